package carom.physics;

import carom.physics.dynamics.Dynamics;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.body.ShapeSpec;
import carom.physics.geometry.Shape;
import carom.physics.math.Aabb;
import carom.physics.math.Limits;
import carom.physics.math.StateHash;
import carom.physics.math.Trig;
import carom.physics.rows.BodyRow;
import java.util.function.Consumer;

/**
 * A rigid body of a {@link World}. The object is a light handle (index and generation) on the
 * world's arrays. There is one handle per body, so handles may be compared with ==.
 *
 * <p>All methods except {@link #isValid}, {@link #index}, {@link #generation}, {@link #type},
 * {@link #user} and the shape accessors throw IllegalStateException once the body was destroyed.
 * Numbers that are not finite or out of range (beyond 32,768 m, 1e5 m/s) throw
 * IllegalArgumentException with the value. No method allocates unless its comment says so.
 *
 * <p>A body that rests for a while falls asleep with all that it touches, see {@link #awake}. It
 * wakes by itself when something moves it or what it touches. Setting a property to the value it
 * already has doesn't wake it.
 *
 * <p>Forces and impulses add up, act in the next step, and are then cleared. They do nothing on
 * static, kinematic and disabled bodies.
 *
 * @param <T> the user's type
 */
public final class Body<T> {
  private static final BodyType[] TYPES = BodyType.values();

  /** Distance, m, with the turn, rad, below which a body has reached the pose it moves to. */
  private static final float THERE = 1e-5f;

  /** All locks there are, by angularZ + 2 linearX + 4 linearY. */
  private static final MotionLocks[] LOCKS = new MotionLocks[8];

  static {
    for (int i = 0; i < LOCKS.length; i++) {
      LOCKS[i] = new MotionLocks((i & 2) != 0, (i & 4) != 0, (i & 1) != 0);
    }
  }

  private final World<T> world;
  private final BodyStore store;
  private final int index;
  private final int generation;
  private final BodyType type;
  private final ShapeDef[] firstShapes;
  private final T user;

  Body(
      World<T> world,
      BodyStore store,
      int index,
      int generation,
      BodyType type,
      ShapeDef[] shapes,
      T user) {
    this.world = world;
    this.store = store;
    this.index = index;
    this.generation = generation;
    this.type = type;
    firstShapes = shapes;
    this.user = user;
  }

  void check() {
    if (!store.alive(index, generation)) {
      throw new IllegalStateException(
          "body=" + index + " generation=" + generation + " was destroyed; see isValid()");
    }
  }

  World<T> world() {
    return world;
  }

  /**
   * Returns the body's slot. The slot is used again after the body is destroyed.
   *
   * @return 0 or more
   */
  public int index() {
    return index;
  }

  /**
   * Returns the body's generation, which tells apart the bodies that used the same slot.
   *
   * @return 0 or more
   */
  public int generation() {
    return generation;
  }

  /**
   * Returns whether the body still exists.
   *
   * @return false once it was destroyed
   */
  public boolean isValid() {
    return store.alive(index, generation);
  }

  /**
   * Returns the object that the body stands for.
   *
   * @return the user given to {@link World#createBody}, may be null
   */
  public T user() {
    return user;
  }

  /**
   * Returns the body's type: static, kinematic or dynamic.
   *
   * @return the type; of a destroyed body, the one it was created with
   */
  public BodyType type() {
    return isValid() ? TYPES[store.type[index]] : type;
  }

  /**
   * Makes the body static, kinematic or dynamic. Origin and velocity stay, except that a static
   * body is at rest; pending forces are cleared. In a callback this takes effect at the end of the
   * step. Allocates.
   *
   * @param newType the new type
   * @throws IllegalArgumentException if the new type is dynamic and the shapes have no mass
   * @throws IllegalStateException during a query
   */
  public void setType(BodyType newType) {
    check();
    Limits.notNull("newType", newType);
    world.edits().changeType(this, newType);
  }

  /**
   * Returns whether the body takes part in the simulation.
   *
   * @return true unless {@link #setEnabled} said otherwise
   */
  public boolean isEnabled() {
    check();
    return !store.disabled(index);
  }

  /**
   * Takes the body out of the simulation, or back in. A disabled body keeps pose and velocity, but
   * doesn't move, feels no forces and collides with nothing. Queries don't find it, and its joints
   * are idle. Its contacts end in the next step. In a callback this takes effect at the end of the
   * step.
   *
   * @param enabled true if the body takes part from now on
   * @throws IllegalStateException during a query
   */
  public void setEnabled(boolean enabled) {
    check();
    world.edits().enable(this, enabled);
  }

  /**
   * Returns whether the body is awake: dynamic or kinematic, enabled, and not asleep. A sleeping
   * body is at rest and costs nothing. It wakes with its whole island (dynamic bodies connected by
   * contacts or joints), in the step in which something awake begins to touch it.
   *
   * @return false for static, disabled and sleeping bodies
   */
  public boolean awake() {
    check();
    int flags = store.flags[index] & (BodyStore.ASLEEP | BodyStore.DISABLED);
    return flags == 0 && store.type[index] != BodyStore.STATIC;
  }

  /**
   * Wakes the body and its island. If the body is awake, its time of rest starts again. In a
   * callback this takes effect at the end of the step.
   */
  public void wake() {
    check();
    world.note(Call.WAKE, index);
    dynamics().wake(index);
  }

  /**
   * Puts the body and its island to sleep at once, which clears their velocities and pending
   * forces. Nothing happens if the world has sleeping switched off, if a body of the island may not
   * sleep, or if one touches a body that it may no longer touch (because that body was disabled or
   * filtered out since the last step, say). In a callback this takes effect at the end of the step.
   *
   * @throws IllegalStateException during a query
   */
  public void sleep() {
    check();
    world.refuseDuringQuery("sleep");
    world.note(Call.SLEEP, index);
    world.sleep(index);
  }

  /**
   * Returns whether the body may fall asleep.
   *
   * @return true unless {@link #setSleepAllowed} or {@link BodyDef#sleepAllowed} said otherwise
   */
  public boolean sleepAllowed() {
    check();
    return (store.flags[index] & BodyStore.SLEEPLESS) == 0;
  }

  /**
   * Sets whether the body may fall asleep. A body that may not sleep wakes, and keeps awake all
   * that it touches.
   *
   * @param allowed true if the body may fall asleep, as by default
   */
  public void setSleepAllowed(boolean allowed) {
    check();
    world.note(Call.SET_SLEEP_ALLOWED, index, allowed);
    if (allowed) {
      store.flags[index] &= ~BodyStore.SLEEPLESS;
    } else {
      store.flags[index] |= BodyStore.SLEEPLESS;
      dynamics().wake(index);
    }
  }

  /**
   * Returns the speed below which the body is at rest.
   *
   * @return m/s; the world's unless {@link #setSleepSpeed} or {@link BodyDef#sleepSpeed} gave one
   */
  public float sleepSpeed() {
    check();
    float own = store.sleepSpeed[index];
    return own == BodyStore.WORLDS ? world.def().sleepSpeed() : own;
  }

  /**
   * Sets the speed below which the body is at rest, see {@link BodyDef#sleepSpeed}. A sleeping body
   * stays asleep.
   *
   * @param speed m/s, 0..1000
   */
  public void setSleepSpeed(float speed) {
    check();
    Limits.range("sleepSpeed", speed, 0, Limits.MAX_SLEEP_SPEED);
    world.note(Call.SET_SLEEP_SPEED, index, speed);
    store.sleepSpeed[index] = speed;
    store.coldChanged();
  }

  private Dynamics dynamics() {
    return world.dynamics();
  }

  /** Wakes the body if it sleeps. */
  private void rouse() {
    if (store.asleep(index)) {
      dynamics().wake(index);
    }
  }

  /** Returns whether forces act on the body: it is dynamic and enabled. */
  private boolean acts() {
    return store.type[index] == BodyStore.DYNAMIC && !store.disabled(index);
  }

  ShapeSpec[] specs() {
    return World.specs(shapes());
  }

  private ShapeDef shapeDef(int i) {
    ShapeDef[] all = shapes();
    return all[Limits.index("shape", i, all.length)];
  }

  /** Returns the body's shapes; of a destroyed body, those it was created with. */
  ShapeDef[] shapes() {
    return isValid() ? world.shapes(index) : firstShapes;
  }

  /**
   * Returns the x coordinate of the body's origin.
   *
   * @return m, world
   */
  public float x() {
    check();
    return store.originX(index);
  }

  /**
   * Returns the y coordinate of the body's origin.
   *
   * @return m, world
   */
  public float y() {
    check();
    return store.originY(index);
  }

  /**
   * Returns the x coordinate of the centre of mass. It equals the origin for static and kinematic
   * bodies.
   *
   * @return m, world
   */
  public float centerX() {
    check();
    return store.x[index];
  }

  /**
   * Returns the y coordinate of the centre of mass. It equals the origin for static and kinematic
   * bodies.
   *
   * @return m, world
   */
  public float centerY() {
    check();
    return store.y[index];
  }

  /**
   * Returns the cosine of the rotation.
   *
   * @return -1..1
   */
  public float cos() {
    check();
    return store.cos[index];
  }

  /**
   * Returns the sine of the rotation.
   *
   * @return -1..1
   */
  public float sin() {
    check();
    return store.sin[index];
  }

  /**
   * Returns the rotation as an angle.
   *
   * @return rad, -pi..pi, counter-clockwise
   */
  public float angle() {
    check();
    return Trig.atan2(store.sin[index], store.cos[index]);
  }

  /**
   * Returns the x component of the velocity of the centre of mass.
   *
   * @return m/s
   */
  public float velocityX() {
    check();
    return store.vx[index];
  }

  /**
   * Returns the y component of the velocity of the centre of mass.
   *
   * @return m/s
   */
  public float velocityY() {
    check();
    return store.vy[index];
  }

  /**
   * Returns the angular velocity.
   *
   * @return rad/s, counter-clockwise
   */
  public float angularVelocity() {
    check();
    return store.w[index];
  }

  /**
   * Returns the x coordinate, in the world, of a point of the body.
   *
   * @param localX m, in the body frame
   * @param localY m, in the body frame
   * @return m, world
   */
  public float worldPointX(float localX, float localY) {
    return worldVectorX(localX - localCenterX(), localY - store.localY[index]) + store.x[index];
  }

  /**
   * Returns the y coordinate, in the world, of a point of the body.
   *
   * @param localX m, in the body frame
   * @param localY m, in the body frame
   * @return m, world
   */
  public float worldPointY(float localX, float localY) {
    return worldVectorY(localX - localCenterX(), localY - store.localY[index]) + store.y[index];
  }

  /**
   * Returns the x component, in the world, of a vector of the body frame: it is turned, not moved.
   *
   * @param localX in the body frame
   * @param localY in the body frame
   * @return in the unit of the vector
   */
  public float worldVectorX(float localX, float localY) {
    check();
    return store.cos[index] * localX - store.sin[index] * localY;
  }

  /**
   * Returns the y component, in the world, of a vector of the body frame: it is turned, not moved.
   *
   * @param localX in the body frame
   * @param localY in the body frame
   * @return in the unit of the vector
   */
  public float worldVectorY(float localX, float localY) {
    check();
    return store.sin[index] * localX + store.cos[index] * localY;
  }

  /**
   * Returns the x coordinate, in the body frame, of a point of the world.
   *
   * @param worldX m
   * @param worldY m
   * @return m, from the body's origin
   */
  public float localPointX(float worldX, float worldY) {
    return localVectorX(worldX - centerX(), worldY - store.y[index]) + store.localX[index];
  }

  /**
   * Returns the y coordinate, in the body frame, of a point of the world.
   *
   * @param worldX m
   * @param worldY m
   * @return m, from the body's origin
   */
  public float localPointY(float worldX, float worldY) {
    return localVectorY(worldX - centerX(), worldY - store.y[index]) + store.localY[index];
  }

  /**
   * Returns the x component, in the body frame, of a vector of the world: it is turned, not moved.
   *
   * @param worldX in the world
   * @param worldY in the world
   * @return in the unit of the vector
   */
  public float localVectorX(float worldX, float worldY) {
    check();
    return store.cos[index] * worldX + store.sin[index] * worldY;
  }

  /**
   * Returns the y component, in the body frame, of a vector of the world: it is turned, not moved.
   *
   * @param worldX in the world
   * @param worldY in the world
   * @return in the unit of the vector
   */
  public float localVectorY(float worldX, float worldY) {
    check();
    return store.cos[index] * worldY - store.sin[index] * worldX;
  }

  /**
   * Returns the x component of the velocity of a point that moves with the body: v + w x r.
   *
   * @param worldX m, world
   * @param worldY m, world
   * @return m/s
   */
  public float velocityAtX(float worldX, float worldY) {
    Limits.coordinate("worldX", worldX);
    return velocityX() - store.w[index] * (worldY - store.y[index]);
  }

  /**
   * Returns the y component of the velocity of a point that moves with the body: v + w x r.
   *
   * @param worldX m, world
   * @param worldY m, world
   * @return m/s
   */
  public float velocityAtY(float worldX, float worldY) {
    Limits.coordinate("worldY", worldY);
    return velocityY() + store.w[index] * (worldX - store.x[index]);
  }

  /**
   * Teleports the body to a position and an angle.
   *
   * @param x x of the origin, m, world
   * @param y y of the origin, m, world
   * @param angleRad rotation, rad, counter-clockwise, within 1e5
   */
  public void setPose(float x, float y, float angleRad) {
    Limits.range("angle", angleRad, -1e5f, 1e5f);
    setPose(x, y, Trig.cos(angleRad), Trig.sin(angleRad));
  }

  /**
   * Teleports the body to a position and a rotation.
   *
   * @param x x of the origin, m, world
   * @param y y of the origin, m, world
   * @param cos cosine of the rotation
   * @param sin sine of the rotation; (cos, sin) is kept bit for bit if its length is 1 up to
   *     rounding, else normalised
   */
  public void setPose(float x, float y, float cos, float sin) {
    check();
    world.refuseDuringQuery("setPose");
    BodyStore.checkPose(x, y, cos, sin);
    world.note(Call.SET_POSE, index, x, y, cos, sin);
    float oldX = store.x[index];
    float oldY = store.y[index];
    float oldCos = store.cos[index];
    float oldSin = store.sin[index];
    store.setOriginPose(index, x, y, cos, sin);
    movedFrom(oldX, oldY, oldCos, oldSin);
  }

  private void movedFrom(float x, float y, float cos, float sin) {
    if (store.x[index] != x
        || store.y[index] != y
        || store.cos[index] != cos
        || store.sin[index] != sin) {
      world.moved(index);
    }
  }

  /**
   * Teleports the body by its centre of mass, which is what the world stores. The values that
   * {@link #centerX}, {@link #centerY}, {@link #cos} and {@link #sin} returned are restored bit for
   * bit.
   *
   * @param x x of the centre of mass, m, world
   * @param y y of the centre of mass, m, world
   * @param cos cosine of the rotation
   * @param sin sine of the rotation
   */
  public void setCenterPose(float x, float y, float cos, float sin) {
    check();
    world.refuseDuringQuery("setCenterPose");
    BodyStore.checkPose(x, y, cos, sin);
    world.note(Call.SET_CENTER_POSE, index, x, y, cos, sin);
    float oldX = store.x[index];
    float oldY = store.y[index];
    float oldCos = store.cos[index];
    float oldSin = store.sin[index];
    store.setCenterPose(index, x, y, cos, sin);
    movedFrom(oldX, oldY, oldCos, oldSin);
  }

  /**
   * Sets the velocity of the centre of mass. Does nothing on a static body.
   *
   * @param vx x component, m/s
   * @param vy y component, m/s
   */
  public void setVelocity(float vx, float vy) {
    check();
    Limits.velocity("velocityX", vx);
    Limits.velocity("velocityY", vy);
    world.note(Call.SET_VELOCITY, index, vx, vy);
    if (store.type[index] != BodyStore.STATIC) {
      if (vx != 0 || vy != 0) {
        rouse();
      }
      store.vx[index] = vx;
      store.vy[index] = vy;
    }
  }

  /**
   * Sets the angular velocity. Does nothing on a static body.
   *
   * @param radPerSecond rad/s, counter-clockwise
   */
  public void setAngularVelocity(float radPerSecond) {
    check();
    Limits.velocity("angularVelocity", radPerSecond);
    world.note(Call.SET_ANGULAR_VELOCITY, index, radPerSecond);
    if (store.type[index] != BodyStore.STATIC) {
      if (radPerSecond != 0) {
        rouse();
      }
      store.w[index] = radPerSecond;
    }
  }

  /**
   * Sets the velocities by which a kinematic body reaches a pose in the next step, so that it
   * pushes and carries what is in the way; {@link #setPose} would put it there without. It turns
   * the shorter way round, half a turn to within 0.01 rad. The velocities stay after the step, so
   * call this before every step: a body that is there, to 0.01 mm and 0.01 mrad, stops and may
   * sleep. Speeds above the world's limits are cut. Dynamic bodies get the velocities, too, but
   * gravity and what they meet change them. Does nothing on a static body.
   *
   * @param x x of the origin, m, world
   * @param y y of the origin, m, world
   * @param angleRad rotation, rad, counter-clockwise, within 1e5
   * @param dtSeconds length of the next step, s
   */
  public void moveTo(float x, float y, float angleRad, float dtSeconds) {
    check();
    Limits.coordinate("x", x);
    Limits.coordinate("y", y);
    Limits.range("angle", angleRad, -1e5f, 1e5f);
    Limits.timeStep(dtSeconds);
    float cos = Trig.cos(angleRad);
    float sin = Trig.sin(angleRad);
    float lx = store.localX[index];
    float ly = store.localY[index];
    float wayX = x + (cos * lx - sin * ly) - store.x[index];
    float wayY = y + (sin * lx + cos * ly) - store.y[index];
    float c = store.cos[index];
    float s = store.sin[index];
    float turn = Trig.atan2(sin * c - cos * s, cos * c + sin * s);
    boolean there = Math.abs(wayX) + Math.abs(wayY) + Math.abs(turn) < THERE;
    setVelocity(there ? 0 : speed(wayX, dtSeconds), there ? 0 : speed(wayY, dtSeconds));
    setAngularVelocity(there ? 0 : speed(turn, dtSeconds));
  }

  private static float speed(float way, float dt) {
    return Math.max(-Limits.MAX_VELOCITY, Math.min(way / dt, Limits.MAX_VELOCITY));
  }

  /**
   * Applies a force at the centre of mass during the next step.
   *
   * @param fx x component, N
   * @param fy y component, N
   */
  public void applyForce(float fx, float fy) {
    check();
    checkForce(fx, fy);
    world.note(Call.APPLY_FORCE, index, fx, fy);
    addForce(fx, fy);
  }

  private static void checkForce(float fx, float fy) {
    Limits.force("forceX", fx);
    Limits.force("forceY", fy);
  }

  private void addForce(float fx, float fy) {
    if (acts() && (fx != 0 || fy != 0)) {
      dynamics().wake(index);
      store.forceX[index] += fx;
      store.forceY[index] += fy;
    }
  }

  /**
   * Applies a force at a point during the next step: the force at the centre of mass, and its
   * torque.
   *
   * @param fx x component, N
   * @param fy y component, N
   * @param px point of application, m, world
   * @param py point of application, m, world
   */
  public void applyForce(float fx, float fy, float px, float py) {
    Limits.coordinate("px", px);
    Limits.coordinate("py", py);
    check();
    checkForce(fx, fy);
    world.note(Call.APPLY_FORCE_AT, index, fx, fy, px, py);
    addForce(fx, fy);
    if (acts()) {
      store.torque[index] += (px - store.x[index]) * fy - (py - store.y[index]) * fx;
    }
  }

  /**
   * Applies a force and a torque that are always there, such as those of a fluid or a wind, during
   * the next step. Unlike {@link #applyForce}, it lets the body fall asleep, and it does nothing on
   * a sleeping body.
   *
   * @param fx x component, N
   * @param fy y component, N
   * @param torque N m, counter-clockwise
   */
  public void applyAmbientForce(float fx, float fy, float torque) {
    check();
    checkForce(fx, fy);
    Limits.force("torque", torque);
    world.note(Call.APPLY_AMBIENT_FORCE, index, fx, fy, torque);
    if (acts() && !store.asleep(index)) {
      store.forceX[index] += fx;
      store.forceY[index] += fy;
      store.torque[index] += torque;
    }
  }

  /**
   * Reads pose, velocities, the time at rest, and what acts on the body in the next step: the
   * {@link BodyRow#STATE_INTS} ints that a row has from {@link BodyRow#MOTION} on.
   *
   * @param row receives them
   * @param at where the row begins
   */
  public void readRow(int[] row, int at) {
    check();
    Limits.stretch("row", Limits.notNull("row", row).length, at, BodyRow.INTS);
    dynamics().readBody(index, row, at);
  }

  /**
   * Takes over what {@link #readRow} reads, to the bit. A sleeping body wakes, with its island.
   *
   * @param row a row of a body that is awake, with finite numbers
   * @param at where the row begins
   */
  public void writeRow(int[] row, int at) {
    check();
    world.refuseDuringQuery("writeRow");
    Limits.stretch("row", Limits.notNull("row", row).length, at, BodyRow.INTS);
    BodyRow.check(row, at);
    world.noteRow(index, row, at);
    dynamics().wake(index);
    float oldX = store.x[index];
    float oldY = store.y[index];
    float oldCos = store.cos[index];
    float oldSin = store.sin[index];
    dynamics().writeBody(index, row, at);
    movedFrom(oldX, oldY, oldCos, oldSin);
  }

  /**
   * Returns a hash of pose, velocities, and of the forces and impulses that wait for the next step.
   * It changes when something moves or pushes the body.
   */
  public long stamp() {
    check();
    long h = StateHash.mix(StateHash.SEED, store.x[index], store.y[index]);
    h = StateHash.mix(h, store.cos[index], store.sin[index]);
    h = StateHash.mix(h, store.vx[index], store.vy[index]);
    h = StateHash.mix(h, store.w[index], store.torque[index]);
    h = StateHash.mix(h, store.forceX[index], store.forceY[index]);
    h = StateHash.mix(h, store.impulseX[index], store.impulseY[index]);
    return StateHash.mix(h, store.impulseW[index], 0f);
  }

  /**
   * Returns a hash of which joints the body has, and of their settings. It changes when one comes
   * or goes, or a motor, a limit, a spring or a target is set.
   */
  public long jointStamp() {
    check();
    return dynamics().jointTransfer().stamp(index);
  }

  /**
   * Applies an impulse at the centre of mass. At the start of the next step the velocity changes by
   * J / m.
   *
   * @param jx x component, N s
   * @param jy y component, N s
   */
  public void applyImpulse(float jx, float jy) {
    check();
    checkImpulse(jx, jy);
    world.note(Call.APPLY_IMPULSE, index, jx, jy);
    addImpulse(jx, jy);
  }

  private static void checkImpulse(float jx, float jy) {
    Limits.force("impulseX", jx);
    Limits.force("impulseY", jy);
  }

  private void addImpulse(float jx, float jy) {
    if (acts() && (jx != 0 || jy != 0)) {
      dynamics().wake(index);
      store.impulseX[index] += jx;
      store.impulseY[index] += jy;
    }
  }

  /**
   * Applies an impulse at a point. At the start of the next step the velocity changes by J / m, and
   * the angular velocity by r x J / I.
   *
   * @param jx x component, N s
   * @param jy y component, N s
   * @param px point of application, m, world
   * @param py point of application, m, world
   */
  public void applyImpulse(float jx, float jy, float px, float py) {
    Limits.coordinate("px", px);
    Limits.coordinate("py", py);
    check();
    checkImpulse(jx, jy);
    world.note(Call.APPLY_IMPULSE_AT, index, jx, jy, px, py);
    addImpulse(jx, jy);
    if (acts()) {
      store.impulseW[index] += (px - store.x[index]) * jy - (py - store.y[index]) * jx;
    }
  }

  /**
   * Applies a torque during the next step.
   *
   * @param torque N m, counter-clockwise
   */
  public void applyTorque(float torque) {
    check();
    Limits.force("torque", torque);
    world.note(Call.APPLY_TORQUE, index, torque);
    if (acts() && torque != 0) {
      dynamics().wake(index);
      store.torque[index] += torque;
    }
  }

  /**
   * Applies an angular impulse. At the start of the next step the angular velocity changes by j /
   * I.
   *
   * @param j N m s, counter-clockwise
   */
  public void applyAngularImpulse(float j) {
    check();
    Limits.force("angularImpulse", j);
    world.note(Call.APPLY_ANGULAR_IMPULSE, index, j);
    if (acts() && j != 0) {
      dynamics().wake(index);
      store.impulseW[index] += j;
    }
  }

  /**
   * Steers the body towards a velocity: applies the force F = k (goal - v) during the next step.
   *
   * <p>If it is called before every step of dt, each step scales the difference by {@code 1 - k dt
   * / m}. A k above {@code m / dt} would overshoot and is clamped to it, which reaches the goal in
   * one step.
   *
   * @param goalX x component of the goal, m/s
   * @param goalY y component of the goal, m/s
   * @param k strength, kg/s, not negative
   * @param dtSeconds the length of the next step, s
   */
  public void seekVelocity(float goalX, float goalY, float k, float dtSeconds) {
    Limits.timeStep(dtSeconds);
    seekVelocity(goalX, goalY, Math.min(k, mass() / dtSeconds));
  }

  /**
   * Steers the body towards a velocity without clamping k: applies the force F = k (goal - v)
   * during the next step. Keep k below {@code m / dt}, or the body overshoots.
   *
   * @param goalX x component of the goal, m/s
   * @param goalY y component of the goal, m/s
   * @param k strength, kg/s, 0..1e12
   */
  public void seekVelocity(float goalX, float goalY, float k) {
    check();
    Limits.velocity("goalX", goalX);
    Limits.velocity("goalY", goalY);
    Limits.range("k", k, 0, 1e12f);
    applyForce(k * (goalX - store.vx[index]), k * (goalY - store.vy[index]));
  }

  /**
   * Returns whether the body is a bullet, see {@link BodyDef#bullet}.
   *
   * @return true if continuous collision stops the body at dynamic bodies, too
   */
  public boolean isBullet() {
    check();
    return store.bullet(index);
  }

  /**
   * Sets whether the body is a bullet, see {@link BodyDef#bullet}.
   *
   * @param bullet true to stop it at dynamic bodies, too, however fast it is
   */
  public void setBullet(boolean bullet) {
    check();
    world.note(Call.SET_BULLET, index, bullet);
    store.setBullet(index, bullet);
  }

  /**
   * Returns the body's mass.
   *
   * @return kg; 0 if not dynamic
   */
  public float mass() {
    check();
    return store.mass[index];
  }

  /**
   * Returns the moment of inertia about the centre of mass.
   *
   * @return kg m^2; 0 if not dynamic or rotation is fixed
   */
  public float inertia() {
    check();
    return store.inertia[index];
  }

  /**
   * Returns the x coordinate of the centre of mass in the body frame.
   *
   * @return m; 0 if not dynamic
   */
  public float localCenterX() {
    check();
    return store.localX[index];
  }

  /**
   * Returns the y coordinate of the centre of mass in the body frame.
   *
   * @return m; 0 if not dynamic
   */
  public float localCenterY() {
    check();
    return store.localY[index];
  }

  /**
   * Sets the mass that the body has while it is dynamic, instead of the one computed from shapes
   * and densities. The body's origin, and the velocity there, stay. Wakes the body. In a callback
   * this takes effect at the end of the step.
   *
   * @param kilograms mass, kg, 1e-9..1e15
   * @param inertia moment of inertia about the centre of mass, kg m^2, 1e-20..1e20; 0 for a body
   *     that no force turns
   * @param centerX x of the centre of mass in the body frame, m
   * @param centerY y of the centre of mass in the body frame, m
   * @throws IllegalStateException during a query
   */
  public void setMass(float kilograms, float inertia, float centerX, float centerY) {
    check();
    world.edits().changeMass(this, BodyDef.checkedMass(kilograms, inertia, centerX, centerY));
  }

  /**
   * Computes the mass from shapes and densities again, which undoes {@link #setMass}.
   *
   * @throws IllegalArgumentException if the body is dynamic and its shapes have no mass
   * @throws IllegalStateException during a query
   */
  public void computeMass() {
    check();
    world.edits().changeMass(this, null);
  }

  /**
   * Returns whether {@link #setMass} or {@link BodyDef#mass} gave the mass.
   *
   * @return false if the mass is computed from the shapes
   */
  public boolean hasOwnMass() {
    check();
    return world.ownMass(index) != null;
  }

  /**
   * Returns whether the rotation is fixed, see {@link BodyDef#fixedRotation}.
   *
   * @return true if no force turns the body
   */
  public boolean isFixedRotation() {
    check();
    return (store.flags[index] & BodyStore.FIXED_ROTATION) != 0;
  }

  /**
   * Fixes or frees the rotation, the third of the {@link #motionLocks}. Fixing it stops the
   * rotation. Wakes the body. In a callback this takes effect at the end of the step.
   *
   * @param fixed true if no force shall turn the body
   * @throws IllegalStateException during a query
   */
  public void setFixedRotation(boolean fixed) {
    check();
    world.edits().fixRotation(this, fixed);
  }

  /**
   * Returns the axes along which no force, contact or joint moves the body.
   *
   * @return the locks, the rotation's included
   */
  public MotionLocks motionLocks() {
    check();
    int flags = store.flags[index];
    return LOCKS[
        (flags & BodyStore.LINEAR_LOCKS) / BodyStore.LOCK_X * 2
            + (flags & BodyStore.FIXED_ROTATION)];
  }

  /**
   * Locks axes of the body's motion and frees the others. The velocity along an axis that is newly
   * locked becomes zero; from then on {@link #setVelocity} and {@link #setAngularVelocity} alone
   * decide it. Wakes the body. In a callback this takes effect at the end of the step.
   *
   * <p>Contacts see a locked axis as that of an immovable body. A joint between a locked body and a
   * free one gives way a little under sudden loads, because the lock takes back what the joint did.
   *
   * @param locks the locks, the rotation's included
   * @throws IllegalStateException during a query
   */
  public void setMotionLocks(MotionLocks locks) {
    check();
    Limits.notNull("locks", locks);
    world.edits().lockMotion(this, locks);
  }

  /**
   * Returns the number of shapes.
   *
   * @return as many as the definition had, and those that were added or removed since
   */
  public int shapeCount() {
    return shapes().length;
  }

  /**
   * Adds a shape, which becomes the last one. Mass, inertia and centre of mass are computed anew,
   * unless {@link #hasOwnMass}; the body's origin, the velocity there, its joints and all other
   * contacts stay. Wakes the body and what it touches. A body that was edited is the same as one
   * that was created so, except that the origin of a body whose centre of mass moves may round
   * otherwise.
   *
   * <p>In a callback this takes effect at the end of the step. Calls add up: the number of a shape
   * counts as if the calls before were carried out. Allocates.
   *
   * @param shape the shape with its material and filter, in the body frame
   * @throws IllegalArgumentException if the body is dynamic and the shape a line, or the body would
   *     have more than 1,024 convex parts
   * @throws IllegalStateException during a query
   */
  public void addShape(ShapeDef shape) {
    check();
    Limits.notNull("shape", shape);
    world.edits().addShape(this, shape);
  }

  /**
   * Removes a shape. Those with higher numbers move down by one. Its contacts and overlaps end now,
   * and {@link CollisionListener#end} is called. Everything else is as with {@link #addShape}. A
   * dynamic body without shapes has a mass of 1 kg.
   *
   * @param i number of the shape, below {@link #shapeCount}
   * @throws IllegalStateException during a query
   */
  public void removeShape(int i) {
    check();
    world.edits().removeShape(this, i);
  }

  /**
   * Replaces a shape by another one, which takes its number. The contacts and overlaps of the old
   * one end now, and {@link CollisionListener#end} is called; those of the new one begin in the
   * next step. Everything else is as with {@link #addShape}.
   *
   * @param i number of the shape, below {@link #shapeCount}
   * @param shape the new shape with its material and filter, in the body frame
   * @throws IllegalArgumentException as in {@link #addShape}
   * @throws IllegalStateException during a query
   */
  public void replaceShape(int i, ShapeDef shape) {
    check();
    Limits.notNull("shape", shape);
    world.edits().replaceShape(this, i, shape);
  }

  /**
   * Makes the body what a definition says: type, shapes, mass, locks, damping, gravity scale, sleep
   * speed and bullet. Origin, velocity, joints, user, and whether it may sleep or is enabled, stay;
   * what the definition says of these doesn't count. Contacts and overlaps of all shapes end now,
   * and {@link CollisionListener#end} is called; new ones begin in the next step, which pushes out
   * what overlaps. A static body is at rest. Wakes the body and what it touches.
   *
   * <p>In a callback, type, shapes, mass and locks change at the end of the step. Allocates.
   *
   * @param def what it becomes; copied
   * @throws IllegalArgumentException if it would be dynamic and the shapes have no mass, or have
   *     more than 1,024 convex parts; the body is unchanged
   * @throws IllegalStateException during a query
   */
  public void become(BodyDef def) {
    check();
    Limits.notNull("def", def);
    world.edits().become(this, def);
    float sleepsBelow =
        def.sleepSpeed == BodyStore.WORLDS ? world.def().sleepSpeed() : def.sleepSpeed;
    setLinearDamping(def.linearDamping);
    setAngularDamping(def.angularDamping);
    setGravityScale(def.gravityScale);
    setBullet(def.bullet);
    if (sleepSpeed() != sleepsBelow) {
      setSleepSpeed(sleepsBelow);
    }
  }

  /**
   * Returns the object that a shape stands for.
   *
   * @param i number of the shape, below {@link #shapeCount}
   * @return the user of its {@link ShapeDef}, may be null
   */
  public Object shapeUser(int i) {
    return shapeDef(i).user();
  }

  /**
   * Sets the object that a shape stands for. It changes nothing else. In a callback this takes
   * effect at the end of the step. Allocates.
   *
   * @param i number of the shape, below {@link #shapeCount}
   * @param user the object, may be null
   * @throws IllegalStateException during a query
   */
  public void setShapeUser(int i, Object user) {
    check();
    world.edits().changeShape("setShapeUser", this, i, shape -> shape.withUser(user));
  }

  /**
   * Returns a shape of the body.
   *
   * @param i number of the shape, below {@link #shapeCount}
   * @return the shape as it was given, in the body frame
   */
  public Shape shape(int i) {
    return shapeDef(i).shape();
  }

  /**
   * Returns the material of a shape.
   *
   * @param i number of the shape, below {@link #shapeCount}
   * @return the material
   */
  public Material material(int i) {
    return shapeDef(i).material();
  }

  /**
   * Sets the material of a shape. Mass, inertia and centre of mass are computed anew, unless {@link
   * #hasOwnMass}. Wakes the body and what it touches. In a callback this takes effect at the end of
   * the step. Allocates.
   *
   * @param i number of the shape, below {@link #shapeCount}
   * @param newMaterial the new material
   * @throws IllegalStateException during a query
   */
  public void setMaterial(int i, Material newMaterial) {
    check();
    world.edits().changeShape("setMaterial", this, i, shape -> shape.withMaterial(newMaterial));
  }

  /**
   * Returns the filter of a shape, which says what the shape collides with.
   *
   * @param i number of the shape, below {@link #shapeCount}
   * @return the filter
   */
  public Filter filter(int i) {
    return shapeDef(i).filter();
  }

  /**
   * Sets the filter of a shape. Contacts that it no longer allows end in the next step; those that
   * it newly allows begin there. Wakes the body and what it touches. In a callback this takes
   * effect at the end of the step. Allocates.
   *
   * @param i number of the shape, below {@link #shapeCount}
   * @param newFilter the new filter
   * @throws IllegalStateException during a query
   */
  public void setFilter(int i, Filter newFilter) {
    check();
    world.edits().changeShape("setFilter", this, i, shape -> shape.withFilter(newFilter));
  }

  /**
   * Asks the world's {@link CollisionFilter} about this body again, because its answer has changed.
   * Contacts that it no longer allows end in the next step; those that it newly allows begin there.
   * Wakes the body and what it touches. In a callback this takes effect at the end of the step.
   * Costs a look at all contacts of the world.
   *
   * @throws IllegalStateException during a query
   */
  public void refilter() {
    check();
    world.edits().refilter(this);
  }

  /**
   * Returns whether a shape is a sensor, see {@link ShapeDef}.
   *
   * @param i number of the shape, below {@link #shapeCount}
   * @return true if the shape reports overlaps and pushes nothing
   */
  public boolean sensor(int i) {
    return shapeDef(i).sensor();
  }

  /**
   * Makes a shape a sensor, or solid. If this is a change, all contacts of the body end, and begin
   * again in the next step. Wakes the body and what it touches. In a callback this takes effect at
   * the end of the step. Allocates.
   *
   * @param i number of the shape, below {@link #shapeCount}
   * @param sensor true for a sensor, false for a solid shape
   * @throws IllegalStateException during a query
   */
  public void setSensor(int i, boolean sensor) {
    check();
    world.edits().changeShape("setSensor", this, i, shape -> shape.withSensor(sensor));
  }

  /**
   * Computes the tight bounding box of all shapes.
   *
   * @param out receives the box, which is empty if the body has no shapes
   */
  public void aabb(Aabb out) {
    check();
    world.aabb(index, Limits.notNull("out", out));
  }

  /**
   * Returns the factor on the world's gravity.
   *
   * @return 1 by default
   */
  public float gravityScale() {
    check();
    return store.gravityScale[index];
  }

  /**
   * Sets the factor on the world's gravity.
   *
   * @param factor -1e3..1e3; with 0 the body floats
   */
  public void setGravityScale(float factor) {
    check();
    Limits.range("gravityScale", factor, -Limits.MAX_GRAVITY_SCALE, Limits.MAX_GRAVITY_SCALE);
    world.note(Call.SET_GRAVITY_SCALE, index, factor);
    if (store.gravityScale[index] != factor) {
      rouse();
      store.gravityScale[index] = factor;
      store.coldChanged();
    }
  }

  /**
   * Returns the rate at which velocity decays.
   *
   * @return 1/s
   */
  public float linearDamping() {
    check();
    return store.linearDamping[index];
  }

  /**
   * Sets the rate at which velocity decays.
   *
   * @param perSecond 1/s, 0..1e4
   */
  public void setLinearDamping(float perSecond) {
    check();
    Limits.range("linearDamping", perSecond, 0, Limits.MAX_DAMPING);
    world.note(Call.SET_LINEAR_DAMPING, index, perSecond);
    store.linearDamping[index] = perSecond;
    store.coldChanged();
  }

  /**
   * Returns the rate at which angular velocity decays.
   *
   * @return 1/s
   */
  public float angularDamping() {
    check();
    return store.angularDamping[index];
  }

  /**
   * Sets the rate at which angular velocity decays.
   *
   * @param perSecond 1/s, 0..1e4
   */
  public void setAngularDamping(float perSecond) {
    check();
    Limits.range("angularDamping", perSecond, 0, Limits.MAX_DAMPING);
    world.note(Call.SET_ANGULAR_DAMPING, index, perSecond);
    store.angularDamping[index] = perSecond;
    store.coldChanged();
  }

  /**
   * Visits the contacts of this body in the last step, in canonical order. They are part of the
   * saved state. Sensors are left out, see {@link #forEachOverlap}.
   *
   * @param visitor receives the other bodies; it must not destroy bodies
   */
  public void forEachContact(BodyContactVisitor<T> visitor) {
    check();
    world.forEachContact(index, Limits.notNull("visitor", visitor));
  }

  /**
   * Visits the bodies that were inside this body's sensors in the last step, and those whose
   * sensors it was inside, in canonical order. They are part of the saved state.
   *
   * @param visitor receives the other bodies, each once; it must not destroy bodies
   */
  public void forEachOverlap(BodyVisitor<T> visitor) {
    check();
    world.forEachOverlap(index, Limits.notNull("visitor", visitor));
  }

  /**
   * Visits the joints of this body, the newest first.
   *
   * @param visitor receives the joints; it may destroy the joint it receives
   */
  public void forEachJoint(Consumer<Joint<T>> visitor) {
    check();
    world.forEachJoint(index, Limits.notNull("visitor", visitor));
  }

  /**
   * Returns whether a joint holds this body, to another one or to the world.
   *
   * @return false for a body without joints
   */
  public boolean hasJoints() {
    check();
    return world.hasJoints(index);
  }

  @Override
  public String toString() {
    return "Body(" + type() + " " + index + ":" + generation + " " + user + ")";
  }
}
