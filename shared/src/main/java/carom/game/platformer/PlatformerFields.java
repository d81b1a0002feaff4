package carom.game.platformer;

import static carom.sim.event.Audience.ALL;
import static carom.sim.event.Audience.NOBODY;
import static carom.sim.event.Audience.OWNER;
import static carom.sim.field.Scope.ACCOUNT;
import static carom.sim.field.Scope.ENTITY;
import static carom.sim.field.Scope.MATCH;

import carom.sim.field.Choice;
import carom.sim.field.Count;
import carom.sim.field.Countdown;
import carom.sim.field.EntityRef;
import carom.sim.field.Field;
import carom.sim.field.Flag;
import carom.sim.field.PlayerRef;
import carom.sim.field.Real;
import java.util.List;

/** The state of the platformer: what is saved, hashed and sent. */
public final class PlatformerFields {
  /** Most coins of a level. */
  static final int MAX_COINS = 1_024;

  /** Most foes of a level. */
  static final int MAX_FOES = 32;

  /** Most samples of a run's path. */
  static final int MAX_SAMPLES = 200;

  /** Longest run that counts, ms. */
  static final int MAX_RUN_MS = 600_000;

  // Of a player. Input writes them, so that clients predict jumps.
  static final Count CAN_JUMP = Field.count("canJump", 0, 1_000); // ticks after an edge
  static final Countdown WANTS_JUMP = Field.countdown("wantsJump"); // also before landing
  static final Countdown DROPS = Field.countdown("drops"); // one-way platforms don't hold
  static final Flag JUMPING = Field.flag("jumping");

  /** Ticks for which foes don't harm a player who was hurt or has just come. */
  public static final Countdown HURT = Field.countdown("hurt");

  // What input found, until the server has added it to the score.
  static final Count EARNED = Field.count("earned", -100, 100).to(NOBODY);

  // Of a player without a body: when and at which spawn it comes back.
  static final Countdown RESPAWN = Field.countdown("respawn").to(OWNER);
  static final Count RESPAWN_PLACE = Field.count("respawnPlace", 0, 65_535).to(NOBODY);

  // Of a player's run from the start to the goal: ready at the start, then the time that is left.
  static final Flag READY = Field.flag("ready");

  /** Ticks until a player's run no longer counts; over while there is none. */
  public static final Countdown RUN = Field.countdown("run").to(ALL);

  /** Best time of a player on this course, ms; 0 for none. */
  public static final Count OWN_BEST = Field.count("ownBest", 0, MAX_RUN_MS).to(ALL);

  static final Count PATH = path("path").to(NOBODY).times(MAX_SAMPLES);

  // Of a player who has passed a checkpoint: its place, to which the player comes back.
  static final Flag CHECKED = Field.flag("checked").to(NOBODY);
  static final Real CHECK_X = Field.real("checkX").to(NOBODY);
  static final Real CHECK_Y = Field.real("checkY").to(NOBODY);

  // Of an account.
  static final Count WINS = Field.count("wins").of(ACCOUNT).to(ALL);
  static final Count BEST_MS =
      Field.count("bestMs", 0, 3_600_000).of(ACCOUNT).to(ALL).lowestIsBest();

  // Of an account: best times on the courses that ship.
  static final Count GAP_MS =
      Field.count("gapMs", 0, MAX_RUN_MS).of(ACCOUNT).to(ALL).lowestIsBest();
  static final Count RUINS_MS =
      Field.count("ruinsMs", 0, MAX_RUN_MS).of(ACCOUNT).to(ALL).lowestIsBest();

  // Of the match: its best run, whose path all clients can show.

  /** Time of the best run of the match, ms; 0 for none. */
  public static final Count BEST_RUN = Field.count("bestRun", 0, MAX_RUN_MS).of(MATCH).to(ALL);

  /** Player of the best run, unless it has left. */
  public static final PlayerRef BEST_RUNNER = Field.player("bestRunner").of(MATCH).to(ALL);

  /** Number of samples of the best run's path; 0 for a run that took too long to be kept. */
  public static final Count BEST_LENGTH =
      Field.count("bestLength", 0, MAX_SAMPLES).of(MATCH).to(ALL);

  /** The path of the best run, as {@link Runs#x} and {@link Runs#y} read it. */
  public static final Count BEST_PATH = path("bestPath").of(MATCH).to(ALL).times(MAX_SAMPLES);

  // Of a foe: its zone, which way it goes, its mood and the next one, and its prey.
  static final Count HAUNT = Field.count("haunt", 0, MAX_FOES - 1).of(ENTITY);
  static final Flag BACK = Field.flag("back").of(ENTITY);
  static final Choice<Foes.Mood> MOOD = Field.choice("mood", Foes.Mood.class).of(ENTITY);
  static final Choice<Foes.Mood> NEXT_MOOD = Field.choice("nextMood", Foes.Mood.class).of(ENTITY);
  static final Countdown REACTS = Field.countdown("reacts").of(ENTITY); // until the next mood
  static final PlayerRef PREY = Field.player("prey").of(ENTITY).to(NOBODY);
  static final EntityRef FOE = Field.entity("foe").of(MATCH).to(NOBODY).times(MAX_FOES);
  static final Countdown FOE_WAIT = Field.countdown("foeWait").of(MATCH).to(NOBODY).times(MAX_FOES);

  // Of the match: the flag and the coins.
  static final EntityRef FLAG = Field.entity("flag").of(MATCH).to(ALL);
  static final Count FLAG_PLACE = Field.count("flagPlace", 0, 65_535).of(MATCH).to(NOBODY);
  static final Countdown FLAG_WAIT = Field.countdown("flagWait").of(MATCH).to(ALL);
  static final EntityRef COIN = Field.entity("coin").of(MATCH).to(NOBODY).times(MAX_COINS);
  static final Countdown COIN_WAIT =
      Field.countdown("coinWait").of(MATCH).to(NOBODY).times(MAX_COINS);

  private PlatformerFields() {}

  private static Count path(String name) {
    return Field.count(name, 0, Runs.MAX_POINT);
  }

  /** Returns all of them. */
  static List<Field<?>> all() {
    return List.of(
        CAN_JUMP,
        WANTS_JUMP,
        DROPS,
        JUMPING,
        HURT,
        EARNED,
        READY,
        RUN,
        OWN_BEST,
        PATH,
        RESPAWN,
        RESPAWN_PLACE,
        CHECKED,
        CHECK_X,
        CHECK_Y,
        WINS,
        BEST_MS,
        GAP_MS,
        RUINS_MS,
        BEST_RUN,
        BEST_RUNNER,
        BEST_LENGTH,
        BEST_PATH,
        HAUNT,
        BACK,
        MOOD,
        NEXT_MOOD,
        REACTS,
        PREY,
        FOE,
        FOE_WAIT,
        FLAG,
        FLAG_PLACE,
        FLAG_WAIT,
        COIN,
        COIN_WAIT);
  }
}
