package carom.physics.dynamics.solver;

import static carom.physics.dynamics.solver.ContactBlocks.CLOSING_ACCELERATION;
import static carom.physics.dynamics.solver.ContactBlocks.EXTRA;
import static carom.physics.dynamics.solver.ContactBlocks.FIRST;
import static carom.physics.dynamics.solver.ContactBlocks.FRICTION;
import static carom.physics.dynamics.solver.ContactBlocks.INERTIA_A;
import static carom.physics.dynamics.solver.ContactBlocks.INERTIA_B;
import static carom.physics.dynamics.solver.ContactBlocks.INVERSE_NORMAL_MASS;
import static carom.physics.dynamics.solver.ContactBlocks.LANES;
import static carom.physics.dynamics.solver.ContactBlocks.MASS_A;
import static carom.physics.dynamics.solver.ContactBlocks.MASS_B;
import static carom.physics.dynamics.solver.ContactBlocks.MOVING_SURFACE;
import static carom.physics.dynamics.solver.ContactBlocks.NORMAL_ARM_A;
import static carom.physics.dynamics.solver.ContactBlocks.NORMAL_ARM_B;
import static carom.physics.dynamics.solver.ContactBlocks.NORMAL_IMPULSE;
import static carom.physics.dynamics.solver.ContactBlocks.NX;
import static carom.physics.dynamics.solver.ContactBlocks.NY;
import static carom.physics.dynamics.solver.ContactBlocks.RECORD;
import static carom.physics.dynamics.solver.ContactBlocks.RESTITUTION;
import static carom.physics.dynamics.solver.ContactBlocks.RESTITUTION_FIRST;
import static carom.physics.dynamics.solver.ContactBlocks.RESTITUTION_NORMAL;
import static carom.physics.dynamics.solver.ContactBlocks.RESTITUTION_SECOND;
import static carom.physics.dynamics.solver.ContactBlocks.RESTITUTION_TANGENT;
import static carom.physics.dynamics.solver.ContactBlocks.SECOND;
import static carom.physics.dynamics.solver.ContactBlocks.SURFACE;
import static carom.physics.dynamics.solver.ContactBlocks.TANGENT_ARM_A;
import static carom.physics.dynamics.solver.ContactBlocks.TANGENT_ARM_B;
import static carom.physics.dynamics.solver.ContactBlocks.TANGENT_IMPULSE;
import static carom.physics.dynamics.solver.ContactBlocks.TANGENT_MASS;
import static carom.physics.dynamics.solver.ContactBlocks.TOTAL_NORMAL;
import static carom.physics.dynamics.solver.ContactBlocks.TOTAL_TANGENT;
import static carom.physics.dynamics.solver.ContactBlocks.TWO;
import static carom.physics.dynamics.solver.SolverBodies.VX;
import static carom.physics.dynamics.solver.SolverBodies.VY;
import static carom.physics.dynamics.solver.SolverBodies.W;

import carom.physics.dynamics.domain.DomainPhases;

/**
 * Solves the restitution of contacts, once per step, after its substeps.
 *
 * <p>Points that came together faster than the threshold, and were pushed, part with the speed
 * decided when the step began, corrected for where they are now. Where one bounce spoils another,
 * as when a body is hit from two sides, more rounds settle it; impulses never pull. Warm starting
 * ends here, because the points fly apart.
 */
final class ContactRestitution {
  /** Rounds: a closed gas loses 2.5 % of its energy in 300 steps with one, 0.2 % with four. */
  private static final int ROUNDS = 4;

  private final ContactBlocks blocks;
  private final ScalarContacts scalar;

  // The stages, made once so that a step allocates nothing.
  private final DomainPhases.Phase solving;
  private final DomainPhases.Phase clearing;

  /** State of the bodies, {@link SolverBodies#state}. */
  private float[] v = new float[0];

  /** Length of a substep, s. */
  private float h;

  /** Solves the contacts of these blocks. */
  ContactRestitution(ContactBlocks blocks, ScalarContacts scalar) {
    this.blocks = blocks;
    this.scalar = scalar;
    solving = blocks.phase((from, to, worker) -> solveBlocks(from, to));
    clearing = blocks.phase((from, to, worker) -> clearBlocks(from, to));
  }

  /**
   * Adds the phases. The blocks must be packed.
   *
   * @param state of the bodies
   * @param h length of a substep, s
   */
  void solve(DomainPhases phases, float[] state, float h) {
    if (!any()) {
      return;
    }
    v = state;
    this.h = h;
    for (int round = 0; round < ROUNDS; round++) {
      blocks.addColours(phases, solving);
    }
    blocks.addAll(phases, clearing);
  }

  private boolean any() {
    for (int block = 0; block < blocks.count(); block++) {
      if ((blocks.traits[block] & RESTITUTION) != 0) {
        return true;
      }
    }
    return false;
  }

  private void solveBlocks(int from, int to) {
    for (int block = from; block < to; block++) {
      int end = (blocks.traits[block] & RESTITUTION) != 0 ? blocks.used[block] : 0;
      for (int i = 0; i < end; i++) {
        solve(block, i, FIRST, RESTITUTION_FIRST);
        if ((blocks.traits[block] & TWO) != 0) {
          solve(block, i, SECOND, RESTITUTION_SECOND);
        }
      }
    }
  }

  private void clearBlocks(int from, int to) {
    for (int block = from; block < to; block++) {
      int end = (blocks.traits[block] & RESTITUTION) != 0 ? blocks.used[block] : 0;
      for (int i = 0; i < end; i++) {
        clearImpulses(block, i, FIRST, RESTITUTION_FIRST);
        if ((blocks.traits[block] & TWO) != 0) {
          clearImpulses(block, i, SECOND, RESTITUTION_SECOND);
        }
      }
    }
  }

  private void clearImpulses(int block, int i, int point, int wanted) {
    int p = block * RECORD + i + point;
    if (blocks.extra[block * EXTRA + i + wanted] != 0 && blocks.data[p + TOTAL_NORMAL] != 0) {
      blocks.data[p + NORMAL_IMPULSE] = 0;
      blocks.data[p + TANGENT_IMPULSE] = 0;
    }
  }

  private void solve(int block, int i, int point, int wanted) {
    float[] d = blocks.data;
    int lane = block * LANES + i;
    int at = block * RECORD + i;
    int more = block * EXTRA + i;
    int p = at + point;
    float wantedSpeed = blocks.extra[more + wanted];
    if (wantedSpeed == 0 || d[p + TOTAL_NORMAL] == 0) {
      return;
    }
    int a = blocks.bodyA[lane];
    int b = blocks.bodyB[lane];
    float acceleration = blocks.extra[more + CLOSING_ACCELERATION];
    float square =
        wantedSpeed * wantedSpeed
            - 2 * acceleration * scalar.gap(p, scalar.normalMotion(block, i), a, b);
    float speed = square > 0 ? (float) Math.sqrt(square) + 0.5f * h * acceleration : 0;
    float impulse =
        (Math.max(speed, 0) - scalar.normalSpeed(lane, point)) / d[p + INVERSE_NORMAL_MASS];
    impulse = Math.max(impulse, -d[p + NORMAL_IMPULSE]);
    d[p + NORMAL_IMPULSE] += impulse;
    d[p + TOTAL_NORMAL] += impulse;
    float wa = v[a + W] - d[at + INERTIA_A] * (d[p + NORMAL_ARM_A] * impulse);
    float wb = v[b + W] + d[at + INERTIA_B] * (d[p + NORMAL_ARM_B] * impulse);
    scalar.applyImpulse(lane, at, impulse, 0, wa, wb);
    if (d[at + FRICTION] != 0 && isCentral(at, p)) {
      solveFriction(block, i, p, more + wanted, impulse);
    }
  }

  /** Returns whether impulses along the normal turn neither body. */
  private boolean isCentral(int at, int p) {
    float[] d = blocks.data;
    float turnA = d[p + NORMAL_ARM_A];
    float turnB = d[p + NORMAL_ARM_B];
    float turning = d[at + INERTIA_A] * turnA * turnA + d[at + INERTIA_B] * turnB * turnB;
    return turning <= 1e-6f * (d[at + MASS_A] + d[at + MASS_B]);
  }

  /**
   * Solves the friction of the bounce: a blow of (1 + e) m v along the normal rubs with up to mu
   * times that, of which the share of m v has been had. Only where the blow goes through both
   * centres, as between discs: elsewhere friction changes the normal speed, and with Newton's
   * restitution that can add energy (Kane and Levinson, "Dynamics", 1985).
   */
  private void solveFriction(int block, int i, int p, int more, float impulse) {
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
    blocks.extra[more + RESTITUTION_NORMAL] += impulse;
    float limit = d[at + FRICTION] * Math.max(blocks.extra[more + RESTITUTION_NORMAL], 0);
    float old = blocks.extra[more + RESTITUTION_TANGENT];
    float sum = Math.max(-limit, Math.min(old - d[p + TANGENT_MASS] * tangentSpeed, limit));
    float change = sum - old;
    blocks.extra[more + RESTITUTION_TANGENT] = sum;
    d[p + TOTAL_TANGENT] += change;
    float wa = v[a + W] - d[at + INERTIA_A] * (d[p + TANGENT_ARM_A] * change);
    float wb = v[b + W] + d[at + INERTIA_B] * (d[p + TANGENT_ARM_B] * change);
    scalar.applyImpulse(lane, at, 0, change, wa, wb);
  }
}
