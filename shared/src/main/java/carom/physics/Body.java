package carom.physics;

import carom.physics.dynamics.Dynamics;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.body.ShapeSpec;
import carom.physics.geometry.Shape;
import carom.physics.math.Aabb;
import carom.physics.math.Limits;
import carom.physics.math.StateHash;
import carom.physics.math.Trig;
import java.util.function.Consumer;

/**
 * A body: a light handle (index and generation) on the world's arrays. There is one handle per
 * body, so handles may be compared with ==.
 *
 * <p>All methods except {@link #isValid}, {@link #index}, {@link #generation}, {@link #type},
 * {@link #user} and the shape accessors throw IllegalStateException once the body was destroyed.
 * Numbers that are not finite or absurd (beyond 1e7 m, 1e5 m/s) throw IllegalArgumentException with
 * the value. Nothing allocates.
 *
 * <p>A body that rests for a while falls asleep with all that it touches, see {@link #awake}. It
 * wakes by itself when something moves it or what it touches; setting what it has already doesn't
 * wake it.
 *
 * <p>Forces and impulses add up, act in the next step, and are then forgotten; on static and
 * kinematic bodies, and on disabled ones, they do nothing.
 *
 * <p><b>Length.</b> The class has one getter or setter per property of a body, each with its unit
 * and range; none of them is longer than a few lines.
 *
 * @param <T> the user's type
 */
public final class Body<T> {
  private static final BodyType[] TYPES = BodyType.values();

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
   * The body's slot, used again after it is destroyed.
   *
   * @return 0 or more
   */
  public int index() {
    return index;
  }

  /**
   * Tells the bodies apart that used the same slot.
   *
   * @return 0 or more
   */
  public int generation() {
    return generation;
  }

  /**
   * Whether the body still exists.
   *
   * @return false once it was destroyed
   */
  public boolean isValid() {
    return store.alive(index, generation);
  }

  /**
   * What the body stands for.
   *
   * @return as given to {@link World#createBody}
   */
  public T user() {
    return user;
  }

  /**
   * What may move the body.
   *
   * @return of a destroyed body, what it was made as
   */
  public BodyType type() {
    return isValid() ? TYPES[store.type[index]] : type;
  }

  /**
   * Makes the body static, kinematic or dynamic. Origin and velocity stay, except that a static
   * body is at rest; forces that wait are forgotten. In a callback this takes effect at the end of
   * the step. Allocates.
   *
   * @param newType what may move it from now on
   * @throws IllegalArgumentException if it is to be dynamic and its shapes have no mass
   * @throws IllegalStateException during a query
   */
  public void setType(BodyType newType) {
    check();
    world.edits().changeType(this, newType);
  }

  /**
   * Whether the body takes part in the simulation.
   *
   * @return true unless {@link #setEnabled} said otherwise
   */
  public boolean isEnabled() {
    check();
    return !store.disabled(index);
  }

  /**
   * Takes the body out of the simulation, or back in: a disabled body keeps pose and velocity, but
   * doesn't move, feels no forces, collides with nothing, is found by no query, and its joints are
   * idle. Its contacts end in the next step. In a callback this takes effect at the end of the
   * step.
   *
   * @param enabled whether it takes part from now on
   * @throws IllegalStateException during a query
   */
  public void setEnabled(boolean enabled) {
    check();
    world.edits().enable(this, enabled);
  }

  /**
   * Whether the body is awake: dynamic or kinematic, enabled, and not asleep. A sleeping body is at
   * rest and costs nothing. It wakes with its whole island (dynamic bodies that hold each other by
   * contacts or joints), in the step in which something awake begins to touch it.
   *
   * @return false for static bodies
   */
  public boolean awake() {
    check();
    int flags = store.flags[index] & (BodyStore.ASLEEP | BodyStore.DISABLED);
    return flags == 0 && store.type[index] != BodyStore.STATIC;
  }

  /**
   * Wakes the body and its island; if it is awake, its time of rest starts again. In a callback
   * this takes effect at the end of the step.
   */
  public void wake() {
    check();
    dynamics().wake(index);
  }

  /**
   * Puts the body and its island to sleep at once; velocities and waiting forces are gone then.
   * Nothing happens if one of them may not sleep or touches what it may not touch any longer (a
   * body that was disabled, say, or filtered out since the last step), or nothing sleeps in this
   * world. In a callback this takes effect at the end of the step.
   *
   * @throws IllegalStateException during a query
   */
  public void sleep() {
    check();
    world.sleep(index);
  }

  /**
   * Whether the body may fall asleep.
   *
   * @return true unless it was said otherwise
   */
  public boolean sleepAllowed() {
    check();
    return (store.flags[index] & BodyStore.SLEEPLESS) == 0;
  }

  /**
   * Sets whether the body may fall asleep; if not, it wakes, and keeps awake all that it touches.
   *
   * @param allowed true by default
   */
  public void setSleepAllowed(boolean allowed) {
    check();
    if (allowed) {
      store.flags[index] &= ~BodyStore.SLEEPLESS;
    } else {
      store.flags[index] |= BodyStore.SLEEPLESS;
      dynamics().wake(index);
    }
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

  /** Whether forces do something. */
  private boolean acts() {
    return store.type[index] == BodyStore.DYNAMIC && !store.disabled(index);
  }

  ShapeSpec[] specs() {
    return World.specs(shapes());
  }

  /** Of a destroyed body, what it was made of. */
  ShapeDef[] shapes() {
    return isValid() ? world.shapes(index) : firstShapes;
  }

  /**
   * The body's origin.
   *
   * @return x, m
   */
  public float x() {
    check();
    return store.originX(index);
  }

  /**
   * The body's origin.
   *
   * @return y, m
   */
  public float y() {
    check();
    return store.originY(index);
  }

  /**
   * The centre of mass; equals the origin for static and kinematic bodies.
   *
   * @return x, m
   */
  public float centerX() {
    check();
    return store.x[index];
  }

  /**
   * The centre of mass; equals the origin for static and kinematic bodies.
   *
   * @return y, m
   */
  public float centerY() {
    check();
    return store.y[index];
  }

  /**
   * Cosine of the rotation.
   *
   * @return -1 to 1
   */
  public float cos() {
    check();
    return store.cos[index];
  }

  /**
   * Sine of the rotation.
   *
   * @return -1 to 1
   */
  public float sin() {
    check();
    return store.sin[index];
  }

  /**
   * The rotation as an angle.
   *
   * @return rad, -pi to pi, counter-clockwise
   */
  public float angle() {
    check();
    return Trig.atan2(store.sin[index], store.cos[index]);
  }

  /**
   * Velocity of the centre of mass.
   *
   * @return x, m/s
   */
  public float velocityX() {
    check();
    return store.vx[index];
  }

  /**
   * Velocity of the centre of mass.
   *
   * @return y, m/s
   */
  public float velocityY() {
    check();
    return store.vy[index];
  }

  /**
   * Angular velocity.
   *
   * @return rad/s, counter-clockwise
   */
  public float angularVelocity() {
    check();
    return store.w[index];
  }

  /**
   * Teleports the body.
   *
   * @param x origin, m
   * @param y origin, m
   * @param angleRad rad
   */
  public void setPose(float x, float y, float angleRad) {
    Limits.range("angle", angleRad, -1e5f, 1e5f);
    setPose(x, y, Trig.cos(angleRad), Trig.sin(angleRad));
  }

  /**
   * Teleports the body.
   *
   * @param x origin, m
   * @param y origin, m
   * @param cos cosine of the rotation
   * @param sin sine; (cos, sin) is taken bit for bit if its length is 1 up to rounding, else
   *     normalised
   */
  public void setPose(float x, float y, float cos, float sin) {
    check();
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
   * Teleports the body by its centre of mass, which is what the world stores: what {@link
   * #centerX}, {@link #centerY}, {@link #cos} and {@link #sin} returned is set again bit for bit.
   *
   * @param x centre of mass, m
   * @param y centre of mass, m
   * @param cos cosine of the rotation
   * @param sin sine
   */
  public void setCenterPose(float x, float y, float cos, float sin) {
    check();
    float oldX = store.x[index];
    float oldY = store.y[index];
    float oldCos = store.cos[index];
    float oldSin = store.sin[index];
    store.setCenterPose(index, x, y, cos, sin);
    movedFrom(oldX, oldY, oldCos, oldSin);
  }

  /**
   * Sets the velocity of the centre of mass; nothing on a static body.
   *
   * @param vx m/s
   * @param vy m/s
   */
  public void setVelocity(float vx, float vy) {
    check();
    Limits.velocity("velocityX", vx);
    Limits.velocity("velocityY", vy);
    if (store.type[index] != BodyStore.STATIC) {
      if (vx != 0 || vy != 0) {
        rouse();
      }
      store.vx[index] = vx;
      store.vy[index] = vy;
    }
  }

  /**
   * Sets the angular velocity; nothing on a static body.
   *
   * @param radPerSecond rad/s, counter-clockwise
   */
  public void setAngularVelocity(float radPerSecond) {
    check();
    Limits.velocity("angularVelocity", radPerSecond);
    if (store.type[index] != BodyStore.STATIC) {
      if (radPerSecond != 0) {
        rouse();
      }
      store.w[index] = radPerSecond;
    }
  }

  /**
   * Pulls at the centre of mass during the next step.
   *
   * @param fx N
   * @param fy N
   */
  public void applyForce(float fx, float fy) {
    check();
    Limits.force("forceX", fx);
    Limits.force("forceY", fy);
    if (acts() && (fx != 0 || fy != 0)) {
      dynamics().wake(index);
      store.forceX[index] += fx;
      store.forceY[index] += fy;
    }
  }

  /**
   * Pulls at a point during the next step: the force at the centre, and its torque.
   *
   * @param fx N
   * @param fy N
   * @param px point of application, m, world
   * @param py point of application, m, world
   */
  public void applyForce(float fx, float fy, float px, float py) {
    Limits.coordinate("px", px);
    Limits.coordinate("py", py);
    applyForce(fx, fy);
    if (acts()) {
      store.torque[index] += (px - store.x[index]) * fy - (py - store.y[index]) * fx;
    }
  }

  /**
   * Pulls during the next step, as gravity does: by something that is always there, such as a fluid
   * or a wind. Other than by {@link #applyForce} the body may fall asleep in spite of it; a
   * sleeping body is left alone.
   *
   * @param fx N
   * @param fy N
   * @param torque N m, counter-clockwise
   */
  public void applyAmbientForce(float fx, float fy, float torque) {
    check();
    Limits.force("forceX", fx);
    Limits.force("forceY", fy);
    Limits.force("torque", torque);
    if (acts() && !store.asleep(index)) {
      store.forceX[index] += fx;
      store.forceY[index] += fy;
      store.torque[index] += torque;
    }
  }

  /**
   * A number that changes when anybody moves this body or pushes it: a hash of pose, velocities,
   * and of the forces and impulses that wait for the next step.
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
   * Kicks the centre of mass: at the start of the next step the velocity changes by J / m.
   *
   * @param jx N s
   * @param jy N s
   */
  public void applyImpulse(float jx, float jy) {
    check();
    Limits.force("impulseX", jx);
    Limits.force("impulseY", jy);
    if (acts() && (jx != 0 || jy != 0)) {
      dynamics().wake(index);
      store.impulseX[index] += jx;
      store.impulseY[index] += jy;
    }
  }

  /**
   * Kicks a point: as at the centre, and the angular velocity changes by r x J / I.
   *
   * @param jx N s
   * @param jy N s
   * @param px point of application, m, world
   * @param py point of application, m, world
   */
  public void applyImpulse(float jx, float jy, float px, float py) {
    Limits.coordinate("px", px);
    Limits.coordinate("py", py);
    applyImpulse(jx, jy);
    if (acts()) {
      store.impulseW[index] += (px - store.x[index]) * jy - (py - store.y[index]) * jx;
    }
  }

  /**
   * Turns the body during the next step.
   *
   * @param torque N m, counter-clockwise
   */
  public void applyTorque(float torque) {
    check();
    Limits.force("torque", torque);
    if (acts() && torque != 0) {
      dynamics().wake(index);
      store.torque[index] += torque;
    }
  }

  /**
   * Kicks the rotation: at the start of the next step the angular velocity changes by j / I.
   *
   * @param j N m s, counter-clockwise
   */
  public void applyAngularImpulse(float j) {
    check();
    Limits.force("angularImpulse", j);
    if (acts() && j != 0) {
      dynamics().wake(index);
      store.impulseW[index] += j;
    }
  }

  /**
   * Steers towards a velocity: applies the force F = k (goal - v) for the next step.
   *
   * <p>Called before every step of dt, the difference shrinks by the factor {@code 1 - k dt / m}; k
   * above {@code m / dt} would overshoot and is cut to it, which reaches the goal in one step.
   *
   * @param goalX m/s
   * @param goalY m/s
   * @param k strength, kg/s, not negative
   * @param dtSeconds the length of the next step, s
   */
  public void seekVelocity(float goalX, float goalY, float k, float dtSeconds) {
    Limits.timeStep(dtSeconds);
    seekVelocity(goalX, goalY, Math.min(k, mass() / dtSeconds));
  }

  /**
   * Steers towards a velocity: applies the force F = k (goal - v) for the next step, as it is. Keep
   * k below {@code m / dt}, or the body overshoots.
   *
   * @param goalX m/s
   * @param goalY m/s
   * @param k strength, kg/s, not negative
   */
  public void seekVelocity(float goalX, float goalY, float k) {
    check();
    Limits.velocity("goalX", goalX);
    Limits.velocity("goalY", goalY);
    Limits.range("k", k, 0, 1e12f);
    applyForce(k * (goalX - store.vx[index]), k * (goalY - store.vy[index]));
  }

  /**
   * Whether the body is a bullet, see {@link BodyDef#bullet}.
   *
   * @return true if it is stopped at dynamic bodies, too
   */
  public boolean isBullet() {
    check();
    return store.bullet(index);
  }

  /**
   * Makes the body a bullet, or an ordinary body; see {@link BodyDef#bullet}.
   *
   * @param bullet true to stop it at dynamic bodies, too, however fast it is
   */
  public void setBullet(boolean bullet) {
    check();
    store.setBullet(index, bullet);
  }

  /**
   * Mass.
   *
   * @return kg; 0 if not dynamic
   */
  public float mass() {
    check();
    return store.mass[index];
  }

  /**
   * Moment of inertia about the centre of mass.
   *
   * @return kg m^2; 0 if not dynamic or rotation is fixed
   */
  public float inertia() {
    check();
    return store.inertia[index];
  }

  /**
   * The centre of mass in the body frame.
   *
   * @return x, m; 0 if not dynamic
   */
  public float localCenterX() {
    check();
    return store.localX[index];
  }

  /**
   * The centre of mass in the body frame.
   *
   * @return y, m; 0 if not dynamic
   */
  public float localCenterY() {
    check();
    return store.localY[index];
  }

  /**
   * Sets what the body weighs while it is dynamic, instead of what its shapes and densities say.
   * The body's origin, and the velocity there, stay. Wakes it. In a callback this takes effect at
   * the end of the step.
   *
   * @param kilograms 1e-9 to 1e15
   * @param inertia moment of inertia about the centre of mass, kg m^2, 1e-20 to 1e20; 0 for a body
   *     that no force turns
   * @param centerX centre of mass in the body frame, m
   * @param centerY centre of mass in the body frame, m
   * @throws IllegalStateException during a query
   */
  public void setMass(float kilograms, float inertia, float centerX, float centerY) {
    check();
    world.edits().changeMass(this, BodyDef.checkedMass(kilograms, inertia, centerX, centerY));
  }

  /**
   * Goes back to the mass that shapes and densities say, see {@link #setMass}.
   *
   * @throws IllegalArgumentException if the body is dynamic and its shapes have no mass
   * @throws IllegalStateException during a query
   */
  public void computeMass() {
    check();
    world.edits().changeMass(this, null);
  }

  /**
   * Whether mass is what {@link #setMass} or {@link BodyDef#mass} said.
   *
   * @return false if it is computed from the shapes
   */
  public boolean hasOwnMass() {
    check();
    return world.ownMass(index) != null;
  }

  /**
   * Whether no force turns the body.
   *
   * @return see {@link BodyDef#fixedRotation}
   */
  public boolean isFixedRotation() {
    check();
    return (store.flags[index] & BodyStore.FIXED_ROTATION) != 0;
  }

  /**
   * Fixes the rotation, which stops, or frees it. Wakes the body. In a callback this takes effect
   * at the end of the step.
   *
   * @param fixed true if no force shall turn the body
   * @throws IllegalStateException during a query
   */
  public void setFixedRotation(boolean fixed) {
    check();
    world.edits().fixRotation(this, fixed);
  }

  /**
   * The number of shapes.
   *
   * @return as many as were given
   */
  public int shapeCount() {
    return firstShapes.length;
  }

  /**
   * A shape.
   *
   * @param i below {@link #shapeCount}
   * @return in the body frame, as it was given
   */
  public Shape shape(int i) {
    return shapes()[i].shape();
  }

  /**
   * What a shape is made of.
   *
   * @param i below {@link #shapeCount}
   * @return its material
   */
  public Material material(int i) {
    return shapes()[i].material();
  }

  /**
   * Makes a shape of another material. Mass, inertia and centre of mass are computed anew, unless
   * {@link #hasOwnMass}. Wakes the body and what it touches. In a callback this takes effect at the
   * end of the step. Allocates.
   *
   * @param i below {@link #shapeCount}
   * @param newMaterial what it is made of from now on
   * @throws IllegalStateException during a query
   */
  public void setMaterial(int i, Material newMaterial) {
    check();
    world.edits().changeShape(this, i, shape -> shape.withMaterial(newMaterial));
  }

  /**
   * Whom a shape meets.
   *
   * @param i below {@link #shapeCount}
   * @return its filter
   */
  public Filter filter(int i) {
    return shapes()[i].filter();
  }

  /**
   * Sets whom a shape meets. Contacts that it no longer allows end in the next step, those that it
   * newly allows begin there. Wakes the body and what it touches. In a callback this takes effect
   * at the end of the step. Allocates.
   *
   * @param i below {@link #shapeCount}
   * @param newFilter whom it meets from now on
   * @throws IllegalStateException during a query
   */
  public void setFilter(int i, Filter newFilter) {
    check();
    world.edits().changeShape(this, i, shape -> shape.withFilter(newFilter));
  }

  /**
   * Whether a shape only notices.
   *
   * @param i below {@link #shapeCount}
   * @return true if it pushes nothing
   */
  public boolean sensor(int i) {
    return shapes()[i].sensor();
  }

  /**
   * Makes a shape a sensor, or solid. If it wasn't already, all contacts of the body end, and begin
   * again in the next step. Wakes the body and what it touches. In a callback this takes effect at
   * the end of the step. Allocates.
   *
   * @param i below {@link #shapeCount}
   * @param sensor whether it only notices from now on
   * @throws IllegalStateException during a query
   */
  public void setSensor(int i, boolean sensor) {
    check();
    world.edits().changeShape(this, i, shape -> shape.withSensor(sensor));
  }

  /**
   * The tight bounding box of all shapes.
   *
   * @param out receives the box; empty without shapes
   */
  public void aabb(Aabb out) {
    check();
    world.aabb(index, out);
  }

  /**
   * Factor on the world's gravity.
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
   * @param factor 0 floats; within 1e3
   */
  public void setGravityScale(float factor) {
    check();
    Limits.range("gravityScale", factor, -Limits.MAX_GRAVITY_SCALE, Limits.MAX_GRAVITY_SCALE);
    if (store.gravityScale[index] != factor) {
      rouse();
      store.gravityScale[index] = factor;
      store.coldChanged();
    }
  }

  /**
   * Rate at which velocity decays.
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
   * @param perSecond 1/s, 0 to 1e4
   */
  public void setLinearDamping(float perSecond) {
    check();
    store.linearDamping[index] = Limits.range("linearDamping", perSecond, 0, Limits.MAX_DAMPING);
    store.coldChanged();
  }

  /**
   * Rate at which angular velocity decays.
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
   * @param perSecond 1/s, 0 to 1e4
   */
  public void setAngularDamping(float perSecond) {
    check();
    store.angularDamping[index] = Limits.range("angularDamping", perSecond, 0, Limits.MAX_DAMPING);
    store.coldChanged();
  }

  /**
   * Visits what touched this body in the last step, in canonical order; part of the saved state.
   * Sensors are not among them, see {@link #forEachOverlap}.
   *
   * @param visitor receives the other bodies; it must not destroy bodies
   */
  public void forEachContact(BodyContactVisitor<T> visitor) {
    check();
    world.forEachContact(index, visitor);
  }

  /**
   * Visits what was inside this body's sensors in the last step, and whose sensors it was in
   * itself, in canonical order; part of the saved state.
   *
   * @param visitor receives the other bodies, each once; it must not destroy bodies
   */
  public void forEachOverlap(BodyVisitor<T> visitor) {
    check();
    world.forEachOverlap(index, visitor);
  }

  /**
   * Visits the joints that hold this body, the newest first.
   *
   * @param visitor receives them; it may destroy the joint it receives
   */
  public void forEachJoint(Consumer<Joint<T>> visitor) {
    check();
    world.forEachJoint(index, visitor);
  }

  @Override
  public String toString() {
    return "Body(" + type() + " " + index + ":" + generation + " " + user + ")";
  }
}
