package carom.physics.dynamics.store;

import carom.physics.simd.VectorKernels;
import carom.physics.simd.VectorModule;

/**
 * A kernel that hashes a column of numbers side by side, bit for bit as {@link ColumnHash} does one
 * after the other. How many numbers go through it shows in no result.
 */
public abstract class ColumnHashLanes extends VectorKernels {
  /** The kernel made with the Vector API, null without; see {@link VectorModule}. */
  static final ColumnHashLanes FOUND =
      VectorModule.find("carom.physics.dynamics.simd.VectorColumnHash", ColumnHashLanes.class);

  /** Longs per vector, at most. */
  public static final int SUMS = 8;

  /** Numbers of a block. */
  public static final int BLOCK = 32;

  /** Shorter columns gain too little to be worth the calls. */
  private static final int LEAST = 512;

  /** Makes the kernel; it is found by name. */
  protected ColumnHashLanes() {}

  /**
   * Adds words of a column, multiplied by their factors, to sums that belong together.
   *
   * @param from first number, a multiple of {@value #BLOCK}, like the end
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
    int numbers = grant(n / BLOCK, n) * BLOCK;
    column(column, factors, 0, numbers, sums);
    return numbers;
  }
}
