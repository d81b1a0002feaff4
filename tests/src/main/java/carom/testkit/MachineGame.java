package carom.testkit;

import carom.game.Games;
import carom.physics.Body;
import carom.physics.Joint;
import carom.physics.JointDef;
import carom.physics.Material;
import carom.physics.geometry.Box;
import carom.physics.geometry.Capsule;
import carom.physics.geometry.Circle;
import carom.sim.Game;
import carom.sim.Role;
import carom.sim.Simulation;
import carom.sim.entity.Entity;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import carom.sim.event.EventKind;
import carom.sim.joint.Assembly;
import carom.sim.joint.AssemblyDef;
import carom.sim.level.Appearance;
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;

/**
 * A game of machines: players drive cars on wheel joints past ragdolls, over a rope bridge, under a
 * crane. What a player's buttons do is all in {@link #input}; JUMP kicks the car up.
 */
public final class MachineGame implements Game {
  /** Speed of the wheels at full throttle, rad/s. */
  public static final float WHEEL_SPEED = 12;

  private static final Material METAL = new Material(1, 0.4f, 0.1f);
  private static final Material RUBBER = new Material(1, 1.2f, 0.1f);
  private static final Appearance PAINT = Appearance.of(0x4cc9f0, Appearance.Look.PLAYER);

  private Assembly car;
  private Assembly ragdoll;
  private Assembly gears;
  private Archetype plank;
  private Archetype load;
  private Archetype link;
  private EventKind snap;

  /** Makes the game known, so that levels may name it. */
  public static void register() {
    Games.add(MachineGame::new);
  }

  /**
   * Returns a level with a floor between two walls, 60 m apart, and players' spawns on it.
   *
   * @param more further spawns, each after a comma: ragdolls, bridges (team: planks), gears,
   *     cranes, crates
   */
  public static Level level(String more) {
    return level(more, "");
  }

  /**
   * Returns such a level with more in its file.
   *
   * @param fields further fields of the file, each after a comma
   */
  public static Level level(String more, String fields) {
    register();
    String json =
        """
        {"name": "machines", "game": "machines", "gravity": [0, -10],
         "bounds": {"min": [-40, -10], "max": [40, 30]},
         "spawns": [{"name": "player", "at": [-24, 1.2]}, {"name": "player", "at": [24, 1.2]}%s],
         "statics": [
           {"name": "floor", "at": [0, -1], "shape": {"type": "box", "width": 80, "height": 2}},
           {"at": [-31, 10], "shape": {"type": "box", "width": 2, "height": 24}},
           {"at": [31, 10], "shape": {"type": "box", "width": 2, "height": 24}}]%s}
        """
            .formatted(more, fields);
    try {
      return Level.parse("machines.json", json.getBytes(StandardCharsets.UTF_8));
    } catch (LevelException e) {
      throw new IllegalStateException(e);
    }
  }

  @Override
  public String name() {
    return "machines";
  }

  @Override
  public String defaultLevel() {
    return "machines";
  }

  @Override
  public void setUp(Simulation s) {
    snap = s.eventKinds().add("snap", 0xffd166, 1, "snap");
    ArchetypeDef wheel = new ArchetypeDef("wheel").shape(new Circle(0.45f), RUBBER);
    car =
        s.assemblies()
            .add(
                new AssemblyDef("car")
                    .body(
                        "chassis",
                        new ArchetypeDef("chassis")
                            .shape(new Box(1.4f, 0.3f), METAL)
                            .appearance(PAINT),
                        0,
                        0)
                    .body("rear", wheel, -1, -0.6f)
                    .body("front", wheel, 1, -0.6f)
                    .joint(
                        "drive",
                        "chassis",
                        "rear",
                        (a, b) ->
                            JointDef.wheel(a, b, -1, -0.6f, 0, 1)
                                .limits(-0.3f, 0.3f)
                                .spring(4, 0.7f)
                                .motor(0, 40))
                    .joint(
                        "roll",
                        "chassis",
                        "front",
                        (a, b) ->
                            JointDef.wheel(a, b, 1, -0.6f, 0, 1)
                                .limits(-0.3f, 0.3f)
                                .spring(4, 0.7f)));
    ragdoll = s.assemblies().add(ragdoll());
    gears = s.assemblies().add(gears());
    plank = s.archetypes().add(new ArchetypeDef("plank").shape(new Box(0.48f, 0.12f), METAL));
    link = s.archetypes().add(new ArchetypeDef("link").shape(new Box(0.09f, 0.05f), METAL));
    load = s.archetypes().add(new ArchetypeDef("load").shape(new Box(0.5f, 0.5f), METAL));
    if (s.role() == Role.AUTHORITY) {
      build(s);
    }
  }

  /** Makes what the level's spawns name: ragdolls, bridges, cranes and crates. */
  private void build(Simulation s) {
    for (Level.Spawn spot : s.level().spawns()) {
      switch (spot.name()) {
        case "ragdoll" -> ragdoll(s, spot.x(), spot.y());
        case "bridge" -> bridge(s, spot.x(), spot.y(), spot.team(), 1e9f);
        case "weak bridge" -> bridge(s, spot.x(), spot.y(), spot.team(), 400);
        case "carpet" -> carpet(s, spot.x(), spot.y(), 270);
        case "gears" -> gears(s, spot.x(), spot.y(), 0);
        case "crane" -> crane(s, spot.x(), spot.y());
        case "crate" -> crate(s, spot.x(), spot.y());
        case "tie" -> ties = true;
        default -> {}
      }
    }
  }

  private static AssemblyDef ragdoll() {
    AssemblyDef def =
        new AssemblyDef("ragdoll")
            .body("torso", limb(0.6f, 0.17f), 0, 1.5f)
            .body("head", new ArchetypeDef("head").shape(new Circle(0.17f), METAL), 0, 1.75f)
            .joint("neck", "torso", "head", (a, b) -> hinge(a, b, 0, 1.6f, -0.6f, 0.6f));
    for (String side : List.of("left", "right")) {
      float x = side.equals("left") ? -0.25f : 0.25f;
      def.body(side + " arm", limb(0.5f, 0.07f), x, 1.5f)
          .body(side + " thigh", limb(0.42f, 0.09f), x / 2, 0.85f)
          .body(side + " shin", limb(0.42f, 0.08f), x / 2, 0.42f)
          .joint(
              side + " shoulder",
              "torso",
              side + " arm",
              (a, b) -> hinge(a, b, x, 1.5f, -2.4f, 2.4f))
          .joint(
              side + " hip",
              "torso",
              side + " thigh",
              (a, b) -> hinge(a, b, x / 2, 0.85f, -0.8f, 1.6f))
          .joint(
              side + " knee",
              side + " thigh",
              side + " shin",
              (a, b) -> hinge(a, b, x / 2, 0.42f, -2.2f, 0));
    }
    return def;
  }

  /** A heavy frame with two wheels in gear, the first driven, and two buckets on a pulley. */
  private static AssemblyDef gears() {
    ArchetypeDef bucket = new ArchetypeDef("bucket").shape(new Box(0.25f, 0.2f), METAL);
    return new AssemblyDef("gears")
        .body("frame", new ArchetypeDef("frame").shape(new Box(1.5f, 0.3f), METAL), 0, 0)
        .body("small", cog(0.4f), -0.8f, 1)
        .body("large", cog(0.8f), 0.4f, 1)
        .body("left", bucket, -2.5f, 1.5f)
        .body("right", bucket, 2.5f, 1)
        .joint("drive", "frame", "small", (a, b) -> JointDef.revolute(a, b, -0.8f, 1).motor(3, 30))
        .joint("axle", "frame", "large", (a, b) -> JointDef.revolute(a, b, 0.4f, 1))
        .joint("gear", "small", "large", (a, b) -> JointDef.gear(a, b, -0.5f))
        .joint(
            "rope",
            "left",
            "right",
            (a, b) -> JointDef.pulley(a, b, -2.5f, 1.7f, 2.5f, 1.2f, -2.5f, 4, 2.5f, 4, 1));
  }

  private static ArchetypeDef cog(float radius) {
    return new ArchetypeDef("cog").shape(new Circle(radius), METAL);
  }

  private static ArchetypeDef limb(float length, float radius) {
    return new ArchetypeDef("limb")
        .shape(new Capsule(0, 0, 0, -length, radius), METAL)
        .angularDamping(0.5f);
  }

  private static JointDef<Object> hinge(
      Body<Object> a, Body<Object> b, float x, float y, float lower, float upper) {
    return JointDef.revolute(a, b, x, y).limits(lower, upper);
  }

  /** Makes a ragdoll with its feet at a place. */
  public Entity ragdoll(Simulation s, float x, float y) {
    return s.spawn(ragdoll, x, y, 0, null);
  }

  /** Makes two wheels in gear on a frame, and two buckets on a pulley, turned by an angle. */
  public Entity gears(Simulation s, float x, float y, float angle) {
    return s.spawn(gears, x, y, angle, null);
  }

  /**
   * Makes a bridge of planks of 1 m that hang between two points of the world.
   *
   * @param x its middle
   * @param breakForce of its hinges, N
   * @return its planks, from the left
   */
  public Entity[] bridge(Simulation s, float x, float y, int planks, float breakForce) {
    Entity[] made = new Entity[planks];
    Body<Entity> last = null;
    for (int i = 0; i <= planks; i++) {
      float at = x - planks / 2f + i;
      Body<Entity> next = null;
      if (i < planks) {
        made[i] = s.spawn(plank, at + 0.5f, y, 0, null);
        next = made[i].body();
      }
      s.connect(
          JointDef.revolute(next == null ? null : last, next == null ? last : next, at, y)
              .breaksAt(breakForce, Float.POSITIVE_INFINITY));
      last = next;
    }
    return made;
  }

  /** Makes a carpet of links of 0.2 m that lies on the ground, from a place to the right. */
  public void carpet(Simulation s, float x, float y, int links) {
    Body<Entity> last = null;
    for (int i = 0; i < links; i++) {
      Body<Entity> next = s.spawn(link, x + 0.2f * i, y, 0, null).body();
      if (last != null) {
        s.connect(JointDef.revolute(last, next, x + 0.2f * i - 0.1f, y));
      }
      last = next;
    }
  }

  /**
   * Makes a crane: a trolley on a rail that goes there and back by itself, with a load on a rope.
   *
   * @return trolley and load
   */
  public Entity[] crane(Simulation s, float x, float y) {
    Entity trolley = s.spawn(plank, x, y, 0, null);
    Entity hanging = s.spawn(load, x, y - 3, 0, null);
    Joint<Entity> rail =
        s.connect(JointDef.prismatic(null, trolley.body(), x, y, 1, 0).limits(-4, 4).motor(1, 400));
    s.connect(JointDef.rope(trolley.body(), hanging.body(), x, y, x, y - 2.5f, 2.6f));
    rails = Arrays.copyOf(rails, rails.length + 1);
    rails[rails.length - 1] = rail.index();
    return new Entity[] {trolley, hanging};
  }

  /** Makes a crate. */
  public Entity crate(Simulation s, float x, float y) {
    Entity crate = s.spawn(load, x, y, 0, null);
    crates = Arrays.copyOf(crates, crates.length + 1);
    crates[crates.length - 1] = crate.id();
    return crate;
  }

  private int[] rails = {};
  private int[] crates = {};
  private Joint<Entity> rope;
  private boolean ties;

  @Override
  public void beforeStep(Simulation s) {
    if (ties) {
      tieCrates(s);
    }
    for (int rail : rails) {
      Joint<Entity> joint = s.world().joint(rail);
      if (joint != null && s.tick() % 240 == 0) {
        joint.setMotor(s.tick() % 480 == 0 ? 1 : -1, 400);
      }
    }
  }

  /** Ties the first two crates together for two seconds, then leaves them apart for two. */
  private void tieCrates(Simulation s) {
    if (crates.length < 2 || s.tick() % 120 != 0) {
      return;
    }
    if (rope != null && rope.isValid()) {
      s.disconnect(rope);
      rope = null;
      return;
    }
    Body<Entity> a = s.entity(crates[0]).body();
    Body<Entity> b = s.entity(crates[1]).body();
    rope = s.connect(JointDef.distance(a, b, a.x(), a.y(), b.x(), b.y()).spring(3, 0.5f));
  }

  @Override
  public boolean keepsMore() {
    return true;
  }

  @Override
  public void join(Simulation s, Player p) {
    List<Level.Spawn> spots = s.level().spawns("player");
    Level.Spawn spot = spots.get(p.id() % spots.size());
    s.spawn(car, spot.x(), spot.y(), 0, p);
  }

  @Override
  public void input(Simulation s, Player p, Input in) {
    Joint<Entity> drive = s.joint(p.body(), "drive");
    if (drive != null) {
      drive.setMotor(-WHEEL_SPEED * in.moveX(), 40);
    }
    if (in.held(Input.JUMP)) {
      p.body().body().applyForce(0, 30 * p.body().body().mass());
    }
  }

  @Override
  public void broke(Simulation s, Joint<Entity> joint) {
    s.emit(snap).at(joint.anchorAX(), joint.anchorAY());
  }
}
