package carom.server.threads;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.locks.LockSupport;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Finds threads that don't come back from a game's code. It looks at each thread four times a
 * second, but not while all of them take long naps. A thread hangs if it is in the same call of the
 * same callback at each of seven looks, and has computed or waited meanwhile; a thread that the
 * machine gives no time is looked at for longer. A thread that builds matches hangs if it builds
 * the same one for ten seconds of looks, in any code.
 *
 * <p>It counts looks, not time: after a pause of the whole process, nothing hangs. Slow ticks
 * outside of a game's code aren't its business.
 */
public final class Watchdog implements AutoCloseable {
  /** Longest time until a thread that hangs is found, ms. */
  public static final int FOUND_MS = 2_000;

  /** Longest time until a thread that builds a match without end is found, ms. */
  public static final int LOAD_FOUND_MS = 10_000;

  private static final Logger LOG = LoggerFactory.getLogger(Watchdog.class);
  private static final int LOOK_MS = 250;

  /** Looks at which the callback must be the same, after the first that saw it. */
  private static final int LOOKS = FOUND_MS / LOOK_MS - 2;

  /** Looks as {@link #LOOKS} of a thread that builds a match. */
  private static final int LOAD_LOOKS = LOAD_FOUND_MS / LOOK_MS - 2;

  /**
   * Times as many looks for a thread that neither computes nor waits, such as one that reads from a
   * socket.
   */
  private static final int PATIENCE = 4;

  /** Share of the time that a thread must have had a processor to count as computing. */
  private static final int BUSY_PARTS = 10;

  /** The work of a thread. The watchdog's thread calls every method. */
  public interface Watched {
    /** Returns a number that changes whenever the work gets on. */
    int progress();

    /**
     * Hears at a look that nothing has got on since the look before, in whatever code. Mostly the
     * work is just long. Does nothing unless overridden.
     */
    default void lasts() {}

    /**
     * Receives a thread that hangs, and isn't watched any longer.
     *
     * @param callback the method of the game that doesn't return, for people; null for a thread
     *     that builds a match in other code
     * @param stack of the thread
     */
    void hangs(String callback, ThreadStack stack);
  }

  private static final class Watch {
    private final WatchedThread thread;
    private final Watched watched;
    private final boolean builds;
    private int progress;

    /** The work of the thread that must end, or null. */
    private String work;

    private int looks;
    private long cpuNs;

    Watch(WatchedThread thread, Watched watched, boolean builds) {
      this.thread = thread;
      this.watched = watched;
      this.builds = builds;
    }
  }

  private final String guard;
  private final List<Watch> watches = new CopyOnWriteArrayList<>();
  private final Thread thread = new Thread(this::run, "carom-watchdog");
  private volatile boolean closed;

  /**
   * Creates a watchdog that watches nothing and doesn't run yet.
   *
   * @param guard the class through which all calls of games go
   */
  public Watchdog(Class<?> guard) {
    this.guard = guard.getName();
    thread.setDaemon(true);
  }

  /** Watches a thread that runs games from now on, until it ends; any thread. */
  void watch(WatchedThread games, Watched watched) {
    add(new Watch(games, watched, false));
  }

  /** Watches a thread that builds matches from now on, and rests between them; any thread. */
  void watchLoads(WatchedThread loads, Watched watched) {
    add(new Watch(loads, watched, true));
  }

  private void add(Watch watch) {
    watch.thread.onAwake(() -> LockSupport.unpark(thread));
    watches.add(watch);
    LockSupport.unpark(thread);
  }

  /** Begins to look. */
  public void start() {
    thread.start();
  }

  private void run() {
    while (!closed) {
      if (watches.stream().allMatch(watch -> watch.thread.rests())) {
        LockSupport.park(this);
      }
      try {
        Thread.sleep(LOOK_MS);
      } catch (InterruptedException e) {
        return;
      }
      for (Watch watch : watches) {
        try {
          look(watch);
        } catch (RuntimeException | Error e) {
          LOG.error("the watchdog failed; it goes on", e);
        }
      }
    }
  }

  private void look(Watch w) {
    int progress = w.watched.progress();
    if (progress != w.progress || w.thread.rests()) {
      w.progress = progress;
      w.work = null;
      return;
    }
    Thread watched = w.thread.thread();
    if (watched.getState() == Thread.State.TERMINATED) {
      watches.remove(w);
      return;
    }
    w.watched.lasts();
    StackTraceElement[] stack = watched.getStackTrace();
    String callback = callback(stack);
    String work = w.builds ? "a match" : callback;
    if (work == null || !work.equals(w.work)) {
      w.work = work;
      w.looks = 0;
      w.cpuNs = cpuNs(watched);
      return;
    }
    w.looks++;
    long neededNs = LOOK_MS * 1_000_000L * w.looks / BUSY_PARTS;
    boolean clear = waits(watched) || cpuNs(watched) - w.cpuNs >= neededNs;
    int looks = w.builds ? LOAD_LOOKS : LOOKS;
    if (w.looks >= (clear ? looks : PATIENCE * looks)) {
      watches.remove(w);
      w.watched.hangs(callback, new ThreadStack(watched.getName(), stack));
    }
  }

  private static boolean waits(Thread thread) {
    Thread.State state = thread.getState();
    return state != Thread.State.RUNNABLE && state != Thread.State.NEW;
  }

  /** Returns the time for which a thread has had a processor, ns; -1 if it can't be measured. */
  private static long cpuNs(Thread thread) {
    ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    return threads.isThreadCpuTimeSupported() ? threads.getThreadCpuTime(thread.getId()) : -1;
  }

  /** Returns where a thread hangs, for people, by what {@link Watched#hangs} received. */
  static String where(String callback) {
    return callback == null ? "code of no callback" : callback;
  }

  /** Returns the outermost call of a game in a stack, or null if there is none. */
  private String callback(StackTraceElement[] stack) {
    for (int i = stack.length - 1; i > 0; i--) {
      if (stack[i].getClassName().equals(guard)) {
        return stack[i].getMethodName() + " of " + calledBy(stack, i);
      }
    }
    return null;
  }

  /** Returns the class that the guard's frame at an index calls in the end. */
  private String calledBy(StackTraceElement[] stack, int index) {
    for (int i = index - 1; i >= 0; i--) {
      if (!stack[i].getClassName().startsWith(guard)) { // nor a lambda of it
        return stack[i].getClassName();
      }
    }
    return guard;
  }

  @Override
  public void close() {
    closed = true;
    thread.interrupt();
  }
}
