package carom.physics.mover;

import carom.physics.Body;
import carom.physics.PartVisitor;
import carom.physics.QueryFilter;
import carom.physics.World;
import carom.physics.collision.Core;
import carom.physics.collision.Gjk;
import carom.physics.collision.Mtv;
import carom.physics.collision.Sat;
import carom.physics.geometry.Capsule;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Convex;
import carom.physics.geometry.Segment;
import carom.physics.math.Aabb;
import carom.physics.math.Transform;
import java.util.Arrays;

/**
 * The convex parts around a mover, collected once per move, and what the mover measures of them.
 * All points are relative to the origin that {@link #collect} is given, in double precision.
 */
final class Surroundings<T> {
  private static final int MAX_STEPS = 48;
  private static final double ARRIVED = 1e-7;

  private final double radius;
  private final double half;
  private final double upX;
  private final double upY;
  private final Convex capsule;

  private final Core own = new Core();
  private final Core other = new Core();
  private final Gjk gjk = new Gjk();
  private final Sat sat = new Sat();
  private final Mtv mtv = new Mtv();
  private final Transform ownPose = new Transform();
  private final Transform pose = new Transform();

  private Convex[] convex = new Convex[16];
  private Body<?>[] bodies = new Body<?>[16];
  private int[] shapes = new int[16];
  private float[] poses = new float[64];
  private boolean[] skipped = new boolean[16];
  private int count;
  private final PartVisitor<T> adding = this::add;

  private double originX;
  private double originY;

  // What measure() found.

  /** Gap between capsule and part, m; negative if they overlap. */
  double gap;

  /** Unit normal out of the part, towards the capsule. */
  double normalX;

  double normalY;

  /** Point of the part that is nearest. */
  double pointX;

  double pointY;

  /** True if the nearest point is a sharp corner. */
  boolean corner;

  /** Normal of the surface that the mover would stand on: of a corner, its uppermost face. */
  double faceX;

  double faceY;

  /** Part that {@link #cast} hit, -1 for none. */
  int hit;

  Surroundings(MoverDef<T> def) {
    radius = def.radius;
    half = Math.max(0, 0.5 * def.height - def.radius);
    upX = def.upX;
    upY = def.upY;
    float x = (float) (half * upX);
    float y = (float) (half * upY);
    capsule = half < 1e-4 ? new Circle(def.radius) : new Capsule(-x, -y, x, y, def.radius);
  }

  /** Collects the parts in an area. Points are relative to the given origin from now on. */
  void collect(World<T> world, Aabb area, QueryFilter<T> filter, double x, double y) {
    originX = x;
    originY = y;
    count = 0;
    world.queries().parts(area, filter, adding);
  }

  /** Releases bodies and shapes, so that the garbage collector can free an unused world. */
  void clear() {
    Arrays.fill(bodies, 0, count, null);
    Arrays.fill(convex, 0, count, null);
    count = 0;
  }

  private boolean add(Body<T> body, int shape, Convex part, Transform at) {
    if (count == convex.length) {
      convex = Arrays.copyOf(convex, count * 2);
      bodies = Arrays.copyOf(bodies, count * 2);
      shapes = Arrays.copyOf(shapes, count * 2);
      poses = Arrays.copyOf(poses, count * 8);
      skipped = Arrays.copyOf(skipped, count * 2);
    }
    convex[count] = part;
    bodies[count] = body;
    shapes[count] = shape;
    poses[4 * count] = at.x;
    poses[4 * count + 1] = at.y;
    poses[4 * count + 2] = at.cos;
    poses[4 * count + 3] = at.sin;
    skipped[count++] = false;
    return true;
  }

  int count() {
    return count;
  }

  /** Returns the body of a part. The cast is safe, as the bodies come from a world of T. */
  @SuppressWarnings("unchecked")
  Body<T> body(int i) {
    return (Body<T>) bodies[i];
  }

  int shape(int i) {
    return shapes[i];
  }

  /** Leaves a part out of this move. */
  void skip(int i) {
    skipped[i] = true;
  }

  /**
   * Returns how far the lowest point of a capsule at (x, y) is above the uppermost face of a part,
   * m, and sets {@link #faceX} and {@link #faceY} to that face's normal.
   */
  double above(int i, double x, double y) {
    Convex part = convex[i];
    place(i);
    int best = -1;
    if (part.vertexCount() > 1) {
      for (int edge = 0; edge < part.vertexCount(); edge++) {
        if (best < 0 || upward(part, i, edge) > upward(part, i, best)) {
          best = edge;
        }
      }
    }
    faceX = best < 0 ? upX : turnedX(part, i, best);
    faceY = best < 0 ? upY : turnedY(part, i, best);
    int vertex = Math.max(0, best);
    double fx = x - half * upX - other.x[vertex];
    double fy = y - half * upY - other.y[vertex];
    return fx * faceX + fy * faceY - radius - part.radius();
  }

  private double turnedX(Convex part, int i, int edge) {
    return (double) poses[4 * i + 2] * part.normalX(edge)
        - (double) poses[4 * i + 3] * part.normalY(edge);
  }

  private double turnedY(Convex part, int i, int edge) {
    return (double) poses[4 * i + 3] * part.normalX(edge)
        + (double) poses[4 * i + 2] * part.normalY(edge);
  }

  private double upward(Convex part, int i, int edge) {
    return turnedX(part, i, edge) * upX + turnedY(part, i, edge) * upY;
  }

  private void place(int i) {
    other.place(
        convex[i],
        poses[4 * i] - originX,
        poses[4 * i + 1] - originY,
        poses[4 * i + 2],
        poses[4 * i + 3]);
  }

  private void placeCapsule(double x, double y) {
    own.radius = radius;
    own.count = capsule.vertexCount();
    own.x[0] = x - half * upX;
    own.y[0] = y - half * upY;
    if (own.count > 1) {
      own.x[1] = x + half * upX;
      own.y[1] = y + half * upY;
    } else {
      own.x[0] = x;
      own.y[0] = y;
    }
  }

  /**
   * Measures the gap between a capsule at (x, y) and a part.
   *
   * @return false if the part is left out, or if the capsule is behind a one-sided segment
   */
  boolean measure(int i, double x, double y) {
    if (skipped[i]) {
      return false;
    }
    place(i);
    return measurePlaced(i, x, y);
  }

  private boolean measurePlaced(int i, double x, double y) {
    Convex part = convex[i];
    placeCapsule(x, y);
    boolean front = part instanceof Segment && ((Segment) part).isOneSided();
    if (front && height(part, i, x, y) < 0) {
      return false;
    }
    gjk.run(own, other);
    if (gjk.distance > 0) {
      normalX = -gjk.normalX;
      normalY = -gjk.normalY;
      gap = gjk.distance - radius - part.radius();
      double reach = gjk.distance - part.radius();
      pointX = gjk.ax + reach * gjk.normalX;
      pointY = gjk.ay + reach * gjk.normalY;
      if (front && normalX * turnedX(part, i, 0) + normalY * turnedY(part, i, 0) < 0) {
        return false;
      }
      findFace(part, i, gjk.b0, gjk.b0 == gjk.b1);
    } else if (front) {
      double low = height(part, i, own.x[0], own.y[0]);
      low = Math.min(low, height(part, i, own.x[own.count - 1], own.y[own.count - 1]));
      overlap(turnedX(part, i, 0), turnedY(part, i, 0), low - radius);
    } else {
      ownPose.set((float) x, (float) y, 1, 0);
      pose.set(
          (float) (poses[4 * i] - originX),
          (float) (poses[4 * i + 1] - originY),
          poses[4 * i + 2],
          poses[4 * i + 3]);
      sat.mtv(capsule, ownPose, part, pose, mtv);
      double depth = mtv.length();
      boolean any = depth > 0;
      overlap(any ? mtv.x / depth : upX, any ? mtv.y / depth : upY, -depth);
    }
    return true;
  }

  /** Returns how far a point is in front of a segment's line, m. */
  private double height(Convex segment, int i, double x, double y) {
    return turnedX(segment, i, 0) * (x - other.x[0]) + turnedY(segment, i, 0) * (y - other.y[0]);
  }

  private void overlap(double nx, double ny, double negativeDepth) {
    normalX = nx;
    normalY = ny;
    gap = negativeDepth;
    pointX = own.x[0] - radius * nx;
    pointY = own.y[0] - radius * ny;
    corner = false;
    faceX = nx;
    faceY = ny;
  }

  private void findFace(Convex part, int i, int vertex, boolean isVertex) {
    corner = isVertex && part.radius() == 0;
    faceX = normalX;
    faceY = normalY;
    if (corner) {
      int before = vertex == 0 ? part.vertexCount() - 1 : vertex - 1;
      boolean oneSided = part instanceof Segment && ((Segment) part).isOneSided();
      int first = oneSided ? 0 : vertex;
      int edge = !oneSided && upward(part, i, before) > upward(part, i, first) ? before : first;
      faceX = turnedX(part, i, edge);
      faceY = turnedY(part, i, edge);
    }
  }

  /**
   * Moves a capsule until its gap to a part is {@code skin}. A part that is nearer from the
   * beginning stops it only if the motion comes nearer still, by more than {@code slack}.
   *
   * <p>The method is conservative advancement (Mirtich 1996), as in {@link
   * carom.physics.collision.Cast}. Of equally near hits the first part is taken.
   *
   * @return fraction of the way, 0..1; {@link #hit} is the part that ended it, or -1
   */
  double cast(double x, double y, double dx, double dy, double skin, double slack) {
    hit = -1;
    double way = Math.sqrt(dx * dx + dy * dy);
    double best = 1;
    double result = 1;
    for (int i = 0; i < count; i++) {
      if (!measure(i, x, y) || gap > way * best + skin) {
        continue;
      }
      double target = Math.min(skin, gap) - slack;
      double at = 0;
      for (int step = 0; step < MAX_STEPS; step++) {
        double rate = -(normalX * dx + normalY * dy);
        boolean arrived = gap <= target + ARRIVED || step == MAX_STEPS - 1;
        if (!(rate > 1e-12)) {
          break;
        }
        if (arrived) {
          best = at;
          result = Math.max(0, at - Math.max(0, skin - gap) / rate);
          hit = i;
          break;
        }
        at += (gap - target) / rate;
        if (!(at < best) || !measurePlaced(i, x + at * dx, y + at * dy)) {
          break;
        }
      }
    }
    return result;
  }
}
