package carom.game.arena;

import carom.physics.BodyType;
import carom.physics.Material;
import carom.physics.geometry.Circle;
import carom.sim.SetUp;
import carom.sim.entity.Entity;
import carom.sim.event.EventKind;
import carom.sim.event.Sound;
import carom.sim.level.Appearance;
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Level;
import java.util.ArrayList;
import java.util.List;

/**
 * Everything that a match of the arena is played with and on: kinds of entities and events, and the
 * level's zones.
 */
final class Pitch {
  /** Number of teams; they are 1 and 2. */
  static final int TEAMS = 2;

  /** Names of the teams, by team. */
  static final String[] TEAM_NAMES = {"", "Red", "Blue"};

  static final int[] TEAM_COLORS = {0, 0xff5d5d, 0x4da3ff};

  /** Impulse of the loudest hit, a dash into a ball, N s. */
  private static final float LOUD_HIT = 12;

  /** Kinds of discs, by team. */
  final Archetype[] discs = new Archetype[TEAMS + 1];

  /** Kinds of lamps, by team; 0 is dark. */
  final Archetype[] lamps = new Archetype[TEAMS + 1];

  /** Zones where players appear, by team. */
  final Level.Zone[] homes = new Level.Zone[TEAMS + 1];

  final Archetype ball;

  /** A heavy ball; null if the level has none. */
  final Archetype heavyBall;

  final Archetype spark;
  final EventKind hit;
  final EventKind dash;
  final EventKind jolt;
  final EventKind joltHit;
  final EventKind goal;
  final EventKind boost;
  final List<Level.Zone> goals;

  /** Places where balls are kicked off, heavy ones first. */
  final List<Level.Spawn> kickOffs = new ArrayList<>();

  /** Number of the first balls that are heavy. */
  final int heavies;

  /** Declares the kinds, and finds the zones of the level. */
  Pitch(SetUp s) {
    Material skin = new Material(1, 0.3f, 0.4f);
    for (int team = 1; team <= TEAMS; team++) {
      discs[team] =
          s.archetype(
              new ArchetypeDef("player." + TEAM_NAMES[team])
                  .shape(new Circle(Discs.RADIUS), skin)
                  .fixedRotation(true)
                  .tag(team)
                  .appearance(Appearance.of(TEAM_COLORS[team], Appearance.Look.PLAYER)));
    }
    for (int team = 0; team <= TEAMS; team++) {
      lamps[team] =
          s.archetype(
              new ArchetypeDef("lamp." + TEAM_NAMES[team])
                  .type(BodyType.STATIC)
                  .shape(new Circle(0.3f), skin)
                  .sensor(true)
                  .appearance(
                      Appearance.of(
                          team == 0 ? 0x1d2733 : TEAM_COLORS[team], Appearance.Look.LAMP)));
    }
    ball =
        s.archetype(
            new ArchetypeDef("ball")
                .shape(new Circle(Balls.RADIUS), new Material(0.35f, 0.3f, 0.7f))
                .linearDamping(0.45f)
                .angularDamping(0.8f)
                .appearance(Appearance.of(0xffe08a, Appearance.Look.BALL)));
    spark =
        s.archetype(
            new ArchetypeDef("spark")
                .type(BodyType.STATIC)
                .shape(new Circle(0.25f), skin)
                .sensor(true)
                .appearance(Appearance.of(0xfff6c8, Appearance.Look.LAMP)));
    hit = s.event("hit", 0xffffff, 0, "", Sound.KNOCK, LOUD_HIT); // sparks show it
    dash = s.event("dash", 0x9ad1ff, 1.2f, "", Sound.WHOOSH, 0);
    jolt = s.event("jolt", 0xfff6c8, 1.5f, "", Sound.ZAP, 0);
    joltHit = s.event("jolt hit", 0xfff6c8, 2, "", Sound.KNOCK, ArenaGame.JOLT_IMPULSE);
    goal = s.event("goal", 0xffe08a, 6, "GOAL", Sound.FANFARE, 0);
    goals = s.level().zones("goal");
    boost = s.event("boost", 0x9ad1ff, 0, "", Sound.WHOOSH, 0);
    kickOffs.addAll(s.level().spawns("heavy ball"));
    heavies = kickOffs.size();
    kickOffs.addAll(s.level().spawns("ball"));
    heavyBall =
        heavies == 0
            ? null
            : s.archetype(
                new ArchetypeDef("heavy ball") // weighs 2.8 discs: one that rolls moves them
                    .shape(new Circle(Balls.HEAVY_RADIUS), new Material(1.1f, 0.3f, 0.5f))
                    .linearDamping(0.35f)
                    .angularDamping(0.8f)
                    .appearance(Appearance.of(0xb8c4d6, Appearance.Look.BALL)));
    for (Level.Zone home : s.level().zones("home")) {
      if (home.team() >= 1 && home.team() <= TEAMS) {
        homes[home.team()] = home;
      }
    }
    require(s, goals.size() >= TEAMS, "zones named \"goal\" of teams 1 and 2");
    require(s, kickOffs.size() > heavies, "a spawn named \"ball\"");
    require(
        s,
        heavies < ArenaFields.MAX_BALLS,
        "fewer than " + ArenaFields.MAX_BALLS + " spawns named \"heavy ball\"");
    require(s, homes[1] != null && homes[2] != null, "zones named \"home\" of teams 1 and 2");
  }

  private static void require(SetUp s, boolean met, String what) {
    if (!met) {
      throw new IllegalArgumentException(
          "level \"" + s.level().name() + "\" can't be played as arena: it needs " + what);
    }
  }

  /** Returns whether an entity is a ball of any weight. */
  boolean isBall(Entity e) {
    return e.archetype() == ball || (heavyBall != null && e.archetype() == heavyBall);
  }

  /** Returns where a ball is kicked off, 0..{@link ArenaFields#MAX_BALLS} - 1. */
  Level.Spawn kickOff(int ball) {
    return kickOffs.get(
        ball < heavies ? ball : heavies + (ball - heavies) % (kickOffs.size() - heavies));
  }

  /** Returns whether a place is inside a goal. */
  boolean isInGoal(float x, float y) {
    return goalAt(x, y) != null;
  }

  /** Returns the goal at a place, or null. */
  Level.Zone goalAt(float x, float y) {
    for (int g = 0; g < goals.size(); g++) {
      if (goals.get(g).contains(x, y)) {
        return goals.get(g);
      }
    }
    return null;
  }
}
