package carom.physics.geometry;

import java.util.Arrays;

/**
 * A line from one point to another, without thickness and without mass: for bodies that don't move
 * by forces. Bodies touch a segment from both sides, those of a {@link Chain} only from the front.
 *
 * <p>Vertices are the two ends; edge 0 is the side to the right of the way from vertex 0 to 1, edge
 * 1 the other. The front of a one-sided segment is edge 0.
 */
public final class Segment extends Convex {
  private final boolean oneSided;
  private final boolean[] linked;
  private final float[] ghostX;
  private final float[] ghostY;

  /**
   * Makes a segment with two sides; metres.
   *
   * @param x0 one end
   * @param y0 one end
   * @param x1 the other end, at least {@link Shape#MIN_SIZE} away
   * @param y1 the other end
   */
  public Segment(float x0, float y0, float x1, float y1) {
    this(x0, y0, x1, y1, false, new boolean[2], new float[2], new float[2]);
  }

  /** A link of a chain: what comes before vertex 0 and after vertex 1, where linked. */
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

  /** Returns whether bodies pass through it from behind: a part of a {@link Chain}. */
  public boolean isOneSided() {
    return oneSided;
  }

  /** Returns whether another segment of the chain goes on at vertex {@code end}, 0 or 1. */
  public boolean isLinked(int end) {
    return linked[end];
  }

  /** X of the neighbour's far end, beyond vertex {@code end}; meaningful where linked. */
  public float ghostX(int end) {
    return ghostX[end];
  }

  /** Y of the neighbour's far end, beyond vertex {@code end}; meaningful where linked. */
  public float ghostY(int end) {
    return ghostY[end];
  }

  @Override
  public float radius() {
    return 0;
  }

  /** Zero: a line covers nothing. */
  @Override
  public float area() {
    return 0;
  }

  /** Mass and inertia zero, whatever the density; the centre is the middle. */
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

  /** False nearly everywhere: only points exactly on the line are in it. */
  @Override
  public boolean containsPoint(float x, float y) {
    return isWithin(x, y, 0);
  }

  @Override
  public String toString() {
    return "Segment(" + vx[0] + " " + vy[0] + ", " + vx[1] + " " + vy[1] + ")";
  }
}
