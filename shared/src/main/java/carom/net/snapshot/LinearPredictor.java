package carom.net.snapshot;

import carom.net.codec.Quantizer;

/**
 * Velocities stay; the pose moves with the mean of the old and the true new velocity, which is
 * right for everything that accelerates evenly: gravity, damping, a motor. Fixed-point arithmetic,
 * rounded to nearest.
 *
 * <p>With the old velocity alone the position of a falling body was off by 26 steps after 100 ms,
 * and a record about a byte longer.
 */
final class LinearPredictor implements Predictor {

  private static final int SHIFT = 24;
  private static final long HALF = 1L << (SHIFT - 1);

  private final long[] positionScale = new long[FrameRing.SIZE];
  private final long[] angleScale = new long[FrameRing.SIZE];

  LinearPredictor(int tickRate) {
    // Per step of the sum of two velocities: half a mean, in position steps per second; 1024 / (2
    // pi 32) for angles.
    long position = (long) (Quantizer.POSITION_STEPS / Quantizer.VELOCITY_STEPS) << (SHIFT - 1);
    long angle = Math.round(5.092958178940651 * (1L << (SHIFT - 1)));
    for (int age = 0; age < FrameRing.SIZE; age++) {
      positionScale[age] = (position * age + tickRate / 2) / tickRate;
      angleScale[age] = (angle * age + tickRate / 2) / tickRate;
    }
  }

  @Override
  public void predictVelocity(Motion state, int age) {
    // A body goes on as it moves.
  }

  @Override
  public void predictPose(Motion state, int vx, int vy, int omega, int age) {
    state.x += scaled(state.vx + vx, positionScale[age]);
    state.y += scaled(state.vy + vy, positionScale[age]);
    int turned = scaled(state.omega + omega, angleScale[age]);
    state.angle = (state.angle + turned) & (Quantizer.ANGLE_STEPS - 1);
  }

  private static int scaled(int sum, long scale) {
    return (int) ((sum * scale + HALF) >> SHIFT);
  }
}
