package carom.server.match;

import carom.game.GuardedGame;
import carom.server.metrics.Counter;
import carom.server.metrics.Counters;
import carom.sim.Simulation;
import carom.sim.phase.Findings;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Counts the exceptions of a room's game and logs the 1st, 10th, 100th... of them. The room closes
 * when each tick of a second has failed.
 */
public final class GameFailures implements GuardedGame.FailureListener {
  private static final Logger LOG = LoggerFactory.getLogger(GameFailures.class);

  private final String game;
  private final Counters counters;
  private final String label;
  private boolean failedThisTick;
  private int failedTicksInARow;
  private long nextLogged = 1;
  private int toldFindings;

  /**
   * Creates a log without failures.
   *
   * @param game name of the game
   * @param label begins each log line
   */
  public GameFailures(String game, Counters counters, String label) {
    this.game = game;
    this.counters = counters;
    this.label = label;
  }

  /** Ends a tick, and returns how many ticks in a row, up to this one, had a failure. */
  public int endTick() {
    failedTicksInARow = failedThisTick ? failedTicksInARow + 1 : 0;
    failedThisTick = false;
    return failedTicksInARow;
  }

  /** Logs and counts what was found since the last call that the game's rules do wrongly. */
  public void tell(Findings findings) {
    for (; toldFindings < findings.count(); toldFindings++) {
      counters.add(Counter.UNPREDICTABLE, 1);
      LOG.warn("{}game {}: {}", label, game, findings.get(toldFindings));
    }
  }

  @Override
  public void failed(String callback, Simulation s, Throwable failure) {
    counters.add(Counter.GAME_FAILURES, 1);
    failedThisTick = true;
    long total = counters.get(Counter.GAME_FAILURES);
    if (total == nextLogged) {
      nextLogged *= 10;
      LOG.error(
          "{}game {} failed in {} at tick {} (failure {}); the room goes on unless each tick fails",
          label,
          game,
          callback,
          s.tick(),
          total,
          failure);
    }
  }
}
