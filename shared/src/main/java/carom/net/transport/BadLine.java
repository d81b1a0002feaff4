package carom.net.transport;

import java.util.concurrent.atomic.AtomicLong;

/**
 * One direction of a simulated bad network, for links that send by themselves: work is done later,
 * or not at all. Any thread may use it.
 */
public final class BadLine {
  private final HandshakeLine line;
  private final AtomicLong lastNs = new AtomicLong(System.nanoTime());

  /** Creates a direction of a line. */
  public BadLine(HandshakeLine line) {
    this.line = line;
  }

  /** Does what reaches the other end for sure, after all that was reliable before. */
  public void reliable(Runnable work) {
    long nowNs = System.nanoTime();
    long wayNs = line.oneWayNanos();
    long dueNs = lastNs.updateAndGet(last -> last - nowNs - wayNs > 0 ? last : nowNs + wayNs);
    line.after(dueNs - nowNs, work);
  }

  /** Does what a datagram does, unless it is lost. */
  public void datagram(Runnable work) {
    if (!line.losesOne()) {
      line.after(line.oneWayNanos(), work);
    }
  }
}
