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
  private static final float COUPLING = 0.75f;

  /**
   * How much more two points give way than their bodies' masses say, and how much stiffer (in o) a
   * single point is. Chosen together with the hertz: the pyramid of 100 rows comes to rest (18 J
   * after 260 ticks), and the pile of 2,000 has 13 overlaps deeper than 2 cm; it had 192 when the
   * whole yield counted.
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

  /**
   * What the kernels get until they are {@link ContactLanes#ready}. Which blocks are solved how
   * never shows in the result.
   */
  private static final int WARM_UP_BLOCKS = 4;

  /** Blocks that are worth a piece of work for a worker: to solve, and to pack or store. */
  private static final int SOLVE_AT_LEAST = 16;

  private static final int PACK_AT_LEAST = 16;

  /** Every colour has a group of contacts with one point, and one of those with two. */
  private static final int GROUPS = 2 * 2 * (LAST_COLOUR + 1);

  // Offsets of the quantities of a block in data: of the contact,
  static final int NX = 0;
  static final int NY = NX + LANES;
  static final int FRICTION = NY + LANES;
  static final int SURFACE = FRICTION + LANES;
  static final int MASS_A = SURFACE + LANES;
  static final int MASS_B = MASS_A + LANES;
  static final int INERTIA_A = MASS_B + LANES;
  static final int INERTIA_B = INERTIA_A + LANES;

  /** Softness: bias rate; what the spring adds to a point's yield, and to the points' cross. */
  static final int BIAS_RATE = INERTIA_B + LANES;

  static final int SOFT = BIAS_RATE + LANES;
  static final int SOFT_CROSS = SOFT + LANES;

  /** What an impulse at one point does to the other's speed along the normal, 1/kg. */
  static final int CROSS = SOFT_CROSS + LANES;

  /** Radii of the parts' rounding, m. */
  static final int ROUND_A = CROSS + LANES;

  static final int ROUND_B = ROUND_A + LANES;

  // of each of its two points, relative to FIRST or SECOND,
  static final int AX = 0;
  static final int AY = AX + LANES;
  static final int BX = AY + LANES;
  static final int BY = BX + LANES;

  /** Gap when the step began, and now, m. */
  static final int SEPARATION = BY + LANES;

  static final int GAP = SEPARATION + LANES;

  /** What an impulse does to the point's speed along the normal, 1/kg. */
  static final int YIELD = GAP + LANES;

  static final int TANGENT_MASS = YIELD + LANES;
  static final int NORMAL = TANGENT_MASS + LANES;
  static final int TANGENT = NORMAL + LANES;
  static final int TOTAL = TANGENT + LANES;
  static final int SLIDE = TOTAL + LANES;
  static final int POINT = SLIDE + LANES;

  static final int FIRST = ROUND_B + LANES;
  static final int SECOND = FIRST + POINT;
  static final int RECORD = SECOND + POINT;

  // and of what few contacts need, relative to the block in extra.
  private static final int ROLLING = 0;
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
  private static final int EXTRA = BOUNCE_FIRST + RUBBED + 2 * LANES;

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

  /** Per block: contacts in it, whether they have two points, and if one may roll or bounce. */
  private byte[] used = new byte[0];

  boolean[] two = new boolean[0];
  private boolean[] rolls = new boolean[0];
  private boolean[] bounces = new boolean[0];

  /** Per lane: row of the contact table; offsets of the two bodies in the solver's state. */
  private int[] row = new int[0];

  int[] bodyA = new int[0];
  int[] bodyB = new int[0];

  float[] data = new float[0];
  private float[] extra = new float[0];

  /** The vector kernels, null without; and which blocks they take. */
  private final ContactLanes lanes;

  private boolean[] wide = new boolean[0];

  /** Of each worker. */
  private float[][] scratch = new float[0][];

  /**
   * Which blocks are with static or kinematic bodies: several may touch the same, none moves it.
   */
  boolean[] fixed = new boolean[0];

  /** First block of each colour. */
  private final int[] colourStart = new int[2 * (LAST_COLOUR + 1) + 1];

  private final Crew crew;

  // The stages, made once so that a step allocates nothing.
  private final Crew.Range packing = (from, to, worker) -> packBlocks(from, to);
  private final Crew.Range warming = this::warmStart;
  private final Crew.Range pushing = (from, to, worker) -> solve(from, to, worker, true);
  private final Crew.Range relaxing = (from, to, worker) -> solve(from, to, worker, false);
  private final Crew.Range bouncing = (from, to, worker) -> bounce(from, to);
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
  private float omega;

  private float h;

  float inverseH;
  float maxPush;
  float slop;

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
    omega = TWO_PI * Math.min(constants.contactHertz(), MAX_HERTZ_PER_RATE / h);
    if (lanes != null && scratch.length != crew.count()) {
      scratch = new float[crew.count()][lanes.scratchSize()];
    }
    paint(contacts, bodyStore, solverBodies.count(), activeIndices);
    layOut();
    for (int k = 0; k < count; k++) {
      row[next[group[k]]++] = touching[k];
    }
    crew.run(0, blocks, PACK_AT_LEAST, packing);
  }

  /** Finds the contacts to solve and gives each its colour. */
  private void paint(ContactTable t, BodyStore b, int slots, int[] activeIndex) {
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
      two = new boolean[capacity];
      wide = new boolean[capacity];
      fixed = new boolean[capacity];
      rolls = new boolean[capacity];
      bounces = new boolean[capacity];
      row = new int[capacity * LANES];
      bodyA = new int[capacity * LANES];
      bodyB = new int[capacity * LANES];
      data = new float[capacity * RECORD];
      extra = new float[capacity * EXTRA];
    }
    int widest =
        lanes == null || blocks < FEWEST_BLOCKS ? 0 : lanes.ready() ? blocks : WARM_UP_BLOCKS;
    int block = 0;
    for (int g = 0; g < GROUPS; g++) {
      colourStart[g >> 1] = (g & 1) == 0 ? block : colourStart[g >> 1];
      int left = next[g];
      next[g] = block * LANES;
      for (; left > 0; left -= LANES) {
        used[block] = (byte) Math.min(left, LANES);
        two[block] = (g & 1) != 0;
        wide[block] = block < widest && left >= FEWEST && (g >> 1 & LAST_COLOUR) != LAST_COLOUR;
        if (left < LANES) {
          clear(block);
        }
        fixed[block] = g >> 1 > LAST_COLOUR;
        rolls[block] = false;
        bounces[block] = false;
        block++;
      }
    }
    colourStart[GROUPS >> 1] = blocks;
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
        pack(block * LANES + i);
      }
    }
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

  private void pack(int lane) {
    ContactTable t = table;
    BodyStore b = store;
    int r = row[lane];
    float[] d = data;
    int block = lane / LANES;
    int at = block * RECORD + lane % LANES;
    int more = block * EXTRA + lane % LANES;
    int a = ContactKey.bodyA(t.key[r]);
    int o = ContactKey.bodyB(t.key[r]);
    int slotA = activeIndex[a] + 1;
    int slotB = activeIndex[o] + 1;
    bodyA[lane] = slotA * STRIDE;
    bodyB[lane] = slotB * STRIDE;
    float ma = b.invMass[a];
    float mb = b.invMass[o];
    d[at + NX] = t.nx[r];
    d[at + NY] = t.ny[r];
    d[at + FRICTION] = t.friction[r];
    d[at + SURFACE] = t.surface[r];
    d[at + ROUND_A] = t.roundA[r];
    d[at + ROUND_B] = t.roundB[r];
    d[at + MASS_A] = ma;
    d[at + MASS_B] = mb;
    d[at + INERTIA_A] = b.invInertia[a];
    d[at + INERTIA_B] = b.invInertia[o];
    float stiff = ma == 0 || mb == 0 ? 2 * omega : omega;
    if (!two[block]) {
      stiff *= SINGLE_STIFFNESS;
    }
    float twiceZeta = 2 * settings.contactDampingRatio();
    d[at + BIAS_RATE] = stiff / (twiceZeta + h * stiff);
    float gapX = b.x[o] - b.x[a];
    float gapY = b.y[o] - b.y[a];
    float turning = b.invInertia[a] + b.invInertia[o];
    extra[more + ROLLING] = t.rolling[r];
    extra[more + ROLL_MASS] = turning > 0 ? 1 / turning : 0;
    extra[more + ROLL] = t.roll[r];
    if (t.rolling[r] > 0) {
      rolls[block] = true;
      wide[block] = false;
    }
    extra[more + PULL] =
        (bodies.ax(slotA) - bodies.ax(slotB)) * t.nx[r]
            + (bodies.ay(slotA) - bodies.ay(slotB)) * t.ny[r];
    float yield = packPoint(at, FIRST, t.x0[r], t.y0[r], gapX, gapY, t.separation0[r]);
    d[at + FIRST + NORMAL] = t.normal0[r];
    d[at + FIRST + TANGENT] = t.tangent0[r];
    float perMass = 1 / (h * stiff * (twiceZeta + h * stiff));
    d[at + SOFT] = (ma + mb) * perMass;
    if (two[block]) {
      float other = packPoint(at, SECOND, t.x1[r], t.y1[r], gapX, gapY, t.separation1[r]);
      d[at + SECOND + NORMAL] = t.normal1[r];
      d[at + SECOND + TANGENT] = t.tangent1[r];
      float soft = PAIR_SOFTNESS * (ma + mb) * perMass / (1 + COUPLING);
      d[at + SOFT] = soft;
      d[at + SOFT_CROSS] = soft * COUPLING;
      d[at + CROSS] = cross(at);
      d[at + FIRST + YIELD] = yield * SHARE;
      d[at + SECOND + YIELD] = other * SHARE;
    }
    float e = t.restitution[r];
    for (int i = BOUNCED; i < RUBBED + 2 * LANES; i += LANES) {
      extra[more + BOUNCE_FIRST + i] = 0;
    }
    extra[more + BOUNCE_FIRST] = 0;
    extra[more + BOUNCE_SECOND] = 0;
    if (e > 0) {
      float threshold = settings.restitutionThreshold();
      extra[more + BOUNCE_FIRST] = e * approach(lane, FIRST, threshold);
      extra[more + BOUNCE_SECOND] = two[block] ? e * approach(lane, SECOND, threshold) : 0;
      bounces[block] |= extra[more + BOUNCE_FIRST] != 0 || extra[more + BOUNCE_SECOND] != 0;
    }
  }

  /** Answers the point's yield. */
  private float packPoint(
      int at, int point, float x, float y, float gapX, float gapY, float separation) {
    float[] d = data;
    int p = at + point;
    float bx = x - gapX;
    float by = y - gapY;
    d[p + AX] = x;
    d[p + AY] = y;
    d[p + BX] = bx;
    d[p + BY] = by;
    d[p + SEPARATION] = separation;
    d[p + GAP] = separation;
    float nx = d[at + NX];
    float ny = d[at + NY];
    float masses = d[at + MASS_A] + d[at + MASS_B];
    float iA = d[at + INERTIA_A];
    float iB = d[at + INERTIA_B];
    float rnA = x * ny - y * nx;
    float rnB = bx * ny - by * nx;
    float kn = masses + iA * rnA * rnA + iB * rnB * rnB;
    d[p + YIELD] = kn;
    float rtA = x * nx + y * ny;
    float rtB = bx * nx + by * ny;
    float kt = masses + iA * rtA * rtA + iB * rtB * rtB;
    d[p + TANGENT_MASS] = kt > 0 ? 1 / kt : 0;
    d[p + TOTAL] = 0;
    d[p + SLIDE] = 0;
    return kn;
  }

  private float cross(int at) {
    float[] d = data;
    int p = at + FIRST;
    int q = at + SECOND;
    float nx = d[at + NX];
    float ny = d[at + NY];
    float turnA = (d[p + AX] * ny - d[p + AY] * nx) * (d[q + AX] * ny - d[q + AY] * nx);
    float turnB = (d[p + BX] * ny - d[p + BY] * nx) * (d[q + BX] * ny - d[q + BY] * nx);
    float masses = d[at + MASS_A] + d[at + MASS_B];
    return masses + d[at + INERTIA_A] * turnA + d[at + INERTIA_B] * turnB;
  }

  /**
   * Speed with which the surfaces will meet at a point, m/s: that of now, plus what the relative
   * acceleration a adds over the gap, v^2 = v0^2 + 2 a s; 0 below the threshold. In symplectic
   * Euler a velocity is that of half a substep ago, hence a h / 2 is added here and again after the
   * bounce. Without these terms a perfectly elastic ball would lose 2 % of its height with every
   * bounce.
   */
  private float approach(int lane, int point, float threshold) {
    int at = lane / LANES * RECORD + lane % LANES;
    float pull = extra[lane / LANES * EXTRA + lane % LANES + PULL];
    float speed = 0.5f * h * pull - normalSpeed(lane, point);
    if (!(speed > threshold)) {
      return 0;
    }
    float square = speed * speed + 2 * pull * data[at + point + SEPARATION];
    return square > 0 ? (float) Math.sqrt(square) : 0;
  }

  private float normalSpeed(int lane, int point) {
    float[] d = data;
    int at = lane / LANES * RECORD + lane % LANES;
    int p = at + point;
    int a = bodyA[lane];
    int b = bodyB[lane];
    float dvx = v[b + VX] - v[b + W] * d[p + BY] - v[a + VX] + v[a + W] * d[p + AY];
    float dvy = v[b + VY] + v[b + W] * d[p + BX] - v[a + VY] - v[a + W] * d[p + AX];
    return dvx * d[at + NX] + dvy * d[at + NY];
  }

  /** Applies the impulses remembered from the last substep, or the last step. */
  void warmStart() {
    byColours(warming);
  }

  private void warmStart(int from, int to, int worker) {
    for (int block = from; block < to; block++) {
      if (wide[block]) {
        lanes.warmStart(this, v, scratch[worker], block);
        continue;
      }
      int end = block * LANES + used[block];
      for (int lane = block * LANES; lane < end; lane++) {
        warm(lane, FIRST);
        if (two[block]) {
          warm(lane, SECOND);
        }
        if (rolls[block]) {
          int at = block * RECORD + lane % LANES;
          turn(lane, at, extra[block * EXTRA + lane % LANES + ROLL]);
        }
      }
    }
  }

  private void warm(int lane, int point) {
    int at = lane / LANES * RECORD + lane % LANES;
    float nx = data[at + NX];
    float ny = data[at + NY];
    float pn = data[at + point + NORMAL];
    float pt = data[at + point + TANGENT];
    apply(bodyA[lane], bodyB[lane], at, point, pn * nx - pt * ny, pn * ny + pt * nx);
  }

  /** One visit of each contact, with its spring. */
  void push() {
    byColours(pushing);
  }

  /** One visit of each contact, rigid. */
  void relax() {
    byColours(relaxing);
  }

  private void solve(int from, int to, int worker, boolean bias) {
    for (int block = from; block < to; block++) {
      if (wide[block]) {
        if (bias) {
          lanes.push(this, v, scratch[worker], block);
        } else {
          lanes.relax(this, v, scratch[worker], block);
        }
        continue;
      }
      int end = block * LANES + used[block];
      for (int lane = block * LANES; lane < end; lane++) {
        if (bias) {
          visitAndPush(lane);
        } else {
          relax(lane);
        }
      }
    }
  }

  private void visitAndPush(int lane) {
    int block = lane / LANES;
    if (rolls[block]) {
      solveRolling(lane);
    }
    solveFriction(lane, FIRST);
    if (two[block]) {
      solveFriction(lane, SECOND);
    }
    if (two[block]) {
      pushBoth(lane);
    } else {
      push(lane);
    }
  }

  private void relax(int lane) {
    int block = lane / LANES;
    if (two[block]) {
      holdBoth(lane);
    } else {
      hold(lane);
    }
    solveFriction(lane, FIRST);
    if (two[block]) {
      solveFriction(lane, SECOND);
    }
    if (rolls[block]) {
      solveRolling(lane);
    }
    addUp(lane, FIRST);
    if (two[block]) {
      addUp(lane, SECOND);
    }
  }

  private void addUp(int lane, int point) {
    int p = lane / LANES * RECORD + lane % LANES + point;
    data[p + TOTAL] += data[p + NORMAL];
    data[p + SLIDE] += data[p + TANGENT];
  }

  /** The normal with its spring; the gap is still that of the last relaxing visit. */
  private void push(int lane) {
    float[] d = data;
    int at = lane / LANES * RECORD + lane % LANES;
    float gap = d[at + FIRST + GAP];
    solveOne(lane, push(at, gap), gap > 0 ? 0 : d[at + SOFT]);
  }

  private void pushBoth(int lane) {
    float[] d = data;
    int at = lane / LANES * RECORD + lane % LANES;
    float gap1 = d[at + FIRST + GAP];
    float gap2 = d[at + SECOND + GAP];
    float soft1 = gap1 > 0 ? 0 : d[at + SOFT];
    float soft2 = gap2 > 0 ? 0 : d[at + SOFT];
    float softCross = gap1 > 0 || gap2 > 0 ? 0 : d[at + SOFT_CROSS];
    solveBoth(lane, push(at, gap1), push(at, gap2), soft1, soft2, softCross);
  }

  /** Speed by which a gap may close, or at which overlap is pushed apart (negative), m/s. */
  private float push(int at, float gap) {
    if (gap > 0) {
      return gap * inverseH;
    }
    float overlap = gap + slop;
    float speed = data[at + BIAS_RATE] * (overlap < 0 ? overlap : 0);
    return speed > -maxPush ? speed : -maxPush;
  }

  /** The normal as a rigid contact, after the bodies have moved. */
  private void hold(int lane) {
    solveOne(lane, room(lane, FIRST), 0);
  }

  private void holdBoth(int lane) {
    solveBoth(lane, room(lane, FIRST), room(lane, SECOND), 0, 0, 0);
  }

  /** Measures the gap at a point, and answers the speed by which it may close, m/s. */
  private float room(int lane, int point) {
    float gap = separation(lane, point);
    data[lane / LANES * RECORD + lane % LANES + point + GAP] = gap;
    return gap > 0 ? gap * inverseH : 0;
  }

  private void solveOne(int lane, float push, float soft) {
    float[] d = data;
    int at = lane / LANES * RECORD + lane % LANES;
    float old = d[at + FIRST + NORMAL];
    float yield = d[at + FIRST + YIELD];
    float q = normalSpeed(lane, FIRST) + push - yield * old;
    float sum = q < 0 ? -q / (yield + soft) : 0;
    d[at + FIRST + NORMAL] = sum;
    give(lane, FIRST, sum - old);
  }

  private void solveBoth(
      int lane, float push1, float push2, float soft1, float soft2, float softCross) {
    float[] d = data;
    int at = lane / LANES * RECORD + lane % LANES;
    float old1 = d[at + FIRST + NORMAL];
    float old2 = d[at + SECOND + NORMAL];
    float k1 = d[at + FIRST + YIELD];
    float k2 = d[at + SECOND + YIELD];
    float k = d[at + CROSS];
    float q1 = normalSpeed(lane, FIRST) + push1 - k1 * old1 - k * old2;
    float q2 = normalSpeed(lane, SECOND) + push2 - k2 * old2 - k * old1;
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
    d[at + FIRST + NORMAL] = sum1;
    d[at + SECOND + NORMAL] = sum2;
    give(lane, FIRST, sum1 - old1);
    give(lane, SECOND, sum2 - old2);
  }

  private void give(int lane, int point, float impulse) {
    int at = lane / LANES * RECORD + lane % LANES;
    float px = impulse * data[at + NX];
    float py = impulse * data[at + NY];
    apply(bodyA[lane], bodyB[lane], at, point, px, py);
  }

  private void solveFriction(int lane, int point) {
    float[] d = data;
    int at = lane / LANES * RECORD + lane % LANES;
    int p = at + point;
    int a = bodyA[lane];
    int b = bodyB[lane];
    float nx = d[at + NX];
    float ny = d[at + NY];
    float dvx = v[b + VX] - v[b + W] * d[p + BY] - v[a + VX] + v[a + W] * d[p + AY];
    float dvy = v[b + VY] + v[b + W] * d[p + BX] - v[a + VY] - v[a + W] * d[p + AX];
    float vt = dvy * nx - dvx * ny + d[at + SURFACE];
    float limit = d[at + FRICTION] * d[p + NORMAL];
    float old = d[p + TANGENT];
    float sum = old - d[p + TANGENT_MASS] * vt;
    sum = sum < limit ? sum : limit;
    sum = sum > -limit ? sum : -limit;
    d[p + TANGENT] = sum;
    apply(a, b, at, point, (old - sum) * ny, (sum - old) * nx);
  }

  private void solveRolling(int lane) {
    float[] d = data;
    int at = lane / LANES * RECORD + lane % LANES;
    int more = lane / LANES * EXTRA + lane % LANES;
    float load = d[at + FIRST + NORMAL];
    if (two[lane / LANES]) {
      load += d[at + SECOND + NORMAL];
    }
    float limit = extra[more + ROLLING] * load;
    float old = extra[more + ROLL];
    int a = bodyA[lane];
    int b = bodyB[lane];
    float w = v[b + W] - v[a + W];
    float sum = Math.max(-limit, Math.min(old - extra[more + ROLL_MASS] * w, limit));
    extra[more + ROLL] = sum;
    turn(lane, at, sum - old);
  }

  private void turn(int lane, int at, float impulse) {
    if (data[at + INERTIA_A] != 0) {
      v[bodyA[lane] + W] -= data[at + INERTIA_A] * impulse;
    }
    if (data[at + INERTIA_B] != 0) {
      v[bodyB[lane] + W] += data[at + INERTIA_B] * impulse;
    }
  }

  /** Writes nothing to what can't be moved: other workers may be reading it. */
  private void apply(int a, int b, int at, int point, float px, float py) {
    float[] d = data;
    int p = at + point;
    float massA = d[at + MASS_A];
    float massB = d[at + MASS_B];
    if (massA != 0) {
      v[a + VX] -= massA * px;
      v[a + VY] -= massA * py;
      v[a + W] -= d[at + INERTIA_A] * (d[p + AX] * py - d[p + AY] * px);
    }
    if (massB != 0) {
      v[b + VX] += massB * px;
      v[b + VY] += massB * py;
      v[b + W] += d[at + INERTIA_B] * (d[p + BX] * py - d[p + BY] * px);
    }
  }

  /**
   * The gap at a point now: that of the start, plus how far the two anchors moved and turned apart.
   * Rounding doesn't turn: the lowest point of a rolling disc is always another one. So the anchor
   * of a round part is a radius inside, {@code r - R n}, which makes a difference of {@code R (cos
   * - 1)}. Without it a fast disc would seem to lift off while it turns, and sink in.
   */
  private float separation(int lane, int point) {
    float[] d = data;
    int at = lane / LANES * RECORD + lane % LANES;
    int p = at + point;
    int a = bodyA[lane];
    int b = bodyB[lane];
    float ca = v[a + COS] - 1;
    float sa = v[a + SIN];
    float cb = v[b + COS] - 1;
    float sb = v[b + SIN];
    float movedX = v[b + DX] - v[a + DX];
    float movedY = v[b + DY] - v[a + DY];
    movedX += (cb * d[p + BX] - sb * d[p + BY]) - (ca * d[p + AX] - sa * d[p + AY]);
    movedY += (sb * d[p + BX] + cb * d[p + BY]) - (sa * d[p + AX] + ca * d[p + AY]);
    float round = d[at + ROUND_A] * ca + d[at + ROUND_B] * cb;
    return d[p + SEPARATION] + movedX * d[at + NX] + movedY * d[at + NY] + round;
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
      if (bounces[block]) {
        return true;
      }
    }
    return false;
  }

  private void bounce(int from, int to) {
    for (int block = from; block < to; block++) {
      int end = bounces[block] ? block * LANES + used[block] : 0;
      for (int lane = block * LANES; lane < end; lane++) {
        bounce(lane, FIRST, BOUNCE_FIRST);
        if (two[block]) {
          bounce(lane, SECOND, BOUNCE_SECOND);
        }
      }
    }
  }

  private void endBounces(int from, int to) {
    for (int block = from; block < to; block++) {
      int end = bounces[block] ? block * LANES + used[block] : 0;
      for (int lane = block * LANES; lane < end; lane++) {
        endBounce(lane, FIRST, BOUNCE_FIRST);
        if (two[block]) {
          endBounce(lane, SECOND, BOUNCE_SECOND);
        }
      }
    }
  }

  private void endBounce(int lane, int point, int speed) {
    int p = lane / LANES * RECORD + lane % LANES + point;
    float bounce = extra[lane / LANES * EXTRA + lane % LANES + speed];
    if (bounce != 0 && data[p + TOTAL] != 0) {
      data[p + NORMAL] = 0;
      data[p + TANGENT] = 0;
    }
  }

  private void bounce(int lane, int point, int speed) {
    float[] d = data;
    int at = lane / LANES * RECORD + lane % LANES;
    int more = lane / LANES * EXTRA + lane % LANES;
    int p = at + point;
    float bounce = extra[more + speed];
    if (bounce == 0 || d[p + TOTAL] == 0) {
      return;
    }
    float pull = extra[more + PULL];
    float square = bounce * bounce - 2 * pull * separation(lane, point);
    float wanted = square > 0 ? (float) Math.sqrt(square) + 0.5f * h * pull : 0;
    float impulse = (Math.max(wanted, 0) - normalSpeed(lane, point)) / d[p + YIELD];
    impulse = Math.max(impulse, -d[p + NORMAL]);
    d[p + NORMAL] += impulse;
    d[p + TOTAL] += impulse;
    apply(bodyA[lane], bodyB[lane], at, point, impulse * d[at + NX], impulse * d[at + NY]);
    if (d[at + FRICTION] != 0 && isCentral(at, p)) {
      rub(lane, point, more + speed, impulse);
    }
  }

  /** Whether impulses along the normal turn neither body. */
  private boolean isCentral(int at, int p) {
    float[] d = data;
    float turnA = d[p + AX] * d[at + NY] - d[p + AY] * d[at + NX];
    float turnB = d[p + BX] * d[at + NY] - d[p + BY] * d[at + NX];
    float turning = d[at + INERTIA_A] * turnA * turnA + d[at + INERTIA_B] * turnB * turnB;
    return turning <= 1e-6f * (d[at + MASS_A] + d[at + MASS_B]);
  }

  /**
   * Friction of the bounce: a blow of (1 + e) m v along the normal rubs with up to mu times that,
   * of which the share of m v has been had. Only where the blow goes through both centres, as
   * between discs: elsewhere friction changes the normal speed, and with Newton's restitution that
   * can add energy (Kane and Levinson, "Dynamics", 1985).
   */
  private void rub(int lane, int point, int at, float impulse) {
    float[] d = data;
    int contact = lane / LANES * RECORD + lane % LANES;
    int p = contact + point;
    int a = bodyA[lane];
    int b = bodyB[lane];
    float nx = d[contact + NX];
    float ny = d[contact + NY];
    extra[at + BOUNCED] += impulse;
    float limit = d[contact + FRICTION] * Math.max(extra[at + BOUNCED], 0);
    float dvx = v[b + VX] - v[b + W] * d[p + BY] - v[a + VX] + v[a + W] * d[p + AY];
    float dvy = v[b + VY] + v[b + W] * d[p + BX] - v[a + VY] - v[a + W] * d[p + AX];
    float vt = dvy * nx - dvx * ny + d[contact + SURFACE];
    float old = extra[at + RUBBED];
    float sum = Math.max(-limit, Math.min(old - d[p + TANGENT_MASS] * vt, limit));
    extra[at + RUBBED] = sum;
    d[p + SLIDE] += sum - old;
    apply(a, b, contact, point, (old - sum) * ny, (sum - old) * nx);
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
        t.normal0[r] = d[at + FIRST + NORMAL];
        t.tangent0[r] = d[at + FIRST + TANGENT];
        t.total0[r] = d[at + FIRST + TOTAL];
        t.slide0[r] = d[at + FIRST + SLIDE];
        t.roll[r] = extra[block * EXTRA + i + ROLL];
        if (two[block]) {
          t.normal1[r] = d[at + SECOND + NORMAL];
          t.tangent1[r] = d[at + SECOND + TANGENT];
          t.total1[r] = d[at + SECOND + TOTAL];
          t.slide1[r] = d[at + SECOND + SLIDE];
        }
        if (!(t.normal0[r] + t.normal1[r] + Math.abs(t.roll[r]) <= Float.MAX_VALUE)) {
          t.forget(r);
        }
      }
    }
  }
}
