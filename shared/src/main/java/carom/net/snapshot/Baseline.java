package carom.net.snapshot;

import carom.net.snapshot.frame.FrameRing;

/**
 * The state against which a delta is coded, as an int. It tells how old the state is that both
 * sides know, how many earlier poses of the body they know, too, and how far those are apart. A
 * baseline of three poses has those after tick T, T - stride and T - 2 stride, where T is
 * <em>age</em> ticks before the delta's tick.
 */
final class Baseline {

  /** Most poses of a baseline. */
  public static final int MOST_POSES = 3;

  /** Number of bits of a number of poses. */
  static final int POSES_BITS = 2;

  /** Number of bits of a stride. */
  static final int STRIDE_BITS = 5;

  /** Largest stride, ticks. */
  public static final int MAX_STRIDE = (1 << STRIDE_BITS) - 1;

  private static final int STRIDE_SHIFT = FrameRing.AGE_BITS;
  private static final int POSES_SHIFT = STRIDE_SHIFT + STRIDE_BITS;

  private Baseline() {}

  /**
   * Returns the baseline as an int.
   *
   * @param age ticks, 1..{@link FrameRing#SIZE} - 1
   * @param poses 1..{@link #MOST_POSES}
   * @param stride ticks, 1..{@link #MAX_STRIDE}; of one pose it doesn't count
   */
  public static int of(int age, int poses, int stride) {
    return age | (poses == 1 ? 0 : stride) << STRIDE_SHIFT | poses << POSES_SHIFT;
  }

  /**
   * Returns the stride that says most of how a body moves: a twentieth of a second. Shorter ones
   * say more of rounding, longer ones less of the present.
   *
   * @param tickRate ticks per second
   */
  public static int bestStride(int tickRate) {
    return Math.max(1, Math.min(MAX_STRIDE / 2, (tickRate + 10) / 20));
  }

  /** Returns the age of the newest pose, ticks; after hostile bytes it may be 0. */
  public static int age(int baseline) {
    return baseline & FrameRing.SIZE - 1;
  }

  /** Returns the number of poses; after hostile bytes it may be 0. */
  public static int poses(int baseline) {
    return baseline >>> POSES_SHIFT;
  }

  /** Returns the ticks between two poses: 0 of one pose, and maybe after hostile bytes. */
  public static int stride(int baseline) {
    return baseline >>> STRIDE_SHIFT & MAX_STRIDE;
  }

  /** Returns whether the numbers are such as a sender may use. */
  public static boolean isValid(int baseline) {
    int poses = poses(baseline);
    return age(baseline) > 0 && poses > 0 && (poses == 1 || stride(baseline) > 0);
  }
}
