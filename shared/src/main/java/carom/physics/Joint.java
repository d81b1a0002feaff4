package carom.physics;

import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.joint.JointStore;
import carom.physics.math.Limits;
import carom.physics.math.Trig;

/**
 * A joint between two bodies of a {@link World}, or between a body and the world. The object is a
 * light handle (index and generation) on the world's arrays. There is one handle per joint, so
 * handles may be compared with ==.
 *
 * <p>A joint lives until it is destroyed, breaks, or one of its bodies is destroyed. After that all
 * methods but {@link #isValid}, {@link #index}, {@link #generation} and {@link #type} throw
 * IllegalStateException. Setters of properties that the joint's type lacks throw it, too. No method
 * allocates.
 *
 * <p>A new value acts from the next step on, and wakes the bodies if it differs from the old one.
 * Joints are solved in the order of their indices.
 *
 * @param <T> the user's type of {@link Body#user()}
 */
public final class Joint<T> {
  private final World<T> world;
  private final JointStore store;
  private final int index;
  private final int generation;
  private final JointType type;

  Joint(World<T> world, JointStore store, int index, int generation, JointType type) {
    this.world = world;
    this.store = store;
    this.index = index;
    this.generation = generation;
    this.type = type;
  }

  void check() {
    if (!store.alive(index, generation)) {
      throw new IllegalStateException(
          "joint=" + index + " generation=" + generation + " was destroyed; see isValid()");
    }
  }

  World<T> world() {
    return world;
  }

  /**
   * Returns the joint's slot. The slot is used again after the joint is destroyed.
   *
   * @return 0 or more
   */
  public int index() {
    return index;
  }

  /**
   * Returns the joint's generation, which tells apart the joints that used the same slot.
   *
   * @return 0 or more
   */
  public int generation() {
    return generation;
  }

  /**
   * Returns whether the joint still exists.
   *
   * @return false once it was destroyed
   */
  public boolean isValid() {
    return store.alive(index, generation);
  }

  /**
   * Returns the joint's type.
   *
   * @return the type, which never changes
   */
  public JointType type() {
    return type;
  }

  /**
   * Returns the first body.
   *
   * @return body A, null if the world takes its place
   */
  public Body<T> bodyA() {
    check();
    return world.body(store.bodyA[index]);
  }

  /**
   * Returns the second body.
   *
   * @return body B, never null
   */
  public Body<T> bodyB() {
    check();
    return world.body(store.bodyB[index]);
  }

  /**
   * Returns the x coordinate of A's anchor now; for a mouse joint, of its target.
   *
   * @return m, world
   */
  public float anchorAX() {
    return anchorX(store.bodyA, store.anchorAx, store.anchorAy);
  }

  /**
   * Returns the y coordinate of A's anchor now; for a mouse joint, of its target.
   *
   * @return m, world
   */
  public float anchorAY() {
    return anchorY(store.bodyA, store.anchorAx, store.anchorAy);
  }

  /**
   * Returns the x coordinate of B's anchor now.
   *
   * @return m, world
   */
  public float anchorBX() {
    return anchorX(store.bodyB, store.anchorBx, store.anchorBy);
  }

  /**
   * Returns the y coordinate of B's anchor now.
   *
   * @return m, world
   */
  public float anchorBY() {
    return anchorY(store.bodyB, store.anchorBx, store.anchorBy);
  }

  private float anchorX(int[] bodies, float[] xs, float[] ys) {
    check();
    int body = bodies[index];
    if (body < 0) {
      return xs[index];
    }
    BodyStore b = world.store();
    float x = xs[index] - b.localX[body];
    float y = ys[index] - b.localY[body];
    return b.x[body] + (b.cos[body] * x - b.sin[body] * y);
  }

  private float anchorY(int[] bodies, float[] xs, float[] ys) {
    check();
    int body = bodies[index];
    if (body < 0) {
      return ys[index];
    }
    BodyStore b = world.store();
    float x = xs[index] - b.localX[body];
    float y = ys[index] - b.localY[body];
    return b.y[body] + (b.sin[body] * x + b.cos[body] * y);
  }

  /**
   * Returns the angle of B relative to A, which was 0 when the joint was created. For a motor joint
   * the angle is relative to its target.
   *
   * @return rad, -pi..pi, unless full turns are counted, see {@link JointDef#revolute}
   */
  public float angle() {
    check();
    float angle = wrappedAngle();
    boolean winds = (store.flags[index] & JointStore.WINDS) != 0 && type != JointType.GEAR;
    return winds ? (float) store.woundB(index, angle) : angle;
  }

  private float wrappedAngle() {
    BodyStore b = world.store();
    int one = store.bodyA[index];
    int two = store.bodyB[index];
    float cA = one < 0 ? 1 : b.cos[one];
    float sA = one < 0 ? 0 : b.sin[one];
    float c = b.cos[two] * cA + b.sin[two] * sA;
    float s = b.sin[two] * cA - b.cos[two] * sA;
    float refCos = store.refCos[index];
    float refSin = store.refSin[index];
    return Trig.atan2(s * refCos - c * refSin, c * refCos + s * refSin);
  }

  /**
   * Returns the joint's coordinate, on which limits and spring act; see {@link JointType}.
   *
   * @return m or rad
   */
  public float coordinate() {
    check();
    float dx = anchorBX() - anchorAX();
    float dy = anchorBY() - anchorAY();
    return switch (type) {
      case DISTANCE -> length(dx, dy);
      case PRISMATIC, WHEEL -> {
        BodyStore b = world.store();
        int one = store.bodyA[index];
        float c = one < 0 ? 1 : b.cos[one];
        float s = one < 0 ? 0 : b.sin[one];
        float x = store.axisX[index];
        float y = store.axisY[index];
        yield (c * x - s * y) * dx + (s * x + c * y) * dy;
      }
      case REVOLUTE, WELD, MOTOR, MOUSE -> angle();
      case GEAR -> {
        BodyStore b = world.store();
        int two = store.bodyB[index];
        float x = store.baseBx[index];
        float y = store.baseBy[index];
        float c = b.cos[two] * x + b.sin[two] * y;
        float s = b.sin[two] * x - b.cos[two] * y;
        yield (float) store.woundB(index, Trig.atan2(s, c));
      }
      case RACK -> {
        BodyStore b = world.store();
        int two = store.bodyB[index];
        float x = b.cos[two] * store.axisX[index] - b.sin[two] * store.axisY[index];
        float y = b.sin[two] * store.axisX[index] + b.cos[two] * store.axisY[index];
        yield x * dx + y * dy - store.rest[index];
      }
      case PULLEY -> lengthA() + ratio() * lengthB();
    };
  }

  /**
   * Returns the ratio of a gear, rack or pulley joint, see {@link JointDef#gear}, {@link
   * JointDef#rack} and {@link JointDef#pulley}; of a {@link JointDef#ratchet} the angle between its
   * teeth, rad.
   *
   * @return the ratio given in the definition; 0 for all other joints
   */
  public float ratio() {
    check();
    return store.ratio[index];
  }

  /**
   * Returns the angle behind which a {@link JointDef#ratchet} doesn't turn back: that of the last
   * tooth it has passed.
   *
   * @return rad, over all turns
   */
  public float toothAngle() {
    check();
    refuseUnless(store.isRatchet(index), "toothAngle");
    return (float) store.tooth(index) + 0f; // no negative zero
  }

  /**
   * Returns the length of a pulley's rope on A's side.
   *
   * @return m
   */
  public float lengthA() {
    refuseUnless(type == JointType.PULLEY, "lengthA");
    return length(anchorAX() - store.baseAx[index], anchorAY() - store.baseAy[index]);
  }

  /**
   * Returns the length of a pulley's rope on B's side.
   *
   * @return m
   */
  public float lengthB() {
    refuseUnless(type == JointType.PULLEY, "lengthB");
    return length(anchorBX() - store.baseBx[index], anchorBY() - store.baseBy[index]);
  }

  /**
   * Returns the x coordinate of the world point that a pulley's rope runs to from A.
   *
   * @return m, world
   */
  public float groundAX() {
    refuseUnless(type == JointType.PULLEY, "groundAX");
    return store.baseAx[index];
  }

  /**
   * Returns the y coordinate of the world point that a pulley's rope runs to from A.
   *
   * @return m, world
   */
  public float groundAY() {
    refuseUnless(type == JointType.PULLEY, "groundAY");
    return store.baseAy[index];
  }

  /**
   * Returns the x coordinate of the world point that a pulley's rope runs to from B.
   *
   * @return m, world
   */
  public float groundBX() {
    refuseUnless(type == JointType.PULLEY, "groundBX");
    return store.baseBx[index];
  }

  /**
   * Returns the y coordinate of the world point that a pulley's rope runs to from B.
   *
   * @return m, world
   */
  public float groundBY() {
    refuseUnless(type == JointType.PULLEY, "groundBY");
    return store.baseBy[index];
  }

  private static float length(float x, float y) {
    return (float) Math.sqrt(x * x + y * y);
  }

  /**
   * Returns the x component of the force on B at its anchor in the last substep. A feels the
   * opposite, except in a pulley, see {@link JointDef#pulley}.
   *
   * @return N, world
   */
  public float forceX() {
    check();
    return store.forceX[index];
  }

  /**
   * Returns the y component of the force on B at its anchor in the last substep. A feels the
   * opposite, except in a pulley, see {@link JointDef#pulley}.
   *
   * @return N, world
   */
  public float forceY() {
    check();
    return store.forceY[index];
  }

  /**
   * Returns the torque on B in the last substep, apart from that of the force. A feels the
   * opposite, except in a gear, see {@link JointDef#gear}.
   *
   * @return N m
   */
  public float torque() {
    check();
    return store.torque[index];
  }

  /**
   * Returns whether the two bodies collide with each other, see {@link JointDef#collideConnected}.
   *
   * @return true if they collide
   */
  public boolean collideConnected() {
    check();
    return (store.flags[index] & JointStore.COLLIDE) != 0;
  }

  /**
   * Returns whether the coordinate is limited, see {@link #setLimits}.
   *
   * @return true if limits are set
   */
  public boolean isLimited() {
    return has(JointStore.LIMITED);
  }

  /**
   * Returns whether a spring acts on the coordinate, or on the point of a weld, motor or mouse
   * joint; see {@link #setSpring}.
   *
   * @return true if there is a spring
   */
  public boolean isSprung() {
    return has(JointStore.SPRUNG)
        || (!JointDef.hasCoordinateSpring(type) && store.hertz[index] > 0);
  }

  /**
   * Returns whether a motor drives the coordinate, see {@link #setMotor}.
   *
   * @return true if the motor runs
   */
  public boolean isDriven() {
    return has(JointStore.DRIVEN);
  }

  /**
   * Returns the lower limit of the coordinate.
   *
   * @return m or rad; meaningless unless {@link #isLimited}
   */
  public float lower() {
    check();
    return store.lower[index];
  }

  /**
   * Returns the upper limit of the coordinate.
   *
   * @return m or rad; meaningless unless {@link #isLimited}
   */
  public float upper() {
    check();
    return store.upper[index];
  }

  /**
   * Returns the x component of the axis of a prismatic or wheel joint now. The axis turns with A.
   *
   * @return -1..1, of the unit vector in world axes
   */
  public float axisX() {
    check();
    int one = store.bodyA[index];
    return one < 0
        ? store.axisX[index]
        : world.store().cos[one] * store.axisX[index] - world.store().sin[one] * store.axisY[index];
  }

  /**
   * Returns the y component of the axis of a prismatic or wheel joint now. The axis turns with A.
   *
   * @return -1..1, of the unit vector in world axes
   */
  public float axisY() {
    check();
    int one = store.bodyA[index];
    return one < 0
        ? store.axisY[index]
        : world.store().sin[one] * store.axisX[index] + world.store().cos[one] * store.axisY[index];
  }

  private boolean has(byte flag) {
    check();
    return (store.flags[index] & flag) != 0;
  }

  /**
   * Starts the motor, or changes its speed.
   *
   * @param speed target speed of the coordinate, m/s or rad/s, see {@link JointDef#motor(float,
   *     float)}
   * @param max largest force or torque of the motor, N or N m
   */
  public void setMotor(float speed, float max) {
    check();
    refuseUnless(JointDef.hasMotor(type), "setMotor");
    Limits.velocity("speed", speed);
    Limits.range("max", max, 0, Limits.MAX_FORCE);
    world.note(Call.SET_MOTOR, index, speed, max);
    set(store.motorSpeed, speed);
    set(store.motorMax, max);
    raise(JointStore.DRIVEN);
  }

  /**
   * Returns the target speed of the motor, see {@link #setMotor}.
   *
   * @return m/s or rad/s; meaningless unless {@link #isDriven}
   */
  public float motorSpeed() {
    check();
    return store.motorSpeed[index];
  }

  /**
   * Returns the largest force or torque of the motor, see {@link #setMotor}.
   *
   * @return N or N m; meaningless unless {@link #isDriven}
   */
  public float motorMax() {
    check();
    return store.motorMax[index];
  }

  /** Stops the motor, so that it no longer drives the coordinate. Does nothing without a motor. */
  public void stopMotor() {
    check();
    world.note(Call.STOP_MOTOR, index);
    clear(JointStore.DRIVEN);
    store.motorImpulse[index] = 0;
  }

  /**
   * Limits the coordinate, or changes the limits.
   *
   * @param lower lower limit, m or rad
   * @param upper upper limit, not below the lower one
   */
  public void setLimits(float lower, float upper) {
    check();
    refuseUnless(JointDef.hasLimits(type) && !store.isRatchet(index), "setLimits");
    Limits.range("lower", lower, JointDef.least(type), JointDef.most(type));
    Limits.range("upper", upper, lower, JointDef.most(type));
    world.note(Call.SET_LIMITS, index, lower, upper);
    set(store.lower, lower);
    set(store.upper, upper);
    if (JointDef.windsAt(lower) || JointDef.windsAt(upper)) {
      wind();
    }
    raise(JointStore.LIMITED);
  }

  /** Removes the limits. A rope becomes a rod of its rest length. */
  public void removeLimits() {
    check();
    world.note(Call.REMOVE_LIMITS, index);
    clear(JointStore.LIMITED);
    store.lowerImpulse[index] = 0;
    store.upperImpulse[index] = 0;
  }

  /**
   * Puts a spring on the coordinate, or on the point of a weld, motor or mouse joint, or changes
   * it.
   *
   * @param hertz frequency, 1/s, 0..1000; 0 makes a weld rigid
   * @param dampingRatio 0..100
   */
  public void setSpring(float hertz, float dampingRatio) {
    check();
    refuseUnless(JointDef.canSpring(type), "setSpring");
    Limits.range("hertz", hertz, 0, Limits.MAX_HERTZ);
    Limits.range("dampingRatio", dampingRatio, 0, Limits.MAX_DAMPING_RATIO);
    world.note(Call.SET_SPRING, index, hertz, dampingRatio);
    if (hertz > 0 && store.isRigidWeld(index)) {
      world.dynamics().coolWelds(index);
    }
    set(store.hertz, hertz);
    set(store.damping, dampingRatio);
    if (JointDef.hasCoordinateSpring(type)) {
      raise(JointStore.SPRUNG);
    }
  }

  /**
   * Returns the frequency of the spring, see {@link #setSpring}.
   *
   * @return 1/s; meaningless unless {@link #isSprung}
   */
  public float springHertz() {
    check();
    return store.hertz[index];
  }

  /**
   * Returns the damping ratio of the spring, see {@link #setSpring}.
   *
   * @return 0..100; meaningless unless {@link #isSprung}
   */
  public float springDamping() {
    check();
    return store.damping[index];
  }

  /**
   * Removes the spring on the coordinate. Without limits, too, a distance joint becomes a rod of
   * its rest length.
   */
  public void removeSpring() {
    check();
    refuseUnless(JointDef.hasCoordinateSpring(type), "removeSpring");
    world.note(Call.REMOVE_SPRING, index);
    clear(JointStore.SPRUNG);
    store.springImpulse[index] = 0;
  }

  /**
   * Sets the rest value of the coordinate: where the spring exerts no force, or the length of a
   * rod.
   *
   * @param coordinate m or rad, see {@link JointType}
   */
  public void setRest(float coordinate) {
    check();
    refuseUnless(JointDef.hasLimits(type), "setRest");
    Limits.range("rest", coordinate, JointDef.least(type), JointDef.most(type));
    world.note(Call.SET_REST, index, coordinate);
    set(store.rest, coordinate);
    if (JointDef.windsBeyond(coordinate)) {
      wind();
    }
  }

  /**
   * Returns the rest value of the coordinate: where the spring exerts no force, or the length of a
   * rod.
   *
   * @return m or rad, see {@link JointType}
   */
  public float rest() {
    check();
    return store.rest[index];
  }

  /**
   * Sets the point that a motor or mouse joint draws B's anchor to.
   *
   * @param x x of the target, m, in the frame of A, or of the world if there is no A
   * @param y y of the target, m, in the same frame
   */
  public void setTarget(float x, float y) {
    check();
    refuseUnless(type == JointType.MOTOR || type == JointType.MOUSE, "setTarget");
    Limits.coordinate("x", x);
    Limits.coordinate("y", y);
    world.note(Call.SET_TARGET, index, x, y);
    set(store.anchorAx, x);
    set(store.anchorAy, y);
  }

  /**
   * Returns the x of the point that a motor or mouse joint draws B's anchor to.
   *
   * @return m, in the frame of A, or of the world if there is no A
   */
  public float targetX() {
    refuseUnless(type == JointType.MOTOR || type == JointType.MOUSE, "targetX");
    return store.anchorAx[index];
  }

  /**
   * Returns the y of the point that a motor or mouse joint draws B's anchor to.
   *
   * @return m, in the frame of A, or of the world if there is no A
   */
  public float targetY() {
    refuseUnless(type == JointType.MOTOR || type == JointType.MOUSE, "targetY");
    return store.anchorAy[index];
  }

  /**
   * Sets the angle that a motor joint draws B to.
   *
   * @param angleRad angle of B relative to A, or to the world if there is no A, rad, within 1e5
   */
  public void setTargetAngle(float angleRad) {
    check();
    refuseUnless(type == JointType.MOTOR, "setTargetAngle");
    Limits.range("angle", angleRad, -1e5f, 1e5f);
    world.note(Call.SET_TARGET_ANGLE, index, angleRad);
    set(store.refCos, Trig.cos(angleRad));
    set(store.refSin, Trig.sin(angleRad));
  }

  /** Starts counting full turns if a revolute joint needs an angle beyond half a turn. */
  private void wind() {
    if (type == JointType.REVOLUTE) {
      raise(JointStore.WINDS);
    }
  }

  private void raise(byte flag) {
    if ((store.flags[index] & flag) == 0) {
      store.flags[index] |= flag;
      if (type == JointType.DISTANCE || type == JointType.PULLEY) {
        store.impulseX[index] = 0; // of a length that was rigid, which nothing solves any more
      }
      changed();
    }
  }

  private void clear(byte flag) {
    if ((store.flags[index] & flag) != 0) {
      store.flags[index] &= (byte) ~flag;
      changed();
    }
  }

  private void set(float[] values, float value) {
    if (values[index] != value) {
      values[index] = value;
      changed();
    }
  }

  private void changed() {
    store.settingChanged(index);
    world.dynamics().wakeEnds(index);
  }

  private void refuseUnless(boolean possible, String what) {
    check();
    if (!possible) {
      throw new IllegalStateException(what + " is not possible for type=" + type);
    }
  }

  @Override
  public String toString() {
    return "Joint(" + type + " " + index + ":" + generation + ")";
  }
}
