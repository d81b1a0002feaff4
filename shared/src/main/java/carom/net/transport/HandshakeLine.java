package carom.net.transport;

import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;

/**
 * The simulated bad network where {@link ImpairedLink} isn't: below the handshake of links, and
 * {@link BadLine}s. A step of the handshake is an answer, so it leaves later by the way there and
 * the way back. It runs what is due on one daemon thread. Any thread may use it.
 */
public final class HandshakeLine implements AutoCloseable {
  private final Impairment impairment;
  private final SplitMix random; // guarded by this
  private final ScheduledThreadPoolExecutor clock;

  /**
   * Starts the line of a transport.
   *
   * @param impairment of each direction
   */
  public HandshakeLine(Impairment impairment) {
    this.impairment = impairment;
    random = new SplitMix(impairment.seed());
    clock =
        new ScheduledThreadPoolExecutor(
            1,
            work -> {
              Thread thread = new Thread(work, "carom-simulated-network");
              thread.setDaemon(true);
              return thread;
            },
            new ThreadPoolExecutor.DiscardPolicy());
  }

  /** Returns a round trip of this line, ns; each call draws its own. */
  public synchronized long roundTripNanos() {
    return oneWayNanos() + oneWayNanos();
  }

  /** Returns the time of one way, ns; each call draws its own. */
  public synchronized long oneWayNanos() {
    double ms = impairment.latencyMs() + (2 * random.unit() - 1) * impairment.jitterMs();
    return (long) (Math.max(0, ms) * 1e6);
  }

  /** Returns whether a datagram is lost. */
  public synchronized boolean losesOne() {
    return random.unit() * 100 < impairment.lossPercent();
  }

  /** Returns whether a datagram or the answer to it is lost. */
  public synchronized boolean loses() {
    double arrives = 1 - impairment.lossPercent() / 100;
    return random.unit() >= arrives * arrives;
  }

  /** Returns whether no datagram passes at all. */
  public boolean isDeaf() {
    return impairment.lossPercent() >= 100;
  }

  /** Runs work after a delay. After {@link #close} it does nothing. */
  @SuppressWarnings("FutureReturnValueIgnored") // what is sent may fail, as on any network
  public void after(long nanos, Runnable work) {
    clock.schedule(work, nanos, TimeUnit.NANOSECONDS);
  }

  /** Ends the thread; what waits is lost. A second call does nothing. */
  @Override
  public void close() {
    clock.shutdownNow();
  }
}
