package carom.physics.dynamics.solver;

import static carom.physics.dynamics.solver.ContactBlocks.FIRST;
import static carom.physics.dynamics.solver.ContactBlocks.FIXED;
import static carom.physics.dynamics.solver.ContactBlocks.LANES;
import static carom.physics.dynamics.solver.ContactBlocks.SECOND;
import static carom.physics.dynamics.solver.ContactBlocks.TWO;
import static carom.physics.dynamics.solver.ContactBlocks.WIDE;

import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.body.ShapeTable;
import carom.physics.dynamics.contact.ContactTable;
import carom.physics.dynamics.domain.DomainPhases;
import carom.physics.dynamics.domain.SolverBodies;
import carom.physics.dynamics.jointtree.JointTrees;
import carom.physics.dynamics.jointtree.TreeResponse;
import carom.physics.dynamics.store.ParallelFor;
import carom.physics.settings.Settings;

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
 * <p>A visit changes v by {@code (P' - P) / m}. With the inverse effective mass k = 1 / m and
 * {@code q = v + b s - k P} that makes
 *
 * <pre>
 *   (k + g) P' = -q      g = k / a     a = h o (2 z + h o)
 * </pre>
 *
 * <p>For the spring's mass m the sum of the bodies' inverse masses counts, {@code g = (1/mA + 1/mB)
 * / a}, not the whole inverse effective mass: a corner that can turn away would give way more under
 * the same load, and piles of tilted bodies would sink into each other.
 *
 * <p>Limits: for o to infinity g = 0 and b = 1 / h, a rigid contact that removes s in a substep;
 * for o to 0 no spring. The constants a and b don't contain the mass: a light and a heavy contact
 * relax alike.
 *
 * <p><b>In the contact's frame</b> a visit knows the relative velocity along normal and tangent,
 * and both angular velocities. An impulse p along n changes the first by {@code (1/mA + 1/mB) p},
 * and w by {@code p (r x n) / I}; along the tangent t, n turned left, the lever arm is {@code r x t
 * = r . n}. So bodies are read once and written once per visit, however many points and rows it
 * has.
 *
 * <p><b>Two points</b> are solved together: two such equations with the cross term k12, the speed
 * that an impulse at one point gives the other. With P >= 0 this is a linear complementarity
 * problem of four cases (both push, one, the other, none), of which exactly one fits. A box that
 * falls flat thus lands flat; one point after the other it would tip.
 *
 * <p>The springs of the two points are coupled: g becomes {@code g / (1 + c) [[1, c], [c, 1]]}.
 * With c = 0 these are two springs, with c = 1 a single one in the middle, and the contact is rigid
 * against tipping. Tipping is how a column buckles, while softness along the normal lets the loads
 * of wide piles even out; so most of the softness goes there. Points in one place (or a body that
 * can't turn) would make the matrix singular, hence both diagonal entries are {@value
 * ContactPacker#DIAGONAL_SCALE} times as large.
 *
 * <p><b>Relax.</b> The spring leaves a velocity behind that is only there to remove overlap. After
 * positions moved, the same constraints are solved again rigidly and without bias, so that it is
 * gone and no energy enters.
 *
 * <p><b>Restitution</b> comes first in a substep: impacts are blows between two bodies each, and
 * what they leave parts already when it is pushed. See {@link ContactRestitution}.
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
 * <p><b>Stiffness.</b> The term g P' makes a resting contact yield like the spring it is, by {@code
 * load / (m o^2)}. With uncoupled springs a column of n unit boxes is an elastic rod that buckles
 * under its own weight at about {@code n = 14 (hertz / 30)^(2/3)} (Greenhill's self-buckling;
 * measured: 15 boxes, set down up to 5 cm off the axis, fall at 30 hertz, 20 stand at 54, where
 * wide pyramids keep trembling with hundreds of joules). Coupled, 20 stand at 30 hertz, and the
 * pyramid of 100 rows is at rest.
 *
 * <p>The scheme is Erin Catto's "soft step" (articles and the Solver2D study on box2d.org,
 * 2023-24); soft constraints are from his GDC 2011 talk. Blocks of two points are from his Box2D 2,
 * its solution by cases in Cottle, Pang and Stone, "The Linear Complementarity Problem". Written
 * from the algebra above.
 *
 * <p>{@link ContactBlocks} says in which order contacts are visited and how they lie in memory,
 * {@link ScalarContacts} has the visits.
 */
public final class ContactSolver {
  private static final float TWO_PI = 6.2831855f;

  /** Most frequency of a contact's spring, as a fraction of the substeps per second. */
  private static final float MAX_HERTZ_PER_RATE = 0.25f;

  /** Coupling of the springs of two points: 0 for none, 1 for a single spring in the middle. */
  public static final float COUPLING = 0.75f;

  /**
   * Softness of two points, as a multiple of what their bodies' masses give. Chosen together with
   * {@link #SINGLE_STIFFNESS} and the hertz: the pyramid of 100 rows comes to rest (18 J after 260
   * ticks), and the pile of 2,000 has 13 to 18 overlaps deeper than 2 cm. With the whole inverse
   * effective mass it has 192.
   */
  private static final float PAIR_SOFTNESS = 1.3f;

  /** Stiffness (in o) of a single point, as a multiple of that of two. */
  private static final float SINGLE_STIFFNESS = 1.3f;

  public final ContactBlocks blocks;
  private final ContactPacker packer;
  private final ScalarContacts scalar;
  private final ContactRestitution restitution;

  /** The vector kernels, null without. */
  private final ContactLanes lanes;

  /** Scratch arrays of the kernels, one per worker. */
  private float[][] scratch = new float[0][];

  private final ParallelFor parallel;

  // The stages, made once so that a step allocates nothing.
  private final DomainPhases.Phase warming;
  private final DomainPhases.Phase biasing;
  private final DomainPhases.Phase relaxing;

  private final TreeContacts treeContacts;
  private SolverBodies solverBodies;

  /** {@link SolverBodies#state}. */
  private float[] v;

  /** Length of a substep, s. */
  private float h;

  /** Substeps per second. */
  public float inverseH;

  /** Most speed at which overlap is pushed apart, m/s. */
  public float maxPushSpeed;

  /** Least speed of an impact, m/s. */
  float threshold;

  /** Overlap that isn't pushed apart, m. */
  public float slop;

  /** Bias rate b, 1/s, by the traits {@link ContactBlocks#SOFTNESS}. */
  public final float[] biasRate = new float[4];

  /** Softness g, per inverse mass of the bodies, by the same traits. */
  public final float[] soft = new float[4];

  /**
   * Makes a solver.
   *
   * @param lanes kernels for whole blocks, null for none
   * @param parallel tells how many workers there are
   * @param parts says which parts are discs
   */
  public ContactSolver(ContactLanes lanes, ParallelFor parallel, ShapeTable parts) {
    this.lanes = lanes;
    this.parallel = parallel;
    blocks = new ContactBlocks();
    warming = blocks.phase(this::warmBlocks);
    biasing = blocks.phase(this::biasBlocks);
    relaxing = blocks.phase(this::relaxBlocks);
    scalar = new ScalarContacts(this, blocks);
    treeContacts = new TreeContacts(this, blocks, scalar);
    packer = new ContactPacker(blocks, scalar, lanes, parts);
    restitution = new ContactRestitution(blocks, scalar, parallel);
  }

  /** Returns the number of blocks. */
  public int blocks() {
    return blocks.count();
  }

  /**
   * Collects and colours the touching, not vetoed contacts of the table, and gives active bodies
   * their slots. {@link #pack} follows when the bodies are loaded.
   */
  public void prepare(
      ContactTable contacts,
      BodyStore bodyStore,
      SolverBodies solverBodies,
      JointTrees trees,
      Settings constants,
      float substep) {
    h = substep;
    inverseH = 1 / substep;
    maxPushSpeed = constants.maxPushSpeed();
    slop = constants.slop();
    threshold = constants.restitutionThreshold();
    chooseSoftness(constants);
    if (lanes != null && scratch.length != parallel.count()) {
      scratch = new float[parallel.count()][lanes.scratchSize()];
    }
    blocks.build(contacts, bodyStore, solverBodies, trees, lanes);
    this.solverBodies = solverBodies;
    v = solverBodies.state;
    scalar.begin(solverBodies);
    packer.begin(contacts, bodyStore, solverBodies, constants, substep);
  }

  /**
   * Returns the contacts with bodies of trees, which have their stages among those of joints. The
   * blocks must be packed.
   */
  public TreeContacts ofTrees(ContactTable contacts, TreeResponse response) {
    treeContacts.begin(contacts, response, solverBodies);
    return treeContacts;
  }

  /** Adds the phase that fills the blocks. */
  public void pack(DomainPhases phases) {
    packer.pack(phases);
  }

  /** Sets the softness. Contacts with bodies that can't be moved are twice as stiff (in o). */
  private void chooseSoftness(Settings settings) {
    float omega = TWO_PI * Math.min(settings.contactHertz(), MAX_HERTZ_PER_RATE / h);
    float twiceZeta = 2 * settings.contactDampingRatio();
    for (int kind = 0; kind < soft.length; kind++) {
      float stiff = (kind & FIXED) != 0 ? 2 * omega : omega;
      if ((kind & TWO) == 0) {
        stiff *= SINGLE_STIFFNESS;
      }
      biasRate[kind] = stiff / (twiceZeta + h * stiff);
      float perMass = 1 / (h * stiff * (twiceZeta + h * stiff));
      soft[kind] = (kind & TWO) == 0 ? perMass : PAIR_SOFTNESS * perMass / (1 + COUPLING);
    }
  }

  /**
   * Adds the phases that apply the impulses of the last step. {@link SolverBodies} does it in later
   * substeps.
   */
  public void warmStart(DomainPhases phases) {
    blocks.addColours(phases, warming, false);
  }

  private void warmBlocks(int from, int to, int worker) {
    for (int block = from; block < to; block++) {
      if ((blocks.traits[block] & WIDE) != 0) {
        lanes.warmStart(this, v, scratch[worker], block);
        continue;
      }
      for (int i = 0; i < blocks.used[block]; i++) {
        scalar.warmStart(block, i);
      }
    }
  }

  /** Adds the phases that visit each contact once, with its spring. */
  public void applyBiasedImpulses(DomainPhases phases) {
    blocks.addColours(phases, biasing, false);
  }

  private void biasBlocks(int from, int to, int worker) {
    for (int block = from; block < to; block++) {
      if ((blocks.traits[block] & WIDE) != 0) {
        lanes.applyBiasedImpulses(this, v, scratch[worker], block);
        continue;
      }
      for (int i = 0; i < blocks.used[block]; i++) {
        scalar.applyBiasedImpulses(block, i);
      }
    }
  }

  /** Adds the phases that visit each contact once, rigid. */
  public void relax(DomainPhases phases) {
    blocks.addColours(phases, relaxing, false);
  }

  private void relaxBlocks(int from, int to, int worker) {
    for (int block = from; block < to; block++) {
      if ((blocks.traits[block] & WIDE) != 0) {
        lanes.relax(this, v, scratch[worker], block);
        continue;
      }
      for (int i = 0; i < blocks.used[block]; i++) {
        scalar.relax(block, i);
      }
    }
  }

  /**
   * Returns whether impacts are possible in this step. If any contact of the table might bounce,
   * all phases added so far are run, because packing tells.
   */
  public boolean bounces(DomainPhases phases, boolean mightBounce) {
    if (mightBounce) {
      phases.run();
    }
    return mightBounce && restitution.begin(solverBodies, h, threshold);
  }

  /**
   * Returns whether impacts alone answer a contact in this substep. It depends on nothing but the
   * contact and what its bodies met: others far away mustn't change how it is solved.
   */
  boolean isFree(int block, int i) {
    return restitution.isFree(block, i);
  }

  /**
   * Gives the free contacts of a block the biases that {@link ScalarContacts} gives them.
   *
   * @param block its number
   * @param n holds the biases of the first points, then of the second ones
   * @param at where they begin
   * @param rigid whether they are those of relaxing
   */
  public void freeBiases(int block, float[] n, int at, boolean rigid) {
    boolean two = (blocks.traits[block] & TWO) != 0;
    for (int i = 0; i < blocks.used[block]; i++) {
      if (isFree(block, i)) {
        int lane = block * LANES + i;
        n[at + i] = scalar.freeBias(lane, FIRST, n[at + i], rigid);
        if (two) {
          n[at + LANES + i] = scalar.freeBias(lane, SECOND, n[at + LANES + i], rigid);
        }
      }
    }
  }

  /** Solves the impacts of a substep. No phases may be left to run. */
  public void solveImpacts(DomainPhases phases) {
    restitution.solve(phases);
  }

  /** Adds the phase that hands the impulses back to the table, but for those that overflowed. */
  public void store(DomainPhases phases) {
    packer.store(phases);
  }
}
