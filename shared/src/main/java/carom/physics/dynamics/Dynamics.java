package carom.physics.dynamics;

import carom.physics.dynamics.body.ActiveBodies;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.body.ShapeTable;
import carom.physics.dynamics.contact.BodyContacts;
import carom.physics.dynamics.contact.ContactEvents;
import carom.physics.dynamics.contact.ContactTable;
import carom.physics.dynamics.contact.SleepingContacts;
import carom.physics.dynamics.continuous.ContinuousCollision;
import carom.physics.dynamics.joint.JointEvents;
import carom.physics.dynamics.joint.JointStore;
import carom.physics.dynamics.joint.JointTransfer;
import carom.physics.dynamics.pairs.PairFinder;
import carom.physics.dynamics.pairs.PartRule;
import carom.physics.dynamics.store.IntList;
import carom.physics.dynamics.store.ParallelFor;
import carom.physics.math.StateHash;
import carom.physics.profile.StageListener;
import carom.physics.profile.StepStage;
import carom.physics.rows.ExactRows;
import carom.physics.settings.Settings;
import carom.physics.threads.Workers;

/**
 * The bodies, shapes, contacts and joints of a world, and the step that moves them; the engine
 * behind {@code carom.physics.World}.
 *
 * <p><b>The step.</b> Each stage reads what the ones before it wrote. This is the one place that
 * says in which order they run; a stage that is called out of turn fails an assertion or works on
 * stale data.
 *
 * <pre>
 *   stage        class                  reads                    writes
 *   BEGIN        Sleeping, Refilter     requests of callbacks    velocities (impulses), awake bodies,
 *                                                                rows to ignore
 *   BOXES        PairFinder.refresh     poses                    fat boxes, moved parts
 *   PAIRS        PairFinder.find        fat boxes                trees, rows of the contact table
 *   COLLIDE      CollideStage           poses, rows              manifolds, bodies that wake
 *     (PAIRS and COLLIDE again, for new rows only, while bodies wake)
 *   EVENTS       EventStage             manifolds                vetoes; callbacks: end, begin, preSolve
 *   PREPARE..    Substeps               rows, joints, bodies     velocities, poses, impulses
 *   CONTINUOUS   ContinuousCollision    motion in this step      poses of fast bodies
 *   EVENTS       EventStage             impulses                 callbacks: postSolve, hit, begin
 *                                                                (sensors crossed), broke
 *   SLEEP        Sleeping               speeds, islands          sleeping bodies, rows that retire
 * </pre>
 *
 * <p>After the step, {@code carom.physics.World} carries out what callbacks deferred.
 *
 * <p><b>Between steps</b> {@link BodyEditor} makes, changes and removes bodies. Bodies that wake
 * between steps have their rows in no table until {@link Sleeping#mergeWoken}; therefore every
 * method here that hands out or reads contacts calls it first.
 *
 * <p><b>Order of constraints.</b> Contacts are always visited by ascending {@code ContactKey},
 * joints by ascending slot; the solver's colours follow from that order. Everything else in a step
 * is independent per body. So the result depends on the state alone, never on the shape of a tree
 * or on when a pair was found.
 *
 * <p><b>Sleep.</b> A step looks at the {@linkplain ActiveBodies active bodies} alone; see {@link
 * Sleeping}.
 *
 * <p>One thread at a time. A steady step allocates nothing.
 */
public final class Dynamics {
  /**
   * Rows to have room for per awake body, and once more per movable part of a small world, before
   * there are as many, so that few steps allocate.
   */
  private static final int ROWS_AHEAD = 2;

  private final Settings settings;
  private final BodyStore bodies = new BodyStore();
  private final ShapeTable parts;
  private final ContactTable contacts = new ContactTable();
  private final JointStore joints = new JointStore();
  private final ParallelFor parallel = new ParallelFor();
  private final Substeps substeps;
  private final ContinuousCollision continuous;
  private final PairFinder pairs;
  private final Sleeping sleeping;
  private final CollideStage collideStage;
  private final EventStage eventStage;
  private final Refilter refilter;
  private final BodyEditor editor;
  private final PartQueries queries;

  /** True once a joint could break. */
  private boolean breakable;

  private final ActiveBodies active = new ActiveBodies();

  private final SleepingContacts sleepers = new SleepingContacts();
  private final BodyContacts bodyContacts = new BodyContacts(contacts, sleepers);
  private final ColdWelds coldWelds = new ColdWelds(joints, bodies);
  private final JointTransfer jointTransfer = new JointTransfer(bodies, joints);
  private final EndedContacts ended = new EndedContacts(contacts);
  private final LostLoads lost;
  private final RowTransfer transfer;

  /** Scratch: the bodies of rows that sleep there. */
  private final IntList asleepThere = new IntList();

  /** Null, unless a program measures. */
  private StageListener stages;

  /**
   * Makes an empty world.
   *
   * @param settings its constants; they may change between steps
   */
  public Dynamics(Settings settings) {
    this.settings = settings;
    parts = new ShapeTable(settings);
    lost = new LostLoads(settings, bodies, joints, contacts, bodyContacts);
    transfer =
        new RowTransfer(bodies, parts, contacts, sleepers, bodyContacts, jointTransfer, ended);
    pairs = new PairFinder(settings, bodies, active, parts, contacts, joints::mayTouch, parallel);
    continuous = new ContinuousCollision(pairs, settings, bodies, active, parts, contacts);
    sleeping = new Sleeping(settings, bodies, active, parts, contacts, sleepers, joints, pairs);
    collideStage =
        new CollideStage(sleeping, settings, bodies, parts, contacts, parallel, continuous);
    eventStage = new EventStage(settings, bodies, parts, contacts, sleeping);
    refilter = new Refilter(contacts, pairs, lost);
    editor =
        new BodyEditor(
            settings, bodies, parts, active, contacts, pairs, sleeping, refilter, ended, lost);
    queries = new PartQueries(pairs, parts);
    substeps = new Substeps(settings, bodies, active, contacts, joints, pairs, parts, parallel);
  }

  /**
   * Sets what helps with the work of steps.
   *
   * @param workers null for the caller alone
   */
  public void workers(Workers workers) {
    parallel.use(workers);
  }

  /**
   * Returns the bodies. Between steps poses may be read, and numbers written that don't move
   * shapes.
   *
   * @return the live store
   */
  public BodyStore bodies() {
    return bodies;
  }

  /** Returns what makes, changes and removes bodies. */
  public BodyEditor editor() {
    return editor;
  }

  /** Returns what answers where the parts of shapes are. */
  public PartQueries queries() {
    return queries;
  }

  /**
   * Returns the joints. Their parameters may be written between steps.
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
    refilter.markStale();
    int joint = joints.allocate(type, bodyA, bodyB);
    sleeping.wakeEnds(joint);
    sleeping.jointActivity().refresh(joint);
    return joint;
  }

  /** Returns what passes definitions of joints from world to world. */
  public JointTransfer jointTransfer() {
    return jointTransfer;
  }

  /**
   * Removes a joint.
   *
   * @param joint a slot in use
   */
  public void destroyJoint(int joint) {
    sleeping.wakeEnds(joint);
    coldWelds.cool(joint);
    sleeping.mergeWoken();
    lost.losesJoint(joint);
    joints.release(joint);
    refilter.markStale();
  }

  /** Lets the welds of a beam start cold, because one of them is about to become a spring. */
  public void coolWelds(int joint) {
    coldWelds.cool(joint);
  }

  /** Makes steps look for joints that break; the first joint that can calls it. */
  public void watchBreaking() {
    breakable = true;
  }

  /**
   * Wakes a body with its island, because it gets a velocity, a force, or other numbers that decide
   * how it moves.
   *
   * @param body the slot
   */
  public void wake(int body) {
    sleeping.wake(body);
  }

  /** Wakes all bodies that sleep. */
  public void wakeAll() {
    for (int body = 0; body < bodies.slots(); body++) {
      if (bodies.type[body] != BodyStore.FREE && bodies.asleep(body)) {
        sleeping.wake(body);
      }
    }
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
   * Wakes the bodies of a joint, because its parameters changed.
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
   * @param events hears what happens, null for none
   * @param jointEvents hears what breaks
   */
  public void step(float dt, ContactEvents events, JointEvents jointEvents) {
    begins(StepStage.BEGIN);
    ended.clear();
    pairs.setTimeStep(dt);
    sleeping.resume();
    int few = pairs.fewMovableParts();
    contacts.reserve(ROWS_AHEAD * (active.count + few));
    sleepers.reserve(ROWS_AHEAD * few, bodies.slots());
    sleeping.doAsked();
    for (int i = 0; i < active.count; i++) {
      int body = active.list[i];
      if (bodies.type[body] == BodyStore.DYNAMIC) {
        bodies.applyImpulses(body);
      } else {
        sleeping.wakeDriven(body, dt);
      }
    }
    sleeping.mergeWoken();
    sleeping.reserve(ROWS_AHEAD * few);
    pairs.posesChanged();
    refilter.run();
    begins(StepStage.BOXES);
    parallel.stepBegins(active.count);
    try {
      findContacts(events, dt);
      substeps.run(dt);
    } finally {
      parallel.stepEnds();
    }
    pairs.posesChanged();
    begins(StepStage.CONTINUOUS);
    continuous.run(substeps.solverBodies, dt, events);
    substeps.payStretch();
    begins(StepStage.EVENTS);
    if (events != null) {
      eventStage.afterSolving();
    }
    collideStage.settleReserve();
    continuous.beginCrossings(events);
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
  private void findContacts(ContactEvents events, float dt) {
    pairs.refresh();
    eventStage.beginStep(events);
    begins(StepStage.PAIRS);
    pairs.find();
    begins(StepStage.COLLIDE);
    collideStage.run(true, dt, eventStage.passing);
    while (sleeping.anyTouched()) {
      eventStage.forgetAnswers();
      sleeping.wakeTouched();
      begins(StepStage.PAIRS);
      pairs.find();
      begins(StepStage.COLLIDE);
      collideStage.run(false, dt, eventStage.passing);
    }
    sleeping.forgetMoves();
    sleeping.suspend();
    begins(StepStage.EVENTS);
    if (events != null) {
      eventStage.beforeSolving();
    }
    collideStage.holdBack();
    collideStage.noteOverlaps();
  }

  /**
   * Sets the listener of the stages of a step; not part of the state.
   *
   * @param listener null for none, as at the start
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

  /**
   * Returns the contacts of which a body is awake.
   *
   * @return the live table
   */
  public ContactTable contacts() {
    sleeping.mergeWoken();
    return contacts;
  }

  /**
   * Returns the touching contacts of which no body is awake.
   *
   * @return the live table; some rows are {@linkplain ContactTable#unused unused}
   */
  public ContactTable sleepingContacts() {
    sleeping.mergeWoken();
    return sleepers.rows;
  }

  /**
   * Returns what looks up the contacts of one body.
   *
   * @return answers from both tables
   */
  public BodyContacts bodyContacts() {
    sleeping.mergeWoken();
    return bodyContacts;
  }

  /** Sets a rule of the user, asked last which parts may touch; null for none. */
  public void customRule(PartRule rule) {
    pairs.customRule(rule);
    refilter.markStale();
  }

  /** Returns what callbacks set for single contacts in a step. */
  public ContactOverrides contactOverrides() {
    return eventStage.overrides();
  }

  /**
   * Returns the number of touching contacts of the last step of which a body was awake.
   *
   * @return contacts with points
   */
  public int touchingCount() {
    return collideStage.touching();
  }

  /**
   * Returns the number of bodies that are awake and not static.
   *
   * @return bodies the next step looks at
   */
  public int activeCount() {
    return active.count;
  }

  /**
   * Returns a hash of everything that influences the future.
   *
   * @return 64 bits
   */
  public long hash() {
    sleeping.mergeWoken();
    long h = contacts.hash(bodies.hash(StateHash.SEED));
    return StateHash.finish(joints.hash(sleepers.hash(h)));
  }

  /**
   * Reads the exact state of listed bodies, and their joints and contacts.
   *
   * @param rows lists bodies in use
   * @return contacts left out, because they are with bodies that are not listed
   */
  public int read(ExactRows rows) {
    sleeping.mergeWoken();
    return transfer.read(rows);
  }

  /** Reads the state of one body into its row, which begins at an index. */
  public void readBody(int slot, int[] row, int at) {
    transfer.readBody(slot, row, at);
  }

  /** Gives a body that is awake the state of its row, which says that it is awake. */
  public void writeBody(int slot, int[] row, int at) {
    transfer.writeBody(slot, false, row, at);
  }

  /**
   * Gives listed bodies the exact state of their rows, with their joints and contacts.
   *
   * @param rows lists bodies and joints that were made since the last step, awake
   */
  public void write(ExactRows rows) {
    sleeping.mergeWoken();
    for (int i = 0; i < rows.bodies().count(); i++) {
      int slot = rows.slot(i);
      if (bodies.type[slot] == BodyStore.STATIC) {
        transfer.writeBody(slot, false, rows.bodies().ints(), rows.bodies().at(i));
        editor.moved(slot); // no step measures its box anew; it wakes what its joints hold
      }
    }
    transfer.writeBodies(rows);
    pairs.posesChanged();
    transfer.writeContacts(rows);
    jointTransfer.write(rows);
    asleepThere.count = 0;
    for (int i = 0; i < rows.bodies().count(); i++) {
      if (rows.isAsleep(i)) {
        asleepThere.add(rows.slot(i));
      }
    }
    sleeping.putToSleep(asleepThere);
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
    IntList misplaced =
        sameStructure
            ? sleeping.listMisplaced(from.bodies, from.sleep, editor.staticMoved())
            : null;
    from.bodies.copyTo(bodies);
    from.contacts.copyTo(contacts);
    from.joints.copyTo(joints);
    if (sameStructure) {
      for (int i = 0; i < misplaced.count; i++) {
        editor.leave(misplaced.values[i]);
        editor.enter(misplaced.values[i]);
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
          editor.enter(body);
        }
      }
    }
    sleeping.take(from.sleepers, from.sleep);
    breakable |= joints.anyBreakable();
    refilter.markStale();
    pairs.searchAll();
    pairs.posesChanged();
  }
}
