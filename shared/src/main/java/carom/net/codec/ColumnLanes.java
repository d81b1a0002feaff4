package carom.net.codec;

import carom.physics.simd.VectorKernels;
import carom.physics.simd.VectorModule;

/**
 * Kernels that quantise the numbers of a column side by side, bit for bit as {@link Quantizer} does
 * one after the other. How many go through them shows in no result.
 */
abstract class ColumnLanes extends VectorKernels {
  /** The kernels made with the Vector API, null where the JVM was started without that module. */
  static final ColumnLanes FOUND =
      VectorModule.find("carom.net.codec.VectorColumns", ColumnLanes.class);

  /** Returns how many numbers a call of a kernel takes. */
  abstract int width();

  /**
   * Converts numbers to steps, rounded as {@link Quantizer} does.
   *
   * @param from the numbers, from {@code at} on
   * @param scale steps per unit, a power of two
   * @param max the largest magnitude that a result may have, steps, at most 2^21
   * @param to receives the steps, from {@code at} on; they mean nothing if it is false
   * @return whether all numbers are that small; false, too, if one isn't a number
   */
  abstract boolean round(float[] from, int at, float scale, float max, int[] to);

  /**
   * Converts directions to angles, as {@link Quantizer#angleOfTurn} rounds those of {@code
   * carom.physics.math.Trig.roughTurn}, by the same polynomial.
   *
   * @param error how far these may be off
   */
  abstract void turn(float[] cos, float[] sin, int at, int error, int[] to);

  /**
   * Quantises the first numbers of a column.
   *
   * @param max as in {@link #round}, also above 2^21
   * @return how many were, 0..n; the rest is left to the caller
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

  /** Quantises the first directions of two columns, and returns how many. */
  final int turns(float[] cos, float[] sin, int n, int error, int[] to) {
    int width = width();
    int calls = calls(n);
    for (int at = 0; at < calls * width; at += width) {
      turn(cos, sin, at, error, to);
    }
    return calls * width;
  }

  /** Returns how often a kernel may be called for a column of n numbers. */
  private int calls(int n) {
    return n < Quantizer.LONG ? 0 : grant(n / width(), n);
  }
}
