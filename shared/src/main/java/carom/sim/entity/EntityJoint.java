package carom.sim.entity;

import carom.physics.Body;
import carom.physics.Joint;
import carom.physics.JointType;

/**
 * A joint between two entities, or one and the world. Motor, limits, spring and target may be
 * changed at any time. What {@code Game.input} changes is predicted; all else is told by the exact
 * state of the joint. docs/engine/JOINTS.md says what they do. A handle, valid until the joint
 * breaks or is destroyed.
 */
public final class EntityJoint {
  private final Joint<HostEntity> joint;

  EntityJoint(Joint<HostEntity> joint) {
    this.joint = joint;
  }

  /** Returns the engine's joint, for what runs a simulation. */
  public static Joint<HostEntity> engineOf(EntityJoint joint) {
    return joint.joint;
  }

  /**
   * Destroys the joint. Nothing happens if it is gone already. {@code Game.input} may destroy those
   * of its player's body, and clients predict it.
   *
   * @throws IllegalStateException during the physics
   */
  public void destroy() {
    if (joint.isValid()) {
      joint.bodyB().user().destroy(joint);
    }
  }

  /** Returns the first entity, or null if the world takes its place. */
  public Entity a() {
    Body<HostEntity> body = joint.bodyA();
    return body == null ? null : body.user();
  }

  /** Returns the second entity. */
  public Entity b() {
    return joint.bodyB().user();
  }

  /** Returns whether the joint still exists. */
  public boolean isValid() {
    return joint.isValid();
  }

  /** Returns the joint's type, which never changes. */
  public JointType type() {
    return joint.type();
  }

  /** Returns x of A's anchor now, m, world; for a mouse joint, of its target. */
  public float anchorAX() {
    return joint.anchorAX();
  }

  /** Returns y of A's anchor now, m, world; for a mouse joint, of its target. */
  public float anchorAY() {
    return joint.anchorAY();
  }

  /** Returns x of B's anchor now, m, world. */
  public float anchorBX() {
    return joint.anchorBX();
  }

  /** Returns y of B's anchor now, m, world. */
  public float anchorBY() {
    return joint.anchorBY();
  }

  /** Returns the angle of B relative to A, rad, which was 0 when the joint was created. */
  public float angle() {
    return joint.angle();
  }

  /** Returns the coordinate, on which limits and spring act, m or rad; see {@link JointType}. */
  public float coordinate() {
    return joint.coordinate();
  }

  /** Returns x of the force on B at its anchor in the last substep, N. */
  public float forceX() {
    return joint.forceX();
  }

  /** Returns y of the force on B at its anchor in the last substep, N. */
  public float forceY() {
    return joint.forceY();
  }

  /** Returns the torque on B in the last substep, apart from that of the force, N m. */
  public float torque() {
    return joint.torque();
  }

  /** Returns x of the unit axis of a prismatic or wheel joint now; it turns with A. */
  public float axisX() {
    return joint.axisX();
  }

  /** Returns y of the unit axis of a prismatic or wheel joint now; it turns with A. */
  public float axisY() {
    return joint.axisY();
  }

  /** Returns whether a motor drives the coordinate. */
  public boolean isDriven() {
    return joint.isDriven();
  }

  /** Returns the target speed of the motor, m/s or rad/s; meaningless without one. */
  public float motorSpeed() {
    return joint.motorSpeed();
  }

  /**
   * Starts the motor, or changes it: its target speed, m/s or rad/s, and its largest force or
   * torque, N or N m.
   */
  public void setMotor(float speed, float max) {
    joint.setMotor(speed, max);
  }

  /** Stops the motor, so that it no longer drives the coordinate. */
  public void stopMotor() {
    joint.stopMotor();
  }

  /** Returns whether the coordinate is limited. */
  public boolean isLimited() {
    return joint.isLimited();
  }

  /** Returns the lower limit, m or rad; meaningless without limits. */
  public float lower() {
    return joint.lower();
  }

  /** Returns the upper limit, m or rad; meaningless without limits. */
  public float upper() {
    return joint.upper();
  }

  /** Limits the coordinate, m or rad, or changes the limits. */
  public void setLimits(float lower, float upper) {
    joint.setLimits(lower, upper);
  }

  /** Removes the limits. A rope becomes a rod of its rest length. */
  public void removeLimits() {
    joint.removeLimits();
  }

  /**
   * Returns whether a spring acts on the coordinate, or on the point of a weld, motor or mouse
   * joint.
   */
  public boolean isSprung() {
    return joint.isSprung();
  }

  /**
   * Puts a spring on the coordinate, or changes it: its frequency, 1/s, 0..1000, and its damping
   * ratio, 0..100.
   */
  public void setSpring(float hertz, float dampingRatio) {
    joint.setSpring(hertz, dampingRatio);
  }

  /** Removes the spring. Without limits, too, a distance joint becomes a rod of its rest length. */
  public void removeSpring() {
    joint.removeSpring();
  }

  /** Returns where the spring exerts no force, or the length of a rod, m or rad. */
  public float rest() {
    return joint.rest();
  }

  /** Sets where the spring exerts no force, or the length of a rod, m or rad. */
  public void setRest(float coordinate) {
    joint.setRest(coordinate);
  }

  /**
   * Sets the point that a motor or mouse joint draws B's anchor to, m, in the frame of A, or of the
   * world if there is no A.
   */
  public void setTarget(float x, float y) {
    joint.setTarget(x, y);
  }

  /**
   * Sets the angle that a motor joint draws B to, rad, relative to A, or to the world if there is
   * no A.
   */
  public void setTargetAngle(float angleRad) {
    joint.setTargetAngle(angleRad);
  }

  /** Returns the ratio of a gear, rack or pulley joint; of a ratchet the angle of a tooth, rad. */
  public float ratio() {
    return joint.ratio();
  }

  /** Returns the angle behind which a ratchet doesn't turn back, rad, over all turns. */
  public float toothAngle() {
    return joint.toothAngle();
  }

  /** Returns the length of a pulley's rope on A's side, m. */
  public float lengthA() {
    return joint.lengthA();
  }

  /** Returns the length of a pulley's rope on B's side, m. */
  public float lengthB() {
    return joint.lengthB();
  }

  @Override
  public String toString() {
    return joint.toString();
  }
}
