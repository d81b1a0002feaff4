package carom.physics.dynamics.sleep;

import carom.physics.broadphase.IntVisitor;
import carom.physics.dynamics.Dynamics;
import carom.physics.dynamics.body.ActiveBodies;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.body.Settings;
import carom.physics.dynamics.body.ShapeTable;
import carom.physics.dynamics.contact.ContactTable;
import carom.physics.dynamics.contact.SleepingContacts;
import carom.physics.dynamics.joint.JointStore;
import carom.physics.dynamics.pairs.PairFinder;
import carom.physics.dynamics.store.KeySorter;
import carom.physics.dynamics.store.Stamp;
import carom.physics.math.Aabb;
import java.util.Arrays;

/**
 * Who sleeps: decides which bodies fall asleep and wakes them, with all that belongs to them.
 *
 * <p>A step looks at the {@linkplain ActiveBodies active bodies} alone: the parts of all others are
 * in a tree of their own, contacts between them in {@link SleepingContacts}, their joints are
 * passed over. An island (dynamic bodies that hold each other by touching contacts or joints) falls
 * asleep when all its bodies have been slow for long enough and nothing keeps it awake: a pending
 * force, a moving kinematic body, a running belt or motor, a body that may not sleep. Kinematic
 * bodies at rest fall asleep alone. A body wakes with its whole island: when something awake begins
 * to touch it or no longer does, when its velocity, forces, pose or joints change, and when what it
 * touches, static bodies too, is moved, changed or taken away. Islands are found anew each time,
 * from contacts and joints; nothing is kept.
 *
 * <p>The contacts of a body that wakes are in no table until {@link #mergeWoken}.
 */
public final class Sleeping {
  private static final int FIRST_CAPACITY = 64;

  /** Sleep time of a kinematic body that was set somewhere else since the last step. */
  private static final float MOVED = -1;

  private static final int ASK_WAKE = 0;
  private static final int ASK_DISTURB = 1;
  private static final int ASK_SLEEP = 2;
  private static final int ASKED = 3;

  private final Settings settings;
  private final BodyStore bodies;
  private final ActiveBodies active;
  private final ShapeTable parts;
  private final ContactTable contacts;
  private final SleepingContacts sleepers;
  private final JointStore joints;
  private final PairFinder pairs;
  private final Islands islands = new Islands();
  private final KeySorter sorter = new KeySorter();
  private int asleepCount;

  /** Changes whenever a body falls asleep or wakes. */
  private final Stamp stamp = new Stamp();

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
  private boolean suspended;

  /** Whether a kinematic body was set somewhere else since the last step. */
  private boolean anyMoved;

  // The search for what sleeps in the reach of a part of a static body.
  private int searchPart;
  private final Aabb around = new Aabb();
  private final Aabb box = new Aabb();
  private final IntVisitor onOverlapped = this::overlapped;

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
    this.parts = parts;
    this.contacts = contacts;
    this.sleepers = sleepers;
    this.joints = joints;
    this.pairs = pairs;
  }

  // ---------------------------------------------------------------- who takes part

  /** Counts a body in: as active, unless it is static or sleeps. */
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

  /** Counts a body out. */
  public void leave(int body) {
    if (active.contains(body)) {
      active.remove(body);
    } else if (bodies.type[body] != BodyStore.STATIC) {
      asleepCount--;
      stamp.change();
    }
  }

  /** Whether any body but static ones sleeps. */
  public boolean anyAsleep() {
    return asleepCount > 0;
  }

  /** Whether a body is dynamic and asleep. */
  public boolean sleepsDynamic(int body) {
    return bodies.type[body] == BodyStore.DYNAMIC && bodies.asleep(body);
  }

  /** Whether an active body pushes what it touches: a kinematic one only while it moves. */
  public boolean drives(int body) {
    return active.contains(body)
        && (bodies.type[body] == BodyStore.DYNAMIC
            || bodies.vx[body] != 0
            || bodies.vy[body] != 0
            || bodies.w[body] != 0
            || bodies.sleepTime[body] == MOVED);
  }

  /** Must be called when a body that isn't static was put elsewhere by hand, and woken. */
  public void moved(int body) {
    if (bodies.type[body] == BodyStore.KINEMATIC && settings.sleeping()) {
      bodies.sleepTime[body] = MOVED;
    }
  }

  /** Forgets who was put elsewhere. */
  public void forgetMoves() {
    if (!anyMoved) {
      return;
    }
    anyMoved = false;
    for (int i = 0; i < active.count; i++) {
      int body = active.list[i];
      if (bodies.sleepTime[body] == MOVED) {
        bodies.sleepTime[body] = 0;
      }
    }
  }

  // ---------------------------------------------------------------- callbacks

  /** From now on bodies neither wake nor fall asleep; what is asked for is kept. */
  public void suspend() {
    suspended = true;
  }

  /** Bodies may wake and fall asleep again; {@link #doAsked} sees to those of the meantime. */
  public void resume() {
    suspended = false;
  }

  private void ask(int body, int what) {
    if (askedCount == asked.length) {
      asked = Arrays.copyOf(asked, askedCount * 2);
    }
    asked[askedCount++] = (long) body * ASKED + what;
  }

  /** Does what was asked for in callbacks. */
  public void doAsked() {
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

  // ---------------------------------------------------------------- waking

  /** See {@link Dynamics#wake}. */
  public void wake(int body) {
    if (!bodies.asleep(body)) {
      bodies.sleepTime[body] = Math.min(bodies.sleepTime[body], 0);
    } else if (suspended) {
      ask(body, ASK_WAKE);
    } else {
      wakeIsland(body);
    }
  }

  /** See {@link Dynamics#disturb}. */
  public void disturb(int body) {
    if (suspended) {
      ask(body, ASK_DISTURB);
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

  /** See {@link Dynamics#wakeEnds}. */
  public void wakeEnds(int joint) {
    if (joints.bodyA[joint] >= 0) {
      wake(joints.bodyA[joint]);
    }
    wake(joints.bodyB[joint]);
  }

  /** Wakes what a kinematic body holds by joints, if it moves. */
  public void wakeJointed(int body) {
    if (!drives(body)) {
      return;
    }
    anyMoved |= bodies.sleepTime[body] == MOVED;
    for (int end = joints.firstEnd(body); end >= 0; end = joints.nextEnd(end)) {
      int other = joints.other(end);
      if (other >= 0) {
        wakeIsland(other);
      }
    }
  }

  /** Remembers to wake a body, which may be awake already. */
  public void touch(int body) {
    if (!bodies.asleep(body)) {
      return;
    }
    if (touchedCount == touched.length) {
      touched = Arrays.copyOf(touched, touchedCount * 2);
    }
    touched[touchedCount++] = body;
  }

  /** Wakes what was touched; answers whether there was anything. */
  public boolean wakeTouched() {
    if (touchedCount == 0) {
      return false;
    }
    beginWaking();
    for (int i = 0; i < touchedCount; i++) {
      if (suspended) {
        ask(touched[i], ASK_WAKE);
      } else {
        rouseIsland(touched[i]);
      }
    }
    endWaking();
    touchedCount = 0;
    mergeWoken();
    return true;
  }

  /** Wakes what sleeps within reach of a static body. */
  public void wakeOverlapped(int body) {
    if (asleepCount == 0 || bodies.type[body] != BodyStore.STATIC) {
      return;
    }
    pairs.insertPending();
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
    beginWaking();
    rouseIsland(body);
    endWaking();
  }

  /** Any number of islands may be roused from now on; trees and joints follow at the end. */
  private void beginWaking() {
    gatheredCount = 0;
  }

  private void rouseIsland(int body) {
    if (!bodies.asleep(body)) {
      return;
    }
    if (gatheredCount == 0) {
      pairs.insertPending();
    }
    int first = gatheredCount;
    rouse(body);
    for (int i = first; i < gatheredCount; i++) {
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
  }

  /** Takes those who were roused to the tree of what moves, all at once. */
  private void endWaking() {
    if (gatheredCount > 0) {
      pairs.wake(gathered, gatheredCount);
    }
    for (int i = 0; i < gatheredCount; i++) {
      refreshJoints(gathered[i]);
    }
    gatheredCount = 0;
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
    stamp.change();
    active.add(body);
  }

  private void gather(int body) {
    if (gatheredCount == gathered.length) {
      gathered = Arrays.copyOf(gathered, gatheredCount * 2);
    }
    gathered[gatheredCount++] = body;
  }

  /** Brings the contacts of bodies that woke back to the table. */
  public void mergeWoken() {
    if (wokenCount == 0) {
      return;
    }
    sorter.sort(wokenRows, wokenCount, sleepers.rows.key);
    contacts.order().insert(sleepers.rows, wokenRows, wokenCount);
    for (int i = 0; i < wokenCount; i++) {
      sleepers.release(wokenRows[i]);
    }
    wokenCount = 0;
  }

  // ---------------------------------------------------------------- falling asleep

  /** Measures how long bodies have been slow, and puts islands to sleep. */
  public void rest(float dt) {
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

  /** See {@link Dynamics#sleep}. */
  public void sleep(int body) {
    if (suspended) {
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
      if (!losesHold(island)) {
        putToSleep();
      }
    }
  }

  /** Whether a contact of an island is one that the next step ends, as its parts may not touch. */
  private boolean losesHold(int island) {
    for (int row = 0; row < contacts.count(); row++) {
      if ((contacts.flags[row] & ContactTable.TOUCHING) != 0
          && (isOf(contacts.bodyA(row), island) || isOf(contacts.bodyB(row), island))
          && !pairs.mayStay(contacts, row)) {
        return true;
      }
    }
    return false;
  }

  private boolean isOf(int body, int island) {
    return active.contains(body) && islands.find(active.index[body]) == island;
  }

  /** Begins a new list of bodies to be put to sleep by {@link #putToSleep()}. */
  public void gatherNone() {
    gatheredCount = 0;
  }

  /** Adds a body to the list, unless it sleeps already. */
  public void gatherAwake(int body) {
    if (active.contains(body)) {
      gather(body);
    }
  }

  /** Puts the gathered bodies to sleep; they must be whole islands. */
  public void putToSleep() {
    if (gatheredCount == 0) {
      return;
    }
    pairs.insertPending();
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
    stamp.change();
    for (int i = 0; i < gatheredCount; i++) {
      refreshJoints(gathered[i]);
    }
    contacts.order().retire(bodies, sleepers);
  }

  /** Finds out which awake bodies hold each other, and what keeps them awake. */
  private void findIslands() {
    islands.reset(active.count);
    for (int row = 0; row < contacts.count(); row++) {
      if (contacts.points[row] > 0 && (contacts.flags[row] & ContactTable.VETOED) == 0) {
        tie(contacts.bodyA(row), contacts.bodyB(row), contacts.surface(row) != 0);
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

  // ---------------------------------------------------------------- joints

  /** Decides which joints the solver looks at, after a body came, went, woke or fell asleep. */
  public void refreshJoints(int body) {
    for (int end = joints.firstEnd(body); end >= 0; end = joints.nextEnd(end)) {
      refreshJoint(end >> 1);
    }
  }

  /** A joint is awake if a body of it is, and none sleeps that it could move. */
  public void refreshJoint(int joint) {
    int a = joints.bodyA[joint];
    int b = joints.bodyB[joint];
    boolean awake = active.contains(b) || (a >= 0 && active.contains(a));
    boolean waits = sleepsDynamic(b) || (a >= 0 && sleepsDynamic(a));
    joints.setAwake(joint, awake && !waits);
    if (!awake && !waits) {
      joints.forget(joint);
    }
  }

  // ---------------------------------------------------------------- saved states

  /** Changes whenever a body falls asleep or wakes. */
  public Stamp stamp() {
    return stamp;
  }

  /** Forgets all that waits to be done. */
  public void reset() {
    wokenCount = 0;
    touchedCount = 0;
    askedCount = 0;
    suspended = false;
    anyMoved = false;
  }

  /** Must be called when all bodies are taken out at once. */
  public void clear() {
    asleepCount = 0;
  }

  /**
   * Finds the bodies that are in the wrong tree, or in the wrong place of the tree that rests.
   *
   * @param then the bodies of the state that is restored
   * @param thenSleep its stamp of who sleeps
   * @param staticMoved whether a static body may have been moved since
   * @return how many {@link #gathered} there are
   */
  public int gatherMisplaced(BodyStore then, Stamp thenSleep, boolean staticMoved) {
    gatheredCount = 0;
    if (!staticMoved && stamp.same(thenSleep)) {
      return 0;
    }
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
    return gatheredCount;
  }

  private boolean samePlace(BodyStore then, int body) {
    return bodies.x[body] == then.x[body]
        && bodies.y[body] == then.y[body]
        && bodies.cos[body] == then.cos[body]
        && bodies.sin[body] == then.sin[body];
  }

  /** One of the bodies gathered last. */
  public int gathered(int i) {
    return gathered[i];
  }

  /** Takes over what sleeps, once bodies, contacts and joints are those of the state. */
  public void take(SleepingContacts thenSleepers, Stamp thenSleep) {
    if (!stamp.same(thenSleep)) {
      thenSleepers.copyTo(sleepers);
      thenSleep.copyTo(stamp);
    }
    joints.clearAwake();
    for (int j = 0; j < joints.slots(); j++) {
      if (joints.type[j] != JointStore.FREE) {
        refreshJoint(j);
      }
    }
  }
}
