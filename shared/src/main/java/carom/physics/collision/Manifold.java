package carom.physics.collision;

/**
 * The place at which two convex shapes A and B touch or are about to: one normal and up to two
 * points.
 *
 * <p>Points are in world axes but <b>relative to A's transform position</b>, so they stay exact far
 * from the world's origin and are A's lever arms when A's frame is centred at its mass. A point
 * lies midway between the two surfaces. Its separation is the distance between the surfaces along
 * the normal: positive for a gap, negative for overlap.
 *
 * <p>An id names the pair of vertices, (vertex of A) * 256 + (vertex of B), from which the point
 * comes; it stays the same while the same corners stay in touch, whichever shape lends the
 * reference face, and so carries impulses from tick to tick. The ids of one manifold differ.
 * Contacts with a circle have one point and id 0.
 *
 * <p>A point on a face is a corner of one shape on an edge of the other, and has two ids, one for
 * each end of that edge. It takes the one or the other, depending on which of the two edges at the
 * corner lies flatter on the face; at 45 degrees rounding decides. So each point tells its other
 * id, too. Mutable and reused; only the first {@link #count} points are meaningful.
 */
public final class Manifold {
  private static final int CROSSED0 = 1 << 16;
  private static final int CROSSED1 = 1 << 17;

  /** X of the unit normal from A to B, world axes; 0 when count is 0. */
  public float normalX;

  /** Y of the unit normal from A to B, world axes; 0 when count is 0. */
  public float normalY;

  /** Number of points: 0 (no contact), 1 or 2. */
  public int count;

  /** First point, x, metres from A's position. */
  public float x0;

  /** First point, y, metres from A's position. */
  public float y0;

  /** First point, separation in metres, negative when overlapping. */
  public float separation0;

  /** First point, feature id. */
  public int id0;

  /** Second point, x, metres from A's position. */
  public float x1;

  /** Second point, y, metres from A's position. */
  public float y1;

  /** Second point, separation in metres, negative when overlapping. */
  public float separation1;

  /** Second point, feature id. */
  public int id1;

  /** First point, its other id, or {@link #id0} if it has none. */
  public int otherId0;

  /** Second point, its other id, or {@link #id1} if it has none. */
  public int otherId1;

  /** Makes an empty manifold. */
  public Manifold() {}

  /** Removes the points and the normal: no contact. */
  public void clear() {
    set(0, 0, 0);
    setPoint0(0, 0, 0, 0);
    setPoint1(0, 0, 0, 0);
  }

  void set(float normalX, float normalY, int count) {
    this.normalX = normalX;
    this.normalY = normalY;
    this.count = count;
  }

  /** Sets the first point, which has one id. */
  void setPoint0(float x, float y, float separation, int id) {
    setPoint0(x, y, separation, id, id);
  }

  void setPoint0(float x, float y, float separation, int id, int otherId) {
    x0 = x;
    y0 = y;
    separation0 = separation;
    id0 = id;
    otherId0 = otherId;
  }

  /** Sets the second point, which has one id. */
  void setPoint1(float x, float y, float separation, int id) {
    setPoint1(x, y, separation, id, id);
  }

  void setPoint1(float x, float y, float separation, int id, int otherId) {
    x1 = x;
    y1 = y;
    separation1 = separation;
    id1 = id;
    otherId1 = otherId;
  }

  /**
   * Returns the smallest separation of the points, metres, or positive infinity if there is none.
   */
  public float minSeparation() {
    if (count == 0) {
      return Float.POSITIVE_INFINITY;
    }
    return count == 1 ? separation0 : Math.min(separation0, separation1);
  }

  /**
   * Returns the ids but for the first one in 18 bits, for {@link #setIds}. Of two points on a face,
   * each has as its other id A's vertex of one and B's of the other, one way or the other.
   */
  public int packedIds() {
    if (count < 2) {
      return otherId0;
    }
    int crossed = cross(id0, id1);
    return id1 + (otherId0 == crossed ? CROSSED0 : 0) + (otherId1 == crossed ? CROSSED1 : 0);
  }

  /** Sets all ids: the first one, and {@link #packedIds} of a manifold with as many points. */
  public void setIds(int first, int packed) {
    id0 = first;
    if (count < 2) {
      otherId0 = packed;
      return;
    }
    id1 = secondId(packed);
    int crossed = cross(id0, id1);
    int reverse = cross(id1, id0);
    otherId0 = (packed & CROSSED0) != 0 ? crossed : reverse;
    otherId1 = (packed & CROSSED1) != 0 ? crossed : reverse;
  }

  /** Returns the second point's id from {@link #packedIds} of two points. */
  public static int secondId(int packed) {
    return packed & 0xffff;
  }

  private static int cross(int ofA, int ofB) {
    return ofA & 0xff00 | ofB & 0xff;
  }

  /** Returns the id under which the same point appears if A and B are swapped. */
  public static int swappedId(int id) {
    return ((id & 0xff) << 8) | (id >>> 8);
  }

  /**
   * Returns the x of the one point of collision that stands for the manifold, metres from A's
   * position. The point is the mean of the overlapping points, weighted by their depth, or the
   * nearest point if none overlaps. It moves continuously as bodies rock, and is 0 if count is 0.
   */
  public float pointX() {
    return mix(x0, x1);
  }

  /** Returns the y of the point of collision, see {@link #pointX()}. */
  public float pointY() {
    return mix(y0, y1);
  }

  private float mix(float first, float second) {
    if (count < 2) {
      return count == 0 ? 0 : first;
    }
    float depth0 = Math.max(0, -separation0);
    float depth1 = Math.max(0, -separation1);
    float depth = depth0 + depth1;
    if (depth > 0) {
      return first + (second - first) * (depth1 / depth);
    }
    if (separation0 == separation1) {
      return 0.5f * (first + second);
    }
    return separation0 < separation1 ? first : second;
  }

  @Override
  public String toString() {
    StringBuilder text = new StringBuilder("Manifold(count=").append(count);
    if (count > 0) {
      text.append(", normal=").append(normalX).append(' ').append(normalY);
      text.append(", [").append(x0).append(' ').append(y0).append(" separation=");
      text.append(separation0).append(" id=").append(id0).append(']');
    }
    if (count > 1) {
      text.append(", [").append(x1).append(' ').append(y1).append(" separation=");
      text.append(separation1).append(" id=").append(id1).append(']');
    }
    return text.append(')').toString();
  }
}
