package carom.client;

import carom.game.GameFault;
import carom.game.GuardedGame;
import carom.sim.Simulation;
import java.util.Locale;
import java.util.function.Consumer;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Hears when the predicted game of a stay fails: logs the first failure, and tells the player that
 * the stay goes on without prediction. One stay's; one thread.
 */
final class PredictionFailure implements GuardedGame.FailureListener {
  private static final Logger LOG = LoggerFactory.getLogger(PredictionFailure.class);

  private final String game;
  private final int playerId;
  private final Consumer<String> player;
  private boolean failed;

  /**
   * Creates one that has heard nothing.
   *
   * @param game name of the game
   * @param playerId the own player's id
   * @param player receives the sentence
   */
  PredictionFailure(String game, int playerId, Consumer<String> player) {
    this.game = game;
    this.playerId = playerId;
    this.player = player;
  }

  /** Returns whether the game has failed. */
  boolean hasFailed() {
    return failed;
  }

  @Override
  public void failed(String callback, Simulation s, Throwable failure) {
    if (failed) {
      return;
    }
    failed = true;
    String text =
        String.format(
            Locale.ROOT,
            "Game %s failed in %s at tick %d, predicted for player %d: %s. You play on without"
                + " prediction.",
            game,
            callback,
            s.tick(),
            playerId,
            GameFault.describe(failure));
    LOG.error("{}", text, failure);
    player.accept(text);
  }
}
