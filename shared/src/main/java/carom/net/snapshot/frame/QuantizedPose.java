package carom.net.snapshot.frame;

import carom.net.codec.Quantizer;

/**
 * The quantised pose of a body and whether the body stands still, or a difference of two poses.
 * Mutable, reused.
 */
public final class QuantizedPose {

  public int x;
  public int y;
  public int angle;

  /** True if the body stands still, as {@link Quantizer#isStill} says; no part of a difference. */
  public boolean still;

  /** Creates the pose at the origin, which moves. */
  public QuantizedPose() {}

  /** Copies another pose. */
  public void set(QuantizedPose other) {
    set(other.x, other.y, other.angle, other.still);
  }

  /** Sets all values. */
  public void set(int x, int y, int angle, boolean still) {
    this.x = x;
    this.y = y;
    this.angle = angle;
    this.still = still;
  }

  /**
   * Sets this to how far {@code actual} is from {@code predicted}, the angle the short way round.
   */
  public void setResidual(QuantizedPose predicted, QuantizedPose actual) {
    x = actual.x - predicted.x;
    y = actual.y - predicted.y;
    angle = Quantizer.wrapAngle(actual.angle - predicted.angle);
    still = actual.still;
  }

  /** Undoes {@link #setResidual}: turns the predicted pose into the actual one. */
  public void addResidual(QuantizedPose residual) {
    x += residual.x;
    y += residual.y;
    angle = (angle + residual.angle) & (Quantizer.ANGLE_STEPS - 1);
    still = residual.still;
  }

  /** Returns whether all numbers are in the ranges of {@link Quantizer}. */
  public boolean inRange() {
    return within(x) && within(y) && angle >= 0 && angle < Quantizer.ANGLE_STEPS;
  }

  private static boolean within(int value) {
    return value >= -Quantizer.MAX_POSITION && value <= Quantizer.MAX_POSITION;
  }
}
