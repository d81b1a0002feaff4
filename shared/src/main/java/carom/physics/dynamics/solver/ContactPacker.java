package carom.physics.dynamics.solver;

import static carom.physics.dynamics.domain.SolverBodies.STRIDE;
import static carom.physics.dynamics.solver.ContactBlocks.CLOSING_ACCELERATION;
import static carom.physics.dynamics.solver.ContactBlocks.COEFFICIENT;
import static carom.physics.dynamics.solver.ContactBlocks.CROSS;
import static carom.physics.dynamics.solver.ContactBlocks.EXTRA;
import static carom.physics.dynamics.solver.ContactBlocks.FAST;
import static carom.physics.dynamics.solver.ContactBlocks.FIRST;
import static carom.physics.dynamics.solver.ContactBlocks.FRICTION;
import static carom.physics.dynamics.solver.ContactBlocks.GAP;
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
import static carom.physics.dynamics.solver.ContactBlocks.RADIUS_A;
import static carom.physics.dynamics.solver.ContactBlocks.RADIUS_B;
import static carom.physics.dynamics.solver.ContactBlocks.RECORD;
import static carom.physics.dynamics.solver.ContactBlocks.RESTITUTION;
import static carom.physics.dynamics.solver.ContactBlocks.ROLL;
import static carom.physics.dynamics.solver.ContactBlocks.ROLLING;
import static carom.physics.dynamics.solver.ContactBlocks.ROLLS;
import static carom.physics.dynamics.solver.ContactBlocks.ROLL_MASS;
import static carom.physics.dynamics.solver.ContactBlocks.ROUNDED;
import static carom.physics.dynamics.solver.ContactBlocks.SECOND;
import static carom.physics.dynamics.solver.ContactBlocks.SEPARATION;
import static carom.physics.dynamics.solver.ContactBlocks.SURFACE;
import static carom.physics.dynamics.solver.ContactBlocks.TANGENT_ARM_A;
import static carom.physics.dynamics.solver.ContactBlocks.TANGENT_ARM_B;
import static carom.physics.dynamics.solver.ContactBlocks.TANGENT_IMPULSE;
import static carom.physics.dynamics.solver.ContactBlocks.TANGENT_MASS;
import static carom.physics.dynamics.solver.ContactBlocks.TOTAL_NORMAL;
import static carom.physics.dynamics.solver.ContactBlocks.TOTAL_TANGENT;
import static carom.physics.dynamics.solver.ContactBlocks.TWO;
import static carom.physics.dynamics.solver.ContactBlocks.WIDE;

import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.body.ShapeTable;
import carom.physics.dynamics.contact.ContactKey;
import carom.physics.dynamics.contact.ContactTable;
import carom.physics.dynamics.domain.DomainPhases;
import carom.physics.dynamics.domain.SolverBodies;
import carom.physics.settings.Settings;

/**
 * Carries contacts between the {@link ContactTable} and the blocks of the solver: what they are
 * when a step begins, and the impulses when it ends.
 */
public final class ContactPacker {
  /**
   * Factor of both diagonal entries of a pair of points, so that its matrix is never singular:
   * points in one place share the load.
   */
  public static final float DIAGONAL_SCALE = 1 + 1 / 1024f;

  /**
   * Inverse mass of two bodies that both can't move along the normal, because of locked axes: there
   * is nothing to solve, and all impulses are next to zero.
   */
  private static final float IMMOVABLE = 1e15f;

  /** Most way by which a lever arm is moved, in radii. */
  private static final float MOST_MOVE = 0.5f;

  /** Place of a point relative to A, x, until lever arms are made of it. */
  public static final int ARM_X = NORMAL_ARM_A;

  /** Place of a point relative to A, y. */
  public static final int ARM_Y = NORMAL_ARM_B;

  /** Position of B relative to A, x, in the record of the first point until then. */
  public static final int OFFSET_X = TANGENT_ARM_A;

  /** Position of B relative to A, y. */
  public static final int OFFSET_Y = TANGENT_ARM_B;

  private final ContactBlocks blocks;
  private final ScalarContacts scalar;
  private final ContactLanes lanes;
  private final ShapeTable parts;

  // The stages, made once so that a step allocates nothing.
  private final DomainPhases.Phase packing;
  private final DomainPhases.Phase storing;

  // What the step is about.
  private ContactTable table;
  private BodyStore store;
  private SolverBodies bodies;
  private int[] slotOf;
  private Settings settings;
  private float h;

  /**
   * Fills these blocks.
   *
   * @param lanes kernels for whole blocks, null for none
   * @param parts says which parts are discs
   */
  ContactPacker(ContactBlocks blocks, ScalarContacts scalar, ContactLanes lanes, ShapeTable parts) {
    this.blocks = blocks;
    this.scalar = scalar;
    this.lanes = lanes;
    this.parts = parts;
    packing = blocks.phase((from, to, worker) -> packBlocks(from, to));
    storing = blocks.phase((from, to, worker) -> storeBlocks(from, to));
  }

  /** Begins a step. */
  void begin(
      ContactTable contacts,
      BodyStore bodyStore,
      SolverBodies solverBodies,
      Settings constants,
      float substep) {
    table = contacts;
    store = bodyStore;
    bodies = solverBodies;
    slotOf = solverBodies.slotOf();
    settings = constants;
    h = substep;
  }

  /** Adds the phase that fills the blocks. */
  void pack(DomainPhases phases) {
    blocks.addAll(phases, packing);
  }

  /**
   * Fills blocks. Each block is copied together, lane by lane, before the one before it is
   * finished: vectors of numbers that were just written one by one would have to wait for them.
   */
  private void packBlocks(int from, int to) {
    for (int block = from; block < to; block++) {
      for (int i = 0; i < blocks.used[block]; i++) {
        packContact(block, i);
      }
      if (block > from) {
        finishBlock(block - 1);
      }
    }
    if (to > from) {
      finishBlock(to - 1);
    }
  }

  /** Makes lever arms and masses of what was copied, then restitution, which needs them. */
  private void finishBlock(int block) {
    int used = blocks.used[block];
    boolean two = (blocks.traits[block] & TWO) != 0;
    if (used == LANES && (blocks.traits[block] & WIDE) != 0) {
      lanes.leverArms(blocks.data, block * RECORD, two);
    } else {
      for (int i = 0; i < used; i++) {
        leverArms(block * LANES + i, two);
      }
    }
    for (int i = 0; i < used; i++) {
      int mixed = blocks.row[block * LANES + i] * ContactTable.MATERIAL;
      float restitution = table.material[mixed + ContactTable.RESTITUTION];
      if (restitution > 0) {
        packRestitution(block, i, restitution);
      }
    }
  }

  private void packContact(int block, int i) {
    ContactTable t = table;
    BodyStore b = store;
    float[] d = blocks.data;
    int lane = block * LANES + i;
    int at = block * RECORD + i;
    int r = blocks.row[lane];
    int a = ContactKey.bodyA(t.key[r]);
    int o = ContactKey.bodyB(t.key[r]);
    blocks.bodyA[lane] = slotOf[a] * STRIDE;
    blocks.bodyB[lane] = slotOf[o] * STRIDE;
    float[] c = t.contact;
    int from = r * ContactTable.CONTACT;
    float[] m = t.material;
    int mixed = r * ContactTable.MATERIAL;
    float nx = c[from + ContactTable.NX];
    float ny = c[from + ContactTable.NY];
    d[at + NX] = nx;
    d[at + NY] = ny;
    d[at + FRICTION] = m[mixed + ContactTable.FRICTION];
    if (bodies.locks.isEither(slotOf[a], slotOf[o])) {
      blocks.traits[block] &= ~WIDE;
    }
    d[at + MASS_A] = b.invMass[a];
    d[at + MASS_B] = b.invMass[o];
    d[at + INERTIA_A] = b.invInertia[a];
    d[at + INERTIA_B] = b.invInertia[o];
    d[at + FIRST + ARM_X] = c[from + ContactTable.X0];
    d[at + FIRST + ARM_Y] = c[from + ContactTable.Y0];
    d[at + FIRST + OFFSET_X] = b.x[o] - b.x[a];
    d[at + FIRST + OFFSET_Y] = b.y[o] - b.y[a];
    d[at + FIRST + SEPARATION] = c[from + ContactTable.GAP0];
    d[at + FIRST + NORMAL_IMPULSE] = c[from + ContactTable.NORMAL0];
    d[at + FIRST + TANGENT_IMPULSE] = c[from + ContactTable.TANGENT0];
    if ((blocks.traits[block] & TWO) != 0) {
      d[at + SECOND + ARM_X] = c[from + ContactTable.X1];
      d[at + SECOND + ARM_Y] = c[from + ContactTable.Y1];
      d[at + SECOND + SEPARATION] = c[from + ContactTable.GAP1];
      d[at + SECOND + NORMAL_IMPULSE] = c[from + ContactTable.NORMAL1];
      d[at + SECOND + TANGENT_IMPULSE] = c[from + ContactTable.TANGENT1];
    }
    if (m[mixed + ContactTable.SURFACE] != 0) {
      blocks.addTrait(block, MOVING_SURFACE, SURFACE, RADIUS_A);
      blocks.extra[block * EXTRA + i + SURFACE] = m[mixed + ContactTable.SURFACE];
    }
    if (m[mixed + ContactTable.ROUND_A] != 0 || m[mixed + ContactTable.ROUND_B] != 0) {
      blocks.addTrait(block, ROUNDED, RADIUS_A, ROLLING);
      blocks.extra[block * EXTRA + i + RADIUS_A] = m[mixed + ContactTable.ROUND_A];
      blocks.extra[block * EXTRA + i + RADIUS_B] = m[mixed + ContactTable.ROUND_B];
      if ((blocks.traits[block] & TWO) == 0) {
        moveArm(r, at, m[mixed + ContactTable.ROUND_A], m[mixed + ContactTable.ROUND_B]);
      }
    }
    if (m[mixed + ContactTable.ROLLING] > 0) {
      blocks.addTrait(block, ROLLS, ROLLING, CLOSING_ACCELERATION);
      float turning = b.invInertia[a] + b.invInertia[o];
      blocks.extra[block * EXTRA + i + ROLLING] = m[mixed + ContactTable.ROLLING];
      blocks.extra[block * EXTRA + i + ROLL_MASS] = turning > 0 ? 1 / turning : 0;
      blocks.extra[block * EXTRA + i + ROLL] = t.roll[r];
      blocks.traits[block] &= ~WIDE;
    }
  }

  /**
   * Moves the lever arm on the flat one of a flat and a round shape to where the round one will
   * touch it in the middle of the substeps' forces. Arms stay the same for a step; those of its
   * start would be late, and a plank on two rollers that turn inwards would swing ever wider. The
   * area of its oscillation in phase space is kept if a force that is frozen for n substeps is that
   * of {@code (n - 1) / 2} substeps later. Beside a disc what is merely rounded is flat, too.
   *
   * @param roundA radius of A's rounding, m
   * @param roundB radius of B's rounding, m
   */
  private void moveArm(int row, int at, float roundA, float roundB) {
    float[] d = blocks.data;
    int roundnessA = roundness(table.part[2 * row], roundA);
    int roundnessB = roundness(table.part[2 * row + 1], roundB);
    // What carries no load yet may be about to pass: its gap belongs to the arms of now.
    if (roundnessA == roundnessB || d[at + FIRST + NORMAL_IMPULSE] == 0) {
      return;
    }
    int a = ContactKey.bodyA(table.key[row]);
    int b = ContactKey.bodyB(table.key[row]);
    float nx = d[at + NX];
    float ny = d[at + NY];
    float x = d[at + FIRST + ARM_X];
    float y = d[at + FIRST + ARM_Y];
    boolean ofB = roundnessB > roundnessA;
    int round = ofB ? b : a;
    int flat = ofB ? a : b;
    // The middle of the rounding, seen from its body.
    float coreX = ofB ? x - d[at + FIRST + OFFSET_X] + roundB * nx : x - roundA * nx;
    float coreY = ofB ? y - d[at + FIRST + OFFSET_Y] + roundB * ny : y - roundA * ny;
    float speedX = store.vx[round] - store.w[round] * coreY - store.vx[flat];
    float speedY = store.vy[round] + store.w[round] * coreX - store.vy[flat];
    float later = 0.5f * (settings.substeps() - 1) * h;
    float most = MOST_MOVE * (roundA + roundB);
    float way = later * (speedY * nx - speedX * ny);
    way = Math.max(-most, Math.min(way, most));
    if (ofB) {
      d[at + FIRST + ARM_X] -= way * ny;
      d[at + FIRST + ARM_Y] += way * nx;
      d[at + FIRST + OFFSET_X] -= way * ny;
      d[at + FIRST + OFFSET_Y] += way * nx;
    } else {
      d[at + FIRST + OFFSET_X] += way * ny;
      d[at + FIRST + OFFSET_Y] -= way * nx;
    }
  }

  private int roundness(int part, float radius) {
    return parts.isDisc(part) ? 2 : radius > 0 ? 1 : 0;
  }

  private void leverArms(int lane, boolean two) {
    float[] d = blocks.data;
    int at = lane / LANES * RECORD + lane % LANES;
    float gapX = d[at + FIRST + OFFSET_X];
    float gapY = d[at + FIRST + OFFSET_Y];
    float along = scalar.inverseMasses(lane, at, d[at + NX], d[at + NY]);
    float across = scalar.inverseMasses(lane, at, -d[at + NY], d[at + NX]);
    leverArms(at, at + FIRST, gapX, gapY, along, across);
    if (two) {
      leverArms(at, at + SECOND, gapX, gapY, along, across);
      d[at + CROSS] = cross(at, along);
      d[at + FIRST + INVERSE_NORMAL_MASS] *= DIAGONAL_SCALE;
      d[at + SECOND + INVERSE_NORMAL_MASS] *= DIAGONAL_SCALE;
    }
  }

  private void leverArms(int at, int p, float gapX, float gapY, float along, float across) {
    float[] d = blocks.data;
    float x = d[p + ARM_X];
    float y = d[p + ARM_Y];
    float bx = x - gapX;
    float by = y - gapY;
    float nx = d[at + NX];
    float ny = d[at + NY];
    float inertiaA = d[at + INERTIA_A];
    float inertiaB = d[at + INERTIA_B];
    float normalA = x * ny - y * nx;
    float normalB = bx * ny - by * nx;
    float tangentA = x * nx + y * ny;
    float tangentB = bx * nx + by * ny;
    float kt = across + inertiaA * tangentA * tangentA + inertiaB * tangentB * tangentB;
    d[p + NORMAL_ARM_A] = normalA;
    d[p + NORMAL_ARM_B] = normalB;
    d[p + TANGENT_ARM_A] = tangentA;
    d[p + TANGENT_ARM_B] = tangentB;
    d[p + GAP] = d[p + SEPARATION];
    d[p + INVERSE_NORMAL_MASS] =
        along + inertiaA * normalA * normalA + inertiaB * normalB * normalB;
    if (d[p + INVERSE_NORMAL_MASS] == 0) {
      d[p + INVERSE_NORMAL_MASS] = IMMOVABLE;
      d[p + NORMAL_IMPULSE] = 0;
      d[p + TANGENT_IMPULSE] = 0;
    }
    d[p + TANGENT_MASS] = kt > 0 ? 1 / kt : 0;
    d[p + TOTAL_NORMAL] = 0;
    d[p + TOTAL_TANGENT] = 0;
  }

  private float cross(int at, float along) {
    float[] d = blocks.data;
    int p = at + FIRST;
    int q = at + SECOND;
    float turnA = d[p + NORMAL_ARM_A] * d[q + NORMAL_ARM_A];
    float turnB = d[p + NORMAL_ARM_B] * d[q + NORMAL_ARM_B];
    return along + d[at + INERTIA_A] * turnA + d[at + INERTIA_B] * turnB;
  }

  private void packRestitution(int block, int i, float restitution) {
    int at = block * RECORD + i;
    int lane = block * LANES + i;
    int more = block * EXTRA + i;
    int slotA = blocks.bodyA[lane] / STRIDE;
    int slotB = blocks.bodyB[lane] / STRIDE;
    float acceleration =
        (bodies.ax(slotA) - bodies.ax(slotB)) * blocks.data[at + NX]
            + (bodies.ay(slotA) - bodies.ay(slotB)) * blocks.data[at + NY];
    boolean fast =
        isFast(lane, FIRST, acceleration)
            || ((blocks.traits[block] & TWO) != 0 && isFast(lane, SECOND, acceleration));
    blocks.addTrait(block, RESTITUTION, CLOSING_ACCELERATION, EXTRA);
    blocks.extra[more + CLOSING_ACCELERATION] = acceleration;
    blocks.extra[more + COEFFICIENT] = restitution;
    blocks.extra[more + FAST] = fast ? 1 : 0;
  }

  /** Returns whether a point approaches, or parts, faster than the threshold for impacts. */
  private boolean isFast(int lane, int point, float acceleration) {
    // A velocity is that of half a substep ago.
    float closing = 0.5f * h * acceleration - scalar.normalSpeed(lane, point);
    float gap = blocks.data[lane / LANES * RECORD + lane % LANES + point + SEPARATION];
    return (gap < 0 ? Math.abs(closing) : closing) > settings.restitutionThreshold();
  }

  /** Adds the phase that hands the impulses back to the table, but for those that overflowed. */
  void store(DomainPhases phases) {
    blocks.addAll(phases, storing);
  }

  private void storeBlocks(int from, int to) {
    ContactTable t = table;
    float[] c = t.contact;
    float[] d = blocks.data;
    for (int block = from; block < to; block++) {
      for (int i = 0; i < blocks.used[block]; i++) {
        int at = block * RECORD + i;
        int r = blocks.row[block * LANES + i];
        int into = r * ContactTable.CONTACT;
        float load = d[at + FIRST + NORMAL_IMPULSE];
        c[into + ContactTable.NORMAL0] = load;
        c[into + ContactTable.TANGENT0] = d[at + FIRST + TANGENT_IMPULSE];
        c[into + ContactTable.TOTAL0] = d[at + FIRST + TOTAL_NORMAL];
        c[into + ContactTable.SLIDE0] = d[at + FIRST + TOTAL_TANGENT];
        if ((blocks.traits[block] & TWO) != 0) {
          c[into + ContactTable.NORMAL1] = d[at + SECOND + NORMAL_IMPULSE];
          c[into + ContactTable.TANGENT1] = d[at + SECOND + TANGENT_IMPULSE];
          c[into + ContactTable.TOTAL1] = d[at + SECOND + TOTAL_NORMAL];
          c[into + ContactTable.SLIDE1] = d[at + SECOND + TOTAL_TANGENT];
          load += d[at + SECOND + NORMAL_IMPULSE];
        }
        if ((blocks.traits[block] & ROLLS) != 0) {
          t.roll[r] = blocks.extra[block * EXTRA + i + ROLL];
          load += Math.abs(t.roll[r]);
        }
        if (!(load <= Float.MAX_VALUE)) {
          t.forget(r);
        }
      }
    }
  }
}
