package carom.net.snapshot;

import carom.net.codec.Quantizer;

/** The six quantised numbers that move, as one mutable value for predicting and coding. */
final class Motion {

  int x;
  int y;
  int angle;
  int vx;
  int vy;
  int omega;

  boolean inRange() {
    return within(x, Quantizer.MAX_POSITION)
        && within(y, Quantizer.MAX_POSITION)
        && angle >= 0
        && angle < Quantizer.ANGLE_STEPS
        && within(vx, Quantizer.MAX_VELOCITY)
        && within(vy, Quantizer.MAX_VELOCITY)
        && within(omega, Quantizer.MAX_OMEGA);
  }

  private static boolean within(int value, int max) {
    return value >= -max && value <= max;
  }
}
