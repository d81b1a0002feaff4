package carom.physics.dynamics.jointtree;

import static carom.physics.dynamics.jointtree.TreeRecords.A;
import static carom.physics.dynamics.jointtree.TreeRecords.ARM_AX;
import static carom.physics.dynamics.jointtree.TreeRecords.ARM_AY;
import static carom.physics.dynamics.jointtree.TreeRecords.ARM_BX;
import static carom.physics.dynamics.jointtree.TreeRecords.ARM_BY;
import static carom.physics.dynamics.jointtree.TreeRecords.BIAS_X;
import static carom.physics.dynamics.jointtree.TreeRecords.BIAS_Y;
import static carom.physics.dynamics.jointtree.TreeRecords.BODY;
import static carom.physics.dynamics.jointtree.TreeRecords.GAP_X;
import static carom.physics.dynamics.jointtree.TreeRecords.GAP_Y;
import static carom.physics.dynamics.jointtree.TreeRecords.INERTIA;
import static carom.physics.dynamics.jointtree.TreeRecords.INVERSE;
import static carom.physics.dynamics.jointtree.TreeRecords.JOINT;
import static carom.physics.dynamics.jointtree.TreeRecords.MASS_X;
import static carom.physics.dynamics.jointtree.TreeRecords.MASS_Y;
import static carom.physics.dynamics.jointtree.TreeRecords.PX;
import static carom.physics.dynamics.jointtree.TreeRecords.PY;
import static carom.physics.dynamics.jointtree.TreeRecords.QX;
import static carom.physics.dynamics.jointtree.TreeRecords.QY;
import static carom.physics.dynamics.jointtree.TreeRecords.RAX;
import static carom.physics.dynamics.jointtree.TreeRecords.RAY;
import static carom.physics.dynamics.jointtree.TreeRecords.RBX;
import static carom.physics.dynamics.jointtree.TreeRecords.RBY;
import static carom.physics.dynamics.jointtree.TreeRecords.SOFT;
import static carom.physics.dynamics.jointtree.TreeRecords.SXX;
import static carom.physics.dynamics.jointtree.TreeRecords.SXY;
import static carom.physics.dynamics.jointtree.TreeRecords.SYY;
import static carom.physics.dynamics.jointtree.TreeRecords.TURNING;
import static carom.physics.dynamics.jointtree.TreeRecords.Z;
import static carom.physics.dynamics.solverbody.SolverBodies.COS;
import static carom.physics.dynamics.solverbody.SolverBodies.DX;
import static carom.physics.dynamics.solverbody.SolverBodies.DY;
import static carom.physics.dynamics.solverbody.SolverBodies.SIN;
import static carom.physics.dynamics.solverbody.SolverBodies.VX;
import static carom.physics.dynamics.solverbody.SolverBodies.VY;
import static carom.physics.dynamics.solverbody.SolverBodies.W;

import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.joint.JointStore;
import carom.physics.dynamics.parallel.ParallelFor;

/**
 * Solves the points of {@linkplain JointTrees trees} of revolute joints directly: after a visit all
 * of a tree's joints hold at once, whatever hangs on them. Solved one by one, a load is noticed by
 * one more joint per visit, and a joint is a spring that is as weak as its bodies are light.
 *
 * <p><b>Equations.</b> With the masses M, the joints' matrix J and the speeds e at which anchors
 * part too fast, the change of velocities u and the impulses p are
 *
 * <pre>
 *   M u = J' p        J u + c p = -e
 * </pre>
 *
 * <p><b>Elimination</b> goes from the leaves to the root. A body c, with all that hangs on it, is
 * as heavy as a matrix A of 3 x 3 (the articulated inertia of Featherstone, "Rigid Body Dynamics
 * Algorithms"); seen from the other side of its joint it is
 *
 * <pre>
 *   S = (Jc A^-1 Jc' + c)^-1            2 x 2
 *   A of the parent += Jp' S Jp
 * </pre>
 *
 * <p>Nothing fills in, so a visit takes time in proportion to the joints. All that is added is
 * positive, hence mass ratios of a million cost no digits. Elimination is done once per substep,
 * when the lever arms change, and serves relaxing and the next biased impulses.
 *
 * <p><b>Pull.</b> A link under tension T swings about its own centre with the frequency {@code
 * sqrt(T l / I)}; beyond {@code 2 / h} no explicit step follows it, and a chain under 1,000 times
 * its links' weight would burst. So a body's moment of inertia counts {@code h^2} times the
 * stiffness that the pull of the last substep gives it against turning (Tournier et al., "Stable
 * Constrained Dynamics", 2015), which makes the step implicit in that alone. Slower motions hardly
 * feel it.
 *
 * <p><b>Softness.</b> What is held at several places may be held too tightly, and no impulses solve
 * that: there c is {@value TreeRecords#CLOSED_SOFTNESS} of the inverse masses of a joint's bodies,
 * and acts on the sum of a substep's impulses. A tree held once is always solvable, and rigid.
 *
 * <p>Numbers are doubles, the order of sums is that of the lists; so vectors, threads and the
 * places of bodies change no bit. Limits, motors and springs of these joints are rows as always,
 * visited before.
 */
public final class TreeSolver {
  /** Most gap between anchors that counts, m, as for all joints. */
  private static final float MAX_ERROR = 4;

  private final JointTrees trees;
  private final ParallelFor parallel;
  private final TreeRecords records;

  // The arrays of the records.

  private double[] joint;
  private double[] body;
  private int[] bodyA;
  private int[] bodyB;
  private boolean[] childIsB;
  private int[] offset;
  private boolean[] turns;

  /** State of the bodies. */
  private float[] v = new float[0];

  /** Length of a substep, s. */
  private double h;

  /** Share of an error that goes away per second, 1/s. */
  private float biasRate;

  // The stages, made once so that a step allocates nothing.
  private final ParallelFor.Range measuring = (from, to, worker) -> measureTrees(from, to);
  private final ParallelFor.Range warming = (from, to, worker) -> warmTrees(from, to);
  private final ParallelFor.Range biasing = (from, to, worker) -> biasTrees(from, to);
  private final ParallelFor.Range relaxing = (from, to, worker) -> relaxTrees(from, to);

  /** Makes a solver of these trees, which threads share. */
  public TreeSolver(JointTrees trees, ParallelFor parallel) {
    this.trees = trees;
    this.parallel = parallel;
    records = new TreeRecords(trees);
  }

  /** Begins a step: loads the joints and bodies of all trees. */
  public void begin(
      JointStore j, BodyStore bodyStore, int[] slotOf, float[] state, float substep, float rate) {
    v = state;
    h = substep;
    biasRate = rate;
    if (trees.count == 0) {
      return;
    }
    records.load(j, bodyStore, slotOf);
    joint = records.joint;
    body = records.body;
    bodyA = records.bodyA;
    bodyB = records.bodyB;
    childIsB = records.childIsB;
    offset = records.offset;
    turns = records.turns;
    parallel.run(0, trees.count, 1, measuring);
  }

  /** Applies the impulses of the last substep, or the last step. */
  public void warmStart() {
    parallel.run(0, trees.count, 1, warming);
  }

  /** Solves all joints before bodies move, with bias, which draws anchors together. */
  public void applyBiasedImpulses() {
    parallel.run(0, trees.count, 1, biasing);
  }

  /** Solves all joints after bodies moved, rigid. */
  public void relax() {
    parallel.run(0, trees.count, 1, relaxing);
  }

  private void measureTrees(int from, int to) {
    for (int t = from; t < to; t++) {
      measure(t);
    }
  }

  private void warmTrees(int from, int to) {
    double[] d = joint;
    for (int i = trees.start[from]; i < trees.start[to]; i++) {
      applyImpulse(i, d[i * JOINT + PX], d[i * JOINT + PY]);
    }
  }

  private void biasTrees(int from, int to) {
    for (int t = from; t < to; t++) {
      solve(t, true);
    }
  }

  private void relaxTrees(int from, int to) {
    for (int t = from; t < to; t++) {
      measure(t);
      solve(t, false);
    }
  }

  private void applyImpulse(int i, double px, double py) {
    double[] d = joint;
    int at = i * JOINT;
    int p = trees.parent[i];
    int c = trees.child[i];
    int a = childIsB[i] ? p : c;
    int b = childIsB[i] ? c : p;
    if (a >= 0) {
      change(a, -px, -py, d[at + RAY] * px - d[at + RAX] * py);
    }
    if (b >= 0) {
      change(b, px, py, d[at + RBX] * py - d[at + RBY] * px);
    }
  }

  private void change(int b, double px, double py, double turn) {
    int at = b * BODY;
    int o = offset[b];
    v[o + VX] += (float) (px / body[at + MASS_X]);
    v[o + VY] += (float) (py / body[at + MASS_Y]);
    if (turns[b]) {
      v[o + W] += (float) (turn / body[at + TURNING]);
    }
  }

  /** Finds lever arms and gaps with the bodies where they are now, and eliminates. */
  private void measure(int t) {
    int firstBody = trees.bodyStart[t];
    int lastBody = trees.bodyStart[t + 1];
    int first = trees.start[t];
    int last = trees.start[t + 1];
    records.clearImpulses(firstBody, lastBody);
    for (int i = first; i < last; i++) {
      findArms(i);
      addPull(i);
    }
    for (int b = firstBody; b < lastBody; b++) {
      beginMatrix(b * BODY);
    }
    for (int i = last - 1; i >= first; i--) {
      eliminate(i);
    }
    if (trees.up[firstBody] < 0) {
      invert(firstBody * BODY);
    }
  }

  /** Adds to both bodies how much their ends are pulled outwards. */
  private void addPull(int i) {
    double[] d = joint;
    int at = i * JOINT;
    int a = childIsB[i] ? trees.parent[i] : trees.child[i];
    int b = childIsB[i] ? trees.child[i] : trees.parent[i];
    if (a >= 0) {
      body[a * BODY + Z] -= d[at + PX] * d[at + RAX] + d[at + PY] * d[at + RAY];
    }
    if (b >= 0) {
      body[b * BODY + Z] += d[at + PX] * d[at + RBX] + d[at + PY] * d[at + RBY];
    }
  }

  /** Sets the matrix of a body to what it is without the others. */
  private void beginMatrix(int of) {
    double[] m = body;
    double pull = m[of + Z];
    double turning = m[of + INERTIA] + (pull > 0 ? h * pull : 0);
    m[of + A] = m[of + MASS_X];
    m[of + A + 1] = 0;
    m[of + A + 2] = 0;
    m[of + A + 3] = m[of + MASS_Y];
    m[of + A + 4] = 0;
    m[of + A + 5] = turning;
    m[of + TURNING] = turning;
  }

  private void findArms(int i) {
    double[] d = joint;
    int at = i * JOINT;
    int a = bodyA[i];
    int b = bodyB[i];
    double ax = v[a + COS] * d[at + ARM_AX] - v[a + SIN] * d[at + ARM_AY];
    double ay = v[a + SIN] * d[at + ARM_AX] + v[a + COS] * d[at + ARM_AY];
    double bx = v[b + COS] * d[at + ARM_BX] - v[b + SIN] * d[at + ARM_BY];
    double by = v[b + SIN] * d[at + ARM_BX] + v[b + COS] * d[at + ARM_BY];
    double dx = d[at + GAP_X] + ((double) v[b + DX] - v[a + DX]) + (bx - ax);
    double dy = d[at + GAP_Y] + ((double) v[b + DY] - v[a + DY]) + (by - ay);
    double far = Math.abs(dx) + Math.abs(dy);
    double rate = far > MAX_ERROR ? biasRate * MAX_ERROR / far : biasRate;
    d[at + RAX] = far <= MAX_ERROR ? ax + dx : ax;
    d[at + RAY] = far <= MAX_ERROR ? ay + dy : ay;
    d[at + RBX] = bx;
    d[at + RBY] = by;
    d[at + BIAS_X] = rate * dx;
    d[at + BIAS_Y] = rate * dy;
  }

  /** Finds how heavy a joint's child is, with all that hangs on it, and adds it to the parent. */
  private void eliminate(int i) {
    double[] d = joint;
    double[] m = body;
    int at = i * JOINT;
    int c = trees.child[i];
    double xx = d[at + SOFT];
    double xy = 0;
    double yy = xx;
    if (c >= 0) {
      int of = c * BODY;
      invert(of);
      double rx = d[at + (childIsB[i] ? RBX : RAX)];
      double ry = d[at + (childIsB[i] ? RBY : RAY)];
      double xw = m[of + INVERSE + 2];
      double yw = m[of + INVERSE + 4];
      double ww = m[of + INVERSE + 5];
      xx += m[of + INVERSE] - ry * (2 * xw - ry * ww);
      xy += m[of + INVERSE + 1] + rx * xw - ry * (yw + rx * ww);
      yy += m[of + INVERSE + 3] + rx * (2 * yw + rx * ww);
    }
    double determinant = xx * yy - xy * xy;
    double inverse = determinant > 0 ? 1 / determinant : 0;
    double sxx = yy * inverse;
    double sxy = -xy * inverse;
    double syy = xx * inverse;
    d[at + SXX] = sxx;
    d[at + SXY] = sxy;
    d[at + SYY] = syy;
    int p = trees.parent[i];
    if (p >= 0) {
      int of = p * BODY + A;
      double rx = d[at + (childIsB[i] ? RAX : RBX)];
      double ry = d[at + (childIsB[i] ? RAY : RBY)];
      double xw = rx * sxy - ry * sxx;
      double yw = rx * syy - ry * sxy;
      m[of] += sxx;
      m[of + 1] += sxy;
      m[of + 2] += xw;
      m[of + 3] += syy;
      m[of + 4] += yw;
      m[of + 5] += rx * yw - ry * xw;
    }
  }

  /** Inverts the matrix A of a body. */
  private void invert(int of) {
    double[] m = body;
    double xx = m[of + A];
    double xy = m[of + A + 1];
    double xw = m[of + A + 2];
    double yy = m[of + A + 3];
    double yw = m[of + A + 4];
    double ww = m[of + A + 5];
    double one = yy * ww - yw * yw;
    double two = xw * yw - xy * ww;
    double three = xy * yw - xw * yy;
    double determinant = xx * one + xy * two + xw * three;
    double inverse = determinant > 0 ? 1 / determinant : 0;
    m[of + INVERSE] = one * inverse;
    m[of + INVERSE + 1] = two * inverse;
    m[of + INVERSE + 2] = three * inverse;
    m[of + INVERSE + 3] = (xx * ww - xw * xw) * inverse;
    m[of + INVERSE + 4] = (xy * xw - xx * yw) * inverse;
    m[of + INVERSE + 5] = (xx * yy - xy * xy) * inverse;
  }

  private void solve(int t, boolean bias) {
    records.clearImpulses(trees.bodyStart[t], trees.bodyStart[t + 1]);
    for (int i = trees.start[t + 1] - 1; i >= trees.start[t]; i--) {
      gather(i, bias);
    }
    int root = trees.bodyStart[t];
    if (trees.up[root] < 0) {
      applyInverse(root * BODY);
      addVelocity(root);
    }
    for (int i = trees.start[t]; i < trees.start[t + 1]; i++) {
      release(i);
    }
  }

  /** Finds a joint's impulse as if its parent stood still, and gives it to the parent. */
  private void gather(int i, boolean bias) {
    double[] d = joint;
    double[] m = body;
    int at = i * JOINT;
    int a = bodyA[i];
    int b = bodyB[i];
    double wa = v[a + W];
    double wb = v[b + W];
    double ex = ((double) v[b + VX] - v[a + VX]) + (wa * d[at + RAY] - wb * d[at + RBY]);
    double ey = ((double) v[b + VY] - v[a + VY]) + (wb * d[at + RBX] - wa * d[at + RAX]);
    if (bias) {
      ex += d[at + BIAS_X];
      ey += d[at + BIAS_Y];
    }
    ex += d[at + SOFT] * d[at + PX];
    ey += d[at + SOFT] * d[at + PY];
    int c = trees.child[i];
    double sign = childIsB[i] ? 1 : -1;
    if (c >= 0) {
      int z = c * BODY + Z;
      applyInverse(c * BODY);
      double rx = d[at + (childIsB[i] ? RBX : RAX)];
      double ry = d[at + (childIsB[i] ? RBY : RAY)];
      ex += sign * (m[z] - ry * m[z + 2]);
      ey += sign * (m[z + 1] + rx * m[z + 2]);
    }
    double qx = -(d[at + SXX] * ex + d[at + SXY] * ey);
    double qy = -(d[at + SXY] * ex + d[at + SYY] * ey);
    d[at + QX] = qx;
    d[at + QY] = qy;
    int p = trees.parent[i];
    if (p >= 0) {
      int z = p * BODY + Z;
      double rx = d[at + (childIsB[i] ? RAX : RBX)];
      double ry = d[at + (childIsB[i] ? RAY : RBY)];
      m[z] -= sign * qx;
      m[z + 1] -= sign * qy;
      m[z + 2] -= sign * (rx * qy - ry * qx);
    }
  }

  /** Makes the change of velocity of the impulse on a body, with all that hangs on it. */
  private void applyInverse(int of) {
    double[] m = body;
    double x = m[of + Z];
    double y = m[of + Z + 1];
    double w = m[of + Z + 2];
    m[of + Z] = m[of + INVERSE] * x + m[of + INVERSE + 1] * y + m[of + INVERSE + 2] * w;
    m[of + Z + 1] = m[of + INVERSE + 1] * x + m[of + INVERSE + 3] * y + m[of + INVERSE + 4] * w;
    m[of + Z + 2] = m[of + INVERSE + 2] * x + m[of + INVERSE + 4] * y + m[of + INVERSE + 5] * w;
  }

  private void addVelocity(int b) {
    int z = b * BODY + Z;
    int o = offset[b];
    v[o + VX] += (float) body[z];
    v[o + VY] += (float) body[z + 1];
    if (turns[b]) {
      v[o + W] += (float) body[z + 2];
    }
  }

  /** Finds a joint's impulse, now that its parent has moved, and moves its child. */
  private void release(int i) {
    double[] d = joint;
    double[] m = body;
    int at = i * JOINT;
    double qx = d[at + QX];
    double qy = d[at + QY];
    double sign = childIsB[i] ? 1 : -1;
    int p = trees.parent[i];
    if (p >= 0) {
      int z = p * BODY + Z;
      double rx = d[at + (childIsB[i] ? RAX : RBX)];
      double ry = d[at + (childIsB[i] ? RAY : RBY)];
      double x = sign * (m[z] - ry * m[z + 2]);
      double y = sign * (m[z + 1] + rx * m[z + 2]);
      qx += d[at + SXX] * x + d[at + SXY] * y;
      qy += d[at + SXY] * x + d[at + SYY] * y;
    }
    d[at + PX] += qx;
    d[at + PY] += qy;
    int c = trees.child[i];
    if (c >= 0) {
      int of = c * BODY;
      double rx = d[at + (childIsB[i] ? RBX : RAX)];
      double ry = d[at + (childIsB[i] ? RBY : RAY)];
      double x = sign * qx;
      double y = sign * qy;
      double w = rx * y - ry * x;
      int n = of + INVERSE;
      m[of + Z] += m[n] * x + m[n + 1] * y + m[n + 2] * w;
      m[of + Z + 1] += m[n + 1] * x + m[n + 3] * y + m[n + 4] * w;
      m[of + Z + 2] += m[n + 2] * x + m[n + 4] * y + m[n + 5] * w;
      addVelocity(c);
    }
  }

  /** Stores what the joints exerted, and forgets what isn't a number. */
  public void store(JointStore j, float inverseH) {
    records.store(j, inverseH);
  }
}
