package carom.net.snapshot.frame;

import carom.net.codec.Quantizer;
import java.util.Arrays;

/**
 * Holds the quantised poses of a frame, by slot. Each is one long: a third of the memory of four
 * columns, and compared at once. All numbers must be within the ranges of {@link Quantizer}, which
 * isn't checked. One thread; allocates only in {@link #ensure}.
 */
final class PoseTable {
  // From above: x, y, the angle, and whether it stands still, of 26, 26, 10 and 1 bits.
  private static final int X_SHIFT = 38;
  private static final int Y_SHIFT = 12;
  private static final int ANGLE_SHIFT = 2;
  private static final long Y_MASK = (1L << X_SHIFT - Y_SHIFT) - 1;

  private long[] poses = {};

  /** Makes room for slots below a limit. */
  void ensure(int limit) {
    if (limit > poses.length) {
      poses = Arrays.copyOf(poses, limit);
    }
  }

  /**
   * Puts a pose into a slot for which there is room.
   *
   * @param still 1 if the body stands still, else 0
   */
  void put(int slot, int x, int y, int angle, int still) {
    poses[slot] = packed(x, y, angle, still);
  }

  /**
   * Puts the poses of many slots.
   *
   * @param slot from one index on: where each goes, or a negative number for nowhere
   * @param from that index
   * @param columns x, y, angle and still, n of each
   */
  void putAll(int n, int[] slot, int from, int[][] columns) {
    int[] x = columns[0];
    int[] y = columns[1];
    int[] angle = columns[2];
    int[] still = columns[3];
    long[] poses = this.poses;
    for (int i = 0; i < n; i++) {
      int at = slot[from + i];
      if (at >= 0) {
        poses[at] = packed(x[i], y[i], angle[i], still[i]);
      }
    }
  }

  /** Returns those of 64 slots below a limit whose pose differs from that of another frame. */
  long differing(PoseTable other, int word, int limit) {
    long[] poses = this.poses;
    long[] old = other.poses;
    int begin = word << 6;
    int end = Math.min(limit, begin + 64);
    // in a world at rest often all of them
    if (Arrays.equals(poses, begin, end, old, begin, end)) {
      return 0;
    }
    long result = 0;
    for (int slot = begin; slot < end; slot++) {
      long difference = poses[slot] ^ old[slot];
      // 0 or 1 without a branch
      result |= (difference | -difference) >>> Long.SIZE - 1 << slot;
    }
    return result;
  }

  /** Returns a pose as one long. */
  static long packed(int x, int y, int angle, int still) {
    return (long) x << X_SHIFT | (y & Y_MASK) << Y_SHIFT | (long) angle << ANGLE_SHIFT | still;
  }

  boolean same(PoseTable other, int slot) {
    return poses[slot] == other.poses[slot];
  }

  int x(int slot) {
    return x(poses[slot]);
  }

  int y(int slot) {
    return y(poses[slot]);
  }

  int angle(int slot) {
    return angle(poses[slot]);
  }

  boolean still(int slot) {
    return (poses[slot] & 1) != 0;
  }

  void read(int slot, QuantizedPose out) {
    unpack(poses[slot], out);
  }

  /** Undoes {@link #packed}. */
  static void unpack(long pose, QuantizedPose out) {
    out.set(x(pose), y(pose), angle(pose), (pose & 1) != 0);
  }

  private static int x(long pose) {
    return (int) (pose >> X_SHIFT);
  }

  private static int y(long pose) {
    return (int) (pose << Long.SIZE - X_SHIFT >> Long.SIZE - X_SHIFT + Y_SHIFT);
  }

  private static int angle(long pose) {
    return (int) pose >> ANGLE_SHIFT & Quantizer.ANGLE_STEPS - 1;
  }
}
