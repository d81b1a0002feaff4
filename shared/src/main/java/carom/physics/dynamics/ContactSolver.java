package carom.physics.dynamics;

import static carom.physics.dynamics.SolverBodies.COS;
import static carom.physics.dynamics.SolverBodies.DX;
import static carom.physics.dynamics.SolverBodies.DY;
import static carom.physics.dynamics.SolverBodies.SIN;
import static carom.physics.dynamics.SolverBodies.STRIDE;
import static carom.physics.dynamics.SolverBodies.VX;
import static carom.physics.dynamics.SolverBodies.VY;
import static carom.physics.dynamics.SolverBodies.W;

import java.util.Arrays;

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
 * <p><b>Colours.</b> Sequential impulses need an order. Contacts are given colours, greedily in the
 * order of their keys: the first colour that neither body has yet. Contacts of one colour share no
 * body that can be moved, so the order within a colour changes no bit of the result, and they can
 * be solved in lanes, or by several threads. Contacts between bodies that move come first and those
 * with the static world last, which thus has the last word: what rests on the ground doesn't sink
 * into it. A body with more than {@value #LAST_COLOUR} contacts spills into a last colour that is
 * solved one by one. The colouring depends on the touching contacts of this step alone and costs a
 * few ns per contact, so there is no history to save or to hash.
 *
 * <p><b>Layout.</b> Contacts are packed in blocks of {@value #LANES}, a colour beginning a new
 * block. Each quantity of a block lies side by side for all its contacts; all quantities of a block
 * follow each other ({@code data[block * RECORD + quantity + lane]}). So a pass is one stream
 * through memory, and a block's quantity is one vector register.
 */
final class ContactSolver {
  /** Contacts in a block. */
  static final int LANES = 8;

  private static final float TWO_PI = 6.2831855f;

  /** A closed gas loses 2.5 % of its energy in 300 steps with one round, 0.2 % with four. */
  private static final int BOUNCE_ROUNDS = 4;

  /** A contact's spring is at most this fraction as fast as the substeps. */
  private static final float MAX_HERTZ_PER_RATE = 0.25f;

  /**
   * How far the springs of two points act as one: 0 not at all, 1 as a single spring in the middle.
   */
  static final float COUPLING = 0.75f;

  /**
   * How much more two points give way than their bodies' masses say, and how much stiffer (in o) a
   * single point is. Chosen together with the hertz: the pyramid of 100 rows comes to rest (18 J
   * after 260 ticks), and the pile of 2,000 has 13 to 18 overlaps deeper than 2 cm; it had 192 when
   * the whole yield counted.
   */
  private static final float PAIR_SOFTNESS = 1.3f;

  private static final float SINGLE_STIFFNESS = 1.3f;

  /** Two points yield that much more, so that points in one place share the load. */
  private static final float SHARE = 1 + 1 / 1024f;

  /** The last colour among moving bodies, and with static ones; it takes what found no other. */
  private static final int LAST_COLOUR = 63;

  /** Blocks with fewer contacts are solved one by one. */
  private static final int FEWEST = 3;

  /** Steps with fewer blocks don't use vectors. */
  private static final int FEWEST_BLOCKS = 64;

  /** Blocks that are worth a piece of work for a worker: to solve, and to pack or store. */
  private static final int SOLVE_AT_LEAST = 16;

  private static final int PACK_AT_LEAST = 16;

  /** Every colour has a group of contacts with one point, and one of those with two. */
  private static final int GROUPS = 2 * 2 * (LAST_COLOUR + 1);

  // Offsets of the quantities of a block in data: of the contact,
  static final int NX = 0;
  static final int NY = NX + LANES;
  static final int FRICTION = NY + LANES;
  static final int MASS_A = FRICTION + LANES;
  static final int MASS_B = MASS_A + LANES;
  static final int INERTIA_A = MASS_B + LANES;
  static final int INERTIA_B = INERTIA_A + LANES;

  /** What an impulse at one point does to the other's speed along the normal, 1/kg. */
  static final int CROSS = INERTIA_B + LANES;

  // of each of its two points, relative to FIRST or SECOND: lever arms of impulses along the
  // normal, r x n, and along the tangent, r x t = r . n, of both bodies, m,
  static final int NORMAL_ARM_A = 0;
  static final int NORMAL_ARM_B = NORMAL_ARM_A + LANES;
  static final int TANGENT_ARM_A = NORMAL_ARM_B + LANES;
  static final int TANGENT_ARM_B = TANGENT_ARM_A + LANES;

  /** gap when the step began, and now, m, */
  static final int SEPARATION = TANGENT_ARM_B + LANES;

  static final int GAP = SEPARATION + LANES;

  /** what an impulse does to the point's speed along the normal, 1/kg, */
  static final int YIELD = GAP + LANES;

  /** its inverse along the tangent, kg, */
  static final int TANGENT_MASS = YIELD + LANES;

  /** impulses along normal and tangent, of the substep and of the whole step. */
  static final int NORMAL = TANGENT_MASS + LANES;

  static final int TANGENT = NORMAL + LANES;
  static final int TOTAL = TANGENT + LANES;
  static final int SLIDE = TOTAL + LANES;
  static final int POINT = SLIDE + LANES;

  static final int FIRST = CROSS + LANES;
  static final int SECOND = FIRST + POINT;
  static final int RECORD = SECOND + POINT;

  // What few contacts need, relative to the block in extra; each part is only valid if the block
  // has the trait. Speed of moving surfaces, m/s:
  static final int SURFACE = 0;

  /** Radii of the parts' rounding, m. */
  static final int ROUND_A = SURFACE + LANES;

  static final int ROUND_B = ROUND_A + LANES;
  private static final int ROLLING = ROUND_B + LANES;
  private static final int ROLL_MASS = ROLLING + LANES;
  private static final int ROLL = ROLL_MASS + LANES;

  /** Acceleration with which gravity and forces press the bodies together, m/s^2. */
  private static final int PULL = ROLL + LANES;

  /** Approach speed of each point to answer with a bounce, m/s, 0 if there is none to answer. */
  private static final int BOUNCE_FIRST = PULL + LANES;

  private static final int BOUNCE_SECOND = BOUNCE_FIRST + LANES;

  /** How much further the bounce's impulse along the normal, and that of its friction, are. */
  private static final int BOUNCED = 2 * LANES;

  private static final int RUBBED = BOUNCED + 2 * LANES;
  static final int EXTRA = BOUNCE_FIRST + RUBBED + 2 * LANES;

  // Traits of blocks.
  /** Its contacts have two points. */
  static final int TWO = 1;

  /** They are with bodies that can't be moved: several touch the same, none writes to it. */
  static final int FIXED = 2;

  /** Some contact has a moving surface, a round part, rolling resistance, a bounce to come. */
  static final int MOVING_SURFACE = 4;

  static final int ROUND = 8;
  private static final int ROLLS = 16;
  private static final int BOUNCES = 32;

  /** Solved by vectors. */
  private static final int WIDE = 64;

  /** The traits that softness depends on. */
  private static final int SOFTNESS = TWO | FIXED;

  /** Number of contacts, and of blocks. */
  private int count;

  private int blocks;

  /** The touching rows and their groups, in the order of the keys. */
  private int[] touching = new int[0];

  private int[] group = new int[0];

  /** Colours each slot of {@link SolverBodies} has, among moving bodies and with static ones. */
  private long[] taken = new long[0];

  private long[] takenFixed = new long[0];

  /** Per group: its contacts; then, while they are packed, its next lane. */
  private final int[] next = new int[GROUPS];

  /** Per block: contacts in it, and its traits. */
  private byte[] used = new byte[0];

  byte[] traits = new byte[0];

  /** Per lane: row of the contact table; offsets of the two bodies in the solver's state. */
  private int[] row = new int[0];

  int[] bodyA = new int[0];
  int[] bodyB = new int[0];

  float[] data = new float[0];
  float[] extra = new float[0];

  /** The vector kernels, null without. */
  private final ContactLanes lanes;

  /** Of each worker. */
  private float[][] scratch = new float[0][];

  /** First block of each colour. */
  private final int[] colourStart = new int[2 * (LAST_COLOUR + 1) + 1];

  private final Crew crew;

  // The stages, made once so that a step allocates nothing.
  private final Crew.Range packing = (from, to, worker) -> packBlocks(from, to);
  private final Crew.Range warming = (from, to, worker) -> warmBlocks(from, to);
  private final Crew.Range pushing = this::pushBlocks;
  private final Crew.Range relaxing = this::relaxBlocks;
  private final Crew.Range bouncing = (from, to, worker) -> bounceBlocks(from, to);
  private final Crew.Range bounceEnding = (from, to, worker) -> endBounces(from, to);
  private final Crew.Range storing = (from, to, worker) -> store(from, to);

  // What the step is about.
  private ContactTable table;
  private BodyStore store;
  private SolverBodies bodies;
  private int[] activeIndex;
  private Settings settings;

  /** {@link SolverBodies#state}. */
  private float[] v;

  /** Constants of the step. */
  private float h;

  float inverseH;
  float maxPush;
  float slop;

  /** Softness by {@link #SOFTNESS}: bias rate; what a spring adds to the yield, by inverse mass. */
  final float[] biasRate = new float[4];

  final float[] soft = new float[4];

  /**
   * Makes a solver.
   *
   * @param lanes kernels for whole blocks, null for none
   * @param crew does colours
   */
  ContactSolver(ContactLanes lanes, Crew crew) {
    this.lanes = lanes;
    this.crew = crew;
  }

  int blocks() {
    return blocks;
  }

  /** Collects, colours and packs the touching, not vetoed contacts of the table. */
  void prepare(
      ContactTable contacts,
      BodyStore bodyStore,
      SolverBodies solverBodies,
      int[] activeIndices,
      Settings constants,
      float substep) {
    table = contacts;
    store = bodyStore;
    bodies = solverBodies;
    activeIndex = activeIndices;
    settings = constants;
    v = solverBodies.state;
    h = substep;
    inverseH = 1 / substep;
    maxPush = constants.maxPushSpeed();
    slop = constants.slop();
    soften();
    if (lanes != null && scratch.length != crew.count()) {
      scratch = new float[crew.count()][lanes.scratchSize()];
    }
    paint(solverBodies.count());
    layOut();
    for (int k = 0; k < count; k++) {
      row[next[group[k]]++] = touching[k];
    }
    crew.run(0, blocks, PACK_AT_LEAST, packing);
  }

  /** Contacts with what can't be moved are twice as stiff (in o). */
  private void soften() {
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

  /** Finds the contacts to solve and gives each its colour. */
  private void paint(int slots) {
    ContactTable t = table;
    BodyStore b = store;
    if (touching.length < t.count()) {
      int capacity = Math.max(t.count(), touching.length * 2);
      touching = new int[capacity];
      group = new int[capacity];
    }
    if (taken.length < slots) {
      int capacity = Math.max(slots, taken.length * 2);
      taken = new long[capacity];
      takenFixed = new long[capacity];
    }
    Arrays.fill(taken, 0, slots, 0);
    Arrays.fill(takenFixed, 0, slots, 0);
    Arrays.fill(next, 0);
    count = 0;
    for (int r = 0; r < t.count(); r++) {
      if (t.points[r] == 0 || (t.flags[r] & ContactTable.DORMANT) != 0) {
        continue;
      }
      if ((t.flags[r] & ContactTable.VETOED) != 0) {
        t.forget(r);
        continue;
      }
      int a = ContactKey.bodyA(t.key[r]);
      int o = ContactKey.bodyB(t.key[r]);
      int c;
      if (b.invMass[a] == 0) {
        c = LAST_COLOUR + 1 + paint(takenFixed, activeIndex[o] + 1);
      } else if (b.invMass[o] == 0) {
        c = LAST_COLOUR + 1 + paint(takenFixed, activeIndex[a] + 1);
      } else {
        int slotA = activeIndex[a] + 1;
        int slotB = activeIndex[o] + 1;
        c = Math.min(Long.numberOfTrailingZeros(~(taken[slotA] | taken[slotB])), LAST_COLOUR);
        long bit = 1L << c;
        taken[slotA] |= bit;
        taken[slotB] |= bit;
      }
      group[count] = 2 * c + t.points[r] - 1;
      next[group[count]]++;
      touching[count++] = r;
    }
  }

  private static int paint(long[] masks, int slot) {
    int c = Math.min(Long.numberOfTrailingZeros(~masks[slot]), LAST_COLOUR);
    masks[slot] |= 1L << c;
    return c;
  }

  /** Gives each group its blocks. */
  private void layOut() {
    blocks = 0;
    for (int g = 0; g < GROUPS; g++) {
      blocks += (next[g] + LANES - 1) / LANES;
    }
    if (used.length < blocks) {
      int capacity = Math.max(blocks, used.length * 2);
      used = new byte[capacity];
      traits = new byte[capacity];
      row = new int[capacity * LANES];
      bodyA = new int[capacity * LANES];
      bodyB = new int[capacity * LANES];
      data = new float[capacity * RECORD];
      extra = new float[capacity * EXTRA];
    }
    int widest = lanes == null || blocks < FEWEST_BLOCKS ? 0 : lanes.trusted(blocks);
    int block = 0;
    for (int g = 0; g < GROUPS; g++) {
      int colour = g >> 1;
      if ((g & 1) == 0) {
        colourStart[colour] = block;
      }
      int kind = ((g & 1) != 0 ? TWO : 0) | (colour > LAST_COLOUR ? FIXED : 0);
      int left = next[g];
      next[g] = block * LANES;
      for (; left > 0; left -= LANES) {
        used[block] = (byte) Math.min(left, LANES);
        boolean wide = block < widest && left >= FEWEST && (colour & LAST_COLOUR) != LAST_COLOUR;
        traits[block] = (byte) (kind | (wide ? WIDE : 0));
        if (left < LANES) {
          clear(block);
        }
        block++;
      }
    }
    colourStart[GROUPS >> 1] = blocks;
  }

  /** Makes the empty lanes of a block contacts of nothing with nothing. */
  private void clear(int block) {
    int at = block * RECORD;
    Arrays.fill(data, at, at + RECORD, 0);
    Arrays.fill(data, at + FIRST + YIELD, at + FIRST + YIELD + LANES, 1);
    Arrays.fill(data, at + SECOND + YIELD, at + SECOND + YIELD + LANES, 1);
    Arrays.fill(bodyA, block * LANES, (block + 1) * LANES, 0);
    Arrays.fill(bodyB, block * LANES, (block + 1) * LANES, 0);
  }

  /** Does a stage colour by colour; what found no colour is done by the caller alone. */
  private void byColours(Crew.Range stage) {
    if (crew.count() == 1) {
      stage.run(0, blocks, 0);
      return;
    }
    for (int c = 0; c < GROUPS >> 1; c++) {
      int least = (c & LAST_COLOUR) == LAST_COLOUR ? Integer.MAX_VALUE : SOLVE_AT_LEAST;
      crew.run(colourStart[c], colourStart[c + 1], least, stage);
    }
  }

  private void packBlocks(int from, int to) {
    for (int block = from; block < to; block++) {
      for (int i = 0; i < used[block]; i++) {
        pack(block, i);
      }
    }
  }

  private void pack(int block, int i) {
    ContactTable t = table;
    BodyStore b = store;
    float[] d = data;
    int lane = block * LANES + i;
    int at = block * RECORD + i;
    int r = row[lane];
    int a = ContactKey.bodyA(t.key[r]);
    int o = ContactKey.bodyB(t.key[r]);
    bodyA[lane] = (activeIndex[a] + 1) * STRIDE;
    bodyB[lane] = (activeIndex[o] + 1) * STRIDE;
    float nx = t.nx[r];
    float ny = t.ny[r];
    d[at + NX] = nx;
    d[at + NY] = ny;
    d[at + FRICTION] = t.friction[r];
    d[at + MASS_A] = b.invMass[a];
    d[at + MASS_B] = b.invMass[o];
    d[at + INERTIA_A] = b.invInertia[a];
    d[at + INERTIA_B] = b.invInertia[o];
    float gapX = b.x[o] - b.x[a];
    float gapY = b.y[o] - b.y[a];
    packPoint(at, FIRST, t.x0[r], t.y0[r], gapX, gapY, t.separation0[r]);
    d[at + FIRST + NORMAL] = t.normal0[r];
    d[at + FIRST + TANGENT] = t.tangent0[r];
    if ((traits[block] & TWO) != 0) {
      packPoint(at, SECOND, t.x1[r], t.y1[r], gapX, gapY, t.separation1[r]);
      d[at + SECOND + NORMAL] = t.normal1[r];
      d[at + SECOND + TANGENT] = t.tangent1[r];
      d[at + CROSS] = cross(at);
      d[at + FIRST + YIELD] *= SHARE;
      d[at + SECOND + YIELD] *= SHARE;
    }
    if (t.surface[r] != 0) {
      has(block, MOVING_SURFACE, SURFACE, ROUND_A);
      extra[block * EXTRA + i + SURFACE] = t.surface[r];
    }
    if (t.roundA[r] != 0 || t.roundB[r] != 0) {
      has(block, ROUND, ROUND_A, ROLLING);
      extra[block * EXTRA + i + ROUND_A] = t.roundA[r];
      extra[block * EXTRA + i + ROUND_B] = t.roundB[r];
    }
    if (t.rolling[r] > 0) {
      has(block, ROLLS, ROLLING, PULL);
      float turning = b.invInertia[a] + b.invInertia[o];
      extra[block * EXTRA + i + ROLLING] = t.rolling[r];
      extra[block * EXTRA + i + ROLL_MASS] = turning > 0 ? 1 / turning : 0;
      extra[block * EXTRA + i + ROLL] = t.roll[r];
      traits[block] &= ~WIDE;
    }
    if (t.restitution[r] > 0) {
      packBounce(block, i, t.restitution[r]);
    }
  }

  /** Gives a block a trait; its part of extra is zero for those lanes that don't have it. */
  private void has(int block, int trait, int from, int to) {
    if ((traits[block] & trait) == 0) {
      traits[block] |= (byte) trait;
      Arrays.fill(extra, block * EXTRA + from, block * EXTRA + to, 0);
    }
  }

  private void packPoint(
      int at, int point, float x, float y, float gapX, float gapY, float separation) {
    float[] d = data;
    int p = at + point;
    float bx = x - gapX;
    float by = y - gapY;
    float nx = d[at + NX];
    float ny = d[at + NY];
    float masses = d[at + MASS_A] + d[at + MASS_B];
    float inertiaA = d[at + INERTIA_A];
    float inertiaB = d[at + INERTIA_B];
    float normalA = x * ny - y * nx;
    float normalB = bx * ny - by * nx;
    float tangentA = x * nx + y * ny;
    float tangentB = bx * nx + by * ny;
    float kt = masses + inertiaA * tangentA * tangentA + inertiaB * tangentB * tangentB;
    d[p + NORMAL_ARM_A] = normalA;
    d[p + NORMAL_ARM_B] = normalB;
    d[p + TANGENT_ARM_A] = tangentA;
    d[p + TANGENT_ARM_B] = tangentB;
    d[p + SEPARATION] = separation;
    d[p + GAP] = separation;
    d[p + YIELD] = masses + inertiaA * normalA * normalA + inertiaB * normalB * normalB;
    d[p + TANGENT_MASS] = kt > 0 ? 1 / kt : 0;
    d[p + TOTAL] = 0;
    d[p + SLIDE] = 0;
  }

  private float cross(int at) {
    float[] d = data;
    int p = at + FIRST;
    int q = at + SECOND;
    float turnA = d[p + NORMAL_ARM_A] * d[q + NORMAL_ARM_A];
    float turnB = d[p + NORMAL_ARM_B] * d[q + NORMAL_ARM_B];
    float masses = d[at + MASS_A] + d[at + MASS_B];
    return masses + d[at + INERTIA_A] * turnA + d[at + INERTIA_B] * turnB;
  }

  private void packBounce(int block, int i, float restitution) {
    int at = block * RECORD + i;
    int lane = block * LANES + i;
    int slotA = bodyA[lane] / STRIDE;
    int slotB = bodyB[lane] / STRIDE;
    float pull =
        (bodies.ax(slotA) - bodies.ax(slotB)) * data[at + NX]
            + (bodies.ay(slotA) - bodies.ay(slotB)) * data[at + NY];
    float first = restitution * approach(lane, FIRST, pull);
    float second = (traits[block] & TWO) == 0 ? 0 : restitution * approach(lane, SECOND, pull);
    if (first != 0 || second != 0) {
      has(block, BOUNCES, PULL, EXTRA);
      extra[block * EXTRA + i + PULL] = pull;
      extra[block * EXTRA + i + BOUNCE_FIRST] = first;
      extra[block * EXTRA + i + BOUNCE_SECOND] = second;
    }
  }

  /**
   * Speed with which the surfaces will meet at a point, m/s: that of now, plus what the relative
   * acceleration a adds over the gap, v^2 = v0^2 + 2 a s; 0 below the threshold. In symplectic
   * Euler a velocity is that of half a substep ago, hence a h / 2 is added here and again after the
   * bounce. Without these terms a perfectly elastic ball would lose 2 % of its height with every
   * bounce.
   */
  private float approach(int lane, int point, float pull) {
    int at = lane / LANES * RECORD + lane % LANES;
    float closing = 0.5f * h * pull - normalSpeed(lane, point);
    if (!(closing > settings.restitutionThreshold())) {
      return 0;
    }
    float square = closing * closing + 2 * pull * data[at + point + SEPARATION];
    return square > 0 ? (float) Math.sqrt(square) : 0;
  }

  private float normalSpeed(int lane, int point) {
    float[] d = data;
    int at = lane / LANES * RECORD + lane % LANES;
    int a = bodyA[lane];
    int b = bodyB[lane];
    float dvx = v[b + VX] - v[a + VX];
    float dvy = v[b + VY] - v[a + VY];
    float linear = dvx * d[at + NX] + dvy * d[at + NY];
    float armA = d[at + point + NORMAL_ARM_A];
    float armB = d[at + point + NORMAL_ARM_B];
    return linear + (v[b + W] * armB - v[a + W] * armA);
  }

  /**
   * Applies the impulses remembered from the last step; see {@link SolverBodies} for what happens
   * in later substeps.
   */
  void warmStart() {
    byColours(warming);
  }

  private void warmBlocks(int from, int to) {
    for (int block = from; block < to; block++) {
      for (int i = 0; i < used[block]; i++) {
        warm(block, i);
      }
    }
  }

  private void warm(int block, int i) {
    float[] d = data;
    int lane = block * LANES + i;
    int at = block * RECORD + i;
    int p = at + FIRST;
    float normal = d[p + NORMAL];
    float tangent = d[p + TANGENT];
    float turnA = d[p + NORMAL_ARM_A] * normal + d[p + TANGENT_ARM_A] * tangent;
    float turnB = d[p + NORMAL_ARM_B] * normal + d[p + TANGENT_ARM_B] * tangent;
    if ((traits[block] & TWO) != 0) {
      int q = at + SECOND;
      float normal2 = d[q + NORMAL];
      float tangent2 = d[q + TANGENT];
      turnA += d[q + NORMAL_ARM_A] * normal2 + d[q + TANGENT_ARM_A] * tangent2;
      turnB += d[q + NORMAL_ARM_B] * normal2 + d[q + TANGENT_ARM_B] * tangent2;
      normal += normal2;
      tangent += tangent2;
    }
    if ((traits[block] & ROLLS) != 0) {
      float roll = extra[block * EXTRA + i + ROLL];
      turnA += roll;
      turnB += roll;
    }
    float wa = v[bodyA[lane] + W] - d[at + INERTIA_A] * turnA;
    float wb = v[bodyB[lane] + W] + d[at + INERTIA_B] * turnB;
    give(lane, at, normal, tangent, wa, wb);
  }

  /** One visit of each contact, with its spring. */
  void push() {
    byColours(pushing);
  }

  private void pushBlocks(int from, int to, int worker) {
    for (int block = from; block < to; block++) {
      if ((traits[block] & WIDE) != 0) {
        lanes.push(this, v, scratch[worker], block);
        continue;
      }
      for (int i = 0; i < used[block]; i++) {
        push(block, i);
      }
    }
  }

  /** One visit of each contact, rigid. */
  void relax() {
    byColours(relaxing);
  }

  private void relaxBlocks(int from, int to, int worker) {
    for (int block = from; block < to; block++) {
      if ((traits[block] & WIDE) != 0) {
        lanes.relax(this, v, scratch[worker], block);
        continue;
      }
      for (int i = 0; i < used[block]; i++) {
        relax(block, i);
      }
    }
  }

  /** Friction, then the normals with their springs; the gaps are those of the last relaxing. */
  private void push(int block, int i) {
    float[] d = data;
    int lane = block * LANES + i;
    int at = block * RECORD + i;
    int a = bodyA[lane];
    int b = bodyB[lane];
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
    int trait = traits[block];
    if ((trait & MOVING_SURFACE) != 0) {
      slip += extra[block * EXTRA + i + SURFACE];
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
    give(lane, at, normal, tangent, wa, wb);
  }

  /** The normals as a rigid contact, after the bodies have moved; then friction. */
  private void relax(int block, int i) {
    float[] d = data;
    int lane = block * LANES + i;
    int at = block * RECORD + i;
    int a = bodyA[lane];
    int b = bodyB[lane];
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
    int trait = traits[block];
    if ((trait & MOVING_SURFACE) != 0) {
      slip += extra[block * EXTRA + i + SURFACE];
    }
    float moved = moved(block, i);
    int p = at + FIRST;
    int q = at + SECOND;
    float gap = gap(p, moved, a, b);
    d[p + GAP] = gap;
    float old = d[p + NORMAL];
    float normal;
    if ((trait & TWO) == 0) {
      normal = press(p, speed, wa, wb, gap > 0 ? gap * inverseH : 0, 0) - old;
      wa -= inertiaA * (d[p + NORMAL_ARM_A] * normal);
      wb += inertiaB * (d[p + NORMAL_ARM_B] * normal);
    } else {
      float gap2 = gap(q, moved, a, b);
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
    give(lane, at, normal, tangent, wa, wb);
  }

  private void addUp(int p) {
    data[p + TOTAL] += data[p + NORMAL];
    data[p + SLIDE] += data[p + TANGENT];
  }

  /** Friction at a point; answers the change of its impulse. */
  private float rub(int at, int p, float slip, float wa, float wb) {
    float[] d = data;
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
    float load = data[at + FIRST + NORMAL];
    if ((traits[block] & TWO) != 0) {
      load += data[at + SECOND + NORMAL];
    }
    float limit = extra[more + ROLLING] * load;
    float old = extra[more + ROLL];
    float sum = Math.max(-limit, Math.min(old - extra[more + ROLL_MASS] * w, limit));
    extra[more + ROLL] = sum;
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
    float[] d = data;
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
    float[] d = data;
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

  /**
   * Gives B impulses along normal and tangent, and A their opposites; the angular velocities are
   * already the new ones. Writes nothing to what can't be moved: other workers may be reading it.
   */
  private void give(int lane, int at, float normal, float tangent, float wa, float wb) {
    float[] d = data;
    float nx = d[at + NX];
    float ny = d[at + NY];
    float px = normal * nx - tangent * ny;
    float py = normal * ny + tangent * nx;
    float massA = d[at + MASS_A];
    float massB = d[at + MASS_B];
    if (massA != 0) {
      int a = bodyA[lane];
      v[a + VX] -= massA * px;
      v[a + VY] -= massA * py;
      v[a + W] = wa;
    }
    if (massB != 0) {
      int b = bodyB[lane];
      v[b + VX] += massB * px;
      v[b + VY] += massB * py;
      v[b + W] = wb;
    }
  }

  /**
   * How far B moved away from A along the normal since the step began, rotation of lever arms not
   * counted. Rounding doesn't turn: the lowest point of a rolling disc is always another one. So
   * the anchor of a round part is a radius inside, {@code r - R n}, which makes a difference of
   * {@code R (cos - 1)}. Without it a fast disc would seem to lift off while it turns, and sink in.
   */
  private float moved(int block, int i) {
    float[] d = data;
    int at = block * RECORD + i;
    int a = bodyA[block * LANES + i];
    int b = bodyB[block * LANES + i];
    float movedX = v[b + DX] - v[a + DX];
    float movedY = v[b + DY] - v[a + DY];
    float moved = movedX * d[at + NX] + movedY * d[at + NY];
    if ((traits[block] & ROUND) != 0) {
      int more = block * EXTRA + i;
      moved += extra[more + ROUND_A] * (v[a + COS] - 1) + extra[more + ROUND_B] * (v[b + COS] - 1);
    }
    return moved;
  }

  /**
   * The gap at a point now: that of the start, plus how far the two anchors moved and turned apart.
   * A lever arm r that turned by R moves along the normal by {@code (R r - r) . n = (cos - 1) (r .
   * n) + sin (r x n)}.
   */
  private float gap(int p, float moved, int a, int b) {
    float[] d = data;
    float ca = v[a + COS] - 1;
    float sa = v[a + SIN];
    float cb = v[b + COS] - 1;
    float sb = v[b + SIN];
    float turnedA = ca * d[p + TANGENT_ARM_A] + sa * d[p + NORMAL_ARM_A];
    float turnedB = cb * d[p + TANGENT_ARM_B] + sb * d[p + NORMAL_ARM_B];
    return d[p + SEPARATION] + (moved + (turnedB - turnedA));
  }

  /**
   * Bounces: points that came together faster than the threshold, and were pushed, part with the
   * speed decided when the step began, corrected for where they are now. Where one bounce spoils
   * another, as when a body is hit from two sides, more rounds settle it; impulses never pull.
   * Warm-start impulses end here, as the points fly apart.
   */
  void restitution() {
    if (!anyBounces()) {
      return;
    }
    for (int round = 0; round < BOUNCE_ROUNDS; round++) {
      byColours(bouncing);
    }
    crew.run(0, blocks, SOLVE_AT_LEAST, bounceEnding);
  }

  private boolean anyBounces() {
    for (int block = 0; block < blocks; block++) {
      if ((traits[block] & BOUNCES) != 0) {
        return true;
      }
    }
    return false;
  }

  private void bounceBlocks(int from, int to) {
    for (int block = from; block < to; block++) {
      int end = (traits[block] & BOUNCES) != 0 ? used[block] : 0;
      for (int i = 0; i < end; i++) {
        bounce(block, i, FIRST, BOUNCE_FIRST);
        if ((traits[block] & TWO) != 0) {
          bounce(block, i, SECOND, BOUNCE_SECOND);
        }
      }
    }
  }

  private void endBounces(int from, int to) {
    for (int block = from; block < to; block++) {
      int end = (traits[block] & BOUNCES) != 0 ? used[block] : 0;
      for (int i = 0; i < end; i++) {
        endBounce(block, i, FIRST, BOUNCE_FIRST);
        if ((traits[block] & TWO) != 0) {
          endBounce(block, i, SECOND, BOUNCE_SECOND);
        }
      }
    }
  }

  private void endBounce(int block, int i, int point, int wanted) {
    int p = block * RECORD + i + point;
    if (extra[block * EXTRA + i + wanted] != 0 && data[p + TOTAL] != 0) {
      data[p + NORMAL] = 0;
      data[p + TANGENT] = 0;
    }
  }

  private void bounce(int block, int i, int point, int wanted) {
    float[] d = data;
    int lane = block * LANES + i;
    int at = block * RECORD + i;
    int more = block * EXTRA + i;
    int p = at + point;
    float bounce = extra[more + wanted];
    if (bounce == 0 || d[p + TOTAL] == 0) {
      return;
    }
    int a = bodyA[lane];
    int b = bodyB[lane];
    float pull = extra[more + PULL];
    float square = bounce * bounce - 2 * pull * gap(p, moved(block, i), a, b);
    float speed = square > 0 ? (float) Math.sqrt(square) + 0.5f * h * pull : 0;
    float impulse = (Math.max(speed, 0) - normalSpeed(lane, point)) / d[p + YIELD];
    impulse = Math.max(impulse, -d[p + NORMAL]);
    d[p + NORMAL] += impulse;
    d[p + TOTAL] += impulse;
    float wa = v[a + W] - d[at + INERTIA_A] * (d[p + NORMAL_ARM_A] * impulse);
    float wb = v[b + W] + d[at + INERTIA_B] * (d[p + NORMAL_ARM_B] * impulse);
    give(lane, at, impulse, 0, wa, wb);
    if (d[at + FRICTION] != 0 && isCentral(at, p)) {
      rubBounce(block, i, p, more + wanted, impulse);
    }
  }

  /** Whether impulses along the normal turn neither body. */
  private boolean isCentral(int at, int p) {
    float[] d = data;
    float turnA = d[p + NORMAL_ARM_A];
    float turnB = d[p + NORMAL_ARM_B];
    float turning = d[at + INERTIA_A] * turnA * turnA + d[at + INERTIA_B] * turnB * turnB;
    return turning <= 1e-6f * (d[at + MASS_A] + d[at + MASS_B]);
  }

  /**
   * Friction of the bounce: a blow of (1 + e) m v along the normal rubs with up to mu times that,
   * of which the share of m v has been had. Only where the blow goes through both centres, as
   * between discs: elsewhere friction changes the normal speed, and with Newton's restitution that
   * can add energy (Kane and Levinson, "Dynamics", 1985).
   */
  private void rubBounce(int block, int i, int p, int more, float impulse) {
    float[] d = data;
    int lane = block * LANES + i;
    int at = block * RECORD + i;
    int a = bodyA[lane];
    int b = bodyB[lane];
    float dvx = v[b + VX] - v[a + VX];
    float dvy = v[b + VY] - v[a + VY];
    float slip = dvy * d[at + NX] - dvx * d[at + NY];
    slip += v[b + W] * d[p + TANGENT_ARM_B] - v[a + W] * d[p + TANGENT_ARM_A];
    if ((traits[block] & MOVING_SURFACE) != 0) {
      slip += extra[block * EXTRA + i + SURFACE];
    }
    extra[more + BOUNCED] += impulse;
    float limit = d[at + FRICTION] * Math.max(extra[more + BOUNCED], 0);
    float old = extra[more + RUBBED];
    float sum = Math.max(-limit, Math.min(old - d[p + TANGENT_MASS] * slip, limit));
    float change = sum - old;
    extra[more + RUBBED] = sum;
    d[p + SLIDE] += change;
    float wa = v[a + W] - d[at + INERTIA_A] * (d[p + TANGENT_ARM_A] * change);
    float wb = v[b + W] + d[at + INERTIA_B] * (d[p + TANGENT_ARM_B] * change);
    give(lane, at, 0, change, wa, wb);
  }

  /** Hands the impulses back to the table, but for those that overflowed. */
  void store() {
    crew.run(0, blocks, PACK_AT_LEAST, storing);
  }

  private void store(int from, int to) {
    ContactTable t = table;
    float[] d = data;
    for (int block = from; block < to; block++) {
      for (int i = 0; i < used[block]; i++) {
        int at = block * RECORD + i;
        int r = row[block * LANES + i];
        float load = d[at + FIRST + NORMAL];
        t.normal0[r] = load;
        t.tangent0[r] = d[at + FIRST + TANGENT];
        t.total0[r] = d[at + FIRST + TOTAL];
        t.slide0[r] = d[at + FIRST + SLIDE];
        if ((traits[block] & TWO) != 0) {
          t.normal1[r] = d[at + SECOND + NORMAL];
          t.tangent1[r] = d[at + SECOND + TANGENT];
          t.total1[r] = d[at + SECOND + TOTAL];
          t.slide1[r] = d[at + SECOND + SLIDE];
          load += t.normal1[r];
        }
        if ((traits[block] & ROLLS) != 0) {
          t.roll[r] = extra[block * EXTRA + i + ROLL];
          load += Math.abs(t.roll[r]);
        }
        if (!(load <= Float.MAX_VALUE)) {
          t.forget(r);
        }
      }
    }
  }
}
