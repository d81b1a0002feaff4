package carom.physics.dynamics.store;

import carom.physics.simd.VectorModule;

/**
 * A kernel that hashes a column of numbers side by side, bit for bit as {@link ColumnHash} does one
 * after the other. How many numbers go through it shows in no result.
 */
public abstract class ColumnHashLanes {
  /** The kernel made with the Vector API, null without; see {@link VectorModule}. */
  static final ColumnHashLanes FOUND =
      VectorModule.find("carom.physics.dynamics.simd.VectorColumnHash", ColumnHashLanes.class);

  /** Longs per vector, at most. */
  public static final int SUMS = 8;

  /**
   * Number of calls before everything goes through the kernel. Until then the JIT compiler may
   * interpret it, hundreds of times slower.
   */
  private static final int WARM_UP = 1_500;

  /** Pieces per hash while warming up. */
  private static final int FEW = 8;

  /** Numbers per piece while warming up. */
  private static final int SMALL = 32;

  /** Shorter columns gain too little to be worth the calls. */
  private static final int LEAST = 512;

  /** How often the kernel was called. Worlds share this count, which needn't be exact. */
  private int calls;

  /**
   * Adds words of a column, multiplied by their factors, to sums that belong together.
   *
   * @param from first number, a multiple of {@value #SMALL}, like the end
   * @param sums {@link #SUMS} of them
   */
  public abstract void column(float[] column, long[] factors, int from, int to, long[] sums);

  /**
   * Adds the first numbers of a column.
   *
   * @param n how many there are
   * @return how many were added, an even number; the rest is left to the caller
   */
  final int column(float[] column, long[] factors, int n, long[] sums) {
    if (n < LEAST) {
      return 0; // the compiled kernel, which knows long columns only, would box vectors for nothing
    }
    int whole = n & -SMALL;
    if (calls >= WARM_UP) {
      column(column, factors, 0, whole, sums);
      return whole;
    }
    int done = Math.min(whole, FEW * SMALL);
    for (int at = 0; at < done; at += SMALL, calls++) {
      column(column, factors, at, at + SMALL, sums);
    }
    return done;
  }
}
