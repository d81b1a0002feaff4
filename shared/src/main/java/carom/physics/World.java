package carom.physics;

import carom.physics.broadphase.CellVisitor;
import carom.physics.broadphase.IntVisitor;
import carom.physics.dynamics.BodyContacts;
import carom.physics.dynamics.BodyStore;
import carom.physics.dynamics.Checks;
import carom.physics.dynamics.ContactEvents;
import carom.physics.dynamics.ContactTable;
import carom.physics.dynamics.Dynamics;
import carom.physics.dynamics.Excerpt;
import carom.physics.dynamics.JointEvents;
import carom.physics.dynamics.JointStore;
import carom.physics.dynamics.Settings;
import carom.physics.dynamics.ShapeSpec;
import carom.physics.dynamics.StageListener;
import carom.physics.dynamics.Stamp;
import carom.physics.geometry.MassData;
import carom.physics.math.Aabb;
import carom.physics.math.Transform;
import carom.physics.math.Trig;
import carom.physics.threads.Workers;
import java.util.Arrays;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;

/**
 * A rigid-body world: create bodies, step, look.
 *
 * <p>A pure function of its {@link WorldDef} and the calls made: equal calls in equal order give
 * equal bits on every JVM, and {@link #stateHash} proves it. One thread at a time. A steady {@link
 * #step} allocates nothing.
 *
 * @param <T> what bodies stand for in the user's program, see {@link Body#user()}
 */
public final class World<T> {
  private static final byte DESTROY_BODY = 0;
  private static final byte DESTROY_JOINT = 1;
  private static final byte ENABLE = 2;
  private static final byte DISABLE = 3;

  /** Plus the new type's code. */
  private static final byte CHANGE_TYPE = 4;

  private static final byte CHANGE_SHAPE = 7;
  private static final byte CHANGE_MASS = 8;
  private static final byte FIX_ROTATION = 9;
  private static final byte FREE_ROTATION = 10;

  /** Another material, filter or kind for one of a body's shapes. */
  private record ShapeChange(int shape, UnaryOperator<ShapeDef> how) {
    ShapeDef[] of(ShapeDef[] shapes) {
      ShapeDef[] changed = shapes.clone();
      changed[shape] = how.apply(shapes[shape]);
      return changed;
    }
  }

  private final WorldDef def;
  private final Dynamics dynamics;
  private final BodyStore store;
  private final Collision<T> collision;
  private final JointStore joints;
  private final Events events = new Events();
  private final Queries<T> queries;
  private long moves;
  private final JointEvents onBroke = this::broke;

  /** Handles by slot; those of free slots are null. */
  private Object[] handles = new Object[64];

  /** What bodies consist of, by slot, and what they weigh if it isn't computed from that. */
  private ShapeDef[][] shapes = new ShapeDef[64][];

  private MassData[] ownMasses = new MassData[64];

  private Object[] jointHandles = new Object[0];

  /** Changes whenever a body comes, goes, or changes what the broadphase knows of it. */
  private final Stamp structure = new Stamp();

  /** Changes whenever a joint comes or goes. */
  private final Stamp jointStructure = new Stamp();

  private CollisionListener<T> listener;
  private JointListener<T> jointListener;

  private boolean stepping;
  private boolean querying;

  /** What was asked for in a callback: what, to which slot of which generation. */
  private byte[] pending = new byte[8];

  private int[] pendingSlot = new int[8];
  private int[] pendingGeneration = new int[8];
  private Object[] pendingValue = new Object[8];
  private int pendingCount;

  private final Aabb box = new Aabb();
  private final Aabb queryBox = new Aabb();
  private final Transform pose = new Transform();
  private int[] found = new int[16];
  private int foundCount;
  private final IntVisitor collect = this::collect;

  /**
   * Makes an empty world.
   *
   * @param def its constants
   */
  public World(WorldDef def) {
    this.def = def;
    dynamics =
        new Dynamics(
            new Settings(
                def.gravityX(),
                def.gravityY(),
                def.substeps(),
                def.contactHertz(),
                def.contactDampingRatio(),
                def.restitutionThreshold(),
                def.maxPushSpeed(),
                def.slop(),
                def.speculativeDistance(),
                def.aabbMargin(),
                def.maxSpeed(),
                def.maxAngularSpeed(),
                def.jointHertz(),
                def.jointDampingRatio(),
                def.sleeping(),
                def.sleepSpeed(),
                def.sleepDelay(),
                def.continuous(),
                def.hitSpeed(),
                def.integrator() == Integrator.EXPLICIT_EULER));
    store = dynamics.bodies();
    joints = dynamics.joints();
    collision = new Collision<>(this, dynamics.contacts());
    queries = new Queries<>(this, null);
  }

  /**
   * The constants this world was made with.
   *
   * @return the definition
   */
  public WorldDef def() {
    return def;
  }

  /**
   * Gravity.
   *
   * @return x, m/s^2
   */
  public float gravityX() {
    return def.gravityX();
  }

  /**
   * Gravity.
   *
   * @return y, m/s^2
   */
  public float gravityY() {
    return def.gravityY();
  }

  /**
   * Makes a body. In a callback, too: it then collides from the next step on.
   *
   * @param bodyDef what it is made from; copied
   * @param user what it stands for, may be null
   * @return its handle
   * @throws IllegalArgumentException if the shapes of a dynamic body have no mass
   * @throws IllegalStateException during a query
   */
  public Body<T> createBody(BodyDef bodyDef, T user) {
    refuseDuringQuery("createBody");
    ShapeDef[] given = bodyDef.shapes.toArray(new ShapeDef[0]);
    int slot =
        dynamics.create(code(bodyDef.type), specs(given), bodyDef.mass, bodyDef.fixedRotation);
    store.setOriginPose(
        slot, bodyDef.x, bodyDef.y, Trig.cos(bodyDef.angle), Trig.sin(bodyDef.angle));
    if (bodyDef.type != BodyType.STATIC) {
      store.vx[slot] = bodyDef.vx;
      store.vy[slot] = bodyDef.vy;
      store.w[slot] = bodyDef.angularVelocity;
    }
    store.linearDamping[slot] = bodyDef.linearDamping;
    store.angularDamping[slot] = bodyDef.angularDamping;
    store.gravityScale[slot] = bodyDef.gravityScale;
    store.setBullet(slot, bodyDef.bullet);
    if (!bodyDef.sleepAllowed) {
      store.flags[slot] |= BodyStore.SLEEPLESS;
    }
    dynamics.enter(slot, bodyDef.awake);
    if (slot >= handles.length) {
      handles = Arrays.copyOf(handles, Math.max(slot + 1, handles.length * 2));
      shapes = Arrays.copyOf(shapes, handles.length);
      ownMasses = Arrays.copyOf(ownMasses, handles.length);
    }
    shapes[slot] = given;
    ownMasses[slot] = bodyDef.mass;
    Body<T> body = new Body<>(this, store, slot, store.generation[slot], bodyDef.type, given, user);
    handles[slot] = body;
    structure.change();
    return body;
  }

  static ShapeSpec[] specs(ShapeDef[] shapes) {
    ShapeSpec[] specs = new ShapeSpec[shapes.length];
    for (int i = 0; i < shapes.length; i++) {
      Material m = shapes[i].material();
      Filter f = shapes[i].filter();
      specs[i] =
          new ShapeSpec(
              shapes[i].shape(),
              m.density(),
              m.friction(),
              m.restitution(),
              m.rollingResistance(),
              m.tangentSpeed(),
              f.category(),
              f.mask(),
              f.group(),
              shapes[i].sensor());
    }
    return specs;
  }

  private static byte code(BodyType type) {
    return switch (type) {
      case STATIC -> BodyStore.STATIC;
      case KINEMATIC -> BodyStore.KINEMATIC;
      case DYNAMIC -> BodyStore.DYNAMIC;
    };
  }

  /**
   * Removes a body and its joints; touching contacts end first. In a callback this takes effect at
   * the end of the step, and until then the body stays as it is.
   *
   * @param body of this world
   * @throws IllegalStateException if it was destroyed before, or during a query
   */
  public void destroyBody(Body<T> body) {
    refuseDuringQuery("destroyBody");
    own(body);
    request(DESTROY_BODY, body.index(), body.generation(), null);
  }

  /** Has something done now, or at the end of the step. */
  private void request(byte what, int slot, int generation, Object value) {
    if (pendingCount == pending.length) {
      pending = Arrays.copyOf(pending, pendingCount * 2);
      pendingSlot = Arrays.copyOf(pendingSlot, pendingCount * 2);
      pendingGeneration = Arrays.copyOf(pendingGeneration, pendingCount * 2);
      pendingValue = Arrays.copyOf(pendingValue, pendingCount * 2);
    }
    pending[pendingCount] = what;
    pendingSlot[pendingCount] = slot;
    pendingValue[pendingCount] = value;
    pendingGeneration[pendingCount++] = generation;
    if (!stepping) {
      stepping = true;
      try {
        carryOut();
      } finally {
        stepping = false;
      }
    }
  }

  /** Does what was asked for; end callbacks may ask for more. */
  private void carryOut() {
    try {
      for (int i = 0; i < pendingCount; i++) {
        int slot = pendingSlot[i];
        int generation = pendingGeneration[i];
        if (pending[i] == DESTROY_JOINT) {
          if (joints.alive(slot, generation)) {
            removeJoint(slot);
          }
        } else if (store.alive(slot, generation)) {
          carryOut(pending[i], slot, pendingValue[i]);
        }
      }
    } finally {
      Arrays.fill(pendingValue, 0, pendingCount, null);
      pendingCount = 0;
    }
  }

  private void carryOut(byte what, int slot, Object value) {
    switch (what) {
      case DESTROY_BODY -> removeBody(slot);
      case ENABLE, DISABLE -> dynamics.setEnabled(slot, what == ENABLE);
      case CHANGE_SHAPE -> changeShape(slot, (ShapeChange) value);
      case CHANGE_MASS -> {
        dynamics.change(slot, specs(shapes[slot]), (MassData) value);
        ownMasses[slot] = (MassData) value;
      }
      case FIX_ROTATION, FREE_ROTATION -> {
        dynamics.setFixedRotation(slot, what == FIX_ROTATION);
        dynamics.change(slot, specs(shapes[slot]), ownMasses[slot]);
      }
      default ->
          dynamics.setType(slot, (byte) (what - CHANGE_TYPE), specs(shapes[slot]), ownMasses[slot]);
    }
    structure.change();
  }

  private void changeShape(int slot, ShapeChange change) {
    ShapeDef[] changed = change.of(shapes[slot]);
    if (changed[change.shape].sensor() != shapes[slot][change.shape].sensor()) {
      dynamics.endContacts(slot, listener == null ? null : events);
    }
    dynamics.change(slot, specs(changed), ownMasses[slot]);
    shapes[slot] = changed;
  }

  void enable(Body<T> body, boolean enabled) {
    refuseDuringQuery("setEnabled");
    request(enabled ? ENABLE : DISABLE, body.index(), body.generation(), null);
  }

  void changeType(Body<T> body, BodyType type) {
    refuseDuringQuery("setType");
    if (type == BodyType.DYNAMIC) {
      Dynamics.checkMass(body.specs(), ownMass(body.index()));
    }
    request((byte) (CHANGE_TYPE + code(type)), body.index(), body.generation(), null);
  }

  void changeShape(Body<T> body, int shape, UnaryOperator<ShapeDef> how) {
    refuseDuringQuery("changing a shape");
    if (shape < 0 || shape >= body.shapeCount()) {
      throw new IndexOutOfBoundsException(
          "shape=" + shape + " is outside 0.." + (body.shapeCount() - 1) + "; see shapeCount()");
    }
    ShapeChange change = new ShapeChange(shape, how);
    ShapeDef[] changed = change.of(shapes(body.index()));
    if (body.type() == BodyType.DYNAMIC) {
      Dynamics.checkMass(specs(changed), ownMass(body.index()));
    }
    request(CHANGE_SHAPE, body.index(), body.generation(), change);
  }

  void changeMass(Body<T> body, MassData ownOrNull) {
    refuseDuringQuery("setMass");
    if (body.type() == BodyType.DYNAMIC) {
      Dynamics.checkMass(body.specs(), ownOrNull);
    }
    request(CHANGE_MASS, body.index(), body.generation(), ownOrNull);
  }

  void fixRotation(Body<T> body, boolean fixed) {
    refuseDuringQuery("setFixedRotation");
    request(fixed ? FIX_ROTATION : FREE_ROTATION, body.index(), body.generation(), null);
  }

  ShapeDef[] shapes(int slot) {
    return shapes[slot];
  }

  MassData ownMass(int slot) {
    return ownMasses[slot];
  }

  private void removeBody(int slot) {
    while (joints.firstEnd(slot) >= 0) {
      removeJoint(joints.firstEnd(slot) >> 1);
    }
    dynamics.destroy(slot, listener == null ? null : events);
    handles[slot] = null;
    shapes[slot] = null;
    ownMasses[slot] = null;
  }

  private void removeJoint(int slot) {
    dynamics.destroyJoint(slot);
    jointHandles[slot] = null;
    jointStructure.change();
  }

  /**
   * Makes a joint. In a callback before the solver it acts in this step already; that the bodies no
   * longer collide takes effect in the next one.
   *
   * @param d what it is made from
   * @return its handle
   * @throws IllegalStateException if a body was destroyed, or during a query
   */
  public Joint<T> createJoint(JointDef<T> d) {
    refuseDuringQuery("createJoint");
    own(d.bodyB);
    if (d.bodyA != null) {
      own(d.bodyA);
    }
    int a = d.bodyA == null ? -1 : d.bodyA.index();
    int b = d.bodyB.index();
    float cA = a < 0 ? 1 : store.cos[a];
    float sA = a < 0 ? 0 : store.sin[a];
    int j = dynamics.createJoint((byte) d.type.ordinal(), a, b);
    joints.flags[j] = d.flags();
    joints.anchorAx[j] = a < 0 ? d.ax : localX(a, d.ax, d.ay);
    joints.anchorAy[j] = a < 0 ? d.ay : localY(a, d.ax, d.ay);
    joints.anchorBx[j] = localX(b, d.bx, d.by);
    joints.anchorBy[j] = localY(b, d.bx, d.by);
    joints.axisX[j] = cA * d.axisX + sA * d.axisY;
    joints.axisY[j] = cA * d.axisY - sA * d.axisX;
    joints.refCos[j] = store.cos[b] * cA + store.sin[b] * sA;
    joints.refSin[j] = store.sin[b] * cA - store.cos[b] * sA;
    joints.rest[j] = d.rest;
    couple(d, j);
    if (!d.restGiven && d.type == JointType.DISTANCE) {
      joints.rest[j] = length(d.bx - d.ax, d.by - d.ay);
    }
    joints.lower[j] = d.lower;
    joints.upper[j] = d.upper;
    joints.motorSpeed[j] = d.motorSpeed;
    joints.motorMax[j] = d.motorMax;
    joints.hertz[j] = d.hertz;
    joints.damping[j] = d.damping;
    joints.angularHertz[j] = d.angularHertz;
    joints.angularDamping[j] = d.angularDamping;
    joints.maxForce[j] = d.maxForce;
    joints.maxTorque[j] = d.maxTorque;
    joints.breakForce[j] = d.breakForce;
    joints.breakTorque[j] = d.breakTorque;
    if (d.breakForce < Float.POSITIVE_INFINITY || d.breakTorque < Float.POSITIVE_INFINITY) {
      dynamics.watchBreaking();
    }
    if (j >= jointHandles.length) {
      jointHandles = Arrays.copyOf(jointHandles, Math.max(j + 1, jointHandles.length * 2));
    }
    Joint<T> joint = new Joint<>(this, joints, j, d.type);
    jointHandles[j] = joint;
    jointStructure.change();
    return joint;
  }

  /** Takes over where the coordinates of gear, rack and pulley count from. */
  private void couple(JointDef<T> d, int j) {
    joints.ratio[j] = d.ratio;
    joints.baseAx[j] = d.baseAx;
    joints.baseAy[j] = d.baseAy;
    joints.baseBx[j] = d.baseBx;
    joints.baseBy[j] = d.baseBy;
    if (d.type == JointType.GEAR) {
      joints.baseAx[j] = d.bodyA.cos();
      joints.baseAy[j] = d.bodyA.sin();
      joints.baseBx[j] = d.bodyB.cos();
      joints.baseBy[j] = d.bodyB.sin();
    } else if (d.type == JointType.RACK) {
      float c = d.bodyB.cos();
      float s = d.bodyB.sin();
      joints.axisX[j] = c * d.axisX + s * d.axisY;
      joints.axisY[j] = c * d.axisY - s * d.axisX;
      joints.rest[j] = (d.bx - d.ax) * d.axisX + (d.by - d.ay) * d.axisY;
    } else if (d.type == JointType.PULLEY && !d.restGiven) {
      joints.rest[j] =
          length(d.ax - d.baseAx, d.ay - d.baseAy)
              + d.ratio * length(d.bx - d.baseBx, d.by - d.baseBy);
    }
  }

  private static float length(float x, float y) {
    return (float) Math.sqrt(x * x + y * y);
  }

  private void own(Body<T> body) {
    body.check();
    if (body.world() != this) {
      throw new IllegalArgumentException("body=" + body + " belongs to another world");
    }
  }

  /** A point of the world in a body's frame. */
  private float localX(int body, float x, float y) {
    float dx = x - store.x[body];
    float dy = y - store.y[body];
    return store.localX[body] + (store.cos[body] * dx + store.sin[body] * dy);
  }

  private float localY(int body, float x, float y) {
    float dx = x - store.x[body];
    float dy = y - store.y[body];
    return store.localY[body] + (store.cos[body] * dy - store.sin[body] * dx);
  }

  /**
   * Removes a joint; in a callback at the end of the step.
   *
   * @param joint of this world
   * @throws IllegalStateException if it was destroyed before, or during a query
   */
  public void destroyJoint(Joint<T> joint) {
    refuseDuringQuery("destroyJoint");
    joint.check();
    if (joint.world() != this) {
      throw new IllegalArgumentException("joint=" + joint + " belongs to another world");
    }
    request(DESTROY_JOINT, joint.index(), joint.generation(), null);
  }

  /**
   * The number of joints.
   *
   * @return all types together
   */
  public int jointCount() {
    return joints.count();
  }

  /**
   * The joint in a slot.
   *
   * @param index see {@link Joint#index()}
   * @return null if there is none
   */
  @SuppressWarnings("unchecked")
  public Joint<T> joint(int index) {
    return index >= 0 && index < jointHandles.length ? (Joint<T>) jointHandles[index] : null;
  }

  /**
   * Visits all joints by ascending index.
   *
   * @param visitor receives them
   */
  public void forEachJoint(Consumer<Joint<T>> visitor) {
    for (int i = 0; i < joints.slots(); i++) {
      Joint<T> joint = joint(i);
      if (joint != null) {
        visitor.accept(joint);
      }
    }
  }

  /** Visits the joints of a body. */
  void forEachJoint(int body, Consumer<Joint<T>> visitor) {
    int end = joints.firstEnd(body);
    while (end >= 0) {
      int next = joints.nextEnd(end);
      visitor.accept(joint(end >> 1));
      end = next;
    }
  }

  /**
   * Sets who hears about breaking joints; not part of the state.
   *
   * @param newListener null for nobody
   */
  public void jointListener(JointListener<T> newListener) {
    jointListener = newListener;
  }

  private void broke(int slot) {
    Joint<T> joint = joint(slot);
    if (jointListener != null) {
      jointListener.broke(joint);
    }
    request(DESTROY_JOINT, slot, joint.generation(), null);
  }

  /**
   * Advances the world by one tick; see {@link CollisionListener} for what is called when.
   *
   * <p>If a callback throws, the exception leaves this method and the world is in the middle of a
   * step: restore a saved state or give the world up.
   *
   * @param dtSeconds s, more than 0, at most 0.1; use the same in every step
   */
  public void step(float dtSeconds) {
    Checks.timeStep(dtSeconds);
    refuseDuringStep("step");
    refuseDuringQuery("step");
    stepping = true;
    try {
      moves++;
      dynamics.step(dtSeconds, listener == null ? null : events, onBroke);
      carryOut();
    } finally {
      stepping = false;
      pendingCount = 0;
    }
  }

  /**
   * Sets who helps the thread that calls {@link #step}; not part of the state. Results are the same
   * bit for bit, with any number of workers or none. Callbacks stay on the calling thread. Worlds
   * of less than some hundred contacts are stepped by the caller alone.
   *
   * @param newWorkers null (the default) for nobody; see {@link
   *     carom.physics.threads.WorkerThreads}. Isn't closed by the world
   * @throws IllegalStateException in a callback of a step
   */
  public void workers(Workers newWorkers) {
    refuseDuringStep("workers");
    dynamics.workers(newWorkers);
  }

  /**
   * Sets who hears about collisions; not part of the state.
   *
   * @param newListener null for nobody
   */
  public void listener(CollisionListener<T> newListener) {
    listener = newListener;
  }

  /**
   * Sets who is told of the stages of a step, to measure them; not part of the state.
   *
   * @param newListener null for nobody, as at the start
   */
  public void stageListener(StageListener newListener) {
    dynamics.stageListener(newListener);
  }

  /** Hands the rows of the contact table to the listener. */
  private final class Events implements ContactEvents {
    @Override
    public void begin(int row) {
      listener.begin(collision.at(row));
    }

    @Override
    public void end(int row) {
      listener.end(collision.at(row));
    }

    @Override
    public boolean preSolve(int row) {
      return listener.preSolve(collision.at(row));
    }

    @Override
    public void postSolve(int row) {
      listener.postSolve(collision.at(row));
    }

    @Override
    public void hit(int row, float speed) {
      listener.hit(collision.at(row, speed));
    }
  }

  /**
   * 64 bits that are equal if two worlds made with equal definitions will behave equally: poses,
   * velocities, pending forces, masses, shapes, contacts and joints with their impulses, and the
   * order in which slots will be given out. Users, listeners and the broadphase are not in it.
   *
   * @return the hash
   */
  public long stateHash() {
    return dynamics.hash();
  }

  /**
   * Copies the state out.
   *
   * @param reuseOrNull a state of this world to overwrite, or null for a new one
   * @return the state
   */
  public WorldState save(WorldState reuseOrNull) {
    refuseDuringStep("save");
    WorldState s = reuseOrNull == null ? new WorldState(this) : reuseOrNull;
    checkOwner(s);
    dynamics.save(s.dynamics, structure.same(s.structure));
    if (!structure.same(s.structure)) {
      int slots = store.slots();
      if (s.handles.length < slots) {
        s.handles = new Object[handles.length];
        s.shapes = new ShapeDef[handles.length][];
        s.ownMasses = new MassData[handles.length];
      } else if (s.slots > slots) {
        Arrays.fill(s.handles, slots, s.slots, null);
        Arrays.fill(s.shapes, slots, s.slots, null);
        Arrays.fill(s.ownMasses, slots, s.slots, null);
      }
      System.arraycopy(handles, 0, s.handles, 0, slots);
      System.arraycopy(shapes, 0, s.shapes, 0, slots);
      System.arraycopy(ownMasses, 0, s.ownMasses, 0, slots);
      s.slots = slots;
      structure.copyTo(s.structure);
    }
    if (!jointStructure.same(s.jointStructure)) {
      int slots = joints.slots();
      if (s.jointHandles.length < slots) {
        s.jointHandles = new Object[jointHandles.length];
      } else if (s.jointSlots > slots) {
        Arrays.fill(s.jointHandles, slots, s.jointSlots, null);
      }
      System.arraycopy(jointHandles, 0, s.jointHandles, 0, slots);
      s.jointSlots = slots;
      jointStructure.copyTo(s.jointStructure);
    }
    return s;
  }

  /**
   * Takes a saved state over, bit for bit. Bodies made since are gone, bodies destroyed since are
   * back with their handles and users. No callback is called.
   *
   * <p>A handle from a future that was undone may be valid again, when that future comes once more:
   * it then means the body that was created in the same way.
   *
   * @param s made by {@link #save} of this world; stays as it is
   */
  public void restore(WorldState s) {
    refuseDuringStep("restore");
    refuseDuringQuery("restore");
    checkOwner(s);
    moves++;
    dynamics.restore(s.dynamics, structure.same(s.structure));
    if (!structure.same(s.structure)) {
      int slots = store.slots();
      System.arraycopy(s.handles, 0, handles, 0, slots);
      Arrays.fill(handles, slots, handles.length, null);
      System.arraycopy(s.shapes, 0, shapes, 0, slots);
      Arrays.fill(shapes, slots, shapes.length, null);
      System.arraycopy(s.ownMasses, 0, ownMasses, 0, slots);
      Arrays.fill(ownMasses, slots, ownMasses.length, null);
      s.structure.copyTo(structure);
    }
    if (!jointStructure.same(s.jointStructure)) {
      int slots = joints.slots();
      System.arraycopy(s.jointHandles, 0, jointHandles, 0, slots);
      Arrays.fill(jointHandles, slots, jointHandles.length, null);
      s.jointStructure.copyTo(jointStructure);
    }
  }

  /**
   * Reads the exact state of some bodies out, to be carried to another world.
   *
   * @param excerpt lists the bodies; receives the rest
   */
  public void read(Excerpt excerpt) {
    refuseDuringStep("read");
    dynamics.read(excerpt);
  }

  /**
   * Gives new bodies the exact state that others have in another world, with their contacts. From
   * now on both go on alike, to the bit, as long as nothing else reaches them.
   *
   * @param excerpt lists bodies that were created here since the last step and are awake, of the
   *     same kinds and in the same order as those it was read from
   */
  public void write(Excerpt excerpt) {
    refuseDuringStep("write");
    refuseDuringQuery("write");
    dynamics.write(excerpt);
  }

  private void checkOwner(WorldState s) {
    if (s.owner != this) {
      throw new IllegalArgumentException("the state was saved by another world; restore it there");
    }
  }

  /** Numbers that {@link #readMotions} writes per body. */
  public static final int MOTION = 7;

  /**
   * Writes where all bodies are and how they move: the same numbers as {@link Body#x}, {@link
   * Body#y}, {@link Body#cos}, {@link Body#sin}, {@link Body#velocityX}, {@link Body#velocityY} and
   * {@link Body#angularVelocity}, for whoever wants those of thousands. O(slots).
   *
   * @param to receives {@link #MOTION} numbers for every slot, from {@link Body#index} times MOTION
   *     on; those of unused slots mean nothing
   * @throws IllegalArgumentException if it is shorter than {@link #slotCount} times MOTION
   */
  public void readMotions(float[] to) {
    int needed = store.slots() * MOTION;
    if (to.length < needed) {
      throw new IllegalArgumentException(
          "to.length=" + to.length + " is less than slotCount() * MOTION = " + needed);
    }
    for (int slot = 0, at = 0; slot < store.slots(); slot++, at += MOTION) {
      to[at] = store.originX(slot);
      to[at + 1] = store.originY(slot);
      to[at + 2] = store.cos[slot];
      to[at + 3] = store.sin[slot];
      to[at + 4] = store.vx[slot];
      to[at + 5] = store.vy[slot];
      to[at + 6] = store.w[slot];
    }
  }

  /**
   * The number of bodies.
   *
   * @return all types together
   */
  public int bodyCount() {
    return store.count();
  }

  /**
   * One more than the largest index any body ever had.
   *
   * @return bound for arrays indexed by {@link Body#index()}
   */
  public int slotCount() {
    return store.slots();
  }

  /**
   * The body in a slot.
   *
   * @param index see {@link Body#index()}
   * @return null if there is none
   */
  @SuppressWarnings("unchecked")
  public Body<T> body(int index) {
    return index >= 0 && index < handles.length ? (Body<T>) handles[index] : null;
  }

  /**
   * Visits all bodies by ascending index.
   *
   * @param visitor receives them
   */
  public void forEachBody(Consumer<Body<T>> visitor) {
    for (int i = 0; i < store.slots(); i++) {
      Body<T> body = body(i);
      if (body != null) {
        visitor.accept(body);
      }
    }
  }

  /**
   * Visits the bodies with a shape whose AABB overlaps a box, by ascending index.
   *
   * @param minX left edge, m
   * @param minY lower edge, m
   * @param maxX right edge, m
   * @param maxY upper edge, m
   * @param visitor receives each body once; must not create, destroy, or query again
   */
  public void queryAabb(float minX, float minY, float maxX, float maxY, BodyVisitor<T> visitor) {
    int n = find(minX, minY, maxX, maxY);
    querying = true;
    try {
      int last = -1;
      for (int i = 0; i < n; i++) {
        int slot = dynamics.bodyOf(found[i]);
        if (slot != last && !visitor.visit(body(slot))) {
          return;
        }
        last = slot;
      }
    } finally {
      querying = false;
    }
  }

  /**
   * The body at a point.
   *
   * @param x m
   * @param y m
   * @return the one with the smallest index whose shape contains the point, null if none does
   */
  public Body<T> bodyAt(float x, float y) {
    int n = find(x, y, x, y);
    for (int i = 0; i < n; i++) {
      int slot = dynamics.bodyOf(found[i]);
      pose.set(store.x[slot], store.y[slot], store.cos[slot], store.sin[slot]);
      if (dynamics.convexOf(found[i]).containsPoint(pose, x, y)) {
        return body(slot);
      }
    }
    return null;
  }

  /** Collects the parts in a box, sorted by body; answers how many. */
  private int find(float minX, float minY, float maxX, float maxY) {
    refuseDuringQuery("query");
    queryBox.set(
        Checks.coordinate("minX", minX),
        Checks.coordinate("minY", minY),
        Checks.coordinate("maxX", maxX),
        Checks.coordinate("maxY", maxY));
    foundCount = 0;
    dynamics.query(minX, minY, maxX, maxY, collect);
    for (int i = 1; i < foundCount; i++) {
      int part = found[i];
      int slot = dynamics.bodyOf(part);
      int j = i - 1;
      while (j >= 0 && later(found[j], part, slot)) {
        found[j + 1] = found[j];
        j--;
      }
      found[j + 1] = part;
    }
    return foundCount;
  }

  private boolean later(int part, int than, int slot) {
    int own = dynamics.bodyOf(part);
    return own > slot || (own == slot && part > than);
  }

  private boolean collect(int part) {
    dynamics.boxOf(part, false, box);
    if (box.overlaps(queryBox)) {
      if (foundCount == found.length) {
        found = Arrays.copyOf(found, foundCount * 2);
      }
      found[foundCount++] = part;
    }
    return true;
  }

  /**
   * Visits all contact points of the last step, for debug drawing; those of sleeping bodies are as
   * they were when these fell asleep.
   *
   * @param visitor receives those of awake bodies in canonical order, then the others in none
   */
  public void forEachContact(ContactVisitor visitor) {
    forEachPoint(dynamics.contacts(), visitor);
    forEachPoint(dynamics.sleepingContacts(), visitor);
  }

  private void forEachPoint(ContactTable t, ContactVisitor visitor) {
    for (int row = 0; row < t.count(); row++) {
      if (t.unused(row)) {
        continue;
      }
      int a = t.bodyA(row);
      for (int i = 0; i < t.points(row); i++) {
        visitor.contact(
            store.x[a] + t.pointX(row, i),
            store.y[a] + t.pointY(row, i),
            t.normalX(row),
            t.normalY(row),
            t.separation(row, i),
            t.impulse(row, i));
      }
    }
  }

  /**
   * Visits the nodes of the broadphase's trees, for debug drawing.
   *
   * @param visitor receives boxes and depths
   */
  public void forEachTreeCell(CellVisitor visitor) {
    dynamics.cells(visitor);
  }

  /**
   * Visits the box of each convex part of each body, for debug drawing.
   *
   * @param fat whether with the broadphase's margin
   * @param visitor receives the boxes
   */
  public void forEachAabb(boolean fat, AabbVisitor visitor) {
    for (int slot = 0; slot < store.slots(); slot++) {
      if (store.type[slot] == BodyStore.FREE) {
        continue;
      }
      int first = store.firstPart[slot];
      for (int part = first; part < first + store.partCount[slot]; part++) {
        dynamics.boxOf(part, fat, box);
        visitor.aabb(box.minX, box.minY, box.maxX, box.maxY);
      }
    }
  }

  /**
   * What the last step had to do. Allocates one small object.
   *
   * @return counters
   */
  public StepProfile profile() {
    return new StepProfile(
        store.count(),
        dynamics.activeCount(),
        dynamics.contacts().count(),
        dynamics.touchingCount());
  }

  /** Visits the touching contacts of one body in canonical order. */
  void forEachContact(int slot, BodyContactVisitor<T> visitor) {
    BodyContacts t = dynamics.bodyContacts();
    int first = t.open(slot);
    int end = t.size();
    try {
      for (int i = first; i < end; i++) {
        if (!t.sensor(i)) {
          visitor.contact(body(t.other(i)), t.normalX(i), t.normalY(i), t.impulse(i));
        }
      }
    } finally {
      t.close(first);
    }
  }

  /** Visits what is inside a body's sensors, and whose sensors the body is in. */
  void forEachOverlap(int slot, BodyVisitor<T> visitor) {
    BodyContacts t = dynamics.bodyContacts();
    int first = t.open(slot);
    int end = t.size();
    int last = -1;
    try {
      for (int i = first; i < end; i++) {
        int other = t.other(i);
        if (t.sensor(i) && other != last) {
          if (!visitor.visit(body(other))) {
            return;
          }
          last = other;
        }
      }
    } finally {
      t.close(first);
    }
  }

  /** Bounding box of a body's shapes. */
  void aabb(int slot, Aabb out) {
    out.setEmpty();
    int first = store.firstPart[slot];
    for (int part = first; part < first + store.partCount[slot]; part++) {
      dynamics.boxOf(part, false, box);
      out.add(box);
    }
  }

  void moved(int slot) {
    refuseDuringQuery("setPose");
    moves++;
    dynamics.moved(slot);
  }

  void sleep(int slot) {
    refuseDuringQuery("sleep");
    dynamics.sleep(slot);
  }

  BodyStore store() {
    return store;
  }

  Dynamics dynamics() {
    return dynamics;
  }

  /**
   * Casts, overlaps, nearest points.
   *
   * @return who answers such questions about this world
   */
  public Queries<T> queries() {
    return queries;
  }

  /**
   * A number that changes whenever a body may have come to another place: by a step, by being put
   * there, by restoring.
   *
   * @return meaningful only compared with an earlier one of this world; not part of the state
   */
  public long moves() {
    return moves;
  }

  /**
   * Casts, overlaps, nearest points in this world with its bodies elsewhere. The shapes are those
   * they have now. Allocates: make one and keep it.
   *
   * @param poses asked anew by each question
   * @return who answers
   */
  public Queries<T> queries(Poses poses) {
    return new Queries<>(this, poses);
  }

  void beginQuery(String what) {
    refuseDuringQuery(what);
    querying = true;
  }

  void endQuery() {
    querying = false;
  }

  private void refuseDuringStep(String what) {
    if (stepping) {
      throw new IllegalStateException(what + " is not possible in a collision callback");
    }
  }

  private void refuseDuringQuery(String what) {
    if (querying) {
      throw new IllegalStateException(what + " is not possible while a query visits bodies");
    }
  }
}
