package carom.server.threads;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Threads that share duties: those of the rooms, or the one of the lobby. A duty belongs to one
 * thread at a time, for one turn. {@link TurnSchedule} says which thread has which turn.
 *
 * <p>A duty alternates turns and naps until it is stopped or has failed, and then says farewell. An
 * exception that reaches this class is a bug. It is logged, and the duty goes on, unless {@value
 * #MAX_FAILURES_IN_A_ROW} turns in a row fail. An error ends the duty and never its thread.
 *
 * <p>The pool has a thread for each duty until it has as many as it may. A {@link Watchdog} finds
 * turns that last: after half a second another thread takes the place of the one that has such a
 * turn. If it comes back, it ends and its duty goes on; if it never does, the duty's {@link
 * HangListener} hears of it. Any thread may call every method.
 */
public final class DutyPool implements AutoCloseable {
  /** Longest farewell, ms. Links stay open for so long that the last message arrives. */
  public static final long FAREWELL_MS = 400;

  private static final Logger LOG = LoggerFactory.getLogger(DutyPool.class);
  private static final long FAREWELL_NAP_NS = TimeUnit.MILLISECONDS.toNanos(4);
  private static final int MAX_FAILURES_IN_A_ROW = 100;

  /**
   * Nap after which a thread must say that it is awake, ns: a {@link Watchdog} looks at it again.
   */
  private static final long REST_NS = TimeUnit.MILLISECONDS.toNanos(100);

  /** Hears of a duty that is abandoned because a turn of it doesn't end. */
  @FunctionalInterface
  public interface HangListener {
    /**
     * Receives what hangs. The watchdog's thread.
     *
     * @param thread name of the thread, which has the lowest priority now
     * @param callback the method of the game that doesn't return, for people
     * @param stack of the thread
     */
    void hangs(String thread, String callback, ThreadStack stack);
  }

  private final String name;
  private final int size;
  private final int priority;
  private final LongSupplier clock;
  private final long originNs;
  private final Watchdog watchdog;

  /** The schedule, which is also the lock of all fields below. */
  private final TurnSchedule schedule = new TurnSchedule();

  private final List<PoolThread> threads = new ArrayList<>();
  private int threadsMade;
  private boolean closed;

  /**
   * Creates a pool that has no thread yet.
   *
   * @param name of its threads, which a number follows; of the one thread if size is 1
   * @param size the most threads that it has at once, without those that don't come back
   * @param priority of the threads
   * @param clock monotonic nanoseconds
   * @param watchdog looks at the threads; null for none
   */
  public DutyPool(String name, int size, int priority, LongSupplier clock, Watchdog watchdog) {
    this.name = name;
    this.size = size;
    this.priority = priority;
    this.clock = clock;
    this.watchdog = watchdog;
    originNs = clock.getAsLong();
  }

  /**
   * Begins a duty.
   *
   * @param title what it is, for logs
   * @param afterNs time until its first turn, ns
   * @param onHang hears if a turn never ends; then nobody runs the duty any more
   * @param onEnd called as the last act for the duty, however it ends, on a thread of the pool
   */
  public Shift add(
      String title, Duty duty, long afterNs, HangListener onHang, Consumer<Shift> onEnd) {
    Shift shift = new Shift(title, duty, onHang, onEnd);
    PoolThread started = null;
    PoolThread looks;
    synchronized (schedule) {
      if (closed) {
        throw new IllegalStateException("the pool is closed");
      }
      long nowNs = nowNs();
      if (threads.size() < size) {
        started = new PoolThread(schedule.addLine(nowNs));
      }
      looks = threadOf(schedule.add(shift, nowNs + afterNs, nowNs));
    }
    if (started != null) {
      started.begin();
    }
    wake(looks);
    return shift;
  }

  private long nowNs() {
    return clock.getAsLong() - originNs;
  }

  /** Returns the thread of a line, or null. Under the lock. */
  private PoolThread threadOf(TurnSchedule.Line line) {
    if (line != null) {
      for (int i = 0; i < threads.size(); i++) {
        if (threads.get(i).line == line) {
          return threads.get(i);
        }
      }
    }
    return null;
  }

  private static void wake(PoolThread thread) {
    if (thread != null && thread.thread != Thread.currentThread()) {
      LockSupport.unpark(thread.thread);
    }
  }

  /** Ends the threads, after the turns that they have. Duties that haven't ended have no more. */
  @Override
  public void close() {
    List<PoolThread> all;
    synchronized (schedule) {
      closed = true;
      all = List.copyOf(threads);
    }
    all.forEach(DutyPool::wake);
  }

  /** A duty in this pool, from its first turn to its last. */
  public final class Shift extends TurnSchedule.Item {
    private final String title;
    private final Duty duty;
    private final HangListener onHang;
    private final Consumer<Shift> onEnd;
    private final CountDownLatch ended = new CountDownLatch(1);
    private volatile boolean stopping;

    /** Guarded by the lock. */
    private boolean abandoned;

    // Those of the thread that has the turn.
    private int failures;
    private boolean leaving;
    private boolean over;
    private long farewellEndNs;

    private Shift(String title, Duty duty, HangListener onHang, Consumer<Shift> onEnd) {
      this.title = title;
      this.duty = duty;
      this.onHang = onHang;
      this.onEnd = onEnd;
    }

    /** Gives the duty a turn soon. Any thread. */
    public void wake() {
      PoolThread looks;
      synchronized (schedule) {
        if (abandoned || ended.getCount() == 0) {
          return;
        }
        looks = threadOf(schedule.wake(this, nowNs()));
      }
      DutyPool.wake(looks);
    }

    /** Asks the duty to say farewell and doesn't wait. Any thread. */
    public void stop() {
      stopping = true;
      wake();
    }

    /** Waits until the duty has ended, or until {@code endNs} in {@link System#nanoTime}. */
    public void join(long endNs) {
      boolean inTime = false;
      try {
        inTime = ended.await(Math.max(1, endNs - System.nanoTime()), TimeUnit.NANOSECONDS);
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
      if (!inTime) {
        LOG.warn("{} did not end in time", title);
      }
    }

    /** Does a turn, whatever it throws. */
    private void turn() {
      try {
        if (!leaving && !stopping) {
          work();
        }
        if (!leaving && (stopping || duty.hasFailed())) {
          leave();
        }
        long nowNs = clock.getAsLong();
        over = leaving && (duty.isDeserted() || nowNs - farewellEndNs >= 0);
        if (leaving && !over) {
          duty.turn(nowNs);
        }
      } catch (RuntimeException | Error e) {
        over = true;
        report(e);
      }
    }

    private void work() {
      try {
        duty.turn(clock.getAsLong());
        failures = 0;
      } catch (RuntimeException | StackOverflowError e) {
        failures++;
        if (failures == 1) {
          LOG.error("{} failed; it goes on", title, e);
        } else if (failures == MAX_FAILURES_IN_A_ROW) {
          duty.fail(String.format(Locale.ROOT, "%d turns in a row failed", failures));
        }
      }
    }

    private void leave() {
      leaving = true;
      long nowNs = clock.getAsLong();
      farewellEndNs = nowNs + TimeUnit.MILLISECONDS.toNanos(FAREWELL_MS);
      duty.close(nowNs);
    }

    private void report(Throwable e) {
      try {
        LOG.error("{} ended by an error", title, e);
        duty.fail("an error ended it");
      } catch (RuntimeException | Error again) {
        return; // too little memory even for that: its links are closed all the same
      }
    }

    private long napNs() {
      return leaving ? FAREWELL_NAP_NS : duty.napNs(clock.getAsLong());
    }

    private void end() {
      try {
        duty.closeLinks();
        onEnd.accept(this);
      } catch (RuntimeException | Error e) {
        report(e);
      } finally {
        ended.countDown();
      }
    }
  }

  /** A thread, until another one takes its place. It is no daemon, so it keeps the JVM alive. */
  private final class PoolThread implements WatchedThread, Watchdog.Watched {
    private final TurnSchedule.Line line;
    private final Thread thread;
    private volatile boolean resting;
    private volatile Runnable onAwake = () -> {};

    /** The duty whose turn it has, or null. Written under the lock. */
    private volatile Shift present;

    /** Changes with each turn and nap. Written under the lock. */
    private volatile int turns;

    // What the watchdog saw last.
    private int seenTurns;
    private Shift seen;

    /** Tells whether another thread has its place. Guarded by the lock. */
    private boolean replaced;

    PoolThread(TurnSchedule.Line line) {
      this.line = line;
      String number = size == 1 && threadsMade == 0 ? "" : "-" + (threadsMade + 1);
      threadsMade++;
      thread = new Thread(this::live, name + number);
      thread.setPriority(priority);
      threads.add(this);
    }

    void begin() {
      if (watchdog != null) {
        watchdog.watch(this, this);
      }
      thread.start();
    }

    private void live() {
      boolean lasts = true;
      while (lasts) {
        try {
          lasts = next();
        } catch (RuntimeException | Error e) {
          LOG.error("{} failed; it goes on", thread.getName(), e);
        }
      }
      resting = true; // for good
    }

    /** Takes a turn or a nap. Returns whether there is another one. */
    private boolean next() {
      Shift shift;
      long napNs = 0;
      PoolThread guard = null;
      synchronized (schedule) {
        if (replaced || closed) {
          threads.remove(this);
          return false;
        }
        long nowNs = nowNs();
        shift = (Shift) schedule.take(line, nowNs);
        present = shift;
        if (shift == null) {
          napNs = schedule.nap(line, nowNs);
        } else {
          guard = threadOf(schedule.guard(nowNs));
        }
        turns++;
      }
      if (shift == null) {
        nap(napNs);
      } else {
        wake(guard);
        run(shift);
      }
      return true;
    }

    private void run(Shift shift) {
      long napNs = 0;
      boolean hasLinks = false;
      try {
        shift.turn();
        if (!shift.over) {
          napNs = shift.napNs();
          hasLinks = !shift.leaving && shift.duty.hasLinks();
        }
      } catch (RuntimeException | Error e) {
        shift.over = true;
        shift.report(e);
      } finally {
        if (shift.over) {
          shift.end();
        }
        putBack(shift, napNs, hasLinks);
      }
    }

    private void putBack(Shift shift, long napNs, boolean hasLinks) {
      PoolThread looks = null;
      boolean abandoned;
      synchronized (schedule) {
        present = null;
        abandoned = shift.abandoned;
        if (shift.over || abandoned) {
          schedule.endTurn(shift);
        } else {
          looks = threadOf(schedule.put(shift, napNs, hasLinks, nowNs()));
        }
      }
      wake(looks);
      if (abandoned && !shift.over) {
        shift.end();
      }
    }

    private void nap(long napNs) {
      boolean rest = napNs >= REST_NS;
      resting = rest;
      if (napNs == TurnSchedule.NEVER) {
        LockSupport.park(this);
      } else if (napNs > 0) {
        LockSupport.parkNanos(this, napNs);
      }
      if (rest) {
        resting = false;
        onAwake.run();
      }
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

    @Override
    public int progress() {
      seenTurns = turns;
      seen = present;
      return 31 * seenTurns + (seen == null ? 0 : seen.duty.progress());
    }

    /** Returns whether it still has the turn that the watchdog saw. Under the lock. */
    private boolean hasSeenTurn() {
      return seen != null && seen == present && seenTurns == turns;
    }

    /** Gives its place to another thread. Under the lock. */
    private PoolThread replace() {
      if (replaced || closed) {
        return null;
      }
      replaced = true;
      threads.remove(this);
      schedule.replace(line, nowNs());
      return new PoolThread(line);
    }

    @Override
    public void lasts() {
      PoolThread started = null;
      synchronized (schedule) {
        if (hasSeenTurn()) {
          started = replace();
        }
      }
      if (started != null) {
        started.begin();
      }
    }

    @Override
    public void hangs(String callback, ThreadStack stack) {
      boolean hangs;
      PoolThread started = null;
      synchronized (schedule) {
        hangs = hasSeenTurn();
        if (hangs) {
          started = replace();
          seen.abandoned = true;
        }
      }
      if (started != null) {
        started.begin();
      }
      if (!hangs) {
        watchdog.watch(this, this); // it has come back in this moment
        return;
      }
      thread.setPriority(Thread.MIN_PRIORITY);
      seen.onHang.hangs(thread.getName(), callback, stack);
      seen.ended.countDown();
    }
  }
}
