package carom.physics;

import carom.physics.archive.ArchiveReader;
import carom.physics.broadphase.CellVisitor;
import carom.physics.broadphase.IntVisitor;
import carom.physics.dynamics.BodyEditor;
import carom.physics.dynamics.Dynamics;
import carom.physics.dynamics.PartQueries;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.body.ShapeSpec;
import carom.physics.dynamics.contact.BodyContacts;
import carom.physics.dynamics.contact.ContactEvents;
import carom.physics.dynamics.contact.ContactTable;
import carom.physics.dynamics.joint.JointEvents;
import carom.physics.dynamics.joint.JointStore;
import carom.physics.dynamics.joint.JointTransfer;
import carom.physics.geometry.MassData;
import carom.physics.math.Aabb;
import carom.physics.math.Limits;
import carom.physics.math.StateHash;
import carom.physics.math.Transform;
import carom.physics.math.Trig;
import carom.physics.profile.StageListener;
import carom.physics.rows.BodyRow;
import carom.physics.rows.ExactRows;
import carom.physics.rows.JointDefRow;
import carom.physics.rows.PhysicsVersion;
import carom.physics.settings.Settings;
import carom.physics.threads.Workers;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.IntFunction;

/**
 * A rigid-body world: it holds bodies and joints, advances them step by step and answers queries.
 *
 * <p>A world is a pure function of its {@link WorldDef} and the calls made. Equal calls in equal
 * order give equal bits on every JVM, and {@link #stateHash} proves it. Only one thread may use a
 * world at a time. A steady {@link #step} allocates nothing.
 *
 * <p>The work is elsewhere: {@code dynamics} steps, {@link Queries} answers, {@code EditQueue}
 * changes bodies, {@code Handles} keeps their objects.
 *
 * @param <T> the type of the objects that bodies stand for in the using program, see {@link
 *     Body#user()}
 */
public final class World<T> {
  /**
   * Version of the simulation's arithmetic. Equal worlds of one version behave equally. Recordings
   * of another version are refused, states as bytes tell it ({@link WorldState#physicsVersion}).
   */
  public static final int PHYSICS_VERSION = PhysicsVersion.NUMBER;

  private static final JointType[] JOINT_TYPES = JointType.values();

  /** The constants that the world was made with. */
  private final WorldDef firstDef;

  /** The constants that the stages of a step see: those of {@link #def}. */
  private final Settings settings;

  private WorldDef def;
  private final Dynamics dynamics;
  private final PartQueries parts;
  private final BodyStore store;
  private final JointStore joints;
  private final ContactDispatch<T> events;
  private final Queries<T> queries;
  private final Handles<T> handles = new Handles<>();
  private final EditQueue<T> edits;
  private long moves;
  private QueryFilter<T> scope;
  private final JointEvents onBroke = this::broke;

  private JointListener<T> jointListener;

  private float stepSeconds;

  /** Rule of the program that decides which shapes meet; null for none. */
  private CollisionFilter<T> filter;

  /** Records calls that change this world; null (the default) records nothing. */
  private WorldRecorder recorder;

  /** True if a state was restored since the last step. */
  private boolean restored;

  private boolean stepping;
  private boolean querying;

  /** Decides which calls may still change this world; null if all may. */
  private final Aabb box = new Aabb();

  private final Aabb queryBox = new Aabb();
  private final Transform pose = new Transform();
  private int[] found = new int[16];
  private int foundCount;
  private final IntVisitor collect = this::collect;

  /**
   * Makes an empty world.
   *
   * @param def constants of the world
   */
  public World(WorldDef def) {
    this.def = Limits.notNull("def", def);
    firstDef = def;
    settings = def.live();
    dynamics = new Dynamics(settings);
    parts = dynamics.queries();
    store = dynamics.bodies();
    joints = dynamics.joints();
    events = new ContactDispatch<>(this, new Collision<>(this, dynamics.contacts()));
    queries = new Queries<>(this, null);
    edits = new EditQueue<>(this, dynamics, handles);
  }

  /**
   * Returns the constants of this world.
   *
   * @return the definition that it was made with, or the last one that {@link #redefine} took over
   */
  public WorldDef def() {
    return def;
  }

  /**
   * Returns the constants that this world was made with. Another world that shall {@link #read} its
   * states is made with the same.
   *
   * @return the constructor's definition, without what {@link #redefine} changed
   */
  public WorldDef firstDef() {
    return firstDef;
  }

  /**
   * Changes the constants of the world from the next step on:
   *
   * <pre>
   *   world.redefine(world.def().withGravity(0, 3))
   * </pre>
   *
   * <p>They are part of the state from then on: saved, restored, archived, and in {@link
   * #stateHash} unless they are those that the world was made with. Sleeping bodies wake if gravity
   * changes or sleeping is switched off; otherwise they sleep on. Lower limits of speed act on
   * bodies that are faster.
   *
   * @param newDef the constants; substeps, speculativeDistance, integrator and both mixing rules
   *     stay as they are
   * @throws IllegalArgumentException if one of these five differs
   * @throws IllegalStateException during a step or a query
   */
  public void redefine(WorldDef newDef) {
    refuseDuringStep("redefine");
    refuseDuringQuery("redefine");
    Limits.notNull("newDef", newDef).checkFollows(def);
    noteValue(Call.REDEFINE, newDef);
    boolean wakes =
        newDef.gravityX() != def.gravityX()
            || newDef.gravityY() != def.gravityY()
            || (def.sleeping() && !newDef.sleeping());
    take(newDef);
    if (wakes) {
      dynamics.wakeAll();
    }
  }

  private void take(WorldDef newDef) {
    def = newDef.hash() == firstDef.hash() ? firstDef : newDef;
    settings.take(def);
  }

  /**
   * Returns the x component of gravity.
   *
   * @return m/s^2
   */
  public float gravityX() {
    return def.gravityX();
  }

  /**
   * Returns the y component of gravity.
   *
   * @return m/s^2
   */
  public float gravityY() {
    return def.gravityY();
  }

  /**
   * Creates a body. A callback of a step may do so, too; the body then collides from the next step
   * on.
   *
   * @param bodyDef definition of the body; copied
   * @param user object that the body stands for, may be null
   * @return the body's handle
   * @throws IllegalArgumentException if the shapes of a dynamic body have no mass
   * @throws IllegalStateException during a query
   */
  public Body<T> createBody(BodyDef bodyDef, T user) {
    refuseDuringQuery("createBody");
    ShapeDef[] given = Limits.notNull("bodyDef", bodyDef).shapes.toArray(new ShapeDef[0]);
    ShapeSpec[] specs = specs(given);
    byte type = code(bodyDef.type);
    if (recorder != null) {
      BodyEditor.checkShapes(type, specs, bodyDef.mass); // what is refused isn't recorded
    }
    noteValue(Call.CREATE_BODY, bodyDef);
    int slot = dynamics.editor().create(type, specs, bodyDef.mass, bodyDef.locks.angularZ());
    store.setLinearLocks(slot, axes(bodyDef.locks));
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
    store.sleepSpeed[slot] = bodyDef.sleepSpeed;
    store.setBullet(slot, bodyDef.bullet);
    if (!bodyDef.sleepAllowed) {
      store.flags[slot] |= BodyStore.SLEEPLESS;
    }
    Body<T> body = new Body<>(this, store, slot, store.generation(slot), bodyDef.type, given, user);
    handles.put(body, given, bodyDef.mass); // a collision filter may be asked about it next
    dynamics.editor().enter(slot, bodyDef.awake);
    return body;
  }

  /**
   * Creates the bodies of a long line: as few as its segments need, all with the same definition
   * and user. Move kinematic ones alike, and destroy them all.
   *
   * @param chain the line, in the bodies' frame
   * @param bodyDef a static or kinematic body without shapes; stays as it is
   * @param user object that the bodies stand for, may be null
   * @return the bodies, in the order of the points
   * @throws IllegalArgumentException if the line crosses itself, or the body is dynamic or has
   *     shapes
   * @throws IllegalStateException during a query
   */
  public List<Body<T>> createChain(ChainDef chain, BodyDef bodyDef, T user) {
    Limits.notNull("chain", chain);
    Limits.notNull("bodyDef", bodyDef);
    if (bodyDef.type == BodyType.DYNAMIC || !bodyDef.shapes.isEmpty()) {
      throw new IllegalArgumentException(
          "type="
              + bodyDef.type
              + " shapes="
              + bodyDef.shapes.size()
              + " of the body of a chain; it must be static or kinematic, without shapes");
    }
    refuseDuringQuery("createChain");
    List<Body<T>> bodies = new ArrayList<>();
    try {
      for (List<ShapeDef> shapes : chain.bodies()) {
        bodyDef.shapes.addAll(shapes);
        bodies.add(createBody(bodyDef, user));
        bodyDef.shapes.clear();
      }
    } finally {
      bodyDef.shapes.clear();
    }
    return bodies;
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
              shapes[i].sensor(),
              m.frictionMixing(),
              m.restitutionMixing());
    }
    return specs;
  }

  static int axes(MotionLocks locks) {
    return (locks.linearX() ? BodyStore.LOCK_X : 0) | (locks.linearY() ? BodyStore.LOCK_Y : 0);
  }

  static byte code(BodyType type) {
    return switch (type) {
      case STATIC -> BodyStore.STATIC;
      case KINEMATIC -> BodyStore.KINEMATIC;
      case DYNAMIC -> BodyStore.DYNAMIC;
    };
  }

  /**
   * Destroys a body and its joints. Touching contacts end first. In a callback this takes effect at
   * the end of the step; until then the body stays as it is.
   *
   * @param body a body of this world
   * @throws IllegalStateException if the body was destroyed before, or during a query
   * @throws IllegalArgumentException if the body belongs to another world
   */
  public void destroyBody(Body<T> body) {
    own("body", body);
    refuseDuringQuery("destroyBody");
    edits.destroy(body);
  }

  ShapeDef[] shapes(int slot) {
    return handles.shapes(slot);
  }

  MassData ownMass(int slot) {
    return handles.ownMass(slot);
  }

  void removeBody(int slot) {
    while (joints.firstEnd(slot) >= 0) {
      removeJoint(joints.firstEnd(slot) >> 1);
    }
    dynamics.editor().destroy(slot, contactEvents());
    handles.removeBody(slot);
  }

  void removeJoint(int slot) {
    tell(JointListener::destroyed, joint(slot));
    dynamics.destroyJoint(slot);
    handles.removeJoint(slot);
  }

  /**
   * Creates a joint. If a callback before the solver creates it, the joint acts in this step
   * already, and its bodies stop colliding with each other in the next step.
   *
   * @param d definition of the joint
   * @return the joint's handle
   * @throws IllegalStateException if a body was destroyed, or during a query
   */
  public Joint<T> createJoint(JointDef<T> d) {
    refuseDuringQuery("createJoint");
    own("bodyB", Limits.notNull("d", d).bodyB);
    if (d.bodyA != null) {
      own("bodyA", d.bodyA);
    }
    settleRecorder();
    int a = d.bodyA == null ? -1 : d.bodyA.index();
    int b = d.bodyB.index();
    int j = dynamics.createJoint((byte) d.type.ordinal(), a, b);
    new JointMaker(store, joints).fill(j, d);
    return enter(j);
  }

  /**
   * Creates a joint as {@link #createJoint(JointDef)} does, between other bodies than those that
   * the definition was made with. It belongs to these bodies from then on.
   *
   * @param bodyA null for the world, as far as the type allows it
   * @param bodyB another body
   * @param d the definition, with points in world coordinates
   * @return the joint's handle
   */
  public Joint<T> createJoint(Body<T> bodyA, Body<T> bodyB, JointDef<?> d) {
    Limits.notNull("bodyB", bodyB);
    boolean grounds = JointTransfer.mayBeGrounded(Limits.notNull("d", d).type.ordinal());
    if (bodyA == bodyB || (bodyA == null && !grounds)) {
      throw new IllegalArgumentException(
          "type=" + d.type + " of a joint between bodyA=" + bodyA + " and bodyB=" + bodyB);
    }
    return createJoint(d.between(bodyA, bodyB));
  }

  /**
   * Creates a joint from the definition of another world's joint, as {@link #readJoint} reads it.
   * The numbers are not trusted.
   *
   * @param bodyA null for the world, as far as the type allows it
   * @param bodyB another body
   * @param definition holds it; {@link JointDefRow} declares its fields
   * @param at where it begins
   * @return the joint's handle
   * @throws IllegalArgumentException if the definition is damaged; no joint is created then
   * @throws IllegalStateException if a body was destroyed, or during a query
   */
  public Joint<T> createJoint(Body<T> bodyA, Body<T> bodyB, int[] definition, int at) {
    refuseDuringQuery("createJoint");
    own("bodyB", bodyB);
    if (bodyA != null) {
      own("bodyA", bodyA);
    }
    int room = Limits.notNull("definition", definition).length;
    Limits.stretch("definition", room, at, JointDefRow.INTS);
    int type = definition[at + JointDefRow.TYPE];
    if (!JointTransfer.isType(type)
        || bodyA == bodyB
        || (bodyA == null && !JointTransfer.mayBeGrounded(type))) {
      throw new IllegalArgumentException(
          "type=" + type + " of a joint between bodyA=" + bodyA + " and bodyB=" + bodyB);
    }
    String problem = dynamics.jointTransfer().problem(definition, at);
    if (problem != null) {
      throw new IllegalArgumentException(problem);
    }
    settleRecorder();
    int a = bodyA == null ? -1 : bodyA.index();
    int j = dynamics.createJoint((byte) type, a, bodyB.index());
    dynamics.jointTransfer().writeDefinition(j, definition, at);
    return enter(j);
  }

  /** Makes the handle of a joint that has just been filled in, and tells of it. */
  private Joint<T> enter(int j) {
    if (joints.breakForce[j] < Float.POSITIVE_INFINITY
        || joints.breakTorque[j] < Float.POSITIVE_INFINITY) {
      dynamics.watchBreaking();
    }
    JointType type = JOINT_TYPES[joints.type[j]];
    Joint<T> joint = new Joint<>(this, joints, j, joints.generation(j), type);
    handles.put(joint);
    if (recorder != null) {
      int[] made = new int[JointDefRow.INTS];
      dynamics.jointTransfer().readDefinition(j, made, 0);
      recorder.noteValue(Call.CREATE_JOINT, joints.bodyA[j], joints.bodyB[j], made);
    }
    tell(JointListener::created, joint);
    return joint;
  }

  /**
   * Reads the definition of a joint, with the settings that it has now. {@link #createJoint(Body,
   * Body, int[], int)} makes an equal joint of it.
   *
   * @param to receives {@link JointDefRow#INTS} ints
   * @param at where they begin
   */
  public void readJoint(Joint<T> joint, int[] to, int at) {
    own(joint);
    Limits.stretch("to", Limits.notNull("to", to).length, at, JointDefRow.INTS);
    dynamics.jointTransfer().readDefinition(joint.index(), to, at);
  }

  private void own(String name, Body<T> body) {
    Limits.notNull(name, body).check();
    if (body.world() != this) {
      throw new IllegalArgumentException("body=" + body + " belongs to another world");
    }
  }

  /**
   * Destroys a joint. In a callback this takes effect at the end of the step.
   *
   * @param joint a joint of this world
   * @throws IllegalStateException if the joint was destroyed before, or during a query
   * @throws IllegalArgumentException if the joint belongs to another world
   */
  public void destroyJoint(Joint<T> joint) {
    refuseDuringQuery("destroyJoint");
    own(joint);
    edits.destroy(joint);
  }

  /**
   * Gives bodies that are created from now on ascending indices, until bodies are destroyed. The
   * solver's order is then the order of their creation.
   *
   * @throws IllegalStateException during a step or a query
   */
  public void sortFreeBodies() {
    refuseDuringStep("sortFreeBodies");
    refuseDuringQuery("sortFreeBodies");
    note(Call.SORT_FREE_BODIES);
    store.sortFree();
  }

  /**
   * Destroys all joints. Those created next get ascending indices: the solver's order is then the
   * order of their creation.
   *
   * @throws IllegalStateException during a step or a query
   */
  public void destroyJoints() {
    refuseDuringStep("destroyJoints");
    refuseDuringQuery("destroyJoints");
    note(Call.DESTROY_JOINTS);
    for (int j = joints.slots() - 1; j >= 0; j--) {
      if (joint(j) != null) {
        removeJoint(j);
      }
    }
    joints.sortFree();
  }

  /**
   * Returns how often the settings of joints of an index were changed: motors, limits, springs,
   * targets. It is only good for comparison, and no part of the state.
   *
   * @param index below {@link #jointSlotCount()}
   */
  public int jointChanges(int index) {
    return joints.changes(Limits.index("index", index, joints.slots()));
  }

  /** Returns a number above all indices of joints that were ever used. */
  public int jointSlotCount() {
    return joints.slots();
  }

  private void own(Joint<T> joint) {
    Limits.notNull("joint", joint).check();
    if (joint.world() != this) {
      throw new IllegalArgumentException("joint=" + joint + " belongs to another world");
    }
  }

  /**
   * Returns the number of joints.
   *
   * @return joints of all types together
   */
  public int jointCount() {
    return joints.count();
  }

  /**
   * Returns the joint in a slot.
   *
   * @param index the slot, see {@link Joint#index()}
   * @return the joint, null if there is none
   */
  public Joint<T> joint(int index) {
    return handles.joint(index);
  }

  /**
   * Visits all joints by ascending index.
   *
   * @param visitor receives the joints
   */
  public void forEachJoint(Consumer<Joint<T>> visitor) {
    Limits.notNull("visitor", visitor);
    for (int i = 0; i < joints.slots(); i++) {
      Joint<T> joint = joint(i);
      if (joint != null) {
        visitor.accept(joint);
      }
    }
  }

  /** Returns whether a body has joints. */
  boolean hasJoints(int body) {
    return joints.firstEnd(body) >= 0;
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
   * Sets the listener that is called when joints break. It is not part of the state.
   *
   * @param newListener the listener, null for none
   */
  public void jointListener(JointListener<T> newListener) {
    jointListener = newListener;
    note(Call.LISTENERS, listeners());
  }

  private void broke(int slot) {
    Joint<T> joint = joint(slot);
    if (events.lists() != null) {
      events.lists().broke(joint);
    }
    tell(JointListener::broke, joint);
    edits.destroy(joint);
  }

  /**
   * Advances the world by one tick. {@link CollisionListener} describes which callbacks are called
   * when.
   *
   * <p>If a callback throws, the exception leaves this method and the world is in the middle of a
   * step: restore a saved state or give the world up.
   *
   * @param dtSeconds length of the tick, s, more than 0, at most 0.1; use the same in every step
   */
  public void step(float dtSeconds) {
    Limits.timeStep(dtSeconds);
    refuseDuringStep("step");
    refuseDuringQuery("step");
    if (recorder != null) {
      recorder.noteStep(dtSeconds);
      if (restored && filter != null) {
        askAboutSleeping();
      }
    }
    restored = false;
    stepping = true;
    stepSeconds = dtSeconds;
    try {
      moves++;
      if (events.lists() != null) {
        events.lists().beginStep();
      }
      dynamics.step(dtSeconds, contactEvents(), onBroke);
      edits.carryOut();
    } finally {
      stepping = false;
      edits.forget();
      if (events.lists() != null) {
        events.lists().endStep();
      }
    }
  }

  /**
   * Sets the workers that help the thread that calls {@link #step}. They are not part of the state.
   * Results are the same bit for bit, with any number of workers or none. Callbacks stay on the
   * calling thread. The calling thread does steps with fewer than 500 moving bodies alone.
   *
   * @param newWorkers the workers, null (the default) for none; see {@link
   *     carom.physics.threads.WorkerThreads}. The world doesn't close them
   * @throws IllegalStateException in a callback of a step
   */
  public void workers(Workers newWorkers) {
    refuseDuringStep("workers");
    dynamics.workers(newWorkers);
  }

  /**
   * Sets the listener that is called for collisions. It is not part of the state.
   *
   * @param newListener the listener, null for none
   */
  public void listener(CollisionListener<T> newListener) {
    events.listener(newListener);
    note(Call.LISTENERS, listeners());
  }

  /**
   * Sets the lists that each step fills with what happened in it. They are not part of the state.
   *
   * @param newLists lists that no other world fills, null (the default) for none
   * @throws IllegalStateException in a callback of a step
   */
  public void eventLists(EventLists<T> newLists) {
    refuseDuringStep("eventLists");
    if (newLists != null) {
      newLists.clear();
    }
    events.lists(newLists);
  }

  /**
   * Sets the filter that is asked which shapes meet. It is not part of the state. All bodies wake,
   * and the next step asks it about all pairs. Set it before bodies are created if they shall stay
   * asleep.
   *
   * @param newFilter the filter, null (the default) for none
   * @throws IllegalStateException during a step or a query
   */
  public void collisionFilter(CollisionFilter<T> newFilter) {
    refuseDuringStep("collisionFilter");
    refuseDuringQuery("collisionFilter");
    note(Call.COLLISION_FILTER, newFilter == null ? 0 : 1);
    askAbout(newFilter);
    forEachBody(body -> dynamics.wake(body.index()));
  }

  /** Has a filter asked about all pairs in the next step, and from then on; wakes nothing. */
  void askAbout(CollisionFilter<T> newFilter) {
    filter = newFilter;
    dynamics.customRule(newFilter == null ? null : this::shouldCollide);
  }

  /** Asks about sleeping contacts, which a state has brought and no step asks about. */
  private void askAboutSleeping() {
    ContactTable rows = dynamics.sleepingContacts();
    for (int row = 0; row < rows.count(); row++) {
      if (!rows.unused(row)) {
        shouldCollide(rows.partA(row), rows.partB(row));
      }
    }
  }

  private boolean shouldCollide(int partA, int partB) {
    int shapeA = parts.shapeOf(partA);
    int shapeB = parts.shapeOf(partB);
    Body<T> a = body(parts.bodyOf(partA));
    Body<T> b = body(parts.bodyOf(partB));
    boolean before = querying;
    querying = true;
    try {
      boolean meet = filter.shouldCollide(a, shapeA, b, shapeB);
      if (recorder != null) {
        recorder.noteAnswer(a.index(), shapeA, b.index(), shapeB, meet);
      }
      return meet;
    } finally {
      querying = before;
    }
  }

  /**
   * Sets the listener that hears of the stages of a step, to measure them. It is not part of the
   * state.
   *
   * @param newListener the listener, null (the default) for none
   */
  public void stageListener(StageListener newListener) {
    dynamics.stageListener(newListener);
  }

  /**
   * Returns a hash of all state that decides how the world will behave. Two worlds made with equal
   * definitions that will behave equally have equal hashes. The hash covers poses, velocities,
   * pending forces, masses, shapes, contacts and joints with their impulses, constants that {@link
   * #redefine} changed, and the order in which slots will be given out. It leaves out users,
   * listeners and the broadphase.
   *
   * @return 64 bits
   */
  public long stateHash() {
    long h = dynamics.hash();
    return def == firstDef ? h : StateHash.finish(StateHash.mix(h, def.hash()));
  }

  /**
   * Saves the state of the world.
   *
   * @param reuseOrNull a state of this world to overwrite, or null for a new one
   * @return the state
   */
  public WorldState save(WorldState reuseOrNull) {
    refuseDuringStep("save");
    WorldState s = reuseOrNull == null ? new WorldState(this) : reuseOrNull;
    checkOwner(s);
    s.def = def;
    s.physicsVersion = PHYSICS_VERSION;
    dynamics.save(s.dynamics, handles.sameBodies(s.handles));
    handles.copyTo(s.handles, store.slots(), joints.slots());
    return s;
  }

  /**
   * Restores a saved state, bit for bit. Bodies created since are gone, and bodies destroyed since
   * are back with their handles and users. No callback is called.
   *
   * <p>A handle from an undone future may become valid again when that future is replayed. It then
   * means the body that was created in the same way.
   *
   * @param s a state made by {@link #save} or {@link #read} of this world; stays as it is
   */
  public void restore(WorldState s) {
    refuseDuringStep("restore");
    refuseDuringQuery("restore");
    checkOwner(Limits.notNull("s", s));
    noteValue(Call.STATE, s);
    moves++;
    if (events.lists() != null) {
      events.lists().clear();
    }
    take(s.def);
    dynamics.restore(s.dynamics, handles.sameBodies(s.handles));
    s.handles.copyTo(handles, store.slots(), joints.slots());
    restored = true;
  }

  /**
   * Reads a state that {@link WorldState#write} has written, in this or another program. {@link
   * #restore} then restores it: bodies keep their slots and generations, and this world continues
   * like the one that was saved, to the bit if {@link WorldState#physicsVersion} is this build's.
   * Bodies and joints that this world has under the same slot and generation keep their handles. A
   * body that shall stand for another user gets a new handle.
   *
   * <p>The bytes need not be trusted: they either make a state that can be stepped or are refused.
   * Memory stays in proportion to them, except for the parts of shapes, which are at most 2^20. The
   * world isn't touched.
   *
   * @param archive positioned at the start of the state; read up to its end
   * @param users returns the user of the body in a slot; a null user means the one that the body
   *     has here
   * @return the state, which belongs to this world
   * @throws ArchiveException if the bytes are damaged, of another format, or of a world with
   *     another definition
   */
  public WorldState read(ArchiveReader archive, IntFunction<T> users) {
    Limits.notNull("archive", archive);
    WorldState s = WorldState.read(archive, this, Limits.notNull("users", users));
    s.dynamics.distinguish(dynamics);
    handles.distinguish(s.handles);
    return s;
  }

  /**
   * Returns a body of a saved state of this world.
   *
   * @param s a state made by {@link #save} or {@link #read}
   * @param index the body's slot
   * @return the body's handle, valid once the state is restored; null if there is none
   */
  @SuppressWarnings("unchecked")
  public Body<T> bodyIn(WorldState s, int index) {
    checkOwner(Limits.notNull("s", s));
    return (Body<T>) s.handles.body(index);
  }

  /**
   * Reads the exact state of some bodies and of their joints and contacts, so that another world
   * can take it over.
   *
   * <p>A contact with a body that is neither listed nor static is left out. The rows then behave as
   * in this world only until that body matters. A joint with such a body is left out, too, and is
   * counted in {@link ExactRows#cutJoints}; its bodies then behave otherwise at once.
   *
   * @param rows lists the bodies, see {@link ExactRows#addBody}; receives their state except for
   *     what belongs to the using program
   * @return number of contacts left out, and of listed bodies of which a call ended a contact since
   *     the last step: what may have acted on them without being in the rows
   */
  public int readRows(ExactRows rows) {
    refuseDuringStep("readRows");
    checkListed(rows);
    return dynamics.read(rows);
  }

  /**
   * Gives new bodies the exact state, the joints and the contacts of bodies of another world. From
   * now on both behave alike, to the bit, as long as nothing else reaches them.
   *
   * <p>A contact is left out if one of its ends is not a body of this world, or the body lacks the
   * part. A joint's row is left out if it has no slot, or if the joint there has other ends.
   *
   * @param rows exact state of bodies that were created here since the last step and are awake, and
   *     of joints that were {@linkplain #createJoint(Body, Body, int[], int) created} from the
   *     definitions of the other world's. They have the same kinds and the same order as those the
   *     rows were read from; see {@link ExactRows#setSlot} and {@link ExactRows#setJointSlot}
   */
  public void writeRows(ExactRows rows) {
    refuseDuringStep("writeRows");
    refuseDuringQuery("writeRows");
    checkListed(rows);
    for (int i = 0; i < rows.bodies().count(); i++) {
      BodyRow.check(rows.bodies().ints(), rows.bodies().at(i));
    }
    settleRecorder();
    dynamics.write(rows);
    if (recorder != null) {
      recorder.noteValue(Call.STATE, save(null));
    }
  }

  /** Refuses rows that list a body that this world doesn't have. */
  private void checkListed(ExactRows rows) {
    Limits.notNull("rows", rows);
    for (int i = 0; i < rows.bodies().count(); i++) {
      if (body(rows.slot(i)) == null) {
        throw new IllegalArgumentException(
            "slot=" + rows.slot(i) + " of row=" + i + " is no body of this world; see setSlot()");
      }
    }
  }

  private void checkOwner(WorldState s) {
    if (s.owner != this) {
      throw new IllegalArgumentException("the state was saved by another world; restore it there");
    }
  }

  /** Number of values that {@link #readMotions} writes for each body. */
  public static final int MOTION = 7;

  /**
   * Copies the poses and velocities of a range of slots into arrays. The values are those of {@link
   * Body#x}, {@link Body#y}, {@link Body#cos}, {@link Body#sin}, {@link Body#velocityX}, {@link
   * Body#velocityY} and {@link Body#angularVelocity}. Use it to read thousands of bodies at once.
   *
   * @param from first slot, see {@link Body#index}; not negative
   * @param n number of consecutive slots; the values of unused slots mean nothing
   * @param to {@link #MOTION} arrays, in the order above, that receive n values each
   * @throws IndexOutOfBoundsException if an array is too short, or a slot is not below {@link
   *     #slotCount}
   */
  public void readMotions(int from, int n, float[][] to) {
    Limits.stretch("slots", store.slots(), from, n);
    Limits.stretch("to", Limits.notNull("to", to).length, 0, MOTION);
    for (int i = 0; i < MOTION; i++) {
      Limits.stretch("to[i]", Limits.notNull("to[i]", to[i]).length, 0, n);
    }
    float[] x = to[0];
    float[] y = to[1];
    for (int i = 0; i < n; i++) {
      x[i] = store.originX(from + i);
      y[i] = store.originY(from + i);
    }
    System.arraycopy(store.cos, from, to[2], 0, n);
    System.arraycopy(store.sin, from, to[3], 0, n);
    System.arraycopy(store.vx, from, to[4], 0, n);
    System.arraycopy(store.vy, from, to[5], 0, n);
    System.arraycopy(store.w, from, to[6], 0, n);
  }

  /**
   * Returns the number of bodies.
   *
   * @return bodies of all types together
   */
  public int bodyCount() {
    return store.count();
  }

  /**
   * Returns one more than the largest index that any body ever had.
   *
   * @return bound for arrays indexed by {@link Body#index()}
   */
  public int slotCount() {
    return store.slots();
  }

  /**
   * Returns the body in a slot.
   *
   * @param index the slot, see {@link Body#index()}
   * @return the body, null if there is none
   */
  public Body<T> body(int index) {
    return handles.body(index);
  }

  /**
   * Visits all bodies by ascending index.
   *
   * @param visitor receives the bodies
   */
  public void forEachBody(Consumer<Body<T>> visitor) {
    Limits.notNull("visitor", visitor);
    for (int i = 0; i < store.slots(); i++) {
      Body<T> body = body(i);
      if (body != null) {
        visitor.accept(body);
      }
    }
  }

  /**
   * Visits the dynamic bodies that are awake, by ascending index. Costs about a nanosecond per slot
   * besides the visits.
   *
   * @param visitor receives the bodies; must not create or destroy any
   */
  public void forEachAwake(Consumer<Body<T>> visitor) {
    Limits.notNull("visitor", visitor);
    for (int i = 0; i < store.slots(); i++) {
      if (store.type[i] == BodyStore.DYNAMIC && store.active(i)) {
        visitor.accept(body(i));
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
    Limits.notNull("visitor", visitor);
    int n = find(minX, minY, maxX, maxY);
    querying = true;
    try {
      int last = -1;
      for (int i = 0; i < n; i++) {
        int slot = parts.bodyOf(found[i]);
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
   * Returns the body at a point.
   *
   * @param x x of the point, m
   * @param y y of the point, m
   * @return the body with the smallest index that has a shape that contains the point; null if
   *     there is none
   */
  public Body<T> bodyAt(float x, float y) {
    int n = find(x, y, x, y);
    for (int i = 0; i < n; i++) {
      int slot = parts.bodyOf(found[i]);
      pose.set(store.x[slot], store.y[slot], store.cos[slot], store.sin[slot]);
      if (parts.convexOf(found[i]).containsPoint(pose, x, y)) {
        return body(slot);
      }
    }
    return null;
  }

  /** Collects the parts in a box, sorted by body, and returns their number. */
  private int find(float minX, float minY, float maxX, float maxY) {
    refuseDuringQuery("query");
    queryBox.set(
        Limits.coordinate("minX", minX),
        Limits.coordinate("minY", minY),
        Limits.coordinate("maxX", maxX),
        Limits.coordinate("maxY", maxY));
    foundCount = 0;
    parts.query(minX, minY, maxX, maxY, collect);
    for (int i = 1; i < foundCount; i++) {
      int part = found[i];
      int slot = parts.bodyOf(part);
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
    int own = parts.bodyOf(part);
    return own > slot || (own == slot && part > than);
  }

  private boolean collect(int part) {
    parts.boxOf(part, false, box);
    if (box.overlaps(queryBox) && sees(body(parts.bodyOf(part)), parts.shapeOf(part))) {
      if (foundCount == found.length) {
        found = Arrays.copyOf(found, foundCount * 2);
      }
      found[foundCount++] = part;
    }
    return true;
  }

  /**
   * Visits all contact points of the last step, for debug drawing. The points of sleeping bodies
   * are as they were when the bodies fell asleep.
   *
   * @param visitor receives the points of awake bodies in canonical order, then those of sleeping
   *     bodies in no particular order
   */
  public void forEachContact(ContactVisitor visitor) {
    Limits.notNull("visitor", visitor);
    forEachPoint(dynamics.contacts(), visitor);
    forEachPoint(dynamics.sleepingContacts(), visitor);
  }

  private void forEachPoint(ContactTable t, ContactVisitor visitor) {
    for (int row = 0; row < t.count(); row++) {
      if (t.unused(row)) {
        continue;
      }
      int a = t.bodyA(row);
      for (int i = 0; t.touches(row) && i < t.points(row); i++) {
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
    Limits.notNull("visitor", visitor);
    parts.cells(visitor);
  }

  /**
   * Visits the box of each convex part of each body, for debug drawing.
   *
   * @param fat true for boxes with the broadphase's margin
   * @param visitor receives the boxes
   */
  public void forEachAabb(boolean fat, AabbVisitor visitor) {
    Limits.notNull("visitor", visitor);
    for (int slot = 0; slot < store.slots(); slot++) {
      if (store.type[slot] == BodyStore.FREE) {
        continue;
      }
      int first = store.firstPart[slot];
      for (int part = first; part < first + store.partCount[slot]; part++) {
        parts.boxOf(part, fat, box);
        visitor.aabb(box.minX, box.minY, box.maxX, box.maxY);
      }
    }
  }

  /**
   * Returns counters of the work of the last step. Allocates one small object.
   *
   * @return the counters
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

  /** Visits the bodies inside a body's sensors, and the bodies whose sensors it is inside. */
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

  /** Computes the bounding box of a body's shapes. */
  void aabb(int slot, Aabb out) {
    out.setEmpty();
    int first = store.firstPart[slot];
    for (int part = first; part < first + store.partCount[slot]; part++) {
      parts.boxOf(part, false, box);
      out.add(box);
    }
  }

  void moved(int slot) {
    moves++;
    dynamics.editor().moved(slot);
  }

  void sleep(int slot) {
    dynamics.sleep(slot);
  }

  float stepSeconds() {
    return stepSeconds;
  }

  BodyStore store() {
    return store;
  }

  Dynamics dynamics() {
    return dynamics;
  }

  /**
   * Returns the queries of this world: casts, overlaps and nearest points.
   *
   * @return queries about the bodies where they are now
   */
  public Queries<T> queries() {
    return queries;
  }

  /**
   * Returns a number that changes whenever a body may have moved: in a step, by {@link
   * Body#setPose}, or by {@link #restore}.
   *
   * @return a number that is only meaningful compared with an earlier one of this world; not part
   *     of the state
   */
  public long moves() {
    return moves;
  }

  /**
   * Creates queries about this world with its bodies in other poses. The shapes are those the
   * bodies have now. Allocates: create one and keep it.
   *
   * @param poses asked anew in each query
   * @return the queries
   */
  public Queries<T> queries(Poses poses) {
    return new Queries<>(this, poses);
  }

  /**
   * Limits what all queries of this world see, besides their own filters; no part of its state.
   *
   * @param newScope the shapes that queries see from now on; null for all
   */
  public void queryScope(QueryFilter<T> newScope) {
    scope = newScope;
  }

  boolean sees(Body<T> body, int shape) {
    return scope == null || scope.accepts(body, shape);
  }

  EditQueue<T> edits() {
    return edits;
  }

  // ---------------------------------------------------------------- recording of calls

  /** Sets the recorder of calls; null for none. */
  void recorder(WorldRecorder newRecorder) {
    refuseDuringStep("recording");
    recorder = newRecorder;
    if (newRecorder != null && filter != null) {
      askAbout(filter); // as the replay's world will, which begins with restoring
    }
  }

  /** Returns whether a collision filter is set. */
  boolean isFiltered() {
    return filter != null;
  }

  /** Returns which listeners there are: 1 for collisions, 2 for joints, added up. */
  int listeners() {
    return (events.listener() == null ? 0 : 1) | (jointListener == null ? 0 : 2);
  }

  /** Returns whether calls are recorded now: those of a step's own are not. */
  private boolean records() {
    return recorder != null && (!stepping || recorder.isInCallback());
  }

  private void settleRecorder() {
    if (records()) {
      recorder.settle();
    }
  }

  void enterCallback() {
    if (recorder != null) {
      recorder.enter();
    }
  }

  void leaveCallback() {
    if (recorder != null) {
      recorder.leave();
    }
  }

  private void tell(BiConsumer<JointListener<T>, Joint<T>> what, Joint<T> joint) {
    if (jointListener != null) {
      enterCallback();
      what.accept(jointListener, joint);
      leaveCallback();
    }
  }

  void note(Call call) {
    if (records()) {
      recorder.note(call);
    }
  }

  /** Notes a call of a body or joint, or one with a number. */
  void note(Call call, int of) {
    if (records()) {
      recorder.note(call, of);
    }
  }

  /** Notes a call of a body with a flag. */
  void note(Call call, int of, boolean flag) {
    if (records()) {
      recorder.note(call, of, flag ? 1 : 0);
    }
  }

  /** Notes a call of a body or joint with a number. */
  void note(Call call, int of, float a) {
    if (records()) {
      recorder.note(call, of, a);
    }
  }

  /** Notes a call of a body or joint with two numbers. */
  void note(Call call, int of, float a, float b) {
    if (records()) {
      recorder.note(call, of, a, b);
    }
  }

  /** Notes a call of a body with three numbers. */
  void note(Call call, int of, float a, float b, float c) {
    if (records()) {
      recorder.note(call, of, a, b, c);
    }
  }

  /** Notes a call of a body with four numbers. */
  void note(Call call, int of, float a, float b, float c, float d) {
    if (records()) {
      recorder.note(call, of, a, b, c, d);
    }
  }

  /** Notes a row that is written into a body. */
  void noteRow(int body, int[] row, int at) {
    if (records()) {
      recorder.noteRow(body, row, at);
    }
  }

  /** Notes an edit. */
  void noteEdit(byte what, int slot, Object value) {
    if (records()) {
      recorder.noteValue(Call.EDIT, what, slot, value);
    }
  }

  private void noteValue(Call call, Object value) {
    if (records()) {
      recorder.noteValue(call, value);
    }
  }

  /** Returns the receiver of contact events; null if there is no listener. */
  ContactEvents contactEvents() {
    return events.orNull();
  }

  /** Marks the world as busy. Returns false if it was busy already, in a step or in an edit. */
  boolean beginEdits() {
    boolean begins = !stepping;
    stepping = true;
    return begins;
  }

  void endEdits() {
    stepping = false;
  }

  void beginQuery(String what) {
    refuseDuringQuery(what);
    querying = true;
  }

  void endQuery() {
    querying = false;
  }

  /** Notes that bodies may be elsewhere, for those that ask {@link #moves}. */
  void posesChanged() {
    moves++;
  }

  private void refuseDuringStep(String what) {
    if (stepping) {
      throw new IllegalStateException(what + " is not possible in a collision callback");
    }
  }

  /**
   * Refuses a call during a query. What works on a world from outside calls it before its first
   * change, as the world's own methods do.
   *
   * @param what the call's name
   * @throws IllegalStateException while a query or a collision filter runs
   */
  public void refuseDuringQuery(String what) {
    if (querying) {
      throw new IllegalStateException(
          what
              + " is not possible while a query or a collision filter runs; remember what it finds,"
              + " and change the world afterwards");
    }
  }
}
