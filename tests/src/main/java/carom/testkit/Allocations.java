package carom.testkit;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;

/** What the calling thread allocates. */
public final class Allocations {
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
}
