package carom.game.platformer;

import carom.physics.BodyType;
import carom.physics.Material;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Polygon;
import carom.sim.SetUp;
import carom.sim.entity.Entity;
import carom.sim.event.EventKind;
import carom.sim.event.Sound;
import carom.sim.field.Count;
import carom.sim.level.Appearance;
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Level;
import java.util.ArrayList;
import java.util.List;

/** The kinds of entities and events of the platformer, and the places of its level. */
final class Course {
  private static final int[] COLORS = {
    0xef476f, 0xffd166, 0x06d6a0, 0x4cc9f0, 0xb388eb, 0xf78c6b, 0x9ef01a, 0xff9ebb
  };

  /** Height of a foe, metres. The body's origin is in the middle. */
  static final float FOE_HEIGHT = 0.9f;

  /** Length that is cut off a player's corners, metres. */
  private static final float CUT = 0.12f;

  /** Length that is cut off a player's sole on each side, metres. */
  private static final float SOLE_CUT = 0.1f;

  final Archetype coin;
  final Archetype flag;

  /** A foe that patrols. */
  final Archetype walker;

  /** A foe that patrols, and chases players that it sees in its zone. */
  final Archetype hunter;

  /** The remains of a foe, for a moment. */
  final Archetype flat;

  final EventKind jumpEvent;
  final EventKind coinEvent;
  final EventKind flagEvent;
  final EventKind fallEvent;
  final EventKind checkpointEvent;
  final EventKind stompEvent;
  final EventKind hurtEvent;
  final EventKind goalEvent;
  final EventKind bestEvent;

  /** The places where players begin and come back. */
  final List<Level.Spawn> places;

  final List<Level.Spawn> coins;
  final List<Level.Spawn> flags;

  /** The zones of foes, one for each; they walk on the lower edge. */
  final List<Level.Zone> haunts;

  /** The zones in which runs begin and end; null without. */
  final Level.Zone start;

  final Level.Zone goal;

  /** The account's best time on this course; null for one that doesn't ship. */
  final Count best;

  private final Archetype[] players = new Archetype[COLORS.length];
  private final Level.Bounds bounds;

  /**
   * Registers the kinds and looks the places up.
   *
   * @throws IllegalArgumentException if the level lacks a place, or has too many coins
   */
  Course(SetUp s) {
    // No friction: walls must not hold a jumper, and steering brakes better than friction.
    Material skin = new Material(1.2f, 0, 0);
    for (int i = 0; i < COLORS.length; i++) {
      players[i] =
          s.archetype(
              new ArchetypeDef("player." + i)
                  .shape(figure(), skin)
                  .fixedRotation(true)
                  .appearance(Appearance.of(COLORS[i], Appearance.Look.PLAYER)));
    }
    coin =
        s.archetype(
            new ArchetypeDef("coin")
                .type(BodyType.STATIC)
                .sensor(true)
                .shape(new Circle(0.3f), skin)
                .appearance(Appearance.of(0xffd166, Appearance.Look.COIN)));
    flag =
        s.archetype(
            new ArchetypeDef("flag")
                .type(BodyType.STATIC)
                .sensor(true)
                .shape(Polygon.of(-0.4f, -0.7f, -0.25f, -0.7f, 0.7f, 0.35f, -0.4f, 0.8f), skin)
                .appearance(Appearance.of(0xff4d6d, Appearance.Look.PLAIN)));
    walker = s.archetype(foe("walker", 0x9b5de5, skin));
    hunter = s.archetype(foe("hunter", 0xd62828, skin));
    flat =
        s.archetype(
            new ArchetypeDef("flat")
                .type(BodyType.STATIC)
                .sensor(true)
                .shape(slab(0.55f, -FOE_HEIGHT / 2, 0.2f), skin)
                .appearance(Appearance.of(0x6d597a, Appearance.Look.PLAIN)));
    jumpEvent = s.event("jump", 0xffffff, 0.6f, "", Sound.HOP, 0);
    coinEvent = s.event("coin", 0xffd166, 0.8f, "+1", Sound.CHIME, 0);
    flagEvent = s.event("flag", 0xff4d6d, 3, "+" + PlatformerGame.FLAG_POINTS, Sound.FANFARE, 0);
    fallEvent = s.event("fall", 0xef476f, 2, "", Sound.DROP, 0);
    checkpointEvent = s.event("checkpoint", 0x06d6a0, 1.5f, "checkpoint", Sound.CHIME, 0);
    stompEvent = s.event("stomp", 0xffffff, 1.5f, "+" + PlatformerGame.FOE_POINTS, Sound.KNOCK, 0);
    hurtEvent = s.event("hurt", 0xef476f, 2, "-" + PlatformerGame.HURT_POINTS, Sound.ZAP, 0);
    goalEvent = s.event("goal", 0x06d6a0, 3, "+" + PlatformerGame.RUN_POINTS, Sound.FANFARE, 0);
    bestEvent = s.event("best", 0xffd166, 4, "BEST TIME", Sound.FANFARE, 0);
    coins = s.level().spawns("coin");
    flags = s.level().spawns("flag");
    places = s.level().spawns("player");
    bounds = s.level().bounds();
    haunts = haunts(s.level());
    start = zone(s.level(), "start");
    goal = zone(s.level(), "goal");
    best =
        switch (s.level().name()) {
          case "Windmill Gap" -> PlatformerFields.GAP_MS;
          case "Sunken Ruins" -> PlatformerFields.RUINS_MS;
          default -> null;
        };
    check(s.level());
  }

  private void check(Level level) {
    if (places.isEmpty() || (flags.isEmpty() && goal == null)) {
      throw new IllegalArgumentException(
          "level \""
              + level.name()
              + "\" can't be played as platformer: it needs spawns named \"player\" and \"flag\","
              + " or zones \"start\" and \"goal\" instead of the flag");
    }
    if ((start == null) != (goal == null)) {
      throw new IllegalArgumentException(
          "level \""
              + level.name()
              + "\" has a zone \""
              + (start == null ? "goal" : "start")
              + "\" only; a run needs one \"start\" and one \"goal\"");
    }
    if (haunts.size() > PlatformerFields.MAX_FOES) {
      throw new IllegalArgumentException(
          "level \""
              + level.name()
              + "\" has walkers and hunters="
              + haunts.size()
              + ", limit "
              + PlatformerFields.MAX_FOES);
    }
    if (coins.size() > PlatformerFields.MAX_COINS) {
      throw new IllegalArgumentException(
          "level \""
              + level.name()
              + "\" has coins="
              + coins.size()
              + ", limit "
              + PlatformerFields.MAX_COINS);
    }
  }

  private static List<Level.Zone> haunts(Level level) {
    List<Level.Zone> found = new ArrayList<>(level.zones("walker"));
    found.addAll(level.zones("hunter"));
    return found;
  }

  /** Returns whether a level has foes. */
  static boolean hasFoes(Level level) {
    return !haunts(level).isEmpty();
  }

  private static Level.Zone zone(Level level, String name) {
    List<Level.Zone> zones = level.zones(name);
    return zones.isEmpty() ? null : zones.get(0);
  }

  private static ArchetypeDef foe(String name, int rgb, Material skin) {
    return new ArchetypeDef(name)
        .shape(slab(0.5f, -FOE_HEIGHT / 2, FOE_HEIGHT), skin)
        .fixedRotation(true)
        .appearance(Appearance.of(rgb, Appearance.Look.PLAIN));
  }

  /** Returns a low box whose lower corners are cut. */
  private static Polygon slab(float right, float bottom, float height) {
    float cut = height / 5;
    return Polygon.of(
        -right,
        bottom + cut,
        -right + cut,
        bottom,
        right - cut,
        bottom,
        right,
        bottom + cut,
        right - cut,
        bottom + height,
        -right + cut,
        bottom + height);
  }

  /** Returns the kind of foe that a zone is for. */
  Archetype foe(Level.Zone haunt) {
    return haunt.name().equals("hunter") ? hunter : walker;
  }

  /** Returns whether an entity is a foe that isn't beaten. */
  boolean isFoe(Entity e) {
    return e.archetype() == walker || e.archetype() == hunter;
  }

  /** Returns a box whose corners are cut, so that it glides over seams and edges. */
  private static Polygon figure() {
    float right = PlatformerGame.PLAYER_WIDTH / 2;
    float top = PlatformerGame.PLAYER_HEIGHT / 2;
    float[] corners = {
      -right,
      top - CUT,
      -right,
      -top + CUT,
      -right + SOLE_CUT,
      -top,
      right - SOLE_CUT,
      -top,
      right,
      -top + CUT,
      right,
      top - CUT,
      right - CUT,
      top,
      -right + CUT,
      top
    };
    return Polygon.of(corners);
  }

  /** Returns what a player looks like. */
  Archetype player(int id) {
    return players[id % players.length];
  }

  /** Returns the index of the place that is nearest to a point. */
  int nearestPlace(float x, float y) {
    int nearest = 0;
    float best = Float.MAX_VALUE;
    for (int i = 0; i < places.size(); i++) {
      float dx = places.get(i).x() - x;
      float dy = places.get(i).y() - y;
      if (dx * dx + dy * dy < best) {
        best = dx * dx + dy * dy;
        nearest = i;
      }
    }
    return nearest;
  }

  /**
   * Returns whether a body has left the bounds for good: to a side, or downwards. What leaves by
   * the upper edge comes back by gravity.
   */
  boolean isLost(Entity body) {
    return body.x() < bounds.minX() || body.x() > bounds.maxX() || body.y() < bounds.minY();
  }
}
