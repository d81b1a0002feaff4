package carom.physics.collision;

import carom.physics.math.Limits;
import carom.physics.math.Transform;
import carom.physics.math.Trig;

/**
 * The motion of a frame during one time step. Its origin moves straight at constant speed, and it
 * turns at a constant rate. Mutable and reused.
 */
public final class Sweep {
  /** X of the origin at the start, metres. */
  public float x;

  /** Y of the origin at the start, metres. */
  public float y;

  /** Cosine of the angle at the start. */
  public float cos = 1;

  /** Sine of the angle at the start. */
  public float sin;

  /** Way of the origin along x, metres. */
  public float dx;

  /** Way of the origin along y, metres. */
  public float dy;

  /** Turn, radians, counter-clockwise; it may exceed a full turn. */
  public float angleRad;

  /** Makes a frame that rests at the origin. */
  public Sweep() {}

  /**
   * Sets a motion that starts at a pose and has constant velocities.
   *
   * @param start pose at the start; copied
   * @param dx way along x, metres
   * @param dy way along y, metres
   * @param angleRad turn, radians
   * @return this
   */
  public Sweep set(Transform start, float dx, float dy, float angleRad) {
    Limits.notNull("start", start);
    x = start.x;
    y = start.y;
    cos = start.cos;
    sin = start.sin;
    this.dx = dx;
    this.dy = dy;
    this.angleRad = angleRad;
    return this;
  }

  /**
   * Sets a motion from one pose to another that turns the shorter way round.
   *
   * @param start pose at the start; copied
   * @param end pose at the end; copied
   * @return this
   */
  public Sweep between(Transform start, Transform end) {
    Limits.notNull("start", start);
    Limits.notNull("end", end);
    float turn =
        Trig.atan2(
            start.cos * end.sin - start.sin * end.cos, start.cos * end.cos + start.sin * end.sin);
    return set(start, end.x - start.x, end.y - start.y, turn);
  }

  /**
   * Sets this to a stretch of another motion.
   *
   * @param whole the motion, another object than this
   * @param from where the stretch begins, 0 to 1
   * @param to where it ends, {@code from} to 1
   * @return this
   */
  public Sweep part(Sweep whole, float from, float to) {
    Limits.notNull("whole", whole);
    float turn = from * whole.angleRad;
    float c = Trig.cos(turn);
    float s = Trig.sin(turn);
    x = whole.x + from * whole.dx;
    y = whole.y + from * whole.dy;
    cos = whole.cos * c - whole.sin * s;
    sin = whole.sin * c + whole.cos * s;
    dx = (to - from) * whole.dx;
    dy = (to - from) * whole.dy;
    angleRad = (to - from) * whole.angleRad;
    return this;
  }

  /**
   * Copies another motion.
   *
   * @param other the motion to copy; not changed
   * @return this
   */
  public Sweep set(Sweep other) {
    Limits.notNull("other", other);
    x = other.x;
    y = other.y;
    cos = other.cos;
    sin = other.sin;
    dx = other.dx;
    dy = other.dy;
    angleRad = other.angleRad;
    return this;
  }

  /**
   * Computes the pose at a moment.
   *
   * @param fraction 0 at the start, 1 at the end
   * @param out receives the pose
   */
  public void at(float fraction, Transform out) {
    Limits.notNull("out", out);
    float turn = fraction * angleRad;
    float c = Trig.cos(turn);
    float s = Trig.sin(turn);
    out.set(x + fraction * dx, y + fraction * dy, cos * c - sin * s, sin * c + cos * s);
  }
}
