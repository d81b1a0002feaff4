package carom.physics.effects;

import carom.physics.geometry.Circle;
import carom.physics.geometry.Convex;
import carom.physics.math.Aabb;
import carom.physics.math.Trig;

/**
 * Submerged part of a body: area, centroid and second moment of its parts, clipped by the surface
 * and by the edges of an area. Coordinates are relative to the body's centre of mass, so far from
 * the world's origin nothing is lost to rounding.
 *
 * <p>Polygons are clipped exactly (Sutherland and Hodgman 1974). Discs within the edges use the
 * formula of the circular segment, exact up to the float arc tangent. Other round shapes are
 * approximated by polygons of {@value #DIRECTIONS} or more corners, whose moments are scaled so
 * that an unclipped one has exactly the shape's area.
 */
final class Submerged {
  /**
   * Number of corners of the polygon that approximates a disc. A multiple of four keeps the sides
   * of upright capsules flat.
   */
  static final int DIRECTIONS = 64;

  private static final double[] DIRECTION_X = new double[DIRECTIONS];
  private static final double[] DIRECTION_Y = new double[DIRECTIONS];

  static {
    for (int i = 0; i < DIRECTIONS; i++) {
      float angle = 2 * Trig.PI * i / DIRECTIONS;
      DIRECTION_X[i] = Trig.cos(angle);
      DIRECTION_Y[i] = Trig.sin(angle);
    }
  }

  private static final int PLANES = 5;

  /** Largest number of corners of a clipped polygon; each plane adds one at most. */
  private static final int CAPACITY = Math.max(DIRECTIONS, Convex.MAX_VERTICES) + PLANES;

  /** Submerged area, m^2. */
  double area;

  /**
   * Submerged centroid relative to the body's centre of mass, m. It is meaningful only if the area
   * is positive.
   */
  double centroidX;

  double centroidY;

  /** Second moment of the submerged area about its centroid, m^4. */
  double second;

  private double sumX;
  private double sumY;
  private double sumSecond;

  // Half planes nx x + ny y <= limit that are kept: below the surface, then within the left, right,
  // lower and upper edge.
  private final double[] planeX = {0, -1, 1, 0, 0};
  private final double[] planeY = {1, 0, 0, -1, 1};
  private final double[] limit = new double[PLANES];

  private double[] px = new double[CAPACITY];
  private double[] py = new double[CAPACITY];
  private double[] qx = new double[CAPACITY];
  private double[] qy = new double[CAPACITY];
  private int count;

  // Position of the body's origin relative to its centre, and the body's rotation.
  private double originX;
  private double originY;
  private double cos;
  private double sin;

  /** Starts with a body whose centre is at (x, y). */
  void begin(
      double x,
      double y,
      double originX,
      double originY,
      double cos,
      double sin,
      Aabb area,
      double surfaceX,
      double surfaceY,
      double normalX,
      double normalY) {
    this.originX = originX;
    this.originY = originY;
    this.cos = cos;
    this.sin = sin;
    planeX[0] = normalX;
    planeY[0] = normalY;
    limit[0] = normalX * (surfaceX - x) + normalY * (surfaceY - y);
    limit[1] = x - area.minX;
    limit[2] = area.maxX - x;
    limit[3] = y - area.minY;
    limit[4] = area.maxY - y;
    this.area = 0;
    sumX = 0;
    sumY = 0;
    sumSecond = 0;
  }

  /** Adds a part of the body, given in the body's frame. */
  void add(Convex part) {
    double whole = part.area();
    if (whole == 0) {
      return;
    }
    if (part instanceof Circle && isWithinEdges(part)) {
      addDisc(part);
      return;
    }
    double scale = 1;
    if (part.radius() > 0) {
      outline(part);
      scale = whole / outlineArea();
    } else {
      corners(part);
    }
    for (int i = 0; i < PLANES; i++) {
      cut(planeX[i], planeY[i], limit[i]);
    }
    sum(scale);
  }

  /** Computes the centroid and second moment. Call it after the last part. */
  void end() {
    if (area > 0) {
      centroidX = sumX / area;
      centroidY = sumY / area;
      second = Math.max(0, sumSecond - area * (centroidX * centroidX + centroidY * centroidY));
    }
  }

  private double placeX(double x, double y) {
    return originX + (cos * x - sin * y);
  }

  private double placeY(double x, double y) {
    return originY + (sin * x + cos * y);
  }

  private boolean isWithinEdges(Convex disc) {
    double x = placeX(disc.vertexX(0), disc.vertexY(0));
    double y = placeY(disc.vertexX(0), disc.vertexY(0));
    double r = disc.radius();
    return x - r >= -limit[1]
        && x + r <= limit[2]
        && y - r >= -limit[3]
        && (y + r <= limit[4] || (planeX[0] == 0 && planeY[0] > 0 && limit[0] <= limit[4]));
  }

  /**
   * Adds a disc. A circular segment beyond the distance t r from the centre, with u = acos t, has
   * the area r^2 (u - sin u cos u), the first moment 2/3 r^3 sin^3 u, and the second moments r^4
   * (u/4 - sin 4u / 16) along the axis and r^4 (u/4 - sin 2u / 6 + sin 4u / 48) across (integrals
   * over strips).
   */
  private void addDisc(Convex disc) {
    double x = placeX(disc.vertexX(0), disc.vertexY(0));
    double y = placeY(disc.vertexX(0), disc.vertexY(0));
    double r = disc.radius();
    double t = (planeX[0] * x + planeY[0] * y - limit[0]) / r;
    if (t >= 1) {
      return;
    }
    double c = Math.max(t, -1);
    double s = Math.sqrt(1 - c * c);
    double u = c == -1 ? Math.PI : Trig.atan2((float) s, (float) c);
    double sin2 = 2 * s * c;
    double sin4 = 2 * sin2 * (c * c - s * s);
    double a = r * r * (u - s * c);
    double first = 2.0 / 3 * r * r * r * s * s * s;
    double polar = r * r * r * r * (u / 2 - sin2 / 6 - sin4 / 24);
    area += a;
    sumX += a * x - first * planeX[0];
    sumY += a * y - first * planeY[0];
    sumSecond += polar - 2 * first * (x * planeX[0] + y * planeY[0]) + a * (x * x + y * y);
  }

  private void corners(Convex part) {
    count = part.vertexCount();
    for (int i = 0; i < count; i++) {
      px[i] = placeX(part.vertexX(i), part.vertexY(i));
      py[i] = placeY(part.vertexX(i), part.vertexY(i));
    }
  }

  /** Computes the farthest points of a rounded shape in fixed directions, counter-clockwise. */
  private void outline(Convex part) {
    count = DIRECTIONS;
    double r = part.radius();
    for (int i = 0; i < DIRECTIONS; i++) {
      int farthest = 0;
      double most = Double.NEGATIVE_INFINITY;
      for (int v = 0; v < part.vertexCount(); v++) {
        double far = DIRECTION_X[i] * part.vertexX(v) + DIRECTION_Y[i] * part.vertexY(v);
        if (far > most) {
          most = far;
          farthest = v;
        }
      }
      double x = part.vertexX(farthest) + r * DIRECTION_X[i];
      double y = part.vertexY(farthest) + r * DIRECTION_Y[i];
      px[i] = placeX(x, y);
      py[i] = placeY(x, y);
    }
  }

  private double outlineArea() {
    double twice = 0;
    for (int i = 0; i < count; i++) {
      int next = i + 1 == count ? 0 : i + 1;
      twice += (px[i] - px[0]) * (py[next] - py[0]) - (py[i] - py[0]) * (px[next] - px[0]);
    }
    return 0.5 * twice;
  }

  /** Clips the polygon to the half plane below a limit. */
  private void cut(double nx, double ny, double most) {
    int kept = 0;
    for (int i = 0; i < count; i++) {
      int next = i + 1 == count ? 0 : i + 1;
      double here = nx * px[i] + ny * py[i] - most;
      double there = nx * px[next] + ny * py[next] - most;
      if (here <= 0) {
        qx[kept] = px[i];
        qy[kept++] = py[i];
      }
      if ((here < 0 && there > 0) || (here > 0 && there < 0)) {
        double at = here / (here - there);
        qx[kept] = px[i] + at * (px[next] - px[i]);
        qy[kept++] = py[i] + at * (py[next] - py[i]);
      }
    }
    double[] x = px;
    double[] y = py;
    px = qx;
    py = qy;
    qx = x;
    qy = y;
    count = kept;
  }

  /** Adds the moments of the clipped polygon, by triangles about the body's centre. */
  private void sum(double scale) {
    for (int i = 0; i < count; i++) {
      int next = i + 1 == count ? 0 : i + 1;
      double ax = px[i];
      double ay = py[i];
      double bx = px[next];
      double by = py[next];
      double cross = scale * (ax * by - ay * bx);
      area += cross / 2;
      sumX += cross * (ax + bx) / 6;
      sumY += cross * (ay + by) / 6;
      sumSecond += cross * (ax * ax + ay * ay + ax * bx + ay * by + bx * bx + by * by) / 12;
    }
  }
}
