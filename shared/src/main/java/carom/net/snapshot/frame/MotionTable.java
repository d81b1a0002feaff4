package carom.net.snapshot.frame;

import carom.net.codec.Quantizer;
import java.util.Arrays;

/**
 * Holds the quantised motions of a frame, by slot. Each is two longs side by side, its place and
 * its speed: a third less memory than six columns, and all in one cache line. All numbers must be
 * within the ranges of {@link Quantizer}, which isn't checked. One thread; allocates only in {@link
 * #ensure}.
 */
final class MotionTable {
  // Of a place, from above: x, y and the angle, of 27, 27 and 10 bits.
  private static final int X_SHIFT = 37;
  private static final int Y_SHIFT = 10;
  private static final long Y_MASK = (1L << X_SHIFT - Y_SHIFT) - 1;

  // Of a speed: vx, vy and omega, of at least 19, 19 and 17 bits.
  private static final int VX_SHIFT = 36;
  private static final int VY_SHIFT = 17;
  private static final long VY_MASK = (1L << VX_SHIFT - VY_SHIFT) - 1;
  private static final long OMEGA_MASK = (1L << VY_SHIFT) - 1;

  /** By slot: its place, then its speed. */
  private long[] words = {};

  /** Makes room for slots below a limit. */
  void ensure(int limit) {
    if (2 * limit > words.length) {
      words = Arrays.copyOf(words, 2 * limit);
    }
  }

  /** Puts a motion into a slot for which there is room. */
  void put(int slot, int x, int y, int angle, int vx, int vy, int omega) {
    words[2 * slot] = place(x, y, angle);
    words[2 * slot + 1] = speed(vx, vy, omega);
  }

  /**
   * Puts the motions of many slots.
   *
   * @param slot from one index on: where each goes, or a negative number for nowhere
   * @param from that index
   * @param columns x, y, angle, vx, vy, omega, n of each
   */
  void putAll(int n, int[] slot, int from, int[][] columns) {
    int[] x = columns[0];
    int[] y = columns[1];
    int[] angle = columns[2];
    int[] vx = columns[3];
    int[] vy = columns[4];
    int[] omega = columns[5];
    long[] words = this.words;
    for (int i = 0; i < n; i++) {
      int at = 2 * slot[from + i];
      if (at >= 0) {
        words[at] = place(x[i], y[i], angle[i]);
        words[at + 1] = speed(vx[i], vy[i], omega[i]);
      }
    }
  }

  /** Returns those of 64 slots below a limit whose motion differs from that of another frame. */
  long differing(MotionTable other, int word, int limit) {
    long[] words = this.words;
    long[] old = other.words;
    int begin = word << 6;
    int end = Math.min(limit, begin + 64);
    // in a world at rest often all of them
    if (Arrays.equals(words, 2 * begin, 2 * end, old, 2 * begin, 2 * end)) {
      return 0;
    }
    long result = 0;
    for (int slot = begin; slot < end; slot++) {
      long difference = words[2 * slot] ^ old[2 * slot] | words[2 * slot + 1] ^ old[2 * slot + 1];
      // 0 or 1 without a branch
      result |= (difference | -difference) >>> Long.SIZE - 1 << slot;
    }
    return result;
  }

  private static long place(int x, int y, int angle) {
    return (long) x << X_SHIFT | (y & Y_MASK) << Y_SHIFT | angle;
  }

  private static long speed(int vx, int vy, int omega) {
    return (long) vx << VX_SHIFT | (vy & VY_MASK) << VY_SHIFT | omega & OMEGA_MASK;
  }

  boolean same(MotionTable other, int slot) {
    return words[2 * slot] == other.words[2 * slot]
        && words[2 * slot + 1] == other.words[2 * slot + 1];
  }

  int x(int slot) {
    return (int) (words[2 * slot] >> X_SHIFT);
  }

  int y(int slot) {
    return (int) (words[2 * slot] << Long.SIZE - X_SHIFT >> Long.SIZE - X_SHIFT + Y_SHIFT);
  }

  int angle(int slot) {
    return (int) words[2 * slot] & Quantizer.ANGLE_STEPS - 1;
  }

  int vx(int slot) {
    return (int) (words[2 * slot + 1] >> VX_SHIFT);
  }

  int vy(int slot) {
    return (int) (words[2 * slot + 1] << Long.SIZE - VX_SHIFT >> Long.SIZE - VX_SHIFT + VY_SHIFT);
  }

  int omega(int slot) {
    return (int) words[2 * slot + 1] << Integer.SIZE - VY_SHIFT >> Integer.SIZE - VY_SHIFT;
  }
}
