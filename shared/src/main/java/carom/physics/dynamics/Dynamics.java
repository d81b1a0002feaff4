package carom.physics.dynamics;

import carom.physics.broadphase.CastVisitor;
import carom.physics.broadphase.CellVisitor;
import carom.physics.broadphase.IntVisitor;
import carom.physics.dynamics.body.ActiveBodies;
import carom.physics.dynamics.body.BodyMaker;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.body.Settings;
import carom.physics.dynamics.body.ShapeSpec;
import carom.physics.dynamics.body.ShapeTable;
import carom.physics.dynamics.contact.BodyContacts;
import carom.physics.dynamics.contact.ContactEvents;
import carom.physics.dynamics.contact.ContactKey;
import carom.physics.dynamics.contact.ContactTable;
import carom.physics.dynamics.contact.SleepingContacts;
import carom.physics.dynamics.joint.JointEvents;
import carom.physics.dynamics.joint.JointStore;
import carom.physics.dynamics.pairs.PairFinder;
import carom.physics.dynamics.parallel.ParallelFor;
import carom.physics.dynamics.sleep.Sleeping;
import carom.physics.geometry.Convex;
import carom.physics.geometry.MassData;
import carom.physics.math.Aabb;
import carom.physics.math.StateHash;
import carom.physics.profile.StageListener;
import carom.physics.profile.StepStage;
import carom.physics.rows.ExactRows;
import carom.physics.threads.Workers;

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
 * <p><b>Sleep.</b> A step looks at the {@linkplain ActiveBodies active bodies} alone; see {@link
 * Sleeping}.
 *
 * <p>One thread at a time. A steady step allocates nothing.
 */
public final class Dynamics {
  /** Rows to have room for per awake body before there are as many, so that few steps allocate. */
  private static final int ROWS_AHEAD = 2;

  private final Settings settings;
  private final BodyStore bodies = new BodyStore();
  private final ShapeTable parts = new ShapeTable();
  private final BodyMaker maker = new BodyMaker(bodies, parts);
  private final ContactTable contacts = new ContactTable();
  private final JointStore joints = new JointStore();
  private final ParallelFor parallel = new ParallelFor();
  private final Substeps substeps;
  private final ContinuousCollision continuous;
  private final PairFinder pairs;
  private final Sleeping sleeping;
  private final CollideStage collideStage;
  private final EventStage eventStage;

  /** Whether a static body was ever moved by hand. */
  private boolean staticMoved;

  /** Whether it must be decided anew which pairs may touch. */
  private boolean rulesStale;

  /** Whether any joint ever could break. */
  private boolean breakable;

  private float lastStep = 1 / 60f;

  private final ActiveBodies active = new ActiveBodies();

  private final SleepingContacts sleepers = new SleepingContacts();
  private final BodyContacts bodyContacts = new BodyContacts(contacts, sleepers);
  private final RowTransfer transfer =
      new RowTransfer(bodies, parts, contacts, sleepers, bodyContacts);

  /** Null, unless somebody measures. */
  private StageListener stages;

  /**
   * Makes an empty world.
   *
   * @param settings its constants
   */
  public Dynamics(Settings settings) {
    this.settings = settings;
    pairs = new PairFinder(settings, bodies, parts, contacts, joints::mayTouch, parallel);
    continuous = new ContinuousCollision(pairs, settings, bodies, active, parts, contacts);
    sleeping = new Sleeping(settings, bodies, active, parts, contacts, sleepers, joints, pairs);
    collideStage =
        new CollideStage(sleeping, settings, bodies, parts, contacts, parallel, continuous);
    eventStage = new EventStage(settings, bodies, contacts);
    substeps = new Substeps(settings, bodies, active, contacts, joints, pairs, parallel);
  }

  /**
   * Has steps share their work, or no longer.
   *
   * @param workers null for the caller alone
   */
  public void workers(Workers workers) {
    parallel.use(workers);
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
      sleeping.wakeOverlapped(body);
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
      sleeping.wakeOverlapped(body);
    }
    sleeping.refreshJoints(body);
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
      sleeping.wakeOverlapped(body);
    } else {
      leave(body);
    }
    sleeping.refreshJoints(body);
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
    sleeping.mergeWoken();
    maker.refill(body, shapes, own, total);
    contacts.forgetManifolds(body);
    contacts.mixAgain(body, parts);
    sleeping.wakeOverlapped(body);
    rulesStale = true;
    sleeping.doAsked(); // by those who heard of contacts that ended
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
    sleeping.enter(body);
    pairs.enter(body);
  }

  /** Takes a body out again; nothing may rely on it any longer. */
  private void leave(int body) {
    sleeping.leave(body);
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
    sleeping.mergeWoken();
    if (events != null) {
      sleeping.suspend();
      try {
        for (int row = 0; row < contacts.count(); row++) {
          if (touches(row) && (contacts.bodyA(row) == body || contacts.bodyB(row) == body)) {
            events.end(row);
          }
        }
      } finally {
        sleeping.resume();
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
    sleeping.doAsked();
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
    sleeping.wakeEnds(joint);
    sleeping.refreshJoint(joint);
    return joint;
  }

  /**
   * Removes a joint.
   *
   * @param joint a slot in use
   */
  public void destroyJoint(int joint) {
    sleeping.wakeEnds(joint);
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
      contacts.ignore(row, !pairs.mayStay(contacts, row));
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
      sleeping.wakeOverlapped(body);
    } else {
      pairs.posesChanged();
      wake(body);
      sleeping.moved(body);
    }
  }

  /**
   * Must be called when a body gets a velocity, a force, or other numbers that decide how it moves:
   * wakes it and all that it holds or leans on.
   *
   * @param body the slot
   */
  public void wake(int body) {
    sleeping.wake(body);
  }

  /**
   * Puts a body and its island to sleep; velocities and forces are gone then. Nothing happens if
   * one of them may not sleep, or touches what it may not touch any longer.
   *
   * @param body the slot
   */
  public void sleep(int body) {
    sleeping.sleep(body);
  }

  /**
   * Must be called when what a body touches may lose its hold: before it is taken away, and when
   * its shapes, mass, filters or joints change. Wakes it and all that touches it, static or not.
   *
   * @param body the slot
   */
  public void disturb(int body) {
    sleeping.disturb(body);
  }

  /**
   * Must be called when the parameters of a joint changed: wakes its bodies.
   *
   * @param joint a slot in use
   */
  public void wakeEnds(int joint) {
    sleeping.wakeEnds(joint);
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
    sleeping.resume();
    contacts.reserve(ROWS_AHEAD * active.count);
    sleeping.doAsked();
    for (int i = 0; i < active.count; i++) {
      int body = active.list[i];
      if (bodies.type[body] == BodyStore.DYNAMIC) {
        bodies.applyImpulses(body);
      } else {
        sleeping.wakeJointed(body);
      }
    }
    sleeping.mergeWoken();
    pairs.posesChanged();
    refilter();
    begins(StepStage.BOXES);
    parallel.stepBegins(active.count);
    try {
      findContacts(events);
      substeps.run(dt);
    } finally {
      parallel.stepEnds();
    }
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
    sleeping.resume();
    sleeping.doAsked();
    begins(StepStage.SLEEP);
    if (settings.sleeping()) {
      sleeping.rest(dt);
    }
    if (stages != null) {
      stages.done();
    }
  }

  /** Renews boxes, pairs and contacts, and wakes what is touched. */
  private void findContacts(ContactEvents events) {
    refreshBoxes();
    boolean all = true;
    do {
      begins(StepStage.PAIRS);
      pairs.find();
      begins(StepStage.COLLIDE);
      collideStage.run(all);
      all = false;
    } while (sleeping.wakeTouched());
    sleeping.forgetMoves();
    sleeping.suspend();
    begins(StepStage.EVENTS);
    if (events != null) {
      eventStage.beforeSolving(events);
    }
    collideStage.holdBack();
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

  /** Stops fast bodies at what they would have passed through. */
  private void stopFast() {
    if (!settings.continuous() || !continuous.collect(substeps.solverBodies, lastStep)) {
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
    sleeping.mergeWoken();
    return contacts;
  }

  /**
   * The touching contacts of which no body is awake.
   *
   * @return the live table; some rows are {@linkplain ContactTable#unused unused}
   */
  public ContactTable sleepingContacts() {
    sleeping.mergeWoken();
    return sleepers.rows;
  }

  /**
   * What each body touches.
   *
   * @return answers from both tables
   */
  public BodyContacts bodyContacts() {
    sleeping.mergeWoken();
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
    sleeping.mergeWoken();
    long h = contacts.hash(bodies.hash(StateHash.SEED));
    return StateHash.finish(joints.hash(sleepers.hash(h)));
  }

  /**
   * Reads the exact state of listed bodies, and their contacts.
   *
   * @param rows lists bodies in use
   * @return contacts left out, because they are with bodies that are not listed
   */
  public int read(ExactRows rows) {
    sleeping.mergeWoken();
    return transfer.read(rows);
  }

  /**
   * Gives listed bodies the exact state of their rows, with their contacts.
   *
   * @param rows lists bodies that were made since the last step, awake
   */
  public void write(ExactRows rows) {
    sleeping.mergeWoken();
    transfer.writeBodies(rows);
    pairs.posesChanged();
    transfer.writeContacts(rows);
    sleeping.gatherNone();
    for (int i = 0; i < rows.bodies().count(); i++) {
      if (rows.isAsleep(i)) {
        sleeping.gatherAwake(rows.slot(i));
      }
    }
    sleeping.putToSleep();
  }

  /**
   * Copies the state out.
   *
   * @param to is overwritten
   * @param sameStructure whether no body came, went or changed since {@code to} was saved
   */
  public void save(DynamicsState to, boolean sameStructure) {
    sleeping.mergeWoken();
    to.take(bodies, contacts, joints);
    to.takeSleep(sleepers, sleeping.stamp());
    if (!sameStructure) {
      parts.copyTo(to.parts);
    }
  }

  void distinguish(DynamicsState read) {
    read.distinguish(bodies, contacts, joints, sleepers, sleeping.stamp());
  }

  /**
   * Takes a saved state over. The fat boxes stay as they are until a part leaves its own: they
   * don't influence results.
   *
   * @param from stays as it is
   * @param sameStructure whether no body came, went or changed since {@code from} was saved
   */
  public void restore(DynamicsState from, boolean sameStructure) {
    sleeping.reset();
    int misplaced =
        sameStructure ? sleeping.gatherMisplaced(from.bodies, from.sleep, staticMoved) : 0;
    from.bodies.copyTo(bodies);
    from.contacts.copyTo(contacts);
    from.joints.copyTo(joints);
    if (sameStructure) {
      for (int i = 0; i < misplaced; i++) {
        leave(sleeping.gathered(i));
        enter(sleeping.gathered(i));
      }
    } else {
      contacts.forgetManifolds();
      from.parts.copyTo(parts);
      pairs.clear();
      active.clear();
      active.reserve(bodies.slots());
      sleeping.clear();
      for (int body = 0; body < bodies.slots(); body++) {
        if (bodies.type[body] != BodyStore.FREE && !bodies.disabled(body)) {
          enter(body);
        }
      }
    }
    sleeping.take(from.sleepers, from.sleep);
    breakable |= joints.anyBreakable();
    rulesStale = true;
    pairs.searchAll();
    pairs.posesChanged();
  }
}
