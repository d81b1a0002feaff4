package carom.game.playground;

import carom.physics.Filter;
import carom.physics.JointDef;
import carom.physics.Material;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Shape;
import carom.sim.Match;
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
import java.util.List;

/** The kinds of entities and events of the playground, and the places of its level. */
final class Yard {
  private static final Material WOOD = new Material(0.8f, 0.6f, 0);
  private static final Material RUBBER = new Material(0.6f, 0.9f, 0.6f);
  private static final Material TYRE = new Material(0.8f, 1.4f, 0);
  private static final Material SKIN = new Material(0.3f, 0.3f, 0.4f);
  private static final Material IRON = new Material(5, 0.5f, 0);
  private static final Material SHELL = new Material(0.6f, 0.2f, 0.2f);

  private static final float LIFT = -4; // of a balloon, as a share of gravity

  final EventKind grab;
  final EventKind thrown;
  final EventKind slip;
  final EventKind made;
  final EventKind gone;
  final EventKind blocked;
  final EventKind joined;
  final EventKind cut;
  final EventKind basket;
  final EventKind metre;
  final EventKind second;
  final EventKind taken;

  /** A player's robot with the hand at the end of its beam. */
  final Assembly robot;

  /** Kinds of things that players make, from {@link PlaygroundGame#MAKE} on. */
  final Archetype[] things;

  final Archetype star;

  /** Places of players, of things that come out of a basket, and of the star. */
  final List<Level.Spawn> players;

  final List<Level.Spawn> chutes;
  final Level.Spawn starPlace;

  /** Place where towers count; its lower edge is their foot. */
  final Level.Zone site;

  final Level.Bounds bounds;

  private final Archetype body;
  private final float gravity;

  /**
   * Registers the kinds and looks the places up.
   *
   * @throws IllegalArgumentException if the level lacks a place
   */
  Yard(SetUp s) {
    robot =
        s.assembly(
            new AssemblyDef("player")
                .body(
                    "robot",
                    new ArchetypeDef("robot")
                        .shape(new Circle(PlaygroundGame.RADIUS), SHELL)
                        .gravityScale(0)
                        .fixedRotation(true)
                        .appearance(Appearance.of(0xe8eef6, Appearance.Look.PLAYER)),
                    0,
                    0)
                .body(
                    "hand",
                    new ArchetypeDef("hand")
                        .shape(new Circle(0.16f), new Material(0.1f, 0, 0))
                        .sensor(true)
                        .filter(Filter.NOTHING)
                        .gravityScale(0)
                        .fixedRotation(true)
                        .appearance(Appearance.of(0xffd166)),
                    1,
                    0)
                .joint("beam", "robot", "hand", (a, b) -> JointDef.rope(a, b, 0, 0, 1, 0, 50)));
    body = s.archetype("robot");
    things =
        new Archetype[] {
          thing(s, "box", Box.of(1, 1), WOOD, 1),
          thing(s, "ball", new Circle(0.5f), RUBBER, 1),
          thing(s, "plank", Box.of(3, 0.3f), WOOD, 1),
          thing(s, "wheel", new Circle(0.6f), TYRE, 1),
          thing(s, "balloon", new Circle(0.6f), SKIN, LIFT),
          thing(s, "weight", Box.of(0.9f, 0.9f), IRON, 1)
        };
    star =
        s.archetype(
            new ArchetypeDef("star")
                .shape(new Circle(0.6f), RUBBER)
                .linearDamping(0.2f)
                .appearance(Appearance.of(0xffd166, Appearance.Look.COIN)));
    grab = s.event("grab", 0x9bf6ff, 0, "", Sound.HOP, 0);
    thrown = s.event("throw", 0xffffff, 0.6f, "", Sound.WHOOSH, 0);
    slip = s.event("slip", 0xff9f5a, 0.6f, "", Sound.DROP, 0);
    made = s.event("make", 0xffffff, 0.8f, "", Sound.HOP, 0);
    gone = s.event("gone", 0xc9d4e4, 0.8f, "", Sound.NONE, 0);
    blocked = s.event("blocked", 0xff5d5d, 0.4f, "no room", Sound.NONE, 0);
    joined = s.event("join", 0x9bf6ff, 0.6f, "", Sound.KNOCK, 0);
    cut = s.event("cut", 0xff9f5a, 0.6f, "", Sound.ZAP, 0);
    basket = s.event("basket", 0xffd166, 2, "+1", Sound.CHIME, 0);
    metre = s.event("metre", 0x5ad18a, 1.5f, "+1 m", Sound.CHIME, 0);
    second = s.event("second", 0xffd166, 0.8f, "+1", Sound.CHIME, 0);
    taken = s.event("taken", 0xff8fc7, 1.5f, "taken!", Sound.FANFARE, 0);
    Level level = s.level();
    bounds = level.bounds();
    gravity = level.gravityY();
    players = level.spawns("player");
    chutes = level.spawns("chute");
    List<Level.Spawn> stars = level.spawns("star");
    List<Level.Zone> sites = level.zones("site");
    boolean hasBasket = false;
    for (Entity piece : s.statics()) {
      hasBasket |= isBasket(piece);
    }
    if (players.isEmpty() || chutes.isEmpty() || !hasBasket || stars.size() + sites.size() != 2) {
      throw new IllegalArgumentException(
          "level=\""
              + level.name()
              + "\" has players="
              + players.size()
              + " chutes="
              + chutes.size()
              + " baskets="
              + hasBasket
              + " stars="
              + stars.size()
              + " sites="
              + sites.size()
              + "; the playground needs spawns \"player\", \"chute\" and one \"star\", a sensor"
              + " \"basket\" and one zone \"site\"");
    }
    starPlace = stars.get(0);
    site = sites.get(0);
  }

  private static Archetype thing(SetUp s, String name, Shape shape, Material of, float gravity) {
    return s.archetype(
        new ArchetypeDef(name)
            .shape(shape, of)
            .gravityScale(gravity)
            .linearDamping(gravity < 0 ? 1.2f : 0)
            .angularDamping(gravity < 0 ? 1 : 0.1f)
            .appearance(Appearance.of(0xe0b98a)));
  }

  /** Returns whether a sensor is one that takes things for points. */
  static boolean isBasket(Entity sensor) {
    return sensor.archetype().name().equals("basket");
  }

  /** Returns whether a body is a player's robot. */
  boolean isRobot(Entity e) {
    return e.archetype() == body;
  }

  /** Returns whether a beam can hold a body: all that moves but robots. */
  boolean isLoose(Entity e) {
    return e.isDynamic() && !isRobot(e);
  }

  /** Returns whether a body is held at its centre, as its ends are everywhere. */
  boolean isRound(Entity e) {
    return e.archetype().shapes().size() == 1 && e.archetype().shapes().get(0) instanceof Circle;
  }

  /** Returns the weight of a body, N; negative for what rises. */
  float weight(Entity e) {
    return gravity * e.mass() * (isBalloon(e) ? LIFT : 1);
  }

  /** Returns how far the upper edge of a thing that lies is above its centre, metres. */
  float half(Entity e) {
    return e.archetype() == things[2] ? 0.15f : 0.5f;
  }

  /** Puts what has left the level back: robots where they began, all else into a chute. */
  void bringBack(Match m) {
    for (Entity e : m.entities()) {
      if (e.isDynamic() && !bounds.contains(e.x(), e.y()) && e.root() == e) {
        Level.Spawn to = isRobot(e) ? players.get(0) : chutes.get(0);
        e.teleport(to.x(), to.y(), 0);
        e.setVelocity(0, 0);
      }
    }
  }

  /** Returns whether a thing is one that floats in the air. */
  boolean isBalloon(Entity e) {
    return e.archetype() == things[4];
  }
}
