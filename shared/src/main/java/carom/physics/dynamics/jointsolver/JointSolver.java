package carom.physics.dynamics.jointsolver;

import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.joint.JointStore;
import carom.physics.dynamics.jointtree.JointFrame;
import carom.physics.dynamics.jointtree.JointTrees;
import carom.physics.dynamics.jointtree.TreeResponse;
import carom.physics.dynamics.jointtree.TreeSolver;
import carom.physics.dynamics.parallel.ParallelFor;
import carom.physics.dynamics.solverbody.SolverBodies;
import carom.physics.settings.Settings;
import java.util.Arrays;

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
 * <p><b>Trees.</b> Chains that carry far more than their links weigh are solved as a whole, after
 * all colours: see {@link JointTrees}.
 */
public final class JointSolver {
  private static final float TWO_PI = 6.2831855f;

  /** Most frequency of rigid coordinates, as a fraction of the substeps per second. */
  private static final float MAX_HERTZ_PER_RATE = 0.25f;

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
  private final ParallelFor parallel;

  /** Visits, one per worker. */
  private JointVisit[] visits = new JointVisit[0];

  /** Frames, one per worker. */
  private JointFrame[] frames = new JointFrame[0];

  private JointStore store;
  private BodyStore bodies;
  private int[] slotOf;
  private float inverseH;
  private int count;

  /** Slots of the joints to solve, ascending. */
  private int[] found = new int[0];

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

  /** Whether this step's joints are others than the last one's. */
  private boolean anew;

  // The stages, made once so that a step allocates nothing.
  private final ParallelFor.Range packing = this::packJoints;
  private final ParallelFor.Range warming =
      (from, to, worker) -> visits[worker].warmStart(from, to);
  private final ParallelFor.Range biasing =
      (from, to, worker) -> visits[worker].solve(from, to, true);
  private final ParallelFor.Range relaxing =
      (from, to, worker) -> visits[worker].solve(from, to, false);
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
      group = new int[capacity];
      place = new int[capacity];
      colouredVersion = -1;
    }
    anew = colouredVersion != j.version() || trees.areStale(j, bodyStore);
    if (anew) {
      colouredVersion = j.version();
      findJoints();
      trees.find(j, bodyStore, found, count);
    }
    return trees;
  }

  /** Colours and packs the joints that {@link #find} has collected. */
  public void prepare(
      JointStore j, BodyStore bodyStore, Settings s, float h, SolverBodies solverBodies) {
    slotOf = solverBodies.slotOf();
    inverseH = 1 / h;
    if (anew) {
      assignColours(solverBodies.count());
    }
    float omega = TWO_PI * Math.min(s.jointHertz(), MAX_HERTZ_PER_RATE / h);
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
    if (anew) {
      for (int i = 0; i < count; i++) {
        place[i] = group[i] == NO_GROUP ? 0 : next[group[i]]++;
      }
    }
    parallel.run(0, count, GRAIN, packing);
    revolutes.ready();
    treeSolver.begin(j, bodyStore, slotOf, solverBodies.state, h, biasRate);
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
    Arrays.fill(size, 0);
    if (count > 0) {
      clearTaken(slots);
    }
    for (int i = 0; i < count; i++) {
      int slot = found[i];
      boolean plain = isPlainRevolute(slot);
      boolean rigid = plain || store.isRod(slot) || store.isRigidWeld(slot);
      if (rigid && trees.has(slot)) {
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
    }
  }

  private void clearTaken(int slots) {
    if (taken.length < slots) {
      taken = new long[Math.max(slots, taken.length * 2)];
    }
    Arrays.fill(taken, 0, slots, 0);
  }

  private boolean isPlainRevolute(int slot) {
    int more = JointStore.LIMITED | JointStore.DRIVEN | JointStore.SPRUNG;
    return store.type[slot] == JointStore.REVOLUTE
        && (store.flags[slot] & more) == 0
        && !store.isRatchet(slot);
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
        others.pack(place[i], frame, store, trees.has(found[i]));
      }
    }
  }

  /** Applies the impulses remembered from the last substep, or the last step. */
  public void warmStart() {
    for (int c = 0; c < colours; c++) {
      revolutes.warmStart(revoluteStart[c], revoluteStart[c + 1]);
      run(c, warming);
    }
    treeSolver.warmStart();
  }

  /** Visits each joint once before bodies move: errors are corrected and springs act. */
  public void applyBiasedImpulses() {
    for (int c = 0; c < colours; c++) {
      revolutes.applyBiasedImpulses(revoluteStart[c], revoluteStart[c + 1]);
      run(c, biasing);
    }
    treeSolver.applyBiasedImpulses();
  }

  /** Returns whether {@link #settle} does anything. */
  public boolean settles() {
    return treeSolver.settles();
  }

  /** Solves trees with contacts or welds once more before bodies move. */
  public void settle() {
    treeSolver.settle();
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

  /** Visits each joint once after bodies moved, rigid. */
  public void relax() {
    for (int c = 0; c < colours; c++) {
      revolutes.relax(revoluteStart[c], revoluteStart[c + 1]);
      run(c, relaxing);
    }
    treeSolver.relax();
  }

  /** Does a stage for the joints of a colour that aren't plain revolutes. */
  private void run(int colour, ParallelFor.Range stage) {
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
