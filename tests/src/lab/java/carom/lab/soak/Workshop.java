package carom.lab.soak;

import carom.fixtures.Cars;
import carom.game.Games;
import carom.physics.JointDef;
import carom.physics.Material;
import carom.physics.geometry.Box;
import carom.sim.Game;
import carom.sim.Match;
import carom.sim.SetUp;
import carom.sim.Simulation;
import carom.sim.entity.Assembly;
import carom.sim.entity.Entity;
import carom.sim.entity.EntityJoint;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import carom.sim.event.EventKind;
import carom.sim.field.Count;
import carom.sim.field.Field;
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;

/**
 * A game of joints, all of whose state can be saved: cars drive over a bridge that breaks, and drop
 * crates on ropes, which break too. The level has gears that a motor turns.
 */
final class Workshop implements Game {
  static final Count DROPPED = Field.count("dropped", 0, 9_999);

  private static final int MOST_CRATES = 24;

  /** Ticks between two crates of a player. */
  private static final int DROP_TICKS = 45;

  private static final Material METAL = new Material(1, 0.4f, 0.1f);

  private Assembly car;
  private Archetype crate;
  private EventKind snap;

  /** Makes the game known, and returns its level. */
  static Level level() {
    Games.add(Workshop::new);
    StringBuilder planks = new StringBuilder();
    for (int i = 1; i < 8; i++) {
      planks.append(
          String.format(
              Locale.ROOT,
              """
              {"type": "revolute", "a": "plank[%d]", "b": "plank[%d]", "at": [%d, -0.15],
               "breaks": {"force": 900}},
              """,
              i - 1,
              i,
              i - 4));
    }
    String json =
        """
        {"name": "workshop", "game": "workshop", "gravity": [0, -10],
         "bounds": {"min": [-50, -20], "max": [50, 30]},
         "spawns": [{"at": [-30, 1.2]}, {"at": [-24, 1.2]}, {"at": [24, 1.2]}, {"at": [30, 1.2]}],
         "statics": [
           {"name": "west", "at": [-24, -5], "shape": {"type": "box", "width": 40, "height": 10}},
           {"name": "east", "at": [24, -5], "shape": {"type": "box", "width": 40, "height": 10}},
           {"at": [-44.5, 8], "shape": {"type": "box", "width": 1, "height": 30}},
           {"at": [44.5, 8], "shape": {"type": "box", "width": 1, "height": 30}}],
         "bodies": [
           {"name": "plank", "at": [-3.5, -0.15],
            "shape": {"type": "box", "width": 0.96, "height": 0.3},
            "repeat": {"columns": 8, "step": [1, 0]}},
           {"name": "wheel", "at": [12, 5], "shape": {"type": "circle", "radius": 1}},
           {"name": "other", "at": [14, 5], "shape": {"type": "circle", "radius": 1}}],
         "joints": [
           {"type": "revolute", "a": "west", "b": "plank[0]", "at": [-4, -0.15]},
           %s
           {"type": "revolute", "a": "plank[7]", "b": "east", "at": [4, -0.15]},
           {"type": "revolute", "b": "wheel", "at": [12, 5], "motor": {"speed": 90, "max": 50}},
           {"type": "revolute", "b": "other", "at": [14, 5]},
           {"type": "gear", "a": "wheel", "b": "other", "ratio": -1}]}
        """
            .formatted(planks);
    try {
      return Level.parse("workshop", json.getBytes(StandardCharsets.UTF_8));
    } catch (LevelException e) {
      throw new IllegalStateException(e);
    }
  }

  @Override
  public String name() {
    return "workshop";
  }

  @Override
  public String defaultLevel() {
    return "workshop";
  }

  @Override
  public List<Field<?>> fields() {
    return List.of(DROPPED);
  }

  @Override
  public void setUp(SetUp s) {
    car = s.assembly(Cars.car(new ArchetypeDef("car").shape(new Box(1.4f, 0.3f), METAL)));
    crate = s.archetype(new ArchetypeDef("crate").shape(new Box(0.4f, 0.4f), METAL));
    snap = s.event("snap", 0xffd166, 1, "snap");
  }

  @Override
  public void join(Match s, Player p) {
    List<Level.Spawn> spots = s.level().spawns("player");
    Level.Spawn spot = spots.get(p.id() % spots.size());
    s.spawn(car, spot.x(), spot.y() + p.id() / spots.size() * 2, 0, p);
  }

  @Override
  public void input(Simulation s, Player p, Input in) {
    EntityJoint drive = p.entity().joint("drive");
    if (drive != null) {
      drive.setMotor(-12 * in.moveX(), 40);
    }
  }

  @Override
  public void broke(Simulation s, EntityJoint joint) {
    s.emit(snap).at(joint.anchorAX(), joint.anchorAY());
  }

  @Override
  public void afterStep(Match s) {
    int crates = 0;
    for (Entity e : s.entities()) {
      if (e.archetype() == crate) {
        crates++;
        if (e.y() < -12) {
          e.despawn();
        }
      }
    }
    for (Player p : s.players()) {
      if (p == null || p.entity() == null) {
        continue;
      }
      Entity body = p.entity();
      if (body.y() < -12) {
        Level.Spawn spot = s.level().spawns("player").get(0);
        p.entity().teleport(spot.x(), spot.y() + 3, 0);
      } else if (s.input(p).held(Input.ACTION)
          && s.tick() % DROP_TICKS == p.id()
          && crates < MOST_CRATES) {
        drop(s, p, body);
      }
    }
  }

  /** Drops a crate that hangs on a rope; every third one takes another one's place. */
  private void drop(Match s, Player p, Entity chassis) {
    float x = chassis.x();
    float y = chassis.y();
    Entity dropped = s.spawn(crate, x, y + 2);
    p.add(DROPPED, 1);
    if (p.get(DROPPED) % 3 != 0) {
      s.connect(
          chassis, dropped, (a, b) -> JointDef.rope(a, b, x, y, x, y + 2, 2.5f).breaksAt(300, 0));
    } else {
      removeFirst(s);
    }
  }

  private void removeFirst(Match s) {
    for (Entity e : s.entities()) {
      if (e.archetype() == crate) {
        e.despawn();
        return;
      }
    }
  }
}
