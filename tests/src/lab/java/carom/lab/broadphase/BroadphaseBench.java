package carom.lab.broadphase;

import carom.lab.measure.Stopwatch;
import carom.physics.broadphase.BruteForce;
import carom.physics.broadphase.KdTree;
import carom.physics.broadphase.PairVisitor;
import carom.physics.broadphase.QuadTree;
import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.Locale;

/**
 * A small benchmark of broadphase structures alone: all boxes move, and the structure reports every
 * overlapping pair. {@link PairSearchJob} measures the engine's own search.
 *
 * <p>Times are CPU nanoseconds of the calling thread per box and tick, motion excluded. One row
 * takes about the seconds asked for.
 */
public final class BroadphaseBench {
  /** The structures and methods to measure. */
  public enum Method {
    /** The KD-tree, built anew every tick. */
    KD_REBUILD,
    /**
     * The KD-tree, refitted every tick: the class that the engine uses, on all boxes as they are.
     */
    KD_REFIT,
    /** The quadtree, built anew every tick. */
    QUAD_REBUILD,
    /** The comparison of every box with every other. */
    BRUTE_FORCE,
    /**
     * The {@link PairCache}, which keeps pairs while boxes stay within roomy ones, and which no
     * server or client uses.
     */
    LAB_PAIR_CACHE;

    @Override
    public String toString() {
      return name().toLowerCase(Locale.ROOT);
    }
  }

  /**
   * A row of results.
   *
   * @param method what was measured
   * @param boxes number of boxes
   * @param clustered whether the boxes were clustered
   * @param updateNs ns per box and tick to update the index (median)
   * @param pairsNs ns per box and tick to report all pairs (median)
   * @param sumNs ns per box and tick, update and pairs (median; of {@code LAB_PAIR_CACHE} the mean)
   * @param p99Ns the same, slower than 99 of 100 ticks
   * @param worstNs ns per box of the slowest tick, update and pairs
   * @param ticks number of ticks measured
   * @param allocatedBytes per tick
   * @param pairs number of pairs in the last tick
   * @param hash order-independent hash of the pairs of the first three ticks
   */
  public record Row(
      Method method,
      int boxes,
      boolean clustered,
      double updateNs,
      double pairsNs,
      double sumNs,
      double p99Ns,
      double worstNs,
      int ticks,
      double allocatedBytes,
      long pairs,
      long hash) {
    @Override
    public String toString() {
      return String.format(
          Locale.ROOT,
          "%-12s %-9s %7d  update %6.1f  pairs %6.1f  sum %6.1f  worst %6.1f ns/box  pairs/box %.3f"
              + "  hash %016x",
          method,
          clustered ? "clustered" : "uniform",
          boxes,
          updateNs,
          pairsNs,
          sumNs,
          worstNs,
          (double) pairs / boxes,
          hash);
    }
  }

  /** Counts pairs and hashes them independently of their order. */
  private static final class Tally implements PairVisitor {
    long count;
    long hash;

    @Override
    public void pair(int idA, int idB) {
      count++;
      hash += BroadphaseScene.mix(((long) idA << 32) + idB);
    }
  }

  private static final int SLICES = 12;

  /** Most ticks measured. The warm-up has no limit. */
  private static final int MOST_TICKS = 100_000;

  private BroadphaseBench() {}

  /**
   * Measures one method on one scene.
   *
   * @param method what to measure
   * @param n number of boxes
   * @param clustered whether the boxes cluster
   * @param seconds how long to measure after a warm-up of the same length
   * @param pause done before each twelfth of the measuring, untimed
   * @return the row
   */
  public static Row run(Method method, int n, boolean clustered, double seconds, Runnable pause) {
    return run(method, n, clustered, seconds, pause, MOST_TICKS);
  }

  static Row run(
      Method method, int n, boolean clustered, double seconds, Runnable pause, int most) {
    BroadphaseScene scene = new BroadphaseScene(n, clustered);
    KdTree kd = new KdTree(scene.boxes());
    QuadTree quad = new QuadTree();
    BruteForce brute = new BruteForce();
    PairCache cache = new PairCache();
    kd.rebuild(scene.boxes(), scene.ids(), n);
    if (method == Method.LAB_PAIR_CACHE) {
      cache.rebuild(scene.boxes(), scene.ids(), n);
    }
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    double[] update = new double[most];
    double[] pairs = new double[most];
    double[] sum = new double[most];
    long allocated = 0;
    long hash = 0;
    Tally tally = new Tally();
    double begin = Stopwatch.cpuSeconds();
    double warm = begin + seconds;
    double end = warm + seconds;
    double nextPause = warm;
    int rows = 0;
    for (int tick = 0; rows < most && (tick < 6 || Stopwatch.cpuSeconds() < end); tick++) {
      if (tick >= 3 && Stopwatch.cpuSeconds() >= nextPause) {
        pause.run();
        nextPause += seconds / SLICES;
      }
      scene.step();
      tally.count = 0;
      tally.hash = 0;
      long bytes = threads.getCurrentThreadAllocatedBytes();
      long t0 = threads.getCurrentThreadCpuTime();
      switch (method) {
        case KD_REBUILD -> kd.rebuild(scene.boxes(), scene.ids(), n);
        case KD_REFIT -> kd.refit();
        case LAB_PAIR_CACHE -> cache.refit();
        case QUAD_REBUILD -> quad.rebuild(scene.boxes(), scene.ids(), n);
        case BRUTE_FORCE -> brute.rebuild(scene.boxes(), scene.ids(), n);
      }
      long t1 = threads.getCurrentThreadCpuTime();
      switch (method) {
        case KD_REBUILD, KD_REFIT -> kd.pairs(tally);
        case LAB_PAIR_CACHE -> cache.pairs(tally);
        case QUAD_REBUILD -> quad.pairs(tally);
        case BRUTE_FORCE -> brute.pairs(tally);
      }
      long t2 = threads.getCurrentThreadCpuTime();
      hash += tick < 3 ? tally.hash : 0;
      if (tick >= 3 && Stopwatch.cpuSeconds() >= warm) {
        update[rows] = (double) (t1 - t0) / n;
        pairs[rows] = (double) (t2 - t1) / n;
        sum[rows] = update[rows] + pairs[rows];
        allocated += threads.getCurrentThreadAllocatedBytes() - bytes;
        rows++;
      }
    }
    // Most ticks of a cache are cheap and a few dear, so the median would flatter it.
    double mean = Arrays.stream(sum, 0, rows).average().orElse(0);
    Arrays.sort(sum, 0, rows);
    return new Row(
        method,
        n,
        clustered,
        median(update, rows),
        median(pairs, rows),
        method == Method.LAB_PAIR_CACHE ? mean : sum[rows / 2],
        sum[(int) Math.ceil(0.99 * rows) - 1],
        sum[rows - 1],
        rows,
        (double) allocated / rows,
        tally.count,
        hash);
  }

  private static double median(double[] values, int count) {
    Arrays.sort(values, 0, count);
    return values[count / 2];
  }
}
