package carom.physics.collision;

import carom.physics.geometry.Convex;
import carom.physics.geometry.Segment;
import carom.physics.math.Transform;

/**
 * Computes manifolds of pairs with a capsule, a segment or a rounded polygon.
 *
 * <p>{@link Gjk} measures the cores, the shapes without their rounding. While the cores are apart,
 * their distance decides the kind of contact: a face if it equals the best face's separation, two
 * vertices if it is more. If the cores overlap, the face of least overlap serves. A face clips the
 * edge that lies against it, which gives two points; then the radii are subtracted.
 *
 * <p>A one-sided {@link Segment} collides with its front only, and its neighbours decide about
 * normals that lean over its ends. At a concave or straight joint the front's own normal serves
 * instead. At an outward corner normals up to the neighbour's front are kept, and those beyond are
 * left to the neighbour. A shape whose middle is behind the front passes.
 */
final class RoundCollider {
  /** Gap, metres, up to which cores count as touching and faces serve. */
  private static final double TOUCHING = 1e-5;

  /**
   * Cosine between the direction of two vertices and a face's normal from which on the contact may
   * count as a face contact.
   */
  private static final double FLAT = 0.9999;

  /**
   * Cosine between two facing edges from which on two vertices that are {@link #FLAT} make a face
   * contact.
   */
  private static final double PARALLEL = 0.998;

  /** Margin, metres, by which B's face must be better to be preferred while cores overlap. */
  private static final double FACE_BIAS = 5e-4;

  private final Core a = new Core();
  private final Core b = new Core();
  private final Gjk gjk = new Gjk();
  private final Normals normalsA = new Normals();
  private final Normals normalsB = new Normals();

  // Results of the last call of bestFace.
  private double faceSeparation;
  private int faceEdge;

  private float gap;

  /** Edge normals of a core. */
  private static final class Normals {
    private final double[] x = new double[Convex.MAX_VERTICES];
    private final double[] y = new double[Convex.MAX_VERTICES];

    /** Number of faces that may be the reference: 1 for a one-sided segment, 0 for a point. */
    private int usable;

    void place(Convex shape, double cos, double sin) {
      usable = shape instanceof Segment s && s.isOneSided() ? 1 : shape.vertexCount();
      if (shape.vertexCount() == 1) {
        usable = 0;
      }
      for (int i = 0; i < shape.vertexCount(); i++) {
        double nx = shape.normalX(i);
        double ny = shape.normalY(i);
        x[i] = cos * nx - sin * ny;
        y[i] = sin * nx + cos * ny;
      }
    }
  }

  RoundCollider() {}

  /** Computes the manifold of two shapes, as {@link Collider#collide} does. */
  void collide(
      Convex shapeA, Transform ta, Convex shapeB, Transform tb, float speculative, Manifold out) {
    out.clear();
    a.place(shapeA, ta, ta.x, ta.y);
    b.place(shapeB, tb, ta.x, ta.y);
    double radii = a.radius + b.radius;
    gjk.run(a, b);
    gap = (float) (gjk.distance - radii);
    if (!(gjk.distance - radii <= speculative)) {
      return;
    }
    normalsA.place(shapeA, ta.cos, ta.sin);
    normalsB.place(shapeB, tb.cos, tb.sin);
    Segment front = null;
    double sign = 1;
    if (shapeA instanceof Segment s && s.isOneSided()) {
      front = s;
    } else if (shapeB instanceof Segment s && s.isOneSided()) {
      front = s;
      sign = -1;
    }
    if (front != null
        && isBehind(sign > 0 ? a : b, sign > 0 ? normalsA : normalsB, sign > 0 ? b : a)) {
      return;
    }
    if (a.count == 1 || b.count == 1) {
      disc(front, sign, radii, speculative, out);
    } else {
      faces(front, sign, radii, speculative, out);
    }
  }

  /** Returns how far apart the last two shapes are, m; zero or less if they touch or overlap. */
  float gap() {
    return gap;
  }

  /** Returns whether the mean of a core's vertices is behind the front of a one-sided segment. */
  private static boolean isBehind(Core segment, Normals normals, Core other) {
    double x = 0;
    double y = 0;
    for (int i = 0; i < other.count; i++) {
      x += other.x[i] - segment.x[0];
      y += other.y[i] - segment.y[0];
    }
    return normals.x[0] * x + normals.y[0] * y < 0;
  }

  // ---------------------------------------------------------------- one-sided segments

  /**
   * Decision about a normal that isn't the front's: take it, use the front's instead, or leave the
   * contact to the neighbour.
   */
  private enum NormalUse {
    TAKE,
    FRONT,
    LEAVE
  }

  /** Decides what to do with a normal (from the segment outwards) that isn't the front's. */
  private static NormalUse judge(
      Segment shape, Core segment, Normals normals, double nx, double ny, boolean apart) {
    double ex = segment.x[1] - segment.x[0];
    double ey = segment.y[1] - segment.y[0];
    double lean = nx * ex + ny * ey;
    int end = lean < 0 ? 0 : 1;
    double fx = normals.x[0];
    double fy = normals.y[0];
    double across = nx * fx + ny * fy;
    if (isStraight(segment, nx, ny) && across > 0) {
      return NormalUse.FRONT;
    }
    // What is apart beyond an end, and behind the front, passes, or is the neighbour's.
    NormalUse front = apart && across <= 0 ? NormalUse.LEAVE : NormalUse.FRONT;
    if (!shape.isLinked(end)) {
      return across > 0 ? NormalUse.TAKE : front;
    }
    // The neighbour's direction in the segment's own frame is turned by the same rotation as the
    // front's normal; in that frame the cross product decides.
    double ownX = (double) shape.vertexX(end) - shape.ghostX(end);
    double ownY = (double) shape.vertexY(end) - shape.ghostY(end);
    double toward = end == 0 ? 1 : -1;
    double gx = toward * ownX;
    double gy = toward * ownY;
    double ox = (double) shape.vertexX(1) - shape.vertexX(0);
    double oy = (double) shape.vertexY(1) - shape.vertexY(0);
    double bend = toward * (gx * oy - gy * ox);
    double size = Math.sqrt((gx * gx + gy * gy) * (ox * ox + oy * oy));
    if (!(bend > 1e-3 * size)) {
      return front;
    }
    // The neighbour's front normal, turned into world axes: right of its way, (gy, -gx).
    double cos = fx * shape.normalX(0) + fy * shape.normalY(0);
    double sin = fy * shape.normalX(0) - fx * shape.normalY(0);
    double hx = cos * gy + sin * gx;
    double hy = sin * gy - cos * gx;
    return toward * (hx * ny - hy * nx) >= 0 ? NormalUse.TAKE : NormalUse.LEAVE;
  }

  // ---------------------------------------------------------------- discs

  /** Computes the manifold if one of the cores is a point. */
  private void disc(Segment front, double sign, double radii, float speculative, Manifold out) {
    double nx = gjk.normalX;
    double ny = gjk.normalY;
    double distance = gjk.distance;
    boolean ofA = b.count == 1;
    if (!(distance > TOUCHING)) {
      if (ofA) {
        bestFace(a, normalsA, b);
      } else {
        bestFace(b, normalsB, a);
      }
      Normals normals = ofA ? normalsA : normalsB;
      nx = ofA ? normals.x[faceEdge] : -normals.x[faceEdge];
      ny = ofA ? normals.y[faceEdge] : -normals.y[faceEdge];
      distance = Math.min(distance, faceSeparation);
    } else if (front != null) {
      Core segment = sign > 0 ? a : b;
      Normals normals = sign > 0 ? normalsA : normalsB;
      boolean atEnd = sign > 0 ? gjk.a0 == gjk.a1 : gjk.b0 == gjk.b1;
      if (atEnd && isStraight(segment, nx, ny)) {
        nx = sign * normals.x[0];
        ny = sign * normals.y[0];
      } else if (atEnd
          && judge(front, segment, normals, sign * nx, sign * ny, true) != NormalUse.TAKE) {
        // At a joint that isn't an outward corner, what is beyond the end is the neighbour's.
        return;
      }
    }
    double separation = distance - radii;
    if (!(separation <= speculative)) {
      return;
    }
    // Midway between the surfaces, seen from the point that is a core.
    double along = ofA ? -b.radius - 0.5 * separation : a.radius + 0.5 * separation;
    Core point = ofA ? b : a;
    out.set((float) nx, (float) ny, 1);
    out.setPoint0(
        (float) (point.x[0] + along * nx),
        (float) (point.y[0] + along * ny),
        (float) separation,
        0);
  }

  /**
   * Returns whether a direction is nearly perpendicular to a segment. Then a contact at its end is
   * as good as one on it.
   */
  private static boolean isStraight(Core segment, double nx, double ny) {
    double ex = segment.x[1] - segment.x[0];
    double ey = segment.y[1] - segment.y[0];
    return Math.abs(nx * ex + ny * ey) <= 1e-3 * Math.sqrt(ex * ex + ey * ey);
  }

  // ---------------------------------------------------------------- edges

  private void faces(Segment front, double sign, double radii, float speculative, Manifold out) {
    bestFace(a, normalsA, b);
    double separationA = faceSeparation;
    int edgeA = faceEdge;
    bestFace(b, normalsB, a);
    double separationB = faceSeparation;
    int edgeB = faceEdge;
    boolean apart = gjk.distance > TOUCHING;
    boolean ofB = separationB > separationA + (apart ? 0 : FACE_BIAS);
    boolean corner =
        apart && isCorner(Math.max(separationA, separationB), ofB ? edgeB : edgeA, ofB);
    double nx = corner ? gjk.normalX : ofB ? -normalsB.x[edgeB] : normalsA.x[edgeA];
    double ny = corner ? gjk.normalY : ofB ? -normalsB.y[edgeB] : normalsA.y[edgeA];
    if (front != null && (corner || ofB == sign > 0)) {
      Core segment = sign > 0 ? a : b;
      Normals normals = sign > 0 ? normalsA : normalsB;
      NormalUse use = judge(front, segment, normals, sign * nx, sign * ny, apart);
      if (use == NormalUse.LEAVE) {
        return;
      }
      if (use == NormalUse.FRONT) {
        corner = false;
        ofB = sign < 0;
      }
    }
    if (corner) {
      vertices(radii, speculative, out);
    } else if (ofB) {
      clip(b, normalsB, edgeB, a, normalsA, separationB, true, front != null, speculative, out);
    } else {
      clip(a, normalsA, edgeA, b, normalsB, separationA, false, front != null, speculative, out);
    }
  }

  /**
   * Returns whether two vertices face each other, rather than a face and an edge that lies nearly
   * flat on it.
   */
  private boolean isCorner(double faceSeparation, int edge, boolean ofB) {
    if (gjk.a0 != gjk.a1 || gjk.b0 != gjk.b1) {
      return false;
    }
    if (faceSeparation < FLAT * gjk.distance) {
      return true;
    }
    Normals reference = ofB ? normalsB : normalsA;
    Normals facing = ofB ? normalsA : normalsB;
    double most = 0;
    for (int i = 0; i < (ofB ? a : b).count; i++) {
      double against = -facing.x[i] * reference.x[edge] - facing.y[i] * reference.y[edge];
      most = Math.max(most, against);
    }
    return most < PARALLEL;
  }

  private void bestFace(Core of, Normals normals, Core other) {
    faceSeparation = Double.NEGATIVE_INFINITY;
    faceEdge = 0;
    for (int i = 0; i < normals.usable; i++) {
      int deepest = other.support(-normals.x[i], -normals.y[i]);
      double s =
          normals.x[i] * (other.x[deepest] - of.x[i]) + normals.y[i] * (other.y[deepest] - of.y[i]);
      if (s > faceSeparation) {
        faceSeparation = s;
        faceEdge = i;
      }
    }
  }

  /** Sets the one point of two vertices, which are the closest points of the cores. */
  private void vertices(double radii, float speculative, Manifold out) {
    double separation = gjk.distance - radii;
    if (!(separation <= speculative)) {
      return;
    }
    double along = a.radius + 0.5 * separation;
    out.set((float) gjk.normalX, (float) gjk.normalY, 1);
    out.setPoint0(
        (float) (gjk.ax + along * gjk.normalX),
        (float) (gjk.ay + along * gjk.normalY),
        (float) separation,
        gjk.a0 << 8 | gjk.b0);
  }

  /**
   * Clips the edge of core i that lies against edge v1 of core r, as {@link Collider} does. If
   * {@code flipped}, r is B.
   */
  private void clip(
      Core r,
      Normals rn,
      int v1,
      Core i,
      Normals in,
      double separation,
      boolean flipped,
      boolean chained,
      float speculative,
      Manifold out) {
    int v2 = v1 + 1 == r.count ? 0 : v1 + 1;
    double nx = rn.x[v1];
    double ny = rn.y[v1];
    int support = i.support(-nx, -ny);
    int before = support == 0 ? i.count - 1 : support - 1;
    boolean useBefore =
        in.x[before] * nx + in.y[before] * ny < in.x[support] * nx + in.y[support] * ny;
    int w1 = useBefore ? before : support;
    int w2 = w1 + 1 == i.count ? 0 : w1 + 1;
    double tx = -ny;
    double ty = nx;
    double span = tx * (r.x[v2] - r.x[v1]) + ty * (r.y[v2] - r.y[v1]);
    double low = tx * (i.x[w2] - r.x[v1]) + ty * (i.y[w2] - r.y[v1]);
    double high = tx * (i.x[w1] - r.x[v1]) + ty * (i.y[w1] - r.y[v1]);
    double height1 = nx * (i.x[w2] - r.x[v1]) + ny * (i.y[w2] - r.y[v1]);
    double height2 = nx * (i.x[w1] - r.x[v1]) + ny * (i.y[w1] - r.y[v1]);
    double radii = a.radius + b.radius;
    double facing = flipped ? -1 : 1;
    if (low >= span || high <= 0) {
      // Corner beside corner: one point, unless a neighbour in the chain has it.
      double gap = separation - radii;
      if (!chained && gap <= speculative) {
        int rv = low >= span ? v2 : v1;
        int iv = low >= span ? w2 : w1;
        double middle = r.radius + 0.5 * gap;
        out.set((float) (facing * nx), (float) (facing * ny), 1);
        out.setPoint0(
            (float) (r.x[rv] + middle * nx),
            (float) (r.y[rv] + middle * ny),
            (float) gap,
            flipped ? iv << 8 | rv : rv << 8 | iv);
      }
      return;
    }
    double slope = high > low ? (height2 - height1) / (high - low) : 0;
    double position1 = Math.max(low, 0);
    double position2 = Math.min(high, span);
    double separation1 = height1 + slope * (position1 - low) - radii;
    double separation2 = height2 + slope * (position2 - high) - radii;
    boolean keep1 = separation1 <= speculative;
    boolean keep2 = separation2 <= speculative;
    if (!keep1 && !keep2) {
      return;
    }
    int id1 = flipped ? w2 << 8 | v1 : v1 << 8 | w2;
    int id2 = flipped ? w1 << 8 | v2 : v2 << 8 | w1;
    int highId = flipped ? w2 << 8 | v2 : v2 << 8 | w2;
    int lowId = flipped ? w1 << 8 | v1 : v1 << 8 | w1;
    int otherId1 = low < 0 ? lowId : highId;
    int otherId2 = high > span ? highId : lowId;
    double up1 = r.radius + 0.5 * separation1;
    double up2 = r.radius + 0.5 * separation2;
    float x1 = (float) (r.x[v1] + tx * position1 + nx * up1);
    float y1 = (float) (r.y[v1] + ty * position1 + ny * up1);
    float x2 = (float) (r.x[v1] + tx * position2 + nx * up2);
    float y2 = (float) (r.y[v1] + ty * position2 + ny * up2);
    out.set((float) (facing * nx), (float) (facing * ny), keep1 && keep2 ? 2 : 1);
    if (keep1) {
      out.setPoint0(x1, y1, (float) separation1, id1, otherId1);
      out.setPoint1(x2, y2, (float) separation2, id2, otherId2);
    } else {
      out.setPoint0(x2, y2, (float) separation2, id2, otherId2);
    }
  }
}
