package carom.physics.geometry;

import carom.physics.math.Aabb;
import carom.physics.math.Transform;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;

/**
 * A line of segments that is solid from one side, for ground, walls or the inside of an arena. It
 * is for bodies that forces don't move.
 *
 * <p><b>The front is on the left</b> when walking along the points. Ground drawn from left to right
 * carries what is above it. A loop drawn counter-clockwise holds what is inside, and one drawn
 * clockwise keeps things out. Everything passes through from behind.
 *
 * <p>Each segment knows its neighbours. So bodies slide over the joints of flat or hollow ground
 * without catching on the next segment's end (no ghost collisions).
 */
public final class Chain extends Shape {
  /** Largest number of segments in a chain. Use several chains for more. */
  public static final int MAX_SEGMENTS = 1000;

  private final float[] xy;
  private final boolean loop;
  private final List<Convex> parts;

  private Chain(float[] xy, boolean loop) {
    this.xy = xy;
    this.loop = loop;
    parts = Collections.unmodifiableList(segments());
  }

  /**
   * Creates an open chain.
   *
   * @param xy x0, y0, x1, y1, ... in metres, 2 points or more, neighbours at least {@link
   *     Shape#MIN_SIZE} apart
   * @throws IllegalArgumentException when the chain crosses itself or turns back on itself
   */
  public static Chain open(float... xy) {
    return make(xy, false, 2);
  }

  /**
   * Creates a closed chain, whose last segment leads back to the first point.
   *
   * @param xy x0, y0, x1, y1, ... in metres, 3 points or more, the first not repeated
   * @throws IllegalArgumentException when the chain crosses itself or turns back on itself
   */
  public static Chain loop(float... xy) {
    return make(xy, true, 3);
  }

  private static Chain make(float[] xy, boolean loop, int least) {
    int points = xy.length / 2;
    int most = loop ? MAX_SEGMENTS : MAX_SEGMENTS + 1;
    if (xy.length % 2 != 0) {
      throw new IllegalArgumentException(
          "chain coordinates=" + xy.length + " must be even: x and y of each point");
    }
    if (points < least || points > most) {
      throw new IllegalArgumentException(
          "chain points=" + points + " must be in " + least + ".." + most);
    }
    Chain chain = new Chain(xy.clone(), loop);
    chain.refuseCrossings();
    return chain;
  }

  private void refuseCrossings() {
    int points = xy.length / 2;
    int count = parts.size();
    for (int i = 0; i < count; i++) {
      int next = i + 1 < count || loop ? (i + 1) % count : i;
      int middle = (i + 1) % points;
      int after = (i + 2) % points;
      if (next != i && side(i, middle, after) == 0 && ahead(i, middle, after) < 0) {
        throw new IllegalArgumentException(
            "chain segment=" + next + " turns back on segment=" + i + "; leave a gap between them");
      }
    }
    // Only segments that overlap along the longer axis can cross, and on a line of ground few do.
    int axis = extent(0) >= extent(1) ? 0 : 1;
    long[] byLowEnd = new long[count];
    for (int i = 0; i < count; i++) {
      int bits = Float.floatToIntBits(low(i, axis) + 0f); // turns minus zero into zero
      byLowEnd[i] = (long) (bits ^ (bits >> 31 & Integer.MAX_VALUE)) << 32 | i;
    }
    Arrays.sort(byLowEnd);
    for (int k = 0; k < count; k++) {
      int i = (int) byLowEnd[k];
      float end = high(i, axis);
      for (int l = k + 1; l < count && low((int) byLowEnd[l], axis) <= end; l++) {
        int j = (int) byLowEnd[l];
        if (low(i, 1 - axis) <= high(j, 1 - axis) && low(j, 1 - axis) <= high(i, 1 - axis)) {
          refuseCrossing(Math.min(i, j), Math.max(i, j));
        }
      }
    }
  }

  private void refuseCrossing(int i, int j) {
    int points = xy.length / 2;
    int middle = (i + 1) % points;
    int end = (j + 1) % points;
    if (j > i + 1
        && side(i, middle, j) * side(i, middle, end) < 0
        && side(j, end, i) * side(j, end, middle) < 0) {
      throw new IllegalArgumentException(
          "chain segment=" + i + " crosses segment=" + j + "; make it two chains");
    }
  }

  private float low(int segment, int axis) {
    int next = (segment + 1) % (xy.length / 2);
    return Math.min(xy[2 * segment + axis], xy[2 * next + axis]);
  }

  private float high(int segment, int axis) {
    int next = (segment + 1) % (xy.length / 2);
    return Math.max(xy[2 * segment + axis], xy[2 * next + axis]);
  }

  /** Returns the extent of the points along an axis, metres. */
  private float extent(int axis) {
    float least = Float.POSITIVE_INFINITY;
    float most = Float.NEGATIVE_INFINITY;
    for (int at = axis; at < xy.length; at += 2) {
      least = Math.min(least, xy[at]);
      most = Math.max(most, xy[at]);
    }
    return most - least;
  }

  /**
   * Returns a positive number if a point is to the left of the line through two others, and a
   * negative one if it is to the right.
   */
  private double side(int from, int to, int point) {
    double ux = (double) xy[2 * to] - xy[2 * from];
    double uy = (double) xy[2 * to + 1] - xy[2 * from + 1];
    double px = (double) xy[2 * point] - xy[2 * from];
    double py = (double) xy[2 * point + 1] - xy[2 * from + 1];
    return Math.signum(ux * py - uy * px);
  }

  /**
   * Returns a positive number if the way from a middle point leads on, and a negative one if it
   * leads back.
   */
  private double ahead(int from, int middle, int to) {
    double ux = (double) xy[2 * middle] - xy[2 * from];
    double uy = (double) xy[2 * middle + 1] - xy[2 * from + 1];
    double px = (double) xy[2 * to] - xy[2 * middle];
    double py = (double) xy[2 * to + 1] - xy[2 * middle + 1];
    return ux * px + uy * py;
  }

  /**
   * Returns the segments. They run against the points, so that their front, which is on the right,
   * is the chain's left.
   */
  private List<Convex> segments() {
    int points = xy.length / 2;
    int count = loop ? points : points - 1;
    List<Convex> segments = new ArrayList<>(count);
    for (int i = 0; i < count; i++) {
      int next = (i + 1) % points;
      int after = (i + 2) % points;
      int before = (i + points - 1) % points;
      boolean[] linked = {loop || i + 2 < points, loop || i > 0};
      segments.add(
          new Segment(
              xy[2 * next],
              xy[2 * next + 1],
              xy[2 * i],
              xy[2 * i + 1],
              true,
              linked,
              new float[] {xy[2 * after], xy[2 * before]},
              new float[] {xy[2 * after + 1], xy[2 * before + 1]}));
    }
    return segments;
  }

  /** Returns whether the last point is joined to the first. */
  public boolean isLoop() {
    return loop;
  }

  /** Returns the number of points. */
  public int pointCount() {
    return xy.length / 2;
  }

  /** Returns the x of a point, metres. */
  public float pointX(int index) {
    return xy[2 * index];
  }

  /** Returns the y of a point, metres. */
  public float pointY(int index) {
    return xy[2 * index + 1];
  }

  /** Returns the segments, in the order of the points. */
  @Override
  public List<Convex> parts() {
    return parts;
  }

  @Override
  public void aabb(Transform t, Aabb out) {
    out.setEmpty();
    for (int i = 0; i < xy.length; i += 2) {
      out.add(t.worldX(xy[i], xy[i + 1]), t.worldY(xy[i], xy[i + 1]));
    }
  }

  /**
   * Returns zero, because a line covers nothing. A loop is a border and not the area it encloses.
   */
  @Override
  public float area() {
    return 0;
  }

  /**
   * Returns a mass and an inertia of zero for any density, with the mean of the points as centre.
   */
  @Override
  public MassData mass(float density) {
    checkDensity(density);
    double x = 0;
    double y = 0;
    for (int i = 0; i < xy.length; i += 2) {
      x += xy[i];
      y += xy[i + 1];
    }
    int points = xy.length / 2;
    return new MassData(0, (float) (x / points), (float) (y / points), 0);
  }

  @Override
  public Chain moved(float dx, float dy) {
    float[] moved = xy.clone();
    for (int i = 0; i < moved.length; i += 2) {
      moved[i] += dx;
      moved[i + 1] += dy;
    }
    return new Chain(moved, loop);
  }

  @Override
  public String toString() {
    return "Chain(points=" + xy.length / 2 + ", loop=" + loop + ")";
  }
}
