package carom.client.desktop.paint;

import carom.game.GameFault;
import java.util.HashSet;
import java.util.Set;
import java.util.function.Consumer;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Runs the parts of a picture: layers, effects, panels. A part that throws is left out from then
 * on, until the next level or look, and the rest of the picture goes on. Log and player are told
 * once of each failure, and anew of another one of the same part. Render thread only.
 */
public final class PictureParts {
  private static final Logger LOG = LoggerFactory.getLogger(PictureParts.class);

  private final Runnable repair;
  private final Consumer<String> player;
  private final Set<String> broken = new HashSet<>();
  private final Set<String> told = new HashSet<>();

  /**
   * Creates a picture of which no part has failed.
   *
   * @param repair ends what a part that threw has begun, such as a batch
   * @param player receives a sentence about each part that failed
   */
  public PictureParts(Runnable repair, Consumer<String> player) {
    this.repair = repair;
    this.player = player;
  }

  /** Tries all parts again, because another level is shown, or by another look. */
  public void renew() {
    broken.clear();
  }

  /** Returns whether a part is left out. */
  public boolean isBroken(String name) {
    return broken.contains(name);
  }

  /**
   * Runs a part, unless it has failed before.
   *
   * @param name of the part, for people
   */
  public void run(String name, Runnable part) {
    if (broken.contains(name)) {
      return;
    }
    try {
      part.run();
    } catch (RuntimeException | Error e) { // also an error: what the part had allocated is free now
      broken.add(name);
      repair.run();
      String reason = GameFault.describe(e);
      if (told.add(name + reason)) {
        LOG.error("the picture's part \"{}\" failed and is left out: {}", name, reason, e);
        player.accept("A part of the picture failed and is left out: " + name);
      }
    }
  }
}
