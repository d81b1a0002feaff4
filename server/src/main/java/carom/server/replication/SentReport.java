package carom.server.replication;

import carom.net.snapshot.Explanation;
import java.util.Locale;

/**
 * Answers an operator's question why a player was not sent an entity, or that it was.
 *
 * @param why what became of the entity's record
 * @param nearRowsWaiting rows of what is near the player that wait for room in a snapshot
 * @param paceBytesPerSecond what the player's line is given, bytes/s
 */
public record SentReport(Explanation why, int nearRowsWaiting, int paceBytesPerSecond) {
  /** Returns all values in one line, for programs. */
  @Override
  public String toString() {
    return String.format(
        Locale.ROOT,
        "%s nearRowsWaiting=%d paceBytesPerSecond=%d",
        why,
        nearRowsWaiting,
        paceBytesPerSecond);
  }
}
