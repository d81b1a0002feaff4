package carom.physics.dynamics.solver;

import static carom.physics.dynamics.domain.SolverBodies.STRIDE;
import static carom.physics.dynamics.domain.SolverBodies.VX;
import static carom.physics.dynamics.domain.SolverBodies.VY;
import static carom.physics.dynamics.domain.SolverBodies.W;
import static carom.physics.dynamics.solver.ContactBlocks.CLOSING_ACCELERATION;
import static carom.physics.dynamics.solver.ContactBlocks.COEFFICIENT;
import static carom.physics.dynamics.solver.ContactBlocks.CROSS;
import static carom.physics.dynamics.solver.ContactBlocks.EXTRA;
import static carom.physics.dynamics.solver.ContactBlocks.FAST;
import static carom.physics.dynamics.solver.ContactBlocks.FIRST;
import static carom.physics.dynamics.solver.ContactBlocks.FREE;
import static carom.physics.dynamics.solver.ContactBlocks.FRICTION;
import static carom.physics.dynamics.solver.ContactBlocks.GAP;
import static carom.physics.dynamics.solver.ContactBlocks.IMPACT_NORMAL;
import static carom.physics.dynamics.solver.ContactBlocks.IMPACT_TANGENT;
import static carom.physics.dynamics.solver.ContactBlocks.INERTIA_A;
import static carom.physics.dynamics.solver.ContactBlocks.INERTIA_B;
import static carom.physics.dynamics.solver.ContactBlocks.INVERSE_NORMAL_MASS;
import static carom.physics.dynamics.solver.ContactBlocks.LANES;
import static carom.physics.dynamics.solver.ContactBlocks.MASS_A;
import static carom.physics.dynamics.solver.ContactBlocks.MASS_B;
import static carom.physics.dynamics.solver.ContactBlocks.MOVING_SURFACE;
import static carom.physics.dynamics.solver.ContactBlocks.NORMAL_ARM_A;
import static carom.physics.dynamics.solver.ContactBlocks.NORMAL_ARM_B;
import static carom.physics.dynamics.solver.ContactBlocks.NX;
import static carom.physics.dynamics.solver.ContactBlocks.NY;
import static carom.physics.dynamics.solver.ContactBlocks.RECORD;
import static carom.physics.dynamics.solver.ContactBlocks.RESTITUTION;
import static carom.physics.dynamics.solver.ContactBlocks.SECOND;
import static carom.physics.dynamics.solver.ContactBlocks.SURFACE;
import static carom.physics.dynamics.solver.ContactBlocks.TANGENT_ARM_A;
import static carom.physics.dynamics.solver.ContactBlocks.TANGENT_ARM_B;
import static carom.physics.dynamics.solver.ContactBlocks.TANGENT_MASS;
import static carom.physics.dynamics.solver.ContactBlocks.TOTAL_NORMAL;
import static carom.physics.dynamics.solver.ContactBlocks.TOTAL_TANGENT;
import static carom.physics.dynamics.solver.ContactBlocks.TWO;

import carom.physics.dynamics.domain.DomainPhases;
import carom.physics.dynamics.domain.SolverBodies;
import carom.physics.dynamics.store.ParallelFor;
import java.util.Arrays;

/**
 * Solves impacts, at the start of each substep: points that would close their gap within the
 * substep, faster than the threshold, part with e times the speed of their approach.
 *
 * <p>An impact is a blow between two bodies, at the speeds that they have at that moment. Blows
 * follow one another, colour by colour and round by round, until none is left. So a blow goes on
 * through a row of balls, as from one to the next in Newton's cradle, and each blow by itself keeps
 * momentum and loses {@code (1 - e^2)} of the energy of the approach: with e = 1 nothing. What
 * still approaches more slowly than the threshold is left to the solver, which stops it.
 *
 * <p>Looked at are contacts that approach fast when the step begins, and those of bodies that were
 * struck in it. A step in which nothing approaches fast does none of this.
 *
 * <p>Both points of a contact that lands flat bounce together, or the body would turn.
 */
final class ContactRestitution {
  /** Most rounds in a substep. A row of n touching balls takes up to n of them. */
  private static final int MOST_ROUNDS = 32;

  /**
   * State: impacts are possible in the rest of this step. The contact bounces, and approached fast
   * when the step began, or a body of it was struck since.
   */
  private static final int POSSIBLE = 1;

  /** State: a body of it was struck since the contact was looked at. */
  private static final int STRUCK = 2;

  /** State: the surfaces meet or part faster than the threshold. */
  private static final int FAST_NOW = 4;

  /** The round before the first one. */
  private static final int START = 1;

  /** No link. */
  private static final int NONE = -1;

  /** Part of the effective masses below which two points count as one. */
  private static final float SINGULAR = 1e-5f;

  private final ContactBlocks blocks;
  private final ScalarContacts scalar;
  private final ParallelFor parallel;

  /** The stage, made once so that a step allocates nothing. */
  private final DomainPhases.Phase solving;

  private SolverBodies bodies;

  /** State of the bodies, {@link SolverBodies#state}. */
  private float[] v = new float[0];

  /** Length of a substep, s. */
  private float h;

  private float threshold;

  /**
   * Per lane: 0, or {@link #POSSIBLE} and what else is known of its impacts. Threads write the same
   * where they write to one lane at once.
   */
  private byte[] state = new byte[0];

  /**
   * Per block: the last round of this step in which a body of its bouncing contacts was struck, or
   * {@link #START} if a contact approached fast when the step began, or 0.
   */
  private int[] news = new int[0];

  /** Per slot: the first link to a bouncing contact of the body, {@link #NONE} without. */
  private int[] firstLink = new int[0];

  /** Per link, two a lane, for A and for B: the next link of the same body, or {@link #NONE}. */
  private int[] nextLink = new int[0];

  /** Number of the present round within the step, from {@link #START} + 1 on. */
  private int round;

  /** Number of the first round of this substep. */
  private int firstRound;

  /** Per worker: whether it found an impact in this round. */
  private boolean[] found = new boolean[1];

  /** Solves the contacts of these blocks. */
  ContactRestitution(ContactBlocks blocks, ScalarContacts scalar, ParallelFor parallel) {
    this.blocks = blocks;
    this.scalar = scalar;
    this.parallel = parallel;
    solving = blocks.phase(this::solveBlocks);
  }

  /**
   * Begins a step. The blocks must be packed.
   *
   * @param bodies whose velocities change
   * @param substep length of a substep, s
   * @param leastSpeed of an impact, m/s
   * @return whether anything meets or parts so fast that impacts are possible
   */
  boolean begin(SolverBodies bodies, float substep, float leastSpeed) {
    if (!findFast()) {
      return false;
    }
    this.bodies = bodies;
    v = bodies.state;
    h = substep;
    threshold = leastSpeed;
    round = START;
    linkAll(v.length / STRIDE);
    if (found.length < parallel.count()) {
      found = new boolean[parallel.count()];
    }
    return true;
  }

  /** Finds the contacts that approach or part fast; returns whether any does. */
  private boolean findFast() {
    if (news.length < blocks.traits.length) {
      news = new int[blocks.traits.length];
      state = new byte[blocks.bodyA.length];
      nextLink = new int[2 * blocks.bodyA.length];
    }
    Arrays.fill(news, 0, blocks.count(), 0);
    Arrays.fill(state, 0, blocks.count() * LANES, (byte) 0);
    boolean any = false;
    for (int block = 0; block < blocks.count(); block++) {
      int end = (blocks.traits[block] & RESTITUTION) != 0 ? blocks.used[block] : 0;
      for (int i = 0; i < end; i++) {
        if (blocks.extra[block * EXTRA + FAST + i] != 0) {
          state[block * LANES + i] = POSSIBLE;
          news[block] = START;
          any = true;
        }
      }
    }
    return any;
  }

  /** Lists the bouncing contacts of each body, so that a blow finds those it may lead to. */
  private void linkAll(int slots) {
    if (firstLink.length < slots) {
      firstLink = new int[slots];
    }
    Arrays.fill(firstLink, 0, slots, NONE);
    for (int block = 0; block < blocks.count(); block++) {
      int end = (blocks.traits[block] & RESTITUTION) != 0 ? blocks.used[block] : 0;
      for (int i = 0; i < end; i++) {
        if (blocks.extra[block * EXTRA + i + COEFFICIENT] != 0) {
          int lane = block * LANES + i;
          link(2 * lane, blocks.bodyA[lane] / STRIDE);
          link(2 * lane + 1, blocks.bodyB[lane] / STRIDE);
        }
      }
    }
  }

  private void link(int link, int slot) {
    nextLink[link] = firstLink[slot];
    firstLink[slot] = link;
  }

  /** Solves the impacts of a substep. No phases may be left to run. */
  void solve(DomainPhases phases) {
    boolean more = true;
    firstRound = round + 1;
    while (more && round + 1 - firstRound < MOST_ROUNDS) {
      round++;
      Arrays.fill(found, false);
      blocks.addColours(phases, solving, true);
      phases.run();
      more = false;
      for (boolean any : found) {
        more |= any;
      }
    }
    findFree();
  }

  /** Finds the blocks with contacts that impacts alone answer in this substep. */
  private void findFree() {
    for (int block = 0; block < blocks.count(); block++) {
      if (news[block] != 0) {
        int all = 0;
        for (int lane = block * LANES; lane < (block + 1) * LANES; lane++) {
          all |= state[lane];
        }
        blocks.traits[block] &= ~FREE;
        blocks.traits[block] |= (byte) ((all & FAST_NOW) != 0 ? FREE : 0);
      }
    }
  }

  /** Returns whether the surfaces of a contact meet or part so fast that impacts alone answer. */
  boolean isFree(int block, int i) {
    return (blocks.traits[block] & FREE) != 0 && (state[block * LANES + i] & FAST_NOW) != 0;
  }

  /** Looks at all possible impacts in the first round of a substep, then where blows may lead. */
  private void solveBlocks(int from, int to, int worker) {
    boolean first = round == firstRound;
    boolean any = false;
    for (int block = from; block < to; block++) {
      if (news[block] == 0 || (!first && news[block] < round - 1)) {
        continue;
      }
      for (int i = 0; i < blocks.used[block]; i++) {
        if ((state[block * LANES + i] & (first ? POSSIBLE : STRUCK)) != 0) {
          any |= solve(block, i);
        }
      }
    }
    if (any) {
      found[worker] = true;
    }
  }

  /** Solves the impact of a contact, if there is one; returns whether there was. */
  private boolean solve(int block, int i) {
    float[] d = blocks.data;
    int lane = block * LANES + i;
    int at = block * RECORD + i;
    state[lane] = POSSIBLE;
    float parting1 = scalar.normalSpeed(lane, FIRST);
    float wanted1 = bounce(block, i, FIRST, parting1);
    if ((blocks.traits[block] & TWO) == 0) {
      if (wanted1 > 0) {
        applyImpulse(block, i, (wanted1 - parting1) / d[at + FIRST + INVERSE_NORMAL_MASS], 0);
        return true;
      }
      noteSpeed(lane, parting1);
      return false;
    }
    float parting2 = scalar.normalSpeed(lane, SECOND);
    float wanted2 = bounce(block, i, SECOND, parting2);
    if (wanted1 <= 0 && wanted2 <= 0) {
      noteSpeed(lane, Math.max(Math.abs(parting1), Math.abs(parting2)));
      return false;
    }
    float k1 = d[at + FIRST + INVERSE_NORMAL_MASS] / ContactPacker.DIAGONAL_SCALE;
    float k2 = d[at + SECOND + INVERSE_NORMAL_MASS] / ContactPacker.DIAGONAL_SCALE;
    float k = d[at + CROSS];
    float change1 = wanted1 - parting1;
    float change2 = wanted2 - parting2;
    float impulse1 = wanted1 > 0 ? change1 / k1 : 0;
    float impulse2 = wanted2 > 0 ? change2 / k2 : 0;
    if (wanted1 > 0 && wanted2 > 0) {
      float determinant = k1 * k2 - k * k;
      if (determinant <= SINGULAR * k1 * k2) {
        impulse1 *= 0.5f;
        impulse2 = impulse1;
      } else {
        float both1 = (k2 * change1 - k * change2) / determinant;
        float both2 = (k1 * change2 - k * change1) / determinant;
        impulse1 = both2 < 0 ? impulse1 : Math.max(both1, 0);
        impulse2 = both1 < 0 ? impulse2 : Math.max(both2, 0);
      }
    }
    applyImpulse(block, i, impulse1, impulse2);
    return true;
  }

  /** Notes how fast the surfaces of a contact meet or part. */
  private void noteSpeed(int lane, float speed) {
    if (Math.abs(speed) > threshold) {
      state[lane] |= FAST_NOW;
    }
  }

  /**
   * Returns the speed at which a point is to part, m/s; 0 if there is no impact in this substep.
   *
   * <p>The surfaces meet at the speed of now, plus what the relative acceleration a adds over the
   * gap: {@code u^2 = c^2 + 2 a s}. Where the gap is the same again after the bounce, they part at
   * {@code e^2 u^2 - 2 a s}. In symplectic Euler a velocity is that of half a substep ago, hence
   * {@code a h / 2} is added before and after. Without these terms a perfectly elastic ball would
   * lose 2 % of its height with every bounce.
   */
  private float bounce(int block, int i, int point, float parting) {
    float gap = blocks.data[block * RECORD + i + point + GAP];
    int more = block * EXTRA + i;
    float acceleration = blocks.extra[more + CLOSING_ACCELERATION];
    float closing = 0.5f * h * acceleration - parting;
    boolean closes = h * (h * acceleration - parting) > gap;
    if (!closes || !(closing > threshold)) {
      return 0;
    }
    float e = blocks.extra[more + COEFFICIENT];
    float fall = 2 * acceleration * gap;
    float square = e * e * (closing * closing + fall) - fall;
    return square > 0 ? (float) Math.sqrt(square) + 0.5f * h * acceleration : 0;
  }

  /** Applies the impulses of a blow, and the friction that goes with it. */
  private void applyImpulse(int block, int i, float impulse1, float impulse2) {
    float[] d = blocks.data;
    int lane = block * LANES + i;
    int at = block * RECORD + i;
    int p = at + FIRST;
    int q = at + SECOND;
    int a = blocks.bodyA[lane];
    int b = blocks.bodyB[lane];
    float ax = v[a + VX];
    float ay = v[a + VY];
    float aw = v[a + W];
    float bx = v[b + VX];
    float by = v[b + VY];
    float bw = v[b + W];
    float turnA = d[p + NORMAL_ARM_A] * impulse1;
    float turnB = d[p + NORMAL_ARM_B] * impulse1;
    d[p + TOTAL_NORMAL] += impulse1;
    if (impulse2 != 0) {
      turnA += d[q + NORMAL_ARM_A] * impulse2;
      turnB += d[q + NORMAL_ARM_B] * impulse2;
      d[q + TOTAL_NORMAL] += impulse2;
    }
    float wa = v[a + W] - d[at + INERTIA_A] * turnA;
    float wb = v[b + W] + d[at + INERTIA_B] * turnB;
    scalar.applyImpulse(lane, at, impulse1 + impulse2, 0, wa, wb);
    if (d[at + FRICTION] != 0) {
      int sums = block * EXTRA + i;
      solveFriction(block, i, p, sums, impulse1);
      if (impulse2 != 0) {
        solveFriction(block, i, q, sums + LANES, impulse2);
      }
    }
    if (d[at + MASS_A] != 0) {
      tell(a / STRIDE);
      bodies.countOut(a / STRIDE, v[a + VX] - ax, v[a + VY] - ay, v[a + W] - aw);
    }
    if (d[at + MASS_B] != 0) {
      tell(b / STRIDE);
      bodies.countOut(b / STRIDE, v[b + VX] - bx, v[b + VY] - by, v[b + W] - bw);
    }
  }

  /** Tells the contacts of a body that it was struck in this round. */
  private void tell(int slot) {
    for (int link = firstLink[slot]; link != NONE; link = nextLink[link]) {
      int lane = link / 2;
      state[lane] |= POSSIBLE | STRUCK;
      news[lane / LANES] = round;
    }
  }

  /**
   * Solves the friction of a blow at a point: at most mu times its impulse, and no more than stops
   * the sliding, so it only ever takes energy. It may change the normal speed; Newton's restitution
   * asked for with friction in the same equations could add energy (Kane and Levinson, "Dynamics",
   * 1985).
   */
  private void solveFriction(int block, int i, int p, int sums, float impulse) {
    float[] d = blocks.data;
    int lane = block * LANES + i;
    int at = block * RECORD + i;
    int a = blocks.bodyA[lane];
    int b = blocks.bodyB[lane];
    float dvx = v[b + VX] - v[a + VX];
    float dvy = v[b + VY] - v[a + VY];
    float tangentSpeed = dvy * d[at + NX] - dvx * d[at + NY];
    tangentSpeed += v[b + W] * d[p + TANGENT_ARM_B] - v[a + W] * d[p + TANGENT_ARM_A];
    if ((blocks.traits[block] & MOVING_SURFACE) != 0) {
      tangentSpeed += blocks.extra[block * EXTRA + i + SURFACE];
    }
    blocks.extra[sums + IMPACT_NORMAL] += impulse;
    float limit = d[at + FRICTION] * blocks.extra[sums + IMPACT_NORMAL];
    float old = blocks.extra[sums + IMPACT_TANGENT];
    float sum = Math.max(-limit, Math.min(old - d[p + TANGENT_MASS] * tangentSpeed, limit));
    float change = sum - old;
    blocks.extra[sums + IMPACT_TANGENT] = sum;
    d[p + TOTAL_TANGENT] += change;
    float wa = v[a + W] - d[at + INERTIA_A] * (d[p + TANGENT_ARM_A] * change);
    float wb = v[b + W] + d[at + INERTIA_B] * (d[p + TANGENT_ARM_B] * change);
    scalar.applyImpulse(lane, at, 0, change, wa, wb);
  }
}
