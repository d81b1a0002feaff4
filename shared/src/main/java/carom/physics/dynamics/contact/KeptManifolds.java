package carom.physics.dynamics.contact;

import carom.physics.collision.Collider;
import carom.physics.collision.Manifold;
import carom.physics.geometry.Box;
import carom.physics.geometry.Convex;
import carom.physics.math.Transform;

/**
 * Manifolds of polygons, kept while their shapes hardly move relative to each other, and distances
 * of all shapes that don't touch.
 *
 * <p>Each row of the contact table has one kept manifold; {@link KeptRows} holds them.
 *
 * <p>The pose of B in A's frame is rounded to a grid of {@value #CELL} m and rad. The manifold is
 * that of the rounded pose; from there to the true pose the gaps follow by {@code n . m}, with the
 * way m of B's material at the point, and a normal that belongs to B turns with it. That is exact
 * for a corner against a face, and off by a grid step times the angle between the two faces at the
 * ends of faces.
 *
 * <p>So the answer depends on the two poses alone, wherever they come from, and not on the past:
 * whether a manifold was kept or is computed anew shows in no bit. Nothing here needs to be saved,
 * sent or hashed; what is kept may be forgotten at any time.
 *
 * <p>Two corners that face each other with a gap are remembered as a pair of corners; direction and
 * distance are those of the true pose.
 *
 * <p>The distance of shapes of any kind that are apart is kept: until they have moved that far they
 * can't touch.
 *
 * <p>The idea of using a manifold for several steps is from Box2D v3's contact recycling; there it
 * depends on when the manifold was made.
 */
public final class KeptManifolds {
  /** Grid step for the relative position, m, and rotation. */
  public static final float CELL = 1 / 2048f;

  /**
   * Adding and subtracting this rounds a number to the grid; those beyond 8 km, where the grid of
   * floats itself is as coarse, to that.
   */
  public static final float ROUNDING = 1.5f * (1 << 23) * CELL;

  /** A gap is trusted after so much has been taken off for rounding: absolute, m, and relative. */
  private static final float DOUBT = 1e-4f;

  private static final float RELATIVE_DOUBT = 1e-5f;

  // What is kept of a row: the rounded pose of B in A's frame, before and after its rotation was
  // made a unit.
  private static final int COS = KeptRows.COS;
  private static final int SIN = 1;
  private static final int X = 2;
  private static final int Y = 3;
  private static final int UNIT_COS = 4;
  private static final int UNIT_SIN = 5;

  /**
   * Place of an integer whose bits describe the manifold. It is the number of points or {@link
   * #CORNERS}; + {@link #OF_B} if the normal is B's; + {@link #CLOSE} for corners so close that the
   * true pose may turn their direction round; + id of the first point, shifted.
   */
  private static final int KIND = 6;

  /** Place of the way that shapes without points may move before there can be some, m. */
  private static final int CLEARANCE = 7;

  // The manifold in A's frame, if there are points.
  private static final int NX = 7;
  private static final int NY = 8;
  private static final int X0 = 9;
  private static final int Y0 = 10;
  private static final int GAP0 = 11;
  private static final int X1 = 12;
  private static final int Y1 = 13;
  private static final int GAP1 = 14;

  /** Place of the ids but for the first one, as the bits of an integer. */
  private static final int IDS = 15;

  /**
   * Number of points that stands for one point between two corners. The corner of A, in A's frame,
   * is in the place of the first point, that of B, in B's frame, in the place of the second.
   */
  private static final int CORNERS = 3;

  private static final int COUNT = 3;
  private static final int OF_B = 4;
  private static final int CLOSE = 8;
  private static final int ID_SHIFT = 4;

  private final KeptRows rows = new KeptRows();

  /** Returns the storage, which moves as the table's rows do. */
  KeptRows rows() {
    return rows;
  }

  /** Makes room for so many rows. */
  public void ensure(int count) {
    rows.ensure(count);
  }

  /** Forgets a row. Does nothing if there is no room for it yet. */
  public void forget(int row) {
    rows.forget(row);
  }

  /** The memory that one worker needs. */
  public static final class Scratch {
    private final Collider collider = new Collider();
    private final Transform identity = new Transform();
    private final Transform pose = new Transform();
    private final Manifold made = new Manifold();
    private final float[] followed = new float[ContactTable.CONTACT];

    private int boxMakes;

    /** Returns how many manifolds of two boxes weren't kept, but made. */
    public int boxMakes() {
      return boxMakes;
    }
  }

  /** Returns whether a manifold is kept of a relative pose that is rounded to the same. */
  public boolean holds(int row, float x, float y, float cos, float sin) {
    float[] r = rows.numbers;
    int at = row * KeptRows.STRIDE;
    float way = Math.abs(round(x) - r[at + X]) + Math.abs(round(y) - r[at + Y]);
    float turn = Math.abs(round(cos) - r[at + COS]) + Math.abs(round(sin) - r[at + SIN]);
    return way + turn == 0;
  }

  /** Returns whether the kept manifold is one of a face, with points of just these ids. */
  public boolean ofFace(int row, int points, int id0, int id1) {
    int at = row * KeptRows.STRIDE;
    int kind = Float.floatToRawIntBits(rows.numbers[at + KIND]);
    return (kind & (COUNT | CLOSE)) == points
        && kind >>> ID_SHIFT == id0
        && (points == 1
            || Manifold.secondId(Float.floatToRawIntBits(rows.numbers[at + IDS])) == id1);
  }

  /**
   * Carries a manifold of a face on from the rounded to the true pose.
   *
   * @param row where it is kept
   * @param aCos how A is turned
   * @param aSin how A is turned
   * @param x where B is in A's frame
   * @param y where B is in A's frame
   * @param cos how B is turned in A's frame
   * @param sin how B is turned in A's frame
   * @param to receives normal, points and gaps in the order of {@link ContactTable#contact}
   * @param into where in it
   * @return the least gap, m
   */
  public float follow(
      int row,
      float aCos,
      float aSin,
      float x,
      float y,
      float cos,
      float sin,
      float[] to,
      int into) {
    float[] r = rows.numbers;
    int at = row * KeptRows.STRIDE;
    // From the rounded pose to the true one B turns by (1 + c, s) and shifts.
    float c = cos * r[at + UNIT_COS] + sin * r[at + UNIT_SIN] - 1;
    float s = sin * r[at + UNIT_COS] - cos * r[at + UNIT_SIN];
    float nx = r[at + NX];
    float ny = r[at + NY];
    if ((kind(at) & OF_B) != 0) {
      float turned = nx + (c * nx - s * ny);
      ny += s * nx + c * ny;
      nx = turned;
    }
    to[into + ContactTable.NX] = aCos * nx - aSin * ny;
    to[into + ContactTable.NY] = aSin * nx + aCos * ny;
    float least = followPoint(at, X0, aCos, aSin, x, y, c, s, nx, ny, to, into + ContactTable.X0);
    if ((kind(at) & COUNT) == 2) {
      float gap = followPoint(at, X1, aCos, aSin, x, y, c, s, nx, ny, to, into + ContactTable.X1);
      least = Math.min(least, gap);
    }
    return least;
  }

  private float followPoint(
      int at,
      int point,
      float aCos,
      float aSin,
      float x,
      float y,
      float c,
      float s,
      float nx,
      float ny,
      float[] to,
      int into) {
    float[] r = rows.numbers;
    float px = r[at + point];
    float py = r[at + point + 1];
    float armX = px - r[at + X];
    float armY = py - r[at + Y];
    float moveX = x - r[at + X] + (c * armX - s * armY);
    float moveY = y - r[at + Y] + (s * armX + c * armY);
    float gap = r[at + point + 2] + (nx * moveX + ny * moveY);
    px += 0.5f * moveX;
    py += 0.5f * moveY;
    to[into] = aCos * px - aSin * py;
    to[into + 1] = aSin * px + aCos * py;
    to[into + 2] = gap;
    return gap;
  }

  /**
   * Finds where two polygons touch.
   *
   * @param row where to keep it
   * @param a A's part
   * @param ta its pose
   * @param b B's part
   * @param tb its pose
   * @param reach no point of B is further from B's position, m
   * @param speculative points up to this far apart count, m
   * @param hints per row what the collider said last
   * @param out receives the manifold
   */
  public void collide(
      int row,
      Convex a,
      Transform ta,
      Convex b,
      Transform tb,
      float reach,
      float speculative,
      int[] hints,
      Scratch scratch,
      Manifold out) {
    float worldX = tb.x - ta.x;
    float worldY = tb.y - ta.y;
    float x = ta.cos * worldX + ta.sin * worldY;
    float y = ta.cos * worldY - ta.sin * worldX;
    float cos = ta.cos * tb.cos + ta.sin * tb.sin;
    float sin = ta.cos * tb.sin - ta.sin * tb.cos;
    float cellX = round(x);
    float cellY = round(y);
    float cellCos = round(cos);
    float cellSin = round(sin);
    float[] r = rows.numbers;
    int at = row * KeptRows.STRIDE;
    float way = Math.abs(cellX - r[at + X]) + Math.abs(cellY - r[at + Y]);
    float turn = Math.abs(cellCos - r[at + COS]) + Math.abs(cellSin - r[at + SIN]);
    if (way + turn != 0) {
      if (kind(at) == 0
          && r[at + COS] != KeptRows.UNKNOWN
          && way + turn * reach < r[at + CLEARANCE]) {
        out.count = 0;
        return;
      }
      r[at + COS] = cellCos;
      r[at + SIN] = cellSin;
      r[at + X] = cellX;
      r[at + Y] = cellY;
      make(at, a, b, reach, speculative, hints, row, scratch);
    }
    int kind = kind(at);
    int count = kind & COUNT;
    out.count = count;
    if (count == 0) {
      return;
    }
    if (count == CORNERS) {
      corners(at, ta, x, y, cos, sin, speculative, out);
      return;
    }
    if ((kind & CLOSE) != 0) {
      scratch.collider.collide(a, ta, b, tb, speculative, hints[row], out);
      return;
    }
    float[] f = scratch.followed;
    if (follow(row, ta.cos, ta.sin, x, y, cos, sin, f, 0) > speculative) {
      // Close enough in the rounded pose alone; whether such a row exists depends on fat boxes.
      out.count = 0;
      return;
    }
    out.normalX = f[ContactTable.NX];
    out.normalY = f[ContactTable.NY];
    out.x0 = f[ContactTable.X0];
    out.y0 = f[ContactTable.Y0];
    out.separation0 = f[ContactTable.GAP0];
    if (count == 2) {
      out.x1 = f[ContactTable.X1];
      out.y1 = f[ContactTable.Y1];
      out.separation1 = f[ContactTable.GAP1];
    }
    out.setIds(kind >>> ID_SHIFT, Float.floatToRawIntBits(r[at + IDS]));
  }

  /** Makes one point midway between two corners, if they are close enough. */
  private void corners(
      int at,
      Transform ta,
      float x,
      float y,
      float cos,
      float sin,
      float speculative,
      Manifold out) {
    float[] r = rows.numbers;
    float px = r[at + X0];
    float py = r[at + Y0];
    float qx = x + (cos * r[at + X1] - sin * r[at + Y1]);
    float qy = y + (sin * r[at + X1] + cos * r[at + Y1]);
    float wayX = qx - px;
    float wayY = qy - py;
    float distance = (float) Math.sqrt(wayX * wayX + wayY * wayY);
    if (!(distance <= speculative)) {
      out.count = 0;
      return;
    }
    float nx = wayX / distance;
    float ny = wayY / distance;
    px += 0.5f * wayX;
    py += 0.5f * wayY;
    out.count = 1;
    out.normalX = ta.cos * nx - ta.sin * ny;
    out.normalY = ta.sin * nx + ta.cos * ny;
    out.x0 = ta.cos * px - ta.sin * py;
    out.y0 = ta.sin * px + ta.cos * py;
    out.separation0 = distance;
    out.id0 = kind(at) >>> ID_SHIFT;
    out.otherId0 = out.id0;
  }

  /**
   * Returns whether two shapes are known not to touch.
   *
   * @param row where it was kept
   * @param ta A's pose
   * @param tb B's pose
   * @param reach no point of B is further from B's position, m
   * @param rounded whether the rounded pose decides, as for pairs that {@link #collide} is asked
   *     about
   * @return true if they haven't moved far enough since it was kept
   */
  public boolean apart(int row, Transform ta, Transform tb, float reach, boolean rounded) {
    float[] r = rows.numbers;
    int at = row * KeptRows.STRIDE;
    float rounding = rounded ? ROUNDING : 0;
    float worldX = tb.x - ta.x;
    float worldY = tb.y - ta.y;
    float x = ta.cos * worldX + ta.sin * worldY + rounding - rounding;
    float y = ta.cos * worldY - ta.sin * worldX + rounding - rounding;
    float cos = ta.cos * tb.cos + ta.sin * tb.sin + rounding - rounding;
    float sin = ta.cos * tb.sin - ta.sin * tb.cos + rounding - rounding;
    float way = Math.abs(x - r[at + X]) + Math.abs(y - r[at + Y]);
    float turn = Math.abs(cos - r[at + COS]) + Math.abs(sin - r[at + SIN]);
    return kind(at) == 0
        && r[at + COS] != KeptRows.UNKNOWN
        && way + turn * reach < r[at + CLEARANCE];
  }

  /**
   * Keeps how far apart two shapes are that don't touch.
   *
   * @param row where
   * @param ta A's pose
   * @param tb B's pose
   * @param gap they are at least so far apart, m
   * @param speculative points up to this far apart count, m
   */
  public void keepApart(int row, Transform ta, Transform tb, float gap, float speculative) {
    float[] r = rows.numbers;
    int at = row * KeptRows.STRIDE;
    setKind(at, 0);
    float worldX = tb.x - ta.x;
    float worldY = tb.y - ta.y;
    r[at + X] = ta.cos * worldX + ta.sin * worldY;
    r[at + Y] = ta.cos * worldY - ta.sin * worldX;
    r[at + COS] = ta.cos * tb.cos + ta.sin * tb.sin;
    r[at + SIN] = ta.cos * tb.sin - ta.sin * tb.cos;
    r[at + CLEARANCE] = clearance(gap, speculative, r[at + X], r[at + Y]);
  }

  /** Returns how far shapes may move before they can touch, m, less rounding. */
  private static float clearance(float gap, float speculative, float x, float y) {
    return gap - speculative - (DOUBT + RELATIVE_DOUBT * (Math.abs(x) + Math.abs(y)));
  }

  private int kind(int at) {
    return Float.floatToRawIntBits(rows.numbers[at + KIND]);
  }

  private void setKind(int at, int kind) {
    rows.numbers[at + KIND] = Float.intBitsToFloat(kind);
  }

  private static float round(float value) {
    return value + ROUNDING - ROUNDING;
  }

  /**
   * Returns how much closer two surfaces may seem in the rounded pose than in the true one, m.
   *
   * @param reach no point of B is further from B's position, m
   */
  public static float slack(float reach) {
    return 2 * CELL * (1 + reach);
  }

  /** Computes what is kept of the rounded pose. */
  private void make(
      int at,
      Convex a,
      Convex b,
      float reach,
      float speculative,
      int[] hints,
      int row,
      Scratch scratch) {
    scratch.boxMakes += a instanceof Box && b instanceof Box ? 1 : 0;
    float[] r = rows.numbers;
    float cos = r[at + COS];
    float sin = r[at + SIN];
    float unit = 1 / (float) Math.sqrt(cos * cos + sin * sin);
    r[at + UNIT_COS] = cos * unit;
    r[at + UNIT_SIN] = sin * unit;
    Transform pose = scratch.pose.set(r[at + X], r[at + Y], r[at + UNIT_COS], r[at + UNIT_SIN]);
    Manifold m = scratch.made;
    scratch.collider.collide(a, scratch.identity, b, pose, speculative, hints[row], m);
    hints[row] = scratch.collider.hint();
    if (m.count == 0) {
      setKind(at, 0);
      r[at + CLEARANCE] = clearance(scratch.collider.gap(), speculative, pose.x, pose.y);
      return;
    }
    if (scratch.collider.ofCorners() && m.separation0 <= slack(reach)) {
      setKind(at, 1 + CLOSE);
      return;
    }
    if (scratch.collider.ofCorners()) {
      int cornerA = m.id0 >> 8;
      int cornerB = m.id0 & 0xff;
      setKind(at, CORNERS + (m.id0 << ID_SHIFT));
      r[at + X0] = a.vertexX(cornerA);
      r[at + Y0] = a.vertexY(cornerA);
      r[at + X1] = b.vertexX(cornerB);
      r[at + Y1] = b.vertexY(cornerB);
      return;
    }
    setKind(at, m.count + (scratch.collider.ofB() ? OF_B : 0) + (m.id0 << ID_SHIFT));
    r[at + NX] = m.normalX;
    r[at + NY] = m.normalY;
    r[at + X0] = m.x0;
    r[at + Y0] = m.y0;
    r[at + GAP0] = m.separation0;
    r[at + X1] = m.x1;
    r[at + Y1] = m.y1;
    r[at + GAP1] = m.separation1;
    r[at + IDS] = Float.intBitsToFloat(m.packedIds());
  }
}
