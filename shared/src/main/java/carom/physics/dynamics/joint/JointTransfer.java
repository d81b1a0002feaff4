package carom.physics.dynamics.joint;

import carom.physics.dynamics.body.BodyStore;
import carom.physics.math.Limits;
import carom.physics.math.StateHash;
import carom.physics.rows.ExactRows;
import carom.physics.rows.JointDefRow;
import carom.physics.rows.JointRow;
import carom.physics.rows.Rows;
import java.util.Arrays;

/**
 * Reads joints of a world into {@link ExactRows}, writes such rows into it, and passes the
 * definitions of joints from world to world. One world's; allocates only to grow.
 */
public final class JointTransfer {
  private final BodyStore bodies;
  private final JointStore s;

  /** Joints found: their slots. */
  private int[] found = new int[8];

  private int foundCount;
  private int cut;

  /** A joint of no world, into which definitions are written to find what is wrong with them. */
  private final JointStore probe = new JointStore();

  /** Makes the transfer of a world. */
  public JointTransfer(BodyStore bodies, JointStore joints) {
    this.bodies = bodies;
    s = joints;
    probe.allocate(JointStore.REVOLUTE, -1, -1);
  }

  /**
   * Reads the joints of the listed bodies, except those that hold bodies that are not listed.
   *
   * @param rows receives the joints, and the number of those left out
   * @param placeOf by slot of a body: its place in the list, or negative
   */
  public void read(ExactRows rows, int[] placeOf) {
    foundCount = 0;
    cut = 0;
    for (int i = 0; i < rows.bodies().count(); i++) {
      int body = rows.slot(i);
      for (int end = s.firstEnd(body); end >= 0; end = s.nextEnd(end)) {
        find(end, placeOf);
      }
    }
    Arrays.sort(found, 0, foundCount);
    rows.joints().clear();
    for (int i = 0; i < foundCount; i++) {
      int at = rows.addJoint(found[i]);
      read(found[i], rows.joints().ints(), at, placeOf);
    }
    rows.cutJoints(cut);
  }

  /** Notes a joint that belongs to the rows, once. */
  private void find(int end, int[] placeOf) {
    int other = s.other(end);
    boolean listed = other >= 0 && placeOf[other] >= 0;
    if (!listed && other >= 0 && bodies.type[other] != BodyStore.STATIC) {
      cut++;
      return;
    }
    if (listed && (end & 1) == 1) {
      return; // A's list has it, too
    }
    if (foundCount == found.length) {
      found = Arrays.copyOf(found, 2 * foundCount);
    }
    found[foundCount++] = end >> 1;
  }

  private void read(int j, int[] row, int at, int[] placeOf) {
    row[at + JointRow.END_A] = end(s.bodyA[j], placeOf);
    row[at + JointRow.END_B] = end(s.bodyB[j], placeOf);
    row[at + JointRow.FLAGS] = s.flags[j];
    row[at + JointRow.MOTOR_SPEED] = bits(s.motorSpeed[j]);
    row[at + JointRow.MOTOR_MAX] = bits(s.motorMax[j]);
    row[at + JointRow.LOWER] = bits(s.lower[j]);
    row[at + JointRow.UPPER] = bits(s.upper[j]);
    row[at + JointRow.HERTZ] = bits(s.hertz[j]);
    row[at + JointRow.DAMPING] = bits(s.damping[j]);
    row[at + JointRow.REST] = bits(s.rest[j]);
    row[at + JointRow.ANCHOR_AX] = bits(s.anchorAx[j]);
    row[at + JointRow.ANCHOR_AY] = bits(s.anchorAy[j]);
    row[at + JointRow.REF_COS] = bits(s.refCos[j]);
    row[at + JointRow.REF_SIN] = bits(s.refSin[j]);
    row[at + JointRow.TURNS_A] = s.turnsA[j];
    row[at + JointRow.TURNS_B] = s.turnsB[j];
    row[at + JointRow.LAST_A] = bits(s.lastA[j]);
    row[at + JointRow.LAST_B] = bits(s.lastB[j]);
    row[at + JointRow.IMPULSE_X] = bits(s.impulseX[j]);
    row[at + JointRow.IMPULSE_Y] = bits(s.impulseY[j]);
    row[at + JointRow.IMPULSE_W] = bits(s.impulseW[j]);
    row[at + JointRow.SPRING_IMPULSE] = bits(s.springImpulse[j]);
    row[at + JointRow.MOTOR_IMPULSE] = bits(s.motorImpulse[j]);
    row[at + JointRow.LOWER_IMPULSE] = bits(s.lowerImpulse[j]);
    row[at + JointRow.UPPER_IMPULSE] = bits(s.upperImpulse[j]);
    row[at + JointRow.FORCE_X] = bits(s.forceX[j]);
    row[at + JointRow.FORCE_Y] = bits(s.forceY[j]);
    row[at + JointRow.TORQUE] = bits(s.torque[j]);
  }

  private static int end(int body, int[] placeOf) {
    return body < 0 ? JointRow.GROUND : placeOf[body] >= 0 ? placeOf[body] : ~body;
  }

  private static int bits(float value) {
    return Float.floatToRawIntBits(value);
  }

  /**
   * Gives joints the state of their rows. A row without a slot is left out, and so is one whose
   * joint holds other bodies. A number out of its range counts as the nearest that is in it.
   */
  public void write(ExactRows rows) {
    Rows joints = rows.joints();
    for (int i = 0; i < joints.count(); i++) {
      int j = rows.jointSlot(i);
      if (j >= 0
          && j < s.slots()
          && s.type[j] != JointStore.FREE
          && isEnd(rows, joints.get(i, JointRow.END_A), s.bodyA[j])
          && isEnd(rows, joints.get(i, JointRow.END_B), s.bodyB[j])) {
        write(j, joints.ints(), joints.at(i));
      }
    }
    if (joints.count() > 0) {
      s.coldChanged();
    }
  }

  private static boolean isEnd(ExactRows rows, int end, int body) {
    if (end >= 0) {
      return end < rows.bodies().count() && rows.slot(end) == body;
    }
    return end == JointRow.GROUND ? body < 0 : ~end == body;
  }

  private void write(int j, int[] row, int at) {
    int flags = row[at + JointRow.FLAGS] & JointRanges.CHANGEABLE_FLAGS;
    s.flags[j] = (byte) (s.flags[j] & JointStore.COLLIDE | flags);
    float speed = number(row, at + JointRow.MOTOR_SPEED);
    s.motorSpeed[j] = JointRanges.within(speed, -Limits.MAX_VELOCITY, Limits.MAX_VELOCITY);
    s.motorMax[j] = within(row, at + JointRow.MOTOR_MAX, Limits.MAX_FORCE);
    s.lower[j] = number(row, at + JointRow.LOWER);
    s.upper[j] = Math.max(s.lower[j], number(row, at + JointRow.UPPER));
    s.hertz[j] = within(row, at + JointRow.HERTZ, Limits.MAX_HERTZ);
    s.damping[j] = within(row, at + JointRow.DAMPING, Limits.MAX_DAMPING_RATIO);
    s.rest[j] = number(row, at + JointRow.REST);
    s.anchorAx[j] = number(row, at + JointRow.ANCHOR_AX);
    s.anchorAy[j] = number(row, at + JointRow.ANCHOR_AY);
    s.refCos[j] = number(row, at + JointRow.REF_COS);
    s.refSin[j] = number(row, at + JointRow.REF_SIN);
    s.turnsA[j] = row[at + JointRow.TURNS_A];
    s.turnsB[j] = row[at + JointRow.TURNS_B];
    s.lastA[j] = number(row, at + JointRow.LAST_A);
    s.lastB[j] = number(row, at + JointRow.LAST_B);
    s.impulseX[j] = number(row, at + JointRow.IMPULSE_X);
    s.impulseY[j] = number(row, at + JointRow.IMPULSE_Y);
    s.impulseW[j] = number(row, at + JointRow.IMPULSE_W);
    s.springImpulse[j] = number(row, at + JointRow.SPRING_IMPULSE);
    s.motorImpulse[j] = number(row, at + JointRow.MOTOR_IMPULSE);
    s.lowerImpulse[j] = number(row, at + JointRow.LOWER_IMPULSE);
    s.upperImpulse[j] = number(row, at + JointRow.UPPER_IMPULSE);
    s.forceX[j] = number(row, at + JointRow.FORCE_X);
    s.forceY[j] = number(row, at + JointRow.FORCE_Y);
    s.torque[j] = number(row, at + JointRow.TORQUE);
  }

  private static float number(int[] row, int at) {
    return JointRanges.finite(Float.intBitsToFloat(row[at]));
  }

  private static float within(int[] row, int at, float most) {
    return JointRanges.within(Float.intBitsToFloat(row[at]), 0, most);
  }

  /**
   * Reads what a joint was made with, or its present settings where they have changed since.
   *
   * @param j a slot in use
   * @param to receives {@link JointDefRow#INTS} ints
   * @param at where they begin
   */
  public void readDefinition(int j, int[] to, int at) {
    to[at + JointDefRow.TYPE] = s.type[j];
    to[at + JointDefRow.FLAGS] = s.flags[j];
    for (int f = 0; f < JointStore.HOT; f++) {
      to[at + JointDefRow.FLOATS + f] = bits(s.floats[f][j]);
    }
    to[at + JointDefRow.RATIO] = bits(s.ratio[j]);
    to[at + JointDefRow.BASE_AX] = bits(s.baseAx[j]);
    to[at + JointDefRow.BASE_AY] = bits(s.baseAy[j]);
    to[at + JointDefRow.BASE_BX] = bits(s.baseBx[j]);
    to[at + JointDefRow.BASE_BY] = bits(s.baseBy[j]);
  }

  /**
   * Returns what is wrong with a definition, which may come from anywhere.
   *
   * @param from holds the definition
   * @param at where it begins
   * @return null if a joint may be made of it
   */
  public String problem(int[] from, int at) {
    if ((from[at + JointDefRow.FLAGS] & ~JointRanges.FLAGS) != 0) {
      return "flags=" + from[at + JointDefRow.FLAGS] + " of a joint";
    }
    for (int i = JointDefRow.FLOATS; i < JointDefRow.INTS; i++) {
      float value = Float.intBitsToFloat(from[at + i]);
      boolean unbounded = i == JointDefRow.BREAK_FORCE || i == JointDefRow.BREAK_TORQUE;
      if (!(Math.abs(value) <= (unbounded ? Float.POSITIVE_INFINITY : BodyStore.MOST))) {
        return "number=" + value + " in field=" + i + " of a joint";
      }
    }
    write(probe, 0, from, at);
    return JointRanges.problem(probe, 0);
  }

  /**
   * Fills in a new joint from a definition.
   *
   * @param j a joint of the definition's type
   * @param from holds the definition, which has no {@link #problem}
   * @param at where it begins
   */
  public void writeDefinition(int j, int[] from, int at) {
    write(s, j, from, at);
    s.coldChanged();
  }

  private static void write(JointStore s, int j, int[] from, int at) {
    s.flags[j] = (byte) from[at + JointDefRow.FLAGS];
    for (int f = 0; f < JointStore.HOT; f++) {
      s.floats[f][j] = Float.intBitsToFloat(from[at + JointDefRow.FLOATS + f]);
    }
    s.ratio[j] = Float.intBitsToFloat(from[at + JointDefRow.RATIO]);
    s.baseAx[j] = Float.intBitsToFloat(from[at + JointDefRow.BASE_AX]);
    s.baseAy[j] = Float.intBitsToFloat(from[at + JointDefRow.BASE_AY]);
    s.baseBx[j] = Float.intBitsToFloat(from[at + JointDefRow.BASE_BX]);
    s.baseBy[j] = Float.intBitsToFloat(from[at + JointDefRow.BASE_BY]);
  }

  /** Returns a hash of which joints a body has, and of what a game may change about them. */
  public long stamp(int body) {
    long h = StateHash.SEED;
    for (int end = s.firstEnd(body); end >= 0; end = s.nextEnd(end)) {
      int j = end >> 1;
      h = StateHash.mix(h, (long) s.generation(j) << 32 | j << 8 | s.flags[j]);
      h = StateHash.mix(h, s.motorSpeed[j], s.motorMax[j]);
      h = StateHash.mix(h, s.lower[j], s.upper[j]);
      h = StateHash.mix(h, s.hertz[j], s.damping[j]);
      h = StateHash.mix(h, s.rest[j], s.refCos[j]);
      h = StateHash.mix(h, s.anchorAx[j], s.anchorAy[j]);
      h = StateHash.mix(h, s.refSin[j], 0f);
    }
    return h;
  }

  /** Returns whether a number is one of the types of joints. */
  public static boolean isType(int type) {
    return type >= JointStore.REVOLUTE && type <= JointStore.PULLEY;
  }

  /** Returns whether joints of a type may hold a body to the world instead of another body. */
  public static boolean mayBeGrounded(int type) {
    return type < JointStore.GEAR;
  }
}
