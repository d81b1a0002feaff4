package carom.physics.dynamics.jointtree;

import static carom.physics.dynamics.domain.SolverBodies.COS;
import static carom.physics.dynamics.domain.SolverBodies.SIN;
import static carom.physics.dynamics.domain.SolverBodies.VX;
import static carom.physics.dynamics.domain.SolverBodies.VY;
import static carom.physics.dynamics.domain.SolverBodies.W;
import static carom.physics.dynamics.jointtree.TreeRecords.A;
import static carom.physics.dynamics.jointtree.TreeRecords.BIAS_X;
import static carom.physics.dynamics.jointtree.TreeRecords.BIAS_Y;
import static carom.physics.dynamics.jointtree.TreeRecords.BODY;
import static carom.physics.dynamics.jointtree.TreeRecords.INVERSE;
import static carom.physics.dynamics.jointtree.TreeRecords.JOINT;
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

import carom.physics.dynamics.joint.JointStore;

/**
 * The welds of {@linkplain JointTrees trees}. They do what {@link TreeMatrices} and {@link
 * TreeSolver} do for hinges, with a third row, the angle: impulses are (x, y, turn), and the matrix
 * S is one of 3 x 3.
 *
 * <p>A joint's numbers for that row are a record of {@value #ANGLE} doubles, beside those of {@link
 * TreeRecords}, which hold the point's.
 */
final class TreeWelds {
  /**
   * Softness where a tree is held several times, in inverse moments of inertia of a joint's bodies.
   * It is far less than that of points, because a load bends a beam by a long lever.
   */
  private static final double CLOSED_SOFTNESS = 1e-7;

  /**
   * Softness of every weld, as a share of how easily what hangs on it turns. A beam of 30 pieces
   * with 1,000 times a piece's mass at its end sags by 0.9 mm. Rigid, it would end above or below
   * level by rounding.
   */
  private static final double YIELD = 1e-4;

  /** The last column of S. */
  private static final int SXW = 0;

  private static final int SYW = 1;
  private static final int SWW = 2;

  /** Angular impulse of the substep on B. */
  private static final int PW = 3;

  /** Angular impulse of this visit on B, as far as it follows from what is beyond the joint. */
  private static final int QW = 4;

  /** Angular speed at which the bodies are turned back. */
  private static final int BIAS_W = 5;

  /** The softness of the angle in this substep. */
  private static final int SOFT_W = 6;

  /** Angle of the joint as a rotation, when the step began. */
  private static final int BEGAN_COS = 7;

  private static final int BEGAN_SIN = 8;

  /** The part of the softness that stays. */
  private static final int CLOSED_W = 9;

  private static final int ANGLE = 10;

  private final JointTrees trees;
  private final TreeRecords records;

  /** Records of the joints; in use for welds only. */
  private double[] angle = new double[0];

  /** State of the bodies. */
  private float[] v = new float[0];

  /** Makes the welds of these trees. */
  TreeWelds(JointTrees trees, TreeRecords records) {
    this.trees = trees;
    this.records = records;
  }

  /** Begins a step with that many joints; what was there is gone. */
  void begin(int joints, float[] state) {
    v = state;
    if (angle.length < joints * ANGLE) {
      angle = new double[Math.max(joints * ANGLE, 2 * angle.length)];
    }
  }

  /** Loads the angle of a weld as a step begins. */
  void pack(int i, JointFrame f, JointStore j, boolean closed) {
    int at = i * ANGLE;
    int slot = f.slot;
    double cos = (double) f.cosB * f.cosA + (double) f.sinB * f.sinA;
    double sin = (double) f.sinB * f.cosA - (double) f.cosB * f.sinA;
    angle[at + BEGAN_COS] = cos * j.refCos[slot] + sin * j.refSin[slot];
    angle[at + BEGAN_SIN] = sin * j.refCos[slot] - cos * j.refSin[slot];
    angle[at + PW] = j.impulseW[slot];
    double turning = (double) f.inertiaA + f.inertiaB;
    double soft = turning > 0 ? turning : (double) f.massA + f.massB;
    angle[at + CLOSED_W] = closed ? CLOSED_SOFTNESS * soft : 0;
  }

  /** Returns the angular impulse of a weld in the last substep, N m s. */
  double impulse(int i) {
    return angle[i * ANGLE + PW];
  }

  /** Returns the entry of S for x and turn. */
  double xw(int i) {
    return angle[i * ANGLE + SXW];
  }

  /** Returns the entry of S for y and turn. */
  double yw(int i) {
    return angle[i * ANGLE + SYW];
  }

  /** Returns the entry of S for turn and turn. */
  double ww(int i) {
    return angle[i * ANGLE + SWW];
  }

  /** Scales the impulse of a weld's angle. */
  void scale(int i, double share) {
    angle[i * ANGLE + PW] *= share;
  }

  /**
   * Finds how fast a weld turns back, with the bodies where they are now. The sine stands for the
   * angle; beyond a right angle, where it falls again, 2 less the sine does.
   *
   * @param rate share of an error that goes away per second, 1/s
   */
  void measure(int i, float rate) {
    int at = i * ANGLE;
    int a = records.bodyA[i];
    int b = records.bodyB[i];
    double cos = (double) v[b + COS] * v[a + COS] + (double) v[b + SIN] * v[a + SIN];
    double sin = (double) v[b + SIN] * v[a + COS] - (double) v[b + COS] * v[a + SIN];
    double beganCos = angle[at + BEGAN_COS];
    double beganSin = angle[at + BEGAN_SIN];
    double error = beganSin * cos + beganCos * sin;
    if (beganCos * cos - beganSin * sin < 0) {
      error = error < 0 ? -2 - error : 2 - error;
    }
    angle[at + BIAS_W] = rate * error;
  }

  /** Finds how heavy a weld's child is, whose matrix is inverted, and adds it to the parent. */
  void eliminate(int i) {
    double[] d = records.joint;
    double[] m = records.body;
    int at = i * JOINT;
    boolean childIsB = records.childIsB[i];
    int c = trees.child[i];
    double xx = d[at + SOFT];
    double xy = 0;
    double xw = 0;
    double yy = xx;
    double yw = 0;
    double ww = angle[i * ANGLE + CLOSED_W];
    angle[i * ANGLE + SOFT_W] = ww;
    if (c >= 0) {
      int n = c * BODY + INVERSE;
      double rx = d[at + (childIsB ? RBX : RAX)];
      double ry = d[at + (childIsB ? RBY : RAY)];
      double turn = m[n + 5];
      xw = m[n + 2] - ry * turn;
      yw = m[n + 4] + rx * turn;
      angle[i * ANGLE + SOFT_W] += YIELD * turn;
      ww += turn + YIELD * turn;
      xx += m[n] - ry * (m[n + 2] + xw);
      xy += m[n + 1] + rx * m[n + 2] - ry * yw;
      yy += m[n + 3] + rx * (m[n + 4] + yw);
    }
    findMatrix(i, xx, xy, xw, yy, yw, ww);
    int p = trees.parent[i];
    if (p >= 0) {
      int of = p * BODY + A;
      double rx = d[at + (childIsB ? RAX : RBX)];
      double ry = d[at + (childIsB ? RAY : RBY)];
      double sxw = angle[i * ANGLE + SXW];
      double syw = angle[i * ANGLE + SYW];
      double turnX = rx * d[at + SXY] - ry * d[at + SXX] + sxw;
      double turnY = rx * d[at + SYY] - ry * d[at + SXY] + syw;
      m[of] += d[at + SXX];
      m[of + 1] += d[at + SXY];
      m[of + 2] += turnX;
      m[of + 3] += d[at + SYY];
      m[of + 4] += turnY;
      m[of + 5] += rx * (turnY + syw) - ry * (turnX + sxw) + angle[i * ANGLE + SWW];
    }
  }

  /** Finds the matrix S as the inverse of a symmetric one. */
  private void findMatrix(int i, double xx, double xy, double xw, double yy, double yw, double ww) {
    double one = yy * ww - yw * yw;
    double two = xw * yw - xy * ww;
    double three = xy * yw - xw * yy;
    double determinant = xx * one + xy * two + xw * three;
    double inverse = determinant > 0 ? 1 / determinant : 0;
    double[] d = records.joint;
    int at = i * JOINT;
    d[at + SXX] = one * inverse;
    d[at + SXY] = two * inverse;
    d[at + SYY] = (xx * ww - xw * xw) * inverse;
    angle[i * ANGLE + SXW] = three * inverse;
    angle[i * ANGLE + SYW] = (xy * xw - xx * yw) * inverse;
    angle[i * ANGLE + SWW] = (xx * yy - xy * xy) * inverse;
  }

  /**
   * Finds a weld's impulse as if its parent stood still, and gives it to the parent. The child's
   * change of velocity is known.
   */
  void gather(int i, boolean bias) {
    double[] d = records.joint;
    double[] m = records.body;
    int at = i * JOINT;
    int n = i * ANGLE;
    int a = records.bodyA[i];
    int b = records.bodyB[i];
    double wa = v[a + W];
    double wb = v[b + W];
    double ex = ((double) v[b + VX] - v[a + VX]) + (wa * d[at + RAY] - wb * d[at + RBY]);
    double ey = ((double) v[b + VY] - v[a + VY]) + (wb * d[at + RBX] - wa * d[at + RAX]);
    double ew = wb - wa;
    if (bias) {
      ex += d[at + BIAS_X];
      ey += d[at + BIAS_Y];
      ew += angle[n + BIAS_W];
    }
    ex += d[at + SOFT] * d[at + PX];
    ey += d[at + SOFT] * d[at + PY];
    ew += angle[n + SOFT_W] * angle[n + PW];
    boolean childIsB = records.childIsB[i];
    double sign = childIsB ? 1 : -1;
    int c = trees.child[i];
    if (c >= 0) {
      int z = c * BODY + Z;
      double rx = d[at + (childIsB ? RBX : RAX)];
      double ry = d[at + (childIsB ? RBY : RAY)];
      ex += sign * (m[z] - ry * m[z + 2]);
      ey += sign * (m[z + 1] + rx * m[z + 2]);
      ew += sign * m[z + 2];
    }
    double qx = -(d[at + SXX] * ex + d[at + SXY] * ey + angle[n + SXW] * ew);
    double qy = -(d[at + SXY] * ex + d[at + SYY] * ey + angle[n + SYW] * ew);
    double qw = -(angle[n + SXW] * ex + angle[n + SYW] * ey + angle[n + SWW] * ew);
    d[at + QX] = qx;
    d[at + QY] = qy;
    angle[n + QW] = qw;
    int p = trees.parent[i];
    if (p >= 0) {
      int z = p * BODY + Z;
      double rx = d[at + (childIsB ? RAX : RBX)];
      double ry = d[at + (childIsB ? RAY : RBY)];
      m[z] -= sign * qx;
      m[z + 1] -= sign * qy;
      m[z + 2] -= sign * (rx * qy - ry * qx + qw);
    }
  }

  /** Finds a weld's impulse, now that its parent has moved, and its child's change of velocity. */
  void release(int i) {
    double[] d = records.joint;
    double[] m = records.body;
    int at = i * JOINT;
    int n = i * ANGLE;
    double qx = d[at + QX];
    double qy = d[at + QY];
    double qw = angle[n + QW];
    boolean childIsB = records.childIsB[i];
    double sign = childIsB ? 1 : -1;
    int p = trees.parent[i];
    if (p >= 0) {
      int z = p * BODY + Z;
      double rx = d[at + (childIsB ? RAX : RBX)];
      double ry = d[at + (childIsB ? RAY : RBY)];
      double x = sign * (m[z] - ry * m[z + 2]);
      double y = sign * (m[z + 1] + rx * m[z + 2]);
      double w = sign * m[z + 2];
      qx += d[at + SXX] * x + d[at + SXY] * y + angle[n + SXW] * w;
      qy += d[at + SXY] * x + d[at + SYY] * y + angle[n + SYW] * w;
      qw += angle[n + SXW] * x + angle[n + SYW] * y + angle[n + SWW] * w;
    }
    d[at + PX] += qx;
    d[at + PY] += qy;
    angle[n + PW] += qw;
    int c = trees.child[i];
    if (c >= 0) {
      int z = c * BODY + Z;
      int k = c * BODY + INVERSE;
      double rx = d[at + (childIsB ? RBX : RAX)];
      double ry = d[at + (childIsB ? RBY : RAY)];
      double x = sign * qx;
      double y = sign * qy;
      double w = rx * y - ry * x + sign * qw;
      m[z] += m[k] * x + m[k + 1] * y + m[k + 2] * w;
      m[z + 1] += m[k + 1] * x + m[k + 3] * y + m[k + 4] * w;
      m[z + 2] += m[k + 2] * x + m[k + 4] * y + m[k + 5] * w;
    }
  }
}
