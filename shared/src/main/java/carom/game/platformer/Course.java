package carom.game.platformer;

import carom.physics.BodyType;
import carom.physics.Material;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Polygon;
import carom.sim.SetUp;
import carom.sim.entity.Entity;
import carom.sim.event.EventKind;
import carom.sim.event.Sound;
import carom.sim.level.Appearance;
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Level;
import java.util.List;

/** The kinds of entities and events of the platformer, and the places of its level. */
final class Course {
  private static final int[] COLORS = {
    0xef476f, 0xffd166, 0x06d6a0, 0x4cc9f0, 0xb388eb, 0xf78c6b, 0x9ef01a, 0xff9ebb
  };

  /** Length that is cut off a player's corners, metres. */
  private static final float CUT = 0.12f;

  /** Length that is cut off a player's sole on each side, metres. */
  private static final float SOLE_CUT = 0.1f;

  final Archetype coin;
  final Archetype flag;
  final EventKind jumpEvent;
  final EventKind coinEvent;
  final EventKind flagEvent;
  final EventKind fallEvent;
  final EventKind checkpointEvent;

  /** The places where players begin and come back. */
  final List<Level.Spawn> places;

  final List<Level.Spawn> coins;
  final List<Level.Spawn> flags;
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
    jumpEvent = s.event("jump", 0xffffff, 0.6f, "", Sound.HOP, 0);
    coinEvent = s.event("coin", 0xffd166, 0.8f, "+1", Sound.CHIME, 0);
    flagEvent = s.event("flag", 0xff4d6d, 3, "+" + PlatformerGame.FLAG_POINTS, Sound.FANFARE, 0);
    fallEvent = s.event("fall", 0xef476f, 2, "", Sound.DROP, 0);
    checkpointEvent = s.event("checkpoint", 0x06d6a0, 1.5f, "checkpoint", Sound.CHIME, 0);
    coins = s.level().spawns("coin");
    flags = s.level().spawns("flag");
    places = s.level().spawns("player");
    bounds = s.level().bounds();
    check(s.level());
  }

  private void check(Level level) {
    if (places.isEmpty() || flags.isEmpty()) {
      throw new IllegalArgumentException(
          "level \""
              + level.name()
              + "\" can't be played as platformer: it needs spawns named \"player\" and \"flag\"");
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
