package carom.game.shooter;

import carom.physics.Body;
import carom.physics.BodyType;
import carom.physics.Filter;
import carom.physics.JointDef;
import carom.physics.Material;
import carom.physics.geometry.Box;
import carom.physics.geometry.Capsule;
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
import java.util.List;
import java.util.Locale;

/** The kinds of entities and events of the shooter, and the places of its level. */
final class Stage {
  /** Parts of a ragdoll; the first is its root. */
  static final String[] PARTS = {"torso", "head", "arm", "arm2", "leg", "leg2"};

  private static final int[] COLORS = {
    0xef476f, 0x4cc9f0, 0xffd166, 0x06d6a0, 0xb388eb, 0xf78c6b, 0x9ef01a, 0xff9ebb
  };

  // Ragdolls touch the level only, shots don't touch each other.
  private static final Filter PLAYER = new Filter(2, ~4);
  private static final Filter RAGDOLL = new Filter(4, 1);
  private static final Filter SHOT = new Filter(8, 1 | 2);
  private static final Material CLOTH = new Material(0.8f, 0.5f, 0.2f);

  // No friction: walls must not hold a jumper, and steering brakes better than friction.
  private static final Material SKIN = new Material(1.2f, 0, 0);
  private static final Material LEAD = new Material(0.5f, 0, 0);

  final Archetype bullet;
  final Archetype rocket;

  /** The archetype of what makes sudden deaths, from the level. */
  final Archetype lava;

  final EventKind jump;
  final EventKind shot;
  final EventKind spark;
  final EventKind hit;
  final EventKind boom;
  final EventKind crash;
  final EventKind taken;
  final EventKind knockOut;

  /** Places where players begin and come back. */
  final List<Level.Spawn> places;

  /** Places of pick-ups. */
  final List<Level.Spawn> pickups = new ArrayList<>();

  /** Content of each of {@link #pickups}: a weapon, or null for a medkit. */
  final List<Weapon> contents = new ArrayList<>();

  private final Archetype[] boxes = new Archetype[Weapon.values().length]; // the first is a medkit
  private final Archetype[] players = new Archetype[COLORS.length];
  private final Assembly[] ragdolls = new Assembly[COLORS.length];
  private final Level.Bounds bounds;

  /**
   * Registers the kinds and looks the places up.
   *
   * @throws IllegalArgumentException if the level lacks a place, or has too many pick-ups
   */
  Stage(SetUp s) {
    for (int i = 0; i < COLORS.length; i++) {
      players[i] =
          s.archetype(
              new ArchetypeDef("player." + i)
                  .shape(figure(), SKIN)
                  .filter(PLAYER)
                  .fixedRotation(true)
                  .appearance(Appearance.of(COLORS[i], Appearance.Look.PLAYER)));
      ragdolls[i] = s.assembly(doll(i));
    }
    bullet = s.archetype(shot("bullet", 0.1f, 0xfff1b8).gravityScale(0.15f));
    rocket = s.archetype(shot("rocket", 0.18f, 0xff9f1c).gravityScale(0.35f));
    boxes[0] = s.archetype(box("medkit", 0xff4d6d));
    for (Weapon w : Weapon.values()) {
      if (w.ammo > 0) {
        boxes[w.ordinal()] = s.archetype(box(nameOf(w), 0xffd166));
      }
    }
    jump = s.event("jump", 0xffffff, 0.6f, "", Sound.HOP, 0);
    shot = s.event("shot", 0xffe08a, 0.5f, "", Sound.ZAP, 12);
    spark = s.event("spark", 0xffe08a, 0.4f, "", Sound.NONE, 0);
    hit = s.event("hit", 0xff6b6b, 0.7f, "", Sound.KNOCK, 20);
    boom = s.event("boom", 0xff9f1c, Weapon.BLAST_RADIUS, "", Sound.KNOCK, 0);
    crash = s.event("crash", 0xc08552, 1, "", Sound.KNOCK, 0);
    taken = s.event("taken", 0xffd166, 0.8f, "", Sound.CHIME, 0);
    knockOut = s.event("knock-out", 0xef476f, 3, "KO", Sound.DROP, 0);
    lava = s.archetype("lava");
    Level level = s.level();
    bounds = level.bounds();
    places = level.spawns("player");
    for (int i = 0; i < boxes.length; i++) {
      for (Level.Spawn spot : level.spawns(boxes[i].name())) {
        pickups.add(spot);
        contents.add(i == 0 ? null : Weapon.values()[i]);
      }
    }
    if (places.isEmpty() || pickups.size() > ShooterFields.MAX_PICKUPS) {
      throw new IllegalArgumentException(
          "level \""
              + level.name()
              + "\" can't be played as shooter: it has player="
              + places.size()
              + " and pick-ups="
              + pickups.size()
              + " spawns, needed 1 or more and at most "
              + ShooterFields.MAX_PICKUPS);
    }
  }

  private static String nameOf(Weapon w) {
    return w.name().toLowerCase(Locale.ROOT);
  }

  private static ArchetypeDef shot(String name, float radius, int rgb) {
    return new ArchetypeDef(name)
        .shape(new Circle(radius), LEAD)
        .filter(SHOT)
        .fixedRotation(true)
        .appearance(Appearance.of(rgb, Appearance.Look.BALL));
  }

  private static ArchetypeDef box(String name, int rgb) {
    return new ArchetypeDef(name)
        .type(BodyType.STATIC)
        .sensor(true)
        .shape(Box.of(1.1f, 0.8f), SKIN)
        .appearance(Appearance.of(rgb, Appearance.Look.COIN));
  }

  /** Returns a box whose corners are cut, so that it glides over seams and edges. */
  private static Polygon figure() {
    float right = ShooterGame.PLAYER_WIDTH / 2;
    float top = ShooterGame.PLAYER_HEIGHT / 2;
    float[] half = {right - 0.12f, top, -right + 0.12f, top, -right, top - 0.12f};
    float[] corners = new float[2 * half.length];
    for (int i = 0; i < half.length; i++) { // the lower half is the upper one turned
      corners[i] = half[i];
      corners[half.length + i] = -half[i];
    }
    return Polygon.of(corners);
  }

  private static AssemblyDef doll(int colour) {
    Circle round = new Circle(0.26f);
    Capsule arm = new Capsule(0, -0.2f, 0, 0.2f, 0.09f);
    Capsule leg = new Capsule(0, -0.22f, 0, 0.22f, 0.11f);
    return new AssemblyDef("ragdoll." + colour)
        .body("torso", limb("torso", colour).shape(Box.of(0.44f, 0.6f), CLOTH), 0, 0)
        .body("head", limb("head", colour).shape(round, CLOTH), 0, 0.52f)
        .body("arm", limb("arm", colour).shape(arm, CLOTH), -0.28f, 0.05f)
        .body("arm2", limb("arm", colour).shape(arm, CLOTH), 0.28f, 0.05f)
        .body("leg", limb("leg", colour).shape(leg, CLOTH), -0.12f, -0.5f)
        .body("leg2", limb("leg", colour).shape(leg, CLOTH), 0.12f, -0.5f)
        .joint("neck", "torso", "head", (a, b) -> hinge(a, b, 0, 0.3f, 0.6f))
        .joint("shoulder", "torso", "arm", (a, b) -> hinge(a, b, -0.26f, 0.25f, 2.4f))
        .joint("shoulder2", "torso", "arm2", (a, b) -> hinge(a, b, 0.26f, 0.25f, 2.4f))
        .joint("hip", "torso", "leg", (a, b) -> hinge(a, b, -0.12f, -0.3f, 1.2f))
        .joint("hip2", "torso", "leg2", (a, b) -> hinge(a, b, 0.12f, -0.3f, 1.2f));
  }

  private static ArchetypeDef limb(String name, int colour) {
    return new ArchetypeDef(name + "." + colour)
        .filter(RAGDOLL)
        .angularDamping(1)
        .appearance(Appearance.of(COLORS[colour]));
  }

  private static JointDef<Object> hinge(
      Body<Object> a, Body<Object> b, float x, float y, float angle) {
    return JointDef.revolute(a, b, x, y).limits(-angle, angle);
  }

  /** Returns what a player looks like. */
  Archetype player(int id) {
    return players[id % players.length];
  }

  /** Returns what is left of a player. */
  Assembly ragdoll(int id) {
    return ragdolls[id % ragdolls.length];
  }

  /** Returns what a pick-up looks like; null for a medkit's content. */
  Archetype box(Weapon content) {
    return boxes[content == null ? 0 : content.ordinal()];
  }

  /** Returns whether an entity was fired. */
  boolean isShot(Entity e) {
    return e.archetype() == bullet || e.archetype() == rocket;
  }

  /** Returns whether an entity is a pick-up. */
  boolean isPickup(Entity e) {
    for (Archetype box : boxes) {
      if (e.archetype() == box) {
        return true;
      }
    }
    return false;
  }

  /** Returns whether a body has left the bounds for good: by the upper edge it comes back. */
  boolean isLost(Entity body) {
    return body.x() < bounds.minX() || body.x() > bounds.maxX() || body.y() < bounds.minY();
  }
}
