package carom.lab.measure;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.Arrays;

/**
 * Times pieces of work one by one: CPU time of the calling thread, the clock, and what is
 * allocated.
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
   * Makes one that has measured nothing.
   *
   * @param most pieces it can time
   * @param byClock whether several threads work: the clock counts instead of the CPU time of the
   *     calling one, and what the others allocate, also between the pieces
   */
  public Stopwatch(int most, boolean byClock) {
    this.byClock = byClock;
    cpu = new double[most];
    wall = new double[most];
    othersBegin = byOthers();
  }

  /** CPU time of the calling thread since it began, s. */
  public static double cpuSeconds() {
    return THREADS.getCurrentThreadCpuTime() * 1e-9;
  }

  /** Begins a piece of work. */
  public void begin() {
    bytesBegin = THREADS.getCurrentThreadAllocatedBytes();
    wallBegin = System.nanoTime();
    cpuBegin = THREADS.getCurrentThreadCpuTime();
  }

  /** Ends it. */
  public void end() {
    cpu[count] = (THREADS.getCurrentThreadCpuTime() - cpuBegin) * 1e-9;
    wall[count] = (System.nanoTime() - wallBegin) * 1e-9;
    bytes += THREADS.getCurrentThreadAllocatedBytes() - bytesBegin;
    spent += seconds()[count++];
  }

  /** Does something between two pieces that isn't part of what is measured. */
  public void leaveOut(Runnable work) {
    long before = byOthers();
    work.run();
    othersBegin += byOthers() - before;
  }

  private double[] seconds() {
    return byClock ? wall : cpu;
  }

  /** Returns how many pieces were timed. */
  public int count() {
    return count;
  }

  /** Returns how long they took together, s. */
  public double spent() {
    return spent;
  }

  /** Returns how many it can time. */
  public int most() {
    return cpu.length;
  }

  /** Returns what the pieces from one on took by the clock, ms. */
  public double[] wallMs(int from) {
    return Arrays.stream(wall, from, count).map(seconds -> seconds * 1e3).toArray();
  }

  /** Returns whether it can time no more. */
  public boolean isFull() {
    return count == cpu.length;
  }

  /**
   * Returns the result; times are sorted by it, so ask once, and before threads end that were left
   * out.
   */
  public Times times() {
    long allocated = byClock ? bytes + byOthers() - othersBegin : bytes;
    return Times.of(seconds().clone(), wall, count, allocated);
  }

  /** Returns what threads other than the calling one have allocated. */
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
