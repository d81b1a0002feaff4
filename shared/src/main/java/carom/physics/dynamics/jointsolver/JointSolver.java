package carom.physics.dynamics.jointsolver;

import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.contact.ContactTable;
import carom.physics.dynamics.domain.SolverBodies;
import carom.physics.dynamics.joint.JointStore;
import carom.physics.dynamics.jointtree.JointFrame;
import carom.physics.dynamics.jointtree.JointTrees;
import carom.physics.dynamics.jointtree.TreeResponse;
import carom.physics.dynamics.jointtree.TreeSolver;
import carom.physics.dynamics.store.ParallelFor;
import carom.physics.settings.Settings;
import java.util.Arrays;
import java.util.function.IntPredicate;

/**
 * Solves joints by sequential impulses in the same substeps as contacts, before them. {@link
 * JointVisit} says what a visit of a joint does. This class says which joint is visited when, and
 * by which worker.
 *
 * <p><b>Colours.</b> As contacts, joints are given colours, greedily in the order of their slots:
 * those of one colour share no body that can be moved, so their order changes no bit. Colours are
 * solved one after the other: of each first the plain revolutes, in lanes (see {@link
 * RevoluteSolver}), then the others one by one. Threads share both. A body with more than {@value
 * #LAST_COLOUR} joints spills into a last colour without plain revolutes, which isn't shared. The
 * colouring depends on the awake joints alone, and is kept while these stay the same.
 *
 * <p><b>Groups.</b> {@link JointGroups} sees to it that joints make no energy. It decides how much
 * of the old impulses counts, and which joints are visited more often.
 *
 * <p><b>Trees.</b> Chains that carry far more than their links weigh are solved as a whole, after
 * all colours: see {@link JointTrees}.
 */
public final class JointSolver {
  private static final float TWO_PI = 6.2831855f;

  /** The last colour; it takes what found no other. */
  private static final int LAST_COLOUR = 63;

  /** Number of groups: every colour has one of plain revolutes, and one of other joints. */
  private static final int GROUPS = 2 * (LAST_COLOUR + 1);

  /** Group of joints that have no colour, because a tree solves all of them. */
  private static final int NO_GROUP = -1;

  /** Joints that make a piece of work for a worker. */
  private static final int GRAIN = 16;

  private final RevoluteSolver revolutes;

  /** The joints that aren't plain revolutes. */
  private final JointRecords others = new JointRecords();

  private final JointTrees trees = new JointTrees();
  private final TreeSolver treeSolver;
  private final JointGroups groups = new JointGroups();

  /** Joints that are visited one by one, as indices, in the order of visits. */
  private int[] order = new int[0];

  private final ParallelFor parallel;

  /** Visits, one per worker. */
  private JointVisit[] visits = new JointVisit[0];

  /** Frames, one per worker. */
  private JointFrame[] frames = new JointFrame[0];

  private JointStore store;
  private BodyStore bodies;
  private int[] slotOf;
  private Settings settings;
  private float inverseH;
  private int count;

  /** Slots of the joints to solve, ascending. */
  private int[] found = new int[0];

  /** Per such joint: whether one of its bodies is locked along an axis. */
  private boolean[] locked = new boolean[0];

  /** Groups of these joints. */
  private int[] group = new int[0];

  /** Places of these joints in their groups. */
  private int[] place = new int[0];

  /** Colours that each slot of {@link SolverBodies} has. */
  private long[] taken = new long[0];

  /** Per group: how many joints it has. */
  private final int[] size = new int[GROUPS];

  /** Per group, while joints are placed: where the next one goes. */
  private final int[] next = new int[GROUPS];

  /** Per colour: its first block of plain revolutes. */
  private final int[] revoluteStart = new int[LAST_COLOUR + 2];

  /** Per colour: its first other joint. */
  private final int[] start = new int[LAST_COLOUR + 2];

  /** Number of colours in use. */
  private int colours;

  /** {@link JointStore#version} that the colours are of. They are kept until it changes. */
  private int colouredVersion = -1;

  /** True if joints that aren't plain revolutes are of groups that aren't watched. */
  private boolean anyPlain;

  /** True if this step's joints are others than the last one's. */
  private boolean anew;

  // The stages, made once so that a step allocates nothing.
  private final IntPredicate torn = this::isTorn;
  private final ParallelFor.Range packing = this::packJoints;
  private final ParallelFor.Range warming =
      (from, to, worker) -> visits[worker].warmStart(from, to);
  private final ParallelFor.Range biasing = (from, to, worker) -> visits[worker].push(from, to);
  private final ParallelFor.Range relaxingPlain =
      (from, to, worker) -> visits[worker].relaxPlain(from, to);
  private final ParallelFor.Range relaxing = (from, to, worker) -> visits[worker].relax(from, to);
  private final ParallelFor.Range storing = (from, to, worker) -> visits[worker].store(from, to);

  /**
   * Makes a solver.
   *
   * @param lanes kernels for plain revolutes, null for none
   * @param parallel shares colours among workers
   */
  public JointSolver(RevoluteLanes lanes, ParallelFor parallel) {
    this.parallel = parallel;
    revolutes = new RevoluteSolver(lanes, parallel);
    treeSolver = new TreeSolver(trees, parallel);
  }

  /** Returns the number of joints to solve. */
  public int count() {
    return count;
  }

  /** Collects the joints that can move something, and finds the trees among them. */
  public JointTrees find(JointStore j, BodyStore bodyStore) {
    store = j;
    bodies = bodyStore;
    if (found.length < j.count()) {
      int capacity = Math.max(j.count(), found.length * 2);
      found = new int[capacity];
      locked = new boolean[capacity];
      group = new int[capacity];
      place = new int[capacity];
      colouredVersion = -1;
    }
    anew = colouredVersion != j.version() || trees.areStale(j, bodyStore) || areLocksStale();
    if (anew) {
      colouredVersion = j.version();
      findJoints();
      trees.find(j, bodyStore, found, count);
      groups.find(j, bodyStore, trees, found, count);
    }
    return trees;
  }

  /** Colours and packs the joints that {@link #find} has collected. */
  public void prepare(
      JointStore j, BodyStore bodyStore, Settings s, float h, SolverBodies solverBodies) {
    slotOf = solverBodies.slotOf();
    settings = s;
    inverseH = 1 / h;
    if (anew) {
      assignColours(solverBodies.count());
    }
    float omega = TWO_PI * Math.min(s.jointHertz(), ConstraintRow.MAX_HERTZ_PER_RATE / h);
    float twiceZeta = 2 * s.jointDampingRatio();
    float soft = h * omega * (twiceZeta + h * omega);
    float biasRate = omega / (twiceZeta + h * omega);
    float massScale = soft / (1 + soft);
    float impulseScale = 1 / (1 + soft);
    ensureWorkers();
    for (JointVisit visit : visits) {
      visit.begin(j, bodies, solverBodies.state, h, biasRate, massScale, impulseScale);
    }
    revolutes.begin(solverBodies.state, biasRate, massScale, impulseScale);
    layOut();
    others.begin();
    if (anew) {
      for (int i = 0; i < count; i++) {
        place[i] = group[i] == NO_GROUP ? 0 : next[group[i]]++;
      }
      listGroups();
    }
    groups.beginStep(slotOf, h);
    parallel.run(0, count, GRAIN, packing);
    revolutes.ready();
    treeSolver.begin(j, bodyStore, slotOf, solverBodies.state, h, biasRate);
  }

  /** Lists the joints of groups, now that their order is known. */
  private void listGroups() {
    if (order.length < count) {
      order = new int[found.length];
    }
    int visits = 0;
    for (int g = 0; g < 2 * colours; g++) {
      next[g] = visits;
      visits += size[g];
    }
    for (int i = 0; i < count; i++) {
      if (group[i] != NO_GROUP) {
        order[next[group[i]]++] = i;
      }
    }
    groups.listJoints(order, visits);
  }

  /** Returns whether other joints than those that were found have locked bodies. */
  private boolean areLocksStale() {
    for (int i = 0; bodies.anyLinearLocks() && i < count; i++) {
      if (locked[i] != isLocked(found[i])) {
        return true;
      }
    }
    return false;
  }

  private boolean isLocked(int slot) {
    return bodies.areLocked(store.bodyA[slot], store.bodyB[slot]);
  }

  /** Makes what each worker needs. */
  private void ensureWorkers() {
    int had = visits.length;
    if (had < parallel.count()) {
      visits = Arrays.copyOf(visits, parallel.count());
      frames = Arrays.copyOf(frames, parallel.count());
      for (int i = had; i < visits.length; i++) {
        visits[i] = new JointVisit(others);
        frames[i] = new JointFrame();
      }
    }
  }

  /** Finds the joints to solve. */
  private void findJoints() {
    JointStore j = store;
    count = 0;
    for (int slot = j.nextAwake(0); slot >= 0; slot = j.nextAwake(slot + 1)) {
      int one = j.bodyA[slot];
      int two = j.bodyB[slot];
      boolean gone = bodies.disabled(two) || (one >= 0 && bodies.disabled(one));
      if ((isHeld(one) && isHeld(two)) || gone) {
        j.forget(slot);
      } else {
        locked[count] = isLocked(slot);
        found[count++] = slot;
      }
    }
  }

  /** Returns whether what a joint is with can't be moved. */
  private boolean isHeld(int body) {
    return body < 0 || bodies.invMass[body] == 0;
  }

  /** Gives each joint its colour, but for those that trees solve. */
  private void assignColours(int slots) {
    JointStore j = store;
    colours = 0;
    anyPlain = false;
    Arrays.fill(size, 0);
    if (count > 0) {
      clearTaken(slots);
    }
    for (int i = 0; i < count; i++) {
      int slot = found[i];
      boolean plain = store.isPlainHinge(slot) && groups.isPlain(slot);
      if (store.isRigid(slot) && trees.has(slot)) {
        group[i] = NO_GROUP;
        continue;
      }
      // Slot 0 stands for what can't be moved, and takes no colour.
      int a = isHeld(j.bodyA[slot]) ? 0 : slotOf[j.bodyA[slot]];
      int b = isHeld(j.bodyB[slot]) ? 0 : slotOf[j.bodyB[slot]];
      int colour = Math.min(Long.numberOfTrailingZeros(~(taken[a] | taken[b])), LAST_COLOUR);
      long bit = 1L << colour;
      taken[a] |= bit;
      taken[b] |= bit;
      taken[0] = 0;
      colours = Math.max(colours, colour + 1);
      group[i] = 2 * colour + (colour < LAST_COLOUR && plain ? 0 : 1);
      size[group[i]]++;
      anyPlain |= (group[i] & 1) != 0 && groups.isPlain(slot);
    }
  }

  private void clearTaken(int slots) {
    if (taken.length < slots) {
      taken = new long[Math.max(slots, taken.length * 2)];
    }
    Arrays.fill(taken, 0, slots, 0);
  }

  /** Gives each group its places. */
  private void layOut() {
    int sum = 0;
    for (int c = 0; c < colours; c++) {
      revoluteStart[c] = revolutes.blocks();
      next[2 * c] = revolutes.reserve(size[2 * c]);
      start[c] = sum;
      next[2 * c + 1] = sum;
      sum += size[2 * c + 1];
    }
    revoluteStart[colours] = revolutes.blocks();
    start[colours] = sum;
    others.ensure(sum);
  }

  private void packJoints(int from, int to, int worker) {
    JointFrame frame = frames[worker];
    for (int i = from; i < to; i++) {
      if (group[i] == NO_GROUP) {
        continue;
      }
      frame.load(found[i], store, bodies, slotOf);
      if ((group[i] & 1) == 0) {
        revolutes.pack(place[i], frame, store);
      } else {
        others.pack(place[i], frame, store, trees.has(found[i]), groups.isPlain(found[i]));
      }
    }
  }

  /** Applies the impulses of the last substep, or the last step, as far as they add no energy. */
  public void warmStart(SolverBodies b) {
    addSprings(-1);
    for (int c = 0; c < colours; c++) {
      revolutes.warmStart(revoluteStart[c], revoluteStart[c + 1]);
      run(c, warming);
    }
    treeSolver.warmStart();
    if (groups.weigh(b.state, b.beforeJoints(), treeSolver.response())) {
      for (int g = 0; g < groups.count(); g++) {
        for (int at = groups.start(g); groups.share(g) < 1 && at < groups.start(g + 1); at++) {
          int i = groups.joint(at);
          if ((group[i] & 1) == 0) {
            revolutes.scale(place[i], groups.share(g));
          } else {
            store.scaleImpulses(found[i], groups.share(g));
          }
        }
      }
      for (int t = 0; t < trees.count(); t++) {
        float share = groups.share(groups.groupOfBody(trees.bodyOf(t)));
        if (share < 1) {
          treeSolver.scale(t, share);
        }
      }
    }
    groups.begin(b.state, b.beforeJoints());
  }

  /**
   * Visits each joint before bodies move: errors are corrected and springs act. Groups in which one
   * visit of each changes much get more.
   */
  public void applyBiasedImpulses(SolverBodies b) {
    for (int c = 0; c < colours; c++) {
      revolutes.applyBiasedImpulses(revoluteStart[c], revoluteStart[c + 1]);
      run(c, biasing);
    }
    treeSolver.applyBiasedImpulses();
    boolean more = groups.needMore(b.state, b.beforeJoints());
    for (int n = 0; more && n < JointGroups.MOST_PAIRS; n++) {
      visitMore(n, false, true);
      visitMore(n, true, true);
      more = n + 1 < JointGroups.MOST_PAIRS && groups.stillNeedMore(b.state);
    }
    groups.note(b.state, b.beforeJoints());
  }

  /** Visits the joints of groups that need more visits, one by one, and solves their trees. */
  private void visitMore(int pair, boolean forwards, boolean bias) {
    for (int g = 0; g < groups.count(); g++) {
      if (groups.gets(g, pair)) {
        int from = groups.start(g);
        int to = groups.start(g + 1);
        for (int n = 0; n < to - from; n++) {
          int i = groups.joint(forwards ? from + n : to - 1 - n);
          if ((group[i] & 1) == 0) {
            revolutes.visit(place[i], bias);
          } else {
            visits[0].visit(place[i], forwards, bias);
          }
        }
      }
    }
    for (int t = 0; t < trees.count(); t++) {
      if (groups.gets(groups.groupOfBody(trees.bodyOf(t)), pair)) {
        treeSolver.visit(t, bias);
      }
    }
  }

  /** Returns whether {@link #settle} does anything. */
  public boolean settles() {
    return treeSolver.settles();
  }

  /** Solves trees with contacts or welds once more before bodies move. */
  public void settle(SolverBodies b) {
    treeSolver.settle();
    groups.note(b.state, b.beforeJoints(), treeSolver.response());
  }

  /** Returns how the bodies of trees answer contacts. */
  public TreeResponse treeResponse() {
    return treeSolver.response();
  }

  /** Measures trees. By now it is known which ones contacts act on. */
  public void measureTrees() {
    treeSolver.measure();
  }

  /** Solves trees that contacts act on once more after bodies moved. */
  public void absorb() {
    treeSolver.absorb();
  }

  /** Visits each joint after bodies moved, rigid, in the opposite order, and holds energy. */
  public void relax(SolverBodies b) {
    others.posesChanged();
    for (int c = 0; c < colours; c++) {
      revolutes.relax(revoluteStart[c], revoluteStart[c + 1]);
      if (anyPlain) {
        run(c, relaxingPlain);
      }
    }
    for (int c = colours - 1; c >= 0; c--) {
      run(c, relaxing);
    }
    treeSolver.relax();
    for (int n = 0; n < groups.mostPairs(); n++) {
      visitMore(n, true, false);
      visitMore(n, false, false);
    }
    addSprings(1);
    groups.hold(b.state, b.beforeJoints(), torn);
  }

  /** Adds what the springs of groups hold, whose energy is held, with a sign. */
  private void addSprings(int sign) {
    for (int g = 0; g < groups.count(); g++) {
      if (groups.isSprung(g)) {
        groups.noteSprings(g, springEnergy(g, sign > 0), sign);
      }
    }
  }

  private double springEnergy(int g, boolean moved) {
    double joules = 0;
    for (int at = groups.start(g); at < groups.start(g + 1); at++) {
      int i = groups.joint(at);
      joules += store.hasSpring(found[i]) ? visits[0].springEnergy(place[i], moved) : 0;
    }
    return joules;
  }

  /**
   * Takes energy that springs have got since the last substep out of the motion of their bodies.
   * Continuous collision put some of these back, and so it stretched springs.
   */
  public void payStretch(SolverBodies b) {
    others.posesChanged();
    for (int i = 0; i < b.putBackCount(); i++) {
      int g = groups.group(b.putBack(i));
      if (g >= 0 && groups.isSprung(g)) {
        groups.payStretch(g, springEnergy(g, true));
      }
    }
  }

  /** Returns whether visits didn't settle a group of joints in this step. */
  public boolean anyTroubled() {
    return groups.anyTroubled();
  }

  /**
   * Takes energy away from groups of joints that have more than they can have.
   *
   * @param contacts touch them
   * @param dt length of the step, s
   * @param pulls whether bodies move next, with what draws their anchors together
   * @param ends true at the end of the step, when all groups are looked at; false for those in
   *     trouble
   */
  public void limit(SolverBodies b, ContactTable contacts, float dt, boolean pulls, boolean ends) {
    groups.limit(b, contacts, settings, dt, torn, pulls, ends);
  }

  /** Returns whether the anchors of a joint, given by its index, are far apart. */
  private boolean isTorn(int i) {
    return (group[i] & 1) != 0 && others.torn[place[i]];
  }

  /** Does a stage for the joints of a colour that aren't plain revolutes. */
  private void run(int colour, ParallelFor.Range stage) {
    if (start[colour] == start[colour + 1]) {
      return;
    }
    if (colour == LAST_COLOUR) {
      stage.run(start[colour], start[colour + 1], 0);
    } else {
      parallel.run(start[colour], start[colour + 1], GRAIN, stage);
    }
  }

  /** Stores what the joints exerted. */
  public void store() {
    revolutes.store(store, inverseH);
    treeSolver.store(store, inverseH);
    parallel.run(0, start[colours], GRAIN, storing);
  }
}
