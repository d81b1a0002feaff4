package carom.server.threads;

import java.util.Locale;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.LongSupplier;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A thread of the server, for the lobby or for one room. It alternates turns and naps until it is
 * stopped or its duty has failed, and then says farewell. An exception that reaches this class is a
 * bug. The thread logs it and goes on, unless {@value #MAX_FAILURES_IN_A_ROW} turns in a row fail.
 */
public final class Worker implements WatchedThread {
  /** Longest farewell, ms. Links stay open for so long that the last message arrives. */
  public static final long FAREWELL_MS = 400;

  private static final Logger LOG = LoggerFactory.getLogger(Worker.class);
  private static final long FAREWELL_NAP_NS = TimeUnit.MILLISECONDS.toNanos(4);
  private static final int MAX_FAILURES_IN_A_ROW = 100;

  /**
   * Nap after which a thread must say that it is awake, ns: a {@link Watchdog} looks at it again.
   */
  private static final long REST_NS = TimeUnit.MILLISECONDS.toNanos(100);

  /** The work of a worker. The worker's thread calls every method. */
  public interface Duty {
    /** Does the work that is due. */
    void turn(long nowNs);

    /**
     * Returns how long the thread may sleep now, nanoseconds; {@link Long#MAX_VALUE} until {@link
     * Worker#wake}.
     */
    long napNs(long nowNs);

    /** Returns whether the duty can't go on. */
    boolean hasFailed();

    /** Makes the duty fail and logs why. */
    void fail(String why);

    /** Says goodbye to all clients. Does nothing after {@link #fail}. */
    void close(long nowNs);

    /** Returns whether no link is left. */
    boolean isDeserted();

    /** Closes the remaining links. */
    void closeLinks();
  }

  private final Duty duty;
  private final LongSupplier clock;
  private final Runnable onEnd;
  private final Thread thread;
  private volatile boolean stopping;
  private volatile boolean resting;
  private volatile Runnable onAwake = () -> {};

  /**
   * Creates a worker whose thread doesn't run yet.
   *
   * @param name name of the thread
   * @param onEnd called as the thread's last act, however it ends
   */
  public Worker(String name, Duty duty, LongSupplier clock, Runnable onEnd) {
    this.duty = duty;
    this.clock = clock;
    this.onEnd = onEnd;
    this.thread = new Thread(this::run, name);
  }

  /** Starts the thread. It is no daemon thread, so it keeps the JVM alive. */
  public void start(int priority) {
    thread.setPriority(priority);
    thread.start();
  }

  /** Asks the thread to end and doesn't wait. */
  public void stop() {
    stopping = true;
    wake();
  }

  /** Ends the thread's nap, or the next one if it takes none now. Any thread. */
  public void wake() {
    LockSupport.unpark(thread);
  }

  /** Waits until the thread ends, or until {@code endNs} in the time of {@link System#nanoTime}. */
  public void join(long endNs) {
    try {
      thread.join(Math.max(1, TimeUnit.NANOSECONDS.toMillis(endNs - System.nanoTime())));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    if (thread.isAlive()) {
      LOG.warn("thread {} did not end in time", thread.getName());
    }
  }

  /** Returns the name of the thread. */
  public String name() {
    return thread.getName();
  }

  @Override
  public Thread thread() {
    return thread;
  }

  @Override
  public boolean rests() {
    return resting;
  }

  @Override
  public void onAwake(Runnable newOnAwake) {
    onAwake = newOnAwake;
  }

  /**
   * Gives the thread up, which doesn't come back from its turn: it gets the lowest priority, and
   * ends if it ever comes back.
   */
  public void abandon() {
    thread.setPriority(Thread.MIN_PRIORITY);
    stopping = true;
  }

  private void run() {
    try {
      work();
      farewell();
    } catch (RuntimeException | Error e) {
      LOG.error("{} ended by an error", thread.getName(), e);
      duty.fail("its thread ended by an error");
    } finally {
      duty.closeLinks();
      onEnd.run();
    }
  }

  private void work() {
    int failures = 0;
    while (!stopping && !duty.hasFailed()) {
      try {
        duty.turn(clock.getAsLong());
        failures = 0;
      } catch (RuntimeException | StackOverflowError e) {
        failures++;
        if (failures == 1) {
          LOG.error("{} failed; it goes on", thread.getName(), e);
        } else if (failures == MAX_FAILURES_IN_A_ROW) {
          duty.fail(String.format(Locale.ROOT, "%d turns in a row failed", failures));
        }
      }
      long napNs = duty.napNs(clock.getAsLong());
      if (napNs > 0) {
        nap(napNs);
      }
    }
  }

  private void nap(long napNs) {
    boolean rest = napNs >= REST_NS;
    resting = rest;
    LockSupport.parkNanos(this, napNs);
    if (rest) {
      resting = false;
      onAwake.run();
    }
  }

  private void farewell() {
    long nowNs = clock.getAsLong();
    long endNs = nowNs + TimeUnit.MILLISECONDS.toNanos(FAREWELL_MS);
    duty.close(nowNs);
    while (!duty.isDeserted() && nowNs - endNs < 0) {
      duty.turn(nowNs);
      LockSupport.parkNanos(this, FAREWELL_NAP_NS);
      nowNs = clock.getAsLong();
    }
  }
}
