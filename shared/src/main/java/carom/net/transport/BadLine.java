package carom.net.transport;

import java.util.ArrayDeque;

/**
 * One direction of a simulated bad network, for links that send by themselves: work is done later,
 * or not at all. Any thread may use it.
 */
public final class BadLine {
  private final HandshakeLine line;
  private final ArrayDeque<Runnable> inOrder = new ArrayDeque<>();
  private long lastNs = System.nanoTime();

  /** Creates a direction of a line. */
  public BadLine(HandshakeLine line) {
    this.line = line;
  }

  /** Does what reaches the other end for sure, after all that was reliable before. */
  public synchronized void reliable(Runnable work) {
    long nowNs = System.nanoTime();
    lastNs += Math.max(0, nowNs + line.oneWayNanos() - lastNs);
    inOrder.add(work);
    line.after(lastNs - nowNs, this::doNext); // works due at once may change places
  }

  private void doNext() {
    Runnable work;
    synchronized (this) {
      work = inOrder.remove();
    }
    work.run();
  }

  /** Does what a datagram does, unless it is lost. */
  public void datagram(Runnable work) {
    if (!line.losesOne()) {
      line.after(line.oneWayNanos(), work);
    }
  }
}
