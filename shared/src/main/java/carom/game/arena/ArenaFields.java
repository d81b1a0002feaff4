package carom.game.arena;

import static carom.sim.event.Audience.ALL;
import static carom.sim.event.Audience.NOBODY;
import static carom.sim.field.Scope.ACCOUNT;
import static carom.sim.field.Scope.ENTITY;
import static carom.sim.field.Scope.MATCH;

import carom.sim.field.Count;
import carom.sim.field.Countdown;
import carom.sim.field.EntityRef;
import carom.sim.field.Field;
import carom.sim.field.Flag;
import carom.sim.field.PlayerRef;
import carom.sim.field.Ratio;
import carom.sim.field.Real;
import java.util.List;

/** The arena's state: all that it keeps from tick to tick beside bodies, teams and scores. */
public final class ArenaFields {
  /** Most balls at once. */
  static final int MAX_BALLS = 4;

  /** Most sparks at once. */
  static final int MAX_SPARKS = 16;

  /**
   * Boost that a disc has left, 0..1. Its steps are coarse, so that it changes, and is sent, a few
   * times a second and not in every tick.
   */
  public static final Ratio BOOST = Field.ratio("boost", ArenaGame.BOOST_STEPS).startsAt(1);

  // Of a player. Input writes them, so that clients predict dashes and jolts.
  static final Countdown DASH = Field.countdown("dash"); // while it lasts
  static final Countdown DASH_WAIT = Field.countdown("dashWait"); // until the next one
  static final Real DASH_X = Field.real("dashX"); // where it goes
  static final Real DASH_Y = Field.real("dashY");
  static final Countdown BURST = Field.countdown("burst"); // until the next step of boost is due
  static final Flag JOLTS = Field.flag("jolts"); // gives a jolt in this tick
  static final Countdown JOLT_WAIT = Field.countdown("joltWait");

  // Of an account.
  static final Count WINS = Field.count("wins").of(ACCOUNT).to(ALL);
  static final Count SCORED = Field.count("scored").of(ACCOUNT).to(ALL);
  static final Count RATING = Field.count("rating", 0, 3_000).of(ACCOUNT).to(ALL).startsAt(1_500);

  // Of the match. Goals have the team as index.
  static final Count GOALS =
      Field.count("goals", 0, ArenaGame.GOALS_TO_WIN).of(MATCH).to(ALL).times(Pitch.TEAMS + 1);
  static final EntityRef BALL = Field.entity("ball").of(MATCH).to(ALL).times(MAX_BALLS);
  static final Countdown BALL_WAIT =
      Field.countdown("ballWait").of(MATCH).to(NOBODY).times(MAX_BALLS);
  static final EntityRef LAMP =
      Field.entity("lamp").of(MATCH).to(NOBODY).times(Pitch.TEAMS * ArenaGame.GOALS_TO_WIN);
  static final EntityRef SPARK = Field.entity("spark").of(MATCH).to(NOBODY).times(MAX_SPARKS);

  // Of a ball: the players who touched it last, and for how long it has stayed around one place.
  static final PlayerRef TOUCHED = Field.player("touched").of(ENTITY).to(NOBODY);
  static final PlayerRef TOUCHED_BEFORE = Field.player("touchedBefore").of(ENTITY).to(NOBODY);
  static final Real PLACE_X = Field.real("placeX").of(ENTITY).to(NOBODY);
  static final Real PLACE_Y = Field.real("placeY").of(ENTITY).to(NOBODY);
  static final Countdown UNTIL_STUCK = Field.countdown("untilStuck").of(ENTITY).to(NOBODY);

  // Of a spark.
  static final Countdown GLOW = Field.countdown("glow").of(ENTITY).to(NOBODY);

  private ArenaFields() {}

  /** Returns all of them, in the order of the protocol. */
  static List<Field<?>> all() {
    return List.of(
        DASH,
        DASH_WAIT,
        DASH_X,
        DASH_Y,
        JOLTS,
        JOLT_WAIT,
        WINS,
        SCORED,
        GOALS,
        BALL,
        BALL_WAIT,
        LAMP,
        SPARK,
        TOUCHED,
        TOUCHED_BEFORE,
        PLACE_X,
        PLACE_Y,
        UNTIL_STUCK,
        GLOW,
        BOOST,
        BURST,
        RATING);
  }
}
