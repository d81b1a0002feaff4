package carom.physics.threads;

import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLongArray;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.locks.LockSupport;
import java.util.function.LongSupplier;

/**
 * {@link Workers} made of threads of its own. May be shared by worlds that are stepped by different
 * threads. A world whose step was {@linkplain #stepBegins announced} has the threads until that
 * step ends, any other world for one run. A caller that finds them lent carries out its run alone.
 *
 * <p><b>How.</b> The tasks of a run are dealt out evenly, each worker's share as a range in one
 * atomic word; to take a task is to shorten the range. A worker begins at the front of its own
 * share, the same in every run of that size, so that memory stays in its core's cache, and then
 * helps the others from the ends of theirs. The caller never waits for a thread that the operating
 * system doesn't let run, unless that thread has begun a task.
 *
 * <p><b>Crowds.</b> Where fewer processors are free than there are threads, sharing costs more than
 * it gains. With a clock, announced steps are timed when a caller had to wait, and left to their
 * callers while that is faster.
 *
 * <p>A thread without work spins for some 100 microseconds and then parks; within a step that was
 * announced for some 2 ms, since it takes tens of microseconds to wake and a step has serial parts
 * longer than that. Between steps it costs nothing.
 */
public final class WorkerThreads implements Workers, AutoCloseable {
  /** Most threads, the caller included. */
  public static final int MAX_COUNT = 64;

  /** Looks of an idle thread for work, and of a caller for the end, before it lets go. */
  private static final int SPINS = 2000;

  /** Looks of an idle thread for work within an announced step. */
  private static final int SPINS_IN_STEP = 40_000;

  /** Longs from one share to the next: two cache lines, because processors fetch them in pairs. */
  private static final int APART = 16;

  private final int count;
  private final Thread[] threads;
  private final AtomicBoolean[] parked;

  /** Per worker: its first task that isn't taken, in the upper half; the end of its tasks below. */
  private final AtomicLongArray shares;

  /** Thread that has the workers: the caller of the run or of the announced step that is on. */
  private final AtomicReference<Thread> holder = new AtomicReference<>();

  /** Number of tasks of the run that aren't reported as done. */
  private final AtomicInteger left = new AtomicInteger();

  /** Tells whether a task waited for another one since a run began. */
  private volatile boolean waited;

  /** First exception or error of a task. */
  private volatile Throwable failure;

  /** Tells whether the holder has announced a step. */
  private volatile boolean inStep;

  private volatile boolean closed;

  private final LongSupplier clock;

  /** Those that step without {@link #forOneWorld}, one per thread. */
  private final ThreadLocal<Caller> callers = ThreadLocal.withInitial(Caller::new);

  /** Decides for the holder while its step is on; null if that step isn't shared. */
  private Sharing sharing;

  /** Thread that sleeps until the end of the run, null for none. */
  private volatile Thread waiting;

  /** Work of the run; read by threads that took one of its tasks. */
  private Task work;

  /**
   * Starts {@code count - 1} threads, daemons named {@code carom-worker-1} and so on.
   *
   * @param count how many threads carry out tasks, the caller of {@link #run} included; 1 to
   *     {@value #MAX_COUNT}. More than the machine has processors make everything slower
   * @throws IllegalArgumentException if it is out of range
   */
  public WorkerThreads(int count) {
    this(count, () -> 0);
  }

  /**
   * Starts {@code count - 1} threads, daemons named {@code carom-worker-1} and so on.
   *
   * @param count as in {@link #WorkerThreads(int)}
   * @param clock ns, for instance {@code System::nanoTime}; tells whether sharing pays. It shows in
   *     no result. Called by the threads that step, twice per run at most
   * @throws IllegalArgumentException if the count is out of range
   */
  public WorkerThreads(int count, LongSupplier clock) {
    if (count < 1 || count > MAX_COUNT) {
      throw new IllegalArgumentException(
          "count="
              + count
              + " is outside 1.."
              + MAX_COUNT
              + "; it is the number of threads, the caller included");
    }
    this.count = count;
    this.clock = clock;
    shares = new AtomicLongArray((count + 1) * APART);
    threads = new Thread[count - 1];
    parked = new AtomicBoolean[count - 1];
    for (int i = 0; i < threads.length; i++) {
      int worker = i + 1;
      parked[i] = new AtomicBoolean();
      threads[i] = new Thread(() -> live(worker), "carom-worker-" + worker);
      threads[i].setDaemon(true);
      threads[i].start();
    }
  }

  @Override
  public int count() {
    return count;
  }

  @Override
  public void run(int tasks, Task task) {
    callers.get().run(tasks, task);
  }

  /**
   * Returns these threads for one world, whose steps decide for themselves whether sharing pays. So
   * they do on whichever thread each of them runs, one at a time. Otherwise the steps of one thread
   * decide together.
   */
  public Workers forOneWorld() {
    return new Caller();
  }

  /** A caller whose steps follow each other. */
  private final class Caller implements Workers {
    private final Sharing mine = new Sharing();

    @Override
    public int count() {
      return count;
    }

    @Override
    public void run(int tasks, Task task) {
      if (tasks > 1 && count > 1 && !closed) {
        Thread caller = Thread.currentThread();
        if (holder.get() == caller) {
          spread(tasks, task);
          return;
        }
        if (!mine.isAlone() && holder.compareAndSet(null, caller)) {
          try {
            spread(tasks, task);
          } finally {
            holder.set(null);
          }
          return;
        }
      }
      for (int i = 0; i < tasks; i++) {
        task.run(i, 0);
      }
    }

    @Override
    public void stepBegins() {
      Thread caller = Thread.currentThread();
      if (holder.get() != caller && !holder.compareAndSet(null, caller)) {
        return;
      }
      boolean shared = mine.begins(clock.getAsLong());
      sharing = shared ? mine : null;
      inStep = shared;
      if (shared) {
        wake();
      } else {
        holder.set(null);
      }
    }

    @Override
    public void stepEnds() {
      mine.ends(clock.getAsLong());
      if (holder.get() == Thread.currentThread()) {
        sharing = null;
        inStep = false;
        holder.set(null);
      }
    }

    @Override
    public void waits() {
      waited = true;
    }
  }

  private void spread(int tasks, Task task) {
    work = task;
    left.set(tasks);
    for (int worker = count - 1; worker >= 0; worker--) {
      long from = (long) tasks * worker / count;
      long to = (long) tasks * (worker + 1) / count;
      shares.set((worker + 1) * APART, from << Integer.SIZE | to);
    }
    wake();
    help(0);
    awaitOthers();
    work = null;
    if (waited) {
      waited = false;
      if (sharing != null) {
        sharing.waited(Sharing.LONG_WAIT_NS + 1);
      }
    }
    Throwable thrown = failure;
    if (thrown != null) {
      failure = null;
      if (thrown instanceof Error error) {
        throw error;
      }
      throw (RuntimeException) thrown;
    }
  }

  private void wake() {
    for (int i = 0; i < threads.length; i++) {
      if (parked[i].get()) {
        LockSupport.unpark(threads[i]);
      }
    }
  }

  /**
   * {@inheritDoc} The threads are the caller's until {@link #stepEnds}, unless another's step has
   * them, or this one is better done alone.
   */
  @Override
  public void stepBegins() {
    callers.get().stepBegins();
  }

  @Override
  public void stepEnds() {
    callers.get().stepEnds();
  }

  private void awaitOthers() {
    if (left.get() == 0) {
      return;
    }
    long begin = clock.getAsLong();
    for (int i = 0; left.get() != 0 && i < SPINS; i++) {
      Thread.onSpinWait();
    }
    if (left.get() != 0) {
      waiting = Thread.currentThread();
      while (left.get() != 0) {
        LockSupport.park(this);
      }
      waiting = null;
    }
    if (sharing != null) {
      sharing.waited(clock.getAsLong() - begin);
    }
  }

  @Override
  public void waits() {
    waited = true;
  }

  /**
   * Takes tasks until none is free, its own first, then those of the others. Returns how many. What
   * it takes is of the run that is on, even if it came to help with the one before: a run can't end
   * while one of its tasks isn't reported.
   */
  private int help(int worker) {
    int done = 0;
    for (int k = 0; k < count; k++) {
      int at = ((worker + k) % count + 1) * APART;
      long share = shares.get(at);
      while (first(share) < end(share)) {
        int task = k == 0 ? first(share) : end(share) - 1;
        if (shares.compareAndSet(at, share, k == 0 ? share + (1L << Integer.SIZE) : share - 1)) {
          carryOut(task, worker);
          done++;
        }
        share = shares.get(at);
      }
    }
    if (done > 0 && left.addAndGet(-done) == 0) {
      Thread caller = waiting;
      if (caller != null) {
        LockSupport.unpark(caller);
      }
    }
    return done;
  }

  private static int first(long share) {
    return (int) (share >>> Integer.SIZE);
  }

  private static int end(long share) {
    return (int) share;
  }

  private void carryOut(int task, int worker) {
    try {
      work.run(task, worker);
    } catch (RuntimeException | Error e) {
      failure = e;
    }
  }

  private void live(int worker) {
    AtomicBoolean asleep = parked[worker - 1];
    int idle = 0;
    while (!closed) {
      if (hasWork(worker)) {
        help(worker);
        idle = 0;
      } else if (idle < (inStep ? SPINS_IN_STEP : SPINS)) {
        idle++;
        Thread.onSpinWait();
      } else {
        asleep.set(true);
        if (!hasWork(worker) && !closed) {
          LockSupport.park(this);
        }
        asleep.set(false);
        idle = 0;
      }
    }
  }

  private boolean hasWork(int worker) {
    long share = shares.get((worker + 1) * APART);
    return first(share) < end(share);
  }

  /**
   * Ends the threads. Worlds that have them go on, each on its caller alone. Must not be called by
   * a task.
   */
  @Override
  public void close() {
    closed = true;
    for (Thread thread : threads) {
      LockSupport.unpark(thread);
    }
  }
}
