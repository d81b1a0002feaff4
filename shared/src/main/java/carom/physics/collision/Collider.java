package carom.physics.collision;

import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Convex;
import carom.physics.math.Limits;
import carom.physics.math.Transform;

/**
 * Computes contact manifolds. An instance holds scratch memory, so use one per thread; no call
 * allocates.
 *
 * <h2>Polygons</h2>
 *
 * <p>All work happens in A's frame, so precision depends on the distance of the two bodies and not
 * on where in the world they are. The separating axis theorem picks the face of least overlap (or
 * widest gap) of either shape as reference; the opposite edge of the other shape is clipped to the
 * reference face's side planes, and the two ends are the contact points.
 *
 * <pre>
 *        w1 +--------------+ w2          incident edge of the other shape, runs against the reference edge
 *           |              |
 *   v2 +----|--------------|----+ v1     reference edge, normal n up; the points are (v2 with w1) and (v1 with w2)
 * </pre>
 *
 * <p>Each point is named by one vertex of either shape, which stays the same when a body slides or
 * when the other shape lends the reference face. In overlap A's face is preferred unless B's is
 * better by a clear margin (hysteresis without memory), so resting boxes do not flip between nearly
 * equal faces.
 *
 * <p>With a gap the closest points may be two vertices. Then there is one point, the normal is the
 * direction between them, and the separation is their distance: a face normal there would stop
 * bodies that are about to pass each other.
 *
 * <h2>Degenerate cases</h2>
 *
 * Centres of two circles coincide: the normal is (0, 1), world axes. Centre of a circle on an edge,
 * on a vertex, or inside a polygon: the normal of the edge of least overlap, of equal ones the one
 * with the lowest index. Polygons with equally good faces: A's face of lowest index.
 *
 * <h2>Capsules, segments, rounded polygons</h2>
 *
 * These shapes get the same kinds of contacts by another method: the shapes without their rounding
 * are measured, then the radii are subtracted. A capsule lying on a flat has two points. A segment
 * of a chain touches only what is in front of it, and at joints that aren't outward corners with
 * its own normal only; the point of a circle has id 0 here, too.
 *
 * <p>Round shapes and pairs of boxes have classes of their own: {@link RoundCollider}, {@link
 * BoxCollider}.
 */
public final class Collider {
  /**
   * Gap, metres, up to which the direction between two vertices is not trusted and a face normal
   * serves.
   */
  public static final float TOUCHING = 1e-5f;

  /**
   * Margin, metres, by which B's face must be better to be preferred to A's while shapes overlap.
   * The smaller of this and the {@link #RELATIVE_FACE_BIAS} counts.
   */
  public static final float FACE_BIAS = 5e-4f;

  /**
   * Margin by which B's face must be better, as a fraction of the smaller shape's first edge. It
   * replaces {@link #FACE_BIAS} if it is less, because shapes may be tiny.
   */
  public static final float RELATIVE_FACE_BIAS = 0.01f;

  /**
   * Difference, as a fraction of the boxes' half sizes, up to which the faces of two boxes are
   * equally good.
   */
  public static final float BOX_ROUNDING = 1e-6f;

  /** Number of bits of a vertex or edge in a hint. */
  private static final int HINT_BITS = 8;

  private static final int HINT_MASK = (1 << HINT_BITS) - 1;

  private final float[] ax = new float[Convex.MAX_VERTICES];
  private final float[] ay = new float[Convex.MAX_VERTICES];
  private final float[] bx = new float[Convex.MAX_VERTICES];
  private final float[] by = new float[Convex.MAX_VERTICES];
  private final float[] bnx = new float[Convex.MAX_VERTICES];
  private final float[] bny = new float[Convex.MAX_VERTICES];

  private final RoundCollider round = new RoundCollider();
  private final BoxCollider box = new BoxCollider();

  // Results of the last search for a face.
  private float faceSeparation;
  private int faceEdge;
  private int faceSupport;

  private int hint;
  private float gap;
  private boolean ofB;
  private boolean ofCorners;

  /** Makes a collider with its own scratch memory. */
  public Collider() {}

  /**
   * Finds where two convex shapes touch, or nearly do. Swapping A and B gives the same contact with
   * reversed normal, points relative to the other body and {@link Manifold#swappedId swapped ids},
   * up to rounding and, in overlap, to the preference for A's face.
   *
   * @param a shape A in its body's frame
   * @param ta pose of A, read only, finite
   * @param b shape B in its body's frame
   * @param tb pose of B, read only, finite
   * @param speculativeDistance points up to this far apart are reported too, metres, not negative
   * @param out receives the manifold; count 0 when the shapes are farther apart
   */
  public void collide(
      Convex a, Transform ta, Convex b, Transform tb, float speculativeDistance, Manifold out) {
    collide(a, ta, b, tb, speculativeDistance, 0, out);
  }

  /**
   * Finds where two convex shapes touch, or nearly do, starting from a hint. It is faster for
   * polygons if the hint is where the last search for the same shapes in nearly the same poses
   * ended.
   *
   * @param a shape A in its body's frame
   * @param ta pose of A, read only, finite
   * @param b shape B in its body's frame
   * @param tb pose of B, read only, finite
   * @param speculativeDistance points up to this far apart are reported too, metres, not negative
   * @param startAt the {@link #hint} after that search, or 0 if unknown; no bit of the result
   *     depends on it
   * @param out receives the manifold; count 0 when the shapes are farther apart
   */
  public void collide(
      Convex a,
      Transform ta,
      Convex b,
      Transform tb,
      float speculativeDistance,
      int startAt,
      Manifold out) {
    Core.checkPair(a, ta, b, tb);
    Limits.notNull("out", out);
    hint = startAt;
    ofCorners = false;
    if (!(a.isSimple() && b.isSimple())) {
      round.collide(a, ta, b, tb, speculativeDistance, out);
      gap = round.gap();
    } else if (a instanceof Circle circleA) {
      if (b instanceof Circle circleB) {
        circles(circleA, ta, circleB, tb, speculativeDistance, out);
      } else {
        polygonCircle(b, tb, circleA, ta, speculativeDistance, out);
        flip(ta, tb, out);
      }
    } else if (b instanceof Circle circleB) {
      polygonCircle(a, ta, circleB, tb, speculativeDistance, out);
    } else if (a instanceof Box boxA && b instanceof Box boxB) {
      box.collide(boxA, ta, boxB, tb, speculativeDistance, out);
      gap = box.gap();
      ofB = box.ofB();
      ofCorners = box.ofCorners();
    } else {
      polygons(a, ta, b, tb, speculativeDistance, out);
    }
  }

  /**
   * Returns where the last search ended: the best edges of A and of B and the vertices opposite.
   * Any of them may be out of range for other shapes.
   *
   * @return a hint to pass to {@code collide} for the same pair
   */
  public int hint() {
    return hint;
  }

  /**
   * Returns how far apart the last two shapes are at least, if they have no contact point.
   *
   * @return m, measured along the normal of some face or between the closest points; may be below
   *     the speculative distance if a corner decided, or because a one-sided segment lets the other
   *     pass; meaningless for two discs
   */
  public float gap() {
    return gap;
  }

  /**
   * Returns whether the normal of the last manifold belongs to a face of B. It is valid for two
   * polygons with contact points.
   *
   * @return true for B, false for A; meaningless if a shape was round
   */
  public boolean ofB() {
    return ofB;
  }

  /**
   * Returns whether the normal of the last manifold is the direction between two corners that are
   * apart. It is valid for two polygons with a contact point, whose id names the corners.
   *
   * @return false if the normal is that of a face; meaningless if a shape was round
   */
  public boolean ofCorners() {
    return ofCorners;
  }

  /** Returns one of the four numbers in a hint, or 0 if there is no such vertex. */
  private static int hinted(int hint, int place, int count) {
    int index = hint >>> place * HINT_BITS & HINT_MASK;
    return index < count ? index : 0;
  }

  private static void circles(
      Circle a, Transform ta, Circle b, Transform tb, float speculative, Manifold out) {
    float fromX = ta.rotateX(a.centerX(), a.centerY());
    float fromY = ta.rotateY(a.centerX(), a.centerY());
    float dx = (tb.x - ta.x) + tb.rotateX(b.centerX(), b.centerY()) - fromX;
    float dy = (tb.y - ta.y) + tb.rotateY(b.centerX(), b.centerY()) - fromY;
    float distance = length(dx, dy);
    float separation = distance - a.radius() - b.radius();
    if (!(separation <= speculative)) {
      out.clear();
      return;
    }
    float nx = 0;
    float ny = 1;
    if (distance > 0) {
      nx = dx / distance;
      ny = dy / distance;
    }
    float middle = a.radius() + 0.5f * separation;
    out.set(nx, ny, 1);
    out.setPoint0(fromX + middle * nx, fromY + middle * ny, separation, 0);
  }

  /** Computes the manifold of polygon A and circle B. */
  private void polygonCircle(
      Convex a, Transform ta, Circle b, Transform tb, float speculative, Manifold out) {
    float worldX = (tb.x - ta.x) + tb.rotateX(b.centerX(), b.centerY());
    float worldY = (tb.y - ta.y) + tb.rotateY(b.centerX(), b.centerY());
    float cx = ta.cos * worldX + ta.sin * worldY;
    float cy = ta.cos * worldY - ta.sin * worldX;
    float radius = b.radius();
    float best = a instanceof Box box ? faceOfBox(box, cx, cy) : faceNearest(a, cx, cy);
    gap = best - radius;
    if (!(gap <= speculative)) {
      out.clear();
      return;
    }
    int edge = faceEdge;
    float nx = a.normalX(edge);
    float ny = a.normalY(edge);
    float distance = best;
    if (best > 0) {
      int next = edge + 1 == a.vertexCount() ? 0 : edge + 1;
      int corner = -1;
      // Along the edge, counter-clockwise, is (-ny, nx).
      if (nx * (cy - a.vertexY(edge)) - ny * (cx - a.vertexX(edge)) < 0) {
        corner = edge;
      } else if (nx * (cy - a.vertexY(next)) - ny * (cx - a.vertexX(next)) > 0) {
        corner = next;
      }
      if (corner >= 0) {
        float dx = cx - a.vertexX(corner);
        float dy = cy - a.vertexY(corner);
        distance = length(dx, dy);
        nx = dx / distance;
        ny = dy / distance;
      }
    }
    gap = distance - radius;
    if (!(gap <= speculative)) {
      out.clear();
      return;
    }
    float back = 0.5f * (distance + radius);
    float px = cx - back * nx;
    float py = cy - back * ny;
    out.set(ta.rotateX(nx, ny), ta.rotateY(nx, ny), 1);
    out.setPoint0(ta.rotateX(px, py), ta.rotateY(px, py), gap, 0);
  }

  /**
   * Returns how far a point is above the face of a polygon that it is furthest above. Of equal
   * faces it takes the one of lowest index. The search starts at the hint.
   */
  private float faceNearest(Convex a, float x, float y) {
    int count = a.vertexCount();
    int edge = hinted(hint, 0, count);
    float best = a.normalX(edge) * (x - a.vertexX(edge)) + a.normalY(edge) * (y - a.vertexY(edge));
    int i = edge;
    for (int left = count; left > 1; left--) {
      i = i + 1 == count ? 0 : i + 1;
      float s = a.normalX(i) * (x - a.vertexX(i)) + a.normalY(i) * (y - a.vertexY(i));
      if (s >= best && (s > best || i < edge)) {
        best = s;
        edge = i;
      }
    }
    hint = edge;
    faceEdge = edge;
    return best;
  }

  /** Returns for a box, without branches, what {@link #faceNearest} returns, bit for bit. */
  private float faceOfBox(Box a, float x, float y) {
    float below = a.vertexY(0) - y;
    float right = x - a.vertexX(2);
    float above = y - a.vertexY(2);
    float left = a.vertexX(0) - x;
    float first = Math.max(below, right);
    float second = Math.max(above, left);
    // Later faces only win if they are strictly better.
    int early = choose(sign(below - right), 1, 0);
    int late = choose(sign(above - left), 3, 2);
    faceEdge = choose(sign(first - second), late, early);
    return Math.max(first, second);
  }

  /** Turns a manifold of (B, A) into that of (A, B). */
  private static void flip(Transform ta, Transform tb, Manifold out) {
    if (out.count > 0) {
      out.normalX = -out.normalX;
      out.normalY = -out.normalY;
      out.x0 += tb.x - ta.x;
      out.y0 += tb.y - ta.y;
    }
  }

  /**
   * Sets one point for two vertices, p of A and q of B, that face each other. With a gap, normal
   * and separation are their direction and distance; else they are those of the given face, from A
   * to B.
   *
   * @return whether the normal is their direction
   */
  static boolean cornerPoint(
      float px,
      float py,
      float qx,
      float qy,
      float faceSeparation,
      float nx,
      float ny,
      int id,
      float speculative,
      Manifold out) {
    float separation = faceSeparation;
    float x = nx;
    float y = ny;
    boolean apart = faceSeparation > TOUCHING;
    if (apart) {
      float dx = qx - px;
      float dy = qy - py;
      separation = length(dx, dy);
      x = dx / separation;
      y = dy / separation;
    }
    if (!(separation <= speculative)) {
      out.clear();
      return false;
    }
    out.set(x, y, 1);
    out.setPoint0(0.5f * (px + qx), 0.5f * (py + qy), separation, id);
    return apart;
  }

  /**
   * Computes the manifold of two polygons: moves B into A's frame, finds the best face of each, and
   * clips against the better one.
   */
  private void polygons(
      Convex a, Transform ta, Convex b, Transform tb, float speculative, Manifold out) {
    float worldX = tb.x - ta.x;
    float worldY = tb.y - ta.y;
    float x = ta.cos * worldX + ta.sin * worldY;
    float y = ta.cos * worldY - ta.sin * worldX;
    float cos = ta.cos * tb.cos + ta.sin * tb.sin;
    float sin = ta.cos * tb.sin - ta.sin * tb.cos;
    int countA = a.vertexCount();
    int countB = b.vertexCount();
    for (int i = 0; i < countB; i++) {
      float vx = b.vertexX(i);
      float vy = b.vertexY(i);
      bx[i] = cos * vx - sin * vy + x;
      by[i] = sin * vx + cos * vy + y;
    }
    int start = hint;
    faceOfA(a, countA, countB, hinted(start, 0, countA), hinted(start, 1, countB), speculative);
    float separationA = faceSeparation;
    int edgeA = faceEdge;
    int supportB = faceSupport;
    hint = start & ~0xffff | supportB << HINT_BITS | edgeA;
    gap = separationA;
    if (!(separationA <= speculative)) {
      out.clear();
      return;
    }
    for (int i = 0; i < countB; i++) {
      float nx = b.normalX(i);
      float ny = b.normalY(i);
      bnx[i] = cos * nx - sin * ny;
      bny[i] = sin * nx + cos * ny;
    }
    faceOfB(a, countA, countB, hinted(start, 2, countB), hinted(start, 3, countA), speculative);
    hint = hint & 0xffff | faceSupport << 3 * HINT_BITS | faceEdge << 2 * HINT_BITS;
    gap = Math.max(separationA, faceSeparation);
    if (!(faceSeparation <= speculative)) {
      out.clear();
      return;
    }
    float bias = 0;
    if (faceSeparation <= TOUCHING) {
      float edge = Math.min(firstEdge(a), firstEdge(bx, by));
      bias = faceBias(edge);
    }
    ofB = faceSeparation > separationA + bias;
    if (ofB) {
      int edge = faceEdge;
      float nx = bnx[edge];
      float ny = bny[edge];
      int facing = facing(a, countA, faceSupport, nx, ny);
      int after = facing + 1 == countA ? 0 : facing + 1;
      ax[facing] = a.vertexX(facing);
      ay[facing] = a.vertexY(facing);
      ax[after] = a.vertexX(after);
      ay[after] = a.vertexY(after);
      clip(
          bx,
          by,
          edge,
          edge + 1 == countB ? 0 : edge + 1,
          nx,
          ny,
          ax,
          ay,
          facing,
          after,
          faceSeparation,
          true,
          speculative,
          out);
    } else {
      float nx = a.normalX(edgeA);
      float ny = a.normalY(edgeA);
      int facing = facing(bnx, bny, countB, supportB, nx, ny);
      int after = edgeA + 1 == countA ? 0 : edgeA + 1;
      ax[edgeA] = a.vertexX(edgeA);
      ay[edgeA] = a.vertexY(edgeA);
      ax[after] = a.vertexX(after);
      ay[after] = a.vertexY(after);
      clip(
          ax,
          ay,
          edgeA,
          after,
          nx,
          ny,
          bx,
          by,
          facing,
          facing + 1 == countB ? 0 : facing + 1,
          separationA,
          false,
          speculative,
          out);
    }
    if (out.count > 0) {
      toWorldAxes(ta, out);
    }
  }

  /**
   * Returns the margin by which B's face must be better, m, given the length of the smaller first
   * edge, m.
   */
  static float faceBias(float firstEdge) {
    return Math.min(FACE_BIAS, RELATIVE_FACE_BIAS * firstEdge);
  }

  private static float firstEdge(Convex a) {
    return Math.abs(a.vertexX(1) - a.vertexX(0)) + Math.abs(a.vertexY(1) - a.vertexY(0));
  }

  private static float firstEdge(float[] xs, float[] ys) {
    return Math.abs(xs[1] - xs[0]) + Math.abs(ys[1] - ys[0]);
  }

  /**
   * Finds the face of A with the largest separation from B. A face's separation is the smallest
   * height of a vertex of B above it. Of equal faces it takes the one of lowest index. Any face
   * with a separation above the speculative distance ends the search.
   *
   * <p>The search starts at the hint and goes around from there. A face can't win if B's lowest
   * vertex above the best face is at a smaller height above it. So mostly one vertex decides, and
   * branches hardly ever go another way than before.
   */
  private void faceOfA(
      Convex a, int countA, int countB, int startEdge, int startSupport, float speculative) {
    int edge = startEdge;
    float best = lowestOfB(a, edge, countB, startSupport);
    int support = faceSupport;
    int i = edge;
    for (int left = countA; left > 1 && best <= speculative; left--) {
      i = i + 1 == countA ? 0 : i + 1;
      float bound =
          a.normalX(i) * (bx[support] - a.vertexX(i)) + a.normalY(i) * (by[support] - a.vertexY(i));
      if (bound >= best) {
        float low = lowestOfB(a, i, countB, support);
        if (low > best || (low == best && i < edge)) {
          best = low;
          edge = i;
          support = faceSupport;
        }
      }
    }
    faceSeparation = best;
    faceEdge = edge;
    faceSupport = support;
  }

  /**
   * Returns how far B's lowest vertex is above a face of A. Of equally low vertices it takes the
   * one of lowest index.
   */
  private float lowestOfB(Convex a, int edge, int countB, int start) {
    float nx = a.normalX(edge);
    float ny = a.normalY(edge);
    float vx = a.vertexX(edge);
    float vy = a.vertexY(edge);
    int lowest = start;
    float low = nx * (bx[start] - vx) + ny * (by[start] - vy);
    int j = start;
    for (int left = countB; left > 1; left--) {
      j = j + 1 == countB ? 0 : j + 1;
      float s = nx * (bx[j] - vx) + ny * (by[j] - vy);
      if (s <= low && (s < low || j < lowest)) {
        low = s;
        lowest = j;
      }
    }
    faceSupport = lowest;
    return low;
  }

  /** Finds the face of B with the largest separation from A, as {@link #faceOfA} does for A. */
  private void faceOfB(
      Convex a, int countA, int countB, int startEdge, int startSupport, float speculative) {
    int edge = startEdge;
    float best = lowestOfA(a, edge, countA, startSupport);
    int support = faceSupport;
    int i = edge;
    for (int left = countB; left > 1 && best <= speculative; left--) {
      i = i + 1 == countB ? 0 : i + 1;
      float bound = bnx[i] * (a.vertexX(support) - bx[i]) + bny[i] * (a.vertexY(support) - by[i]);
      if (bound >= best) {
        float low = lowestOfA(a, i, countA, support);
        if (low > best || (low == best && i < edge)) {
          best = low;
          edge = i;
          support = faceSupport;
        }
      }
    }
    faceSeparation = best;
    faceEdge = edge;
    faceSupport = support;
  }

  /** Returns how far A's lowest vertex is above a face of B. */
  private float lowestOfA(Convex a, int edge, int countA, int start) {
    float nx = bnx[edge];
    float ny = bny[edge];
    float vx = bx[edge];
    float vy = by[edge];
    int lowest = start;
    float low = nx * (a.vertexX(start) - vx) + ny * (a.vertexY(start) - vy);
    int j = start;
    for (int left = countA; left > 1; left--) {
      j = j + 1 == countA ? 0 : j + 1;
      float s = nx * (a.vertexX(j) - vx) + ny * (a.vertexY(j) - vy);
      if (s <= low && (s < low || j < lowest)) {
        low = s;
        lowest = j;
      }
    }
    faceSupport = lowest;
    return low;
  }

  /**
   * Returns a mask with all bits set if a number is below zero or minus zero, else with none. Boxes
   * use such masks for decisions, because an unpredictable branch costs more than computing both
   * choices.
   */
  static int sign(float value) {
    return Float.floatToRawIntBits(value) >> 31;
  }

  static int choose(int mask, int ifSet, int otherwise) {
    return ifSet & mask | otherwise & ~mask;
  }

  private static int facing(Convex a, int count, int support, float nx, float ny) {
    int before = support == 0 ? count - 1 : support - 1;
    float against = a.normalX(support) * nx + a.normalY(support) * ny;
    return a.normalX(before) * nx + a.normalY(before) * ny < against ? before : support;
  }

  /** Returns the one of the two edges at the support vertex whose normal opposes n more. */
  private static int facing(float[] nxs, float[] nys, int count, int support, float nx, float ny) {
    int before = support == 0 ? count - 1 : support - 1;
    float against = nxs[support] * nx + nys[support] * ny;
    return nxs[before] * nx + nys[before] * ny < against ? before : support;
  }

  /**
   * Builds the manifold from the reference edge v1 v2 of polygon R, with its normal, and the edge
   * w1 w2 of polygon I that faces it. Everything is in A's frame. If {@code flipped}, R is B and I
   * is A.
   */
  private void clip(
      float[] rx,
      float[] ry,
      int v1,
      int v2,
      float nx,
      float ny,
      float[] ix,
      float[] iy,
      int w1,
      int w2,
      float faceSeparation,
      boolean flipped,
      float speculative,
      Manifold out) {
    float facing = flipped ? -1 : 1;

    // Positions along the reference edge, from v1 at 0 to v2 at span. The facing edge runs from w2
    // (low) to w1 (high).
    float tx = -ny;
    float ty = nx;
    float span = tx * (rx[v2] - rx[v1]) + ty * (ry[v2] - ry[v1]);
    float low = tx * (ix[w2] - rx[v1]) + ty * (iy[w2] - ry[v1]);
    float high = tx * (ix[w1] - rx[v1]) + ty * (iy[w1] - ry[v1]);
    float height1 = nx * (ix[w2] - rx[v1]) + ny * (iy[w2] - ry[v1]);
    float height2 = nx * (ix[w1] - rx[v1]) + ny * (iy[w1] - ry[v1]);
    int r = low >= span ? v2 : high <= 0 ? v1 : -1;
    int i = low >= span ? w2 : w1;
    if (faceSeparation > TOUCHING) {
      // With a gap, the facing vertex that is nearest to the face may lie beyond its end while the
      // facing edge does not. Then two vertices are the closest points, unless the end of the face
      // sees the inner part of the facing edge (parallel edges).
      float nearest = height1 <= height2 ? low : high;
      if (nearest < 0 || nearest > span) {
        int end = nearest < 0 ? v1 : v2;
        float ex = ix[w2] - ix[w1];
        float ey = iy[w2] - iy[w1];
        float along = ex * (rx[end] - ix[w1]) + ey * (ry[end] - iy[w1]);
        if (along <= 0 || along >= ex * ex + ey * ey) {
          r = end;
          i = along <= 0 ? w1 : w2;
        }
      }
    }
    if (r >= 0) {
      int id = flipped ? i << 8 | r : r << 8 | i;
      float px = flipped ? ix[i] : rx[r];
      float py = flipped ? iy[i] : ry[r];
      float qx = flipped ? rx[r] : ix[i];
      float qy = flipped ? ry[r] : iy[i];
      ofCorners =
          cornerPoint(
              px, py, qx, qy, faceSeparation, facing * nx, facing * ny, id, speculative, out);
      return;
    }
    float position1 = low;
    float position2 = high;
    float separation1 = height1;
    float separation2 = height2;
    float run = high - low;
    if (run > 0) {
      float slope = (height2 - height1) / run;
      if (low < 0) {
        position1 = 0;
        separation1 = height1 - slope * low;
      }
      if (high > span) {
        position2 = span;
        separation2 = height2 + slope * (span - high);
      }
    }
    boolean keep1 = separation1 <= speculative;
    boolean keep2 = separation2 <= speculative;
    if (!keep1 && !keep2) {
      out.clear();
      return;
    }
    float x1 = rx[v1] + tx * position1 + nx * (0.5f * separation1);
    float y1 = ry[v1] + ty * position1 + ny * (0.5f * separation1);
    float x2 = rx[v1] + tx * position2 + nx * (0.5f * separation2);
    float y2 = ry[v1] + ty * position2 + ny * (0.5f * separation2);
    int id1 = flipped ? w2 << 8 | v1 : v1 << 8 | w2;
    int id2 = flipped ? w1 << 8 | v2 : v2 << 8 | w1;
    int highId = flipped ? w2 << 8 | v2 : v2 << 8 | w2;
    int lowId = flipped ? w1 << 8 | v1 : v1 << 8 | w1;
    int otherId1 = low < 0 ? lowId : highId;
    int otherId2 = high > span ? highId : lowId;
    out.set(facing * nx, facing * ny, keep1 && keep2 ? 2 : 1);
    if (keep1) {
      out.setPoint0(x1, y1, separation1, id1, otherId1);
      out.setPoint1(x2, y2, separation2, id2, otherId2);
    } else {
      out.setPoint0(x2, y2, separation2, id2, otherId2);
    }
  }

  static void toWorldAxes(Transform ta, Manifold out) {
    float nx = out.normalX;
    float ny = out.normalY;
    out.normalX = ta.rotateX(nx, ny);
    out.normalY = ta.rotateY(nx, ny);
    float x = out.x0;
    float y = out.y0;
    out.x0 = ta.rotateX(x, y);
    out.y0 = ta.rotateY(x, y);
    x = out.x1;
    y = out.y1;
    out.x1 = ta.rotateX(x, y);
    out.y1 = ta.rotateY(x, y);
  }

  /**
   * Returns the length of a vector. It computes in double precision, so that neither tiny nor huge
   * components are lost.
   */
  private static float length(float x, float y) {
    return (float) Math.sqrt((double) x * x + (double) y * y);
  }
}
