package carom.physics.geometry;

import carom.physics.math.Aabb;
import carom.physics.math.Limits;
import carom.physics.math.Transform;
import java.util.List;

/**
 * A solid region of the plane in its body's frame: one {@link Convex} shape, a {@link Compound} of
 * several, or a {@link Chain} of lines.
 *
 * <p>Lengths are metres. Shapes are immutable and validated on creation: coordinates are finite and
 * at most {@link #MAX_SIZE} from the frame's origin, and nothing is thinner than {@link #MIN_SIZE}.
 * An invalid shape throws an {@link IllegalArgumentException} that names value and limit. Float
 * arithmetic is good between these bounds, and best for shapes of 0.1 to 100 m.
 */
public abstract sealed class Shape permits Convex, Compound, Chain {
  /**
   * Smallest radius, half extent, or width of a polygon, metres. Below it, contact tolerances would
   * be larger than the shapes.
   */
  public static final float MIN_SIZE = 1e-3f;

  /**
   * Largest radius, half extent, or coordinate, metres. Above it, neighbouring floats are more than
   * 8 mm apart.
   */
  public static final float MAX_SIZE = 1e5f;

  Shape() {}

  /**
   * Returns the convex parts of this shape in a fixed order. A convex shape is its own only part.
   * The list is unmodifiable, and the call allocates nothing.
   */
  public abstract List<Convex> parts();

  /**
   * Computes the tight bounding box of this shape in a pose.
   *
   * @param t pose that takes the shape's frame to the world, read only
   * @param out receives the box
   */
  public abstract void aabb(Transform t, Aabb out);

  /**
   * Returns the area in m&sup2;, or 0 for lines. Overlapping parts of a compound each count in
   * full.
   */
  public abstract float area();

  /**
   * Returns mass, centre of mass and moment of inertia about the centre of mass, for a uniform
   * density. It computes in double precision from exact formulas and allocates the result.
   *
   * @param density kg/m&sup2;, finite and not negative; 0 gives mass 0 and the centroid of the area
   */
  public abstract MassData mass(float density);

  /**
   * Returns this shape translated in its frame. Vertex order, edge order and normals stay as they
   * are, and so do feature ids.
   *
   * @param dx translation along x, metres
   * @param dy translation along y, metres
   */
  public abstract Shape moved(float dx, float dy);

  /**
   * Returns true if the point (x, y) of the shape's own frame is inside or on the border. For
   * lines, the point must be on one of them.
   */
  public boolean containsPoint(float x, float y) {
    List<Convex> parts = parts();
    for (int i = 0; i < parts.size(); i++) {
      if (parts.get(i).containsPoint(x, y)) {
        return true;
      }
    }
    return false;
  }

  /**
   * Returns true if the world point (x, y) is inside or on the border of this shape in pose {@code
   * t}.
   */
  public final boolean containsPoint(Transform t, float x, float y) {
    Limits.notNull("t", t);
    return containsPoint(t.localX(x, y), t.localY(x, y));
  }

  /**
   * Returns the distance from the frame's origin to the farthest point of the shape, metres. No
   * rotation reaches beyond it.
   */
  public float reach() {
    List<Convex> parts = parts();
    float reach = 0;
    for (int i = 0; i < parts.size(); i++) {
      reach = Math.max(reach, parts.get(i).reach());
    }
    return reach;
  }

  static float checkSize(String what, float value) {
    if (!(value >= MIN_SIZE && value <= MAX_SIZE)) {
      throw new IllegalArgumentException(
          what + "=" + value + " must be in " + MIN_SIZE + ".." + MAX_SIZE + " m");
    }
    return value;
  }

  static float checkCoordinate(String what, float value) {
    if (!(Math.abs(value) <= MAX_SIZE)) {
      throw new IllegalArgumentException(
          what + "=" + value + " must be a number in -" + MAX_SIZE + ".." + MAX_SIZE + " m");
    }
    return value;
  }

  /** Does so for one of many coordinates, whose name is put together only if it is refused. */
  static float checkCoordinate(String what, int number, float value) {
    return Math.abs(value) <= MAX_SIZE ? value : checkCoordinate(what + number, value);
  }

  static float checkDensity(float density) {
    if (!(density >= 0 && density <= Float.MAX_VALUE)) {
      throw new IllegalArgumentException(
          "density="
              + density
              + " must be finite and >= 0 kg/m^2; make the body static for no mass");
    }
    return density;
  }
}
