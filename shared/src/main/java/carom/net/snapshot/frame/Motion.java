package carom.net.snapshot.frame;

import carom.net.codec.Quantizer;

/** The quantised pose and velocity of a body, or a difference of two. Mutable, reused. */
public final class Motion {

  public int x;
  public int y;
  public int angle;
  public int vx;
  public int vy;
  public int omega;

  void set(Motion other) {
    x = other.x;
    y = other.y;
    angle = other.angle;
    vx = other.vx;
    vy = other.vy;
    omega = other.omega;
  }

  /** Returns whether all six numbers are 0. */
  public boolean isZero() {
    return (x | y | angle | vx | vy | omega) == 0;
  }

  /** Sets all six numbers to 0. */
  public void clear() {
    x = 0;
    y = 0;
    angle = 0;
    vx = 0;
    vy = 0;
    omega = 0;
  }

  /** Sets this to what {@code actual} differs from the prediction out of {@code baseline}. */
  public void setResidual(Predictor predictor, Motion baseline, Motion actual, int way, int age) {
    set(baseline);
    predictor.velocity(this, way, age);
    int predictedVx = vx;
    int predictedVy = vy;
    int predictedOmega = omega;
    set(baseline);
    predictor.pose(this, actual.vx, actual.vy, actual.omega, age);
    vx = actual.vx - predictedVx;
    vy = actual.vy - predictedVy;
    omega = actual.omega - predictedOmega;
    x = actual.x - x;
    y = actual.y - y;
    angle = Quantizer.wrapAngle(actual.angle - angle);
  }

  /** Undoes {@link #setResidual}: turns a baseline into the actual state. */
  public void addResidual(Predictor predictor, Motion residual, int way, int age) {
    int oldVx = vx;
    int oldVy = vy;
    int oldOmega = omega;
    predictor.velocity(this, way, age);
    int newVx = vx + residual.vx;
    int newVy = vy + residual.vy;
    int newOmega = omega + residual.omega;
    vx = oldVx;
    vy = oldVy;
    omega = oldOmega;
    predictor.pose(this, newVx, newVy, newOmega, age);
    vx = newVx;
    vy = newVy;
    omega = newOmega;
    x += residual.x;
    y += residual.y;
    angle = (angle + residual.angle) & (Quantizer.ANGLE_STEPS - 1);
  }

  /** Returns whether all six numbers are in the ranges of {@link Quantizer}. */
  public boolean inRange() {
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
