package carom.physics.dynamics.jointtree;

import static carom.physics.dynamics.domain.SolverBodies.VX;
import static carom.physics.dynamics.domain.SolverBodies.VY;
import static carom.physics.dynamics.domain.SolverBodies.W;
import static carom.physics.dynamics.jointtree.TreeRecords.BIAS_X;
import static carom.physics.dynamics.jointtree.TreeRecords.BIAS_Y;
import static carom.physics.dynamics.jointtree.TreeRecords.BODY;
import static carom.physics.dynamics.jointtree.TreeRecords.INVERSE;
import static carom.physics.dynamics.jointtree.TreeRecords.JOINT;
import static carom.physics.dynamics.jointtree.TreeRecords.NX;
import static carom.physics.dynamics.jointtree.TreeRecords.NY;
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
import static carom.physics.dynamics.jointtree.TreeRecords.Z;

import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.joint.JointStore;
import carom.physics.dynamics.store.ParallelFor;

/**
 * Solves the points, angles and lengths of {@linkplain JointTrees trees} of joints directly: after
 * a visit all of a tree's joints hold at once, under any load. Solved one by one, a load is noticed
 * by one more joint per visit, and a joint is a spring that is as weak as its bodies are light.
 *
 * <p><b>Equations.</b> With the masses M, the joints' matrix J and the speeds e at which anchors
 * part too fast, the change of velocities u and the impulses p are
 *
 * <pre>
 *   M u = J' p        J u + c p = -e
 * </pre>
 *
 * <p><b>Softness.</b> What is held at several places may be held too tightly, and no impulses solve
 * that: there c is {@value TreeRecords#CLOSED_SOFTNESS} of the inverse masses of a joint's bodies,
 * and acts on the sum of a substep's impulses. A tree held once is always solvable, and rigid.
 *
 * <p><b>Warm start.</b> A tree of hinges starts with the impulses of the last substep. The pull of
 * a rod couples its two bodies ({@link TreeMatrices}), and old impulses would need an elimination
 * of their own. So a tree with rods is solved at the warm start, too.
 *
 * <p>Numbers are doubles, the order of sums is that of the lists; so vectors, threads and the
 * places of bodies change no bit. Limits, motors and springs of these joints are rows as always,
 * visited before.
 */
public final class TreeSolver {
  private final JointTrees trees;
  private final ParallelFor parallel;
  private final TreeRecords records;
  private final TreeMatrices matrices;
  private final TreeResponse response;

  // The arrays of the records.

  private double[] joint;
  private double[] body;
  private int[] bodyA;
  private int[] bodyB;
  private boolean[] childIsB;
  private boolean[] weld;
  private int[] offset;
  private boolean[] turns;

  /** State of the bodies. */
  private float[] v = new float[0];

  // The stages, made once so that a step allocates nothing.
  private final ParallelFor.Range measuring = (from, to, worker) -> measureTrees(from, to);
  private final ParallelFor.Range warming = (from, to, worker) -> warmTrees(from, to);
  private final ParallelFor.Range biasing = (from, to, worker) -> biasTrees(from, to);
  private final ParallelFor.Range settling = (from, to, worker) -> settleTrees(from, to);
  private final ParallelFor.Range absorbing = (from, to, worker) -> absorbInTrees(from, to);
  private final ParallelFor.Range relaxing = (from, to, worker) -> relaxTrees(from, to);

  /** Makes a solver of these trees, which threads share. */
  public TreeSolver(JointTrees trees, ParallelFor parallel) {
    this.trees = trees;
    this.parallel = parallel;
    records = new TreeRecords(trees);
    matrices = new TreeMatrices(trees, records);
    response = new TreeResponse(trees, records);
  }

  /** Returns whether {@link #settle} does anything. */
  public boolean settles() {
    return trees.count > 0 && (records.anyWelds || response.any());
  }

  /** Returns how the bodies of trees answer contacts. */
  public TreeResponse response() {
    return response;
  }

  /** Begins a step: loads the joints and bodies of all trees. */
  public void begin(
      JointStore j, BodyStore bodyStore, int[] slotOf, float[] state, float substep, float rate) {
    v = state;
    if (trees.count == 0) {
      response.begin(state);
      return;
    }
    records.load(j, bodyStore, slotOf, state);
    joint = records.joint;
    body = records.body;
    bodyA = records.bodyA;
    bodyB = records.bodyB;
    childIsB = records.childIsB;
    weld = records.weld;
    offset = records.offset;
    turns = records.turns;
    matrices.begin(state, substep, rate);
    response.begin(state);
  }

  /** Measures all trees. By now it is known which ones contacts act on. */
  public void measure() {
    parallel.run(0, trees.count, 1, measuring);
  }

  /** Applies the impulses of the last substep, or the last step. */
  public void warmStart() {
    parallel.run(0, trees.count, 1, warming);
  }

  /** Scales the impulses of a tree, of which only a share counts. */
  public void scale(int t, double share) {
    for (int i = trees.start[t]; i < trees.start[t + 1]; i++) {
      joint[i * JOINT + PX] *= share;
      joint[i * JOINT + PY] *= share;
      if (weld[i]) {
        records.welds.scale(i, share);
      }
    }
  }

  /** Solves all joints before bodies move, with bias, which draws anchors together. */
  public void applyBiasedImpulses() {
    parallel.run(0, trees.count, 1, biasing);
  }

  /** Solves trees with welds or contacts once more before bodies move, with bias. */
  public void settle() {
    parallel.run(0, trees.count, 1, settling);
  }

  /** Solves all joints after bodies moved, rigid. */
  public void relax() {
    parallel.run(0, trees.count, 1, relaxing);
  }

  /** Solves trees with contacts once more after bodies moved. */
  public void absorb() {
    parallel.run(0, trees.count, 1, absorbing);
  }

  /** Solves a tree once more, after rows of its bodies were visited. */
  public void visit(int t, boolean bias) {
    solve(t, bias);
  }

  private void measureTrees(int from, int to) {
    for (int t = from; t < to; t++) {
      measureTree(t);
    }
  }

  private void measureTree(int t) {
    matrices.measure(t);
    if (response.isTouched(t)) {
      response.measure(t);
    }
  }

  private void absorbInTrees(int from, int to) {
    for (int t = from; t < to; t++) {
      if (response.isTouched(t)) {
        absorb(t, false);
      }
    }
  }

  private void warmTrees(int from, int to) {
    for (int t = from; t < to; t++) {
      if (records.hasRods[t]) {
        solveAnew(t);
        continue;
      }
      double[] d = joint;
      for (int i = trees.start[t]; i < trees.start[t + 1]; i++) {
        applyImpulse(i, d[i * JOINT + PX], d[i * JOINT + PY]);
        if (weld[i]) {
          applyTurn(i, records.welds.impulse(i));
        }
      }
    }
  }

  /** Forgets the impulses of a tree, and finds those that hold its joints. */
  private void solveAnew(int t) {
    for (int i = trees.start[t]; i < trees.start[t + 1]; i++) {
      joint[i * JOINT + PX] = 0;
      joint[i * JOINT + PY] = 0;
      if (weld[i]) {
        records.welds.scale(i, 0);
      }
    }
    if (response.isTouched(t)) {
      absorb(t, false);
    } else {
      solve(t, false);
    }
  }

  private void biasTrees(int from, int to) {
    for (int t = from; t < to; t++) {
      solve(t, true);
    }
  }

  private void settleTrees(int from, int to) {
    for (int t = from; t < to; t++) {
      if (response.isTouched(t)) {
        absorb(t, true);
      } else if (records.hasWelds[t]) {
        solve(t, true);
      }
    }
  }

  private void relaxTrees(int from, int to) {
    for (int t = from; t < to; t++) {
      measureTree(t);
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
      records.push(a, -px, -py, d[at + RAY] * px - d[at + RAX] * py, v);
    }
    if (b >= 0) {
      records.push(b, px, py, d[at + RBX] * py - d[at + RBY] * px, v);
    }
  }

  private void applyTurn(int i, double turn) {
    int p = trees.parent[i];
    int c = trees.child[i];
    double sign = childIsB[i] ? 1 : -1;
    if (p >= 0) {
      records.push(p, 0, 0, -sign * turn, v);
    }
    if (c >= 0) {
      records.push(c, 0, 0, sign * turn, v);
    }
  }

  private void solve(int t, boolean bias) {
    records.clearImpulses(trees.bodyStart[t], trees.bodyStart[t + 1]);
    absorb(t, bias);
  }

  /** Solves a tree on whose bodies impulses act. */
  private void absorb(int t, boolean bias) {
    for (int i = trees.start[t + 1] - 1; i >= trees.start[t]; i--) {
      if (weld[i]) {
        gatherWeld(i, bias);
      } else {
        gather(i, bias);
      }
    }
    int root = trees.bodyStart[t];
    if (trees.up[root] < 0) {
      applyInverse(root * BODY);
      addVelocity(root);
    }
    for (int i = trees.start[t]; i < trees.start[t + 1]; i++) {
      if (weld[i]) {
        releaseWeld(i);
      } else {
        release(i);
      }
    }
  }

  private void gatherWeld(int i, boolean bias) {
    if (trees.child[i] >= 0) {
      applyInverse(trees.child[i] * BODY);
    }
    records.welds.gather(i, bias);
  }

  private void releaseWeld(int i) {
    records.welds.release(i);
    if (trees.child[i] >= 0) {
      addVelocity(trees.child[i]);
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
    if (records.rod[i]) {
      double along = ex * d[at + NX] + ey * d[at + NY];
      ex = along * d[at + NX];
      ey = along * d[at + NY];
    }
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
