package carom.physics.collision;

import carom.physics.geometry.Convex;
import carom.physics.math.Limits;
import carom.physics.math.Trig;

/**
 * Finds when two convex shapes that move and turn come within a given distance of each other. An
 * instance holds scratch memory, so use one per thread; no call allocates.
 *
 * <p><b>Method</b> (Catto, "Continuous collision", GDC 2013). At the present time the closest
 * features give an axis along which the shapes are apart: the direction between two vertices, or an
 * edge's normal that turns with its shape. The search then finds the latest time at which the axis
 * still separates them. It takes the deepest vertices at the end and goes back to where these reach
 * the target distance, until none is too deep. That time is the new present. This repeats until the
 * shapes themselves are within the target. Every root is bracketed, every loop is bounded.
 *
 * <p><b>Turning.</b> While shapes turn, a separation along an axis may dip and recover between two
 * times. The second derivative bounds how far. Turn, speed and reach give an upper bound K for it:
 * between two values s0 and s1 over a time u of 0 to 1 the separation is at least {@code s0 + (s1 -
 * s0) u - K u (1 - u) / 2}. Where that doesn't stay above the target, the time is halved and the
 * bound checked again. So no contact is missed, however fast a shape spins.
 *
 * <p>The result depends on the arguments alone, bit for bit.
 */
public final class TimeOfImpact {
  /** The outcome of a search: what happens during the motion. */
  public enum State {
    /** The shapes stay farther apart than the target. */
    SEPARATED,
    /** The shapes reach the target distance at {@link #fraction()}. */
    TOUCHING,
    /** The shapes overlap when the motion starts; the fraction is 0. */
    OVERLAPPING,
    /**
     * The bounded search ended early; up to {@link #fraction()} the motion is safe. This happens at
     * most in long grazing motion with fast turning.
     */
    UNDECIDED
  }

  /** Smallest target distance, metres. */
  public static final float MIN_TARGET = 7.5e-5f;

  private static final int MAX_ROUNDS = 256;
  private static final int MAX_PUSHES = 16;
  private static final int MAX_ROOT_STEPS = 48;

  private final Hull hullA = new Hull();
  private final Hull hullB = new Hull();
  private final Core coreA = new Core();
  private final Core coreB = new Core();
  private final Gjk gjk = new Gjk();
  private final Pose poseA = new Pose();
  private final Pose poseB = new Pose();

  private Sweep sweepA;
  private Sweep sweepB;

  private enum Axis {
    FIXED,
    FACE_OF_A,
    FACE_OF_B
  }

  private Axis axis = Axis.FIXED;

  // The axis in the frame it belongs to, and a point of the face.
  private double axisX;
  private double axisY;
  private double faceX;
  private double faceY;

  // The deepest vertices found by the last call of deepest().
  private int vertexA;
  private int vertexB;

  private double now;
  private float fraction;

  /** Makes an instance with its own scratch memory. */
  public TimeOfImpact() {}

  /** The vertices of a shape in its frame, perhaps shrunk. */
  private static final class Hull {
    private final double[] x = new double[Convex.MAX_VERTICES];
    private final double[] y = new double[Convex.MAX_VERTICES];
    private int count;
    private double radius;

    /**
     * Distance of the farthest vertex from the frame's origin, m; it bounds how far turning moves a
     * vertex.
     */
    private double reach;

    void set(Convex shape, float inset) {
      count = shape.vertexCount();
      radius = Math.max(0, shape.radius() - inset);
      for (int i = 0; i < count; i++) {
        x[i] = shape.vertexX(i);
        y[i] = shape.vertexY(i);
      }
      double rest = (double) inset - shape.radius();
      if (rest > 0 && !(count > 2 && moveSides(shape, rest))) {
        scale(shape, rest);
      }
      double square = 0;
      for (int i = 0; i < count; i++) {
        square = Math.max(square, x[i] * x[i] + y[i] * y[i]);
      }
      reach = Math.sqrt(square);
    }

    /** Moves each side inwards. Returns false, and changes nothing, if a side would vanish. */
    private boolean moveSides(Convex shape, double inset) {
      for (int i = 0; i < count; i++) {
        int next = i + 1 == count ? 0 : i + 1;
        double ex = x[next] - x[i];
        double ey = y[next] - y[i];
        double length = Math.sqrt(ex * ex + ey * ey);
        if (!(inset * (slant(shape, i) + slant(shape, next)) < length)) {
          return false;
        }
      }
      for (int i = 0; i < count; i++) {
        int before = i == 0 ? count - 1 : i - 1;
        double nx = (double) shape.normalX(before) + shape.normalX(i);
        double ny = (double) shape.normalY(before) + shape.normalY(i);
        double along = 0.5 * (nx * nx + ny * ny);
        x[i] -= inset * nx / along;
        y[i] -= inset * ny / along;
      }
      return true;
    }

    /**
     * Returns by how much a side gets shorter at one end when it moves inwards by one: tan(turn /
     * 2).
     */
    private static double slant(Convex shape, int vertex) {
      int before = vertex == 0 ? shape.vertexCount() - 1 : vertex - 1;
      double cos =
          (double) shape.normalX(before) * shape.normalX(vertex)
              + (double) shape.normalY(before) * shape.normalY(vertex);
      return Math.sqrt(Math.max(0, 1 - cos) / Math.max(1e-12, 1 + cos));
    }

    /**
     * Moves the vertices towards their mean, so that every side moves inwards by at least the
     * inset.
     */
    private void scale(Convex shape, double inset) {
      double inner = shape.innerRadius() - (double) shape.radius();
      double keep = inset < inner ? 1 - inset / inner : 0;
      double middleX = 0;
      double middleY = 0;
      for (int i = 0; i < count; i++) {
        middleX += x[i] / count;
        middleY += y[i] / count;
      }
      for (int i = 0; i < count; i++) {
        x[i] = middleX + keep * (x[i] - middleX);
        y[i] = middleY + keep * (y[i] - middleY);
      }
      if (keep == 0) {
        count = 1;
      }
    }
  }

  /** Position and rotation at a moment, relative to where A starts. */
  private static final class Pose {
    private double x;
    private double y;
    private double cos;
    private double sin;

    void set(Sweep s, double t, double originX, double originY) {
      x = s.x - originX + t * s.dx;
      y = s.y - originY + t * s.dy;
      cos = s.cos;
      sin = s.sin;
      if (s.angleRad != 0) {
        float turn = (float) (t * s.angleRad);
        double c = Trig.cos(turn);
        double n = Trig.sin(turn);
        cos = s.cos * c - s.sin * n;
        sin = s.sin * c + s.cos * n;
      }
    }

    double x(double px, double py) {
      return x + (cos * px - sin * py);
    }

    double y(double px, double py) {
      return y + (sin * px + cos * py);
    }
  }

  /**
   * Finds the first moment at which the surfaces are {@code target} apart, within a quarter of it.
   *
   * @param a shape A in its frame
   * @param sa motion of A's frame, read only, finite
   * @param b shape B in its frame
   * @param sb motion of B's frame, read only, finite
   * @param target metres, at least {@link #MIN_TARGET}: stopping short of contact keeps the normal
   *     reliable and leaves room for rounding
   * @return what happens
   * @throws IllegalArgumentException if the target is too small
   */
  public State find(Convex a, Sweep sa, Convex b, Sweep sb, float target) {
    return find(a, 0, sa, b, sb, target);
  }

  /**
   * Finds what {@link #find(Convex, Sweep, Convex, Sweep, float)} finds, with a smaller shape A,
   * which may pass where only its rim would touch.
   *
   * @param a shape A in its frame
   * @param inset how much smaller A is on all sides, metres, not negative. If it is at least the
   *     {@link Convex#innerRadius()}, only the mean of the vertices is left
   * @param sa motion of A's frame, read only, finite
   * @param b shape B in its frame
   * @param sb motion of B's frame, read only, finite
   * @param target metres, at least {@link #MIN_TARGET}, from what is left of A
   * @return what happens
   * @throws IllegalArgumentException if the target is too small
   */
  public State find(Convex a, float inset, Sweep sa, Convex b, Sweep sb, float target) {
    Limits.notNull("a", a);
    Limits.notNull("sa", sa);
    Limits.notNull("b", b);
    Limits.notNull("sb", sb);
    if (!(target >= MIN_TARGET)) {
      throw new IllegalArgumentException(
          "target=" + target + " m must be >= " + MIN_TARGET + ": the search needs some room");
    }
    hullA.set(a, inset);
    hullB.set(b, 0);
    sweepA = sa;
    sweepB = sb;
    double goal = hullA.radius + hullB.radius + target;
    State state = search(goal, 0.25 * target);
    fraction = state == State.SEPARATED ? 1 : (float) now;
    if (fraction > now && state != State.SEPARATED) {
      fraction = Math.nextDown(fraction);
    }
    return state;
  }

  /**
   * Returns the fraction of the motion, 0..1, that the last {@link #find} found. Up to it the
   * motion is safe. It is 1 if the shapes stay apart.
   */
  public float fraction() {
    return fraction;
  }

  private State search(double goal, double tolerance) {
    // Half of the target is reserved for the rounding of the search.
    double floor = goal - 2 * tolerance;
    now = 0;
    double window = 1;
    for (int round = 0; round < MAX_ROUNDS; round++) {
      moveTo(now);
      place();
      gjk.run(coreA, coreB);
      if (gjk.overlap || gjk.distance <= coreA.radius + coreB.radius) {
        return now > 0 ? State.TOUCHING : State.OVERLAPPING;
      }
      if (gjk.distance <= goal + tolerance) {
        return State.TOUCHING;
      }
      chooseAxis();
      double apart = gjk.distance;
      double end = Math.min(1, now + window);
      double time = end;
      double separation = 0;
      boolean found = false;
      for (int push = 0; push < MAX_PUSHES && !found; push++) {
        moveTo(time);
        separation = deepest();
        found = separation >= goal - tolerance;
        if (!found) {
          moveTo(now);
          double before = separation(vertexA, vertexB);
          if (before <= goal + tolerance) {
            return before < goal - tolerance ? State.UNDECIDED : State.TOUCHING;
          }
          time = root(now, before, time, separation, goal, tolerance);
        }
      }
      double length = time - now;
      if (!found || !holds(apart, separation, bend() * length * length, floor)) {
        window = 0.5 * length;
        continue;
      }
      if (time == 1 && separation > goal + tolerance) {
        return State.SEPARATED;
      }
      now = time;
      window = 2 * length;
    }
    return State.UNDECIDED;
  }

  /**
   * Returns whether a separation that starts at s0 and ends at s1 stays at or above a floor in
   * between.
   */
  private static boolean holds(double s0, double s1, double bend, double floor) {
    if (!(bend > 0)) {
      return true;
    }
    double u = Math.max(0, Math.min(1, 0.5 - (s1 - s0) / bend));
    return s0 + (s1 - s0) * u - 0.5 * bend * u * (1 - u) >= floor;
  }

  /**
   * Returns an upper bound of the second derivative of the separation along the axis, m per motion
   * squared.
   */
  private double bend() {
    double wa = Math.abs(sweepA.angleRad);
    double wb = Math.abs(sweepB.angleRad);
    double ra = hullA.reach;
    double rb = hullB.reach;
    double vx = (double) sweepB.dx - sweepA.dx;
    double vy = (double) sweepB.dy - sweepA.dy;
    double way = Math.sqrt(vx * vx + vy * vy);
    double x = (double) sweepB.x - sweepA.x;
    double y = (double) sweepB.y - sweepA.y;
    double far = Math.sqrt(x * x + y * y) + way;
    return switch (axis) {
      case FIXED -> wa * wa * ra + wb * wb * rb;
      case FACE_OF_A -> wa * wa * (far + rb) + 2 * wa * (way + wb * rb) + wb * wb * rb;
      case FACE_OF_B -> wb * wb * (far + ra) + 2 * wb * (way + wa * ra) + wa * wa * ra;
    };
  }

  private void moveTo(double time) {
    poseA.set(sweepA, time, sweepA.x, sweepA.y);
    poseB.set(sweepB, time, sweepA.x, sweepA.y);
  }

  private void place() {
    place(hullA, poseA, coreA);
    place(hullB, poseB, coreB);
  }

  private static void place(Hull hull, Pose pose, Core core) {
    core.count = hull.count;
    core.radius = hull.radius;
    for (int i = 0; i < hull.count; i++) {
      core.x[i] = pose.x(hull.x[i], hull.y[i]);
      core.y[i] = pose.y(hull.x[i], hull.y[i]);
    }
  }

  /** Takes the axis from the closest features at the present time. */
  private void chooseAxis() {
    if (gjk.a0 != gjk.a1) {
      axis = Axis.FACE_OF_A;
      takeFace(hullA, gjk.a0, poseA, gjk.normalX, gjk.normalY);
    } else if (gjk.b0 != gjk.b1) {
      axis = Axis.FACE_OF_B;
      takeFace(hullB, gjk.b0, poseB, -gjk.normalX, -gjk.normalY);
    } else {
      axis = Axis.FIXED;
      axisX = gjk.normalX;
      axisY = gjk.normalY;
    }
  }

  private void takeFace(Hull hull, int vertex, Pose pose, double nx, double ny) {
    axisX = pose.cos * nx + pose.sin * ny;
    axisY = pose.cos * ny - pose.sin * nx;
    faceX = hull.x[vertex];
    faceY = hull.y[vertex];
  }

  /**
   * Returns the smallest separation along the axis in the present poses, and remembers the
   * vertices.
   */
  private double deepest() {
    vertexA = 0;
    vertexB = 0;
    place();
    switch (axis) {
      case FIXED -> {
        vertexA = coreA.support(axisX, axisY);
        vertexB = coreB.support(-axisX, -axisY);
      }
      case FACE_OF_A -> {
        double nx = poseA.cos * axisX - poseA.sin * axisY;
        double ny = poseA.sin * axisX + poseA.cos * axisY;
        vertexB = coreB.support(-nx, -ny);
      }
      case FACE_OF_B -> {
        double nx = poseB.cos * axisX - poseB.sin * axisY;
        double ny = poseB.sin * axisX + poseB.cos * axisY;
        vertexA = coreA.support(-nx, -ny);
      }
    }
    return separation(vertexA, vertexB);
  }

  /**
   * Returns the separation of two vertices (or a face and a vertex) along the axis in the present
   * poses.
   */
  private double separation(int i, int j) {
    double ax = poseA.x(hullA.x[i], hullA.y[i]);
    double ay = poseA.y(hullA.x[i], hullA.y[i]);
    double bx = poseB.x(hullB.x[j], hullB.y[j]);
    double by = poseB.y(hullB.x[j], hullB.y[j]);
    switch (axis) {
      case FACE_OF_A -> {
        double nx = poseA.cos * axisX - poseA.sin * axisY;
        double ny = poseA.sin * axisX + poseA.cos * axisY;
        return nx * (bx - poseA.x(faceX, faceY)) + ny * (by - poseA.y(faceX, faceY));
      }
      case FACE_OF_B -> {
        double nx = poseB.cos * axisX - poseB.sin * axisY;
        double ny = poseB.sin * axisX + poseB.cos * axisY;
        return nx * (ax - poseB.x(faceX, faceY)) + ny * (ay - poseB.y(faceX, faceY));
      }
      default -> {
        return axisX * (bx - ax) + axisY * (by - ay);
      }
    }
  }

  /**
   * Returns the moment at which two vertices are at the goal, found by false position and bisection
   * in turns. If the bound on steps is reached, it is the earlier end of the bracket.
   */
  private double root(
      double early, double high, double late, double low, double goal, double tolerance) {
    double t0 = early;
    double s0 = high;
    double t1 = late;
    double s1 = low;
    for (int step = 0; step < MAX_ROOT_STEPS; step++) {
      double t = (step & 1) == 0 ? t0 + (s0 - goal) * (t1 - t0) / (s0 - s1) : 0.5 * (t0 + t1);
      moveTo(t);
      double s = separation(vertexA, vertexB);
      if (Math.abs(s - goal) <= 0.5 * tolerance) {
        return t;
      }
      if (s > goal) {
        t0 = t;
        s0 = s;
      } else {
        t1 = t;
        s1 = s;
      }
    }
    return t0;
  }
}
