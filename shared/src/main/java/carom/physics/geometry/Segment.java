package carom.physics.geometry;

import carom.physics.math.Limits;
import java.util.Arrays;

/**
 * A line between two points, without thickness and without mass. It is for bodies that forces don't
 * move. Bodies touch a segment from both sides, but a segment of a {@link Chain} only from the
 * front.
 *
 * <p>The vertices are the two ends. Edge 0 is the side to the right of the way from vertex 0 to 1,
 * and edge 1 is the other. The front of a one-sided segment is edge 0.
 */
public final class Segment extends Convex {
  private final boolean oneSided;
  private final boolean[] linked;
  private final float[] ghostX;
  private final float[] ghostY;

  /**
   * Creates a segment with two sides; all lengths in metres.
   *
   * @param x0 x of one end
   * @param y0 y of one end
   * @param x1 x of the other end, at least {@link Shape#MIN_SIZE} away
   * @param y1 y of the other end
   */
  public Segment(float x0, float y0, float x1, float y1) {
    this(x0, y0, x1, y1, false, new boolean[2], new float[2], new float[2]);
  }

  /**
   * Creates a segment of a chain. The arrays describe the neighbour at each vertex: whether there
   * is one, and its far end.
   */
  Segment(
      float x0,
      float y0,
      float x1,
      float y1,
      boolean oneSided,
      boolean[] linked,
      float[] ghostX,
      float[] ghostY) {
    super(
        new float[] {checkCoordinate("segment x0", x0), checkCoordinate("segment x1", x1)},
        new float[] {checkCoordinate("segment y0", y0), checkCoordinate("segment y1", y1)},
        pairNormal(y1 - y0, x0 - x1),
        pairNormal(x0 - x1, y0 - y1),
        false);
    this.oneSided = oneSided;
    this.linked = linked;
    this.ghostX = ghostX;
    this.ghostY = ghostY;
    checkSize("segment length", (float) lengthOf(0));
  }

  /** Returns whether bodies pass through from behind, as they do with a part of a {@link Chain}. */
  public boolean isOneSided() {
    return oneSided;
  }

  /** Returns whether the chain continues at vertex {@code end}, 0 or 1. */
  public boolean isLinked(int end) {
    return linked[Limits.index("end", end, 2)];
  }

  /**
   * Returns the x of the neighbour's far end, beyond vertex {@code end}. It is meaningful only
   * where linked.
   */
  public float ghostX(int end) {
    return ghostX[Limits.index("end", end, 2)];
  }

  /**
   * Returns the y of the neighbour's far end, beyond vertex {@code end}. It is meaningful only
   * where linked.
   */
  public float ghostY(int end) {
    return ghostY[Limits.index("end", end, 2)];
  }

  @Override
  public float radius() {
    return 0;
  }

  /** Returns zero, because a line covers nothing. */
  @Override
  public float area() {
    return 0;
  }

  /** Returns a mass and an inertia of zero for any density, with the middle as centre. */
  @Override
  public MassData mass(float density) {
    checkDensity(density);
    return new MassData(0, 0.5f * vx[0] + 0.5f * vx[1], 0.5f * vy[0] + 0.5f * vy[1], 0);
  }

  @Override
  public Segment moved(float dx, float dy) {
    return new Segment(
        vx[0] + dx,
        vy[0] + dy,
        vx[1] + dx,
        vy[1] + dy,
        oneSided,
        linked,
        new float[] {ghostX[0] + dx, ghostX[1] + dx},
        new float[] {ghostY[0] + dy, ghostY[1] + dy});
  }

  @Override
  public boolean isSame(Convex other) {
    return super.isSame(other)
        && other instanceof Segment s
        && oneSided == s.oneSided
        && Arrays.equals(linked, s.linked)
        && Arrays.equals(ghostX, s.ghostX)
        && Arrays.equals(ghostY, s.ghostY);
  }

  /** Returns true only for points exactly on the line. */
  @Override
  public boolean containsPoint(float x, float y) {
    return isWithin(x, y, 0);
  }

  @Override
  public String toString() {
    return "Segment(" + vx[0] + " " + vy[0] + ", " + vx[1] + " " + vy[1] + ")";
  }
}
