package carom.physics.geometry;

import carom.physics.math.Aabb;
import carom.physics.math.Limits;
import carom.physics.math.Transform;
import java.util.ArrayList;
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
 *
 * <p>A chain may be a piece of a longer line, see {@link #pieces}.
 */
public final class Chain extends Shape {
  /**
   * Largest number of segments in a chain. A body has 1,024 parts at most, because the key of a
   * contact has 10 bits for each part. {@code carom.physics.ChainDef} makes longer lines of several
   * chains.
   */
  public static final int MAX_SEGMENTS = 1000;

  private final float[] xy;
  private final boolean loop;

  /**
   * Points beyond the open ends, to which the line goes on: that before the first, and in {@link
   * #after} that after the last.
   */
  private final float[] before;

  private final float[] after;
  private final List<Convex> parts;

  /** Makes a chain; the points beyond its ends are null if it ends there. */
  Chain(float[] xy, boolean loop, float[] before, float[] after) {
    this.xy = xy;
    this.loop = loop;
    this.before = before;
    this.after = after;
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
    Limits.notNull("xy", xy);
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
    new ChainCrossings(xy, loop).refuse();
    return new Chain(xy.clone(), loop, null, null);
  }

  /**
   * Cuts a long line into chains, each of which knows where the next one goes on. So bodies slide
   * over the cuts as over any other joint. {@code carom.physics.ChainDef} makes bodies of them.
   *
   * @param xy x0, y0, x1, y1, ... in metres, as for {@link #open} or {@link #loop}
   * @param loop whether the last point is joined to the first
   * @param cuts the first segment of each chain but the first one's, ascending, above 0
   * @return the chains, in the order of the points; none has more than {@value #MAX_SEGMENTS}
   *     segments
   * @throws IllegalArgumentException when the line crosses itself or turns back on itself, or a
   *     piece is empty or too long
   */
  public static List<Chain> pieces(float[] xy, boolean loop, int... cuts) {
    Limits.notNull("xy", xy);
    Limits.notNull("cuts", cuts);
    int points = xy.length / 2;
    int segments = loop ? points : points - 1;
    if (xy.length % 2 != 0 || segments < (loop ? 3 : 1)) {
      throw new IllegalArgumentException(
          "chain coordinates="
              + xy.length
              + " must be x and y of each of "
              + (loop ? 3 : 2)
              + " points or more");
    }
    if (cuts.length == 0) {
      return List.of(loop ? loop(xy) : open(xy));
    }
    new ChainCrossings(xy, loop).refuse();
    List<Chain> pieces = new ArrayList<>(cuts.length + 1);
    for (int i = 0; i <= cuts.length; i++) {
      int from = i == 0 ? 0 : cuts[i - 1];
      int to = i == cuts.length ? segments : cuts[i];
      if (to <= from || to - from > MAX_SEGMENTS) {
        throw new IllegalArgumentException(
            "chain piece="
                + i
                + " from segment "
                + from
                + " to "
                + to
                + " must have 1.."
                + MAX_SEGMENTS
                + " segments");
      }
      float[] piece = new float[2 * (to - from + 1)];
      for (int p = from; p <= to; p++) {
        piece[2 * (p - from)] = xy[2 * (p % points)];
        piece[2 * (p - from) + 1] = xy[2 * (p % points) + 1];
      }
      float[] before = loop || from > 0 ? point(xy, (from + points - 1) % points) : null;
      float[] after = loop || to < segments ? point(xy, (to + 1) % points) : null;
      pieces.add(new Chain(piece, false, before, after));
    }
    return pieces;
  }

  private static float[] point(float[] xy, int i) {
    return new float[] {xy[2 * i], xy[2 * i + 1]};
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
      boolean last = i + 1 == count;
      float[] beyondNext = !loop && last && after != null ? after : point(xy, (i + 2) % points);
      float[] beyondThis =
          !loop && i == 0 && before != null ? before : point(xy, (i + points - 1) % points);
      boolean[] linked = {loop || !last || after != null, loop || i > 0 || before != null};
      segments.add(
          new Segment(
              xy[2 * next],
              xy[2 * next + 1],
              xy[2 * i],
              xy[2 * i + 1],
              true,
              linked,
              new float[] {beyondNext[0], beyondThis[0]},
              new float[] {beyondNext[1], beyondThis[1]}));
    }
    return segments;
  }

  /**
   * Returns where the line goes on beyond the first point, in another chain.
   *
   * @return x and y, or null if it ends there
   */
  float[] before() {
    return before;
  }

  /** Returns where the line goes on beyond the last point, as {@link #before} does. */
  float[] after() {
    return after;
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
    Limits.index("point", index, pointCount());
    return xy[2 * index];
  }

  /** Returns the y of a point, metres. */
  public float pointY(int index) {
    Limits.index("point", index, pointCount());
    return xy[2 * index + 1];
  }

  /** Returns the segments, in the order of the points. */
  @Override
  public List<Convex> parts() {
    return parts;
  }

  @Override
  public void aabb(Transform t, Aabb out) {
    Limits.notNull("t", t);
    Limits.notNull("out", out);
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
    return new Chain(moved, loop, moved(before, dx, dy), moved(after, dx, dy));
  }

  private static float[] moved(float[] pointOrNull, float dx, float dy) {
    return pointOrNull == null ? null : new float[] {pointOrNull[0] + dx, pointOrNull[1] + dy};
  }

  @Override
  public String toString() {
    return "Chain(points=" + xy.length / 2 + ", loop=" + loop + ")";
  }
}
