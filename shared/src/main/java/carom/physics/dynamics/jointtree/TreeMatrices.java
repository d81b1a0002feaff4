package carom.physics.dynamics.jointtree;

import static carom.physics.dynamics.domain.SolverBodies.COS;
import static carom.physics.dynamics.domain.SolverBodies.DX;
import static carom.physics.dynamics.domain.SolverBodies.DY;
import static carom.physics.dynamics.domain.SolverBodies.SIN;
import static carom.physics.dynamics.jointtree.TreeRecords.A;
import static carom.physics.dynamics.jointtree.TreeRecords.ACROSS;
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
import static carom.physics.dynamics.jointtree.TreeRecords.LENGTH;
import static carom.physics.dynamics.jointtree.TreeRecords.MASS_X;
import static carom.physics.dynamics.jointtree.TreeRecords.MASS_Y;
import static carom.physics.dynamics.jointtree.TreeRecords.NX;
import static carom.physics.dynamics.jointtree.TreeRecords.NY;
import static carom.physics.dynamics.jointtree.TreeRecords.PX;
import static carom.physics.dynamics.jointtree.TreeRecords.PY;
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

/**
 * The masses of a tree of bodies, as its joints see them. {@link TreeSolver} finds them once per
 * substep, when the lever arms have changed.
 *
 * <p><b>Elimination</b> goes from the leaves to the root. A body c, with all that hangs on it, is
 * as heavy as a matrix A of 3 x 3 (the articulated inertia of Featherstone, "Rigid Body Dynamics
 * Algorithms"); seen from the other side of its joint it is
 *
 * <pre>
 *   S = (Jc A^-1 Jc' + c)^-1            2 x 2, of welds 3 x 3
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
 * <p><b>Rods.</b> A rod is rigid in its direction n. Across it, in the direction t, its pull T at
 * the length l resists the turning of n with the stiffness {@code T / l}, which is implicit
 * likewise:
 *
 * <pre>
 *   S^-1 = Jc A^-1 Jc' + c + t t' / k        k = h T / l, both sides in kg
 * </pre>
 *
 * <p>For {@code k = 0} this is {@code S = n n' / (n' Jc A^-1 Jc' n + c)}. A rod that is pressed has
 * no such stiffness: it may buckle.
 */
final class TreeMatrices {
  /** Most gap between anchors that counts, m, as for all joints. */
  private static final float MAX_ERROR = 4;

  private final JointTrees trees;
  private final TreeRecords records;

  // The arrays of the records.

  private double[] joint;
  private double[] body;
  private int[] bodyA;
  private int[] bodyB;
  private boolean[] childIsB;
  private boolean[] rod;
  private boolean[] weld;

  /** State of the bodies. */
  private float[] v = new float[0];

  /** Length of a substep, s. */
  private double h;

  /** Share of an error that goes away per second, 1/s. */
  private float biasRate;

  /** Makes the matrices of these trees. */
  TreeMatrices(JointTrees trees, TreeRecords records) {
    this.trees = trees;
    this.records = records;
  }

  /** Begins a step, with the records of all trees loaded. */
  void begin(float[] state, float substep, float rate) {
    v = state;
    h = substep;
    biasRate = rate;
    joint = records.joint;
    body = records.body;
    bodyA = records.bodyA;
    bodyB = records.bodyB;
    childIsB = records.childIsB;
    rod = records.rod;
    weld = records.weld;
  }

  /** Finds lever arms and gaps with the bodies where they are now, and eliminates. */
  void measure(int t) {
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
      if (weld[i]) {
        eliminateWeld(i);
      } else {
        eliminate(i);
      }
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
    if (rod[i]) {
      d[at + RAX] = ax;
      d[at + RAY] = ay;
      d[at + RBX] = bx;
      d[at + RBY] = by;
      findRod(at, dx, dy);
      return;
    }
    d[at + RAX] = far <= MAX_ERROR ? ax + dx : ax;
    d[at + RAY] = far <= MAX_ERROR ? ay + dy : ay;
    d[at + RBX] = bx;
    d[at + RBY] = by;
    d[at + BIAS_X] = rate * dx;
    d[at + BIAS_Y] = rate * dy;
  }

  /** Finds a rod's direction and bias, and how much its pull resists turning. */
  private void findRod(int at, double dx, double dy) {
    double[] d = joint;
    double length = Math.sqrt(dx * dx + dy * dy);
    records.point(at, dx, dy, length);
    double nx = d[at + NX];
    double ny = d[at + NY];
    double error = length - d[at + LENGTH];
    double bias = biasRate * Math.max(-MAX_ERROR, Math.min(error, MAX_ERROR));
    d[at + BIAS_X] = bias * nx;
    d[at + BIAS_Y] = bias * ny;
    double pull = -(d[at + PX] * nx + d[at + PY] * ny);
    d[at + ACROSS] = pull > 0 && length > TreeRecords.LEAST_LENGTH ? h * pull / length : 0;
  }

  private void eliminateWeld(int i) {
    if (trees.child[i] >= 0) {
      invert(trees.child[i] * BODY);
    }
    records.welds.measure(i, biasRate);
    records.welds.eliminate(i);
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
    if (rod[i]) {
      findRodMatrix(at, xx, xy, yy);
    } else {
      double determinant = xx * yy - xy * xy;
      double inverse = determinant > 0 ? 1 / determinant : 0;
      d[at + SXX] = yy * inverse;
      d[at + SXY] = -xy * inverse;
      d[at + SYY] = xx * inverse;
    }
    double sxx = d[at + SXX];
    double sxy = d[at + SXY];
    double syy = d[at + SYY];
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

  /** Finds the matrix S of a rod, which is rigid along itself, and yields across by its pull. */
  private void findRodMatrix(int at, double xx, double xy, double yy) {
    double[] d = joint;
    double nx = d[at + NX];
    double ny = d[at + NY];
    double across = d[at + ACROSS];
    double nn = nx * (xx * nx + xy * ny) + ny * (xy * nx + yy * ny);
    double nt = nx * (xy * nx - xx * ny) + ny * (yy * nx - xy * ny);
    double tt = ny * (xx * ny - xy * nx) + nx * (yy * nx - xy * ny);
    double determinant = nn + across * (nn * tt - nt * nt);
    double inverse = determinant > 0 ? 1 / determinant : 0;
    double snn = (1 + across * tt) * inverse;
    double snt = -across * nt * inverse;
    double stt = across * nn * inverse;
    d[at + SXX] = snn * nx * nx - 2 * snt * nx * ny + stt * ny * ny;
    d[at + SXY] = snn * nx * ny + snt * (nx * nx - ny * ny) - stt * nx * ny;
    d[at + SYY] = snn * ny * ny + 2 * snt * nx * ny + stt * nx * nx;
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
}
