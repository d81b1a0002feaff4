package carom.physics.dynamics;

import carom.physics.broadphase.AabbArray;
import carom.physics.broadphase.CastVisitor;
import carom.physics.broadphase.CellVisitor;
import carom.physics.broadphase.IntVisitor;
import carom.physics.broadphase.KdTree;
import carom.physics.broadphase.PairVisitor;
import carom.physics.collision.Collider;
import carom.physics.collision.Manifold;
import carom.physics.geometry.Convex;
import carom.physics.geometry.MassData;
import carom.physics.math.Aabb;
import carom.physics.math.Transform;
import java.util.Arrays;

/**
 * Bodies, their shapes and contacts, and the step that moves them; the engine behind {@code
 * carom.physics.World}.
 *
 * <p><b>A step</b>: refresh fat boxes; search pairs if a box changed; one manifold per pair; tell
 * the owner (end, begin, pre-solve); then {@code substeps} times: integrate velocities, warm start,
 * solve with bias, integrate positions, relax (joints before contacts); bounce; write back; stop
 * fast bodies at what they passed through (see {@link ContinuousCollision}); tell the owner
 * (post-solve and hit, broken joints); carry out what was deferred.
 *
 * <p><b>Order.</b> Contacts are always visited by ascending {@link ContactKey}, joints by ascending
 * slot; the solver's colours follow from that order. Everything else in a step is independent per
 * body. So the result depends on the state alone, never on the shape of a tree or on when a pair
 * was found.
 *
 * <p>One thread at a time. A steady step allocates nothing.
 */
public final class Dynamics {
  private static final int FIRST_CAPACITY = 64;
  private static final MassData NO_MASS = new MassData(0, 0, 0, 0);

  private final Settings settings;
  private final BodyStore bodies = new BodyStore();
  private final ShapeTable parts = new ShapeTable();
  private final ContactTable contacts = new ContactTable();
  private final JointStore joints = new JointStore();
  private final SolverBodies solverBodies = new SolverBodies();
  private final ContactSolver solver = new ContactSolver(ContactLanes.find());
  private final JointSolver jointSolver = new JointSolver();
  private final ContinuousCollision continuous;
  private final Collider collider = new Collider();
  private final Manifold manifold = new Manifold();
  private final Transform poseA = new Transform();
  private final Transform poseB = new Transform();
  private final Aabb box = new Aabb();

  private final KdTree moving = new KdTree(parts.fat);
  private final KdTree fixed = new KdTree(parts.fat);
  private boolean movingStale;
  private boolean fixedStale;

  /** Whether a static body was ever moved by hand. */
  private boolean fixedMoved;

  /** Whether all pairs must be searched, for instance because a static body is new. */
  private boolean searchAll;

  /** Whether it must be decided anew which pairs may touch. */
  private boolean rulesStale;

  /** Whether any joint ever could break. */
  private boolean breakable;

  /** Whether poses changed since fat boxes were refreshed. */
  private boolean boxesStale;

  private float lastStep = 1 / 60f;

  /** Moving bodies in no particular order, and where each is (-1 if static or free). */
  private int[] active = new int[FIRST_CAPACITY];

  private int[] activeIndex = new int[FIRST_CAPACITY];
  private int activeCount;

  private int[] movedParts = new int[FIRST_CAPACITY];
  private int movedCount;

  private final KeySorter sorter = new KeySorter();
  private long[] candidates = new long[FIRST_CAPACITY];
  private int candidateCount;
  private int searchPart;

  private final PairVisitor onPair = this::candidate;
  private final IntVisitor onFound =
      found -> {
        candidate(searchPart, found);
        return true;
      };

  private int touching;

  /** Per row: approach speed if this may be an impact worth telling, else 0. */
  private float[] hitSpeeds = new float[0];

  /**
   * Makes an empty world.
   *
   * @param settings its constants
   */
  public Dynamics(Settings settings) {
    this.settings = settings;
    continuous = new ContinuousCollision(this, settings, bodies, parts, contacts);
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
   * Makes a body at the origin.
   *
   * @param type one of {@link BodyStore}'s types
   * @param shapes what it consists of
   * @param fixedRotation whether only {@code setAngularVelocity} turns it
   * @return the slot
   */
  public int create(byte type, ShapeSpec[] shapes, boolean fixedRotation) {
    int count = 0;
    for (ShapeSpec spec : shapes) {
      count += spec.shape().parts().size();
    }
    if (count > ContactKey.MAX_PARTS) {
      throw new IllegalArgumentException(
          "parts="
              + count
              + " is more than the "
              + ContactKey.MAX_PARTS
              + " convex parts one body can have; split it into several bodies");
    }
    MassData total = type == BodyStore.DYNAMIC ? massOf(shapes) : NO_MASS;
    int body = bodies.allocate(type);
    bodies.flags[body] = fixedRotation ? BodyStore.FIXED_ROTATION : 0;
    bodies.firstPart[body] = parts.allocate(body, count);
    bodies.partCount[body] = count;
    fill(body, shapes, total);
    enter(body);
    return body;
  }

  /** Takes mass and shapes over. */
  private void fill(int body, ShapeSpec[] shapes, MassData total) {
    boolean dynamic = bodies.type[body] == BodyStore.DYNAMIC;
    boolean turns = dynamic && (bodies.flags[body] & BodyStore.FIXED_ROTATION) == 0;
    turns = turns && total.inertia() > 0;
    bodies.mass[body] = total.mass();
    bodies.invMass[body] = dynamic ? 1 / total.mass() : 0;
    bodies.coldChanged();
    bodies.inertia[body] = turns ? total.inertia() : 0;
    bodies.invInertia[body] = turns ? 1 / total.inertia() : 0;
    bodies.localX[body] = total.centerX();
    bodies.localY[body] = total.centerY();
    int part = bodies.firstPart[body];
    long hash = StateHash.SEED;
    float inner = Float.POSITIVE_INFINITY;
    float reach = 0;
    poseA.setIdentity();
    for (int i = 0; i < shapes.length; i++) {
      ShapeSpec spec = shapes[i];
      for (Convex convex : spec.shape().parts()) {
        Convex local = convex.moved(-bodies.localX[body], -bodies.localY[body]);
        parts.set(part, local, i, spec);
        hash = StateHash.mix(hash, spec.friction(), spec.restitution());
        hash = spec.mix(hash, dynamic);
        hash = ShapeHash.mix(hash, local);
        local.aabb(poseA, box);
        if (!spec.sensor()) {
          inner = Math.min(inner, local.innerRadius());
        }
        float furthestX = Math.max(-box.minX, box.maxX);
        float furthestY = Math.max(-box.minY, box.maxY);
        float square = furthestX * furthestX + furthestY * furthestY;
        reach = Math.max(reach, (float) Math.sqrt(square));
        part++;
      }
    }
    bodies.reach[body] = reach;
    bodies.shapeHash[body] = hash;
    bodies.innerRadius[body] = inner;
  }

  /**
   * Checks that a dynamic body could be made of some shapes.
   *
   * @param shapes what it would consist of
   * @throws IllegalArgumentException if they have no mass, or too much
   */
  public static void checkMass(ShapeSpec[] shapes) {
    massOf(shapes);
  }

  /**
   * Makes a body static, kinematic or dynamic. Its origin, and the velocity there, stay, except
   * that a static body is at rest.
   *
   * @param body the slot
   * @param type one of {@link BodyStore}'s types
   * @param shapes what it consists of, as when it was made
   */
  public void setType(int body, byte type, ShapeSpec[] shapes) {
    if (bodies.type[body] == type) {
      return;
    }
    MassData total = type == BodyStore.DYNAMIC ? massOf(shapes) : NO_MASS;
    boolean enabled = !bodies.disabled(body);
    if (enabled) {
      leave(body);
    }
    float oldX = bodies.x[body];
    float oldY = bodies.y[body];
    float originX = bodies.originX(body);
    float originY = bodies.originY(body);
    bodies.type[body] = type;
    fill(body, shapes, total);
    bodies.setOriginPose(body, originX, originY, bodies.cos[body], bodies.sin[body]);
    if (type == BodyStore.STATIC) {
      bodies.vx[body] = 0;
      bodies.vy[body] = 0;
      bodies.w[body] = 0;
    } else {
      bodies.vx[body] -= bodies.w[body] * (bodies.y[body] - oldY);
      bodies.vy[body] += bodies.w[body] * (bodies.x[body] - oldX);
    }
    bodies.clearForces(body);
    if (enabled) {
      enter(body);
    }
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
    bodies.flags[body] ^= BodyStore.DISABLED;
    bodies.clearForces(body);
    if (enabled) {
      enter(body);
    } else {
      leave(body);
    }
    rulesStale = true;
  }

  private static MassData massOf(ShapeSpec[] shapes) {
    if (shapes.length == 0) {
      return new MassData(1, 0, 0, 0);
    }
    double mass = 0;
    double mx = 0;
    double my = 0;
    for (ShapeSpec spec : shapes) {
      Checks.refuseLines(spec.shape());
      MassData m = spec.shape().mass(spec.density());
      mass += m.mass();
      mx += (double) m.mass() * m.centerX();
      my += (double) m.mass() * m.centerY();
    }
    Checks.range("mass", (float) mass, 1e-9f, 1e15f);
    float x = (float) (mx / mass);
    float y = (float) (my / mass);
    double inertia = 0;
    for (ShapeSpec spec : shapes) {
      MassData m = spec.shape().mass(spec.density());
      double dx = m.centerX() - x;
      double dy = m.centerY() - y;
      inertia += m.inertia() + m.mass() * (dx * dx + dy * dy);
    }
    return new MassData((float) mass, x, y, (float) inertia);
  }

  /** Makes the broadphase and the solver know a body. */
  private void enter(int body) {
    int first = bodies.firstPart[body];
    if (activeIndex.length <= body) {
      activeIndex = Arrays.copyOf(activeIndex, Math.max(body + 1, activeIndex.length * 2));
    }
    activeIndex[body] = -1;
    boolean isFixed = bodies.type[body] == BodyStore.STATIC;
    if (!isFixed) {
      if (activeCount == active.length) {
        active = Arrays.copyOf(active, activeCount * 2);
      }
      active[activeCount] = body;
      activeIndex[body] = activeCount++;
    }
    for (int part = first; part < first + bodies.partCount[body]; part++) {
      if (isFixed) {
        fixedBox(body, part);
        fixed.add(part);
      } else {
        parts.fat.set(part, bodies.x[body], bodies.y[body], bodies.x[body], bodies.y[body]);
        moving.add(part);
      }
    }
    searchAll |= isFixed;
    boxesStale = true;
  }

  /** Takes a body out again; its contacts must be gone. */
  private void leave(int body) {
    int at = activeIndex[body];
    if (at >= 0) {
      int last = active[--activeCount];
      active[at] = last;
      activeIndex[last] = at;
      activeIndex[body] = -1;
    }
    int first = bodies.firstPart[body];
    KdTree tree = bodies.type[body] == BodyStore.STATIC ? fixed : moving;
    for (int part = first; part < first + bodies.partCount[body]; part++) {
      tree.remove(part);
    }
  }

  /**
   * Removes a body; its touching contacts end first.
   *
   * @param body the slot
   * @param events is told, null for nobody
   */
  public void destroy(int body, ContactEvents events) {
    if (events != null) {
      for (int row = 0; row < contacts.count(); row++) {
        if (touches(row)
            && (ContactKey.bodyA(contacts.key[row]) == body
                || ContactKey.bodyB(contacts.key[row]) == body)) {
          events.end(row);
        }
      }
    }
    contacts.removeBody(body);
    if (!bodies.disabled(body)) {
      leave(body);
    }
    parts.release(bodies.firstPart[body], bodies.partCount[body]);
    bodies.release(body);
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
    return joints.allocate(type, bodyA, bodyB);
  }

  /**
   * Removes a joint.
   *
   * @param joint a slot in use
   */
  public void destroyJoint(int joint) {
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
    searchAll = true;
    for (int row = 0; row < contacts.count(); row++) {
      int p = contacts.partA[row];
      int q = contacts.partB[row];
      boolean gone = bodies.disabled(parts.body[p]) || bodies.disabled(parts.body[q]);
      contacts.ignore(row, gone || !mayTouch(p, q));
    }
  }

  /** Whether filters, joints and types let two parts touch. */
  boolean mayTouch(int p, int q) {
    int a = parts.body[p];
    int b = parts.body[q];
    return (bodies.invMass[a] != 0 || bodies.invMass[b] != 0)
        && parts.meet(p, q)
        && (joints.count() == 0 || !joints.keepsApart(a, b));
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
      int first = bodies.firstPart[body];
      for (int part = first; part < first + bodies.partCount[body]; part++) {
        fixedBox(body, part);
      }
      fixedStale = true;
      fixedMoved = true;
      searchAll = true;
    } else {
      boxesStale = true;
    }
  }

  /**
   * Must be called when a body gets a velocity, a force, or other numbers that decide how it moves:
   * wakes it and all that it holds or leans on.
   *
   * @param body the slot
   */
  public void wake(int body) {
    bodies.sleepTime[body] = 0;
  }

  /**
   * Must be called when what a body touches may lose its hold: before it is taken away, and when
   * its shapes, mass, filters or joints change. Wakes it and all that touches it, static or not.
   *
   * @param body the slot
   */
  public void disturb(int body) {
    wake(body);
  }

  private void fixedBox(int body, int part) {
    place(body, poseA);
    parts.convex[part].aabb(poseA, box);
    float margin = 0.5f * settings.speculativeDistance();
    parts.fat.set(part, box.minX - margin, box.minY - margin, box.maxX + margin, box.maxY + margin);
  }

  private void place(int body, Transform pose) {
    pose.set(bodies.x[body], bodies.y[body], bodies.cos[body], bodies.sin[body]);
  }

  /**
   * Advances the world.
   *
   * @param dt s, checked by the caller
   * @param events is told what happens, null for nobody
   * @param jointEvents is told what breaks
   */
  public void step(float dt, ContactEvents events, JointEvents jointEvents) {
    lastStep = dt;
    for (int i = 0; i < activeCount; i++) {
      if (bodies.type[active[i]] == BodyStore.DYNAMIC) {
        bodies.applyImpulses(active[i]);
      }
    }
    boxesStale = true;
    refilter();
    refreshBoxes();
    findPairs();
    collide();
    if (events != null) {
      announce(events);
      measureHits();
    }
    solve(dt);
    boxesStale = true;
    stopFast();
    if (events != null) {
      for (int row = 0; row < contacts.count(); row++) {
        if (contacts.points[row] > 0 && (contacts.flags[row] & ContactTable.VETOED) == 0) {
          events.postSolve(row);
          if (hitSpeeds[row] > 0 && contacts.pushed(row)) {
            events.hit(row, hitSpeeds[row]);
          }
        }
      }
    }
    if (breakable) {
      breakJoints(jointEvents);
    }
  }

  private void breakJoints(JointEvents events) {
    for (int j = 0; j < joints.slots(); j++) {
      if (joints.type[j] == JointStore.FREE) {
        continue;
      }
      float x = joints.forceX[j];
      float y = joints.forceY[j];
      float most = joints.breakForce[j];
      if (x * x + y * y > most * most || Math.abs(joints.torque[j]) > joints.breakTorque[j]) {
        events.broke(j);
      }
    }
  }

  /** Gives every moving part whose fat box no longer contains it a new one. */
  private void refreshBoxes() {
    if (!boxesStale) {
      return;
    }
    boxesStale = false;
    float reach = 0.5f * settings.speculativeDistance();
    float margin = settings.aabbMargin();
    for (int i = 0; i < activeCount; i++) {
      int body = active[i];
      place(body, poseA);
      int first = bodies.firstPart[body];
      int end = first + bodies.partCount[body];
      for (int part = first; part < end; part++) {
        parts.convex[part].aabb(poseA, box);
        float minX = box.minX - reach;
        float minY = box.minY - reach;
        float maxX = box.maxX + reach;
        float maxY = box.maxY + reach;
        if (parts.fat.contains(part, minX, minY, maxX, maxY)) {
          continue;
        }
        float aheadX = 2 * lastStep * bodies.vx[body];
        float aheadY = 2 * lastStep * bodies.vy[body];
        parts.fat.set(
            part,
            minX - margin + Math.min(aheadX, 0),
            minY - margin + Math.min(aheadY, 0),
            maxX + margin + Math.max(aheadX, 0),
            maxY + margin + Math.max(aheadY, 0));
        boxChanged(part);
      }
    }
  }

  private void boxChanged(int part) {
    movingStale = true;
    if (!parts.moved[part]) {
      parts.moved[part] = true;
      if (movedCount == movedParts.length) {
        movedParts = Arrays.copyOf(movedParts, movedCount * 2);
      }
      movedParts[movedCount++] = part;
    }
  }

  /** Makes the fat box of a moving part contain another box, too. */
  void cover(int part, Aabb other) {
    AabbArray fat = parts.fat;
    if (!fat.contains(part, other.minX, other.minY, other.maxX, other.maxY)) {
      fat.set(
          part,
          Math.min(fat.minX[part], other.minX),
          Math.min(fat.minY[part], other.minY),
          Math.max(fat.maxX[part], other.maxX),
          Math.max(fat.maxY[part], other.maxY));
      boxChanged(part);
    }
  }

  /** The length of the last step, s. */
  float lastStep() {
    return lastStep;
  }

  /** Stops fast bodies at what they would have passed through. */
  private void stopFast() {
    if (!settings.continuous()
        || !continuous.collect(active, activeCount, activeIndex, solverBodies)) {
      return;
    }
    if (continuous.prepare(active, activeCount)) {
      refreshBoxes();
      continuous.widen();
    }
    refreshTrees();
    continuous.settle(moving, fixed);
    boxesStale = true;
  }

  private void refreshTrees() {
    if (movingStale) {
      moving.refit();
      movingStale = false;
    }
    if (fixedStale) {
      fixed.refit();
      fixedStale = false;
    }
  }

  private void findPairs() {
    if (movedCount == 0 && !searchAll) {
      return;
    }
    refreshTrees();
    candidateCount = 0;
    if (searchAll || movedCount * 4 > moving.size()) {
      moving.pairs(onPair);
      moving.join(fixed, onPair);
    } else {
      for (int i = 0; i < movedCount; i++) {
        int part = movedParts[i];
        if (parts.body[part] < 0 || bodies.disabled(parts.body[part])) {
          continue;
        }
        searchPart = part;
        float minX = parts.fat.minX[part];
        float minY = parts.fat.minY[part];
        float maxX = parts.fat.maxX[part];
        float maxY = parts.fat.maxY[part];
        moving.query(minX, minY, maxX, maxY, onFound);
        fixed.query(minX, minY, maxX, maxY, onFound);
      }
    }
    for (int i = 0; i < movedCount; i++) {
      parts.moved[movedParts[i]] = false;
    }
    movedCount = 0;
    searchAll = false;
    candidates = sorter.sort(candidates, candidateCount);
    contacts.merge(candidates, candidateCount, bodies, parts);
  }

  private void candidate(int p, int q) {
    int a = parts.body[p];
    int b = parts.body[q];
    if (a == b || !mayTouch(p, q)) {
      return;
    }
    if (a > b) {
      int swap = a;
      a = b;
      b = swap;
      swap = p;
      p = q;
      q = swap;
    }
    if (candidateCount == candidates.length) {
      candidates = Arrays.copyOf(candidates, candidateCount * 2);
    }
    candidates[candidateCount++] =
        ContactKey.of(a, p - bodies.firstPart[a], b, q - bodies.firstPart[b]);
  }

  private void collide() {
    touching = 0;
    continuous.begin();
    float distance = settings.speculativeDistance();
    for (int row = 0; row < contacts.count(); row++) {
      int partA = contacts.partA[row];
      int partB = contacts.partB[row];
      place(parts.body[partA], poseA);
      place(parts.body[partB], poseB);
      boolean sensor = contacts.sensor(row);
      float reach = sensor ? 0 : distance;
      if ((contacts.flags[row] & ContactTable.IGNORED) != 0) {
        manifold.count = 0;
      } else {
        collider.collide(parts.convex[partA], poseA, parts.convex[partB], poseB, reach, manifold);
      }
      contacts.update(row, manifold);
      if (manifold.count > 0 && !sensor) {
        touching++;
        float overlap = -manifold.minSeparation();
        if (overlap > settings.slop()) {
          notePressed(parts.body[partA], parts.body[partB], overlap);
        }
      }
    }
  }

  private void notePressed(int a, int b, float overlap) {
    boolean dynamic = bodies.type[a] == BodyStore.DYNAMIC;
    if (dynamic != (bodies.type[b] == BodyStore.DYNAMIC)) {
      continuous.pressed(dynamic ? a : b, overlap);
    }
  }

  private void announce(ContactEvents events) {
    for (int row = 0; row < contacts.count(); row++) {
      byte flags = contacts.flags[row];
      boolean now = (flags & ContactTable.TOUCHING) != 0;
      boolean before = (flags & ContactTable.WAS_TOUCHING) != 0;
      if (before && !now) {
        events.end(row);
      } else if (now) {
        if (!before) {
          events.begin(row);
        }
        if (contacts.points[row] > 0 && !events.preSolve(row)) {
          contacts.flags[row] |= ContactTable.VETOED;
        }
      }
    }
  }

  /** Looks how fast the contacts approach that no impulse held in the step before. */
  private void measureHits() {
    if (hitSpeeds.length < contacts.count()) {
      hitSpeeds = new float[Math.max(contacts.count(), hitSpeeds.length * 2)];
    }
    for (int row = 0; row < contacts.count(); row++) {
      hitSpeeds[row] = 0;
      if (contacts.points[row] > 0 && (contacts.flags[row] & ContactTable.WAS_PUSHED) == 0) {
        float speed = approach(row, contacts.x0[row], contacts.y0[row]);
        if (contacts.points[row] > 1) {
          speed = Math.max(speed, approach(row, contacts.x1[row], contacts.y1[row]));
        }
        hitSpeeds[row] = speed > settings.hitSpeed() ? speed : 0;
      }
    }
  }

  /** How fast the bodies of a row approach at a point relative to A, m/s. */
  private float approach(int row, float ax, float ay) {
    int a = contacts.bodyA(row);
    int b = contacts.bodyB(row);
    float bx = ax - (bodies.x[b] - bodies.x[a]);
    float by = ay - (bodies.y[b] - bodies.y[a]);
    float partX = bodies.vx[b] - bodies.w[b] * by - (bodies.vx[a] - bodies.w[a] * ay);
    float partY = bodies.vy[b] + bodies.w[b] * bx - (bodies.vy[a] + bodies.w[a] * ax);
    return -(partX * contacts.nx[row] + partY * contacts.ny[row]);
  }

  private void solve(float dt) {
    int substeps = settings.substeps();
    float h = dt / substeps;
    solverBodies.load(bodies, active, activeCount, settings, h);
    solver.prepare(contacts, bodies, solverBodies, activeIndex, settings, h);
    float[] state = solverBodies.state;
    int n = solver.blocks();
    jointSolver.prepare(joints, bodies, activeIndex, settings, h, state);
    int m = jointSolver.count();
    for (int i = 0; i < substeps; i++) {
      solverBodies.integrateVelocities(h, settings.maxSpeed(), settings.maxAngularSpeed());
      jointSolver.warmStart(0, m);
      solver.warmStart(state, 0, n);
      jointSolver.solve(0, m, true);
      solver.solve(state, 0, n, true);
      solverBodies.integratePositions(h);
      jointSolver.solve(0, m, false);
      solver.solve(state, 0, n, false);
    }
    solver.restitution(state);
    solver.store(contacts);
    jointSolver.store();
    solverBodies.store(bodies, active);
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
    refreshTrees();
    moving.query(minX, minY, maxX, maxY, visitor);
    fixed.query(minX, minY, maxX, maxY, visitor);
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
    refreshTrees();
    moving.cast(minX, minY, maxX, maxY, dx, dy, 1, visitor);
    fixed.cast(minX, minY, maxX, maxY, dx, dy, 1, visitor);
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
          parts.fat.minX[part], parts.fat.minY[part], parts.fat.maxX[part], parts.fat.maxY[part]);
    } else {
      place(parts.body[part], poseA);
      parts.convex[part].aabb(poseA, out);
    }
  }

  /**
   * Visits the nodes of both trees.
   *
   * @param visitor receives boxes and depths
   */
  public void cells(CellVisitor visitor) {
    refreshBoxes();
    refreshTrees();
    moving.cells(visitor);
    fixed.cells(visitor);
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
   * The contacts.
   *
   * @return the live table
   */
  public ContactTable contacts() {
    return contacts;
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
   * The number of touching contacts in the last step.
   *
   * @return contacts with points
   */
  public int touchingCount() {
    return touching;
  }

  /**
   * The number of bodies that aren't static.
   *
   * @return moving bodies
   */
  public int activeCount() {
    return activeCount;
  }

  /**
   * Hash of everything that influences the future.
   *
   * @return 64 bits
   */
  public long hash() {
    return StateHash.finish(joints.hash(contacts.hash(bodies.hash(StateHash.SEED))));
  }

  /** The state of a world at one moment. */
  public static final class State {
    private final BodyStore bodies = new BodyStore();
    private final ShapeTable parts = new ShapeTable();
    private final ContactTable contacts = new ContactTable();
    private final JointStore joints = new JointStore();
    private long bytes;

    /** Makes an empty state to save into. */
    public State() {}

    /**
     * What the last save copied, apart from shapes, which are copied if bodies came or went.
     *
     * @return bytes of bodies, contacts and joints
     */
    public long bytes() {
      return bytes;
    }
  }

  /**
   * Copies the state out.
   *
   * @param to is overwritten
   * @param sameStructure whether no body came, went or changed since {@code to} was saved
   */
  public void save(State to, boolean sameStructure) {
    to.bytes = bodies.copyTo(to.bodies);
    to.bytes += contacts.copyTo(to.contacts);
    to.bytes += joints.copyTo(to.joints);
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
  public void restore(State from, boolean sameStructure) {
    from.bodies.copyTo(bodies);
    from.contacts.copyTo(contacts);
    from.joints.copyTo(joints);
    rulesStale = true;
    if (sameStructure) {
      restoreFixedBoxes();
    } else {
      from.parts.copyTo(parts);
      movedCount = 0;
      activeCount = 0;
      moving.clear();
      fixed.clear();
      for (int body = 0; body < bodies.slots(); body++) {
        if (bodies.type[body] != BodyStore.FREE && !bodies.disabled(body)) {
          enter(body);
        }
      }
    }
    searchAll = true;
    boxesStale = true;
  }

  /** Static bodies may have been teleported since. */
  private void restoreFixedBoxes() {
    if (!fixedMoved) {
      return;
    }
    for (int body = 0; body < bodies.slots(); body++) {
      if (bodies.type[body] == BodyStore.STATIC) {
        moved(body);
      }
    }
  }
}
