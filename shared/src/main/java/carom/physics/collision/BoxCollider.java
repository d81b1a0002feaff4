package carom.physics.collision;

import carom.physics.geometry.Box;
import carom.physics.math.Transform;

/**
 * Computes manifolds of two boxes. It makes the decisions that {@link Collider} makes for polygons,
 * but from half sizes and angles instead of vertices.
 *
 * <p>Along an axis of one box, the other reaches as far as the projections of its half sizes. That
 * gives four gaps, of which the largest names the reference face. Everything else is measured from
 * the centre of the reference box, along that face's normal n and along the face's direction t,
 * which is n turned left:
 *
 * <pre>
 *          w1 o-----------------o w2      incident face: from high (w1) to low (w2) along t,
 *             |                           at heights above the reference face
 *      v2 +---|-------------+ v1          reference face: from along (v2) to -along (v1)
 *         |        n        |
 *    t <--          ^
 * </pre>
 *
 * <p>Factors of 0, 1 and -1 and masks choose the faces, instead of branches. Where boxes tumble the
 * CPU can't predict a branch, and a misprediction costs more than computing both choices.
 */
final class BoxCollider {
  private static final float TOUCHING = Collider.TOUCHING;

  /** Outward normals of a box's edges. */
  private static final float[] EDGE_X = {0, 1, 0, -1};

  private static final float[] EDGE_Y = {-1, 0, 1, 0};

  private float gap;
  private boolean ofB;
  private boolean ofCorners;

  /** Returns the gap, as {@link Collider#gap} does. */
  float gap() {
    return gap;
  }

  /** Returns whether the normal belongs to a face of B, as {@link Collider#ofB} does. */
  boolean ofB() {
    return ofB;
  }

  /** Returns whether the normal is between two corners, as {@link Collider#ofCorners} does. */
  boolean ofCorners() {
    return ofCorners;
  }

  /** Computes the manifold of two boxes, as {@link Collider#collide} does. */
  void collide(Box a, Transform ta, Box b, Transform tb, float speculative, Manifold out) {
    ofCorners = false;
    float worldX = tb.x - ta.x;
    float worldY = tb.y - ta.y;
    float x = ta.cos * worldX + ta.sin * worldY;
    float y = ta.cos * worldY - ta.sin * worldX;
    float cos = ta.cos * tb.cos + ta.sin * tb.sin;
    float sin = ta.cos * tb.sin - ta.sin * tb.cos;
    float dx = x + cos * b.centerX() - sin * b.centerY() - a.centerX();
    float dy = y + sin * b.centerX() + cos * b.centerY() - a.centerY();
    float c = Math.abs(cos);
    float s = Math.abs(sin);
    float aw = a.halfWidth();
    float ah = a.halfHeight();
    float bw = b.halfWidth();
    float bh = b.halfHeight();
    float gapAx = Math.abs(dx) - aw - (c * bw + s * bh);
    float gapAy = Math.abs(dy) - ah - (s * bw + c * bh);
    float ex = -(cos * dx + sin * dy);
    float ey = sin * dx - cos * dy;
    float gapBx = Math.abs(ex) - bw - (c * aw + s * ah);
    float gapBy = Math.abs(ey) - bh - (s * aw + c * ah);
    float separationA = Math.max(gapAx, gapAy);
    float separationB = Math.max(gapBx, gapBy);
    gap = Math.max(separationA, separationB);
    if (!(gap <= speculative)) {
      out.clear();
      return;
    }
    float bias = Collider.BOX_ROUNDING * (aw + ah + bw + bh);
    if (separationB <= TOUCHING) {
      bias += Collider.faceBias(2 * Math.min(aw, bw));
    }
    ofB = separationB > separationA + bias;
    // The reference box: half sizes, where the other one is in its frame and how that is turned,
    // and where it is itself in A's frame.
    float halfX = aw;
    float halfY = ah;
    float otherX = dx;
    float otherY = dy;
    float turn = sin;
    float otherHalfX = bw;
    float otherHalfY = bh;
    float axisX = 1;
    float axisY = 0;
    float centerX = a.centerX();
    float centerY = a.centerY();
    int edge;
    if (ofB) {
      halfX = bw;
      halfY = bh;
      otherX = ex;
      otherY = ey;
      turn = -sin;
      otherHalfX = aw;
      otherHalfY = ah;
      axisX = cos;
      axisY = sin;
      centerX += dx;
      centerY += dy;
      edge = bestEdge(gapBx, gapBy, ex, ey);
    } else {
      edge = bestEdge(gapAx, gapAy, dx, dy);
    }
    float edgeX = EDGE_X[edge];
    float edgeY = EDGE_Y[edge];
    float up = Math.abs(edgeX) * halfX + Math.abs(edgeY) * halfY;
    float along = Math.abs(edgeY) * halfX + Math.abs(edgeX) * halfY;
    // The other box's axes, and the normal of its face, in those of n and t.
    float turnedCos = edgeX * cos + edgeY * turn;
    float turnedSin = edgeX * turn - edgeY * cos;
    int facing = facingEdge(edge, cos, turn);
    float facingX = EDGE_X[facing];
    float facingY = EDGE_Y[facing];
    float facingN = turnedCos * facingX - turnedSin * facingY;
    float facingT = turnedSin * facingX + turnedCos * facingY;
    float outward = Math.abs(facingX) * otherHalfX + Math.abs(facingY) * otherHalfY;
    float half = Math.abs(facingY) * otherHalfX + Math.abs(facingX) * otherHalfY;
    float middleN = edgeX * otherX + edgeY * otherY + facingN * outward - up;
    float middleT = edgeX * otherY - edgeY * otherX + facingT * outward;
    float low = middleT + facingN * half;
    float high = middleT - facingN * half;
    float heightLow = middleN - facingT * half;
    float heightHigh = middleN + facingT * half;
    float nx = edgeX * axisX - edgeY * axisY;
    float ny = edgeX * axisY + edgeY * axisX;
    boolean atLow = low >= along;
    int corners = atLow || high <= -along ? id(edge, facing, atLow, atLow) : -1;
    float separation = ofB ? separationB : separationA;
    if (separation > TOUCHING) {
      // With a gap, the facing vertex that is nearest to the face may lie beyond its end while the
      // facing edge does not. Then two vertices are the closest points, unless the end of the face
      // sees the inner part of the facing edge (parallel edges).
      float nearest = heightLow <= heightHigh ? low : high;
      if (Math.abs(nearest) > along) {
        float end = nearest < 0 ? -along : along;
        float inner = facingT * heightHigh + facingN * (end - high);
        if (inner <= 0 || inner >= 2 * half) {
          corners = id(edge, facing, nearest > 0, inner > 0);
        }
      }
    }
    float sign = ofB ? -1 : 1;
    if (corners >= 0) {
      float px = a.vertexX(corners >> 8);
      float py = a.vertexY(corners >> 8);
      float vx = b.vertexX(corners & 0xff);
      float vy = b.vertexY(corners & 0xff);
      float qx = cos * vx - sin * vy + x;
      float qy = sin * vx + cos * vy + y;
      ofCorners =
          Collider.cornerPoint(
              px, py, qx, qy, separation, sign * nx, sign * ny, corners, speculative, out);
    } else {
      float slope = -facingT / facingN;
      float position1 = Math.max(low, -along);
      float position2 = Math.min(high, along);
      float separation1 = heightLow + slope * (position1 - low);
      float separation2 = heightHigh + slope * (position2 - high);
      boolean keep1 = separation1 <= speculative;
      boolean keep2 = separation2 <= speculative;
      if (!keep1 && !keep2) {
        out.clear();
        return;
      }
      int id1 = id(edge, facing, false, true);
      int id2 = id(edge, facing, true, false);
      int highId = id(edge, facing, true, true);
      int lowId = id(edge, facing, false, false);
      int otherId1 = low < -along ? lowId : highId;
      int otherId2 = high > along ? highId : lowId;
      float up1 = up + 0.5f * separation1;
      float up2 = up + 0.5f * separation2;
      float x1 = centerX + nx * up1 - ny * position1;
      float y1 = centerY + ny * up1 + nx * position1;
      float x2 = centerX + nx * up2 - ny * position2;
      float y2 = centerY + ny * up2 + nx * position2;
      out.set(sign * nx, sign * ny, keep1 && keep2 ? 2 : 1);
      if (keep1) {
        out.setPoint0(x1, y1, separation1, id1, otherId1);
        out.setPoint1(x2, y2, separation2, id2, otherId2);
      } else {
        out.setPoint0(x2, y2, separation2, id2, otherId2);
      }
    }
    if (out.count > 0) {
      Collider.toWorldAxes(ta, out);
    }
  }

  /**
   * Returns the id of a pair of vertices: the first or second of the reference edge, and one of the
   * facing edge.
   */
  private int id(int edge, int facing, boolean second, boolean facingSecond) {
    int id = (edge + (second ? 1 : 0) & 3) << 8 | (facing + (facingSecond ? 1 : 0) & 3);
    return ofB ? Manifold.swappedId(id) : id;
  }

  /**
   * Returns the edge of a box, turned by an angle, whose normal most opposes that of an edge of
   * another box. Of equally good edges it is the one of lower index.
   */
  private static int facingEdge(int edge, float cos, float sin) {
    // Edge normals are a quarter turn apart: the opposite one is edge + 2, less the quarters by
    // which the box is turned.
    int straight = 2 & Collider.sign(-cos);
    int across = 3 - (2 & Collider.sign(-sin));
    int quarters =
        Collider.choose(Collider.sign(Math.abs(cos) - Math.abs(sin)), across, 2 - straight);
    return edge + 2 - quarters & 3;
  }

  /**
   * Returns the edge that faces the other box. Of equally good edges it is the one of lowest index.
   */
  private static int bestEdge(float gapX, float gapY, float dx, float dy) {
    int sideways = 1 + (2 & Collider.sign(dx + 0f));
    int upright = 2 & Collider.sign(0f - dy);
    int least = Math.min(sideways, upright);
    return Collider.choose(
        Collider.sign(gapY - gapX),
        sideways,
        Collider.choose(Collider.sign(gapX - gapY), upright, least));
  }
}
