package carom.physics.collision.distance;

import carom.physics.math.Transform;
import carom.physics.math.Trig;

/**
 * The motion of a frame during one time step: straight and at constant speed for its origin, with a
 * constant rate of turn. Mutable and reused.
 */
public final class Sweep {
  /** Origin at the start, metres. */
  public float x;

  /** Origin at the start, metres. */
  public float y;

  /** Rotation at the start. */
  public float cos = 1;

  /** Rotation at the start. */
  public float sin;

  /** Way of the origin, metres. */
  public float dx;

  /** Way of the origin, metres. */
  public float dy;

  /** Turn, radians, counter-clockwise; more than a full turn is fine. */
  public float angleRad;

  /** Makes a frame that rests at the origin. */
  public Sweep() {}

  /**
   * Starts at a pose and moves with constant velocities.
   *
   * @param start pose at the start; copied
   * @param dx way along x, metres
   * @param dy way along y, metres
   * @param angleRad turn, radians
   * @return this
   */
  public Sweep set(Transform start, float dx, float dy, float angleRad) {
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
   * Moves from one pose to another, turning the shorter way round.
   *
   * @param start pose at the start; copied
   * @param end pose at the end; copied
   * @return this
   */
  public Sweep between(Transform start, Transform end) {
    float turn =
        Trig.atan2(
            start.cos * end.sin - start.sin * end.cos, start.cos * end.cos + start.sin * end.sin);
    return set(start, end.x - start.x, end.y - start.y, turn);
  }

  /**
   * A stretch of another motion.
   *
   * @param whole the motion, another object than this
   * @param from where the stretch begins, 0 to 1
   * @param to where it ends, {@code from} to 1
   * @return this
   */
  public Sweep part(Sweep whole, float from, float to) {
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
   * @param other stays as it is
   * @return this
   */
  public Sweep set(Sweep other) {
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
   * The pose at a moment.
   *
   * @param fraction 0 at the start, 1 at the end
   * @param out receives the pose
   */
  public void at(float fraction, Transform out) {
    float turn = fraction * angleRad;
    float c = Trig.cos(turn);
    float s = Trig.sin(turn);
    out.set(x + fraction * dx, y + fraction * dy, cos * c - sin * s, sin * c + cos * s);
  }
}
