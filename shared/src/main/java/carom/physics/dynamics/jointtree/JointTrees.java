package carom.physics.dynamics.jointtree;

import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.joint.JointStore;
import java.util.Arrays;

/**
 * Finds the trees of revolute joints, welds and rods that carry too much to be solved joint by
 * joint: a wrecking ball on a chain, a long bridge, a beam.
 *
 * <p>Bodies that can be moved and the joints between them are a graph. What can't be moved is no
 * part of it, so a bridge between two rocks is a tree as well. Revolute joints come first, then
 * welds, then rods: a weld or rod that would close a cycle, or that is with one, stays out, and is
 * solved by itself. So none takes the tree of a chain of hinges away. A joint's <i>load</i> is the
 * mass that hangs on its lighter side (all of the tree's, where both sides are held), in masses of
 * its lighter body. Without other joints beside the tree, a body with an anchor far outside is as
 * light as it is easy to turn. Solved one by one, a joint opens in proportion to its load.
 *
 * <pre>
 *   rock --- 1 kg --- 1 kg --- 1 kg --- 100 kg     loads: 103, 102, 101, 100
 *   truck 500 kg --- 1 kg --- 1 kg --- 1 kg        loads: 3, 2, 1
 * </pre>
 *
 * <p>A tree without a cycle is listed here, its joints from the root to the leaves, for {@link
 * TreeSolver}, if a load is {@value #LEAST_LOAD} or more (with motors or springs beside it: {@value
 * #LEAST_MIXED_LOAD}); or if it is held and has a weld, since each piece of a beam bends all welds
 * up to where it is held. Its root is a joint with what can't be moved, if there is one. All others
 * are solved joint by joint, as if this class didn't exist. So are light welded bodies that move
 * freely.
 *
 * <p>The lists follow from the awake joints and the masses of their bodies alone, so they are no
 * state: not from the slots of bodies, and from those of joints only in the order of sums.
 */
public final class JointTrees {
  /** Least load of a tree that is solved as a whole. */
  private static final float LEAST_LOAD = 50;

  /**
   * Least load of a tree with rows beside it: motors and springs of its bodies. These know the mass
   * of a body alone, the tree that of all, and what one does the other undoes. Below this load such
   * bodies are better off joint by joint.
   */
  private static final float LEAST_MIXED_LOAD = 500;

  /**
   * Square of an anchor's distance from the centre, in those of a body's radius of gyration, from
   * which its body is as light as it is easy to turn.
   */
  private static final float FAR = 32;

  /** Number of trees. */
  int count;

  /** Per tree: its first joint. Behind the last tree, the end of all joints. */
  int[] start = new int[1];

  /** Per tree: its first body. Behind the last tree, the end of all bodies. */
  int[] bodyStart = new int[1];

  /**
   * Per tree: whether it is held at several places: by joints with what can't be moved, or by
   * locks.
   */
  boolean[] closed = new boolean[1];

  /** Per joint, those of a tree one after the other, from the root to the leaves: its slot. */
  int[] slot = new int[0];

  /** Per joint: its body towards the root, -1 if that can't be moved. */
  int[] parent = new int[0];

  /** Per joint: its body towards the leaves, -1 if that can't be moved. */
  int[] child = new int[0];

  /** Per body of the trees: the joint towards the root, -1 if there is none. */
  int[] up = new int[0];

  /** Number of bodies. */
  private int bodyCount;

  /** Per joint of the trees: mass of what is beyond it, seen from the root, kg. */
  private double[] beyond = new double[0];

  /** Per joint of the trees: how many joints beyond it, itself included, are with what's held. */
  private int[] heldBeyond = new int[0];

  /** Per body of the trees: its slot. */
  int[] body = new int[0];

  /** Per slot of a body: the body that stands for its component. */
  private int[] leader = new int[0];

  /** Per slot of a body: the search that it was last seen in. */
  private int[] seen = new int[0];

  /**
   * Per slot of a body that stands for a component: joints with what can't be moved, and locked
   * bodies.
   */
  private int[] held = new int[0];

  /** Per slot of a body that stands for a component: whether it has a cycle. */
  private boolean[] cyclic = new boolean[0];

  /** Per slot of a body that stands for a component: whether there are joints beside its tree. */
  private boolean[] beside = new boolean[0];

  /** Per slot of a body that stands for a component: whether some of these act by themselves. */
  private boolean[] mixed = new boolean[0];

  /**
   * Per slot of a body: whether its tree has a body of {@link #LEAST_LOAD} times another's mass.
   */
  private boolean[] uneven = new boolean[0];

  /** Per slot of a body: its number in the trees, -1 without. */
  private int[] number = new int[0];

  /** Per slot of a joint: the search that found it, negative once a tree has it. */
  private int[] found = new int[0];

  private int search;

  private JointStore joints;
  private BodyStore bodies;

  /** Slots of the joints whose masses were looked at, and what the loads follow from. */
  private int[] looked = new int[0];

  private float[] inverseMass = new float[0];
  private int lookedCount;

  /** Makes empty lists. */
  public JointTrees() {}

  /** Returns whether masses have changed so that there may be other trees. */
  public boolean areStale(JointStore j, BodyStore b) {
    for (int i = 0; i < lookedCount; i++) {
      int k = looked[i];
      if (inverseMass[4 * i] != inverseMassA(j, b, k)
          || inverseMass[4 * i + 1] != b.invMass[j.bodyB[k]]
          || inverseMass[4 * i + 2] != inverseMassAt(j, b, k, j.bodyA[k])
          || inverseMass[4 * i + 3] != inverseMassAt(j, b, k, j.bodyB[k])) {
        return true;
      }
    }
    return false;
  }

  private static float inverseMassA(JointStore j, BodyStore b, int k) {
    return j.bodyA[k] < 0 ? 0 : b.invMass[j.bodyA[k]];
  }

  /** Returns the number of a body in the trees, -1 if it is in none. */
  public int numberOf(int bodySlot) {
    if (count == 0 || bodySlot >= seen.length || seen[bodySlot] != search) {
      return -1;
    }
    int at = number[bodySlot];
    return at >= 0 && at < bodyStart[count] && body[at] == bodySlot ? at : -1;
  }

  /**
   * Returns whether a contact has to feel the whole tree of its first body: heavy bodies hang on
   * it, or the second body is so heavy. Elsewhere a piece answers nearly as it does alone, which a
   * client that predicts a part of the tree computes alike.
   *
   * @param otherSlot the body that it touches, which may be none that can be moved
   */
  public boolean answersWhole(int bodySlot, int otherSlot, BodyStore b) {
    return numberOf(bodySlot) >= 0
        && (uneven[bodySlot]
            || (b.invMass[otherSlot] > 0
                && b.invMass[bodySlot] >= LEAST_LOAD * b.invMass[otherSlot]));
  }

  /** Returns the number of trees. */
  public int count() {
    return count;
  }

  /** Returns the slot of a body of a tree. */
  public int bodyOf(int t) {
    return body[bodyStart[t]];
  }

  /** Returns a number that is another one when there are other trees; 0 for none. */
  public int edition() {
    return count == 0 ? 0 : search;
  }

  /** Returns whether a tree has a joint. */
  public boolean has(int joint) {
    return joint < found.length && found[joint] == -search;
  }

  /**
   * Finds the trees.
   *
   * @param list slots of the joints to solve, ascending; each can move a body
   * @param n how many
   */
  public void find(JointStore j, BodyStore b, int[] list, int n) {
    joints = j;
    bodies = b;
    count = 0;
    bodyCount = 0;
    start[0] = 0;
    bodyStart[0] = 0;
    lookedCount = 0;
    search++;
    ensure(n, b.slots(), j.slots());
    findComponents(list, n);
    for (int i = 0; i < n; i++) {
      int k = list[i];
      if (isOpen(k) && isHeld(k)) {
        build(k);
      }
    }
    for (int i = 0; i < n; i++) {
      if (isOpen(list[i])) {
        build(list[i]);
      }
    }
  }

  private void ensure(int n, int bodySlots, int jointSlots) {
    if (slot.length < n) {
      int capacity = Math.max(n, 2 * slot.length);
      slot = new int[capacity];
      parent = new int[capacity];
      child = new int[capacity];
      beyond = new double[capacity];
      heldBeyond = new int[capacity];
      body = new int[2 * capacity];
      up = new int[2 * capacity];
      looked = new int[capacity];
      inverseMass = new float[4 * capacity];
    }
    if (leader.length < bodySlots) {
      int capacity = Math.max(bodySlots, 2 * leader.length);
      leader = new int[capacity];
      seen = Arrays.copyOf(seen, capacity);
      held = new int[capacity];
      cyclic = new boolean[capacity];
      mixed = new boolean[capacity];
      beside = new boolean[capacity];
      uneven = new boolean[capacity];
      number = new int[capacity];
    }
    if (found.length < jointSlots) {
      found = Arrays.copyOf(found, Math.max(jointSlots, 2 * found.length));
    }
  }

  /** Finds the components of the graph. */
  private void findComponents(int[] list, int n) {
    for (int i = 0; i < n; i++) {
      if (joints.type[list[i]] == JointStore.REVOLUTE) {
        connect(list[i]);
      }
    }
    for (int i = 0; i < n; i++) {
      if (joints.isRigidWeld(list[i]) && keepsTrees(list[i])) {
        connect(list[i]);
      }
    }
    for (int i = 0; i < n; i++) {
      if (joints.isRod(list[i]) && keepsTrees(list[i])) {
        connect(list[i]);
      }
    }
    for (int i = 0; i < n; i++) {
      boolean active = joints.isActive(list[i]);
      if (active || found[list[i]] != search) {
        noteRow(joints.bodyA[list[i]], active);
        noteRow(joints.bodyB[list[i]], active);
      }
    }
  }

  private void noteRow(int bodySlot, boolean active) {
    int at = movable(bodySlot);
    if (at >= 0) {
      mixed[leader(at)] |= active;
      beside[leader(at)] = true;
    }
  }

  private void connect(int k) {
    found[k] = search;
    int a = movable(joints.bodyA[k]);
    int b = movable(joints.bodyB[k]);
    if (a < 0 || b < 0) {
      held[leader(Math.max(a, b))]++;
    } else {
      join(leader(a), leader(b));
    }
  }

  /** Returns whether a joint closes no cycle, and is with none. */
  private boolean keepsTrees(int k) {
    int a = movable(joints.bodyA[k]);
    int b = movable(joints.bodyB[k]);
    if (a < 0 || b < 0) {
      return !cyclic[leader(Math.max(a, b))];
    }
    return leader(a) != leader(b) && !cyclic[leader(a)] && !cyclic[leader(b)];
  }

  /** Returns a body, -1 if it can't be moved. */
  private int movable(int bodySlot) {
    if (bodySlot < 0 || bodies.invMass[bodySlot] == 0) {
      return -1;
    }
    if (seen[bodySlot] != search) {
      seen[bodySlot] = search;
      leader[bodySlot] = bodySlot;
      held[bodySlot] = bodies.areLocked(bodySlot, -1) ? 1 : 0;
      cyclic[bodySlot] = false;
      mixed[bodySlot] = false;
      beside[bodySlot] = false;
      number[bodySlot] = -1;
    }
    return bodySlot;
  }

  private int leader(int bodySlot) {
    int at = bodySlot;
    while (leader[at] != at) {
      leader[at] = leader[leader[at]];
      at = leader[at];
    }
    return at;
  }

  private void join(int one, int two) {
    if (one == two) {
      cyclic[one] = true;
    } else {
      leader[two] = one;
      held[one] += held[two];
      cyclic[one] |= cyclic[two];
    }
  }

  /** Returns whether a joint has no cycle, and no search has come to it yet. */
  private boolean isOpen(int k) {
    return found[k] == search && !cyclic[leader(anyBody(k))] && number[anyBody(k)] < 0;
  }

  private boolean isHeld(int k) {
    return movable(joints.bodyA[k]) < 0 || movable(joints.bodyB[k]) < 0;
  }

  private int anyBody(int k) {
    int a = movable(joints.bodyA[k]);
    return a >= 0 ? a : joints.bodyB[k];
  }

  /** Lists the tree of a joint, which is its root if it is held, and keeps it if loads are high. */
  private void build(int root) {
    int from = start[count];
    int firstBody = bodyStart[count];
    int component = leader(anyBody(root));
    int size = from;
    bodyCount = firstBody;
    addBody(anyBody(root));
    if (isHeld(root)) {
      size = addJoint(size, root, -1, firstBody);
    }
    double total = 0;
    for (int at = firstBody; at < bodyCount; at++) {
      total += 1.0 / bodies.invMass[body[at]];
      for (int end = joints.firstEnd(body[at]); end >= 0; end = joints.nextEnd(end)) {
        if (found[end >> 1] == search) {
          int other = movable(joints.other(end));
          size = addJoint(size, end >> 1, at, other < 0 ? -1 : addBody(other));
        }
      }
    }
    noteMasses(from, size);
    boolean heavy =
        size - from > 1
            && largestLoad(from, size, total, held[component])
                >= (mixed[component] ? LEAST_MIXED_LOAD : LEAST_LOAD);
    if (!heavy && !(held[component] > 0 && hasWeld(from, size))) {
      for (int i = from; i < size; i++) {
        found[slot[i]] = 0;
      }
      bodyCount = firstBody;
      return;
    }
    count++;
    if (start.length <= count) {
      start = Arrays.copyOf(start, 2 * count + 1);
      bodyStart = Arrays.copyOf(bodyStart, 2 * count + 1);
      closed = Arrays.copyOf(closed, 2 * count + 1);
    }
    closed[count - 1] = held[component] > 1;
    noteEvenness(firstBody, bodyCount);
    start[count] = size;
    bodyStart[count] = bodyCount;
  }

  private void noteEvenness(int from, int to) {
    float least = Float.POSITIVE_INFINITY;
    float most = 0;
    for (int i = from; i < to; i++) {
      least = Math.min(least, bodies.invMass[body[i]]);
      most = Math.max(most, bodies.invMass[body[i]]);
    }
    for (int i = from; i < to; i++) {
      uneven[body[i]] = most >= LEAST_LOAD * least;
    }
  }

  private int addBody(int bodySlot) {
    number[bodySlot] = bodyCount;
    body[bodyCount] = bodySlot;
    up[bodyCount] = -1;
    return bodyCount++;
  }

  private int addJoint(int at, int k, int towardsRoot, int towardsLeaves) {
    found[k] = -search;
    slot[at] = k;
    parent[at] = towardsRoot;
    child[at] = towardsLeaves;
    if (towardsLeaves >= 0) {
      up[towardsLeaves] = at;
    }
    return at + 1;
  }

  private void noteMasses(int from, int to) {
    for (int i = from; i < to; i++) {
      int k = slot[i];
      looked[lookedCount] = k;
      inverseMass[4 * lookedCount] = inverseMassA(joints, bodies, k);
      inverseMass[4 * lookedCount + 1] = bodies.invMass[joints.bodyB[k]];
      inverseMass[4 * lookedCount + 2] = inverseMassAt(joints, bodies, k, joints.bodyA[k]);
      inverseMass[4 * lookedCount + 3] = inverseMassAt(joints, bodies, k, joints.bodyB[k]);
      lookedCount++;
    }
  }

  private boolean hasWeld(int from, int to) {
    for (int i = from; i < to; i++) {
      if (joints.isRigidWeld(slot[i])) {
        return true;
      }
    }
    return false;
  }

  /** Returns the mass that a force on a joint's anchor has to move, kg. */
  private double massAt(int i, int bodySlot) {
    return 1.0
        / (beside[leader(bodySlot)]
            ? bodies.invMass[bodySlot]
            : inverseMassAt(joints, bodies, slot[i], bodySlot));
  }

  /**
   * Returns the inverse mass that a body has for a force on the anchor of one of its joints, 1/kg:
   * its own, or where that turns it far more than it moves it, r^2 / I.
   */
  private static float inverseMassAt(JointStore j, BodyStore b, int k, int bodySlot) {
    if (bodySlot < 0) {
      return 0;
    }
    boolean isB = bodySlot == j.bodyB[k];
    float armX = (isB ? j.anchorBx[k] : j.anchorAx[k]) - b.localX[bodySlot];
    float armY = (isB ? j.anchorBy[k] : j.anchorAy[k]) - b.localY[bodySlot];
    float turning = b.invInertia[bodySlot] * (armX * armX + armY * armY);
    return turning > FAR * b.invMass[bodySlot] ? turning : b.invMass[bodySlot];
  }

  /** Returns whether forces on the anchor of a joint turn one of its bodies more than move it. */
  public static boolean isFar(JointStore j, BodyStore b, int k) {
    return isFar(j, b, k, j.bodyA[k]) || isFar(j, b, k, j.bodyB[k]);
  }

  private static boolean isFar(JointStore j, BodyStore b, int k, int bodySlot) {
    return bodySlot >= 0 && inverseMassAt(j, b, k, bodySlot) != b.invMass[bodySlot];
  }

  /** Returns the largest load of joints listed from the root to the leaves. */
  private double largestLoad(int from, int to, double total, int heldInAll) {
    Arrays.fill(beyond, from, to, 0);
    Arrays.fill(heldBeyond, from, to, 0);
    double largest = 0;
    for (int i = to - 1; i >= from; i--) {
      double lighter = Double.POSITIVE_INFINITY;
      if (child[i] < 0) {
        heldBeyond[i]++;
      } else {
        lighter = massAt(i, body[child[i]]);
        beyond[i] += 1.0 / bodies.invMass[body[child[i]]];
      }
      if (parent[i] >= 0) {
        lighter = Math.min(lighter, massAt(i, body[parent[i]]));
        int towardsRoot = up[parent[i]];
        if (towardsRoot >= 0) {
          beyond[towardsRoot] += beyond[i];
          heldBeyond[towardsRoot] += heldBeyond[i];
        }
      }
      double below = heldBeyond[i] > 0 ? total : beyond[i];
      double above = heldInAll > heldBeyond[i] ? total : total - beyond[i];
      largest = Math.max(largest, Math.min(below, above) / lighter);
    }
    return largest;
  }
}
