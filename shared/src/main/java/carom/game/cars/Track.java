package carom.game.cars;

import carom.physics.Body;
import carom.physics.BodyType;
import carom.physics.Filter;
import carom.physics.JointDef;
import carom.physics.Material;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Polygon;
import carom.sim.SetUp;
import carom.sim.entity.Assembly;
import carom.sim.entity.AssemblyDef;
import carom.sim.entity.Entity;
import carom.sim.event.EventKind;
import carom.sim.event.Sound;
import carom.sim.level.Appearance;
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Level;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/** The kinds of entities and events of the race, and the places of its level. */
final class Track {
  /** Tag of the half of a loop that a car climbs, and of the half on which it comes down. */
  static final int CLIMB = 1;

  static final int DESCENT = 2;

  /** Colours of cars; each is an archetype. */
  private static final int[] COLORS = {
    0xff5d5d, 0x4da3ff, 0xffd166, 0x5ad18a, 0xc792ea, 0xff9f5a, 0x4cdfe0, 0xff8fc7
  };

  /** Cars pass one another: a road has no room to overtake. */
  private static final Filter CAR = new Filter(2, ~2);

  private static final float PLANK = 1.1f; // length, m

  /** Force at which a joint between planks breaks, N. */
  private static final float STRENGTH = 750;

  private static final String[] HINGES = hinges();
  private static final Material METAL = new Material(0.9f, 0.3f, 0.1f);
  private static final Material RUBBER = new Material(0.9f, 1.3f, 0.05f);
  private static final Material CRATE = new Material(0.3f, 0.5f, 0);
  private static final Material WOOD = new Material(0.7f, 0.9f, 0);

  final EventKind nitro;
  final EventKind flip;
  final EventKind ring;
  final EventKind gate;
  final EventKind lap;
  final EventKind land;
  final EventKind snap;
  final EventKind crash;
  final EventKind splash;
  final EventKind back;

  /** The boxes that cars break. */
  final Archetype crate;

  /** Places of crates. */
  final List<Level.Spawn> crates;

  /** Places where cars begin. */
  final List<Level.Spawn> grid;

  /** The place to which the next lap moves the lower left corner of {@link #end}, with the car. */
  final Level.Spawn again;

  /** The end of a lap: a tunnel to its begin. */
  final Level.Zone end;

  /** Gates, and rings that fill the tank, from the first to the last. */
  final List<Entity> gates;

  final List<Entity> rings;

  /** Zones in which a car is lost. */
  final List<Level.Zone> pits;

  /** The tops of loops, and what is beside them. */
  final List<Level.Zone> tops;

  final List<Level.Zone> sides;

  /** Places of bridges; the upper edge is the road. */
  final List<Level.Zone> bridges;

  private final Assembly[] cars = new Assembly[COLORS.length];
  private final Assembly[] spans;
  private final Level.Bounds bounds;

  /**
   * Registers the kinds and looks the places up.
   *
   * @throws IllegalArgumentException if the level lacks a place, or has too many gates
   */
  Track(SetUp s) {
    for (int i = 0; i < COLORS.length; i++) {
      cars[i] = s.assembly(parts(i));
    }
    crate =
        s.archetype(
            new ArchetypeDef("crate")
                .shape(Box.of(1, 1), CRATE)
                .appearance(Appearance.of(0xc08552, Appearance.Look.CRATE)));
    nitro = s.event("nitro", 0x4cc9f0, 0, "", Sound.WHOOSH, 0);
    flip = s.event("flip", 0xffd166, 1.5f, "FLIP!", Sound.CHIME, 0);
    ring = s.event("ring", 0x4cc9f0, 1.5f, "", Sound.CHIME, 0);
    gate = s.event("gate", 0xffffff, 0, "", Sound.CHIME, 0);
    lap = s.event("lap", 0xffd166, 2, "", Sound.FANFARE, 0);
    land = s.event("land", 0xd9c3a0, 0, "", Sound.KNOCK, 30);
    snap = s.event("snap", 0xc08552, 0.8f, "", Sound.KNOCK, 0);
    crash = s.event("crash", 0xc08552, 0.8f, "", Sound.KNOCK, 5);
    splash = s.event("splash", 0x9fd8ff, 2, "", Sound.DROP, 0);
    back = s.event("back", 0xffffff, 1.5f, "", Sound.HOP, 0);
    Level level = s.level();
    bounds = level.bounds();
    grid = level.spawns("player");
    crates = level.spawns("crate");
    pits = level.zones("pit");
    tops = level.zones("loop top");
    sides = level.zones("loop side");
    bridges = level.zones("bridge");
    gates = marks(s, "gate");
    rings = marks(s, "ring");
    List<Level.Spawn> begins = level.spawns("lap");
    List<Level.Zone> ends = level.zones("end");
    if (grid.isEmpty()
        || gates.isEmpty()
        || begins.size() != 1
        || ends.size() != 1
        || Math.max(gates.size(), rings.size()) > CarsFields.MAX_MARKS
        || crates.size() > CarsFields.MAX_CRATES
        || bridges.size() > CarsFields.MAX_BRIDGES) {
      throw new IllegalArgumentException(
          "level \""
              + level.name()
              + "\" can't be played as cars: it has spawns player="
              + grid.size()
              + " and lap="
              + begins.size()
              + ", zones end="
              + ends.size()
              + " and bridge="
              + bridges.size()
              + ", gates="
              + gates.size()
              + " and rings="
              + rings.size()
              + "; needed are 1 player and gate or more, 1 lap, 1 end, and at most "
              + CarsFields.MAX_BRIDGES
              + " bridges, and "
              + CarsFields.MAX_MARKS
              + " gates and rings each");
    }
    again = begins.get(0);
    end = ends.get(0);
    spans = new Assembly[bridges.size()];
    for (int i = 0; i < spans.length; i++) {
      spans[i] = s.assembly(span(i, bridges.get(i)));
    }
  }

  private static List<Entity> marks(SetUp s, String name) {
    List<Entity> found = new ArrayList<>();
    for (Entity e : s.statics()) {
      if (e.archetype().name().equals(name)) {
        found.add(e);
      }
    }
    found.sort(Comparator.comparing(Entity::x));
    return found;
  }

  private static AssemblyDef parts(int colour) {
    ArchetypeDef chassis =
        new ArchetypeDef("car." + colour)
            .shape(
                Polygon.of(-1.3f, -0.25f, 1.25f, -0.25f, 1.4f, 0, 1.2f, 0.2f, -1.35f, 0.2f), METAL)
            .shape(Polygon.of(-1, 0.2f, 0.6f, 0.2f, 0.15f, 0.62f, -0.6f, 0.62f), METAL)
            .filter(CAR)
            .appearance(Appearance.of(COLORS[colour], Appearance.Look.PLAYER));
    ArchetypeDef wheel =
        new ArchetypeDef("wheel")
            .shape(new Circle(CarsGame.WHEEL), RUBBER)
            .filter(CAR)
            .appearance(Appearance.of(0x2b2b33, Appearance.Look.BALL));
    return new AssemblyDef("car." + colour)
        .body("chassis", chassis, 0, 0)
        .body("rear", wheel, -0.9f, -0.45f)
        .body("front", wheel, 0.92f, -0.45f)
        .joint("rear", "chassis", "rear", (a, b) -> axle(a, b, -0.9f))
        .joint("front", "chassis", "front", (a, b) -> axle(a, b, 0.92f));
  }

  private static JointDef<Object> axle(Body<Object> chassis, Body<Object> wheel, float x) {
    return JointDef.wheel(chassis, wheel, x, -0.45f, 0, 1)
        .limits(-0.22f, 0.25f)
        .spring(5, 0.6f)
        .motor(0, 1);
  }

  /** Returns how many planks a bridge has; it has one joint more. */
  static int planks(Level.Zone zone) {
    return Math.max(2, Math.round((zone.maxX() - zone.minX()) / PLANK));
  }

  /** Returns the name of a joint of a bridge, 0 and up; the same object each time. */
  static String hinge(int i) {
    return HINGES[i];
  }

  private static String[] hinges() {
    String[] names = new String[AssemblyDef.MAX_BODIES];
    for (int i = 0; i < names.length; i++) {
      names[i] = "hinge." + i;
    }
    return names;
  }

  private static String plank(int i) {
    return "plank." + i;
  }

  /** Returns planks between two posts, which hold on to them and to one another. */
  private static AssemblyDef span(int index, Level.Zone zone) {
    float width = zone.maxX() - zone.minX();
    int planks = planks(zone);
    float length = width / planks;
    ArchetypeDef post =
        new ArchetypeDef("post")
            .type(BodyType.KINEMATIC)
            .shape(Box.of(0.3f, 0.3f), WOOD)
            .appearance(Appearance.of(0x6d4c33));
    ArchetypeDef plank =
        new ArchetypeDef("plank")
            .shape(Box.of(length - 0.04f, 0.24f), WOOD)
            .angularDamping(1)
            .appearance(Appearance.of(0xb07a4a));
    AssemblyDef span = new AssemblyDef("bridge." + index).body(plank(-1), post, -0.15f, -0.12f);
    for (int i = 0; i < planks; i++) {
      span.body(plank(i), plank, (i + 0.5f) * length, -0.12f);
    }
    span.body(plank(planks), post, width + 0.15f, -0.12f);
    for (int i = 0; i <= planks; i++) {
      float x = i * length;
      span.joint(
          hinge(i),
          plank(i - 1),
          plank(i),
          (a, b) -> JointDef.revolute(a, b, x, -0.12f).breaksAt(STRENGTH, Float.POSITIVE_INFINITY));
    }
    return span;
  }

  /** Returns a player's car. */
  Assembly car(int player) {
    return cars[player % cars.length];
  }

  /** Returns the planks of a bridge. */
  Assembly span(int bridge) {
    return spans[bridge];
  }

  /** Returns whether a place is in one of some zones. */
  static boolean isIn(List<Level.Zone> zones, Entity e) {
    for (int i = 0; i < zones.size(); i++) {
      if (zones.get(i).contains(e.x(), e.y())) {
        return true;
      }
    }
    return false;
  }

  /** Returns whether a body is in a pit or has left the bounds, but for the upper edge. */
  boolean isLost(Entity e) {
    return e.x() < bounds.minX() || e.x() > bounds.maxX() || e.y() < bounds.minY() || isIn(pits, e);
  }

  /** Returns the length of a lap, m. */
  float length() {
    return end.minX() - again.x();
  }

  /** Returns how far a car has come, m; a player without one is where it began. */
  float way(int lap, Entity car) {
    return (lap - 1) * length() + (car == null ? 0 : car.x() - again.x());
  }
}
