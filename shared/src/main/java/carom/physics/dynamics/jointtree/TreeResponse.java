package carom.physics.dynamics.jointtree;

import static carom.physics.dynamics.domain.SolverBodies.VX;
import static carom.physics.dynamics.domain.SolverBodies.VY;
import static carom.physics.dynamics.domain.SolverBodies.W;
import static carom.physics.dynamics.jointtree.TreeRecords.BODY;
import static carom.physics.dynamics.jointtree.TreeRecords.INVERSE;
import static carom.physics.dynamics.jointtree.TreeRecords.JOINT;
import static carom.physics.dynamics.jointtree.TreeRecords.RAX;
import static carom.physics.dynamics.jointtree.TreeRecords.RAY;
import static carom.physics.dynamics.jointtree.TreeRecords.RBX;
import static carom.physics.dynamics.jointtree.TreeRecords.RBY;
import static carom.physics.dynamics.jointtree.TreeRecords.SXX;
import static carom.physics.dynamics.jointtree.TreeRecords.SXY;
import static carom.physics.dynamics.jointtree.TreeRecords.SYY;
import static carom.physics.dynamics.jointtree.TreeRecords.Z;

import java.util.Arrays;

/**
 * Tells how the bodies of a {@linkplain JointTrees tree} answer impulses of contacts while its
 * joints hold: a link is as heavy as all that it has to move.
 *
 * <p><b>Response.</b> An impulse z on a body changes its velocity by {@code R z}, R being a matrix
 * of 3 x 3. That of a root is the inverse of A (see {@link TreeMatrices}). The others follow from
 * the root to the leaves: the child answers alone, the joint hands on what it takes to the parent,
 * and the parent's answer comes back.
 *
 * <p><b>Walk.</b> After an impulse the velocities of all bodies of a tree are other ones. To know
 * that of the next contact's body, only the way there is walked. A step towards the root hands on
 * the impulses that were collected beyond the joint; a step towards the leaves makes good what the
 * parent has changed since the child was last seen. So a visit of all contacts of a tree takes time
 * in proportion to its joints and contacts.
 */
public final class TreeResponse {
  /** Numbers of a body: R as xx, xy, xw, yy, yw, ww. */
  private static final int R = 0;

  /** Change of velocity in this walk. */
  private static final int U = 6;

  /** Impulses on it and beyond it that the parent doesn't know of. */
  private static final int PENDING = 9;

  /** The parent's change of velocity that it knows of. */
  private static final int KNOWN = 12;

  private static final int SIZE = 15;

  private final JointTrees trees;
  private final TreeRecords records;

  private double[] d = new double[0];

  /** Per body: its tree. */
  private int[] treeOf = new int[0];

  /** Per tree: whether contacts act on it. */
  private boolean[] touched = new boolean[0];

  /** Per tree: the body at which the walk is. */
  private int[] at = new int[0];

  /** Bodies on the way towards the leaves. */
  private int[] way = new int[0];

  private boolean any;

  /** State of the bodies. */
  private float[] v = new float[0];

  // Results of the steps.

  private double x;
  private double y;
  private double w;
  private double qx;
  private double qy;
  private double qw;

  TreeResponse(JointTrees trees, TreeRecords records) {
    this.trees = trees;
    this.records = records;
  }

  /** Begins a step, with the records of all trees loaded: no contacts act on any. */
  void begin(float[] state) {
    v = state;
    any = false;
    int bodies = trees.bodyStart[trees.count];
    if (treeOf.length < bodies) {
      int capacity = Math.max(bodies, 2 * treeOf.length);
      treeOf = new int[capacity];
      way = new int[capacity];
      d = new double[capacity * SIZE];
    }
    if (touched.length < trees.count) {
      touched = new boolean[Math.max(trees.count, 2 * touched.length)];
      at = new int[touched.length];
    }
    for (int t = 0; t < trees.count; t++) {
      touched[t] = false;
      Arrays.fill(treeOf, trees.bodyStart[t], trees.bodyStart[t + 1], t);
    }
  }

  /** Notes that a contact acts on a body. */
  public void touch(int body) {
    touched[treeOf[body]] = true;
    any = true;
  }

  /** Returns whether contacts act on any tree. */
  public boolean any() {
    return any;
  }

  /** Returns whether contacts act on a tree. */
  boolean isTouched(int t) {
    return any && touched[t];
  }

  /** Returns whether contacts act on the tree of a body. */
  public boolean isTouchedAt(int bodySlot) {
    int body = any ? trees.numberOf(bodySlot) : -1;
    return body >= 0 && touched[treeOf[body]];
  }

  /** Returns whether what contacts start with acts on the tree of a body as that is solved. */
  public boolean startsLate(int bodySlot) {
    return isTouchedAt(bodySlot) && records.hasRods[treeOf[trees.numberOf(bodySlot)]];
  }

  /** Returns the number of a body in the trees, -1 if it is in none. */
  public int number(int bodySlot) {
    return trees.numberOf(bodySlot);
  }

  /** Finds the responses of a tree's bodies, after elimination. */
  void measure(int t) {
    for (int b = trees.bodyStart[t]; b < trees.bodyStart[t + 1]; b++) {
      int r = b * SIZE + R;
      int i = trees.up[b];
      if (i < 0) {
        System.arraycopy(records.body, b * BODY + INVERSE, d, r, 6);
        continue;
      }
      respond(i, b, 1, 0, 0);
      d[r] = x;
      d[r + 1] = y;
      d[r + 2] = w;
      respond(i, b, 0, 1, 0);
      d[r + 3] = y;
      d[r + 4] = w;
      respond(i, b, 0, 0, 1);
      d[r + 5] = w;
    }
  }

  /** Finds how a child answers an impulse, whose parent's response is known. */
  private void respond(int i, int c, double zx, double zy, double zw) {
    invert(c, zx, zy, zw);
    double freeX = x;
    double freeY = y;
    double freeW = w;
    takeUp(i);
    int p = trees.parent[i];
    if (p >= 0) {
      double ownX = qx;
      double ownY = qy;
      double ownW = qw;
      toParent(i);
      answer(p, x, y, w);
      handDown(i);
      qx += ownX;
      qy += ownY;
      qw += ownW;
    }
    toChild(i, c);
    x += freeX;
    y += freeY;
    w += freeW;
  }

  /** Makes (x, y, w) the change of velocity of a body by an impulse, without its parent. */
  private void invert(int b, double zx, double zy, double zw) {
    double[] m = records.body;
    int n = b * BODY + INVERSE;
    x = m[n] * zx + m[n + 1] * zy + m[n + 2] * zw;
    y = m[n + 1] * zx + m[n + 3] * zy + m[n + 4] * zw;
    w = m[n + 2] * zx + m[n + 4] * zy + m[n + 5] * zw;
  }

  /** Makes (x, y, w) the change of velocity of a body by an impulse, with all of its tree. */
  private void answer(int b, double zx, double zy, double zw) {
    int n = b * SIZE + R;
    x = d[n] * zx + d[n + 1] * zy + d[n + 2] * zw;
    y = d[n + 1] * zx + d[n + 3] * zy + d[n + 4] * zw;
    w = d[n + 2] * zx + d[n + 4] * zy + d[n + 5] * zw;
  }

  /** Makes q the impulse of a joint whose child moves by (x, y, w). */
  private void takeUp(int i) {
    boolean childIsB = records.childIsB[i];
    double sign = childIsB ? -1 : 1;
    double rx = records.joint[i * JOINT + (childIsB ? RBX : RAX)];
    double ry = records.joint[i * JOINT + (childIsB ? RBY : RAY)];
    multiply(i, sign * (x - ry * w), sign * (y + rx * w), sign * w);
  }

  /** Makes q the impulse of a joint whose parent moves by (x, y, w). */
  private void handDown(int i) {
    boolean childIsB = records.childIsB[i];
    double sign = childIsB ? 1 : -1;
    double rx = records.joint[i * JOINT + (childIsB ? RAX : RBX)];
    double ry = records.joint[i * JOINT + (childIsB ? RAY : RBY)];
    multiply(i, sign * (x - ry * w), sign * (y + rx * w), sign * w);
  }

  private void multiply(int i, double ex, double ey, double ew) {
    double[] j = records.joint;
    int n = i * JOINT;
    qx = j[n + SXX] * ex + j[n + SXY] * ey;
    qy = j[n + SXY] * ex + j[n + SYY] * ey;
    qw = 0;
    if (records.weld[i]) {
      double sxw = records.welds.xw(i);
      double syw = records.welds.yw(i);
      qx += sxw * ew;
      qy += syw * ew;
      qw = sxw * ex + syw * ey + records.welds.ww(i) * ew;
    }
  }

  /** Makes (x, y, w) the impulse q on a joint's parent. */
  private void toParent(int i) {
    boolean childIsB = records.childIsB[i];
    double sign = childIsB ? -1 : 1;
    double rx = records.joint[i * JOINT + (childIsB ? RAX : RBX)];
    double ry = records.joint[i * JOINT + (childIsB ? RAY : RBY)];
    x = sign * qx;
    y = sign * qy;
    w = sign * (rx * qy - ry * qx + qw);
  }

  /** Makes (x, y, w) the change of velocity of a joint's child by the impulse q. */
  private void toChild(int i, int c) {
    boolean childIsB = records.childIsB[i];
    double sign = childIsB ? 1 : -1;
    double rx = records.joint[i * JOINT + (childIsB ? RBX : RAX)];
    double ry = records.joint[i * JOINT + (childIsB ? RBY : RAY)];
    invert(c, sign * qx, sign * qy, sign * (rx * qy - ry * qx + qw));
  }

  /** Begins a walk through all trees with contacts. */
  public void beginWalk() {
    for (int t = 0; t < trees.count; t++) {
      if (touched[t]) {
        int from = trees.bodyStart[t];
        int to = trees.bodyStart[t + 1];
        at[t] = from;
        records.clearImpulses(from, to);
        for (int b = from; b < to; b++) {
          Arrays.fill(d, b * SIZE + U, (b + 1) * SIZE, 0);
        }
      }
    }
  }

  /** Walks to a body, whose velocity is then known. */
  public void goTo(int body) {
    int t = treeOf[body];
    int from = at[t];
    int to = body;
    int steps = 0;
    while (from != to) {
      if (from > to) {
        from = ascend(from);
      } else {
        way[steps++] = to;
        to = trees.parent[trees.up[to]];
      }
    }
    while (steps > 0) {
      descend(way[--steps]);
    }
    at[t] = body;
  }

  /** Hands a body's pending impulses on to its parent, which is returned. */
  private int ascend(int c) {
    int i = trees.up[c];
    int p = trees.parent[i];
    int n = c * SIZE;
    invert(c, d[n + PENDING], d[n + PENDING + 1], d[n + PENDING + 2]);
    takeUp(i);
    toParent(i);
    add(p, PENDING);
    answer(p, x, y, w);
    add(p, U);
    System.arraycopy(d, p * SIZE + U, d, n + KNOWN, 3);
    Arrays.fill(d, n + PENDING, n + PENDING + 3, 0);
    return p;
  }

  /** Makes good what a body's parent has changed since. */
  private void descend(int c) {
    int i = trees.up[c];
    int p = trees.parent[i] * SIZE + U;
    int n = c * SIZE + KNOWN;
    x = d[p] - d[n];
    y = d[p + 1] - d[n + 1];
    w = d[p + 2] - d[n + 2];
    System.arraycopy(d, p, d, n, 3);
    handDown(i);
    toChild(i, c);
    add(c, U);
  }

  private void add(int b, int to) {
    d[b * SIZE + to] += x;
    d[b * SIZE + to + 1] += y;
    d[b * SIZE + to + 2] += w;
  }

  /** Applies an impulse to the body at which the walk is. */
  public void apply(int b, double px, double py, double turn) {
    int z = b * BODY + Z;
    records.body[z] += px;
    records.body[z + 1] += py;
    records.body[z + 2] += turn;
    x = px;
    y = py;
    w = turn;
    add(b, PENDING);
    answer(b, px, py, turn);
    add(b, U);
  }

  /**
   * Loads the velocity of the body at which the walk is.
   *
   * @param into gets vx, vy, w, and its response as xx, xy, xw, yy, yw, ww
   */
  public void load(int b, double[] into) {
    int o = records.offset[b];
    int n = b * SIZE;
    into[0] = v[o + VX] + d[n + U];
    into[1] = v[o + VY] + d[n + U + 1];
    into[2] = v[o + W] + d[n + U + 2];
    System.arraycopy(d, n + R, into, 3, 6);
  }

  /**
   * Applies an impulse that a contact starts with. A body of a tree with rods gets it as its tree
   * is solved, because the pull of rods makes it heavier; others get it alone.
   */
  public void start(int b, double px, double py, double turn) {
    if (records.hasRods[treeOf[b]]) {
      int z = b * BODY + Z;
      records.body[z] += px;
      records.body[z + 1] += py;
      records.body[z + 2] += turn;
    } else {
      records.push(b, px, py, turn, v);
    }
  }
}
