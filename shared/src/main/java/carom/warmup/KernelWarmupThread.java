package carom.warmup;

import carom.physics.simd.VectorKernels;
import carom.physics.simd.VectorModule;
import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;

/**
 * Warms vector kernels up on a thread of its own. Until they are compiled, all worlds of the JVM
 * step without them: a world's first seconds then neither wait for interpreted kernels nor allocate
 * the objects that these make. The bits are the same.
 *
 * <pre>
 *   prepare()           begin()                                              all sets trusted
 *      |                   | kernels one by one, | a world that needs them,     |
 *      |                   | until they allocate | until its steps allocate     |
 *      |                   | nothing             | nothing                      |
 *   worlds: scalar ---------------------------------------------------------> vectors
 * </pre>
 *
 * <p>What is compiled allocates nothing; that is how the thread sees that the JIT compiler is done.
 * First come the kernels alone, because a caller that is compiled before them takes so many of them
 * in that the compiler gives up within, and boxes vectors for good. Then come their callers. The
 * thread is a daemon of the lowest priority, works at most half of the time, and ends after a few
 * seconds. {@code docs/lab/kernels.md} has the measurements.
 */
public final class KernelWarmupThread {
  /** Longest time of work before a pause of the same length, ns. */
  private static final long BURST_NS = 2_000_000;

  /** Calls of a set between two looks at the clock. */
  private static final int CALLS = 4;

  /** Most calls of a burst: a set that is compiled needs no more. */
  private static final int MOST_CALLS = 512;

  /** Bursts without allocation after which a set is compiled. */
  private static final int STILL_BURSTS = 4;

  /** Bursts after which the thread no longer waits for the compiler. */
  private static final int MOST_BURSTS = 4_000;

  /** Steps without allocation, in a row, after which the callers are compiled. */
  private static final int STILL_STEPS = 40;

  /** Steps after which the thread no longer waits for the compiler. */
  private static final int MOST_STEPS = 3_000;

  private final ThreadMXBean threads;
  private final Thread thread = new Thread(this::run, "carom-warm-up");
  private final List<VectorKernels> sets = new CopyOnWriteArrayList<>();
  private volatile boolean ended;

  /** A set and how many bursts it has not allocated. */
  private static final class Waiting {
    private final VectorKernels set;
    private int still;

    Waiting(VectorKernels set) {
      this.set = set;
    }
  }

  private KernelWarmupThread(ThreadMXBean threads) {
    this.threads = threads;
    thread.setDaemon(true);
    thread.setPriority(Thread.MIN_PRIORITY);
  }

  /**
   * Keeps all worlds of this JVM from vector kernels until the warm-up that {@link #begin} starts
   * has ended. On a JVM that can't tell what a thread allocates, worlds go on to warm kernels up
   * themselves.
   *
   * @return what to begin when the program has time for it
   */
  public static KernelWarmupThread prepare() {
    boolean counts =
        ManagementFactory.getThreadMXBean() instanceof ThreadMXBean some
            && some.isThreadAllocatedMemorySupported()
            && some.isThreadAllocatedMemoryEnabled();
    KernelWarmupThread warmup =
        new KernelWarmupThread(counts ? (ThreadMXBean) ManagementFactory.getThreadMXBean() : null);
    if (counts) {
      Thread own = warmup.thread;
      VectorModule.leaveWarmUpTo(warmup::note, () -> Thread.currentThread() == own);
    }
    return warmup;
  }

  private void note(VectorKernels set) {
    sets.add(set);
    if (ended) {
      set.trust(); // found too late
    }
  }

  /** Starts the thread. Call it once. */
  public void begin() {
    if (threads != null) {
      thread.start();
    }
  }

  /**
   * Waits for the end of the warm-up.
   *
   * @param ms how long at most
   * @return whether it has ended
   * @throws InterruptedException if the calling thread is interrupted
   */
  public boolean await(long ms) throws InterruptedException {
    thread.join(ms);
    return !thread.isAlive();
  }

  private void run() {
    try {
      Rehearsal rehearsal = new Rehearsal(); // its first step finds all sets
      if (!sets.isEmpty()) {
        compileKernels();
        compileCallers(rehearsal);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } finally {
      ended = true;
      sets.forEach(VectorKernels::trust);
    }
  }

  /** Calls the kernels of all sets, by turns, until they allocate nothing. */
  private void compileKernels() throws InterruptedException {
    List<Waiting> waiting = new ArrayList<>();
    sets.forEach(set -> waiting.add(new Waiting(set)));
    for (int i = 0; i < MOST_BURSTS && !waiting.isEmpty(); i++) {
      Waiting next = waiting.get(i % waiting.size());
      long bytes = threads.getThreadAllocatedBytes(thread.getId());
      long begin = System.nanoTime();
      for (int n = 0; n < MOST_CALLS && System.nanoTime() - begin < BURST_NS; n += CALLS) {
        next.set.rehearse(CALLS);
      }
      boolean allocated = threads.getThreadAllocatedBytes(thread.getId()) != bytes;
      next.still = allocated ? 0 : next.still + 1;
      if (next.still == STILL_BURSTS) {
        waiting.remove(next);
      }
      pause(System.nanoTime() - begin);
    }
  }

  /** Steps a world that needs the kernels until it allocates nothing. */
  private void compileCallers(Rehearsal rehearsal) throws InterruptedException {
    int still = 0;
    for (int i = 0; i < MOST_STEPS && still < STILL_STEPS; i++) {
      boolean anew = rehearsal.isAtEnd();
      long bytes = threads.getThreadAllocatedBytes(thread.getId());
      long begin = System.nanoTime();
      rehearsal.step();
      boolean allocated = threads.getThreadAllocatedBytes(thread.getId()) != bytes;
      still = anew || allocated ? 0 : still + 1;
      pause(System.nanoTime() - begin);
    }
  }

  private static void pause(long ns) throws InterruptedException {
    Thread.sleep(ns / 1_000_000, (int) (ns % 1_000_000));
  }
}
