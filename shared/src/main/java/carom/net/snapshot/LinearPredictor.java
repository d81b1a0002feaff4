package carom.net.snapshot;

import carom.net.codec.Quantizer;

/**
 * Everything goes on as it moves: constant velocity, constant angular velocity. Fixed-point
 * arithmetic, rounded to nearest.
 */
final class LinearPredictor implements Predictor {

  private static final int SHIFT = 24;
  private static final long HALF = 1L << (SHIFT - 1);

  private final long[] positionScale = new long[FrameRing.SIZE];
  private final long[] angleScale = new long[FrameRing.SIZE];

  LinearPredictor(int tickRate) {
    // Angle steps per omega step and second, 1024 / (2 pi 32), as an exact constant so that no
    // library function decides it.
    long angleStepsPerOmega = Math.round(5.092958178940651 * (1L << SHIFT));
    for (int age = 0; age < FrameRing.SIZE; age++) {
      long perSecond = (long) Quantizer.POSITION_STEPS / Quantizer.VELOCITY_STEPS << SHIFT;
      positionScale[age] = (perSecond * age + tickRate / 2) / tickRate;
      angleScale[age] = (angleStepsPerOmega * age + tickRate / 2) / tickRate;
    }
  }

  @Override
  public void predict(Motion state, int age) {
    long position = positionScale[age];
    state.x += (int) ((state.vx * position + HALF) >> SHIFT);
    state.y += (int) ((state.vy * position + HALF) >> SHIFT);
    int turned = (int) ((state.omega * angleScale[age] + HALF) >> SHIFT);
    state.angle = (state.angle + turned) & (Quantizer.ANGLE_STEPS - 1);
  }
}
