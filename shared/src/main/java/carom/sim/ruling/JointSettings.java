package carom.sim.ruling;

import carom.physics.Joint;
import carom.physics.JointType;

/**
 * The settings of a joint that a game may change while it exists, as ints: which of motor, limits
 * and spring there are, and their numbers by raw bits. An angle of a target isn't among them.
 * Stateless.
 */
final class JointSettings {
  private static final int FLAGS = 0;
  private static final int MOTOR_SPEED = 1;
  private static final int MOTOR_MAX = 2;
  private static final int LOWER = 3;
  private static final int UPPER = 4;
  private static final int HERTZ = 5;
  private static final int DAMPING = 6;
  private static final int REST = 7;
  private static final int TARGET_X = 8;
  private static final int TARGET_Y = 9;

  /** Number of ints. */
  static final int INTS = 10;

  private static final int DRIVEN = 1;
  private static final int LIMITED = 2;
  private static final int SPRUNG = 4;

  private JointSettings() {}

  /** Reads the settings of a joint to a place of an array. */
  static void read(Joint<?> joint, int[] to, int at) {
    to[at + FLAGS] =
        (joint.isDriven() ? DRIVEN : 0)
            | (joint.isLimited() ? LIMITED : 0)
            | (joint.isSprung() ? SPRUNG : 0);
    to[at + MOTOR_SPEED] = bits(joint.motorSpeed());
    to[at + MOTOR_MAX] = bits(joint.motorMax());
    to[at + LOWER] = bits(joint.lower());
    to[at + UPPER] = bits(joint.upper());
    to[at + HERTZ] = bits(joint.springHertz());
    to[at + DAMPING] = bits(joint.springDamping());
    to[at + REST] = bits(joint.rest());
    boolean hasTarget = joint.type() == JointType.MOTOR || joint.type() == JointType.MOUSE;
    to[at + TARGET_X] = hasTarget ? bits(joint.targetX()) : 0;
    to[at + TARGET_Y] = hasTarget ? bits(joint.targetY()) : 0;
  }

  /** Returns whether a number can be told: all but the flags must be finite. */
  static boolean isSane(int setting, int bits) {
    return setting < INTS
        && (setting == FLAGS || Math.abs(Float.intBitsToFloat(bits)) < Float.POSITIVE_INFINITY);
  }

  /**
   * Changes the settings of a joint as a game would.
   *
   * @param mask bit i says that setting i changes
   * @param to has the new settings
   * @param at where they begin
   * @param scratch room for {@link #INTS} ints
   * @throws IllegalArgumentException if a number is out of its range
   * @throws IllegalStateException if joints of this type don't have such a setting
   */
  static void change(Joint<?> joint, int mask, int[] to, int at, int[] scratch) {
    read(joint, scratch, 0);
    for (int i = 0; i < INTS; i++) {
      if ((mask & 1 << i) != 0) {
        scratch[i] = to[at + i];
      }
    }
    if ((mask & (1 << MOTOR_SPEED | 1 << MOTOR_MAX)) != 0
        || (scratch[FLAGS] & DRIVEN) != 0 != joint.isDriven()) {
      motor(joint, scratch);
    }
    if ((mask & (1 << LOWER | 1 << UPPER)) != 0
        || (scratch[FLAGS] & LIMITED) != 0 != joint.isLimited()) {
      limits(joint, scratch);
    }
    if ((mask & (1 << HERTZ | 1 << DAMPING)) != 0
        || (scratch[FLAGS] & SPRUNG) != 0 != joint.isSprung()) {
      spring(joint, scratch);
    }
    if ((mask & 1 << REST) != 0) {
      joint.setRest(number(scratch, REST));
    }
    if ((mask & (1 << TARGET_X | 1 << TARGET_Y)) != 0) {
      joint.setTarget(number(scratch, TARGET_X), number(scratch, TARGET_Y));
    }
  }

  private static void motor(Joint<?> joint, int[] settings) {
    joint.setMotor(number(settings, MOTOR_SPEED), number(settings, MOTOR_MAX));
    if ((settings[FLAGS] & DRIVEN) == 0) {
      joint.stopMotor();
    }
  }

  private static void limits(Joint<?> joint, int[] settings) {
    joint.setLimits(number(settings, LOWER), number(settings, UPPER));
    if ((settings[FLAGS] & LIMITED) == 0) {
      joint.removeLimits();
    }
  }

  private static void spring(Joint<?> joint, int[] settings) {
    joint.setSpring(number(settings, HERTZ), number(settings, DAMPING));
    if ((settings[FLAGS] & SPRUNG) == 0 && joint.isSprung()) {
      joint.removeSpring();
    }
  }

  private static float number(int[] settings, int at) {
    return Float.intBitsToFloat(settings[at]);
  }

  private static int bits(float value) {
    return Float.floatToRawIntBits(value);
  }
}
