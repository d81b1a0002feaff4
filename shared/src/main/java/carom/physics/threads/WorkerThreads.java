package carom.physics.threads;

import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLongArray;
import java.util.concurrent.locks.LockSupport;

/**
 * {@link Workers} made of threads of its own. May be shared by worlds that are stepped by different
 * threads: a run that finds the threads busy with another world's is carried out by its caller
 * alone.
 *
 * <p><b>How.</b> A run is published as one number, its round and how many tasks it has. Each task
 * has a claim, the last round in which someone took it; who raises it to the current round does the
 * task. A worker begins with its own share of the tasks, the same in every run of that size, so
 * that memory stays in its core's cache, and then helps the others from their ends. The caller
 * never waits for a thread that the operating system doesn't let run, unless that thread has begun
 * a task.
 *
 * <p>A thread without work spins for some 100 microseconds and then parks; within a step that was
 * announced for some 2 ms, since it takes tens of microseconds to wake and a step has serial parts
 * longer than that. Between steps it costs nothing.
 */
public final class WorkerThreads implements Workers, AutoCloseable {
  /** Most threads, the caller included. */
  public static final int MAX_COUNT = 64;

  /** Most tasks that are spread; runs with more are cut up by their callers into bundles. */
  private static final int MAX_SPREAD = 1024;

  /** How often an idle thread looks for work, and a caller for the end, before it lets go. */
  private static final int SPINS = 2000;

  /** And within a step. */
  private static final int SPINS_IN_STEP = 40_000;

  /**
   * A caller that sleeps longer than this over the last tasks waits for a thread that lost its
   * processor: there are fewer than threads that want one. Who spins then is the first to lose it,
   * in the midst of a task; steps took up to twice as long. So for some steps nobody does.
   */
  private static final long HELD_UP_NS = 1_000_000;

  private static final int CROWDED_STEPS = 100;

  /** Claims are that many longs apart: a cache line each. */
  private static final int APART = 8;

  private static final int TASKS_BITS = 16;

  private final int count;
  private final Thread[] threads;
  private final AtomicBoolean[] parked;
  private final AtomicLongArray claims = new AtomicLongArray((MAX_SPREAD + 1) * APART);

  /** Whether a caller uses the threads now. */
  private final AtomicBoolean taken = new AtomicBoolean();

  /** Tasks of the round that nobody has reported as done. */
  private final AtomicInteger left = new AtomicInteger();

  /** What a task threw first. */
  private volatile Throwable failure;

  /**
   * The round, and below it the number of its tasks. Tells the workers that {@link #work} is set.
   */
  private volatile long published;

  /** Whether a step that makes runs is on. */
  private volatile boolean inStep;

  private volatile boolean closed;

  /** For how many steps threads aren't kept spinning; written by whoever steps. */
  private volatile int crowdedSteps;

  /** Who waits for the end of the round, null if nobody sleeps over it. */
  private volatile Thread waiting;

  private Task work;

  /** Tasks of the run, and how many of them make one of the round. */
  private int tasks;

  private int bundle;

  /**
   * Starts {@code count - 1} threads, daemons named {@code carom-worker-1} and so on.
   *
   * @param count how many threads carry out tasks, the caller of {@link #run} included; 1 to
   *     {@value #MAX_COUNT}. More than the machine has processors make everything slower
   * @throws IllegalArgumentException if it is out of range
   */
  public WorkerThreads(int count) {
    if (count < 1 || count > MAX_COUNT) {
      throw new IllegalArgumentException(
          "count="
              + count
              + " is outside 1.."
              + MAX_COUNT
              + "; it is the number of threads, the caller included");
    }
    this.count = count;
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
    if (tasks < 2 || count == 1 || closed || !taken.compareAndSet(false, true)) {
      for (int i = 0; i < tasks; i++) {
        task.run(i, 0);
      }
      return;
    }
    try {
      spread(tasks, task);
    } finally {
      taken.set(false);
    }
  }

  private void spread(int all, Task task) {
    work = task;
    tasks = all;
    bundle = (all + MAX_SPREAD - 1) / MAX_SPREAD;
    int bundles = (all + bundle - 1) / bundle;
    left.set(bundles);
    long round = (published >> TASKS_BITS) + 1;
    published = round << TASKS_BITS | bundles;
    wake();
    help(0, round, bundles);
    awaitOthers();
    work = null;
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

  /** {@inheritDoc} Of several worlds that share the threads, the last one to call decides. */
  @Override
  public void stepBegins() {
    int crowded = crowdedSteps;
    if (crowded > 0) {
      crowdedSteps = crowded - 1;
      return;
    }
    inStep = true;
    wake();
  }

  @Override
  public void stepEnds() {
    inStep = false;
  }

  private void awaitOthers() {
    for (int i = 0; left.get() != 0; i++) {
      if (i < SPINS) {
        Thread.onSpinWait();
      } else {
        waiting = Thread.currentThread();
        if (left.get() != 0) {
          LockSupport.parkNanos(this, HELD_UP_NS);
        }
        waiting = null;
        if (left.get() != 0) {
          crowdedSteps = CROWDED_STEPS;
        }
      }
    }
  }

  /**
   * Takes tasks of the round until none is free: its own first, then those of the others. A thread
   * that comes too late finds every claim of its round raised, to that or a later one, and so never
   * looks at what has changed since.
   */
  private void help(int worker, long round, int bundles) {
    int done = 0;
    for (int k = 0; k < count; k++) {
      int owner = (worker + k) % count;
      int from = bundles * owner / count;
      int to = bundles * (owner + 1) / count;
      for (int i = 0; i < to - from; i++) {
        int b = k == 0 ? from + i : to - 1 - i;
        long seen = claims.get(b * APART);
        if (seen < round && claims.compareAndSet(b * APART, seen, round)) {
          carryOut(b, worker);
          done++;
        }
      }
    }
    if (done > 0 && left.addAndGet(-done) == 0) {
      Thread caller = waiting;
      if (caller != null) {
        LockSupport.unpark(caller);
      }
    }
  }

  private void carryOut(int bundleIndex, int worker) {
    int end = Math.min(tasks, (bundleIndex + 1) * bundle);
    try {
      for (int i = bundleIndex * bundle; i < end; i++) {
        work.run(i, worker);
      }
    } catch (RuntimeException | Error e) {
      failure = e;
    }
  }

  private void live(int worker) {
    AtomicBoolean asleep = parked[worker - 1];
    long seen = 0;
    int idle = 0;
    while (!closed) {
      long now = published;
      if (now != seen) {
        seen = now;
        idle = 0;
        help(worker, now >> TASKS_BITS, (int) (now & (1 << TASKS_BITS) - 1));
      } else if (idle < (inStep ? SPINS_IN_STEP : SPINS)) {
        idle++;
        Thread.onSpinWait();
      } else {
        asleep.set(true);
        if (published == seen && !closed) {
          LockSupport.park(this);
        }
        asleep.set(false);
        idle = 0;
      }
    }
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
