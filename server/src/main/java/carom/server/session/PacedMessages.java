package carom.server.session;

import carom.net.transport.Broadcast;
import java.util.List;
import java.util.concurrent.TimeUnit;

/**
 * A long answer to one client, in several messages: the first ones go at once, and the others one
 * by one, so that they never fill what a link holds for a client on a slow line. One thread.
 */
public final class PacedMessages {
  /** Messages that go at once: a link holds as many of the largest. */
  private static final int AT_ONCE = 4;

  private static final long GAP_NS = TimeUnit.MILLISECONDS.toNanos(50);

  private List<Broadcast> messages = List.of();
  private int next;
  private long lastNs;

  /** Creates an answer that is sent. */
  public PacedMessages() {}

  /** Begins another answer, when the one before {@link #isSent}. */
  public void begin(List<Broadcast> answer) {
    messages = answer;
    next = 0;
  }

  /** Returns whether nothing is left to send. */
  public boolean isSent() {
    return next == messages.size();
  }

  /** Takes the next message to send now, or returns null. */
  public Broadcast take(long nowNs) {
    if (isSent() || (next >= AT_ONCE && nowNs - lastNs < GAP_NS)) {
      return null;
    }
    lastNs = nowNs;
    return messages.get(next++);
  }
}
