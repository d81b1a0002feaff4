package carom.physics.dynamics.solver;

import static carom.physics.dynamics.solver.ContactBlocks.CROSS;
import static carom.physics.dynamics.solver.ContactBlocks.EXTRA;
import static carom.physics.dynamics.solver.ContactBlocks.FIRST;
import static carom.physics.dynamics.solver.ContactBlocks.FIXED;
import static carom.physics.dynamics.solver.ContactBlocks.FRICTION;
import static carom.physics.dynamics.solver.ContactBlocks.GAP;
import static carom.physics.dynamics.solver.ContactBlocks.INERTIA_A;
import static carom.physics.dynamics.solver.ContactBlocks.INERTIA_B;
import static carom.physics.dynamics.solver.ContactBlocks.LANES;
import static carom.physics.dynamics.solver.ContactBlocks.MASS_A;
import static carom.physics.dynamics.solver.ContactBlocks.MASS_B;
import static carom.physics.dynamics.solver.ContactBlocks.MOVING_SURFACE;
import static carom.physics.dynamics.solver.ContactBlocks.NORMAL;
import static carom.physics.dynamics.solver.ContactBlocks.NORMAL_ARM_A;
import static carom.physics.dynamics.solver.ContactBlocks.NORMAL_ARM_B;
import static carom.physics.dynamics.solver.ContactBlocks.NX;
import static carom.physics.dynamics.solver.ContactBlocks.NY;
import static carom.physics.dynamics.solver.ContactBlocks.RECORD;
import static carom.physics.dynamics.solver.ContactBlocks.ROLL;
import static carom.physics.dynamics.solver.ContactBlocks.ROLLING;
import static carom.physics.dynamics.solver.ContactBlocks.ROLLS;
import static carom.physics.dynamics.solver.ContactBlocks.ROLL_MASS;
import static carom.physics.dynamics.solver.ContactBlocks.SECOND;
import static carom.physics.dynamics.solver.ContactBlocks.SLIDE;
import static carom.physics.dynamics.solver.ContactBlocks.SOFTNESS;
import static carom.physics.dynamics.solver.ContactBlocks.SURFACE;
import static carom.physics.dynamics.solver.ContactBlocks.TANGENT;
import static carom.physics.dynamics.solver.ContactBlocks.TANGENT_ARM_A;
import static carom.physics.dynamics.solver.ContactBlocks.TANGENT_ARM_B;
import static carom.physics.dynamics.solver.ContactBlocks.TANGENT_MASS;
import static carom.physics.dynamics.solver.ContactBlocks.TOTAL;
import static carom.physics.dynamics.solver.ContactBlocks.TWO;
import static carom.physics.dynamics.solver.ContactBlocks.WIDE;
import static carom.physics.dynamics.solver.ContactBlocks.YIELD;
import static carom.physics.dynamics.solver.SolverBodies.VX;
import static carom.physics.dynamics.solver.SolverBodies.VY;
import static carom.physics.dynamics.solver.SolverBodies.W;

import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.contact.ContactTable;
import carom.physics.dynamics.parallel.DomainPhases;
import carom.physics.dynamics.parallel.ParallelFor;
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
 * <p>A visit changes v by {@code (P' - P) / m}. With the yield k = 1 / m and {@code q = v + b s - k
 * P} that makes
 *
 * <pre>
 *   (k + g) P' = -q      g = k / a     a = h o (2 z + h o)
 * </pre>
 *
 * <p>For the spring's mass m the sum of the bodies' inverse masses counts, {@code g = (1/mA + 1/mB)
 * / a}, not the whole yield: a corner that can turn away would yield more under the same load, and
 * piles of tilted bodies would sink into each other.
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
 * can't turn) would make the matrix singular, hence both yields are {@value #SHARE} times as large.
 *
 * <p><b>Relax.</b> The spring leaves a velocity behind that is only there to remove overlap. After
 * positions moved, the same constraints are solved again rigidly and without bias, so that it is
 * gone and no energy enters. Restitution comes last, once per step.
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
 * <p>In which order contacts are visited, and how they lie in memory, says {@link ContactBlocks}.
 */
public final class ContactSolver {
  private static final float TWO_PI = 6.2831855f;

  /** A contact's spring is at most this fraction as fast as the substeps. */
  private static final float MAX_HERTZ_PER_RATE = 0.25f;

  /**
   * How far the springs of two points act as one: 0 not at all, 1 as a single spring in the middle.
   */
  public static final float COUPLING = 0.75f;

  /**
   * How much more two points give way than their bodies' masses say, and how much stiffer (in o) a
   * single point is. Chosen together with the hertz: the pyramid of 100 rows comes to rest (18 J
   * after 260 ticks), and the pile of 2,000 has 13 to 18 overlaps deeper than 2 cm; it had 192 when
   * the whole yield counted.
   */
  private static final float PAIR_SOFTNESS = 1.3f;

  private static final float SINGLE_STIFFNESS = 1.3f;

  public final ContactBlocks blocks;
  private final ContactPacker packer;
  private final ContactRestitution bounces;

  /** The vector kernels, null without. */
  private final ContactLanes lanes;

  /** Of each worker. */
  private float[][] scratch = new float[0][];

  private final ParallelFor parallel;

  // The stages, made once so that a step allocates nothing.
  private final DomainPhases.Phase warming;
  private final DomainPhases.Phase pushing;
  private final DomainPhases.Phase relaxing;

  /** {@link SolverBodies#state}. */
  private float[] v;

  /** Constants of the step. */
  private float h;

  public float inverseH;
  public float maxPush;
  public float slop;

  /**
   * Softness by {@link ContactBlocks#SOFTNESS}: bias rate; what a spring adds to the yield, by
   * inverse mass.
   */
  public final float[] biasRate = new float[4];

  public final float[] soft = new float[4];

  /**
   * Makes a solver.
   *
   * @param lanes kernels for whole blocks, null for none
   * @param parallel does colours
   */
  public ContactSolver(ContactLanes lanes, ParallelFor parallel) {
    this.lanes = lanes;
    this.parallel = parallel;
    blocks = new ContactBlocks();
    warming = blocks.phase(this::warmBlocks);
    pushing = blocks.phase(this::pushBlocks);
    relaxing = blocks.phase(this::relaxBlocks);
    packer = new ContactPacker(blocks, lanes);
    bounces = new ContactRestitution(blocks);
  }

  /** The number of blocks. */
  public int blocks() {
    return blocks.count();
  }

  /**
   * Collects and colours the touching, not vetoed contacts of the table, and gives active bodies
   * their slots. To be packed when the bodies are loaded.
   */
  public void prepare(
      ContactTable contacts,
      BodyStore bodyStore,
      SolverBodies solverBodies,
      Settings constants,
      float substep) {
    h = substep;
    inverseH = 1 / substep;
    maxPush = constants.maxPushSpeed();
    slop = constants.slop();
    soften(constants);
    if (lanes != null && scratch.length != parallel.count()) {
      scratch = new float[parallel.count()][lanes.scratchSize()];
    }
    blocks.lay(contacts, bodyStore, solverBodies, lanes);
    v = solverBodies.state;
    packer.begin(contacts, bodyStore, solverBodies, constants, substep);
  }

  /** Adds: what contacts are is written into the blocks. */
  public void pack(DomainPhases phases) {
    packer.pack(phases);
  }

  /** Contacts with what can't be moved are twice as stiff (in o). */
  private void soften(Settings settings) {
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
   * Adds: the impulses remembered from the last step are applied; see {@link SolverBodies} for what
   * happens in later substeps.
   */
  public void warmStart(DomainPhases phases) {
    blocks.addColours(phases, warming);
  }

  private void warmBlocks(int from, int to, int worker) {
    for (int block = from; block < to; block++) {
      if ((blocks.traits[block] & WIDE) != 0) {
        lanes.warm(this, v, scratch[worker], block);
        continue;
      }
      for (int i = 0; i < blocks.used[block]; i++) {
        warm(block, i);
      }
    }
  }

  private void warm(int block, int i) {
    float[] d = blocks.data;
    int lane = block * LANES + i;
    int at = block * RECORD + i;
    int p = at + FIRST;
    float normal = d[p + NORMAL];
    float tangent = d[p + TANGENT];
    float turnA = d[p + NORMAL_ARM_A] * normal + d[p + TANGENT_ARM_A] * tangent;
    float turnB = d[p + NORMAL_ARM_B] * normal + d[p + TANGENT_ARM_B] * tangent;
    if ((blocks.traits[block] & TWO) != 0) {
      int q = at + SECOND;
      float normal2 = d[q + NORMAL];
      float tangent2 = d[q + TANGENT];
      turnA += d[q + NORMAL_ARM_A] * normal2 + d[q + TANGENT_ARM_A] * tangent2;
      turnB += d[q + NORMAL_ARM_B] * normal2 + d[q + TANGENT_ARM_B] * tangent2;
      normal += normal2;
      tangent += tangent2;
    }
    if ((blocks.traits[block] & ROLLS) != 0) {
      float roll = blocks.extra[block * EXTRA + i + ROLL];
      turnA += roll;
      turnB += roll;
    }
    float wa = v[blocks.bodyA[lane] + W] - d[at + INERTIA_A] * turnA;
    float wb = v[blocks.bodyB[lane] + W] + d[at + INERTIA_B] * turnB;
    blocks.give(lane, at, normal, tangent, wa, wb);
  }

  /** Adds one visit of each contact, with its spring. */
  public void push(DomainPhases phases) {
    blocks.addColours(phases, pushing);
  }

  private void pushBlocks(int from, int to, int worker) {
    for (int block = from; block < to; block++) {
      if ((blocks.traits[block] & WIDE) != 0) {
        lanes.push(this, v, scratch[worker], block);
        continue;
      }
      for (int i = 0; i < blocks.used[block]; i++) {
        push(block, i);
      }
    }
  }

  /** Adds one visit of each contact, rigid. */
  public void relax(DomainPhases phases) {
    blocks.addColours(phases, relaxing);
  }

  private void relaxBlocks(int from, int to, int worker) {
    for (int block = from; block < to; block++) {
      if ((blocks.traits[block] & WIDE) != 0) {
        lanes.relax(this, v, scratch[worker], block);
        continue;
      }
      for (int i = 0; i < blocks.used[block]; i++) {
        relax(block, i);
      }
    }
  }

  /** Friction, then the normals with their springs; the gaps are those of the last relaxing. */
  private void push(int block, int i) {
    float[] d = blocks.data;
    int lane = block * LANES + i;
    int at = block * RECORD + i;
    int a = blocks.bodyA[lane];
    int b = blocks.bodyB[lane];
    float nx = d[at + NX];
    float ny = d[at + NY];
    float dvx = v[b + VX] - v[a + VX];
    float dvy = v[b + VY] - v[a + VY];
    float speed = dvx * nx + dvy * ny;
    float slip = dvy * nx - dvx * ny;
    float wa = v[a + W];
    float wb = v[b + W];
    float masses = d[at + MASS_A] + d[at + MASS_B];
    float inertiaA = d[at + INERTIA_A];
    float inertiaB = d[at + INERTIA_B];
    int trait = blocks.traits[block];
    if ((trait & MOVING_SURFACE) != 0) {
      slip += blocks.extra[block * EXTRA + i + SURFACE];
    }
    if ((trait & ROLLS) != 0) {
      float turn = roll(block, i, wb - wa);
      wa -= inertiaA * turn;
      wb += inertiaB * turn;
    }
    int p = at + FIRST;
    float rubbed = rub(at, p, slip, wa, wb);
    slip += masses * rubbed;
    wa -= inertiaA * (d[p + TANGENT_ARM_A] * rubbed);
    wb += inertiaB * (d[p + TANGENT_ARM_B] * rubbed);
    float tangent = 0 + rubbed; // -0 becomes 0, as in lanes
    float gap = d[p + GAP];
    float softness = soft[trait & SOFTNESS] * masses;
    float rate = biasRate[trait & SOFTNESS];
    float old = d[p + NORMAL];
    float normal;
    if ((trait & TWO) == 0) {
      normal = press(p, speed, wa, wb, urge(gap, rate), gap > 0 ? 0 : softness) - old;
      wa -= inertiaA * (d[p + NORMAL_ARM_A] * normal);
      wb += inertiaB * (d[p + NORMAL_ARM_B] * normal);
    } else {
      int q = at + SECOND;
      rubbed = rub(at, q, slip, wa, wb);
      wa -= inertiaA * (d[q + TANGENT_ARM_A] * rubbed);
      wb += inertiaB * (d[q + TANGENT_ARM_B] * rubbed);
      tangent += rubbed;
      float gap2 = d[q + GAP];
      float soft1 = gap > 0 ? 0 : softness;
      float soft2 = gap2 > 0 ? 0 : softness;
      float softCross = gap > 0 || gap2 > 0 ? 0 : softness * COUPLING;
      float old2 = d[q + NORMAL];
      pressBoth(at, speed, wa, wb, urge(gap, rate), urge(gap2, rate), soft1, soft2, softCross);
      normal = d[p + NORMAL] - old;
      float normal2 = d[q + NORMAL] - old2;
      wa -= inertiaA * (d[p + NORMAL_ARM_A] * normal + d[q + NORMAL_ARM_A] * normal2);
      wb += inertiaB * (d[p + NORMAL_ARM_B] * normal + d[q + NORMAL_ARM_B] * normal2);
      normal += normal2;
    }
    blocks.give(lane, at, normal, tangent, wa, wb);
  }

  /** The normals as a rigid contact, after the bodies have moved; then friction. */
  private void relax(int block, int i) {
    float[] d = blocks.data;
    int lane = block * LANES + i;
    int at = block * RECORD + i;
    int a = blocks.bodyA[lane];
    int b = blocks.bodyB[lane];
    float nx = d[at + NX];
    float ny = d[at + NY];
    float dvx = v[b + VX] - v[a + VX];
    float dvy = v[b + VY] - v[a + VY];
    float speed = dvx * nx + dvy * ny;
    float slip = dvy * nx - dvx * ny;
    float wa = v[a + W];
    float wb = v[b + W];
    float masses = d[at + MASS_A] + d[at + MASS_B];
    float inertiaA = d[at + INERTIA_A];
    float inertiaB = d[at + INERTIA_B];
    int trait = blocks.traits[block];
    if ((trait & MOVING_SURFACE) != 0) {
      slip += blocks.extra[block * EXTRA + i + SURFACE];
    }
    float moved = blocks.moved(block, i);
    int p = at + FIRST;
    int q = at + SECOND;
    float gap = blocks.gap(p, moved, a, b);
    d[p + GAP] = gap;
    float old = d[p + NORMAL];
    float normal;
    if ((trait & TWO) == 0) {
      normal = press(p, speed, wa, wb, gap > 0 ? gap * inverseH : 0, 0) - old;
      wa -= inertiaA * (d[p + NORMAL_ARM_A] * normal);
      wb += inertiaB * (d[p + NORMAL_ARM_B] * normal);
    } else {
      float gap2 = blocks.gap(q, moved, a, b);
      d[q + GAP] = gap2;
      float old2 = d[q + NORMAL];
      float urge = gap > 0 ? gap * inverseH : 0;
      float urge2 = gap2 > 0 ? gap2 * inverseH : 0;
      pressBoth(at, speed, wa, wb, urge, urge2, 0, 0, 0);
      normal = d[p + NORMAL] - old;
      float normal2 = d[q + NORMAL] - old2;
      wa -= inertiaA * (d[p + NORMAL_ARM_A] * normal + d[q + NORMAL_ARM_A] * normal2);
      wb += inertiaB * (d[p + NORMAL_ARM_B] * normal + d[q + NORMAL_ARM_B] * normal2);
      normal += normal2;
    }
    float rubbed = rub(at, p, slip, wa, wb);
    slip += masses * rubbed;
    wa -= inertiaA * (d[p + TANGENT_ARM_A] * rubbed);
    wb += inertiaB * (d[p + TANGENT_ARM_B] * rubbed);
    float tangent = 0 + rubbed; // -0 becomes 0, as in lanes
    if ((trait & TWO) != 0) {
      rubbed = rub(at, q, slip, wa, wb);
      wa -= inertiaA * (d[q + TANGENT_ARM_A] * rubbed);
      wb += inertiaB * (d[q + TANGENT_ARM_B] * rubbed);
      tangent += rubbed;
      addUp(q);
    }
    if ((trait & ROLLS) != 0) {
      float turn = roll(block, i, wb - wa);
      wa -= inertiaA * turn;
      wb += inertiaB * turn;
    }
    addUp(p);
    blocks.give(lane, at, normal, tangent, wa, wb);
  }

  private void addUp(int p) {
    blocks.data[p + TOTAL] += blocks.data[p + NORMAL];
    blocks.data[p + SLIDE] += blocks.data[p + TANGENT];
  }

  /** Friction at a point; answers the change of its impulse. */
  private float rub(int at, int p, float slip, float wa, float wb) {
    float[] d = blocks.data;
    float limit = d[at + FRICTION] * d[p + NORMAL];
    float old = d[p + TANGENT];
    float sum =
        old
            - d[p + TANGENT_MASS]
                * (slip + (wb * d[p + TANGENT_ARM_B] - wa * d[p + TANGENT_ARM_A]));
    sum = sum < limit ? sum : limit;
    sum = sum > -limit ? sum : -limit;
    d[p + TANGENT] = sum;
    return sum - old;
  }

  /** Rolling resistance; answers the change of its impulse. */
  private float roll(int block, int i, float w) {
    int at = block * RECORD + i;
    int more = block * EXTRA + i;
    float load = blocks.data[at + FIRST + NORMAL];
    if ((blocks.traits[block] & TWO) != 0) {
      load += blocks.data[at + SECOND + NORMAL];
    }
    float limit = blocks.extra[more + ROLLING] * load;
    float old = blocks.extra[more + ROLL];
    float sum = Math.max(-limit, Math.min(old - blocks.extra[more + ROLL_MASS] * w, limit));
    blocks.extra[more + ROLL] = sum;
    return sum - old;
  }

  /** Speed by which a gap may close, or at which overlap is pushed apart (negative), m/s. */
  private float urge(float gap, float rate) {
    if (gap > 0) {
      return gap * inverseH;
    }
    float overlap = gap + slop;
    float apart = rate * (overlap < 0 ? overlap : 0);
    return apart > -maxPush ? apart : -maxPush;
  }

  /** Solves the one point; answers its impulse. */
  private float press(int p, float speed, float wa, float wb, float urge, float soft) {
    float[] d = blocks.data;
    float old = d[p + NORMAL];
    float yield = d[p + YIELD];
    float q = speed + (wb * d[p + NORMAL_ARM_B] - wa * d[p + NORMAL_ARM_A]) + urge - yield * old;
    float sum = q < 0 ? -q / (yield + soft) : 0;
    d[p + NORMAL] = sum;
    return sum;
  }

  /** Solves both points together. */
  private void pressBoth(
      int at,
      float speed,
      float wa,
      float wb,
      float urge1,
      float urge2,
      float soft1,
      float soft2,
      float softCross) {
    float[] d = blocks.data;
    int p = at + FIRST;
    int q = at + SECOND;
    float old1 = d[p + NORMAL];
    float old2 = d[q + NORMAL];
    float k1 = d[p + YIELD];
    float k2 = d[q + YIELD];
    float k = d[at + CROSS];
    float speed1 = speed + (wb * d[p + NORMAL_ARM_B] - wa * d[p + NORMAL_ARM_A]);
    float speed2 = speed + (wb * d[q + NORMAL_ARM_B] - wa * d[q + NORMAL_ARM_A]);
    float q1 = speed1 + urge1 - k1 * old1 - k * old2;
    float q2 = speed2 + urge2 - k2 * old2 - k * old1;
    k1 += soft1;
    k2 += soft2;
    k += softCross;
    float scale = 1 / (k1 * k2 - k * k);
    float sum1 = (k * q2 - k2 * q1) * scale;
    float sum2 = (k * q1 - k1 * q2) * scale;
    if (!(sum1 >= 0) || !(sum2 >= 0)) {
      sum1 = q1 < 0 ? -q1 / k1 : 0;
      sum2 = 0;
      if (q2 + k * sum1 < 0) {
        sum1 = 0;
        sum2 = q2 < 0 ? -q2 / k2 : 0;
      }
    }
    d[p + NORMAL] = sum1;
    d[q + NORMAL] = sum2;
  }

  /** Adds: contacts bounce that came together fast; see {@link ContactRestitution}. */
  public void restitution(DomainPhases phases) {
    bounces.solve(phases, h);
  }

  /** Adds: the impulses are handed back to the table, but for those that overflowed. */
  public void store(DomainPhases phases) {
    packer.store(phases);
  }
}
