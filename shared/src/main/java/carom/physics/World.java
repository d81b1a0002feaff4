package carom.physics;

import carom.physics.archive.ArchiveException;
import carom.physics.archive.ArchiveReader;
import carom.physics.broadphase.index.CellVisitor;
import carom.physics.broadphase.index.IntVisitor;
import carom.physics.dynamics.Dynamics;
import carom.physics.dynamics.PartQueries;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.body.ShapeSpec;
import carom.physics.dynamics.contact.BodyContacts;
import carom.physics.dynamics.contact.ContactEvents;
import carom.physics.dynamics.contact.ContactTable;
import carom.physics.dynamics.joint.JointEvents;
import carom.physics.dynamics.joint.JointStore;
import carom.physics.geometry.MassData;
import carom.physics.math.Aabb;
import carom.physics.math.Limits;
import carom.physics.math.Transform;
import carom.physics.math.Trig;
import carom.physics.profile.StageListener;
import carom.physics.rows.ExactRows;
import carom.physics.threads.Workers;
import java.util.Arrays;
import java.util.Objects;
import java.util.function.Consumer;
import java.util.function.IntFunction;

/**
 * A rigid-body world: create bodies, step, look.
 *
 * <p>A pure function of its {@link WorldDef} and the calls made: equal calls in equal order give
 * equal bits on every JVM, and {@link #stateHash} proves it. One thread at a time. A steady {@link
 * #step} allocates nothing.
 *
 * <p><b>Length.</b> The class has one method per thing a program may ask of a world; half of it is
 * doc comments. The work is elsewhere: {@code dynamics} steps, {@link Queries} answers, {@code
 * EditQueue} changes bodies, {@code Handles} keeps their objects.
 *
 * @param <T> what bodies stand for in the user's program, see {@link Body#user()}
 */
public final class World<T> {
  /**
   * Changes whenever equal worlds come to behave otherwise than in the version before. States as
   * bytes, recordings and connections of another version are refused; {@code
   * carom.net.protocol.Protocol} says the same number.
   */
  public static final int PHYSICS_VERSION = 4;

  private final WorldDef def;
  private final Dynamics dynamics;
  private final PartQueries parts;
  private final BodyStore store;
  private final Collision<T> collision;
  private final JointStore joints;
  private final Events events = new Events();
  private final Queries<T> queries;
  private final Handles<T> handles = new Handles<>();
  private final EditQueue<T> edits;
  private long moves;
  private final JointEvents onBroke = this::broke;

  private CollisionListener<T> listener;
  private JointListener<T> jointListener;

  private boolean stepping;
  private boolean querying;

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
    dynamics = new Dynamics(def);
    parts = dynamics.queries();
    store = dynamics.bodies();
    joints = dynamics.joints();
    collision = new Collision<>(this, dynamics.contacts());
    queries = new Queries<>(this, null);
    edits = new EditQueue<>(this, dynamics, handles);
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
        dynamics
            .editor()
            .create(code(bodyDef.type), specs(given), bodyDef.mass, bodyDef.fixedRotation);
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
    dynamics.editor().enter(slot, bodyDef.awake);
    Body<T> body = new Body<>(this, store, slot, store.generation(slot), bodyDef.type, given, user);
    handles.put(body, given, bodyDef.mass);
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

  static byte code(BodyType type) {
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
    dynamics.destroyJoint(slot);
    handles.removeJoint(slot);
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
    int j = dynamics.createJoint((byte) d.type.ordinal(), a, b);
    new JointMaker(store, joints).fill(j, d);
    if (d.breakForce < Float.POSITIVE_INFINITY || d.breakTorque < Float.POSITIVE_INFINITY) {
      dynamics.watchBreaking();
    }
    Joint<T> joint = new Joint<>(this, joints, j, joints.generation(j), d.type);
    handles.put(joint);
    return joint;
  }

  private void own(Body<T> body) {
    body.check();
    if (body.world() != this) {
      throw new IllegalArgumentException("body=" + body + " belongs to another world");
    }
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
    edits.destroy(joint);
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
  public Joint<T> joint(int index) {
    return handles.joint(index);
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
    edits.destroy(joint);
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
    Limits.timeStep(dtSeconds);
    refuseDuringStep("step");
    refuseDuringQuery("step");
    stepping = true;
    try {
      moves++;
      dynamics.step(dtSeconds, contactEvents(), onBroke);
      edits.carryOut();
    } finally {
      stepping = false;
      edits.forget();
    }
  }

  /**
   * Sets who helps the thread that calls {@link #step}; not part of the state. Results are the same
   * bit for bit, with any number of workers or none. Callbacks stay on the calling thread. Steps
   * with fewer than 500 moving bodies are done by the caller alone.
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
    dynamics.save(s.dynamics, handles.sameBodies(s.handles));
    handles.copyTo(s.handles, store.slots(), joints.slots());
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
    dynamics.restore(s.dynamics, handles.sameBodies(s.handles));
    s.handles.copyTo(handles, store.slots(), joints.slots());
  }

  /**
   * Reads a state that {@link WorldState#write} has written, in this or another program, to be
   * taken over by {@link #restore}: bodies keep their slots and generations, and from then on this
   * world goes on like the one it was saved from, to the bit. Bodies and joints that this world has
   * under the same slot and generation keep their handles, unless they shall stand for another
   * user.
   *
   * <p>Trusts nothing: whatever the bytes are, they make a state that can be stepped or are
   * refused, and memory stays in proportion to them, but for parts of shapes, which are at most
   * 2^20. The world isn't touched.
   *
   * @param archive from where the state begins; read up to its end
   * @param users what bodies stand for, by slot; null for what they stand for here
   * @return the state, of this world
   * @throws ArchiveException if the bytes are damaged, of another physics version, or of a world
   *     with another definition
   */
  public WorldState read(ArchiveReader archive, IntFunction<T> users) {
    WorldState s = WorldState.read(archive, this, users);
    s.dynamics.distinguish(dynamics);
    handles.distinguish(s.handles);
    return s;
  }

  /**
   * A body of a state of this world.
   *
   * @param s made by {@link #save} or {@link #read}
   * @param index its slot
   * @return its handle, valid once the state is restored; null if there is none
   */
  @SuppressWarnings("unchecked")
  public Body<T> bodyIn(WorldState s, int index) {
    checkOwner(s);
    return (Body<T>) s.handles.body(index);
  }

  /**
   * Reads the exact state of some bodies and of their contacts, to be carried to another world.
   *
   * <p>A contact with a body that is neither listed nor static is left out. The rows then go on as
   * this world does only until that body matters.
   *
   * @param rows lists the bodies, see {@link ExactRows#addBody}; receives all but what belongs to
   *     the using program
   * @return number of contacts left out
   */
  public int readRows(ExactRows rows) {
    refuseDuringStep("readRows");
    return dynamics.read(rows);
  }

  /**
   * Gives new bodies the exact state that others have in another world, with their contacts. From
   * now on both go on alike, to the bit, as long as nothing else reaches them.
   *
   * <p>A contact whose end is no body of this world, or has no such part, is left out.
   *
   * @param rows stands for bodies that were created here since the last step and are awake, of the
   *     same kinds and in the same order as those it was read from; see {@link ExactRows#setSlot}
   */
  public void writeRows(ExactRows rows) {
    refuseDuringStep("writeRows");
    refuseDuringQuery("writeRows");
    dynamics.write(rows);
  }

  private void checkOwner(WorldState s) {
    if (s.owner != this) {
      throw new IllegalArgumentException("the state was saved by another world; restore it there");
    }
  }

  /** Numbers that {@link #readMotions} tells of each body. */
  public static final int MOTION = 7;

  /**
   * Writes where bodies are and how they move: the same numbers as {@link Body#x}, {@link Body#y},
   * {@link Body#cos}, {@link Body#sin}, {@link Body#velocityX}, {@link Body#velocityY} and {@link
   * Body#angularVelocity}, for whoever wants those of thousands.
   *
   * @param from the first one's {@link Body#index}, not negative
   * @param n how many slots in a row, which may be unused: then their numbers mean nothing
   * @param to {@link #MOTION} arrays, in this order, that receive n numbers each
   * @throws IndexOutOfBoundsException if one is shorter, or a slot is not below {@link #slotCount}
   */
  public void readMotions(int from, int n, float[][] to) {
    Objects.checkFromIndexSize(from, n, store.slots());
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
  public Body<T> body(int index) {
    return handles.body(index);
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
   * The body at a point.
   *
   * @param x m
   * @param y m
   * @return the one with the smallest index whose shape contains the point, null if none does
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

  /** Collects the parts in a box, sorted by body; answers how many. */
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
    parts.cells(visitor);
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
        parts.boxOf(part, fat, box);
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
      parts.boxOf(part, false, box);
      out.add(box);
    }
  }

  void moved(int slot) {
    refuseDuringQuery("setPose");
    moves++;
    dynamics.editor().moved(slot);
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

  EditQueue<T> edits() {
    return edits;
  }

  /** Who hears of contacts that end because a body goes or changes, null for nobody. */
  ContactEvents contactEvents() {
    return listener == null ? null : events;
  }

  /** Begins what callbacks may not disturb; answers false if it has begun already. */
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

  private void refuseDuringStep(String what) {
    if (stepping) {
      throw new IllegalStateException(what + " is not possible in a collision callback");
    }
  }

  void refuseDuringQuery(String what) {
    if (querying) {
      throw new IllegalStateException(what + " is not possible while a query visits bodies");
    }
  }
}
