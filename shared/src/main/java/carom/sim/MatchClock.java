package carom.sim;

import carom.physics.math.Limits;
import carom.sim.entity.HostPlayer;
import carom.sim.entity.Player;
import carom.sim.entity.PlayerTable;
import carom.sim.event.Audience;
import carom.sim.field.Count;
import carom.sim.field.Countdown;
import carom.sim.field.Field;
import carom.sim.field.FieldHolder;
import carom.sim.field.FieldReader;
import carom.sim.field.Flag;
import carom.sim.field.Scope;
import carom.sim.outbox.NextMatch;
import java.util.List;

/**
 * The phases of a match: it waits for players, counts down, is played for some time, and shows its
 * result before the next match begins, if anybody is there to play it. A game returns one from
 * {@code Game.clock}; the simulation drives it.
 *
 * <pre>
 *              enough players,              time over,
 *              all ready                    finish
 *   WARM_UP ─────────────────► COUNTDOWN ─► PLAYING ─► OVER ─► the room's next match
 * </pre>
 *
 * <p>The clock's state is in fields of the match, which all players are told. Countdown, play and
 * result are told at once as the ticks at which they end, so that a client knows the phase of every
 * tick that it predicts, without a message. Only a match that {@linkplain #finish ends early}
 * reaches it a moment later.
 *
 * <p>Where a method takes a match, a game passes its {@code Simulation}, and a client the fields
 * that it shows. Immutable; a constant of a game's class may hold it.
 */
public final class MatchClock {
  private static final int ENDLESS = Integer.MAX_VALUE / 4;
  private static final int NOBODY = -1;

  private static final Flag BEGUN = Field.flag("clockBegun").of(Scope.MATCH).to(Audience.ALL);
  private static final Countdown UNTIL_PLAYING = countdown("clockPlaying");
  private static final Countdown UNTIL_OVER = countdown("clockOver");
  private static final Countdown UNTIL_NEXT = countdown("clockNext");
  private static final Count WINNER =
      Field.count("clockWinner", NOBODY, PlayerTable.MAX_PLAYERS - 1)
          .of(Scope.MATCH)
          .to(Audience.ALL)
          .startsAt(NOBODY);
  private static final Count WINNING_TEAM =
      Field.count("clockTeam", 0, 255).of(Scope.MATCH).to(Audience.ALL);
  private static final Count TOLD =
      Field.count("clockTold", 0, MatchPhase.values().length - 1)
          .of(Scope.MATCH)
          .to(Audience.NOBODY);
  private static final List<Field<?>> FIELDS =
      List.of(BEGUN, UNTIL_PLAYING, UNTIL_OVER, UNTIL_NEXT, WINNER, WINNING_TEAM, TOLD);
  private static final MatchPhase[] PHASES = MatchPhase.values();

  private final int players;
  private final boolean waitsForReady;
  private final float countdownSeconds;
  private final float playSeconds;
  private final float overSeconds;
  private final NextMatch next;

  private MatchClock(
      int players,
      boolean waitsForReady,
      float countdownSeconds,
      float playSeconds,
      float overSeconds,
      NextMatch next) {
    this.players = players;
    this.waitsForReady = waitsForReady;
    this.countdownSeconds = countdownSeconds;
    this.playSeconds = playSeconds;
    this.overSeconds = overSeconds;
    this.next = next;
  }

  private static Countdown countdown(String name) {
    return Field.countdown(name).of(Scope.MATCH).to(Audience.ALL);
  }

  /**
   * Returns a clock of matches that are played at once, show their result for 8 s, and are followed
   * by the next level of the room.
   *
   * @param seconds how long a match is played, 0..86,400; 0 = until the game {@linkplain #finish
   *     finishes} it
   */
  public static MatchClock playing(float seconds) {
    require("seconds", seconds, 86_400);
    return new MatchClock(0, false, 0, seconds, 8, NextMatch.OF_ROTATION);
  }

  /**
   * Returns a copy with a warm-up, which lasts until there are enough players.
   *
   * @param enough number of players, 1..1,024
   */
  public MatchClock warmUp(int enough) {
    require("enough", enough, PlayerTable.MAX_PLAYERS);
    return new MatchClock(enough, waitsForReady, countdownSeconds, playSeconds, overSeconds, next);
  }

  /**
   * Returns a copy whose warm-up lasts until all players are {@linkplain HostPlayer#isReady ready}.
   */
  public MatchClock whenReady() {
    return new MatchClock(
        Math.max(1, players), true, countdownSeconds, playSeconds, overSeconds, next);
  }

  /**
   * Returns a copy that counts down before the match.
   *
   * @param seconds 0..60
   */
  public MatchClock countdown(float seconds) {
    require("seconds", seconds, 60);
    return new MatchClock(players, waitsForReady, seconds, playSeconds, overSeconds, next);
  }

  /**
   * Returns a copy that shows the result for some time.
   *
   * @param seconds 0..600
   */
  public MatchClock over(float seconds) {
    require("seconds", seconds, 600);
    return new MatchClock(players, waitsForReady, countdownSeconds, playSeconds, seconds, next);
  }

  /** Returns a copy of matches that are followed by another than the next level of the room. */
  public MatchClock next(NextMatch followed) {
    return new MatchClock(
        players,
        waitsForReady,
        countdownSeconds,
        playSeconds,
        overSeconds,
        Limits.notNull("followed", followed));
  }

  private static void require(String name, float value, float max) {
    if (!(value >= 0 && value <= max)) {
      throw new IllegalArgumentException(name + "=" + value + " is outside 0.." + max);
    }
  }

  // ---- asked by games and clients

  /** Returns the phase. */
  public static MatchPhase phase(FieldReader<?, ?> match) {
    if (!Limits.notNull("match", match).get(BEGUN)) {
      return MatchPhase.WARM_UP;
    }
    if (match.get(UNTIL_PLAYING) > 0) {
      return MatchPhase.COUNTDOWN;
    }
    return match.get(UNTIL_OVER) > 0 ? MatchPhase.PLAYING : MatchPhase.OVER;
  }

  /** Returns whether the match is played: not before its countdown is over, and not afterwards. */
  public static boolean isPlaying(FieldReader<?, ?> match) {
    return phase(match) == MatchPhase.PLAYING;
  }

  /** Returns the ticks until the phase ends, or -1 if no time ends it. */
  public static int ticksLeft(FieldReader<?, ?> match) {
    return switch (phase(match)) {
      case WARM_UP -> -1;
      case COUNTDOWN -> match.get(UNTIL_PLAYING);
      case PLAYING -> match.get(UNTIL_OVER) >= ENDLESS / 2 ? -1 : match.get(UNTIL_OVER);
      case OVER -> match.get(UNTIL_NEXT);
    };
  }

  /** Returns the id of the player who has won, or -1 for none. */
  public static int winner(FieldReader<?, ?> match) {
    return Limits.notNull("match", match).get(WINNER);
  }

  /** Returns the team that has won, or 0 for none. */
  public static int winningTeam(FieldReader<?, ?> match) {
    return Limits.notNull("match", match).get(WINNING_TEAM);
  }

  /** Returns the number of players for which the warm-up waits; 0 = there is none. */
  public int playersToBegin() {
    return players;
  }

  /** Returns whether the warm-up waits for all players to be ready. */
  public boolean waitsForReady() {
    return waitsForReady;
  }

  // ---- told by games

  /** Ends a match that is played without a winner. Does nothing in another phase. */
  public void finish(FieldHolder<?, ?> match) {
    finish(match, NOBODY, 0);
  }

  /**
   * Ends a match that is played, won by a player, or by nobody for null. Does nothing in another
   * phase.
   */
  public void finish(FieldHolder<?, ?> match, Player winner) {
    finish(match, winner == null ? NOBODY : winner.id(), 0);
  }

  /** Ends a match that is played, won by a team. Does nothing in another phase. */
  public void finish(FieldHolder<?, ?> match, int winningTeam) {
    finish(match, NOBODY, winningTeam);
  }

  private static void finish(FieldHolder<?, ?> match, int winner, int winningTeam) {
    requireTeam(winningTeam);
    if (isPlaying(match)) {
      int over = match.get(UNTIL_NEXT) - match.get(UNTIL_OVER); // how long the result is shown
      match.set(UNTIL_OVER, 0);
      match.set(UNTIL_NEXT, over);
      decide(match, winner, winningTeam);
    }
  }

  /**
   * Says who has won a match that ended by its time; in {@code Game.phase} for {@link
   * MatchPhase#OVER}.
   *
   * @param winner null for none
   * @param winningTeam 0 for none
   */
  public void decide(FieldHolder<?, ?> match, Player winner, int winningTeam) {
    decide(match, winner == null ? NOBODY : winner.id(), winningTeam);
  }

  private static void requireTeam(int team) {
    if (team < 0 || team > WINNING_TEAM.max()) {
      throw new IllegalArgumentException(
          "winningTeam=" + team + " is outside 0.." + WINNING_TEAM.max() + "; 0 is for none");
    }
  }

  private static void decide(FieldHolder<?, ?> match, int winner, int winningTeam) {
    requireTeam(winningTeam);
    Limits.notNull("match", match).set(WINNER, winner);
    match.set(WINNING_TEAM, winningTeam);
  }

  // ---- driven by the simulation

  /** Returns the fields of a match that has a clock; unmodifiable. */
  public static List<Field<?>> fields() {
    return FIELDS;
  }

  /**
   * Begins a match without warm-up; when the game has been set up, in both roles.
   *
   * @param tickRate ticks per second
   */
  public void setUp(FieldHolder<?, ?> match, int tickRate) {
    if (players == 0) {
      begin(match, tickRate);
    }
  }

  private void begin(FieldHolder<?, ?> match, int tickRate) {
    int playing = countdownSeconds == 0 ? 0 : Countdown.ticks(countdownSeconds, tickRate);
    int over = playSeconds == 0 ? ENDLESS : playing + Countdown.ticks(playSeconds, tickRate);
    match.set(BEGUN, true);
    match.set(UNTIL_PLAYING, playing);
    match.set(UNTIL_OVER, over);
    match.set(UNTIL_NEXT, over + Countdown.ticks(overSeconds, tickRate));
  }

  /**
   * Goes on to the next phase if it is time; on the server, in each tick.
   *
   * @param present the players of the match
   * @param tickRate ticks per second
   * @return the phase that begins, of which the game should be told, or null for none
   */
  public MatchPhase beforeStep(FieldHolder<?, ?> match, PlayerTable present, int tickRate) {
    if (!match.get(BEGUN) && present.count() >= players && (!waitsForReady || present.allReady())) {
      begin(match, tickRate);
    }
    MatchPhase phase = phase(match);
    if (phase == PHASES[match.get(TOLD)]) {
      return null;
    }
    match.set(TOLD, phase.ordinal());
    return phase;
  }

  /** Returns whether the result was shown for long enough and a player waits for the next match. */
  public boolean isDone(FieldHolder<?, ?> match, PlayerTable present) {
    return phase(match) == MatchPhase.OVER && match.get(UNTIL_NEXT) == 0 && present.count() > 0;
  }

  /** Returns what the room plays after the match. */
  public NextMatch next() {
    return next;
  }
}
