package carom.server.room;

import carom.physics.Collision;
import carom.physics.WorldDef;
import carom.server.metrics.Counter;
import carom.server.metrics.Counters;
import carom.sim.Entity;
import carom.sim.Game;
import carom.sim.Input;
import carom.sim.Level;
import carom.sim.Player;
import carom.sim.Simulation;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A game whose exceptions stop nobody: each callback that throws is counted, and the step goes on
 * as if it had returned. The room closes when each tick of a second has failed.
 *
 * <p>Set-up is not guarded: a game that can't be set up must not start.
 */
final class GuardedGame implements Game {
  private static final Logger LOG = LoggerFactory.getLogger(GuardedGame.class);

  private final Game game;
  private final Counters counters;
  private final String label;
  private boolean failedThisTick;
  private int failedTicksInARow;
  private long nextLogged = 1;

  /**
   * @param label begins each log line
   */
  GuardedGame(Game game, Counters counters, String label) {
    this.game = game;
    this.counters = counters;
    this.label = label;
  }

  /** Call after each tick. Returns how many ticks in a row, up to this one, had a failure. */
  int endTick() {
    failedTicksInARow = failedThisTick ? failedTicksInARow + 1 : 0;
    failedThisTick = false;
    return failedTicksInARow;
  }

  /** Counts a failure, and logs the 1st, 10th, 100th... of them. */
  void failed(String callback, Simulation s, Throwable failure) {
    counters.add(Counter.GAME_FAILURES, 1);
    failedThisTick = true;
    long total = counters.get(Counter.GAME_FAILURES);
    if (total == nextLogged) {
      nextLogged *= 10;
      LOG.error(
          "{}game {} failed in {} at tick {} (failure {}); the room goes on unless each tick fails",
          label,
          game.name(),
          callback,
          s.tick(),
          total,
          failure);
    }
  }

  @Override
  public String name() {
    return game.name();
  }

  @Override
  public String defaultLevel() {
    return game.defaultLevel();
  }

  @Override
  public String description() {
    return game.description();
  }

  @Override
  public WorldDef world(Level level) {
    return game.world(level);
  }

  @Override
  public int memorySize(Level level) {
    return game.memorySize(level);
  }

  @Override
  public void setUp(Simulation s) {
    game.setUp(s);
  }

  @Override
  public void join(Simulation s, Player p) {
    try {
      game.join(s, p);
    } catch (RuntimeException | AssertionError | StackOverflowError e) {
      failed("join of player " + p.id(), s, e);
    }
  }

  @Override
  public void leave(Simulation s, Player p) {
    try {
      game.leave(s, p);
    } catch (RuntimeException | AssertionError | StackOverflowError e) {
      failed("leave of player " + p.id(), s, e);
    }
  }

  @Override
  public void input(Simulation s, Player p, Input in) {
    try {
      game.input(s, p, in);
    } catch (RuntimeException | AssertionError | StackOverflowError e) {
      failed("input of player " + p.id(), s, e);
    }
  }

  @Override
  public void beforeStep(Simulation s) {
    try {
      game.beforeStep(s);
    } catch (RuntimeException | AssertionError | StackOverflowError e) {
      failed("beforeStep", s, e);
    }
  }

  @Override
  public void afterStep(Simulation s) {
    try {
      game.afterStep(s);
    } catch (RuntimeException | AssertionError | StackOverflowError e) {
      failed("afterStep", s, e);
    }
  }

  @Override
  public boolean collision(Simulation s, Collision<Entity> c) {
    try {
      return game.collision(s, c);
    } catch (RuntimeException | AssertionError | StackOverflowError e) {
      failed("collision", s, e);
      return true;
    }
  }
}
