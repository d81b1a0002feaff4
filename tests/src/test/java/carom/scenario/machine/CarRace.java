package carom.scenario.machine;

import carom.fixtures.Cars;
import carom.physics.Material;
import carom.physics.geometry.Box;
import carom.sim.Game;
import carom.sim.Match;
import carom.sim.SetUp;
import carom.sim.Simulation;
import carom.sim.entity.Assembly;
import carom.sim.entity.EntityJoint;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import carom.sim.event.EventKind;
import carom.sim.field.Count;
import carom.sim.field.Field;
import carom.sim.field.Ratio;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Level;
import java.util.List;
import java.util.Locale;

/** Cars race over a bridge that breaks under a second one. Nitro is used up and comes back. */
final class CarRace implements Game {
  static final Ratio NITRO = Field.ratio("nitro").startsAt(1);
  static final Count LAPS = Field.count("laps", 0, 99);

  static final String LEVEL =
      """
      {"name": "Canyon", "game": "carRace", "gravity": [0, -10],
       "bounds": {"min": [-60, -20], "max": [60, 20]},
       "spawns": [{"at": [-30, 1.2]}, {"at": [-36, 1.2]}],
       "zones": [{"name": "flag", "min": [34, -2], "max": [40, 6]}],
       "statics": [
         {"name": "west", "at": [-25, -5], "shape": {"type": "box", "width": 40, "height": 10}},
         {"name": "east", "at": [25, -5], "shape": {"type": "box", "width": 40, "height": 10}},
         {"at": [-45.5, 3], "shape": {"type": "box", "width": 1, "height": 20}},
         {"at": [45.5, 3], "shape": {"type": "box", "width": 1, "height": 20}}],
       "bodies": [{"name": "plank", "at": [-4.5, -0.15],
         "shape": {"type": "box", "width": 0.96, "height": 0.3},
         "repeat": {"columns": 10, "step": [1, 0]}}],
       "joints": [
         {"type": "revolute", "a": "west", "b": "plank[0]", "at": [-5, -0.15]},
         %s
         {"type": "revolute", "a": "plank[9]", "b": "east", "at": [5, -0.15], "name": "last"}]}
      """
          .formatted(planks());

  private static String planks() {
    StringBuilder joints = new StringBuilder();
    for (int i = 1; i < 10; i++) {
      joints.append(
          String.format(
              Locale.ROOT,
              """
              {"type": "revolute", "a": "plank[%d]", "b": "plank[%d]", "at": [%d, -0.15],
               "breaks": {"force": 900}},
              """,
              i - 1,
              i,
              i - 5));
    }
    return joints.toString();
  }

  private Assembly car;
  private EventKind snap;

  @Override
  public String name() {
    return "carRace";
  }

  @Override
  public String defaultLevel() {
    return "canyon";
  }

  @Override
  public List<Field<?>> fields() {
    return List.of(NITRO, LAPS);
  }

  @Override
  public void setUp(SetUp s) {
    Material metal = new Material(1, 0.4f, 0.1f);
    car = s.assembly(Cars.car(new ArchetypeDef("car").shape(new Box(1.4f, 0.3f), metal)));
    snap = s.event("snap", 0xffd166, 1, "snap");
  }

  @Override
  public void join(Match s, Player p) {
    List<Level.Spawn> spots = s.level().spawns("player");
    Level.Spawn spot = spots.get(p.id() % spots.size());
    s.spawn(car, spot.x(), spot.y(), 0, p);
  }

  @Override
  public void input(Simulation s, Player p, Input in) {
    boolean boost = in.held(Input.ACTION) && p.get(NITRO) > 0.01f;
    p.add(NITRO, boost ? -0.01f : 0.002f);
    EntityJoint drive = p.entity().joint("drive");
    if (drive != null) {
      drive.setMotor((boost ? -20 : -12) * in.moveX(), 40);
    }
  }

  @Override
  public void broke(Simulation s, EntityJoint joint) {
    s.emit(snap).at(joint.anchorAX(), joint.anchorAY());
  }

  @Override
  public void afterStep(Match s) {
    Level.Spawn start = s.level().spawns("player").get(0);
    for (Player p : s.players()) {
      if (p == null || p.entity() == null) {
        continue;
      }
      float x = p.entity().x();
      float y = p.entity().y();
      boolean home = s.level().zones("flag").get(0).contains(x, y);
      if (home) {
        p.add(LAPS, 1);
      }
      if (home || y < -12) {
        p.entity().teleport(start.x(), start.y(), 0);
      }
    }
  }
}
