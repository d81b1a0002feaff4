package carom.scenario.machine;

import carom.physics.Body;
import carom.physics.JointDef;
import carom.physics.JointType;
import carom.physics.Material;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.sim.Game;
import carom.sim.Match;
import carom.sim.SetUp;
import carom.sim.Simulation;
import carom.sim.entity.Assembly;
import carom.sim.entity.AssemblyDef;
import carom.sim.entity.Entity;
import carom.sim.entity.EntityJoint;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import carom.sim.event.Audience;
import carom.sim.field.Countdown;
import carom.sim.field.EntityRef;
import carom.sim.field.Field;
import carom.sim.field.Scope;
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Level;
import java.util.ArrayList;
import java.util.List;

/** Trucks with a crane's arm take wrecks on the hook, tow them, and let them go. */
final class TowTruck implements Game {
  static final EntityRef TOWED = Field.entity("towed").to(Audience.ALL);
  static final Countdown PAUSE = Field.countdown("pause").of(Scope.PLAYER);

  static final String LEVEL =
      """
      {"name": "Yard", "game": "towTruck", "gravity": [0, -10],
       "bounds": {"min": [-50, -5], "max": [50, 30]},
       "spawns": [{"at": [-20, 1.2]}, {"at": [20, 1.2]},
         {"name": "wreck", "at": [-14, 0.5]}, {"name": "wreck", "at": [-6, 0.5]},
         {"name": "wreck", "at": [2, 0.5]}, {"name": "wreck", "at": [12, 0.5]}],
       "statics": [
         {"at": [0, -1], "shape": {"type": "box", "width": 70, "height": 2}},
         {"at": [-30, 5], "shape": {"type": "box", "width": 1, "height": 14}, "repeat": {"columns": 2, "step": [60, 0]}}]}
      """;

  private Assembly truck;
  private Archetype wreck;

  @Override
  public String name() {
    return "towTruck";
  }

  @Override
  public String defaultLevel() {
    return "wreckYard";
  }

  @Override
  public List<Field<?>> fields() {
    return List.of(TOWED, PAUSE);
  }

  @Override
  public void setUp(SetUp s) {
    Material metal = new Material(1, 0.4f, 0.1f);
    ArchetypeDef wheel =
        new ArchetypeDef("wheel").shape(new Circle(0.45f), new Material(1, 1.2f, 0.1f));
    ArchetypeDef chassis = new ArchetypeDef("truck").shape(new Box(1.6f, 0.3f), metal);
    ArchetypeDef boom = new ArchetypeDef("boom").shape(new Box(0.7f, 0.08f), metal);
    truck =
        s.assembly(
            new AssemblyDef("truck")
                .body("chassis", chassis, 0, 0)
                .body("rear", wheel, -1.1f, -0.6f)
                .body("front", wheel, 1.1f, -0.6f)
                .body("boom", boom, -1.2f, 0.6f)
                .joint("drive", "chassis", "rear", (a, b) -> axle(a, b, -1.1f).motor(0, 60))
                .joint("roll", "chassis", "front", (a, b) -> axle(a, b, 1.1f))
                .joint(
                    "lift",
                    "chassis",
                    "boom",
                    (a, b) ->
                        JointDef.revolute(a, b, -0.6f, 0.6f).limits(-0.6f, 0.2f).motor(0, 80)));
    wreck = s.archetype(new ArchetypeDef("wreck").shape(new Box(0.6f, 0.4f), metal));
  }

  @Override
  public void begin(Match s) {
    for (Level.Spawn spot : s.level().spawns("wreck")) {
      s.spawn(wreck, spot.x(), spot.y());
    }
  }

  private static JointDef<Object> axle(Body<Object> chassis, Body<Object> wheel, float x) {
    return JointDef.wheel(chassis, wheel, x, -0.6f, 0, 1).limits(-0.3f, 0.3f).spring(5, 0.7f);
  }

  @Override
  public void join(Match s, Player p) {
    List<Level.Spawn> spots = s.level().spawns("player");
    Level.Spawn spot = spots.get(p.id() % spots.size());
    s.spawn(truck, spot.x(), spot.y(), 0, p);
  }

  @Override
  public void input(Simulation s, Player p, Input in) {
    EntityJoint drive = p.entity().joint("drive");
    EntityJoint lift = p.entity().joint("lift");
    if (drive != null) {
      drive.setMotor(-10 * in.moveX(), 60);
    }
    if (lift != null) {
      lift.setMotor(-2 * in.moveY(), 80);
    }
  }

  @Override
  public void beforeStep(Match s) {
    for (Player p : s.players()) {
      if (p.entity() != null && s.input(p).held(Input.ACTION) && p.get(PAUSE) == 0) {
        p.set(PAUSE, s.ticks(1));
        hook(s, p);
      }
    }
  }

  /** Lets go what is on the hook, or takes the nearest wreck within reach. */
  private void hook(Match s, Player p) {
    Entity boom = p.entity().part("boom");
    EntityJoint rope = rope(boom);
    if (rope != null) {
      rope.destroy();
      p.set(TOWED, null);
      return;
    }
    for (Entity e : s.entities()) {
      if (e.archetype() == wreck) {
        float x = boom.x() - 0.7f;
        float dx = e.x() - x;
        if (dx * dx < 4) {
          float y = boom.y();
          s.connect(boom, e, (a, b) -> JointDef.rope(a, b, x, y, e.x(), e.y() + 0.4f, 2));
          p.set(TOWED, e);
          return;
        }
      }
    }
  }

  private static EntityJoint rope(Entity boom) {
    List<EntityJoint> found = new ArrayList<>();
    boom.forEachJoint(j -> found.addAll(j.type() == JointType.DISTANCE ? List.of(j) : List.of()));
    return found.isEmpty() ? null : found.get(0);
  }
}
