package carom.physics.dynamics.solver;

import static carom.physics.dynamics.domain.SolverBodies.STRIDE;
import static carom.physics.dynamics.domain.SolverBodies.VX;
import static carom.physics.dynamics.domain.SolverBodies.VY;
import static carom.physics.dynamics.domain.SolverBodies.W;
import static carom.physics.dynamics.solver.ContactBlocks.EXTRA;
import static carom.physics.dynamics.solver.ContactBlocks.FIRST;
import static carom.physics.dynamics.solver.ContactBlocks.FRICTION;
import static carom.physics.dynamics.solver.ContactBlocks.GAP;
import static carom.physics.dynamics.solver.ContactBlocks.INERTIA_A;
import static carom.physics.dynamics.solver.ContactBlocks.INERTIA_B;
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
import static carom.physics.dynamics.solver.ContactBlocks.ROLL;
import static carom.physics.dynamics.solver.ContactBlocks.ROLLING;
import static carom.physics.dynamics.solver.ContactBlocks.ROLLS;
import static carom.physics.dynamics.solver.ContactBlocks.SECOND;
import static carom.physics.dynamics.solver.ContactBlocks.SOFTNESS;
import static carom.physics.dynamics.solver.ContactBlocks.SURFACE;
import static carom.physics.dynamics.solver.ContactBlocks.TANGENT_ARM_A;
import static carom.physics.dynamics.solver.ContactBlocks.TANGENT_ARM_B;
import static carom.physics.dynamics.solver.ContactBlocks.TANGENT_IMPULSE;
import static carom.physics.dynamics.solver.ContactBlocks.TWO;

import carom.physics.dynamics.contact.ContactKey;
import carom.physics.dynamics.contact.ContactTable;
import carom.physics.dynamics.domain.SolverBodies;
import carom.physics.dynamics.jointtree.TreeResponse;

/**
 * Solves the contacts of bodies of joint trees. A visit does what {@link ScalarContacts} does, but
 * a body is as heavy as what it has to move while its joints hold ({@link TreeResponse}), and an
 * impulse acts on its whole tree.
 *
 * <p>Visited like others, such a contact would stop or push a link of 1 kg where 1,000 kg hang on
 * it. Its joints would have to draw the link back in the next substep, and their stiffness against
 * turning would take that blow for one of a heavier link: chains over an edge gained energy.
 *
 * <p>Contacts are swept several times, because those of one tree push each other; then the tree is
 * solved once with all that they exerted. Before bodies move that comes after all other contacts,
 * and after they have moved, too: a tree is the ground of what lies on it. Springs are as stiff for
 * the masses of the response as others are for those of bodies.
 *
 * <p>Where both bodies are in one tree, each is taken to answer by itself. Together they answer by
 * at most twice the sum, so visits still converge.
 */
public final class TreeContacts {
  /**
   * Visits of each contact per stage. A chain of 16 links with 1,000 kg that lies over an edge, in
   * 81 places, gains up to 2.4 % of its drop with four, nothing with sixteen.
   */
  private static final int SWEEPS = 16;

  /**
   * Part of the pieces' own inverse masses that a response has at least. A point under a hinge
   * can't be moved at all, and would ask for any impulse.
   */
  private static final double LEAST_RESPONSE = 1e-4;

  private final ContactSolver solver;
  private final ContactBlocks blocks;
  private final ScalarContacts scalar;

  /** Number of contacts. */
  private int count;

  /** Per contact: its lane. */
  private int[] lane = new int[0];

  /** Per contact: the number of its body A in the trees, -1 if that is in none. */
  private int[] numberA = new int[0];

  /** Per contact: the number of its body B. */
  private int[] numberB = new int[0];

  private TreeResponse response;
  private SolverBodies bodies;
  private float[] v = new float[0];

  /** Velocity and response of body A of the visited contact, as {@link ResponseRow} has them. */
  private final double[] a = new double[9];

  /** Velocity and response of its body B. */
  private final double[] b = new double[9];

  /** Least inverse effective mass of its rows, 1/kg. */
  private double least;

  private final ResponseRow normal1 = new ResponseRow(a, b);
  private final ResponseRow normal2 = new ResponseRow(a, b);
  private final ResponseRow tangent1 = new ResponseRow(a, b);
  private final ResponseRow tangent2 = new ResponseRow(a, b);
  private final ResponseRow turn = new ResponseRow(a, b);

  /** Solves the contacts of trees among those of these blocks. */
  TreeContacts(ContactSolver solver, ContactBlocks blocks, ScalarContacts scalar) {
    this.solver = solver;
    this.blocks = blocks;
    this.scalar = scalar;
  }

  /** Begins a step: finds the contacts, and tells which bodies they act on. */
  void begin(ContactTable t, TreeResponse trees, SolverBodies solverBodies) {
    response = trees;
    bodies = solverBodies;
    v = solverBodies.state;
    count = 0;
    int from = blocks.startOfTrees();
    int to = blocks.endOfTrees();
    if (lane.length < (to - from) * LANES) {
      lane = new int[2 * (to - from) * LANES];
      numberA = new int[lane.length];
      numberB = new int[lane.length];
    }
    for (int block = from; block < to; block++) {
      for (int i = 0; i < blocks.used[block]; i++) {
        long key = t.key[blocks.row[block * LANES + i]];
        lane[count] = block * LANES + i;
        numberA[count] = note(ContactKey.bodyA(key));
        numberB[count++] = note(ContactKey.bodyB(key));
      }
    }
  }

  private int note(int body) {
    int number = response.number(body);
    if (number >= 0) {
      response.touch(number);
    }
    return number;
  }

  /** Returns whether there is any. */
  public boolean any() {
    return count > 0;
  }

  /** Applies the impulses of the last substep, or the last step. The joints of trees come next. */
  public void warmStart() {
    if (count > 0) {
      response.beginWalk();
    }
    for (int k = 0; k < count; k++) {
      int block = lane[k] / LANES;
      int i = lane[k] % LANES;
      int at = block * RECORD + i;
      rows(block, i);
      float[] d = blocks.data;
      normal1.sum = d[at + FIRST + NORMAL_IMPULSE];
      tangent1.sum = d[at + FIRST + TANGENT_IMPULSE];
      if ((blocks.traits[block] & TWO) != 0) {
        normal2.sum = d[at + SECOND + NORMAL_IMPULSE];
        tangent2.sum = d[at + SECOND + TANGENT_IMPULSE];
      }
      if ((blocks.traits[block] & ROLLS) != 0) {
        turn.sum = blocks.extra[block * EXTRA + i + ROLL];
      }
      push(k, numberA[k], blocks.bodyA[lane[k]], MASS_A, INERTIA_A, -1);
      push(k, numberB[k], blocks.bodyB[lane[k]], MASS_B, INERTIA_B, 1);
    }
  }

  private void push(int k, int number, int offset, int mass, int inertia, double sign) {
    double x = sign * sumX();
    double y = sign * sumY();
    double w = sign * (sign < 0 ? sumTurnA() : sumTurnB());
    if (number >= 0) {
      response.start(number, x, y, w);
      return;
    }
    float[] d = blocks.data;
    int at = lane[k] / LANES * RECORD + lane[k] % LANES;
    if (d[at + mass] != 0) {
      bodies.locks.apply(offset / STRIDE, d[at + mass], (float) x, (float) y, v, offset + VX);
      v[offset + W] += d[at + inertia] * (float) w;
    }
  }

  /** Visits contacts before bodies move, with their springs. Their trees have to settle next. */
  public void applyBiasedImpulses() {
    if (count > 0) {
      response.beginWalk();
      for (int sweep = 0; sweep < SWEEPS; sweep++) {
        for (int k = 0; k < count; k++) {
          bias(k);
        }
      }
    }
  }

  /** Visits contacts after bodies have moved, rigid. Their trees have to absorb it next. */
  public void relax() {
    response.beginWalk();
    for (int k = 0; k < count; k++) {
      measureGaps(lane[k] / LANES, lane[k] % LANES);
    }
    for (int sweep = 0; sweep < SWEEPS; sweep++) {
      for (int k = 0; k < count; k++) {
        relax(k);
      }
    }
    for (int k = 0; k < count; k++) {
      int at = lane[k] / LANES * RECORD + lane[k] % LANES;
      scalar.addToTotals(at + FIRST);
      if ((blocks.traits[lane[k] / LANES] & TWO) != 0) {
        scalar.addToTotals(at + SECOND);
      }
    }
  }

  /** Loads both bodies of a contact. */
  private void open(int k) {
    int at = lane[k] / LANES * RECORD + lane[k] % LANES;
    load(numberA[k], blocks.bodyA[lane[k]], at + MASS_A, at + INERTIA_A, a);
    load(numberB[k], blocks.bodyB[lane[k]], at + MASS_B, at + INERTIA_B, b);
    least = LEAST_RESPONSE * (blocks.data[at + MASS_A] + blocks.data[at + MASS_B]);
  }

  private void load(int number, int offset, int mass, int inertia, double[] into) {
    if (number >= 0) {
      response.goTo(number);
      response.load(number, into);
      return;
    }
    into[0] = v[offset + VX];
    into[1] = v[offset + VY];
    into[2] = v[offset + W];
    float m = blocks.data[mass];
    into[3] = bodies.locks.inverseMasses(offset / STRIDE, m, 0, 0, 1, 0);
    into[4] = 0;
    into[5] = 0;
    into[6] = bodies.locks.inverseMasses(offset / STRIDE, m, 0, 0, 0, 1);
    into[7] = 0;
    into[8] = blocks.data[inertia];
  }

  /** Makes the rows of a contact, with nothing summed up. */
  private void rows(int block, int i) {
    float[] d = blocks.data;
    int at = block * RECORD + i;
    double nx = d[at + NX];
    double ny = d[at + NY];
    int p = at + FIRST;
    normal1.set(nx, ny, d[p + NORMAL_ARM_A], d[p + NORMAL_ARM_B]);
    tangent1.set(-ny, nx, d[p + TANGENT_ARM_A], d[p + TANGENT_ARM_B]);
    normal2.sum = 0;
    tangent2.sum = 0;
    turn.sum = 0;
    if ((blocks.traits[block] & TWO) != 0) {
      p = at + SECOND;
      normal2.set(nx, ny, d[p + NORMAL_ARM_A], d[p + NORMAL_ARM_B]);
      tangent2.set(-ny, nx, d[p + TANGENT_ARM_A], d[p + TANGENT_ARM_B]);
    }
    if ((blocks.traits[block] & ROLLS) != 0) {
      turn.set(0, 0, 1, 1);
    }
  }

  private double sumX() {
    return normal1.x * (normal1.sum + normal2.sum) + tangent1.x * (tangent1.sum + tangent2.sum);
  }

  private double sumY() {
    return normal1.y * (normal1.sum + normal2.sum) + tangent1.y * (tangent1.sum + tangent2.sum);
  }

  private double sumTurnA() {
    return normal1.armA * normal1.sum
        + normal2.armA * normal2.sum
        + tangent1.armA * tangent1.sum
        + tangent2.armA * tangent2.sum
        + turn.sum;
  }

  private double sumTurnB() {
    return normal1.armB * normal1.sum
        + normal2.armB * normal2.sum
        + tangent1.armB * tangent1.sum
        + tangent2.armB * tangent2.sum
        + turn.sum;
  }

  /** Gives the bodies what the rows have summed up. */
  private void close(int k) {
    int at = lane[k] / LANES * RECORD + lane[k] % LANES;
    give(numberB[k], blocks.bodyB[lane[k]], at + MASS_B, b, 1);
    give(numberA[k], blocks.bodyA[lane[k]], at + MASS_A, a, -1);
  }

  private void give(int number, int offset, int mass, double[] velocity, double sign) {
    if (number >= 0) {
      response.goTo(number);
      double w = sign < 0 ? sumTurnA() : sumTurnB();
      response.apply(number, sign * sumX(), sign * sumY(), sign * w);
    } else if (blocks.data[mass] != 0) {
      v[offset + VX] = (float) velocity[0];
      v[offset + VY] = (float) velocity[1];
      v[offset + W] = (float) velocity[2];
    }
  }

  private void bias(int k) {
    int block = lane[k] / LANES;
    int i = lane[k] % LANES;
    float[] d = blocks.data;
    int at = block * RECORD + i;
    int trait = blocks.traits[block];
    open(k);
    rows(block, i);
    int p = at + FIRST;
    int q = at + SECOND;
    if ((trait & ROLLS) != 0) {
      roll(block, i);
    }
    friction(block, i, p, tangent1);
    if ((trait & TWO) != 0) {
      friction(block, i, q, tangent2);
    }
    double nx = normal1.x;
    double ny = normal1.y;
    double masses = nx * nx * (a[3] + b[3]) + 2 * nx * ny * (a[4] + b[4]) + ny * ny * (a[6] + b[6]);
    double softness = solver.soft[trait & SOFTNESS] * masses;
    float rate = solver.biasRate[trait & SOFTNESS];
    float gap = d[p + GAP];
    double bias1 = scalar.bias(block, i, FIRST, gap, rate);
    if ((trait & TWO) == 0) {
      normal(p, bias1, gap > 0 ? 0 : softness);
    } else {
      float gap2 = d[q + GAP];
      double bias2 = scalar.bias(block, i, SECOND, gap2, rate);
      double soft1 = gap > 0 ? 0 : softness;
      double soft2 = gap2 > 0 ? 0 : softness;
      double cross = gap > 0 || gap2 > 0 ? 0 : softness * ContactSolver.COUPLING;
      normals(p, q, bias1, bias2, soft1, soft2, cross);
    }
    close(k);
  }

  private void measureGaps(int block, int i) {
    float[] d = blocks.data;
    int at = block * RECORD + i;
    int o = block * LANES + i;
    float motion = scalar.normalMotion(block, i);
    d[at + FIRST + GAP] = scalar.gap(at + FIRST, motion, blocks.bodyA[o], blocks.bodyB[o]);
    if ((blocks.traits[block] & TWO) != 0) {
      d[at + SECOND + GAP] = scalar.gap(at + SECOND, motion, blocks.bodyA[o], blocks.bodyB[o]);
    }
  }

  private void relax(int k) {
    int block = lane[k] / LANES;
    int i = lane[k] % LANES;
    float[] d = blocks.data;
    int at = block * RECORD + i;
    int trait = blocks.traits[block];
    open(k);
    rows(block, i);
    int p = at + FIRST;
    int q = at + SECOND;
    double bias1 = scalar.closing(block, i, FIRST, d[p + GAP]);
    if ((trait & TWO) == 0) {
      normal(p, bias1, 0);
    } else {
      double bias2 = scalar.closing(block, i, SECOND, d[q + GAP]);
      normals(p, q, bias1, bias2, 0, 0, 0);
    }
    friction(block, i, p, tangent1);
    if ((trait & TWO) != 0) {
      friction(block, i, q, tangent2);
    }
    if ((trait & ROLLS) != 0) {
      roll(block, i);
    }
    close(k);
  }

  private void normal(int p, double bias, double soft) {
    float[] d = blocks.data;
    double old = d[p + NORMAL_IMPULSE];
    double inverseMass = normal1.by(normal1) + least;
    double q = normal1.speed() + bias - inverseMass * old;
    double sum = q < 0 && inverseMass > 0 ? -q / (inverseMass + soft) : 0;
    d[p + NORMAL_IMPULSE] = (float) sum;
    normal1.apply(sum - old);
  }

  private void normals(
      int p, int q, double bias1, double bias2, double soft1, double soft2, double softCross) {
    float[] d = blocks.data;
    double old1 = d[p + NORMAL_IMPULSE];
    double old2 = d[q + NORMAL_IMPULSE];
    double k1 = normal1.by(normal1) * ContactPacker.DIAGONAL_SCALE + least;
    double k2 = normal2.by(normal2) * ContactPacker.DIAGONAL_SCALE + least;
    double k = normal1.by(normal2);
    double q1 = normal1.speed() + bias1 - k1 * old1 - k * old2;
    double q2 = normal2.speed() + bias2 - k2 * old2 - k * old1;
    k1 += soft1;
    k2 += soft2;
    k += softCross;
    double scale = 1 / (k1 * k2 - k * k);
    double sum1 = (k * q2 - k2 * q1) * scale;
    double sum2 = (k * q1 - k1 * q2) * scale;
    if (!(sum1 >= 0) || !(sum2 >= 0)) {
      sum1 = q1 < 0 ? -q1 / k1 : 0;
      sum2 = 0;
      if (q2 + k * sum1 < 0) {
        sum1 = 0;
        sum2 = q2 < 0 ? -q2 / k2 : 0;
      }
    }
    d[p + NORMAL_IMPULSE] = (float) sum1;
    d[q + NORMAL_IMPULSE] = (float) sum2;
    normal1.apply(sum1 - old1);
    normal2.apply(sum2 - old2);
  }

  private void friction(int block, int i, int p, ResponseRow row) {
    float[] d = blocks.data;
    double limit = d[block * RECORD + i + FRICTION] * d[p + NORMAL_IMPULSE];
    double old = d[p + TANGENT_IMPULSE];
    double speed = row.speed();
    if ((blocks.traits[block] & MOVING_SURFACE) != 0) {
      speed += blocks.extra[block * EXTRA + i + SURFACE];
    }
    double inverseMass = row.by(row) + least;
    double sum = clamp(old - speed / inverseMass, limit);
    d[p + TANGENT_IMPULSE] = (float) sum;
    row.apply(sum - old);
  }

  private void roll(int block, int i) {
    int at = block * RECORD + i;
    int more = block * EXTRA + i;
    double load = blocks.data[at + FIRST + NORMAL_IMPULSE];
    if ((blocks.traits[block] & TWO) != 0) {
      load += blocks.data[at + SECOND + NORMAL_IMPULSE];
    }
    double limit = blocks.extra[more + ROLLING] * load;
    double old = blocks.extra[more + ROLL];
    double inverse = turn.by(turn);
    double sum = inverse > 0 ? clamp(old - turn.speed() / inverse, limit) : 0;
    blocks.extra[more + ROLL] = (float) sum;
    turn.apply(sum - old);
  }

  /** Returns a value within a limit, the limit itself for what isn't a number. */
  private static double clamp(double value, double limit) {
    double most = value < limit ? value : limit;
    return most > -limit ? most : -limit;
  }
}
