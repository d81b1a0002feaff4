package carom.net.snapshot;

import carom.net.codec.Quantizer;
import carom.net.snapshot.frame.QuantizedPose;

/**
 * Predicts the pose of a body from the poses of a baseline; the difference to the truth is sent. It
 * computes with integers only, so that both sides compute the same. A better prediction saves bytes
 * and never changes what is decoded.
 *
 * <p>From one pose, or if it stands still, the body stays there. From two, it goes straight on.
 * From three, it falls, if gravity explains the bend of its way; else it goes on with a share of
 * its last speed and a share of the bend, which depend on how large the bend is: a small one is
 * nothing but rounding, a large one may go on. The shares are counted over scenes, see {@link
 * Profiles}.
 */
final class Predictor {

  /** Number of classes of bends that have shares of their own. */
  static final int BEND_SHARES = 12;

  /** Number of shares of a profile: two for each class of a way's bends, and of a turn's. */
  static final int SHARES = 4 * BEND_SHARES;

  /** Value of a whole share. */
  static final int WHOLE = 256;

  private static final int BEND_CLASSES = 11;
  private static final int FALLING = BEND_CLASSES;

  /** Largest difference of a bend from that of a fall, steps: what rounding explains. */
  private static final int FALL_ROUNDING = 2;

  private static final int TWO_POSES = FALLING + FALL_ROUNDING + 1;
  private static final int ONE_POSE = TWO_POSES + 1;
  private static final int TWIST_CLASSES = 10;
  private static final int TWIST_OF_TWO = TWIST_CLASSES;
  private static final int TWIST_OF_ONE = TWIST_OF_TWO + 1;

  /** Binary digits behind the point of what bodies gain in a tick by falling. */
  private static final int FALL_SHIFT = 16;

  private final int tickRate;

  /** Speed that bodies gain in a tick by falling, steps per tick. */
  private long fallX;

  private long fallY;

  /**
   * Creates a predictor without gravity.
   *
   * @param tickRate ticks per second; the other side's must be the same
   */
  public Predictor(int tickRate) {
    this.tickRate = tickRate;
  }

  /** Sets gravity, m/s^2; it is zero before. */
  public void gravity(float x, float y) {
    fallX = gain(x);
    fallY = gain(y);
  }

  private long gain(float metres) {
    double steps = metres * (double) Quantizer.POSITION_STEPS / ((double) tickRate * tickRate);
    double bounded = Math.max(-Quantizer.MAX_POSITION, Math.min(Quantizer.MAX_POSITION, steps));
    return (long) Math.floor(bounded * (1L << FALL_SHIFT) + 0.5);
  }

  /**
   * Finds out how a body moved whose poses are in a track; of one at rest, forgets earlier ones.
   */
  public void study(Track t, int baseline) {
    t.baseline = baseline;
    int poses = Baseline.poses(baseline);
    int stride = Baseline.stride(baseline);
    long age = Baseline.age(baseline);
    if (t.newest.still) {
      t.middle.set(t.newest);
      t.oldest.set(t.newest);
    }
    t.dx = poses < 2 ? 0 : t.newest.x - t.middle.x;
    t.dy = poses < 2 ? 0 : t.newest.y - t.middle.y;
    t.turn = poses < 2 ? 0 : Quantizer.wrapAngle(t.newest.angle - t.middle.angle);
    boolean three = poses == Baseline.MOST_POSES;
    t.bendX = three ? t.dx - t.middle.x + t.oldest.x : 0;
    t.bendY = three ? t.dy - t.middle.y + t.oldest.y : 0;
    int turnBefore = Quantizer.wrapAngle(t.middle.angle - t.oldest.angle);
    t.bendTurn = three ? Quantizer.wrapAngle(t.turn - turnBefore) : 0;
    t.falls = false;
    t.dropX = 0;
    t.dropY = 0;
    if (three) {
      classify(t, stride, age);
    } else {
      t.bend = poses == 2 ? TWO_POSES : ONE_POSE;
      t.twist = poses == 2 ? TWIST_OF_TWO : TWIST_OF_ONE;
    }
    long way = poses < 2 ? 0 : length(t.dx, t.dy) * age / stride;
    t.speed = t.newest.still ? 0 : (way | t.turn) == 0 ? 1 : 2 + Math.min(3, digits(way) + 1 >> 1);
    t.speed = Math.min(Track.SPEEDS - 1, t.speed);
  }

  private void classify(Track t, int stride, long age) {
    long size = length(t.bendX, t.bendY);
    long squared = (long) stride * stride;
    long fall = length(t.bendX - round(fallX * squared), t.bendY - round(fallY * squared));
    t.falls = fall <= FALL_ROUNDING && fall < size;
    // by how much the bend moves the body in this time, in halves
    long reach = age * (age + stride);
    t.dropX = t.falls ? round(fallX * reach >> 1) : 0;
    t.dropY = t.falls ? round(fallY * reach >> 1) : 0;
    t.bend = t.falls ? FALLING + (int) fall : level(size * reach / (4 * squared), BEND_CLASSES - 1);
    t.twist = level(Math.abs(t.bendTurn) * reach / (4 * squared), TWIST_CLASSES - 1);
  }

  private static long length(long x, long y) {
    return Math.abs(x) + Math.abs(y);
  }

  private static long round(long fixed) {
    return fixed + (1L << FALL_SHIFT - 1) >> FALL_SHIFT;
  }

  /** Returns the level of a size: two levels for each binary digit. */
  static int level(long size, int most) {
    int digits = digits(size);
    int level = digits < 2 ? digits : 2 * digits - 2 + (int) (size >>> digits - 2 & 1);
    return Math.min(most, level);
  }

  private static int digits(long size) {
    return Long.SIZE - Long.numberOfLeadingZeros(size);
  }

  /**
   * Predicts the pose after a track that was {@linkplain #study studied}.
   *
   * @param profile of {@link Profiles}
   * @param out a pose in range
   */
  public void predict(Track t, int profile, QuantizedPose out) {
    predict(t, Profiles.SHARES, profile * SHARES, out);
  }

  /** Predicts a pose with shares that begin at an index. */
  static void predict(Track t, short[] shares, int first, QuantizedPose out) {
    int stride = Baseline.stride(t.baseline);
    int age = Baseline.age(t.baseline);
    QuantizedPose from = t.newest;
    if (stride == 0) {
      out.set(from);
      return;
    }
    boolean three = Baseline.poses(t.baseline) == Baseline.MOST_POSES;
    long straight = 2L * stride * age;
    long bent = (long) age * (age + stride);
    long whole = WHOLE * 2L * stride * stride;
    int place = first + 2 * level(length(t.bendX, t.bendY), BEND_SHARES - 1);
    boolean bends = three && !t.falls;
    long on = bends ? shares[place] : WHOLE;
    long bend = bends ? shares[place + 1] : 0;
    long x = on * t.dx * straight + bend * t.bendX * bent;
    long y = on * t.dy * straight + bend * t.bendY * bent;
    int spin = first + 2 * (BEND_SHARES + level(Math.abs(t.bendTurn), BEND_SHARES - 1));
    on = three ? shares[spin] : WHOLE;
    bend = three ? shares[spin + 1] : 0;
    long turn = on * t.turn * straight + bend * t.bendTurn * bent;
    out.x = within(from.x + nearest(x, whole) + t.dropX);
    out.y = within(from.y + nearest(y, whole) + t.dropY);
    out.angle = from.angle + (int) nearest(turn, whole) & Quantizer.ANGLE_STEPS - 1;
  }

  private static long nearest(long value, long whole) {
    return Math.floorDiv(value + whole / 2, whole);
  }

  private static int within(long steps) {
    return (int) Math.max(-Quantizer.MAX_POSITION, Math.min(Quantizer.MAX_POSITION, steps));
  }
}
