package carom.physics.dynamics.solver;

import static carom.physics.dynamics.solver.ContactBlocks.BOUNCED;
import static carom.physics.dynamics.solver.ContactBlocks.BOUNCES;
import static carom.physics.dynamics.solver.ContactBlocks.BOUNCE_FIRST;
import static carom.physics.dynamics.solver.ContactBlocks.BOUNCE_SECOND;
import static carom.physics.dynamics.solver.ContactBlocks.EXTRA;
import static carom.physics.dynamics.solver.ContactBlocks.FIRST;
import static carom.physics.dynamics.solver.ContactBlocks.FRICTION;
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
import static carom.physics.dynamics.solver.ContactBlocks.PULL;
import static carom.physics.dynamics.solver.ContactBlocks.RECORD;
import static carom.physics.dynamics.solver.ContactBlocks.RUBBED;
import static carom.physics.dynamics.solver.ContactBlocks.SECOND;
import static carom.physics.dynamics.solver.ContactBlocks.SLIDE;
import static carom.physics.dynamics.solver.ContactBlocks.SURFACE;
import static carom.physics.dynamics.solver.ContactBlocks.TANGENT;
import static carom.physics.dynamics.solver.ContactBlocks.TANGENT_ARM_A;
import static carom.physics.dynamics.solver.ContactBlocks.TANGENT_ARM_B;
import static carom.physics.dynamics.solver.ContactBlocks.TANGENT_MASS;
import static carom.physics.dynamics.solver.ContactBlocks.TOTAL;
import static carom.physics.dynamics.solver.ContactBlocks.TWO;
import static carom.physics.dynamics.solver.ContactBlocks.YIELD;
import static carom.physics.dynamics.solver.SolverBodies.VX;
import static carom.physics.dynamics.solver.SolverBodies.VY;
import static carom.physics.dynamics.solver.SolverBodies.W;

import carom.physics.dynamics.parallel.DomainPhases;

/**
 * Restitution of contacts, once per step, after its substeps.
 *
 * <p>Points that came together faster than the threshold, and were pushed, part with the speed
 * decided when the step began, corrected for where they are now. Where one bounce spoils another,
 * as when a body is hit from two sides, more rounds settle it; impulses never pull. Warm-start
 * impulses end here, as the points fly apart.
 */
final class ContactRestitution {
  /** A closed gas loses 2.5 % of its energy in 300 steps with one round, 0.2 % with four. */
  private static final int BOUNCE_ROUNDS = 4;

  private final ContactBlocks blocks;

  // The stages, made once so that a step allocates nothing.
  private final DomainPhases.Phase bouncing;
  private final DomainPhases.Phase ending;

  private float h;

  /** Has the contacts of these blocks bounce. */
  ContactRestitution(ContactBlocks blocks) {
    this.blocks = blocks;
    bouncing = blocks.phase((from, to, worker) -> bounceBlocks(from, to));
    ending = blocks.phase((from, to, worker) -> endBounces(from, to));
  }

  /** Adds: all bounce. The blocks must be packed; the substep's length in s. */
  void solve(DomainPhases phases, float h) {
    if (!any()) {
      return;
    }
    this.h = h;
    for (int round = 0; round < BOUNCE_ROUNDS; round++) {
      blocks.addColours(phases, bouncing);
    }
    blocks.addAll(phases, ending);
  }

  private boolean any() {
    for (int block = 0; block < blocks.count(); block++) {
      if ((blocks.traits[block] & BOUNCES) != 0) {
        return true;
      }
    }
    return false;
  }

  private void bounceBlocks(int from, int to) {
    for (int block = from; block < to; block++) {
      int end = (blocks.traits[block] & BOUNCES) != 0 ? blocks.used[block] : 0;
      for (int i = 0; i < end; i++) {
        bounce(block, i, FIRST, BOUNCE_FIRST);
        if ((blocks.traits[block] & TWO) != 0) {
          bounce(block, i, SECOND, BOUNCE_SECOND);
        }
      }
    }
  }

  private void endBounces(int from, int to) {
    for (int block = from; block < to; block++) {
      int end = (blocks.traits[block] & BOUNCES) != 0 ? blocks.used[block] : 0;
      for (int i = 0; i < end; i++) {
        endBounce(block, i, FIRST, BOUNCE_FIRST);
        if ((blocks.traits[block] & TWO) != 0) {
          endBounce(block, i, SECOND, BOUNCE_SECOND);
        }
      }
    }
  }

  private void endBounce(int block, int i, int point, int wanted) {
    int p = block * RECORD + i + point;
    if (blocks.extra[block * EXTRA + i + wanted] != 0 && blocks.data[p + TOTAL] != 0) {
      blocks.data[p + NORMAL] = 0;
      blocks.data[p + TANGENT] = 0;
    }
  }

  private void bounce(int block, int i, int point, int wanted) {
    float[] d = blocks.data;
    int lane = block * LANES + i;
    int at = block * RECORD + i;
    int more = block * EXTRA + i;
    int p = at + point;
    float bounce = blocks.extra[more + wanted];
    if (bounce == 0 || d[p + TOTAL] == 0) {
      return;
    }
    int a = blocks.bodyA[lane];
    int b = blocks.bodyB[lane];
    float pull = blocks.extra[more + PULL];
    float square = bounce * bounce - 2 * pull * blocks.gap(p, blocks.moved(block, i), a, b);
    float speed = square > 0 ? (float) Math.sqrt(square) + 0.5f * h * pull : 0;
    float impulse = (Math.max(speed, 0) - blocks.normalSpeed(lane, point)) / d[p + YIELD];
    impulse = Math.max(impulse, -d[p + NORMAL]);
    d[p + NORMAL] += impulse;
    d[p + TOTAL] += impulse;
    float wa = blocks.v[a + W] - d[at + INERTIA_A] * (d[p + NORMAL_ARM_A] * impulse);
    float wb = blocks.v[b + W] + d[at + INERTIA_B] * (d[p + NORMAL_ARM_B] * impulse);
    blocks.give(lane, at, impulse, 0, wa, wb);
    if (d[at + FRICTION] != 0 && isCentral(at, p)) {
      rubBounce(block, i, p, more + wanted, impulse);
    }
  }

  /** Whether impulses along the normal turn neither body. */
  private boolean isCentral(int at, int p) {
    float[] d = blocks.data;
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
    float[] d = blocks.data;
    int lane = block * LANES + i;
    int at = block * RECORD + i;
    int a = blocks.bodyA[lane];
    int b = blocks.bodyB[lane];
    float dvx = blocks.v[b + VX] - blocks.v[a + VX];
    float dvy = blocks.v[b + VY] - blocks.v[a + VY];
    float slip = dvy * d[at + NX] - dvx * d[at + NY];
    slip += blocks.v[b + W] * d[p + TANGENT_ARM_B] - blocks.v[a + W] * d[p + TANGENT_ARM_A];
    if ((blocks.traits[block] & MOVING_SURFACE) != 0) {
      slip += blocks.extra[block * EXTRA + i + SURFACE];
    }
    blocks.extra[more + BOUNCED] += impulse;
    float limit = d[at + FRICTION] * Math.max(blocks.extra[more + BOUNCED], 0);
    float old = blocks.extra[more + RUBBED];
    float sum = Math.max(-limit, Math.min(old - d[p + TANGENT_MASS] * slip, limit));
    float change = sum - old;
    blocks.extra[more + RUBBED] = sum;
    d[p + SLIDE] += change;
    float wa = blocks.v[a + W] - d[at + INERTIA_A] * (d[p + TANGENT_ARM_A] * change);
    float wb = blocks.v[b + W] + d[at + INERTIA_B] * (d[p + TANGENT_ARM_B] * change);
    blocks.give(lane, at, 0, change, wa, wb);
  }
}
