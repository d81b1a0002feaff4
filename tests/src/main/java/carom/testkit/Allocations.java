package carom.testkit;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;

/** What the calling thread allocates. */
public final class Allocations {
  /** A tumbler boxed vectors for 14,000 steps while its kernels waited for the compiler. */
  private static final int MOST_RUNS = 600;

  /** From this run on each waits a little, as a busy machine may compile nothing meanwhile. */
  private static final int PATIENT = 20;

  private static final long WAIT_MS = 50;

  private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

  private Allocations() {}

  /**
   * Returns the fewest bytes that one of several runs allocates: in the others the JVM may allocate
   * something of its own.
   *
   * @param runs how often the work runs, at least 1
   */
  public static long least(int runs, Runnable work) {
    long least = Long.MAX_VALUE;
    for (int run = 0; run < runs; run++) {
      long before = THREADS.getCurrentThreadAllocatedBytes();
      work.run();
      least = Math.min(least, THREADS.getCurrentThreadAllocatedBytes() - before);
    }
    return least;
  }

  /**
   * Returns the fewest bytes that one of many runs allocates, or the first number that is small
   * enough. Interpreted vector kernels make an object of every vector until the JIT compiler is
   * done with them. How long that takes depends on the machine, so a run that isn't clean only
   * means that another follows.
   *
   * @param enough bytes below which no other run follows
   * @param work tens of steps
   */
  public static long leastOnceCompiled(long enough, Runnable work) throws InterruptedException {
    long least = Long.MAX_VALUE;
    for (int run = 0; run < MOST_RUNS && least >= enough; run++) {
      if (run > PATIENT) {
        Thread.sleep(WAIT_MS);
      }
      least = Math.min(least, least(1, work));
    }
    return least;
  }
}
