package carom.physics.dynamics.jointsolver;

import static carom.physics.dynamics.domain.SolverBodies.COS;
import static carom.physics.dynamics.domain.SolverBodies.DX;
import static carom.physics.dynamics.domain.SolverBodies.DY;
import static carom.physics.dynamics.domain.SolverBodies.MAX_ROTATION;
import static carom.physics.dynamics.domain.SolverBodies.SIN;
import static carom.physics.dynamics.domain.SolverBodies.STRIDE;
import static carom.physics.dynamics.domain.SolverBodies.VELOCITY;
import static carom.physics.dynamics.domain.SolverBodies.VX;
import static carom.physics.dynamics.domain.SolverBodies.VY;
import static carom.physics.dynamics.domain.SolverBodies.W;

import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.contact.ContactTable;
import carom.physics.dynamics.domain.SolverBodies;
import carom.physics.dynamics.joint.JointStore;
import carom.physics.dynamics.jointtree.JointTrees;
import carom.physics.dynamics.jointtree.TreeResponse;
import carom.physics.math.Trig;
import carom.physics.settings.Settings;
import java.util.Arrays;
import java.util.function.IntPredicate;

/**
 * Keeps joints from making energy. A <i>group</i> is what joints hold together: bodies that can be
 * moved.
 *
 * <p>Of all impulses that joints can exert, those that hold them leave the least kinetic energy
 * (Gauss's principle), and each visit of a row comes nearer to that. So where joints without
 * springs and motors add energy, something went wrong. It can in four places:
 *
 * <ul>
 *   <li><b>Warm start.</b> The impulses of the last substep are a guess. They also contain what
 *       errors of position asked for, and where one visit of each joint finds little of an error,
 *       they wind themselves up: a disc with four welded blades got 500,000 times its energy. So
 *       the guess is weighed before it counts ({@link #weigh}).
 *   <li><b>Motion.</b> Bodies move with velocities in which one visit of each joint has found only
 *       a part of the errors. Where it found much, more visits follow ({@link #needMore}).
 *   <li><b>Bias.</b> What draws anchors together is taken out again by the visits after bodies
 *       moved. What they miss is held back ({@link #hold}).
 *   <li><b>Contacts.</b> Their old impulses may be such that only joints balance them, and what is
 *       measured from the velocities of before joints is then no bound. So each step ends with what
 *       groups had when it began ({@link #limit}). Those that all visits didn't settle are held by
 *       a wider bound in each substep, too.
 * </ul>
 *
 * <p>With the velocities v before, their change u and the masses M, a share s of u changes the
 * energy by {@code s (u M v) + s^2 (u M u) / 2}. Each share keeps the momenta, as u does. What
 * springs have got in the substep is added before a change is held back. Where no share is enough,
 * all of a group is slowed, relative to a rigid body that moves freely.
 *
 * <p><b>Plain</b> groups aren't watched: chains and nets of hinges and rods, without trees. They
 * keep more of what turns when their guess isn't weighed, and a net of 10,000 has no time to lose.
 * Bodies of uneven masses are watched: rods of 8 to 1 made a third of their energy. So are those
 * that fly with anchors far outside: of 1,000 such chains 12 made up to all of theirs; and those
 * with locked bodies. A plain group that is held and turns fast, or touches far heavier bodies is
 * compared at the step's end, as all others are.
 *
 * <p>The groups follow from the awake joints, and are no state. Sums are in the order of joints.
 */
final class JointGroups {
  /** Most pairs of visits, there and back, that follow where one visit of each joint finds much. */
  static final int MOST_PAIRS = 8;

  /** Energy that biased visits change, in parts of the group's, from which more visits follow. */
  private static final double MUCH = 5e-4;

  /** The same for groups with springs, turning motors, gears, racks or pulleys. */
  private static final double LITTLE = 5e-5;

  /** Part of its energy that a group may gain in a step, for the errors of steps. */
  private static final double GRAIN = 1e-3;

  /** Times of its energy, and speed of all of it, m/s, with which anchors may be drawn together. */
  private static final double PULL = 4;

  private static final double PULL_SPEED = 3;

  /** Energy per mass that a group may get from nothing in a step, for rounding, J/kg: 1.4 mm/s. */
  private static final double REST = 1e-6;

  /** Energy that trees change, in parts of their group's, from which it is in trouble. */
  private static final double BLOW = 0.1;

  /** Part of a change's energy below which its turning is an error of motion. */
  private static final double SLIGHT = 0.01;

  /** Joints per body from which hinges are a net. */
  private static final float NET = 1.5f;

  /** Part of what springs hold that they may get from nothing in a step. */
  private static final double WOUND = 0.01;

  /** Part of the most speed of turning from which a body turns fast. */
  private static final float FAST = 0.1f;

  /** Most ratio of the masses of a group that isn't watched. */
  private static final float EVEN = 4;

  /** Number of groups. */
  private int count;

  /** Number of bodies in groups. */
  private int bodyCount;

  /** Number of bodies in groups that are watched. They come first. */
  private int watched;

  /** Per body: its slot. */
  private int[] body = new int[0];

  /** Per body: its group. */
  private int[] groupOf = new int[0];

  /** Per body: its slot in {@code SolverBodies}. */
  private int[] place = new int[0];

  private double[] mass = new double[0];
  private double[] inertia = new double[0];

  /** Watched bodies of groups whose energy is held: neither fed nor carried. */
  private int[] tended = new int[0];

  private int tendedCount;

  /** Most speed of turning with which bodies are moved, rad/s. */
  private float mostSpin;

  /** Per tended body: x, y and turn of the change of its velocity by joints in this substep. */
  private double[] change = new double[0];

  /** Per body: its velocity when it was last asked for more visits. */
  private double[] last = new double[0];

  /** Per slot of a body, while groups are found: a body of its group, or itself. */
  private int[] leader = new int[0];

  /** Per slot of a body: its group. */
  private int[] groupAt = new int[0];

  /** Per slot of a body: the search that it was last seen in. */
  private int[] seen = new int[0];

  private int search;

  /** Joints that are visited one by one, group after group, each in the order of visits. */
  private int[] joint = new int[0];

  /** Per group: its first joint; behind the last group, the end. */
  private int[] start = new int[1];

  /** Per group: whether it is a chain or net of hinges and rods that no tree solves. */
  private boolean[] isPlain = new boolean[0];

  /** True for a group that may be plain and has an anchor far outside of a body. */
  private boolean[] isLong = new boolean[0];

  /** Per group: whether a body has more than two joints. */
  private boolean[] crowded = new boolean[0];

  /** Per group: its joints, less those that its bodies would have in a net. */
  private float[] jointsOf = new float[0];

  /** Per group: inverse mass of its lightest body and of its heaviest one, 1/kg. */
  private float[] lightest = new float[0];

  private float[] heaviest = new float[0];

  /** Per group: whether a tree solves joints of it. */
  private boolean[] hasTree = new boolean[0];

  /** Per group: whether it isn't held by what can't be moved, and isn't locked. */
  private boolean[] isFree = new boolean[0];

  /** Per group: whether motors may give it energy, or what draws a body to a point. */
  private boolean[] isFed = new boolean[0];

  /** Per group: whether it has springs and isn't fed. */
  private boolean[] isSprung = new boolean[0];

  /** Per group: energy that its springs have got in this substep, J. */
  private double[] stored = new double[0];

  /** Per group: energy that its springs held when the step began, and hold now, J. */
  private double[] springsBefore = new double[0];

  private double[] springsNow = new double[0];

  /** Set until the first substep of a step has begun. */
  private boolean isFirst;

  /** Per group: whether eight pairs of visits didn't settle it in this step. */
  private boolean[] isTroubled = new boolean[0];

  private boolean anyTroubled;

  /** Islands of what touches. They are found when a group has too much. */
  private final TouchIslands islands = new TouchIslands();

  private boolean areIslandsKnown;

  // Sums over bodies for a step: energy before and now, with the half substep by which velocities
  // are ahead of places; work of gravity and forces; mass and weight.

  private double begun;
  private double work;
  private double now;
  private double sumOfMass;
  private double heavy;

  // Centre of mass of a group, m, and its moment of inertia about it, kg m^2.

  private double centreX;
  private double centreY;
  private double turning;

  /** Per group: whether it touches what can't be moved. */
  private boolean[] isPropped = new boolean[0];

  /** Per group: whether it is plain, and is held and turns fast or touches a far heavier body. */
  private boolean[] isStrained = new boolean[0];

  /** Per group: whether it gets more visits already where these change little. */
  private boolean[] isFine = new boolean[0];

  /** Per group: whether it is held by what moves and can't be moved, or moves along locks. */
  private boolean[] isCarried = new boolean[0];

  /** Per group: whether biased visits still change much. */
  private boolean[] more = new boolean[0];

  /** Per group: how many pairs of visits, there and back, it gets in addition in this substep. */
  private int[] pairs = new int[0];

  /** The most pairs of any group. */
  private int mostPairs;

  // Sums of a group: u M v, u M u, energy, mass and momentum; and the share that counts.

  private double[] product = new double[0];
  private double[] square = new double[0];
  private double[] energy = new double[0];
  private double[] weight = new double[0];
  private double[] momentumX = new double[0];
  private double[] momentumY = new double[0];
  private double[] share = new double[0];

  /** Slots of the joints with what can't be moved, trees' as well. */
  private int[] held = new int[0];

  private int heldCount;

  /** Slots of the motors that turn. */
  private int[] motor = new int[0];

  private int motors;

  /** Per slot of a body: how many joints it has. */
  private int[] degree = new int[0];

  private BodyStore bodies;
  private JointStore joints;

  /** Slots of the joints to solve. */
  private int[] slots;

  /** Per body: its slot in {@code SolverBodies}. */
  private int[] slotOf;

  /** Makes empty lists. */
  JointGroups() {}

  /**
   * Finds the groups.
   *
   * @param found slots of the joints to solve
   * @param n how many
   */
  void find(JointStore j, BodyStore b, JointTrees trees, int[] found, int n) {
    joints = j;
    bodies = b;
    slots = found;
    ensure(Math.max(n, j.count()), b.slots());
    if (n > 0) {
      islands.ensure(b.slots());
    }
    search++;
    bodyCount = 0;
    for (int i = 0; i < n; i++) {
      int one = leader(j.bodyA[found[i]]);
      int two = leader(j.bodyB[found[i]]);
      if (one >= 0) {
        degree[j.bodyA[found[i]]]++;
      }
      if (two >= 0) {
        degree[j.bodyB[found[i]]]++;
      }
      if (one >= 0 && two >= 0) {
        leader[two] = one;
      }
    }
    count = 0;
    for (int i = 0; i < bodyCount; i++) {
      if (leader[body[i]] == body[i]) {
        isPlain[count] = true;
        isLong[count] = false;
        crowded[count] = false;
        jointsOf[count] = 0;
        hasTree[count] = false;
        isFree[count] = true;
        lightest[count] = 0;
        heaviest[count] = Float.POSITIVE_INFINITY;
        groupAt[body[i]] = count++;
      }
    }
    for (int i = 0; i < bodyCount; i++) {
      int g = groupAt[leader(body[i])];
      groupAt[body[i]] = g;
      lightest[g] = Math.max(lightest[g], bodies.invMass[body[i]]);
      heaviest[g] = Math.min(heaviest[g], bodies.invMass[body[i]]);
    }
    heldCount = 0;
    for (int i = 0; i < n; i++) {
      int g = groupOfJoint(found[i]);
      boolean tree = trees.has(found[i]);
      boolean locked = bodies.areLocked(joints.bodyA[found[i]], joints.bodyB[found[i]]);
      isPlain[g] &= !tree && !locked && (joints.isPlainHinge(found[i]) || joints.isRod(found[i]));
      isLong[g] |= isPlain[g] && JointTrees.isFar(joints, bodies, found[i]);
      crowded[g] |= isCrowded(found[i]);
      jointsOf[g]++;
      hasTree[g] |= tree;
      isFree[g] &= !locked;
      if (!isMovable(joints.bodyA[found[i]]) || !isMovable(joints.bodyB[found[i]])) {
        isFree[g] = false;
        held[heldCount++] = found[i];
      }
    }
    for (int i = 0; i < bodyCount; i++) {
      jointsOf[groupAt[body[i]]] -= NET;
    }
    for (int g = 0; g < count; g++) {
      isPlain[g] &= !crowded[g] || jointsOf[g] >= 0;
      isPlain[g] &= lightest[g] <= EVEN * heaviest[g];
      isPlain[g] &= !(isLong[g] && isFree[g]); // a held one is a pendulum
    }
    sortBodies();
  }

  private void ensure(int n, int slotCount) {
    if (leader.length < slotCount) {
      int capacity = Math.max(slotCount, 2 * leader.length);
      leader = new int[capacity];
      groupAt = new int[capacity];
      seen = new int[capacity];
      degree = new int[capacity];
    }
    if (joint.length < n) {
      int capacity = Math.max(n, 2 * joint.length);
      joint = new int[capacity];
      motor = new int[capacity];
      held = new int[capacity];
      ensureBodies(2 * capacity);
      ensureGroups(2 * capacity);
    }
  }

  private void ensureBodies(int capacity) {
    body = new int[capacity];
    groupOf = new int[capacity];
    place = new int[capacity];
    mass = new double[capacity];
    inertia = new double[capacity];
    tended = new int[capacity];
    change = new double[3 * capacity];
    last = new double[3 * capacity];
  }

  private void ensureGroups(int capacity) {
    start = new int[capacity + 1];
    isPlain = new boolean[capacity];
    isLong = new boolean[capacity];
    crowded = new boolean[capacity];
    jointsOf = new float[capacity];
    lightest = new float[capacity];
    heaviest = new float[capacity];
    hasTree = new boolean[capacity];
    isFree = new boolean[capacity];
    isFed = new boolean[capacity];
    isSprung = new boolean[capacity];
    stored = new double[capacity];
    springsBefore = new double[capacity];
    springsNow = new double[capacity];
    isTroubled = new boolean[capacity];
    isPropped = new boolean[capacity];
    isStrained = new boolean[capacity];
    isFine = new boolean[capacity];
    isCarried = new boolean[capacity];
    more = new boolean[capacity];
    pairs = new int[capacity];
    product = new double[capacity];
    square = new double[capacity];
    energy = new double[capacity];
    weight = new double[capacity];
    momentumX = new double[capacity];
    momentumY = new double[capacity];
    share = new double[capacity];
  }

  /** Puts the bodies of a group together, and those of plain groups behind the others. */
  private void sortBodies() {
    Arrays.fill(pairs, 0, count, 0);
    for (int i = 0; i < bodyCount; i++) {
      pairs[groupAt[body[i]]]++;
    }
    watched = layOut(false, 0);
    layOut(true, watched);
    for (int i = 0; i < bodyCount; i++) {
      place[pairs[groupAt[body[i]]]++] = body[i];
    }
    System.arraycopy(place, 0, body, 0, bodyCount);
    for (int i = 0; i < bodyCount; i++) {
      groupOf[i] = groupAt[body[i]];
    }
  }

  /** Gives groups places for as many bodies as are counted; returns the first free one behind. */
  private int layOut(boolean plain, int from) {
    int at = from;
    for (int g = 0; g < count; g++) {
      if (isPlain[g] == plain) {
        int bodiesOf = pairs[g];
        pairs[g] = at;
        at += bodiesOf;
      }
    }
    return at;
  }

  /**
   * Lists the joints of each group.
   *
   * @param order those that are visited one by one, as indices, in the order of visits
   * @param visits how many these are
   */
  void listJoints(int[] order, int visits) {
    Arrays.fill(start, 0, count + 1, 0);
    for (int at = 0; at < visits; at++) {
      start[groupOfJoint(slots[order[at]])]++;
    }
    for (int g = 1; g <= count; g++) {
      start[g] += start[g - 1];
    }
    for (int at = visits - 1; at >= 0; at--) {
      joint[--start[groupOfJoint(slots[order[at]])]] = order[at];
    }
  }

  /** Returns whether a body of a joint has more joints than one of a chain. */
  private boolean isCrowded(int joint) {
    int one = joints.bodyA[joint];
    int two = joints.bodyB[joint];
    return (isMovable(one) && degree[one] > 2) || (isMovable(two) && degree[two] > 2);
  }

  private boolean isMovable(int slot) {
    return slot >= 0 && bodies.invMass[slot] > 0;
  }

  /** Returns the body that stands for the group of a body, -1 if that can't be moved. */
  private int leader(int slot) {
    if (!isMovable(slot)) {
      return -1;
    }
    if (seen[slot] != search) {
      seen[slot] = search;
      leader[slot] = slot;
      degree[slot] = 0;
      body[bodyCount++] = slot;
    }
    int at = slot;
    while (leader[at] != at) {
      leader[at] = leader[leader[at]];
      at = leader[at];
    }
    return at;
  }

  private int groupOfJoint(int slot) {
    int one = joints.bodyA[slot];
    return groupAt[isMovable(one) ? one : joints.bodyB[slot]];
  }

  /** Begins a step of substeps of h seconds: looks at masses, and at what gives groups energy. */
  void beginStep(int[] slotsOf, float h) {
    slotOf = slotsOf;
    mostSpin = MAX_ROTATION / h;
    isFirst = true;
    anyTroubled = false;
    Arrays.fill(isTroubled, 0, count, false);
    for (int i = 0; i < watched; i++) {
      lookAt(i);
    }
    motors = 0;
    for (int g = 0; g < count; g++) {
      isFed[g] = false;
      isSprung[g] = false;
      isFine[g] = false;
      isCarried[g] = false;
      for (int at = start[g]; !isPlain[g] && at < start[g + 1]; at++) {
        int slot = slots[joint[at]];
        isSprung[g] |= joints.hasSpring(slot);
        isFed[g] |= joints.type[slot] == JointStore.MOUSE;
        if ((joints.flags[slot] & JointStore.DRIVEN) != 0 && joints.motorSpeed[slot] != 0) {
          isFed[g] = true;
          motor[motors++] = slot;
        }
        isFine[g] |= isFed[g] || isSprung[g] || joints.isCoupled(slot);
      }
    }
    for (int i = 0; i < heldCount; i++) {
      if (isMoving(joints.bodyA[held[i]]) || isMoving(joints.bodyB[held[i]])) {
        isCarried[groupOfJoint(held[i])] = true;
      }
    }
    for (int i = 0; bodies.anyLinearLocks() && i < watched; i++) {
      isCarried[groupOf[i]] |= isMoving(body[i]);
    }
    for (int g = 0; g < count; g++) {
      isSprung[g] &= !isFed[g] && !isCarried[g];
    }
    tendedCount = 0;
    for (int i = 0; i < watched; i++) {
      if (!isFed[groupOf[i]] && !isCarried[groupOf[i]]) {
        tended[tendedCount++] = i;
      }
    }
  }

  /** Looks at the place and mass of a body. */
  private void lookAt(int member) {
    int slot = body[member];
    place[member] = slotOf[slot];
    mass[member] = 1.0 / bodies.invMass[slot];
    inertia[member] = bodies.invInertia[slot] > 0 ? 1.0 / bodies.invInertia[slot] : 0;
  }

  /** Returns whether a body moves where it can't be moved. */
  private boolean isMoving(int slot) {
    return slot >= 0
        && (bodies.invMass[slot] == 0
            ? bodies.vx[slot] != 0 || bodies.vy[slot] != 0 || bodies.w[slot] != 0
            : bodies.isLockedMotion(slot));
  }

  /** Returns the number of groups. */
  int count() {
    return count;
  }

  /** Returns where the joints of a group begin, which end where those of the next one begin. */
  int start(int group) {
    return start[group];
  }

  /** Returns the joint at a place, as an index. */
  int joint(int at) {
    return joint[at];
  }

  /** Returns the share of the old impulses with which a group starts, 0 to 1. */
  float share(int group) {
    return (float) share[group];
  }

  /** Returns whether a group has springs, and its energy is held. */
  boolean isSprung(int group) {
    return isSprung[group];
  }

  /**
   * Notes what the springs of a group hold. The difference of two notes is what they have got.
   *
   * @param sign -1 as a substep begins, 1 as it ends
   */
  void noteSprings(int group, double joules, int sign) {
    stored[group] += sign * joules;
    springsNow[group] = joules;
    if (isFirst) {
      springsBefore[group] = joules;
    }
  }

  /** Slows bodies of a group by what its springs have got since they were noted last. */
  void payStretch(int group, double joules) {
    double m = 0;
    double sum = 0;
    for (int i = 0; i < watched; i++) {
      if (groupOf[i] == group) {
        m += mass[i];
        double vx = bodies.vx[body[i]];
        double vy = bodies.vy[body[i]];
        double w = bodies.w[body[i]];
        sum += 0.5 * (mass[i] * (vx * vx + vy * vy) + inertia[i] * w * w);
      }
    }
    double got = joules - springsNow[group];
    springsNow[group] = joules;
    if (got <= REST * m) {
      return;
    }
    float left = (float) Math.sqrt(Math.max(1 - got / sum, 0));
    for (int i = 0; i < watched; i++) {
      if (groupOf[i] == group) {
        bodies.vx[body[i]] *= left;
        bodies.vy[body[i]] *= left;
        bodies.w[body[i]] *= left;
      }
    }
  }

  /** Returns whether a joint is of a group that isn't watched. */
  boolean isPlain(int jointSlot) {
    return isPlain[groupOfJoint(jointSlot)];
  }

  /** Returns the group of a body that joints hold. */
  int groupOfBody(int slot) {
    return groupAt[slot];
  }

  /**
   * Weighs the impulses of the last substep, which were just applied, and takes back what adds
   * energy. What a motor is to do counts as taken. Trees without rows beside them are left alone.
   *
   * @param v state of the bodies
   * @param before velocities before
   * @param response tells which trees contacts act on
   * @return whether the share of any group is below 1
   */
  boolean weigh(float[] v, float[] before, TreeResponse response) {
    for (int g = 0; g < count; g++) {
      product[g] = 0;
      square[g] = 0;
      energy[g] = 0;
      weight[g] = 0;
      momentumX[g] = 0;
      momentumY[g] = 0;
    }
    for (int i = 0; i < motors; i++) {
      product[groupOfJoint(motor[i])] -=
          (double) joints.motorImpulse[motor[i]] * joints.motorSpeed[motor[i]];
    }
    for (int i = 0; i < watched; i++) {
      int at = place[i] * STRIDE;
      int old = place[i] * VELOCITY;
      double x = before[old + VX];
      double y = before[old + VY];
      double w = before[old + W];
      double ux = v[at + VX] - x;
      double uy = v[at + VY] - y;
      double uw = v[at + W] - w;
      int g = groupOf[i];
      double m = mass[i];
      double turning = inertia[i];
      product[g] += m * (ux * x + uy * y) + turning * uw * w;
      square[g] += m * (ux * ux + uy * uy) + turning * uw * uw;
      energy[g] += 0.5 * (m * (x * x + y * y) + turning * w * w);
      weight[g] += m;
      momentumX[g] += m * x;
      momentumY[g] += m * y;
    }
    boolean any = false;
    for (int g = 0; g < count; g++) {
      if (isFree[g]) {
        double px = momentumX[g];
        double py = momentumY[g];
        energy[g] = Math.max(energy[g] - 0.5 * (px * px + py * py) / weight[g], 0);
      }
      boolean treeAlone = hasTree[g] && start[g] == start[g + 1];
      share[g] = treeAlone || isCarried[g] || isPlain[g] ? 1 : share(product[g], square[g]);
      any |= share[g] < 1;
    }
    for (int i = 0; any && i < watched; i++) {
      if (hasTree[groupOf[i]] && response.startsLate(body[i])) {
        share[groupOf[i]] = 1; // what contacts begin with is in the change, too
      }
    }
    if (any) {
      for (int i = 0; i < watched; i++) {
        double back = 1 - share[groupOf[i]];
        if (back > 0) {
          int at = place[i] * STRIDE;
          int old = place[i] * VELOCITY;
          v[at + VX] -= (float) (back * ((double) v[at + VX] - before[old + VX]));
          v[at + VY] -= (float) (back * ((double) v[at + VY] - before[old + VY]));
          v[at + W] -= (float) (back * ((double) v[at + W] - before[old + W]));
        }
      }
    }
    return any;
  }

  private void clear(double[] sums) {
    Arrays.fill(sums, 0, count, 0);
  }

  /** Returns the largest share with which energy doesn't grow. */
  private static double share(double product, double square) {
    return 2 * product + square <= 0 ? 1 : Math.max(-2 * product / square, 0);
  }

  /**
   * Returns the largest share with which energy doesn't grow, or that with which it grows least.
   *
   * @param more energy that has grown already, J, or has fallen
   */
  private static double share(double product, double square, double more) {
    if (more == 0) {
      return share(product, square);
    }
    if (square == 0 || 2 * (product + more) + square <= 0) {
      return 1;
    }
    double root = Math.sqrt(Math.max(product * product - 2 * square * more, 0));
    return Math.max(0, Math.min((root - product) / square, 1));
  }

  /** Notes what the first impulses of a substep changed. */
  void begin(float[] v, float[] before) {
    isFirst = false;
    Arrays.fill(change, 0, 3 * tendedCount, 0);
    note(v, before);
  }

  /** Notes what impulses changed. */
  void note(float[] v, float[] before) {
    note(v, before, null);
  }

  /**
   * Notes what impulses changed, but for bodies of trees that contacts have just acted on. Faster
   * than bodies may turn they don't turn; else that would be cut as they move, and not be noted.
   *
   * @param response tells which these are; null for none
   */
  void note(float[] v, float[] before, TreeResponse response) {
    for (int i = 0; i < tendedCount; i++) {
      if (response != null && response.isTouchedAt(body[tended[i]])) {
        continue;
      }
      int at = place[tended[i]] * STRIDE;
      int old = place[tended[i]] * VELOCITY;
      if (Math.abs(v[at + W]) > mostSpin) {
        v[at + W] = v[at + W] > 0 ? mostSpin : -mostSpin;
      }
      change[3 * i] += (double) v[at + VX] - before[old + VX];
      change[3 * i + 1] += (double) v[at + VY] - before[old + VY];
      change[3 * i + 2] += (double) v[at + W] - before[old + W];
    }
  }

  /**
   * Returns whether biased visits still change enough for groups to need more of them.
   *
   * @param v state of the bodies
   * @param before velocities before
   */
  boolean needMore(float[] v, float[] before) {
    clear(square);
    for (int i = 0; i < watched; i++) {
      int at = place[i] * STRIDE;
      int old = place[i] * VELOCITY;
      double ux = (double) v[at + VX] - before[old + VX];
      double uy = (double) v[at + VY] - before[old + VY];
      double uw = (double) v[at + W] - before[old + W];
      square[groupOf[i]] += mass[i] * (ux * ux + uy * uy) + inertia[i] * uw * uw;
    }
    for (int g = 0; g < count; g++) {
      boolean treeAlone = start[g] == start[g + 1];
      more[g] = !isPlain[g] && !treeAlone;
      pairs[g] = 0;
      isTroubled[g] |= treeAlone && 0.5 * square[g] > BLOW * energy[g];
      anyTroubled |= isTroubled[g];
    }
    mostPairs = 0;
    return grantPairs(v);
  }

  /** Returns whether the visits since the last question have changed too much for some groups. */
  boolean stillNeedMore(float[] v) {
    clear(square);
    for (int i = 0; i < watched; i++) {
      int g = groupOf[i];
      if (more[g]) {
        int at = place[i] * STRIDE;
        double ux = v[at + VX] - last[3 * i];
        double uy = v[at + VY] - last[3 * i + 1];
        double uw = v[at + W] - last[3 * i + 2];
        square[g] += mass[i] * (ux * ux + uy * uy) + inertia[i] * uw * uw;
      }
    }
    return grantPairs(v);
  }

  /** Gives groups in which much has changed another pair of visits, and remembers velocities. */
  private boolean grantPairs(float[] v) {
    boolean any = false;
    for (int g = 0; g < count; g++) {
      more[g] &= 0.5 * square[g] > (isFine[g] ? LITTLE : MUCH) * energy[g];
      pairs[g] += more[g] ? 1 : 0;
      any |= more[g];
      isTroubled[g] |= pairs[g] == MOST_PAIRS;
      anyTroubled |= isTroubled[g];
    }
    if (!any) {
      return false;
    }
    mostPairs++;
    for (int i = 0; i < watched; i++) {
      if (more[groupOf[i]]) {
        int at = place[i] * STRIDE;
        last[3 * i] = v[at + VX];
        last[3 * i + 1] = v[at + VY];
        last[3 * i + 2] = v[at + W];
      }
    }
    return true;
  }

  /** Returns how many pairs of visits the groups with most of them get after bodies moved. */
  int mostPairs() {
    return mostPairs;
  }

  /** Returns whether a group gets another pair of visits after bodies moved. */
  boolean gets(int group, int pair) {
    return pair < pairs[group];
  }

  /** Takes back what joints without motors have added to the energy, that of springs included. */
  void hold(float[] v, float[] before, IntPredicate torn) {
    if (tendedCount == 0) {
      return;
    }
    note(v, before);
    clear(product);
    clear(square);
    addChanges(0, tendedCount, v);
    for (int from = 0; from < tendedCount; from = end(from, tendedCount)) {
      int g = groupOf[tended[from]];
      if (isFree[g] && !hasTree[g] && share(product[g], square[g], stored[g]) < 1) {
        double whole = square[g];
        product[g] = 0;
        square[g] = 0;
        unturn(from, end(from, tendedCount), whole, v);
        addChanges(from, end(from, tendedCount), v);
      }
    }
    boolean any = false;
    for (int g = 0; g < count; g++) {
      boolean held = !isFed[g] && !isCarried[g];
      share[g] = held ? share(product[g], square[g], stored[g]) : 1;
      if (share[g] < 1 && isTorn(g, torn)) {
        share[g] = 1;
      }
      double left = share[g] * (product[g] + 0.5 * share[g] * square[g]) + stored[g];
      stored[g] = isSprung[g] ? Math.max(left, 0) : 0;
      any |= share[g] < 1 || stored[g] > 0;
    }
    if (any) {
      holdBack(v);
    }
  }

  /** Adds up the energy of changes of velocity, and what they do to that of the groups. */
  private void addChanges(int from, int to, float[] v) {
    for (int i = from; i < to; i++) {
      int member = tended[i];
      int g = groupOf[member];
      int at = place[member] * STRIDE;
      double ux = change[3 * i];
      double uy = change[3 * i + 1];
      double uw = change[3 * i + 2];
      product[g] +=
          mass[member] * (ux * (v[at + VX] - ux) + uy * (v[at + VY] - uy))
              + inertia[member] * uw * (v[at + W] - uw);
      square[g] += mass[member] * (ux * ux + uy * uy) + inertia[member] * uw * uw;
    }
  }

  /**
   * Takes the turning of a group that moves freely out of the change of its velocities. Joints gave
   * it none, but bodies have moved since, and what is held back of the change must not turn it.
   */
  private void unturn(int from, int to, double whole, float[] v) {
    findCentre(from, to, v);
    double moment = 0;
    for (int i = from; i < to; i++) {
      int member = tended[i];
      double rx = fromCentreX(member, v);
      double ry = fromCentreY(member, v);
      moment += mass[member] * (rx * change[3 * i + 1] - ry * change[3 * i]);
      moment += inertia[member] * change[3 * i + 2];
    }
    double spin = turning > 0 ? moment / turning : 0;
    if (spin * moment > SLIGHT * whole) {
      return;
    }
    for (int i = from; i < to; i++) {
      int member = tended[i];
      change[3 * i] += spin * fromCentreY(member, v);
      change[3 * i + 1] -= spin * fromCentreX(member, v);
      change[3 * i + 2] -= inertia[member] > 0 ? spin : 0;
    }
  }

  /** Finds the centre of mass of a group, and its moment of inertia about it. */
  private void findCentre(int from, int to, float[] v) {
    sumOfMass = 0;
    centreX = 0;
    centreY = 0;
    for (int i = from; i < to; i++) {
      int member = tended[i];
      int at = place[member] * STRIDE;
      sumOfMass += mass[member];
      centreX += mass[member] * ((double) bodies.x[body[member]] + v[at + DX]);
      centreY += mass[member] * ((double) bodies.y[body[member]] + v[at + DY]);
    }
    centreX /= sumOfMass;
    centreY /= sumOfMass;
    turning = 0;
    for (int i = from; i < to; i++) {
      int member = tended[i];
      double rx = fromCentreX(member, v);
      double ry = fromCentreY(member, v);
      turning += mass[member] * (rx * rx + ry * ry) + inertia[member];
    }
  }

  private double fromCentreX(int member, float[] v) {
    return bodies.x[body[member]] + v[place[member] * STRIDE + DX] - centreX;
  }

  private double fromCentreY(int member, float[] v) {
    return bodies.y[body[member]] + v[place[member] * STRIDE + DY] - centreY;
  }

  /** Returns whether anchors are so far apart that closing the gap is all that counts. */
  private boolean isTorn(int g, IntPredicate torn) {
    for (int at = start[g]; at < start[g + 1]; at++) {
      if (torn.test(joint[at])) {
        return true;
      }
    }
    return false;
  }

  private void holdBack(float[] v) {
    for (int i = 0; i < tendedCount; i++) {
      double back = 1 - share[groupOf[tended[i]]];
      if (back > 0) {
        int at = place[tended[i]] * STRIDE;
        v[at + VX] -= (float) (back * change[3 * i]);
        v[at + VY] -= (float) (back * change[3 * i + 1]);
        v[at + W] -= (float) (back * change[3 * i + 2]);
      }
    }
    for (int from = 0; from < tendedCount; from = end(from, tendedCount)) {
      int g = groupOf[tended[from]];
      if (stored[g] > 0) {
        slow(from, end(from, tendedCount), isFree[g], stored[g], v);
        stored[g] = 0;
      }
    }
  }

  /** Returns where the tended bodies of a group end that begins there. */
  private int end(int from, int n) {
    int to = from + 1;
    while (to < n && groupOf[tended[to]] == groupOf[tended[from]]) {
      to++;
    }
    return to;
  }

  /** Returns whether a group is in trouble. */
  boolean anyTroubled() {
    return anyTroubled;
  }

  /**
   * Slows groups that have more energy than when the step began, than gravity and forces have given
   * them since, and than what touches them has lost. This is the last net. Weighing and holding
   * compare with the velocities of before joints, in which the impulses of contacts may be that
   * only joints balance; so they don't notice what a light link gets of a heavy load. Nor do they
   * know of errors of position, which draw bodies uphill.
   *
   * @param solver the bodies, and how gravity and forces accelerate them
   * @param contacts touch the groups
   * @param s tell how fast overlap is pushed apart
   * @param stepS length of the step, s
   * @param torn tells which joints may pull as they like
   * @param pulls whether bodies move next, with what draws their anchors together
   * @param ends true at the end of the step, when all groups are looked at; false for those in
   *     trouble
   */
  void limit(
      SolverBodies solver,
      ContactTable contacts,
      Settings s,
      double stepS,
      IntPredicate torn,
      boolean pulls,
      boolean ends) {
    float[] v = solver.state;
    areIslandsKnown = false;
    double half = 0.5 * stepS / s.substeps();
    int n = ends ? addStrained(v, contacts) : tendedCount;
    int next;
    for (int from = 0; from < n; from = next) {
      int g = groupOf[tended[from]];
      next = end(from, n);
      if ((!ends && !isTroubled[g]) || (pulls && isTorn(g, torn))) {
        continue;
      }
      int to = next;
      clearSums();
      for (int i = from; i < to; i++) {
        addToSums(body[tended[i]], solver, half);
      }
      double has = now;
      double had = begun;
      double m = sumOfMass;
      double may = begun + work + (isSprung[g] ? springsBefore[g] - springsNow[g] : 0);
      double lifted = heavy * s.maxPushSpeed() * stepS + (isSprung[g] ? WOUND * springsNow[g] : 0);
      boolean uphill = ends && !isPlain[g] && -may > m * REST + lifted;
      double most = (1 + GRAIN) * Math.max(may, 0) + m * REST;
      if (pulls) {
        most = Math.max(most, PULL * Math.max(may, 0) + 0.5 * m * PULL_SPEED * PULL_SPEED);
      }
      if (!uphill && !(has > most)) {
        continue;
      }
      if (!areIslandsKnown) {
        areIslandsKnown = true;
        findIslands(contacts, solver, half);
      }
      double given = islands.given(node(body[tended[from]]), has - may, GRAIN);
      boolean loose = !hasTree[g] || isPropped[g]; // a tree may pull up what hangs on it
      if (uphill && loose && -may > lifted + given && !isTorn(g, torn)) {
        goBack(from, to, had / (had - may), v);
      }
      if (has > most + given) {
        double left = has - most - given;
        islands.add(node(body[tended[from]]), 0, -left);
        boolean keeps = isFree[g] && !isPropped[g];
        if (keeps) {
          left = slow(from, to, true, left, v);
        }
        if (!keeps || (left > most && !isTorn(g, torn))) { // such momentum isn't its own
          slow(from, to, false, left, v);
        }
      }
    }
  }

  private void clearSums() {
    begun = 0;
    work = 0;
    now = 0;
    sumOfMass = 0;
    heavy = 0;
  }

  /** Adds the energies of a body that can be moved. */
  private void addToSums(int slot, SolverBodies solver, double half) {
    float[] v = solver.state;
    int at = slotOf[slot] * STRIDE;
    double m = 1.0 / bodies.invMass[slot];
    double turning = bodies.invInertia[slot] > 0 ? 1.0 / bodies.invInertia[slot] : 0;
    double x = m * solver.accelerationX(slotOf[slot]);
    double y = m * solver.accelerationY(slotOf[slot]);
    double torque = turning * solver.angularAcceleration(slotOf[slot]);
    double vx = bodies.vx[slot];
    double vy = bodies.vy[slot];
    double w = bodies.w[slot];
    sumOfMass += m;
    heavy += Math.abs(x) + Math.abs(y);
    begun += 0.5 * (m * (vx * vx + vy * vy) + turning * w * w);
    work += half * (x * vx + y * vy + torque * w) + x * v[at + DX] + y * v[at + DY];
    work += torque == 0 ? 0 : torque * Trig.atan2(v[at + SIN], v[at + COS]);
    vx = v[at + VX];
    vy = v[at + VY];
    w = v[at + W];
    now += 0.5 * (m * (vx * vx + vy * vy) + turning * w * w);
    now += half * (x * vx + y * vy + torque * w);
  }

  /**
   * Adds the bodies of plain groups that are held and turn fast, or on which far heavier bodies lie
   * or fall. Returns the number of bodies whose energy is held now.
   */
  private int addStrained(float[] v, ContactTable contacts) {
    int n = tendedCount;
    if (watched == bodyCount) {
      return n;
    }
    Arrays.fill(isStrained, 0, count, false);
    boolean any = false;
    for (int i = watched; i < bodyCount; i++) {
      boolean fast = Math.abs(v[slotOf[body[i]] * STRIDE + W]) > FAST * mostSpin;
      if (fast && !isFree[groupOf[i]] && !isCarried[groupOf[i]]) {
        isStrained[groupOf[i]] = true;
        any = true;
      }
    }
    for (int row = 0; row < contacts.count(); row++) {
      if (contacts.points[row] > 0) {
        int a = contacts.bodyA(row);
        int b = contacts.bodyB(row);
        any |= load(a, b);
        any |= load(b, a);
      }
    }
    for (int i = watched; any && i < bodyCount; i++) {
      if (isStrained[groupOf[i]]) {
        lookAt(i);
        tended[n++] = i;
      }
    }
    return n;
  }

  /** Notes a body of a plain group that touches a far heavier body. */
  private boolean load(int slot, int other) {
    int g = group(slot);
    boolean heavy = g >= 0 && isPlain[g] && !isCarried[g] && isMovable(other);
    if (!heavy || EVEN * bodies.invMass[other] > heaviest[g]) {
      return false;
    }
    isStrained[g] = true;
    return true;
  }

  /** Moves a group back to a share of its way in this step: errors of position drew it uphill. */
  private void goBack(int from, int to, double share, float[] v) {
    for (int i = from; i < to; i++) {
      int at = place[tended[i]] * STRIDE;
      float turn = (float) (share * Trig.atan2(v[at + SIN], v[at + COS]));
      v[at + DX] *= (float) share;
      v[at + DY] *= (float) share;
      v[at + SIN] = Trig.sin(turn);
      v[at + COS] = Trig.cos(turn);
    }
  }

  /** Finds what touches each other, and how much energy it has got in this step. */
  private void findIslands(ContactTable contacts, SolverBodies solver, double half) {
    islands.begin(bodies.slots());
    Arrays.fill(isPropped, 0, count, false);
    for (int row = 0; row < contacts.count(); row++) {
      if (contacts.points[row] > 0) {
        int a = contacts.bodyA(row);
        int b = contacts.bodyB(row);
        if (isMovable(a) && isMovable(b)) {
          islands.join(node(a), node(b));
        } else {
          prop(a, b);
          prop(b, a);
        }
      }
    }
    for (int row = 0; row < contacts.count(); row++) {
      if (contacts.points[row] > 0) {
        int a = contacts.bodyA(row);
        int b = contacts.bodyB(row);
        int at = row * ContactTable.MATERIAL;
        boolean gives = contacts.material[at + ContactTable.SURFACE] != 0;
        gives |= contacts.material[at + ContactTable.RESTITUTION] > 1;
        addTouching(a, gives || isMoving(b), solver, half);
        addTouching(b, gives || isMoving(a), solver, half);
      }
    }
    for (int i = 0; i < bodyCount; i++) {
      clearSums();
      addToSums(body[i], solver, half);
      islands.add(node(body[i]), begun, now - begun - work);
    }
    for (int i = 0; i < bodyCount; i++) {
      int g = groupOf[i];
      if (isFed[g] || isCarried[g]) {
        islands.open(node(body[i]));
      } else if (isSprung[g] && leader[body[i]] == body[i]) {
        islands.add(node(body[i]), 0, springsNow[g] - springsBefore[g]);
      }
    }
  }

  /** Notes a group that touches what can't be moved. */
  private void prop(int slot, int other) {
    if (group(slot) >= 0 && !isMovable(other) && !isMoving(other)) {
      isPropped[group(slot)] = true;
    }
  }

  private void addTouching(int slot, boolean gives, SolverBodies solver, double half) {
    if (!isMovable(slot)) {
      return;
    }
    if (gives) {
      islands.open(node(slot));
    }
    if (group(slot) < 0 && islands.isFirst(slot)) {
      clearSums();
      addToSums(slot, solver, half);
      islands.add(slot, begun, now - begun - work);
    }
  }

  /** Returns the body that stands for all that joints hold with a body. */
  private int node(int slot) {
    return group(slot) >= 0 ? leader(slot) : slot;
  }

  /** Returns the group of a body, -1 for none. */
  int group(int slot) {
    boolean isKnown = slot < seen.length && seen[slot] == search; // only jointed bodies are
    return isKnown && isMovable(slot) ? groupAt[slot] : -1;
  }

  /**
   * Takes energy out of the motion of a group, as far as there is any. Of one that moves freely
   * only the motion relative to a rigid body counts, and so the momenta stay.
   *
   * @param from its first tended body
   * @param to the end of these
   * @return what there wasn't to be taken, J
   */
  private double slow(int from, int to, boolean free, double joules, float[] v) {
    double vx = 0;
    double vy = 0;
    double moment = 0;
    if (free) {
      findCentre(from, to, v);
      for (int i = from; i < to; i++) {
        vx += mass[tended[i]] * v[place[tended[i]] * STRIDE + VX];
        vy += mass[tended[i]] * v[place[tended[i]] * STRIDE + VY];
      }
      vx /= sumOfMass;
      vy /= sumOfMass;
      for (int i = from; i < to; i++) {
        int member = tended[i];
        int at = place[member] * STRIDE;
        double rx = fromCentreX(member, v);
        double ry = fromCentreY(member, v);
        moment += mass[member] * (rx * (v[at + VY] - vy) - ry * (v[at + VX] - vx));
        moment += inertia[member] * v[at + W];
      }
    }
    double spin = free && turning > 0 ? moment / turning : 0;
    double sum = 0;
    for (int i = from; i < to; i++) {
      int member = tended[i];
      int at = place[member] * STRIDE;
      double ux = v[at + VX] - vx + spin * fromCentreY(member, v);
      double uy = v[at + VY] - vy - spin * fromCentreX(member, v);
      double uw = v[at + W] - spin;
      sum += 0.5 * (mass[member] * (ux * ux + uy * uy) + inertia[member] * uw * uw);
      change[3 * i] = ux;
      change[3 * i + 1] = uy;
      change[3 * i + 2] = inertia[member] > 0 ? uw : 0;
    }
    double lost = sum > 0 ? 1 - Math.sqrt(Math.max(1 - joules / sum, 0)) : 0;
    for (int i = from; i < to; i++) {
      int at = place[tended[i]] * STRIDE;
      v[at + VX] -= (float) (lost * change[3 * i]);
      v[at + VY] -= (float) (lost * change[3 * i + 1]);
      v[at + W] -= (float) (lost * change[3 * i + 2]);
    }
    return Math.max(joules - sum, 0);
  }
}
