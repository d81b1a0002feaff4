package carom.server.checkpoint;

import carom.server.match.Match;
import carom.server.session.Session;
import carom.sim.outbox.NextMatch;
import java.util.List;

/**
 * A room as it was when an earlier run ended.
 *
 * @param match the match, at the last tick that the log has
 * @param rotation index of its level in the room's rotation
 * @param pending the match that was wanted but not loaded, or null
 * @param sessions in their grace period, without links
 * @param lostTicks ticks of the log that didn't come out as they were logged, at least
 */
public record ResumedRoom(
    Match match, int rotation, NextMatch pending, List<Session> sessions, int lostTicks) {
  /** Copies the list. */
  public ResumedRoom {
    sessions = List.copyOf(sessions);
  }
}
