package carom.physics.dynamics.narrow;

import carom.physics.collision.Core;
import carom.physics.collision.Gjk;
import carom.physics.collision.Sweep;
import carom.physics.collision.TimeOfImpact;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.body.ShapeTable;
import carom.physics.dynamics.contact.ContactTable;
import carom.physics.geometry.Convex;
import carom.physics.math.Transform;
import carom.physics.settings.Settings;
import java.util.Arrays;

/**
 * Predicts whether shapes with a gap between them meet within the step. One per worker.
 *
 * <p>A contact keeps its normal for a whole step. Two shapes that pass each other with a gap may
 * come closer along that normal by more than the gap, and would be pushed though they never meet:
 *
 * <pre>
 *        +-------+                       +-------+
 *        |   B   | --&gt;                   |   B   |
 *        +-------+                       +-------+
 *                 \ n     +-----+    a step later    +-----+
 *                  \      |  A  |                    |  A  |
 * </pre>
 *
 * <p>So where the free motion of this step would close a gap along the normal, the shapes are swept
 * along it. What misses by more than {@value TimeOfImpact#MIN_TARGET} m has no contact. Where the
 * motion doesn't close the gap, the contact stays in reserve: blows and joints may change the
 * motion within the step. It touches only when it has pushed.
 *
 * <p><b>Free motion</b> is that by velocities, gravity, forces and damping, substep by substep.
 * What other contacts and joints do within the step isn't predicted.
 */
final class MissFinder {
  /** Verdict: the free motion doesn't close the gap. */
  static final int APART = 0;

  /** Verdict: the shapes pass each other. */
  static final int MISS = 1;

  /** Verdict: the shapes meet. */
  static final int MEET = 2;

  /** Most straight stretches that shapes are swept along. */
  private static final int STRETCHES = 5;

  /** Distance of a disc from the centre of its body that doesn't count, in radii. */
  private static final float OFF_CENTRE = 1e-4f;

  // Places of what a body's sums say: where it is, and its way by its speed, by acceleration, and
  // its turn.
  private static final int PLACE_X = 0;
  private static final int PLACE_Y = 1;
  private static final int WAY_X = 2;
  private static final int WAY_Y = 3;
  private static final int FALL_X = 4;
  private static final int FALL_Y = 5;
  private static final int TURN = 6;
  private static final int STAMP = 7;
  private static final int SUM = 8;

  /** Number of steps after which stamps begin anew; floats count so far. */
  private static final float MOST_STAMPS = 1 << 23;

  /** Slide that makes no difference to whether shapes meet, m. */
  private static final float STRAIGHT = 0.5f * TimeOfImpact.MIN_TARGET;

  /** Part of a flat contact's width by which shapes may slide and surely still meet. */
  private static final float SURE = 0.5f;

  private final Settings settings;
  private final BodyStore bodies;
  private final ShapeTable parts;
  private final ContactTable contacts;
  private final TimeOfImpact timeOfImpact = new TimeOfImpact();
  private final Path pathA = new Path();
  private final Path pathB = new Path();
  private final Sweep sweepA = new Sweep();
  private final Sweep sweepB = new Sweep();
  private final Transform end = new Transform();
  private final Core coreA = new Core();
  private final Core coreB = new Core();
  private final Gjk gjk = new Gjk();

  /** {@link #SUM} numbers per body, valid if stamped in this step. */
  private float[] sums = new float[0];

  private float stamp;

  /** Number of substeps of a prediction. */
  private int substeps;

  /** Length of a substep, s. */
  private float h;

  /** True if the gap is closed after some substep; the numbers below are of the first one. */
  private boolean overlaps;

  private float overlapX;
  private float overlapY;
  private float overlapCosA;
  private float overlapSinA;
  private float overlapCosB;
  private float overlapSinB;

  /** Slide of B's point along A's, m. */
  private float slide;

  /** The free motion of a body: its ways and turns in each substep. */
  private static final class Path {
    private float[] dx = new float[0];
    private float[] dy = new float[0];
    private float[] turn = new float[0];

    void reserve(int count) {
      if (dx.length < count) {
        dx = new float[count];
        dy = new float[count];
        turn = new float[count];
      }
    }
  }

  MissFinder(Settings settings, BodyStore bodies, ShapeTable parts, ContactTable contacts) {
    this.settings = settings;
    this.bodies = bodies;
    this.parts = parts;
    this.contacts = contacts;
  }

  /**
   * Begins a step. The prediction is one substep longer than the step: the last visit of a contact
   * bounds the speed with which bodies go on.
   *
   * @param dt its length, s
   */
  void begin(float dt) {
    stamp++;
    if (stamp == MOST_STAMPS) {
      stamp = 1;
      Arrays.fill(sums, 0);
    }
    substeps = settings.substeps() + 1;
    h = dt / settings.substeps();
    pathA.reserve(substeps);
    pathB.reserve(substeps);
    if (sums.length < SUM * bodies.type.length) {
      sums = new float[SUM * bodies.type.length];
    }
  }

  /** Returns the verdict on a row whose points all have a gap. */
  int judge(int row) {
    int a = contacts.bodyA(row);
    int b = contacts.bodyB(row);
    float[] c = contacts.contact;
    int at = row * ContactTable.CONTACT;
    find(a, pathA);
    find(b, pathB);
    overlaps = false;
    boolean closes = closes(row, at + ContactTable.X0);
    float most = Math.abs(slide);
    float sure = STRAIGHT;
    if (contacts.points[row] > 1) {
      boolean second = closes(row, at + ContactTable.X1);
      most = Math.max(most, Math.abs(slide));
      if (closes && second) {
        float x = c[at + ContactTable.X1] - c[at + ContactTable.X0];
        float y = c[at + ContactTable.Y1] - c[at + ContactTable.Y0];
        float width = Math.abs(y * c[at + ContactTable.NX] - x * c[at + ContactTable.NY]);
        sure = Math.max(STRAIGHT, SURE * width);
      }
      closes |= second;
    }
    if (!closes) {
      return APART;
    }
    if (most < sure && !isTurning(a, b, most)) {
      return MEET;
    }
    if (overlaps && overlap(row, a, b)) {
      return MEET;
    }
    return meet(row) ? MEET : MISS;
  }

  /** Returns whether the parts of a row come so close that they touch, whatever its points say. */
  boolean meets(int row) {
    find(contacts.bodyA(row), pathA);
    find(contacts.bodyB(row), pathB);
    return meet(row);
  }

  private boolean meet(int row) {
    boolean straight = isStraight(contacts.bodyA(row), contacts.bodyB(row));
    int stretches = straight ? 1 : Math.min(STRETCHES, substeps);
    return areDiscs(row) ? discsMeet(row, stretches) : shapesMeet(row, stretches);
  }

  /** Returns whether bodies turn so far that a gap may close along its normal and yet be there. */
  private boolean isTurning(int a, int b, float slideM) {
    float turnA = 0;
    float turnB = 0;
    for (int i = 0; i < substeps; i++) {
      turnA += Math.abs(pathA.turn[i]);
      turnB += Math.abs(pathB.turn[i]);
    }
    float swing = turnA * bodies.reach[a] + turnB * bodies.reach[b];
    return (turnA + turnB) * (slideM + swing) > STRAIGHT;
  }

  /** Returns whether both shapes are discs about the centres of their bodies, as in a gas. */
  private boolean areDiscs(int row) {
    return isCentred(contacts.part[2 * row]) && isCentred(contacts.part[2 * row + 1]);
  }

  private boolean isCentred(int part) {
    Convex c = parts.convex[part];
    return parts.isDisc(part)
        && Math.abs(c.vertexX(0)) + Math.abs(c.vertexY(0)) < OFF_CENTRE * c.radius();
  }

  /**
   * Returns whether bodies are surely too slow to close the gaps of a row. Most are, and this asks
   * for a fraction of what {@link #closes} takes.
   */
  boolean areSlow(int row) {
    int i = sum(contacts.bodyA(row));
    int j = sum(contacts.bodyB(row));
    int at = row * ContactTable.CONTACT;
    return isSlow(at, at + ContactTable.X0, i, j)
        && (contacts.points[row] == 1 || isSlow(at, at + ContactTable.X1, i, j));
  }

  private boolean isSlow(int at, int point, int i, int j) {
    float[] c = contacts.contact;
    float[] s = sums;
    float nx = c[at + ContactTable.NX];
    float ny = c[at + ContactTable.NY];
    float ax = c[point];
    float ay = c[point + 1];
    float bx = ax - (s[j + PLACE_X] - s[i + PLACE_X]);
    float by = ay - (s[j + PLACE_Y] - s[i + PLACE_Y]);
    float turnA = s[i + TURN];
    float turnB = s[j + TURN];
    float bySpeed =
        nx * (s[i + WAY_X] - turnA * ay - (s[j + WAY_X] - turnB * by))
            + ny * (s[i + WAY_Y] + turnA * ax - (s[j + WAY_Y] + turnB * bx));
    float byForce = nx * (s[i + FALL_X] - s[j + FALL_X]) + ny * (s[i + FALL_Y] - s[j + FALL_Y]);
    float byBend =
        turnA * turnA * (Math.abs(ax) + Math.abs(ay))
            + turnB * turnB * (Math.abs(bx) + Math.abs(by));
    float gap = c[point + ContactTable.GAP0 - ContactTable.X0];
    return Math.max(0, bySpeed) + Math.max(0, byForce) + byBend < gap;
  }

  /** Returns where the sums of a body are, and makes them if it has none in this step. */
  private int sum(int body) {
    int at = SUM * body;
    if (sums[at + STAMP] == stamp) {
      return at;
    }
    Arrays.fill(sums, at, at + STAMP, 0);
    sums[at + STAMP] = stamp;
    sums[at + PLACE_X] = bodies.x[body];
    sums[at + PLACE_Y] = bodies.y[body];
    if (!moves(body)) {
      return at;
    }
    float seconds = h * substeps;
    sums[at + WAY_X] = seconds * bodies.vx[body];
    sums[at + WAY_Y] = seconds * bodies.vy[body];
    sums[at + TURN] = seconds * bodies.w[body];
    if (bodies.type[body] == BodyStore.DYNAMIC) {
      sums[at + FALL_X] = seconds * seconds * accelerationX(body);
      sums[at + FALL_Y] = seconds * seconds * accelerationY(body);
      if (!isFree(body)) {
        sums[at + TURN] = Float.NaN; // nothing about it is sure
      }
    }
    return at;
  }

  private boolean moves(int body) {
    return bodies.type[body] != BodyStore.STATIC && !bodies.asleep(body);
  }

  private float accelerationX(int body) {
    return bodies.gravityScale[body] * settings.gravityX()
        + bodies.invMass[body] * bodies.forceX[body];
  }

  private float accelerationY(int body) {
    return bodies.gravityScale[body] * settings.gravityY()
        + bodies.invMass[body] * bodies.forceY[body];
  }

  /** Returns whether two bodies move straight, one seen from the other. */
  private boolean isStraight(int a, int b) {
    int i = sum(a);
    int j = sum(b);
    return isFree(a)
        && isFree(b)
        && sums[i + FALL_X] == sums[j + FALL_X]
        && sums[i + FALL_Y] == sums[j + FALL_Y];
  }

  private boolean isFree(int body) {
    return bodies.linearDamping[body] == 0
        && bodies.angularDamping[body] == 0
        && bodies.torque[body] == 0
        && bodies.linearLocks(body) == 0;
  }

  /** Finds the path of a body, as the integrator will move it. */
  private void find(int body, Path path) {
    boolean dynamic = bodies.type[body] == BodyStore.DYNAMIC;
    boolean rests = !moves(body);
    float vx = rests ? 0 : bodies.vx[body];
    float vy = rests ? 0 : bodies.vy[body];
    float w = rests ? 0 : bodies.w[body];
    dynamic &= !rests;
    int locks = bodies.linearLocks(body);
    boolean freeX = dynamic && (locks & BodyStore.LOCK_X) == 0;
    boolean freeY = dynamic && (locks & BodyStore.LOCK_Y) == 0;
    float linear = 1 / (1 + h * bodies.linearDamping[body]);
    float angular = dynamic ? 1 / (1 + h * bodies.angularDamping[body]) : 1;
    float addX = freeX ? h * accelerationX(body) : 0;
    float addY = freeY ? h * accelerationY(body) : 0;
    float addW = dynamic ? h * bodies.invInertia[body] * bodies.torque[body] : 0;
    boolean explicit = settings.explicitEuler();
    for (int i = 0; i < substeps; i++) {
      float nextX = (vx + addX) * (freeX ? linear : 1);
      float nextY = (vy + addY) * (freeY ? linear : 1);
      float nextW = (w + addW) * angular;
      path.dx[i] = h * (explicit ? vx : nextX);
      path.dy[i] = h * (explicit ? vy : nextY);
      path.turn[i] = h * (explicit ? w : nextW);
      vx = nextX;
      vy = nextY;
      w = nextW;
    }
  }

  /**
   * Returns whether the solver would push at a point of a row, whose place is given, if the motion
   * is free. It asks as the solver does: in each substep, whether the gap of before or that of
   * after would be closed by one more substep at the present velocity.
   */
  private boolean closes(int row, int point) {
    float[] c = contacts.contact;
    int at = row * ContactTable.CONTACT;
    int mixed = row * ContactTable.MATERIAL;
    int a = contacts.bodyA(row);
    int b = contacts.bodyB(row);
    float nx = c[at + ContactTable.NX];
    float ny = c[at + ContactTable.NY];
    float ax = c[point];
    float ay = c[point + 1];
    float bx = ax - (bodies.x[b] - bodies.x[a]);
    float by = ay - (bodies.y[b] - bodies.y[a]);
    float start = c[point + ContactTable.GAP0 - ContactTable.X0];
    float normalArmA = ax * ny - ay * nx;
    float normalArmB = bx * ny - by * nx;
    float tangentArmA = ax * nx + ay * ny;
    float tangentArmB = bx * nx + by * ny;
    // Rounding doesn't turn.
    float roundArmA = tangentArmA - contacts.material[mixed + ContactTable.ROUND_A];
    float roundArmB = tangentArmB + contacts.material[mixed + ContactTable.ROUND_B];
    float dx = 0;
    float dy = 0;
    float cosA = 0;
    float sinA = 0;
    float cosB = 0;
    float sinB = 0;
    float gap = start;
    boolean closes = false;
    for (int i = 0; i < substeps; i++) {
      float moveX = pathB.dx[i] - pathA.dx[i];
      float moveY = pathB.dy[i] - pathA.dy[i];
      float way =
          moveX * nx + moveY * ny + (pathB.turn[i] * normalArmB - pathA.turn[i] * normalArmA);
      closes |= !(gap + way > 0);
      dx += moveX;
      dy += moveY;
      float a2 = pathA.turn[i] * pathA.turn[i];
      float b2 = pathB.turn[i] * pathB.turn[i];
      // As the integrator turns bodies; cosines are less one.
      float stepCosA = -a2 * (0.5f - a2 * (1 / 24f));
      float stepSinA = pathA.turn[i] * (1 - a2 * (1 / 6f));
      float stepCosB = -b2 * (0.5f - b2 * (1 / 24f));
      float stepSinB = pathB.turn[i] * (1 - b2 * (1 / 6f));
      float turnedA = cosA + stepCosA + (cosA * stepCosA - sinA * stepSinA);
      float turnedB = cosB + stepCosB + (cosB * stepCosB - sinB * stepSinB);
      sinA += stepSinA + (sinA * stepCosA + cosA * stepSinA);
      sinB += stepSinB + (sinB * stepCosB + cosB * stepSinB);
      cosA = turnedA;
      cosB = turnedB;
      gap =
          start
              + (dx * nx + dy * ny)
              + (cosB * roundArmB + sinB * normalArmB - (cosA * roundArmA + sinA * normalArmA));
      closes |= !(gap + way > 0);
      if (!(gap > 0) && !overlaps) {
        overlaps = true;
        overlapX = dx;
        overlapY = dy;
        overlapCosA = 1 + cosA;
        overlapSinA = sinA;
        overlapCosB = 1 + cosB;
        overlapSinB = sinB;
      }
    }
    slide = dy * nx - dx * ny + sinB * tangentArmB - sinA * tangentArmA;
    return closes;
  }

  /** Returns whether two discs come so close that they touch. */
  private boolean discsMeet(int row, int stretches) {
    int a = contacts.bodyA(row);
    int b = contacts.bodyB(row);
    float least =
        parts.convex[contacts.part[2 * row]].radius()
            + parts.convex[contacts.part[2 * row + 1]].radius()
            + TimeOfImpact.MIN_TARGET;
    float x = bodies.x[b] - bodies.x[a];
    float y = bodies.y[b] - bodies.y[a];
    for (int i = 0; i < stretches; i++) {
      setStretch(i, stretches);
      float dx = sweepB.dx;
      float dy = sweepB.dy;
      float square = dx * dx + dy * dy;
      float toward = -(x * dx + y * dy);
      float part = toward > 0 ? Math.min(1, toward / square) : 0;
      float nearX = x + part * dx;
      float nearY = y + part * dy;
      if (nearX * nearX + nearY * nearY <= least * least) {
        return true;
      }
      x += dx;
      y += dy;
    }
    return false;
  }

  /** Sets the motion of a stretch: turns of both bodies, and B's way relative to A. */
  private void setStretch(int number, int stretches) {
    sweepA.angleRad = 0;
    sweepB.angleRad = 0;
    sweepB.dx = 0;
    sweepB.dy = 0;
    for (int i = number * substeps / stretches; i < (number + 1) * substeps / stretches; i++) {
      sweepA.angleRad += pathA.turn[i];
      sweepB.angleRad += pathB.turn[i];
      sweepB.dx += pathB.dx[i] - pathA.dx[i];
      sweepB.dy += pathB.dy[i] - pathA.dy[i];
    }
  }

  /**
   * Returns whether the shapes overlap where the gap is first closed. Most that meet do, and this
   * asks for a fraction of what a sweep takes.
   */
  private boolean overlap(int row, int a, int b) {
    place(a, overlapCosA, overlapSinA, 0, 0);
    coreA.place(parts.convex[contacts.part[2 * row]], end, 0, 0);
    float x = bodies.x[b] - bodies.x[a] + overlapX;
    float y = bodies.y[b] - bodies.y[a] + overlapY;
    place(b, overlapCosB, overlapSinB, x, y);
    coreB.place(parts.convex[contacts.part[2 * row + 1]], end, 0, 0);
    gjk.run(coreA, coreB);
    return gjk.distance <= coreA.radius + coreB.radius;
  }

  private void place(int body, float c, float n, float x, float y) {
    float cos = bodies.cos[body];
    float sin = bodies.sin[body];
    end.set(x, y, cos * c - sin * n, sin * c + cos * n);
  }

  private boolean shapesMeet(int row, int stretches) {
    int a = contacts.bodyA(row);
    int b = contacts.bodyB(row);
    Convex shapeA = parts.convex[contacts.part[2 * row]];
    Convex shapeB = parts.convex[contacts.part[2 * row + 1]];
    sweepA.x = 0;
    sweepA.y = 0;
    sweepA.dx = 0;
    sweepA.dy = 0;
    sweepA.cos = bodies.cos[a];
    sweepA.sin = bodies.sin[a];
    sweepB.x = bodies.x[b] - bodies.x[a];
    sweepB.y = bodies.y[b] - bodies.y[a];
    sweepB.cos = bodies.cos[b];
    sweepB.sin = bodies.sin[b];
    for (int i = 0; i < stretches; i++) {
      setStretch(i, stretches);
      if (timeOfImpact.find(shapeA, sweepA, shapeB, sweepB, TimeOfImpact.MIN_TARGET)
          != TimeOfImpact.State.SEPARATED) {
        return true;
      }
      goOn(sweepA);
      goOn(sweepB);
    }
    return false;
  }

  /** Puts the start of a motion to its end. */
  private void goOn(Sweep s) {
    s.at(1, end);
    s.x = end.x;
    s.y = end.y;
    s.cos = end.cos;
    s.sin = end.sin;
  }
}
