package carom.physics.dynamics;

import carom.physics.dynamics.body.ActiveBodies;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.body.ShapeTable;
import carom.physics.dynamics.contact.ContactTable;
import carom.physics.dynamics.contact.SleepingContacts;
import carom.physics.dynamics.joint.JointStore;
import carom.physics.dynamics.pairs.PairFinder;
import carom.physics.dynamics.store.IntList;
import carom.physics.dynamics.store.KeySorter;
import carom.physics.dynamics.store.Stamp;
import carom.physics.settings.Settings;

/**
 * Decides which bodies fall asleep and wakes them, with all that belongs to them.
 *
 * <p>A step looks at the {@linkplain ActiveBodies active bodies} alone. The others have a tree of
 * their own, and {@link SleepingContacts}; their joints are skipped. An island falls asleep when
 * all its bodies have been slow for long and nothing keeps it awake: a pending force, a moving
 * kinematic body, a running belt or motor, a body that may not sleep. Kinematic bodies at rest fall
 * asleep alone. A body wakes with its island: when something awake begins to touch it or ceases to,
 * when its velocity, forces, pose or joints change, and when what it touches moves or changes.
 *
 * <p>The contacts of a body that wakes are in no table until {@link #mergeWoken}.
 */
final class Sleeping {
  private final Settings settings;
  private final BodyStore bodies;
  private final ActiveBodies active;
  private final ContactTable contacts;
  private final SleepingContacts sleepers;
  private final JointStore joints;
  private final PairFinder pairs;
  private final RestTime restTime;
  private final IslandFinder islands;
  private final JointActivity jointActivity;
  private final StaticReach staticReach;
  private final KeySorter sorter = new KeySorter();
  private int asleepCount;

  /** Rows of the sleeping contacts whose bodies woke and that must go to the contact table. */
  private final IntList wokenRows = new IntList();

  /** Bodies to wake once a loop is through. */
  private final IntList touched = new IntList();

  /** Bodies about to fall asleep, or just woken. */
  private final IntList gathered = new IntList();

  private final SleepRequests requests = new SleepRequests();

  /** Changes whenever a body falls asleep or wakes. */
  private final Stamp stamp = new Stamp();

  /** True while callbacks run, in which bodies neither wake nor fall asleep. */
  private boolean suspended;

  /** Makes the sleep of a world without bodies. */
  public Sleeping(
      Settings settings,
      BodyStore bodies,
      ActiveBodies active,
      ShapeTable parts,
      ContactTable contacts,
      SleepingContacts sleepers,
      JointStore joints,
      PairFinder pairs) {
    this.settings = settings;
    this.bodies = bodies;
    this.active = active;
    this.contacts = contacts;
    this.sleepers = sleepers;
    this.joints = joints;
    this.pairs = pairs;
    restTime = new RestTime(settings, bodies, active);
    islands = new IslandFinder(settings, bodies, active, contacts, joints, pairs);
    jointActivity = new JointActivity(bodies, active, joints);
    staticReach = new StaticReach(settings, bodies, parts, pairs);
  }

  // ---------------------------------------------------------------- who takes part

  /** Adds a body: to the active ones, unless it is static or asleep. */
  public void enter(int body) {
    if (bodies.type[body] == BodyStore.STATIC) {
      return;
    }
    if (bodies.asleep(body)) {
      asleepCount++;
      stamp.change();
    } else {
      active.add(body);
    }
  }

  /** Removes a body. */
  public void leave(int body) {
    if (active.contains(body)) {
      active.remove(body);
    } else if (bodies.type[body] != BodyStore.STATIC) {
      asleepCount--;
      stamp.change();
    }
  }

  /** Returns what decides which joints the solver looks at. */
  public JointActivity jointActivity() {
    return jointActivity;
  }

  /** Returns whether any body sleeps; static ones don't count. */
  public boolean anyAsleep() {
    return asleepCount > 0;
  }

  /** Returns whether a body is dynamic and asleep. */
  public boolean sleepsDynamic(int body) {
    return bodies.type[body] == BodyStore.DYNAMIC && bodies.asleep(body);
  }

  /** Returns whether an active body pushes what it touches: a kinematic one only while it moves. */
  public boolean drives(int body) {
    return active.contains(body)
        && (bodies.type[body] == BodyStore.DYNAMIC
            || bodies.vx[body] != 0
            || bodies.vy[body] != 0
            || bodies.w[body] != 0
            || restTime.moved(body));
  }

  /** Notes that a body that isn't static was put elsewhere by hand and woken. */
  public void moved(int body) {
    restTime.markMoved(body);
  }

  /** Forgets which bodies were put elsewhere by hand. */
  public void forgetMoves() {
    restTime.forgetMoves();
  }

  // ---------------------------------------------------------------- callbacks

  /** Keeps bodies from waking and falling asleep while callbacks run; requests are kept. */
  public void suspend() {
    suspended = true;
  }

  /** Lets bodies wake and fall asleep again; {@link #doAsked} carries out the requests. */
  public void resume() {
    suspended = false;
  }

  /** Carries out what callbacks asked for, once bodies may wake and fall asleep again. */
  public void doAsked() {
    for (int i = 0; i < requests.count(); i++) {
      int body = requests.body(i);
      if (bodies.type[body] == BodyStore.FREE) {
        continue;
      }
      switch (requests.what(i)) {
        case SleepRequests.WAKE -> wake(body);
        case SleepRequests.DISTURB -> disturb(body);
        default -> sleep(body);
      }
    }
    requests.clear();
  }

  // ---------------------------------------------------------------- waking

  /** Wakes a body and its island. An awake body starts to count its time at rest anew. */
  public void wake(int body) {
    if (!bodies.asleep(body)) {
      restTime.restart(body);
    } else if (suspended) {
      requests.add(body, SleepRequests.WAKE);
    } else {
      wakeIsland(body);
    }
  }

  /** Wakes a body, static or not, and all that touches it, because they may lose their hold. */
  public void disturb(int body) {
    if (suspended) {
      requests.add(body, SleepRequests.DISTURB);
      return;
    }
    wake(body);
    beginWaking();
    for (int end = sleepers.first(body); end >= 0; end = sleepers.first(body)) {
      rouseIsland(sleepers.other(end));
    }
    endWaking();
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
      if ((a == body || b == body) && (contacts.flags[row] & ContactTable.TOUCHING) != 0) {
        touch(a == body ? b : a);
      }
    }
    wakeTouched();
  }

  /** Wakes the bodies of a joint. */
  public void wakeEnds(int joint) {
    if (joints.bodyA[joint] >= 0) {
      wake(joints.bodyA[joint]);
    }
    wake(joints.bodyB[joint]);
  }

  /** Wakes what a moving kinematic body holds by joints, or may hit in a step of dt seconds. */
  public void wakeDriven(int body, float dt) {
    if (!drives(body)) {
      return;
    }
    staticReach.listBullets(body, dt, touched);
    restTime.noteDriven(body);
    wakeTouched();
    for (int end = joints.firstEnd(body); end >= 0; end = joints.nextEnd(end)) {
      int other = joints.other(end);
      if (other >= 0) {
        wakeIsland(other);
      }
    }
  }

  /** Queues a body to be woken by {@link #wakeTouched}; it may be awake already. */
  public void touch(int body) {
    if (bodies.asleep(body)) {
      touched.add(body);
    }
  }

  /** Returns whether bodies are queued to be woken. */
  public boolean anyTouched() {
    return touched.count > 0;
  }

  /** Wakes the queued bodies. */
  public void wakeTouched() {
    if (touched.count == 0) {
      return;
    }
    beginWaking();
    for (int i = 0; i < touched.count; i++) {
      if (suspended) {
        requests.add(touched.values[i], SleepRequests.WAKE);
      } else {
        rouseIsland(touched.values[i]);
      }
    }
    endWaking();
    touched.count = 0;
    mergeWoken();
  }

  /**
   * Wakes the bodies that sleep within reach of a static or kinematic body, which a still one
   * wouldn't wake by touching them.
   */
  public void wakeOverlapped(int body) {
    if (asleepCount == 0 || bodies.type[body] == BodyStore.DYNAMIC) {
      return;
    }
    staticReach.listSleepers(body, touched);
    wakeTouched();
  }

  /** Wakes a sleeping body and all that is tied to it by contacts and joints. */
  private void wakeIsland(int body) {
    beginWaking();
    rouseIsland(body);
    endWaking();
  }

  /** Begins to rouse islands. Trees and joints follow at the end. */
  private void beginWaking() {
    gathered.count = 0;
  }

  private void rouseIsland(int body) {
    if (!bodies.asleep(body)) {
      return;
    }
    if (gathered.count == 0) {
      pairs.insertPending();
    }
    int first = gathered.count;
    rouse(body);
    for (int i = first; i < gathered.count; i++) {
      int at = gathered.values[i];
      boolean ties = bodies.type[at] == BodyStore.DYNAMIC;
      for (int end = sleepers.first(at); end >= 0; end = sleepers.first(at)) {
        int other = sleepers.other(end);
        if (ties && sleepers.solid(end)) {
          rouseDynamic(other);
        }
        sleepers.unlink(end >> 1);
        wokenRows.add(end >> 1);
      }
      for (int end = joints.firstEnd(at); ties && end >= 0; end = joints.nextEnd(end)) {
        int other = joints.other(end);
        if (other >= 0) {
          rouseDynamic(other);
        }
      }
    }
  }

  /** Takes the roused bodies to the moving tree, all at once. */
  private void endWaking() {
    if (gathered.count > 0) {
      pairs.wake(gathered.values, gathered.count);
    }
    for (int i = 0; i < gathered.count; i++) {
      jointActivity.refreshBody(gathered.values[i]);
    }
    gathered.count = 0;
  }

  private void rouseDynamic(int body) {
    if (bodies.type[body] == BodyStore.DYNAMIC && bodies.asleep(body)) {
      rouse(body);
    }
  }

  private void rouse(int body) {
    gathered.add(body);
    bodies.flags[body] &= ~BodyStore.ASLEEP;
    restTime.wake(body);
    asleepCount--;
    stamp.change();
    active.add(body);
  }

  /** Makes room for so many contacts of bodies that wake at once. Between two merges. */
  public void reserve(int rows) {
    wokenRows.ensureRoom(rows);
    sorter.ensureRoom(wokenRows.values.length);
  }

  /** Brings the contacts of bodies that woke back to the table. */
  public void mergeWoken() {
    if (wokenRows.count == 0) {
      return;
    }
    sorter.sort(wokenRows.values, wokenRows.count, sleepers.rows.key);
    contacts.order().insert(sleepers.rows, wokenRows.values, wokenRows.count);
    for (int i = 0; i < wokenRows.count; i++) {
      sleepers.release(wokenRows.values[i]);
    }
    wokenRows.count = 0;
  }

  // ---------------------------------------------------------------- falling asleep

  /** Measures how long bodies have been slow, and puts islands to sleep. */
  public void rest(float dt) {
    islands.reserve(gathered);
    boolean any = false;
    for (int i = 0; i < active.count; i++) {
      any |= restTime.add(active.list[i], dt);
    }
    if (!any) {
      return;
    }
    mergeWoken();
    islands.find();
    for (int i = 0; i < active.count; i++) {
      if (bodies.sleepTime[active.list[i]] < settings.sleepDelay()
          || bodies.pushed(active.list[i])) {
        islands.keepAwake(i);
      }
    }
    gathered.count = 0;
    for (int i = 0; i < active.count; i++) {
      if (!islands.keptAwake(i)) {
        gathered.add(active.list[i]);
      }
    }
    putToSleep();
  }

  /** Puts a body's island to sleep, unless one of its bodies may not or is losing its hold. */
  public void sleep(int body) {
    if (suspended) {
      requests.add(body, SleepRequests.SLEEP);
    } else if (active.contains(body) && settings.sleeping()) {
      mergeWoken();
      islands.find();
      int island = islands.islandOf(body);
      gathered.count = 0;
      for (int i = 0; i < active.count; i++) {
        if (islands.island(i) == island) {
          if ((bodies.flags[active.list[i]] & BodyStore.SLEEPLESS) != 0) {
            return;
          }
          gathered.add(active.list[i]);
        }
      }
      if (!islands.losesHold(island)) {
        putToSleep();
      }
    }
  }

  /** Puts bodies to sleep, which must be whole islands, except those that sleep already. */
  public void putToSleep(IntList which) {
    gathered.count = 0;
    for (int i = 0; i < which.count; i++) {
      if (active.contains(which.values[i])) {
        gathered.add(which.values[i]);
      }
    }
    putToSleep();
  }

  /** Puts the gathered bodies to sleep. */
  private void putToSleep() {
    if (gathered.count == 0) {
      return;
    }
    pairs.insertPending();
    for (int i = 0; i < gathered.count; i++) {
      int body = gathered.values[i];
      active.remove(body);
      bodies.flags[body] |= BodyStore.ASLEEP;
      bodies.sleepTime[body] = settings.sleepDelay();
      bodies.vx[body] = 0;
      bodies.vy[body] = 0;
      bodies.w[body] = 0;
      bodies.clearForces(body);
      asleepCount++;
    }
    pairs.rest(gathered.values, gathered.count);
    stamp.change();
    for (int i = 0; i < gathered.count; i++) {
      jointActivity.refreshBody(gathered.values[i]);
    }
    contacts.order().retire(bodies, sleepers);
  }

  // ---------------------------------------------------------------- saved states

  /** Returns the stamp that changes whenever a body falls asleep or wakes. */
  public Stamp stamp() {
    return stamp;
  }

  /** Forgets all that is queued, for a state that is restored. */
  public void reset() {
    wokenRows.count = 0;
    touched.count = 0;
    requests.clear();
    suspended = false;
    restTime.reset();
  }

  /** Notes that all bodies were removed at once. */
  public void clear() {
    asleepCount = 0;
  }

  /**
   * Lists the bodies that a restore takes to another tree, or to another place of the resting one.
   *
   * @param then the bodies of the state that is restored
   * @param thenSleep its stamp of who sleeps
   * @param staticMoved whether a static body may have been moved since
   * @return the list, valid until bodies wake or fall asleep
   */
  public IntList listMisplaced(BodyStore then, Stamp thenSleep, boolean staticMoved) {
    gathered.count = 0;
    if (staticMoved || !stamp.same(thenSleep)) {
      for (int body = 0; body < bodies.slots(); body++) {
        if (bodies.type[body] != BodyStore.FREE
            && !bodies.disabled(body)
            && isMisplaced(body, then)) {
          gathered.add(body);
        }
      }
    }
    return gathered;
  }

  private boolean isMisplaced(int body, BodyStore then) {
    boolean willRest = bodies.type[body] == BodyStore.STATIC || then.asleep(body);
    return active.contains(body) == willRest || (willRest && !bodies.samePose(then, body));
  }

  /** Takes over the sleeping contacts of a state, after its bodies, contacts and joints. */
  public void take(SleepingContacts thenSleepers, Stamp thenSleep) {
    if (!stamp.same(thenSleep)) {
      thenSleepers.copyTo(sleepers);
      thenSleep.copyTo(stamp);
    }
    joints.clearAwake();
    for (int j = 0; j < joints.slots(); j++) {
      if (joints.type[j] != JointStore.FREE) {
        jointActivity.refresh(j);
      }
    }
  }
}
