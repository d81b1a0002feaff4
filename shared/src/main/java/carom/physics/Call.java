package carom.physics;

import carom.physics.rows.BodyRow;

/**
 * The calls that a {@link WorldRecorder} records: each way in which a program changes a world. The
 * layout of a call's arguments is declared here once; recorder and replay follow it.
 *
 * <p>A layout has a letter for each argument: {@code b} body, {@code j} joint, {@code i} whole
 * number, {@code f} float, {@code r} a body's row, {@code v} an object that {@link CallValues}
 * passes.
 */
enum Call {
  /** The world makes a step; f: its length. */
  STEP("f"),
  /** A body is created; v: its definition. */
  CREATE_BODY("v"),
  /** A joint is created; bodies (-1 for the world) and v: its definition. */
  CREATE_JOINT("iiv"),
  /** An edit of {@link EditQueue}; which, slot, and v: its value. */
  EDIT("iiv"),
  /** All joints are destroyed. */
  DESTROY_JOINTS(""),
  /** {@link World#sortFreeBodies}. */
  SORT_FREE_BODIES(""),
  /** The constants change; v: the new ones. */
  REDEFINE("v"),
  /** Another state is taken over: {@link World#restore} or {@link World#writeRows}; v: it. */
  STATE("v"),
  /** The listeners change; i: 1 for collisions, 2 for joints, added up. */
  LISTENERS("i"),
  /** A listener refuses a contact. */
  REFUSE_CONTACT(""),
  /** A listener sets a number of its contact; i: which, f: the number. */
  SET_CONTACT("if"),
  /** The collision filter changes; i: 1 if there is one. */
  COLLISION_FILTER("i"),
  /** The filter's answer about two shapes is no, and was yes; body, shape, body, shape. */
  REFUSE_PAIR("iiii"),
  /** The filter's answer about two shapes is yes, and was no. */
  ALLOW_PAIR("iiii"),
  /** {@link Body#wake}. */
  WAKE("b"),
  /** {@link Body#sleep}. */
  SLEEP("b"),
  /** {@link Body#setSleepAllowed}. */
  SET_SLEEP_ALLOWED("bi"),
  /** {@link Body#setSleepSpeed}. */
  SET_SLEEP_SPEED("bf"),
  /** {@link Body#setPose}. */
  SET_POSE("bffff"),
  /** {@link Body#setCenterPose}. */
  SET_CENTER_POSE("bffff"),
  /** {@link Body#setVelocity}. */
  SET_VELOCITY("bff"),
  /** {@link Body#setAngularVelocity}. */
  SET_ANGULAR_VELOCITY("bf"),
  /** {@link Body#applyForce(float, float)}. */
  APPLY_FORCE("bff"),
  /** {@link Body#applyForce(float, float, float, float)}. */
  APPLY_FORCE_AT("bffff"),
  /** {@link Body#applyAmbientForce}. */
  APPLY_AMBIENT_FORCE("bfff"),
  /** {@link Body#applyImpulse(float, float)}. */
  APPLY_IMPULSE("bff"),
  /** {@link Body#applyImpulse(float, float, float, float)}. */
  APPLY_IMPULSE_AT("bffff"),
  /** {@link Body#applyTorque}. */
  APPLY_TORQUE("bf"),
  /** {@link Body#applyAngularImpulse}. */
  APPLY_ANGULAR_IMPULSE("bf"),
  /** {@link Body#setBullet}. */
  SET_BULLET("bi"),
  /** {@link Body#setGravityScale}. */
  SET_GRAVITY_SCALE("bf"),
  /** {@link Body#setLinearDamping}. */
  SET_LINEAR_DAMPING("bf"),
  /** {@link Body#setAngularDamping}. */
  SET_ANGULAR_DAMPING("bf"),
  /** {@link Body#writeRow}. */
  WRITE_ROW("br"),
  /** {@link Joint#setMotor}. */
  SET_MOTOR("jff"),
  /** {@link Joint#stopMotor}. */
  STOP_MOTOR("j"),
  /** {@link Joint#setLimits}. */
  SET_LIMITS("jff"),
  /** {@link Joint#removeLimits}. */
  REMOVE_LIMITS("j"),
  /** {@link Joint#setSpring}. */
  SET_SPRING("jff"),
  /** {@link Joint#removeSpring}. */
  REMOVE_SPRING("j"),
  /** {@link Joint#setRest}. */
  SET_REST("jf"),
  /** {@link Joint#setTarget}. */
  SET_TARGET("jff"),
  /** {@link Joint#setTargetAngle}. */
  SET_TARGET_ANGLE("jf"),
  /** The recording ends; this is no call. */
  END("");

  /** Number of ints of a body's row. */
  static final int ROW = BodyRow.INTS;

  final String layout;

  Call(String layout) {
    this.layout = layout;
  }
}
