package carom.physics.math;

/**
 * A pose in the plane: the position of a body's origin and the body's rotation. It takes points
 * from the body frame to the world:
 *
 * <pre>
 * worldX = x + cos * px - sin * py
 * worldY = y + sin * px + cos * py
 * </pre>
 *
 * <p>The rotation is a unit complex number (cos, sin), so turning a point needs no trigonometry.
 * Code that writes the fields must keep cos&sup2; + sin&sup2; = 1; {@link #normalize()} repairs the
 * drift of repeated products. It is mutable and reused, and not safe for several threads.
 */
public final class Transform {
  /** World position of the body origin, metres. */
  public float x;

  /** World position of the body origin, metres. */
  public float y;

  /** Cosine of the body's angle. */
  public float cos = 1;

  /** Sine of the body's angle. */
  public float sin;

  /** Creates the identity, at the origin and unrotated. */
  public Transform() {}

  /** Creates a pose from a position in metres and an angle in radians, see {@link Trig}. */
  public Transform(float x, float y, float angleRad) {
    set(x, y, angleRad);
  }

  /** Sets position (metres) and angle (radians, counter-clockwise). Returns this. */
  public Transform set(float x, float y, float angleRad) {
    return set(x, y, Trig.cos(angleRad), Trig.sin(angleRad));
  }

  /**
   * Sets position (metres) and rotation as a unit complex number, which is not checked. Returns
   * this.
   */
  public Transform set(float x, float y, float cos, float sin) {
    this.x = x;
    this.y = y;
    this.cos = cos;
    this.sin = sin;
    return this;
  }

  /** Copies {@code t}. Returns this. */
  public Transform set(Transform t) {
    Limits.notNull("t", t);
    return set(t.x, t.y, t.cos, t.sin);
  }

  /** Makes this the identity. Returns this. */
  public Transform setIdentity() {
    return set(0, 0, 1, 0);
  }

  /**
   * Scales (cos, sin) back to length one; a rotation of length zero or NaN becomes the identity
   * rotation.
   */
  public void normalize() {
    double length = Math.sqrt((double) cos * cos + (double) sin * sin);
    if (length > 0) {
      cos = (float) (cos / length);
      sin = (float) (sin / length);
    } else {
      cos = 1;
      sin = 0;
    }
  }

  /** Returns the angle in radians, in (-pi, pi]. */
  public float angle() {
    return Trig.atan2(sin, cos);
  }

  /** Returns the world x of the body-frame point (px, py). */
  public float worldX(float px, float py) {
    return x + (cos * px - sin * py);
  }

  /** Returns the world y of the body-frame point (px, py). */
  public float worldY(float px, float py) {
    return y + (sin * px + cos * py);
  }

  /** Returns the body-frame x of the world point (wx, wy). */
  public float localX(float wx, float wy) {
    return cos * (wx - x) + sin * (wy - y);
  }

  /** Returns the body-frame y of the world point (wx, wy). */
  public float localY(float wx, float wy) {
    return cos * (wy - y) - sin * (wx - x);
  }

  /**
   * Returns the world x component of the body-frame vector (vx, vy). The position has no influence.
   */
  public float rotateX(float vx, float vy) {
    return cos * vx - sin * vy;
  }

  /**
   * Returns the world y component of the body-frame vector (vx, vy). The position has no influence.
   */
  public float rotateY(float vx, float vy) {
    return sin * vx + cos * vy;
  }

  @Override
  public String toString() {
    return "Transform(x=" + x + ", y=" + y + ", cos=" + cos + ", sin=" + sin + ")";
  }
}
