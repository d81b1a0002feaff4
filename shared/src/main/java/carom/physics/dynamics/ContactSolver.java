package carom.physics.dynamics;

import static carom.physics.dynamics.SolverBodies.COS;
import static carom.physics.dynamics.SolverBodies.DX;
import static carom.physics.dynamics.SolverBodies.DY;
import static carom.physics.dynamics.SolverBodies.SIN;
import static carom.physics.dynamics.SolverBodies.STRIDE;
import static carom.physics.dynamics.SolverBodies.VX;
import static carom.physics.dynamics.SolverBodies.VY;
import static carom.physics.dynamics.SolverBodies.W;

import java.util.Arrays;

/**
 * Contacts as soft constraints, solved by sequential impulses in substeps.
 *
 * <p><b>One contact point.</b> With the unit normal n from A to B and the lever arms rA, rB, the
 * points part at the speed {@code vn = n . (vB + wB x rB - vA - wA x rA)}. An impulse p along n
 * changes it by {@code p / m}, where {@code 1 / m = 1/mA + 1/mB + (rA x n)^2 / IA + (rB x n)^2 /
 * IB}. A rigid contact asks for vn >= 0 with p >= 0: {@code p = -m vn}, the sum over all visits
 * clamped, not the single impulse, so that a visit can take back what an earlier one gave too much.
 *
 * <p><b>Soft.</b> Overlap must also go away, without the bounce that pushing it out by velocity
 * (Baumgarte) leaves behind. So the point is a damped spring of mass m on the separation s, stepped
 * by implicit Euler, which is stable for any stiffness. With the angular frequency o = 2 pi hertz,
 * stiffness k = m o^2, damping c = 2 m z o (z the damping ratio), substep h and the new velocity
 * v':
 *
 * <pre>
 *   m (v' - v) = -h (k (s + h v') + c v')      spring and damper at the end of the substep
 *   v' = v + p / m                             and what the impulse p does
 * </pre>
 *
 * The impulse of the spring, over the whole substep, is thus {@code P = -h k s - h (h k + c) v'},
 * or
 *
 * <pre>
 *   v' + b s + g P = 0      with  g = 1 / (h (h k + c))  and  b = k / (h k + c) = o / (2 z + h o)
 * </pre>
 *
 * the bias rate b being the share of s that goes away per second.
 *
 * <p>and one visit, which knows v and the sum so far, solves for its part p:
 *
 * <pre>
 *   p = -m M (v + b s) - I P     a = h o (2 z + h o),  M = a / (1 + a),  I = 1 / (1 + a)
 * </pre>
 *
 * Limits: for o to infinity M = 1, I = 0 and b = 1 / h, a rigid contact that removes s in a
 * substep; for o to 0 M = 0, I = 1: no spring, and the visit takes back what was there. The
 * constants don't contain the mass: a light and a heavy contact relax alike.
 *
 * <p><b>Relax.</b> The spring leaves a velocity behind that is only there to remove overlap. After
 * positions moved, the same constraints are solved again rigidly and without bias, so that it is
 * gone and no energy enters. Restitution comes last, once per step.
 *
 * <p><b>Speculative.</b> A point with a gap s > 0 may approach with s / h, just closing it.
 *
 * <p><b>Friction</b> is the same without softness along the tangent, clamped to the Coulomb cone
 * {@code |pt| <= mu pn}. When pushing overlap apart friction comes first, so that the normal has
 * the last word, and piles come to rest sooner. When relaxing it comes last, since only then the
 * normal impulse has its full size; friction first made sliding boxes feel 3 % too little of it.
 *
 * <p><b>Moving surfaces.</b> With a tangent speed s the surfaces are at rest to each other when vt
 * = -s; friction asks for that instead of 0.
 *
 * <p><b>Rolling resistance</b> is friction of the angular velocity: {@code wB - wA} is driven to
 * zero by an angular impulse of at most {@code c r pn}, with the sum pn of both points' normal
 * impulses, the coefficient c and the radius r of the rolling shape.
 *
 * <p><b>Stiffness.</b> The leak I P makes a resting contact yield like the spring it is, by {@code
 * load / (m o^2)}. A column of n unit boxes is then an elastic rod that buckles under its own
 * weight at about {@code n = 14 (hertz / 30)^(2/3)} (Greenhill's self-buckling; measured: 15 boxes
 * fall at 30 hertz, 20 stand at 54). Without the leak (I = 0) columns of 20 fell while settling; at
 * 60 hertz and four substeps wide pyramids keep trembling.
 *
 * <p>The scheme is Erin Catto's "soft step" (articles and the Solver2D study on box2d.org,
 * 2023-24); soft constraints are from his GDC 2011 talk. Written from the algebra above.
 *
 * <p><b>Layout.</b> One array per quantity, one entry per contact, in the order of the contact
 * keys; kernels take a range, so that ranges without a common body (colours) can later be solved
 * side by side or in lanes.
 */
final class ContactSolver {
  private static final float TWO_PI = 6.2831855f;

  /** A closed gas loses 2.5 % of its energy in 300 steps with one round, 0.2 % with four. */
  private static final int BOUNCE_ROUNDS = 4;

  /** A contact's spring is at most this fraction as fast as the substeps. */
  private static final float MAX_HERTZ_PER_RATE = 0.25f;

  private int capacity;
  private int count;

  /** Whether any contact resists rolling in this step. */
  private boolean rolls;

  /** Whether any point may bounce in this step. */
  private boolean bounces;

  /** Row of the contact table; offsets of the two bodies in {@link SolverBodies#state}. */
  private int[] row = new int[0];

  private int[] bodyA = new int[0];
  private int[] bodyB = new int[0];
  private boolean[] two = new boolean[0];

  private float[] nx = new float[0];
  private float[] ny = new float[0];
  private float[] friction = new float[0];
  private float[] surface = new float[0];
  private float[] rolling = new float[0];
  private float[] rollMass = new float[0];
  private float[] roll = new float[0];
  private float[] massA = new float[0];
  private float[] massB = new float[0];
  private float[] inertiaA = new float[0];
  private float[] inertiaB = new float[0];

  /** Acceleration with which gravity and forces press the bodies together, m/s^2. */
  private float[] pull = new float[0];

  /** Softness: bias rate, factor on the mass, factor on the sum of impulses. */
  private float[] biasRate = new float[0];

  private float[] massScale = new float[0];
  private float[] impulseScale = new float[0];

  private final Point first = new Point();
  private final Point second = new Point();

  /** The columns of one point of each contact. */
  private static final class Point {
    float[] ax = new float[0];
    float[] ay = new float[0];
    float[] bx = new float[0];
    float[] by = new float[0];
    float[] separation = new float[0];
    float[] normalMass = new float[0];
    float[] tangentMass = new float[0];
    float[] normal = new float[0];
    float[] tangent = new float[0];
    float[] total = new float[0];
    float[] slide = new float[0];

    /** Approach speed to answer with a bounce, m/s, 0 if there is none to answer. */
    float[] bounce = new float[0];

    void ensure(int n) {
      ax = new float[n];
      ay = new float[n];
      bx = new float[n];
      by = new float[n];
      separation = new float[n];
      normalMass = new float[n];
      tangentMass = new float[n];
      normal = new float[n];
      tangent = new float[n];
      total = new float[n];
      slide = new float[n];
      bounce = new float[n];
    }
  }

  int count() {
    return count;
  }

  /** Collects the touching, not vetoed contacts of the table. */
  void prepare(
      ContactTable t, BodyStore b, SolverBodies bodies, int[] activeIndex, Settings s, float h) {
    if (capacity < t.count()) {
      ensure(Math.max(t.count(), capacity * 2));
    }
    float hertz = Math.min(s.contactHertz(), MAX_HERTZ_PER_RATE / h);
    float omega = TWO_PI * hertz;
    count = 0;
    bounces = false;
    rolls = false;
    for (int r = 0; r < t.count(); r++) {
      int points = t.points[r];
      if (points == 0) {
        continue;
      }
      if ((t.flags[r] & ContactTable.VETOED) != 0) {
        t.forget(r);
        continue;
      }
      int a = ContactKey.bodyA(t.key[r]);
      int o = ContactKey.bodyB(t.key[r]);
      float ma = b.invMass[a];
      float mb = b.invMass[o];
      int k = count++;
      row[k] = r;
      int slotA = activeIndex[a] + 1;
      int slotB = activeIndex[o] + 1;
      bodyA[k] = slotA * STRIDE;
      bodyB[k] = slotB * STRIDE;
      nx[k] = t.nx[r];
      ny[k] = t.ny[r];
      friction[k] = t.friction[r];
      surface[k] = t.surface[r];
      rolling[k] = t.rolling[r];
      roll[k] = t.roll[r];
      float turning = b.invInertia[a] + b.invInertia[o];
      rollMass[k] = turning > 0 ? 1 / turning : 0;
      rolls |= rolling[k] > 0;
      massA[k] = ma;
      massB[k] = mb;
      inertiaA[k] = b.invInertia[a];
      inertiaB[k] = b.invInertia[o];
      float stiff = ma == 0 || mb == 0 ? 2 * omega : omega;
      float twiceZeta = 2 * s.contactDampingRatio();
      float soft = h * stiff * (twiceZeta + h * stiff);
      biasRate[k] = stiff / (twiceZeta + h * stiff);
      massScale[k] = soft / (1 + soft);
      impulseScale[k] = 1 / (1 + soft);
      float gapX = b.x[o] - b.x[a];
      float gapY = b.y[o] - b.y[a];
      pull[k] =
          (bodies.ax(slotA) - bodies.ax(slotB)) * nx[k]
              + (bodies.ay(slotA) - bodies.ay(slotB)) * ny[k];
      float threshold = t.restitution[r] > 0 ? s.restitutionThreshold() : Float.MAX_VALUE;
      float e = t.restitution[r];
      preparePoint(first, k, t.x0[r], t.y0[r], gapX, gapY);
      first.separation[k] = t.separation0[r];
      first.normal[k] = t.normal0[r];
      first.tangent[k] = t.tangent0[r];
      first.bounce[k] = bounce(first, k, bodies.state, threshold, e, h);
      two[k] = points > 1;
      if (points > 1) {
        preparePoint(second, k, t.x1[r], t.y1[r], gapX, gapY);
        second.separation[k] = t.separation1[r];
        second.normal[k] = t.normal1[r];
        second.tangent[k] = t.tangent1[r];
        second.bounce[k] = bounce(second, k, bodies.state, threshold, e, h);
      }
    }
  }

  private void preparePoint(Point p, int k, float x, float y, float gapX, float gapY) {
    float bx = x - gapX;
    float by = y - gapY;
    p.ax[k] = x;
    p.ay[k] = y;
    p.bx[k] = bx;
    p.by[k] = by;
    float n = nx[k];
    float m = ny[k];
    float masses = massA[k] + massB[k];
    float rnA = x * m - y * n;
    float rnB = bx * m - by * n;
    float kn = masses + inertiaA[k] * rnA * rnA + inertiaB[k] * rnB * rnB;
    p.normalMass[k] = kn > 0 ? 1 / kn : 0;
    float rtA = x * n + y * m;
    float rtB = bx * n + by * m;
    float kt = masses + inertiaA[k] * rtA * rtA + inertiaB[k] * rtB * rtB;
    p.tangentMass[k] = kt > 0 ? 1 / kt : 0;
    p.total[k] = 0;
    p.slide[k] = 0;
  }

  /**
   * Speed after the bounce where the surfaces meet, m/s: from the approach now, plus what the
   * relative acceleration a adds over the gap, v^2 = v0^2 + 2 a s. In symplectic Euler a velocity
   * is that of half a substep ago, hence a h / 2 is added here and again after the bounce. Without
   * these terms a perfectly elastic ball would lose 2 % of its height with every bounce.
   */
  private float bounce(Point p, int k, float[] v, float threshold, float e, float h) {
    float approach = 0.5f * h * pull[k] - normalSpeed(p, k, v);
    if (!(approach > threshold)) {
      return 0;
    }
    float square = approach * approach + 2 * pull[k] * p.separation[k];
    bounces = true;
    return square > 0 ? e * (float) Math.sqrt(square) : 0;
  }

  private float normalSpeed(Point p, int k, float[] v) {
    int a = bodyA[k];
    int b = bodyB[k];
    float dvx = v[b + VX] - v[b + W] * p.by[k] - v[a + VX] + v[a + W] * p.ay[k];
    float dvy = v[b + VY] + v[b + W] * p.bx[k] - v[a + VY] - v[a + W] * p.ax[k];
    return dvx * nx[k] + dvy * ny[k];
  }

  /** Applies the impulses remembered from the last substep, or the last step. */
  void warmStart(float[] v, int from, int to) {
    for (int k = from; k < to; k++) {
      int a = bodyA[k];
      int b = bodyB[k];
      float n = nx[k];
      float m = ny[k];
      float pn = first.normal[k];
      float pt = first.tangent[k];
      float px = pn * n - pt * m;
      float py = pn * m + pt * n;
      float torqueA = first.ax[k] * py - first.ay[k] * px;
      float torqueB = first.bx[k] * py - first.by[k] * px;
      if (two[k]) {
        pn = second.normal[k];
        pt = second.tangent[k];
        float qx = pn * n - pt * m;
        float qy = pn * m + pt * n;
        torqueA += second.ax[k] * qy - second.ay[k] * qx;
        torqueB += second.bx[k] * qy - second.by[k] * qx;
        px += qx;
        py += qy;
      }
      v[a + VX] -= massA[k] * px;
      v[a + VY] -= massA[k] * py;
      v[a + W] -= inertiaA[k] * torqueA;
      v[b + VX] += massB[k] * px;
      v[b + VY] += massB[k] * py;
      v[b + W] += inertiaB[k] * torqueB;
    }
    for (int k = from; rolls && k < to; k++) {
      v[bodyA[k] + W] -= inertiaA[k] * roll[k];
      v[bodyB[k] + W] += inertiaB[k] * roll[k];
    }
  }

  /** One visit of each contact; with bias it also pushes overlap apart. */
  void solve(float[] v, int from, int to, float h, boolean bias, Settings s) {
    float inverseH = 1 / h;
    float maxPush = s.maxPushSpeed();
    float slop = s.slop();
    for (int k = from; k < to; k++) {
      int a = bodyA[k];
      int b = bodyB[k];
      float dpx = v[b + DX] - v[a + DX];
      float dpy = v[b + DY] - v[a + DY];
      float ca = v[a + COS] - 1;
      float sa = v[a + SIN];
      float cb = v[b + COS] - 1;
      float sb = v[b + SIN];
      if (bias) {
        if (rolls) {
          solveRolling(k, v);
        }
        solveFriction(first, k, v);
        if (two[k]) {
          solveFriction(second, k, v);
        }
      }
      solvePoint(first, k, v, dpx, dpy, ca, sa, cb, sb, inverseH, bias, maxPush, slop);
      if (two[k]) {
        solvePoint(second, k, v, dpx, dpy, ca, sa, cb, sb, inverseH, bias, maxPush, slop);
      }
      if (!bias) {
        solveFriction(first, k, v);
        if (two[k]) {
          solveFriction(second, k, v);
        }
        if (rolls) {
          solveRolling(k, v);
        }
        first.total[k] += first.normal[k];
        first.slide[k] += first.tangent[k];
        if (two[k]) {
          second.total[k] += second.normal[k];
          second.slide[k] += second.tangent[k];
        }
      }
    }
  }

  private void solvePoint(
      Point p,
      int k,
      float[] v,
      float dpx,
      float dpy,
      float ca,
      float sa,
      float cb,
      float sb,
      float inverseH,
      boolean bias,
      float maxPush,
      float slop) {
    float ax = p.ax[k];
    float ay = p.ay[k];
    float bx = p.bx[k];
    float by = p.by[k];
    float n = nx[k];
    float m = ny[k];
    float movedX = dpx + (cb * bx - sb * by) - (ca * ax - sa * ay);
    float movedY = dpy + (sb * bx + cb * by) - (sa * ax + ca * ay);
    float separation = p.separation[k] + movedX * n + movedY * m;
    float push = 0;
    float scale = 1;
    float leak = 0;
    if (separation > 0) {
      push = separation * inverseH;
    } else if (bias) {
      push = Math.max(biasRate[k] * Math.min(separation + slop, 0), -maxPush);
      scale = massScale[k];
      leak = impulseScale[k];
    }
    int a = bodyA[k];
    int b = bodyB[k];
    float dvx = v[b + VX] - v[b + W] * by - v[a + VX] + v[a + W] * ay;
    float dvy = v[b + VY] + v[b + W] * bx - v[a + VY] - v[a + W] * ax;
    float vn = dvx * n + dvy * m;
    float old = p.normal[k];
    float impulse = -p.normalMass[k] * scale * (vn + push) - leak * old;
    float sum = Math.max(old + impulse, 0);
    p.normal[k] = sum;
    apply(v, a, b, k, (sum - old) * n, (sum - old) * m, ax, ay, bx, by);
  }

  private void solveFriction(Point p, int k, float[] v) {
    float ax = p.ax[k];
    float ay = p.ay[k];
    float bx = p.bx[k];
    float by = p.by[k];
    float n = nx[k];
    float m = ny[k];
    int a = bodyA[k];
    int b = bodyB[k];
    float dvx = v[b + VX] - v[b + W] * by - v[a + VX] + v[a + W] * ay;
    float dvy = v[b + VY] + v[b + W] * bx - v[a + VY] - v[a + W] * ax;
    float vt = dvy * n - dvx * m;
    if (surface[k] != 0) {
      vt += surface[k];
    }
    float limit = friction[k] * p.normal[k];
    float old = p.tangent[k];
    float sum = Math.max(-limit, Math.min(old - p.tangentMass[k] * vt, limit));
    p.tangent[k] = sum;
    apply(v, a, b, k, (old - sum) * m, (sum - old) * n, ax, ay, bx, by);
  }

  private void solveRolling(int k, float[] v) {
    float load = two[k] ? first.normal[k] + second.normal[k] : first.normal[k];
    float limit = rolling[k] * load;
    float old = roll[k];
    float w = v[bodyB[k] + W] - v[bodyA[k] + W];
    float sum = Math.max(-limit, Math.min(old - rollMass[k] * w, limit));
    roll[k] = sum;
    v[bodyA[k] + W] -= inertiaA[k] * (sum - old);
    v[bodyB[k] + W] += inertiaB[k] * (sum - old);
  }

  private void apply(
      float[] v, int a, int b, int k, float px, float py, float ax, float ay, float bx, float by) {
    float ma = massA[k];
    float mb = massB[k];
    v[a + VX] -= ma * px;
    v[a + VY] -= ma * py;
    v[a + W] -= inertiaA[k] * (ax * py - ay * px);
    v[b + VX] += mb * px;
    v[b + VY] += mb * py;
    v[b + W] += inertiaB[k] * (bx * py - by * px);
  }

  /**
   * Bounces: points that came together faster than the threshold, and were pushed, part with the
   * speed decided when the step began, corrected for where they are now. Where one bounce spoils
   * another, as when a body is hit from two sides, more rounds settle it; impulses never pull.
   * Warm-start impulses end here, as the points fly apart.
   */
  void restitution(float[] v, float h) {
    for (int round = 0; bounces && round < BOUNCE_ROUNDS; round++) {
      for (int k = 0; k < count; k++) {
        restitution(first, k, v, h);
        if (two[k]) {
          restitution(second, k, v, h);
        }
      }
    }
    for (int k = 0; k < count; k++) {
      endBounce(first, k);
      if (two[k]) {
        endBounce(second, k);
      }
    }
  }

  private static void endBounce(Point p, int k) {
    if (p.bounce[k] != 0 && p.total[k] != 0) {
      p.normal[k] = 0;
      p.tangent[k] = 0;
    }
  }

  private void restitution(Point p, int k, float[] v, float h) {
    float bounce = p.bounce[k];
    if (bounce == 0 || p.total[k] == 0) {
      return;
    }
    float square = bounce * bounce - 2 * pull[k] * separation(p, k, v);
    float speed = square > 0 ? (float) Math.sqrt(square) + 0.5f * h * pull[k] : 0;
    float impulse = p.normalMass[k] * (Math.max(speed, 0) - normalSpeed(p, k, v));
    impulse = Math.max(impulse, -p.normal[k]);
    p.normal[k] += impulse;
    p.total[k] += impulse;
    float px = impulse * nx[k];
    float py = impulse * ny[k];
    apply(v, bodyA[k], bodyB[k], k, px, py, p.ax[k], p.ay[k], p.bx[k], p.by[k]);
  }

  /** The gap at a point now. */
  private float separation(Point p, int k, float[] v) {
    int a = bodyA[k];
    int b = bodyB[k];
    float ca = v[a + COS] - 1;
    float sa = v[a + SIN];
    float cb = v[b + COS] - 1;
    float sb = v[b + SIN];
    float movedX = v[b + DX] - v[a + DX];
    float movedY = v[b + DY] - v[a + DY];
    movedX += (cb * p.bx[k] - sb * p.by[k]) - (ca * p.ax[k] - sa * p.ay[k]);
    movedY += (sb * p.bx[k] + cb * p.by[k]) - (sa * p.ax[k] + ca * p.ay[k]);
    return p.separation[k] + movedX * nx[k] + movedY * ny[k];
  }

  /** Hands the impulses back to the table. */
  void store(ContactTable t) {
    for (int k = 0; k < count; k++) {
      int r = row[k];
      t.normal0[r] = first.normal[k];
      t.tangent0[r] = first.tangent[k];
      t.total0[r] = first.total[k];
      t.slide0[r] = first.slide[k];
      t.roll[r] = roll[k];
      if (two[k]) {
        t.normal1[r] = second.normal[k];
        t.tangent1[r] = second.tangent[k];
        t.total1[r] = second.total[k];
        t.slide1[r] = second.slide[k];
      }
    }
  }

  private void ensure(int n) {
    capacity = n;
    row = Arrays.copyOf(row, n);
    bodyA = new int[n];
    bodyB = new int[n];
    two = new boolean[n];
    nx = new float[n];
    ny = new float[n];
    friction = new float[n];
    surface = new float[n];
    rolling = new float[n];
    rollMass = new float[n];
    roll = new float[n];
    massA = new float[n];
    pull = new float[n];
    massB = new float[n];
    inertiaA = new float[n];
    inertiaB = new float[n];
    biasRate = new float[n];
    massScale = new float[n];
    impulseScale = new float[n];
    first.ensure(n);
    second.ensure(n);
  }
}
