package carom.physics.dynamics;

import carom.physics.broadphase.CastVisitor;
import carom.physics.broadphase.CellVisitor;
import carom.physics.broadphase.IntVisitor;
import carom.physics.geometry.Convex;
import carom.physics.geometry.MassData;
import carom.physics.math.Aabb;
import carom.physics.threads.Workers;
import java.util.Arrays;

/**
 * Bodies, their shapes and contacts, and the step that moves them; the engine behind {@code
 * carom.physics.World}.
 *
 * <p><b>A step</b>: refresh fat boxes; search pairs if a box changed; one manifold per pair; wake
 * what is touched, and repeat for what came with it; tell the owner (end, begin, pre-solve); then
 * {@code substeps} times: integrate velocities, warm start, solve with bias, integrate positions,
 * relax (joints before contacts); bounce; write back; stop fast bodies at what they passed through
 * (see {@link ContinuousCollision}); tell the owner (post-solve and hit, broken joints); put to
 * sleep what rests; carry out what was deferred.
 *
 * <p><b>Order.</b> Contacts are always visited by ascending {@link ContactKey}, joints by ascending
 * slot; the solver's colours follow from that order. Everything else in a step is independent per
 * body. So the result depends on the state alone, never on the shape of a tree or on when a pair
 * was found.
 *
 * <p><b>Sleep.</b> The active list holds the bodies that are awake and not static, and a step looks
 * at these alone: the parts of all others are in a tree of their own, contacts between them in
 * {@link SleepingContacts}, their joints are passed over. An island (dynamic bodies that hold each
 * other by touching contacts or joints) falls asleep when all its bodies have been slow for long
 * enough and nothing keeps it awake: a pending force, a moving kinematic body, a running belt or
 * motor, a body that may not sleep. Kinematic bodies at rest fall asleep alone. A body wakes with
 * its whole island: when something awake begins to touch it or no longer does, when its velocity,
 * forces, pose or joints change, and when what it touches, static bodies too, is moved, changed or
 * taken away. Islands are found anew each time, from contacts and joints; nothing is kept.
 *
 * <p>One thread at a time. A steady step allocates nothing.
 */
public final class Dynamics {
  private static final int FIRST_CAPACITY = 64;

  /** Rows to have room for per awake body before there are as many, so that few steps allocate. */
  private static final int ROWS_AHEAD = 2;

  /** Sleep time of a kinematic body that was set somewhere else since the last step. */
  private static final float MOVED = -1;

  private static final int ASK_WAKE = 0;
  private static final int ASK_DISTURB = 1;
  private static final int ASK_SLEEP = 2;
  private static final int ASKED = 3;

  private final Settings settings;
  private final BodyStore bodies = new BodyStore();
  private final ShapeTable parts = new ShapeTable();
  private final BodyMaker maker = new BodyMaker(bodies, parts);
  private final ContactTable contacts = new ContactTable();
  private final JointStore joints = new JointStore();
  private final Crew crew = new Crew();
  private final Substeps substeps;
  private final ContinuousCollision continuous;
  private final PairFinder pairs;
  private final CollideStage collideStage;
  private final EventStage eventStage;
  private final Aabb box = new Aabb();
  private final Aabb around = new Aabb();

  /** Whether a static body was ever moved by hand. */
  private boolean staticMoved;

  /** Whether it must be decided anew which pairs may touch. */
  private boolean rulesStale;

  /** Whether any joint ever could break. */
  private boolean breakable;

  private float lastStep = 1 / 60f;

  private final ActiveBodies active = new ActiveBodies();

  /** The part of a static body of which is asked what sleeps in its reach. */
  private int searchPart;

  private final IntVisitor onOverlapped = this::overlapped;

  private final SleepingContacts sleepers = new SleepingContacts();
  private final BodyContacts bodyContacts = new BodyContacts(contacts, sleepers);
  private final Islands islands = new Islands();
  private int asleepCount;

  /** Changes whenever a body falls asleep or wakes. */
  private final Stamp sleep = new Stamp();

  /** Rows of the sleeping contacts whose bodies woke and that must go to the contact table. */
  private int[] wokenRows = new int[FIRST_CAPACITY];

  private int wokenCount;

  /** Bodies to wake once a loop is through. */
  private int[] touched = new int[FIRST_CAPACITY];

  private int touchedCount;

  /** Bodies about to fall asleep, or just woken. */
  private int[] gathered = new int[FIRST_CAPACITY];

  private int gatheredCount;

  /** What was asked for in a callback: body * ASKED + what. */
  private long[] asked = new long[8];

  private int askedCount;

  /** Whether callbacks run, in which bodies neither wake nor fall asleep. */
  private boolean busy;

  /** Null, unless somebody measures. */
  private StageListener stages;

  /**
   * Makes an empty world.
   *
   * @param settings its constants
   */
  public Dynamics(Settings settings) {
    this.settings = settings;
    pairs = new PairFinder(settings, bodies, parts, contacts, joints);
    continuous = new ContinuousCollision(this, pairs, settings, bodies, active, parts, contacts);
    collideStage = new CollideStage(this, settings, bodies, parts, contacts, crew, continuous);
    eventStage = new EventStage(settings, bodies, contacts);
    substeps = new Substeps(settings, bodies, active, contacts, joints, crew);
  }

  /**
   * Has steps share their work, or no longer.
   *
   * @param workers null for the caller alone
   */
  public void workers(Workers workers) {
    crew.hire(workers);
  }

  /**
   * The bodies; poses may be read, and numbers that don't move shapes written, between steps.
   *
   * @return the live store
   */
  public BodyStore bodies() {
    return bodies;
  }

  /**
   * Makes a body at the origin. It takes part from {@link #enter} on.
   *
   * @param type one of {@link BodyStore}'s types
   * @param shapes what it consists of
   * @param own its mass, null to compute it from the shapes
   * @param fixedRotation whether only {@code setAngularVelocity} turns it
   * @return the slot
   */
  public int create(byte type, ShapeSpec[] shapes, MassData own, boolean fixedRotation) {
    int body = maker.make(type, shapes, own, fixedRotation);
    active.reserve(body + 1);
    return body;
  }

  /**
   * Lets a new body take part, where it is now. A static one wakes what it overlaps.
   *
   * @param body the slot
   * @param awake whether it starts awake; a static body doesn't care
   */
  public void enter(int body, boolean awake) {
    boolean maySleep = (bodies.flags[body] & BodyStore.SLEEPLESS) == 0 && settings.sleeping();
    if (!awake && maySleep && bodies.type[body] != BodyStore.STATIC) {
      bodies.flags[body] |= BodyStore.ASLEEP;
      bodies.vx[body] = 0;
      bodies.vy[body] = 0;
      bodies.w[body] = 0;
      enter(body);
      pairs.searchBody(body);
    } else {
      enter(body);
      wakeOverlapped(body);
    }
  }

  /**
   * Checks that a dynamic body could be made of some shapes.
   *
   * @param shapes what it would consist of
   * @param own its mass, null to compute it from the shapes
   * @throws IllegalArgumentException if they have no mass, or too much
   */
  public static void checkMass(ShapeSpec[] shapes, MassData own) {
    BodyMaker.massOf(shapes, own);
  }

  /**
   * Makes a body static, kinematic or dynamic. Its origin, and the velocity there, stay, except
   * that a static body is at rest.
   *
   * @param body the slot
   * @param type one of {@link BodyStore}'s types
   * @param shapes what it consists of
   * @param own its mass, null to compute it from the shapes
   */
  public void setType(int body, byte type, ShapeSpec[] shapes, MassData own) {
    if (bodies.type[body] == type) {
      return;
    }
    MassData total = BodyMaker.total(type, shapes, own);
    disturb(body);
    boolean enabled = !bodies.disabled(body);
    if (enabled) {
      leave(body);
    }
    bodies.type[body] = type;
    maker.refill(body, shapes, own, total);
    contacts.forgetManifolds(body);
    if (type == BodyStore.STATIC) {
      bodies.vx[body] = 0;
      bodies.vy[body] = 0;
      bodies.w[body] = 0;
    }
    bodies.clearForces(body);
    if (enabled) {
      enter(body);
      wakeOverlapped(body);
    }
    refreshJoints(body);
    rulesStale = true;
  }

  /**
   * Takes a body out of the simulation, or back in. Its contacts end in the next step.
   *
   * @param body the slot
   * @param enabled whether it takes part
   */
  public void setEnabled(int body, boolean enabled) {
    if (bodies.disabled(body) != enabled) {
      return;
    }
    disturb(body);
    bodies.flags[body] ^= BodyStore.DISABLED;
    bodies.clearForces(body);
    if (enabled) {
      enter(body);
      wakeOverlapped(body);
    } else {
      leave(body);
    }
    refreshJoints(body);
    rulesStale = true;
  }

  /**
   * Gives a body other materials, filters, sensors or another mass; its shapes stay. Its origin,
   * and the velocity there, stay, too.
   *
   * @param body the slot
   * @param shapes what it consists of
   * @param own its mass, null to compute it from the shapes
   */
  public void change(int body, ShapeSpec[] shapes, MassData own) {
    MassData total = BodyMaker.total(bodies.type[body], shapes, own);
    disturb(body);
    mergeWoken();
    maker.refill(body, shapes, own, total);
    contacts.forgetManifolds(body);
    contacts.mixAgain(body, parts);
    wakeOverlapped(body);
    rulesStale = true;
  }

  /**
   * Fixes a body's rotation, or frees it; {@link #change} must follow.
   *
   * @param body the slot
   * @param fixed whether nothing but {@code setAngularVelocity} turns it; it then stops turning
   */
  public void setFixedRotation(int body, boolean fixed) {
    if (fixed) {
      bodies.flags[body] |= BodyStore.FIXED_ROTATION;
      bodies.w[body] = 0;
    } else {
      bodies.flags[body] &= ~BodyStore.FIXED_ROTATION;
    }
  }

  /** Makes the broadphase and the solver know a body. */
  private void enter(int body) {
    boolean isStatic = bodies.type[body] == BodyStore.STATIC;
    boolean rests = isStatic || bodies.asleep(body);
    if (!rests) {
      active.add(body);
    } else if (!isStatic) {
      asleepCount++;
      sleep.change();
    }
    pairs.enter(body);
  }

  /** Whether any body but static ones sleeps. */
  boolean anyAsleep() {
    return asleepCount > 0;
  }

  /** Takes a body out again; nothing may rely on it any longer. */
  private void leave(int body) {
    if (active.contains(body)) {
      active.remove(body);
    } else if (bodies.type[body] != BodyStore.STATIC) {
      asleepCount--;
      sleep.change();
    }
    pairs.leave(body);
  }

  /**
   * Ends a body's contacts now; what still touches begins again in the next step.
   *
   * @param body the slot
   * @param events is told, null for nobody
   */
  public void endContacts(int body, ContactEvents events) {
    disturb(body);
    mergeWoken();
    if (events != null) {
      busy = true;
      try {
        for (int row = 0; row < contacts.count(); row++) {
          if (touches(row) && (contacts.bodyA(row) == body || contacts.bodyB(row) == body)) {
            events.end(row);
          }
        }
      } finally {
        busy = false;
      }
    }
    contacts.removeBody(body);
    pairs.searchAll();
  }

  /**
   * Removes a body; its touching contacts end first.
   *
   * @param body the slot
   * @param events is told, null for nobody
   */
  public void destroy(int body, ContactEvents events) {
    endContacts(body, events);
    if (!bodies.disabled(body)) {
      leave(body);
    }
    parts.release(bodies.firstPart[body], bodies.partCount[body]);
    bodies.release(body);
    doAsked();
  }

  /**
   * The joints; their parameters may be written between steps.
   *
   * @return the live store
   */
  public JointStore joints() {
    return joints;
  }

  /**
   * Makes a joint without flags; the caller fills it in.
   *
   * @param type one of {@link JointStore}'s types
   * @param bodyA a slot, -1 for the world
   * @param bodyB a slot
   * @return the joint's slot
   */
  public int createJoint(byte type, int bodyA, int bodyB) {
    rulesStale = true;
    int joint = joints.allocate(type, bodyA, bodyB);
    wakeEnds(joint);
    refreshJoint(joint);
    return joint;
  }

  /**
   * Removes a joint.
   *
   * @param joint a slot in use
   */
  public void destroyJoint(int joint) {
    wakeEnds(joint);
    joints.release(joint);
    rulesStale = true;
  }

  /** Must be called when a joint can break; before, nobody looks. */
  public void watchBreaking() {
    breakable = true;
  }

  /** Decides for each row whether its parts still may touch, and has new pairs searched. */
  private void refilter() {
    if (!rulesStale) {
      return;
    }
    rulesStale = false;
    pairs.searchAll();
    for (int row = 0; row < contacts.count(); row++) {
      int p = contacts.partA[row];
      int q = contacts.partB[row];
      boolean gone = bodies.disabled(parts.body[p]) || bodies.disabled(parts.body[q]);
      contacts.ignore(row, gone || !pairs.mayTouch(p, q));
    }
  }

  /**
   * Must be called after a pose was changed by hand.
   *
   * @param body the slot
   */
  public void moved(int body) {
    if (bodies.disabled(body)) {
      return;
    }
    if (bodies.type[body] == BodyStore.STATIC) {
      pairs.movedStatic(body);
      staticMoved = true;
      disturb(body);
      wakeOverlapped(body);
    } else {
      pairs.posesChanged();
      wake(body);
      if (bodies.type[body] == BodyStore.KINEMATIC && settings.sleeping()) {
        bodies.sleepTime[body] = MOVED;
      }
    }
  }

  /**
   * Must be called when a body gets a velocity, a force, or other numbers that decide how it moves:
   * wakes it and all that it holds or leans on.
   *
   * @param body the slot
   */
  public void wake(int body) {
    if (!bodies.asleep(body)) {
      bodies.sleepTime[body] = Math.min(bodies.sleepTime[body], 0);
    } else if (busy) {
      ask(body, ASK_WAKE);
    } else {
      wakeIsland(body);
    }
  }

  /**
   * Puts a body and its island to sleep; velocities and forces are gone then. Nothing happens if
   * one of them may not sleep.
   *
   * @param body the slot
   */
  public void sleep(int body) {
    if (busy) {
      ask(body, ASK_SLEEP);
    } else if (active.contains(body) && settings.sleeping()) {
      mergeWoken();
      findIslands();
      int island = islands.find(active.index[body]);
      gatheredCount = 0;
      for (int i = 0; i < active.count; i++) {
        if (islands.find(i) == island) {
          if ((bodies.flags[active.list[i]] & BodyStore.SLEEPLESS) != 0) {
            return;
          }
          gather(active.list[i]);
        }
      }
      putToSleep();
    }
  }

  /**
   * Must be called when what a body touches may lose its hold: before it is taken away, and when
   * its shapes, mass, filters or joints change. Wakes it and all that touches it, static or not.
   *
   * @param body the slot
   */
  public void disturb(int body) {
    if (busy) {
      ask(body, ASK_DISTURB);
      return;
    }
    wake(body);
    for (int end = sleepers.first(body); end >= 0; end = sleepers.first(body)) {
      wakeIsland(sleepers.other(end));
    }
    for (int end = joints.firstEnd(body); end >= 0; end = joints.nextEnd(end)) {
      wakeEnds(end >> 1);
    }
    if (asleepCount == 0 || bodies.type[body] == BodyStore.STATIC) {
      return;
    }
    mergeWoken();
    for (int row = 0; row < contacts.count(); row++) {
      int a = contacts.bodyA(row);
      int b = contacts.bodyB(row);
      if ((a == body || b == body) && touches(row)) {
        touch(a == body ? b : a);
      }
    }
    wakeTouched();
  }

  private void ask(int body, int what) {
    if (askedCount == asked.length) {
      asked = Arrays.copyOf(asked, askedCount * 2);
    }
    asked[askedCount++] = (long) body * ASKED + what;
  }

  /** Does what was asked for in callbacks. */
  private void doAsked() {
    for (int i = 0; i < askedCount; i++) {
      int body = (int) (asked[i] / ASKED);
      if (bodies.type[body] == BodyStore.FREE) {
        continue;
      }
      switch ((int) (asked[i] % ASKED)) {
        case ASK_WAKE -> wake(body);
        case ASK_DISTURB -> disturb(body);
        default -> sleep(body);
      }
    }
    askedCount = 0;
  }

  /**
   * Must be called when the parameters of a joint changed: wakes its bodies.
   *
   * @param joint a slot in use
   */
  public void wakeEnds(int joint) {
    if (joints.bodyA[joint] >= 0) {
      wake(joints.bodyA[joint]);
    }
    wake(joints.bodyB[joint]);
  }

  /** Remembers to wake a body, which may be awake already. */
  void touch(int body) {
    if (!bodies.asleep(body)) {
      return;
    }
    if (touchedCount == touched.length) {
      touched = Arrays.copyOf(touched, touchedCount * 2);
    }
    touched[touchedCount++] = body;
  }

  /** Wakes what was touched; answers whether there was anything. */
  private boolean wakeTouched() {
    if (touchedCount == 0) {
      return false;
    }
    for (int i = 0; i < touchedCount; i++) {
      wake(touched[i]);
    }
    touchedCount = 0;
    mergeWoken();
    return true;
  }

  /** Wakes what sleeps within reach of a static body. */
  private void wakeOverlapped(int body) {
    if (asleepCount == 0 || bodies.type[body] != BodyStore.STATIC) {
      return;
    }
    pairs.admit();
    int first = bodies.firstPart[body];
    for (int part = first; part < first + bodies.partCount[body]; part++) {
      searchPart = part;
      float reach = settings.speculativeDistance();
      pairs.tightBox(part, around);
      around.set(
          around.minX - reach, around.minY - reach, around.maxX + reach, around.maxY + reach);
      pairs.resting().query(around.minX, around.minY, around.maxX, around.maxY, onOverlapped);
    }
    wakeTouched();
  }

  /** Looks at the box itself, as the fat one depends on what was before. */
  private boolean overlapped(int part) {
    if (bodies.asleep(parts.body[part]) && pairs.mayTouch(part, searchPart)) {
      pairs.tightBox(part, box);
      if (box.overlaps(around)) {
        touch(parts.body[part]);
      }
    }
    return true;
  }

  /** Wakes a sleeping body and all that is tied to it by contacts and joints. */
  private void wakeIsland(int body) {
    if (!bodies.asleep(body)) {
      return;
    }
    pairs.admit();
    gatheredCount = 0;
    rouse(body);
    for (int i = 0; i < gatheredCount; i++) {
      int at = gathered[i];
      boolean ties = bodies.type[at] == BodyStore.DYNAMIC;
      for (int end = sleepers.first(at); end >= 0; end = sleepers.first(at)) {
        int other = sleepers.other(end);
        if (ties && sleepers.solid(end)) {
          rouseDynamic(other);
        }
        sleepers.unlink(end >> 1);
        if (wokenCount == wokenRows.length) {
          wokenRows = Arrays.copyOf(wokenRows, wokenCount * 2);
        }
        wokenRows[wokenCount++] = end >> 1;
      }
      for (int end = joints.firstEnd(at); ties && end >= 0; end = joints.nextEnd(end)) {
        int other = joints.other(end);
        if (other >= 0) {
          rouseDynamic(other);
        }
      }
    }
    pairs.wake(gathered, gatheredCount);
    for (int i = 0; i < gatheredCount; i++) {
      refreshJoints(gathered[i]);
    }
  }

  private void rouseDynamic(int body) {
    if (bodies.type[body] == BodyStore.DYNAMIC && bodies.asleep(body)) {
      rouse(body);
    }
  }

  private void rouse(int body) {
    gather(body);
    bodies.flags[body] &= ~BodyStore.ASLEEP;
    bodies.sleepTime[body] = bodies.sleepTime[body] == MOVED ? MOVED : 0;
    asleepCount--;
    sleep.change();
    active.add(body);
  }

  private void gather(int body) {
    if (gatheredCount == gathered.length) {
      gathered = Arrays.copyOf(gathered, gatheredCount * 2);
    }
    gathered[gatheredCount++] = body;
  }

  /** Brings the contacts of bodies that woke back to the table. */
  private void mergeWoken() {
    if (wokenCount == 0) {
      return;
    }
    sleepers.rows.sortByKey(wokenRows, wokenCount);
    contacts.insert(sleepers.rows, wokenRows, wokenCount);
    for (int i = 0; i < wokenCount; i++) {
      sleepers.release(wokenRows[i]);
    }
    wokenCount = 0;
  }

  /** Decides which joints the solver looks at, after a body came, went, woke or fell asleep. */
  private void refreshJoints(int body) {
    for (int end = joints.firstEnd(body); end >= 0; end = joints.nextEnd(end)) {
      refreshJoint(end >> 1);
    }
  }

  /** A joint is awake if a body of it is, and none sleeps that it could move. */
  private void refreshJoint(int joint) {
    int a = joints.bodyA[joint];
    int b = joints.bodyB[joint];
    boolean awake = active.contains(b) || (a >= 0 && active.contains(a));
    boolean waits = sleepsDynamic(b) || (a >= 0 && sleepsDynamic(a));
    joints.setAwake(joint, awake && !waits);
    if (!awake && !waits) {
      joints.forget(joint);
    }
  }

  /** Whether a body is dynamic and asleep. */
  boolean sleepsDynamic(int body) {
    return bodies.type[body] == BodyStore.DYNAMIC && bodies.asleep(body);
  }

  /**
   * Advances the world.
   *
   * @param dt s, checked by the caller
   * @param events is told what happens, null for nobody
   * @param jointEvents is told what breaks
   */
  public void step(float dt, ContactEvents events, JointEvents jointEvents) {
    begins(StepStage.BEGIN);
    lastStep = dt;
    busy = false;
    contacts.reserve(ROWS_AHEAD * active.count);
    doAsked();
    boolean teleported = false;
    for (int i = 0; i < active.count; i++) {
      int body = active.list[i];
      if (bodies.type[body] == BodyStore.DYNAMIC) {
        bodies.applyImpulses(body);
      } else if (drives(body)) {
        teleported |= bodies.sleepTime[body] == MOVED;
        wakeJointed(body);
      }
    }
    mergeWoken();
    pairs.posesChanged();
    refilter();
    begins(StepStage.BOXES);
    refreshBoxes();
    boolean all = true;
    do {
      begins(StepStage.PAIRS);
      pairs.find();
      begins(StepStage.COLLIDE);
      collideStage.run(all);
      all = false;
    } while (wakeTouched());
    if (teleported) {
      forgetMoves();
    }
    busy = true;
    begins(StepStage.EVENTS);
    if (events != null) {
      eventStage.beforeSolving(events);
    }
    collideStage.holdBack();
    substeps.run(dt);
    pairs.posesChanged();
    begins(StepStage.CONTINUOUS);
    stopFast();
    begins(StepStage.EVENTS);
    if (events != null) {
      eventStage.afterSolving(events);
    }
    if (breakable) {
      breakJoints(jointEvents);
    }
    busy = false;
    doAsked();
    begins(StepStage.SLEEP);
    if (settings.sleeping()) {
      rest(dt);
    }
    if (stages != null) {
      stages.done();
    }
  }

  /**
   * Sets who is told of the stages of a step; not part of the state.
   *
   * @param listener null for nobody, as at the start
   */
  public void stageListener(StageListener listener) {
    stages = listener;
    substeps.stageListener(listener);
  }

  private void begins(StepStage stage) {
    if (stages != null) {
      stages.begins(stage);
    }
  }

  /** Wakes what a body that moves holds by joints. */
  private void wakeJointed(int body) {
    for (int end = joints.firstEnd(body); end >= 0; end = joints.nextEnd(end)) {
      int other = joints.other(end);
      if (other >= 0) {
        wakeIsland(other);
      }
    }
  }

  private void forgetMoves() {
    for (int i = 0; i < active.count; i++) {
      int body = active.list[i];
      if (bodies.sleepTime[body] == MOVED) {
        bodies.sleepTime[body] = 0;
      }
    }
  }

  /** Measures how long bodies have been slow, and puts islands to sleep. */
  private void rest(float dt) {
    boolean any = false;
    for (int i = 0; i < active.count; i++) {
      any |= measure(active.list[i], dt);
    }
    if (!any) {
      return;
    }
    mergeWoken();
    findIslands();
    for (int i = 0; i < active.count; i++) {
      if (bodies.sleepTime[active.list[i]] < settings.sleepDelay()
          || bodies.pushed(active.list[i])) {
        islands.keepAwake(i);
      }
    }
    gatheredCount = 0;
    for (int i = 0; i < active.count; i++) {
      if (!islands.keptAwake(i)) {
        gather(active.list[i]);
      }
    }
    putToSleep();
  }

  /** Lets a body's time of rest go on; answers whether it is long enough. */
  private boolean measure(int body, float dt) {
    float vx = bodies.vx[body];
    float vy = bodies.vy[body];
    float most = bodies.type[body] == BodyStore.DYNAMIC ? settings.sleepSpeed() : 0;
    float spin = bodies.reach[body] * bodies.w[body];
    boolean slow = vx * vx + vy * vy <= most * most && Math.abs(spin) <= most;
    if (bodies.sleepTime[body] == MOVED) {
      return false;
    }
    if (!slow || (bodies.flags[body] & BodyStore.SLEEPLESS) != 0) {
      bodies.sleepTime[body] = 0;
      return false;
    }
    float time = bodies.sleepTime[body] + dt;
    bodies.sleepTime[body] = Math.min(time, settings.sleepDelay());
    return time >= settings.sleepDelay();
  }

  /** Finds out which awake bodies hold each other, and what keeps them awake. */
  private void findIslands() {
    islands.reset(active.count);
    for (int row = 0; row < contacts.count(); row++) {
      if (contacts.points[row] > 0 && (contacts.flags[row] & ContactTable.VETOED) == 0) {
        tie(contacts.bodyA(row), contacts.bodyB(row), contacts.surface[row] != 0);
      }
    }
    for (int j = joints.nextAwake(0); j >= 0; j = joints.nextAwake(j + 1)) {
      boolean runs = (joints.flags[j] & JointStore.DRIVEN) != 0 && joints.motorSpeed[j] != 0;
      tie(joints.bodyA[j], joints.bodyB[j], runs);
    }
  }

  /** Dynamic bodies join; a kinematic one that hasn't rested for long keeps the other awake. */
  private void tie(int a, int b, boolean running) {
    int i = a < 0 ? -1 : active.index[a];
    int j = active.index[b];
    boolean dynamicA = i >= 0 && bodies.type[a] == BodyStore.DYNAMIC;
    boolean dynamicB = j >= 0 && bodies.type[b] == BodyStore.DYNAMIC;
    boolean restless = running;
    if (dynamicA && dynamicB) {
      islands.join(i, j);
    } else {
      restless |= i >= 0 && !dynamicA && bodies.sleepTime[a] < settings.sleepDelay();
      restless |= j >= 0 && !dynamicB && bodies.sleepTime[b] < settings.sleepDelay();
    }
    if (restless && dynamicA) {
      islands.keepAwake(i);
    }
    if (restless && dynamicB) {
      islands.keepAwake(j);
    }
  }

  /** Puts the gathered bodies to sleep; they must be whole islands. */
  private void putToSleep() {
    if (gatheredCount == 0) {
      return;
    }
    pairs.admit();
    for (int i = 0; i < gatheredCount; i++) {
      int body = gathered[i];
      active.remove(body);
      bodies.flags[body] |= BodyStore.ASLEEP;
      bodies.sleepTime[body] = settings.sleepDelay();
      bodies.vx[body] = 0;
      bodies.vy[body] = 0;
      bodies.w[body] = 0;
      bodies.clearForces(body);
      asleepCount++;
    }
    pairs.rest(gathered, gatheredCount);
    sleep.change();
    for (int i = 0; i < gatheredCount; i++) {
      refreshJoints(gathered[i]);
    }
    contacts.retire(active.index, sleepers);
  }

  /** Whether an active body pushes what it touches: a kinematic one only while it moves. */
  boolean drives(int body) {
    return active.contains(body)
        && (bodies.type[body] == BodyStore.DYNAMIC
            || bodies.vx[body] != 0
            || bodies.vy[body] != 0
            || bodies.w[body] != 0
            || bodies.sleepTime[body] == MOVED);
  }

  private void breakJoints(JointEvents events) {
    for (int j = joints.nextAwake(0); j >= 0; j = joints.nextAwake(j + 1)) {
      float x = joints.forceX[j];
      float y = joints.forceY[j];
      float most = joints.breakForce[j];
      if (x * x + y * y > most * most || Math.abs(joints.torque[j]) > joints.breakTorque[j]) {
        events.broke(j);
      }
    }
  }

  private void refreshBoxes() {
    pairs.refresh(active, lastStep);
  }

  /** The length of the last step, s. */
  float lastStep() {
    return lastStep;
  }

  /** Stops fast bodies at what they would have passed through. */
  private void stopFast() {
    if (!settings.continuous() || !continuous.collect(substeps.solverBodies)) {
      return;
    }
    if (continuous.prepare()) {
      refreshBoxes();
      continuous.widen();
    }
    pairs.refit();
    continuous.settle(pairs.moving(), pairs.resting());
    pairs.posesChanged();
  }

  /**
   * Calls back with every part whose tight box overlaps the given one.
   *
   * @param minX left edge, m
   * @param minY lower edge, m
   * @param maxX right edge, m
   * @param maxY upper edge, m
   * @param visitor receives parts in no particular order
   */
  public void query(float minX, float minY, float maxX, float maxY, IntVisitor visitor) {
    refreshBoxes();
    pairs.refit();
    pairs.moving().query(minX, minY, maxX, maxY, visitor);
    pairs.resting().query(minX, minY, maxX, maxY, visitor);
  }

  /**
   * Calls back with every part whose fat box a moving box meets.
   *
   * @param minX left edge at the start, m
   * @param minY lower edge, m
   * @param maxX right edge, m
   * @param maxY upper edge, m
   * @param dx way along x, m
   * @param dy way along y, m
   * @param visitor receives parts in no particular order; the way it shortens must stay short, as
   *     there are two trees
   */
  public void cast(
      float minX, float minY, float maxX, float maxY, float dx, float dy, CastVisitor visitor) {
    refreshBoxes();
    pairs.refit();
    pairs.moving().cast(minX, minY, maxX, maxY, dx, dy, 1, visitor);
    pairs.resting().cast(minX, minY, maxX, maxY, dx, dy, 1, visitor);
  }

  /**
   * The box of one part.
   *
   * @param part which
   * @param fat whether with its margin, as the broadphase sees it
   * @param out receives the box
   */
  public void boxOf(int part, boolean fat, Aabb out) {
    if (fat) {
      refreshBoxes();
      out.set(
          parts.fat.minX(part), parts.fat.minY(part), parts.fat.maxX(part), parts.fat.maxY(part));
    } else {
      pairs.tightBox(part, out);
    }
  }

  /**
   * Visits the nodes of both trees.
   *
   * @param visitor receives boxes and depths
   */
  public void cells(CellVisitor visitor) {
    refreshBoxes();
    pairs.refit();
    pairs.moving().cells(visitor);
    pairs.resting().cells(visitor);
  }

  /**
   * The body a part belongs to.
   *
   * @param part which
   * @return its slot
   */
  public int bodyOf(int part) {
    return parts.body[part];
  }

  /**
   * The geometry of a part.
   *
   * @param part which
   * @return relative to its body's centre of mass
   */
  public Convex convexOf(int part) {
    return parts.convex[part];
  }

  /**
   * Which of its body's shapes a part belongs to.
   *
   * @param part which
   * @return the shape's number
   */
  public int shapeOf(int part) {
    return parts.shapeIndex[part];
  }

  /**
   * The contacts of which a body is awake.
   *
   * @return the live table
   */
  public ContactTable contacts() {
    mergeWoken();
    return contacts;
  }

  /**
   * The touching contacts of which no body is awake.
   *
   * @return the live table; some rows are {@linkplain ContactTable#unused unused}
   */
  public ContactTable sleepingContacts() {
    mergeWoken();
    return sleepers.rows;
  }

  /**
   * What each body touches.
   *
   * @return answers from both tables
   */
  public BodyContacts bodyContacts() {
    mergeWoken();
    return bodyContacts;
  }

  /**
   * Whether the parts of a row touch; those of sensors do so without points.
   *
   * @param row which
   * @return false if the parts are merely near
   */
  public boolean touches(int row) {
    return (contacts.flags[row] & ContactTable.TOUCHING) != 0;
  }

  /**
   * The number of touching contacts in the last step of which a body was awake.
   *
   * @return contacts with points
   */
  public int touchingCount() {
    return collideStage.touching();
  }

  /**
   * The number of bodies that are awake and not static.
   *
   * @return bodies the next step looks at
   */
  public int activeCount() {
    return active.count;
  }

  /**
   * Hash of everything that influences the future.
   *
   * @return 64 bits
   */
  public long hash() {
    mergeWoken();
    long h = StateHash.mix(bodies.hash(StateHash.SEED), contacts.hash());
    return StateHash.finish(joints.hash(sleepers.hash(h)));
  }

  /**
   * Reads the exact state of the bodies listed in an excerpt.
   *
   * @param excerpt lists bodies in use
   */
  public void read(Excerpt excerpt) {
    mergeWoken();
    excerpt.read(bodies, bodyContacts, contacts, sleepers);
  }

  /**
   * Gives the bodies listed in an excerpt the state it holds, with their contacts.
   *
   * @param excerpt lists bodies that were made since the last step, awake
   */
  public void write(Excerpt excerpt) {
    mergeWoken();
    gatheredCount = 0;
    for (int i = 0; i < excerpt.count(); i++) {
      int body = excerpt.slot(i);
      excerpt.writeBody(bodies, i);
      if (excerpt.sleeps(i) && active.contains(body)) {
        gather(body);
      }
    }
    pairs.posesChanged();
    excerpt.writeContacts(bodies, parts, contacts);
    putToSleep();
  }

  /**
   * Copies the state out.
   *
   * @param to is overwritten
   * @param sameStructure whether no body came, went or changed since {@code to} was saved
   */
  public void save(DynamicsState to, boolean sameStructure) {
    mergeWoken();
    to.take(bodies, contacts, joints);
    to.takeSleep(sleepers, sleep);
    if (!sameStructure) {
      parts.copyTo(to.parts);
    }
  }

  /**
   * Takes a saved state over. The fat boxes stay as they are until a part leaves its own: they
   * don't influence results.
   *
   * @param from stays as it is
   * @param sameStructure whether no body came, went or changed since {@code from} was saved
   */
  public void restore(DynamicsState from, boolean sameStructure) {
    wokenCount = 0;
    touchedCount = 0;
    askedCount = 0;
    busy = false;
    gatheredCount = 0;
    if (sameStructure) {
      gatherMisplaced(from);
    }
    from.bodies.copyTo(bodies);
    from.contacts.copyTo(contacts);
    from.joints.copyTo(joints);
    if (sameStructure) {
      for (int i = 0; i < gatheredCount; i++) {
        leave(gathered[i]);
        enter(gathered[i]);
      }
    } else {
      from.parts.copyTo(parts);
      pairs.clear();
      active.clear();
      active.reserve(bodies.slots());
      asleepCount = 0;
      for (int body = 0; body < bodies.slots(); body++) {
        if (bodies.type[body] != BodyStore.FREE && !bodies.disabled(body)) {
          enter(body);
        }
      }
    }
    if (!sleep.same(from.sleep)) {
      from.sleepers.copyTo(sleepers);
      from.sleep.copyTo(sleep);
    }
    joints.clearAwake();
    for (int j = 0; j < joints.slots(); j++) {
      if (joints.type[j] != JointStore.FREE) {
        refreshJoint(j);
      }
    }
    rulesStale = true;
    pairs.searchAll();
    pairs.posesChanged();
  }

  /** Finds the bodies that are in the wrong tree, or in the wrong place of the tree that rests. */
  private void gatherMisplaced(DynamicsState from) {
    if (!staticMoved && sleep.same(from.sleep)) {
      return;
    }
    BodyStore then = from.bodies;
    for (int body = 0; body < bodies.slots(); body++) {
      if (bodies.type[body] == BodyStore.FREE || bodies.disabled(body)) {
        continue;
      }
      boolean moves = active.contains(body);
      boolean willRest = bodies.type[body] == BodyStore.STATIC || then.asleep(body);
      if (moves == willRest || (willRest && !samePlace(then, body))) {
        gather(body);
      }
    }
  }

  private boolean samePlace(BodyStore then, int body) {
    return bodies.x[body] == then.x[body]
        && bodies.y[body] == then.y[body]
        && bodies.cos[body] == then.cos[body]
        && bodies.sin[body] == then.sin[body];
  }
}
