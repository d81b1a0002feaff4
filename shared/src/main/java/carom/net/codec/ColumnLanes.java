package carom.net.codec;

import carom.physics.simd.VectorKernels;
import carom.physics.simd.VectorModule;

/**
 * Vector kernels that quantise several numbers of a column at once, bit for bit as {@link
 * Quantizer} does one by one. The share of a column that goes through them changes no result.
 */
abstract class ColumnLanes extends VectorKernels {
  /** The kernels built on the Vector API, or null if the JVM runs without that module. */
  static final ColumnLanes FOUND =
      VectorModule.find("carom.net.codec.VectorColumns", ColumnLanes.class);

  /** Returns how many numbers one call of a kernel takes. */
  abstract int width();

  /**
   * Rounds numbers to steps as {@link Quantizer} does.
   *
   * @param from the numbers, from {@code at} on
   * @param scale steps per unit, a power of two
   * @param max the largest allowed magnitude of a result in steps, at most 2^21
   * @param to receives the steps, from {@code at} on; undefined if this returns false
   * @return whether all results are within {@code max}; false if one of the numbers is NaN
   */
  abstract boolean round(float[] from, int at, float scale, float max, int[] to);

  /**
   * Turns directions into angles. It uses the polynomial of {@code
   * carom.physics.math.Trig.roughTurn} and rounds as {@link Quantizer#angleOfTurn} does.
   *
   * @param error largest error of the polynomial
   */
  abstract void turn(float[] cos, float[] sin, int at, int error, int[] to);

  /**
   * Quantises as many leading numbers of a column as the kernel takes.
   *
   * @param max largest magnitude in steps as in {@link #round}, but it may be above 2^21
   * @return how many numbers were quantised, 0..n; the caller does the rest
   */
  final int steps(float[] from, int n, int scale, int max, int[] to) {
    int width = width();
    int calls = calls(n);
    float most = Math.min(max, 1 << 21);
    for (int at = 0; at < calls * width; at += width) {
      if (!round(from, at, scale, most, to)) {
        Quantizer.clampColumn(from, at, at + width, scale, max, to);
      }
    }
    return calls * width;
  }

  /**
   * Quantises as many leading directions of two columns as the kernel takes, and returns how many.
   */
  final int turns(float[] cos, float[] sin, int n, int error, int[] to) {
    int width = width();
    int calls = calls(n);
    for (int at = 0; at < calls * width; at += width) {
      turn(cos, sin, at, error, to);
    }
    return calls * width;
  }

  /** Returns how many kernel calls are granted for a column of n numbers. */
  private int calls(int n) {
    return n < Quantizer.LONG ? 0 : grant(n / width(), n);
  }
}
