package carom.net.snapshot.frame;

import carom.net.codec.Quantizer;

/**
 * Moves a state that both sides know to a later tick; the difference to the truth is sent. It
 * computes with integers only, so that both sides compute the same. A better prediction saves bytes
 * and never changes what is decoded.
 *
 * <p>Velocities come first, in one of three ways that the record names: the body goes on, falls, or
 * stops. Then the client knows the true velocities, and the pose moves with the mean of the old and
 * the new ones, which is right for everything that accelerates evenly: gravity, damping, a motor.
 */
public final class Predictor {

  /** Way of a body that keeps its velocities. */
  public static final int GOES_ON = 0;

  /** Way of a body that gravity accelerates. */
  public static final int FALLS = 1;

  /** Way of a body that has come to rest. */
  public static final int STOPS = 2;

  private static final int SHIFT = 24;
  private static final long HALF = 1L << (SHIFT - 1);

  private final int tickRate;
  private final long[] positionScale = new long[FrameRing.SIZE];
  private final long[] angleScale = new long[FrameRing.SIZE];
  private final int[] fallX = new int[FrameRing.SIZE];
  private final int[] fallY = new int[FrameRing.SIZE];

  /**
   * Creates a predictor without gravity.
   *
   * @param tickRate ticks per second; the other side's must be the same
   */
  public Predictor(int tickRate) {
    this.tickRate = tickRate;
    // Per step of the sum of two velocities: half a mean, in position steps per second; 1024 / (2
    // pi 4) for angles.
    long position = (long) (Quantizer.POSITION_STEPS / Quantizer.VELOCITY_STEPS) << (SHIFT - 1);
    long angle = Math.round(40.743665431525206 * (1L << (SHIFT - 1)));
    for (int age = 0; age < FrameRing.SIZE; age++) {
      positionScale[age] = (position * age + tickRate / 2) / tickRate;
      angleScale[age] = (angle * age + tickRate / 2) / tickRate;
    }
  }

  /** Sets gravity, m/s^2; it is zero before. */
  public void gravity(float x, float y) {
    int stepsX = Quantizer.velocity(x);
    int stepsY = Quantizer.velocity(y);
    for (int age = 0; age < FrameRing.SIZE; age++) {
      fallX[age] = Math.floorDiv(2 * stepsX * age + tickRate, 2 * tickRate);
      fallY[age] = Math.floorDiv(2 * stepsY * age + tickRate, 2 * tickRate);
    }
  }

  /** Returns the way whose prediction comes nearest to a later state. */
  public int way(Motion baseline, Motion actual, int age) {
    if ((actual.vx | actual.vy | actual.omega) == 0
        && (baseline.vx | baseline.vy | baseline.omega) != 0) {
      return STOPS;
    }
    int dx = actual.vx - baseline.vx;
    int dy = actual.vy - baseline.vy;
    int falling = Math.abs(dx - fallX[age]) + Math.abs(dy - fallY[age]);
    return falling < Math.abs(dx) + Math.abs(dy) ? FALLS : GOES_ON;
  }

  /**
   * Predicts the three velocities in place; leaves the pose alone.
   *
   * @param state the baseline
   * @param age ticks, 1..{@link FrameRing#SIZE} - 1
   */
  void velocity(Motion state, int way, int age) {
    if (way == FALLS) {
      state.vx += fallX[age];
      state.vy += fallY[age];
    } else if (way == STOPS) {
      state.vx = 0;
      state.vy = 0;
      state.omega = 0;
    }
  }

  /**
   * Predicts the pose in place, which may leave the range of positions.
   *
   * @param state the baseline
   * @param vx true velocity at the later tick
   * @param vy true velocity at the later tick
   * @param omega true angular velocity at the later tick
   * @param age ticks, 1..{@link FrameRing#SIZE} - 1
   */
  void pose(Motion state, int vx, int vy, int omega, int age) {
    state.x += scaled(state.vx + vx, positionScale[age]);
    state.y += scaled(state.vy + vy, positionScale[age]);
    int turned = scaled(state.omega + omega, angleScale[age]);
    state.angle = (state.angle + turned) & (Quantizer.ANGLE_STEPS - 1);
  }

  private static int scaled(int sum, long scale) {
    return (int) ((sum * scale + HALF) >> SHIFT);
  }
}
