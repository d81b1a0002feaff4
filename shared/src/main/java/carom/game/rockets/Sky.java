package carom.game.rockets;

import carom.physics.BodyType;
import carom.physics.Material;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Polygon;
import carom.physics.math.Trig;
import carom.sim.SetUp;
import carom.sim.entity.Entity;
import carom.sim.event.EventKind;
import carom.sim.event.Sound;
import carom.sim.level.Appearance;
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Level;
import java.util.List;

/** The kinds of entities and events of the rockets, and the places of its level. */
final class Sky {
  /** Names of pick-ups: a repair kit, and each weapon but the first. */
  static final String[] PICKUPS = {"repair", "scatter", "torpedoes", "mines"};

  /** Tag of ships and shots: a planet pulls them, and leaves the rocks where they are. */
  private static final int PULLED = 1;

  private static final Material HULL = new Material(1, 0.3f, 0.2f);
  private static final Material SHELL = new Material(0.5f, 0, 0);
  private static final Material STONE = new Material(2, 0.4f, 0.6f);
  private static final float[] ROCK_RADII = {1.7f, 1.05f, 0.6f};
  private static final String[] ROCKS = {"rock.large", "rock.medium", "rock.small"};

  final Archetype player;

  /** Shots, one for each weapon. */
  final Archetype[] shots;

  /** Rocks, the largest first; each breaks into some of the next. */
  final Archetype[] rocks = new Archetype[ROCKS.length];

  /** As {@link #PICKUPS}. */
  final Archetype[] pickups = new Archetype[PICKUPS.length];

  final EventKind shot;
  final EventKind boom;
  final EventKind spark;
  final EventKind blocked;
  final EventKind crack;
  final EventKind taken;
  final EventKind wreck;

  /** Places where players begin and come back. */
  final List<Level.Spawn> places;

  /** Places where rocks come in. */
  final List<Level.Spawn> rockPlaces;

  /**
   * Registers the kinds and looks the places up.
   *
   * @throws IllegalArgumentException if the level lacks a place
   */
  Sky(SetUp s) {
    player =
        s.archetype(
            new ArchetypeDef("player")
                .shape(new Circle(0.5f), HULL)
                .fixedRotation(true)
                .tag(PULLED)
                .appearance(Appearance.of(0x4cc9f0, Appearance.Look.PLAYER)));
    shots =
        new Archetype[] {
          s.archetype(shot("rocket", 0.16f, 0xffd166)),
          s.archetype(shot("bolt", 0.12f, 0x9ef01a)),
          s.archetype(shot("torpedo", 0.2f, 0xff5d8f)),
          s.archetype(shot("mine", 0.5f, 0xff4d4d).linearDamping(2.5f))
        };
    for (int i = 0; i < ROCKS.length; i++) {
      rocks[i] =
          s.archetype(
              new ArchetypeDef(ROCKS[i])
                  .shape(stone(ROCK_RADII[i], i), STONE)
                  .appearance(Appearance.of(0x8a7f8d)));
    }
    for (int i = 0; i < PICKUPS.length; i++) {
      pickups[i] =
          s.archetype(
              new ArchetypeDef(PICKUPS[i])
                  .type(BodyType.STATIC)
                  .sensor(true)
                  .shape(Box.of(1.2f, 1.2f), SHELL)
                  .appearance(Appearance.of(i == 0 ? 0x06d6a0 : 0xffd166, Appearance.Look.COIN)));
    }
    shot = s.event("shot", 0xffd166, 0.6f, "", Sound.WHOOSH, 0);
    boom = s.event("boom", 0xff9f1c, 3, "", Sound.KNOCK, 0);
    spark = s.event("spark", 0x9ef01a, 1, "", Sound.ZAP, 0);
    blocked = s.event("blocked", 0x7cdcff, 1.2f, "", Sound.ZAP, 0);
    crack = s.event("crack", 0x8a7f8d, 1.5f, "", Sound.KNOCK, 0);
    taken = s.event("taken", 0xffd166, 0.8f, "", Sound.CHIME, 0);
    wreck = s.event("wreck", 0xef476f, 4, "", Sound.DROP, 0);
    places = s.level().spawns("player");
    rockPlaces = s.level().spawns("rock");
    if (places.isEmpty() || rockPlaces.size() > Rocks.MOST_LARGE) {
      throw new IllegalArgumentException(
          "level \""
              + s.level().name()
              + "\" can't be played: it has player="
              + places.size()
              + " and rock="
              + rockPlaces.size()
              + " spawns, needed a spawn \"player\" and at most "
              + Rocks.MOST_LARGE
              + " \"rock\"");
    }
  }

  private static ArchetypeDef shot(String name, float radius, int rgb) {
    return new ArchetypeDef(name)
        .shape(new Circle(radius), SHELL)
        .fixedRotation(true)
        .tag(PULLED)
        .appearance(Appearance.of(rgb, Appearance.Look.BALL));
  }

  /** Returns a rock with seven uneven corners. */
  private static Polygon stone(float radius, int shape) {
    float[] corners = new float[14];
    for (int i = 0; i < 7; i++) {
      float angle = i * 2 * Trig.PI / 7;
      float reach = radius * (1 - 0.06f * ((3 * i + 2 * shape) % 4));
      corners[2 * i] = reach * Trig.cos(angle);
      corners[2 * i + 1] = reach * Trig.sin(angle);
    }
    return Polygon.of(corners);
  }

  /** Returns about how far a kind of rock reaches, metres. */
  static float radius(int kind) {
    return ROCK_RADII[kind];
  }

  /** Returns the kind of a rock, 0 for the largest, or -1 if it is none. */
  int rock(Entity e) {
    return indexOf(rocks, e);
  }

  /** Returns the kind of a pick-up, 0 for a repair kit, or -1 if it is none. */
  int pickup(Entity e) {
    return indexOf(pickups, e);
  }

  /** Returns whether an entity was fired. */
  boolean isShot(Entity e) {
    return indexOf(shots, e) >= 0;
  }

  private static int indexOf(Archetype[] kinds, Entity e) {
    for (int i = 0; i < kinds.length; i++) {
      if (kinds[i] == e.archetype()) {
        return i;
      }
    }
    return -1;
  }
}
