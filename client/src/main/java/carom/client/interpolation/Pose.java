package carom.client.interpolation;

/** A position, an angle and their velocities. Mutable, reused. */
public final class Pose {
  /** X of the body origin, metres. */
  public float x;

  /** Y of the body origin, metres. */
  public float y;

  /** Angle, radians counter-clockwise, any number of turns. */
  public float angle;

  /** X of the velocity, m/s. */
  public float vx;

  /** Y of the velocity, m/s. */
  public float vy;

  /** Angular velocity, rad/s. */
  public float omega;

  /** Creates a pose at the origin, at rest. */
  public Pose() {}

  /** Sets all values. */
  public void set(float x, float y, float angle, float vx, float vy, float omega) {
    this.x = x;
    this.y = y;
    this.angle = angle;
    this.vx = vx;
    this.vy = vy;
    this.omega = omega;
  }

  /** Copies another pose. */
  public void set(Pose other) {
    set(other.x, other.y, other.angle, other.vx, other.vy, other.omega);
  }

  /** Moves this pose towards another by a share of 0..1; angles go the short way. */
  public void blend(Pose other, float share) {
    x += (other.x - x) * share;
    y += (other.y - y) * share;
    angle += wrap(other.angle - angle) * share;
    vx += (other.vx - vx) * share;
    vy += (other.vy - vy) * share;
    omega += (other.omega - omega) * share;
  }

  /** Returns an angle difference the short way round, -pi..pi. */
  public static float wrap(float radians) {
    double turns = radians / (2 * Math.PI);
    return (float) ((turns - Math.rint(turns)) * 2 * Math.PI);
  }
}
