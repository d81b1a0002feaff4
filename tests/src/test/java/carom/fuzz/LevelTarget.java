package carom.fuzz;

import carom.fixtures.PlainGame;
import carom.sim.Role;
import carom.sim.SimulationHost;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/**
 * Level files. A file is refused with its reason, or it can be played: its world is built and
 * stepped if it is small.
 */
final class LevelTarget implements FuzzTarget {
  private static final int SMALL = 100;

  @Override
  public void take(byte[] data) {
    Level level;
    try {
      level = Level.parse("fuzz.json", data);
    } catch (LevelException e) {
      FuzzTarget.requirePrintable(e.getMessage());
      return;
    }
    if (level.statics().size() + level.bodies().size() > SMALL) {
      return;
    }
    SimulationHost simulation;
    try {
      simulation = new SimulationHost(new PlainGame("plain"), level, 1, 60, Role.AUTHORITY);
    } catch (IllegalArgumentException e) {
      FuzzTarget.requirePrintable(e.getMessage());
      return;
    }
    simulation.step();
    simulation.step();
  }

  @Override
  public List<byte[]> seeds() throws Exception {
    List<byte[]> seeds = new ArrayList<>();
    for (String name :
        List.of(
            "arena", "platformer", "rockets", "shooter", "cars", "harbour", "lagoon", "sluice")) {
      seeds.add(Level.builtIn(name).source());
    }
    seeds.add(SMALL_LEVEL.getBytes(StandardCharsets.UTF_8));
    return seeds;
  }

  private static final String SMALL_LEVEL =
      """
      {"name": "small", "game": "plain", "gravity": [0, -10], "bounds": {"min": [-9, -9], "max": [9, 9]},
       "materials": {"m": {"density": 1, "friction": 0.5, "restitution": 0.2}},
       "spawns": [{"at": [0, 0], "team": 1}], "zones": [{"name": "z", "min": [0, 0], "max": [1, 1]}],
       "areas": [{"type": "water", "min": [0, 0], "max": [2, 2]}, {"type": "attractor", "at": [3, 3], "range": 2, "strength": 4}],
       "statics": [{"at": [0, -5], "shape": {"type": "box", "width": 9, "height": 1}},
                   {"at": [0, -8], "shape": {"type": "chain", "points": [[0, 0], [1, 0], [2, 1]]}}],
       "bodies": [{"name": "a", "at": [0, 2], "material": "m", "shape": {"type": "circle", "radius": 0.5}},
                  {"name": "b", "at": [2, 2], "shape": {"type": "compound", "parts": [{"type": "circle", "radius": 0.5},
                   {"type": "capsule", "from": [0, 0], "to": [1, 0], "radius": 0.2}]}},
                  {"at": [4, 2], "type": "kinematic", "motion": {"to": [5, 2], "period": 2},
                   "shape": {"type": "polygon", "points": [[0, 0], [1, 0], [0, 1]]}},
                  {"at": [-4, 2], "repeat": {"columns": 2, "rows": 2, "step": [1, 1]}, "shape": {"type": "box", "width": 0.5, "height": 0.5}}],
       "joints": [{"type": "hinge", "a": "a", "b": "b", "at": [1, 2]}]}
      """;
}
