package carom.lab.measure;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.Arrays;

/**
 * Times pieces of work one by one: CPU time of the calling thread, clock time and bytes allocated.
 */
public final class Stopwatch {
  private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

  private final boolean byClock;
  private final double[] cpu;
  private final double[] wall;
  private int count;
  private double spent;
  private long othersBegin;
  private long bytes;
  private long bytesBegin;
  private long cpuBegin;
  private long wallBegin;

  /**
   * Creates a stopwatch that has measured nothing.
   *
   * @param most most pieces that it can time
   * @param byClock whether several threads work. Then clock time replaces the calling thread's CPU
   *     time, and the other threads' allocations count, also those between the pieces
   */
  public Stopwatch(int most, boolean byClock) {
    this.byClock = byClock;
    cpu = new double[most];
    wall = new double[most];
    othersBegin = byOthers();
  }

  /** Returns the CPU time of the calling thread since its start, s. */
  public static double cpuSeconds() {
    return THREADS.getCurrentThreadCpuTime() * 1e-9;
  }

  /** Begins a piece of work. */
  public void begin() {
    bytesBegin = THREADS.getCurrentThreadAllocatedBytes();
    wallBegin = System.nanoTime();
    cpuBegin = THREADS.getCurrentThreadCpuTime();
  }

  /** Ends the piece of work. */
  public void end() {
    cpu[count] = (THREADS.getCurrentThreadCpuTime() - cpuBegin) * 1e-9;
    wall[count] = (System.nanoTime() - wallBegin) * 1e-9;
    bytes += THREADS.getCurrentThreadAllocatedBytes() - bytesBegin;
    spent += seconds()[count++];
  }

  /** Runs work between two pieces without measuring it. */
  public void leaveOut(Runnable work) {
    long before = byOthers();
    work.run();
    othersBegin += byOthers() - before;
  }

  private double[] seconds() {
    return byClock ? wall : cpu;
  }

  /** Returns the number of pieces timed. */
  public int count() {
    return count;
  }

  /** Returns the time of all pieces together, s. */
  public double spent() {
    return spent;
  }

  /** Returns the most pieces that this stopwatch can time. */
  public int most() {
    return cpu.length;
  }

  /** Returns the clock times of the pieces from one on, ms. */
  public double[] wallMs(int from) {
    return Arrays.stream(wall, from, count).map(seconds -> seconds * 1e3).toArray();
  }

  /** Returns whether the stopwatch can time no more pieces. */
  public boolean isFull() {
    return count == cpu.length;
  }

  /**
   * Returns the result. Call it once, because it sorts the times, and before the other threads end,
   * whose allocations it counts.
   */
  public Times times() {
    long allocated = byClock ? bytes + byOthers() - othersBegin : bytes;
    return Times.of(seconds().clone(), wall, count, allocated);
  }

  /** Returns the bytes that threads other than the calling one have allocated. */
  private static long byOthers() {
    long me = Thread.currentThread().getId();
    long[] ids = THREADS.getAllThreadIds();
    long[] allocated = THREADS.getThreadAllocatedBytes(ids);
    long sum = 0;
    for (int i = 0; i < ids.length; i++) {
      sum += ids[i] == me ? 0 : Math.max(allocated[i], 0); // -1 for one that has ended since
    }
    return sum;
  }
}
