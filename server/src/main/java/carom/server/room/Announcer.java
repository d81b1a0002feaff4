package carom.server.room;

import carom.net.protocol.ServerMessage;
import carom.server.session.Session;

/**
 * Tells players in a line of text what happens in their room.
 *
 * <p>Lines about players that come and go are limited, because a crowd can come and go at once: to
 * {@value #PER_SECOND} a second after {@value #BURST} at once, and fewer with many players, each of
 * which gets the line. A line that is left out is no loss, since the roster tells the same.
 */
final class Announcer {
  private static final float BURST = 20;
  private static final float PER_SECOND = 2;

  /** A line to more sessions than these counts as several. */
  private static final int FEW_SESSIONS = 64;

  private final RoomSessions sessions;
  private final int tickRateHz;
  private float credit = BURST;
  private int creditTick;

  Announcer(RoomSessions sessions, int tickRateHz) {
    this.sessions = sessions;
    this.tickRateHz = tickRateHz;
  }

  /** Sends a text to all players. */
  void notice(String text) {
    sessions.sendToAll(new ServerMessage.Notice(text), null);
  }

  /** Tells all others that a player has come or gone, unless there were too many such lines. */
  void comingOrGoing(Session about, String text, int tick) {
    credit = Math.min(BURST, credit + (tick - creditTick) * PER_SECOND / tickRateHz);
    creditTick = tick;
    if (credit >= 1) {
      credit -= Math.max(1, sessions.count() / (float) FEW_SESSIONS);
      sessions.sendToAll(new ServerMessage.Notice(text), about);
    }
  }
}
