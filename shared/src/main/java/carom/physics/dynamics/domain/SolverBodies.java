package carom.physics.dynamics.domain;

import carom.physics.dynamics.body.ActiveBodies;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.contact.ContactTable;
import carom.physics.dynamics.pairs.PairFinder;
import carom.physics.dynamics.store.ParallelFor;
import carom.physics.math.Limits;
import carom.physics.math.Transform;
import carom.physics.settings.Settings;
import java.util.Arrays;

/**
 * The moving bodies as the solver sees them: velocity, and how far a body has moved and turned
 * since the step began, packed to 32 bytes.
 *
 * <pre>
 *   state   | slot 0: static, zero  | unused | slot s                      | ...
 *                                            | VX VY W  DX DY  COS SIN  -  |   floats
 *                                             velocity  moved  turned
 * </pre>
 *
 * <p>Slot 0 is the one static body of all constraints: without mass and at rest, it absorbs what is
 * added to it (which is zero). Moving bodies follow, see {@link SolverSlots}. Positions are
 * differences, so the solver works with small numbers wherever in the world it is.
 */
public final class SolverBodies {
  /** Floats per slot. */
  public static final int STRIDE = 8;

  /** Velocity, x, m/s. */
  public static final int VX = 0;

  /** Velocity, y, m/s. */
  public static final int VY = 1;

  /** Angular velocity, rad/s. */
  public static final int W = 2;

  /** Distance moved since the step began, x, m. */
  public static final int DX = 3;

  /** Distance moved since the step began, y, m. */
  public static final int DY = 4;

  /** Cosine of the turn since the step began. */
  public static final int COS = 5;

  /** Sine of that turn. */
  public static final int SIN = 6;

  /** Most distance of a body in a substep, m: a net under overflow, far above any sane speed. */
  private static final float MAX_TRANSLATION = 1e6f;

  /** Bodies that were put back since the step began. */
  private int[] putBack = new int[0];

  private int putBackCount;

  /** Most turn of a body in a substep, rad; the series for the rotation is good up to here. */
  public static final float MAX_ROTATION = 2;

  /** Quantities of all slots. */
  public float[] state = new float[0];

  /**
   * Velocities without the changes by contacts in this substep, {@link #VELOCITY} floats per slot.
   * The next substep starts warm with these changes: they are the sum of the contacts' impulses
   * times their lever arms, which stay the same for a whole step. So no contact has to be visited
   * again.
   */
  private float[] withoutContacts = new float[0];

  /** Floats per slot of arrays of velocities. */
  public static final int VELOCITY = 4;

  /** Velocities before joints were solved, in the same places. */
  private float[] beforeJoints = new float[0];

  /** Acceleration by gravity and forces, x, per slot, m/s^2. */
  private float[] ax = new float[0];

  /** Acceleration by gravity and forces, y, per slot, m/s^2. */
  private float[] ay = new float[0];

  /** Angular acceleration by torques, per slot, rad/s^2. */
  private float[] aw = new float[0];

  /** Factor that damping leaves of the velocity, per slot. */
  private float[] linearFactor = new float[0];

  /** Factor that damping leaves of the angular velocity, per slot. */
  private float[] angularFactor = new float[0];

  /** Explicit Euler only: velocities before a substep's acceleration, as in {@link #state}. */
  private float[] before = new float[0];

  /** Explicit Euler only: velocities after a substep's acceleration. */
  private float[] free = new float[0];

  /** Explicit Euler only: velocities after a substep's constraints. */
  private float[] solved = new float[0];

  /** The locked axes of the moving bodies. */
  public final AxisLocks locks = new AxisLocks();

  private boolean explicit;

  private int count;

  /** Bodies that make a piece of work for a worker. */
  private static final int GRAIN = 128;

  private final ParallelFor parallel;
  public final ActiveBodies active;
  public final Domains domains;
  private final SolverSlots slots;

  // What the step is about.
  private BodyStore bodies;
  private Settings settings;
  private float h;

  // The stages, made once so that a step allocates nothing.
  private final DomainPhases.Phase loading =
      (given, d, border, worker) -> load(from(d, border), to(d, border));
  private final DomainPhases.Phase accelerating =
      (warm, d, border, worker) -> accelerate(from(d, border), to(d, border), warm != 0);
  private final DomainPhases.Phase moving =
      (given, d, border, worker) -> move(from(d, border), to(d, border));
  private final DomainPhases.Phase storing =
      (given, d, border, worker) -> store(from(d, border), to(d, border), d % 2 != 0);
  private final ParallelFor.Range remembering = (from, to, worker) -> rememberVelocities(from, to);
  private final ParallelFor.Range addingJointChanges =
      (from, to, worker) -> addJointChanges(from, to);

  /**
   * Makes it empty.
   *
   * @param active the bodies
   * @param pairs tells which bodies are near each other; null where no step is shared
   * @param parallel does the stages that joints need
   */
  public SolverBodies(ActiveBodies active, PairFinder pairs, ParallelFor parallel) {
    this.active = active;
    this.parallel = parallel;
    domains = new Domains(active, pairs);
    slots = new SolverSlots(active, domains);
  }

  /** Returns the slot of a body, 0 if it doesn't move. */
  public int slot(int body) {
    return slots.slotOf[body];
  }

  /** Returns the slot of each body, 0 if it doesn't move. Holds until the next step. */
  public int[] slotOf() {
    return slots.slotOf;
  }

  /** Returns how many slots there are, the static one and unused ones included. */
  public int count() {
    return count;
  }

  /** Returns the offset in {@link #state} of a domain's idle slot, which is zero. */
  public int idle(int domain) {
    return slots.idle(domain) * STRIDE;
  }

  private int from(int domain, boolean border) {
    return slots.from(domain, border);
  }

  private int to(int domain, boolean border) {
    return slots.to(domain, border);
  }

  /** Returns the acceleration of a slot's body along x in this step, m/s^2. */
  public float ax(int slot) {
    return ax[slot];
  }

  /** Returns the acceleration of a slot's body along y in this step, m/s^2. */
  public float ay(int slot) {
    return ay[slot];
  }

  /** Begins a step, and finds its domains. {@code ContactBlocks.build} comes next. */
  public void begin(BodyStore b, Settings s, float substep, ContactTable contacts) {
    putBackCount = 0;
    bodies = b;
    settings = s;
    h = substep;
    explicit = s.explicitEuler();
    domains.find(parallel.isSharing() ? parallel.count() : 1, contacts);
  }

  /** Gives active bodies their slots. Those at the border of a domain must be known by now. */
  public void assignSlots() {
    slots.assign();
    count = slots.count();
    if (ax.length < count) {
      int capacity = slots.capacity();
      state = new float[capacity * STRIDE];
      withoutContacts = new float[capacity * VELOCITY];
      ax = new float[capacity];
      ay = new float[capacity];
      aw = new float[capacity];
      linearFactor = new float[capacity];
      angularFactor = new float[capacity];
    }
    locks.begin(bodies.anyLinearLocks(), count);
    resetSlot(0);
    for (int domain = 0; domain < domains.count(); domain++) {
      resetSlot(slots.idle(domain));
    }
  }

  /** Sets a slot to rest. */
  private void resetSlot(int slot) {
    Arrays.fill(state, slot * STRIDE, (slot + 1) * STRIDE, 0);
    state[slot * STRIDE + COS] = 1;
    ax[slot] = 0;
    ay[slot] = 0;
    aw[slot] = 0;
  }

  /** Adds the phase that loads the moving bodies, cuts speeds to the limits and uses up forces. */
  public void load(DomainPhases phases) {
    phases.add(loading, 0);
  }

  private void load(int from, int to) {
    BodyStore b = bodies;
    Settings s = settings;
    for (int i = from; i < to; i++) {
      int body = slots.body[i];
      int at = i * STRIDE;
      boolean dynamic = b.type[body] == BodyStore.DYNAMIC;
      if (dynamic) {
        b.applyImpulses(body);
      }
      state[at + VX] = b.vx[body] + 0f; // no -0: what rests has one sign
      state[at + VY] = b.vy[body] + 0f;
      state[at + W] = b.w[body] + 0f;
      limit(state, at, s.maxSpeed(), s.maxAngularSpeed());
      state[at + DX] = 0;
      state[at + DY] = 0;
      state[at + COS] = 1;
      state[at + SIN] = 0;
      if (dynamic) {
        ax[i] = b.gravityScale[body] * s.gravityX() + b.invMass[body] * b.forceX[body];
        ay[i] = b.gravityScale[body] * s.gravityY() + b.invMass[body] * b.forceY[body];
        aw[i] = b.invInertia[body] * b.torque[body];
        linearFactor[i] = 1 / (1 + h * b.linearDamping[body]);
        angularFactor[i] = 1 / (1 + h * b.angularDamping[body]);
        b.useForces(body);
        locks.load(i, b, body, state, at, ax, ay);
      } else {
        ax[i] = 0;
        ay[i] = 0;
        aw[i] = 0;
        linearFactor[i] = 1;
        angularFactor[i] = 1;
      }
    }
  }

  private void hold(int slot) {
    locks.hold(slot, bodies, slots.body, state, slot * STRIDE);
    locks.hold(slot, bodies, slots.body, withoutContacts, slot * VELOCITY);
  }

  /**
   * Adds the phase of the first half of symplectic Euler: v += h a. Damping is implicit, v / (1 + h
   * c), hence stable for any rate. Speeds above the limits are cut; what isn't a number becomes
   * zero, so that one broken body stays one.
   *
   * @param warm whether the contacts' impulses of the last substep are applied, too
   */
  public void integrateVelocities(DomainPhases phases, boolean warm) {
    if (!explicit) {
      phases.add(accelerating, warm ? 1 : 0);
      return;
    }
    phases.run();
    if (before.length < state.length) {
      before = new float[state.length];
      free = new float[state.length];
      solved = new float[state.length];
    }
    System.arraycopy(state, 0, before, 0, count * STRIDE);
    accelerate(1, count, warm);
    System.arraycopy(state, 0, free, 0, count * STRIDE);
  }

  private void accelerate(int from, int to, boolean warm) {
    float[] s = state;
    float[] p = withoutContacts;
    float maxSpeed = settings.maxSpeed();
    float maxAngularSpeed = settings.maxAngularSpeed();
    for (int i = from; i < to; i++) {
      int at = i * STRIDE;
      int q = i * VELOCITY;
      float vx = s[at + VX];
      float vy = s[at + VY];
      float w = s[at + W];
      float byContactsX = vx - p[q + VX];
      float byContactsY = vy - p[q + VY];
      float byContactsW = w - p[q + W];
      s[at + VX] = (vx + h * ax[i]) * linearFactor[i];
      s[at + VY] = (vy + h * ay[i]) * linearFactor[i];
      s[at + W] = (w + h * aw[i]) * angularFactor[i];
      limit(s, at, maxSpeed, maxAngularSpeed);
      p[q + VX] = s[at + VX];
      p[q + VY] = s[at + VY];
      p[q + W] = s[at + W];
      if (warm
          && Math.abs(byContactsX) + Math.abs(byContactsY) + Math.abs(byContactsW)
              <= Float.MAX_VALUE) {
        s[at + VX] += byContactsX;
        s[at + VY] += byContactsY;
        s[at + W] += byContactsW;
      }
      hold(i);
    }
  }

  /** Remembers velocities, because joints are going to change them. */
  public void rememberVelocities() {
    if (beforeJoints.length < withoutContacts.length) {
      beforeJoints = new float[withoutContacts.length];
    }
    parallel.run(1, count, GRAIN, remembering);
  }

  /** Returns how gravity and forces accelerate the body at a slot along x, m/s^2. */
  public float accelerationX(int slot) {
    return ax[slot];
  }

  /** Returns the same along y. */
  public float accelerationY(int slot) {
    return ay[slot];
  }

  /** Returns how torques accelerate the turning of the body at a slot, rad/s^2. */
  public float angularAcceleration(int slot) {
    return aw[slot];
  }

  /**
   * Returns the velocities that were remembered.
   *
   * @return the live array, {@link #VELOCITY} floats per slot
   */
  public float[] beforeJoints() {
    return beforeJoints;
  }

  private void rememberVelocities(int from, int to) {
    for (int i = from; i < to; i++) {
      beforeJoints[i * VELOCITY + VX] = state[i * STRIDE + VX];
      beforeJoints[i * VELOCITY + VY] = state[i * STRIDE + VY];
      beforeJoints[i * VELOCITY + W] = state[i * STRIDE + W];
    }
  }

  /** Counts a change of a body's velocity as not made by contacts, which would repeat it. */
  public void countOut(int slot, float vx, float vy, float w) {
    withoutContacts[slot * VELOCITY + VX] += vx;
    withoutContacts[slot * VELOCITY + VY] += vy;
    withoutContacts[slot * VELOCITY + W] += w;
  }

  /** Counts the changes since {@link #rememberVelocities} as not made by contacts. */
  public void afterJoints() {
    parallel.run(1, count, GRAIN, addingJointChanges);
  }

  private void addJointChanges(int from, int to) {
    for (int i = from; i < to; i++) {
      withoutContacts[i * VELOCITY + VX] +=
          state[i * STRIDE + VX] - beforeJoints[i * VELOCITY + VX];
      withoutContacts[i * VELOCITY + VY] +=
          state[i * STRIDE + VY] - beforeJoints[i * VELOCITY + VY];
      withoutContacts[i * VELOCITY + W] += state[i * STRIDE + W] - beforeJoints[i * VELOCITY + W];
    }
  }

  /**
   * Adds the phase of the second half: bodies move.
   *
   * <p>Explicit Euler: with the velocity from before they were accelerated, {@code v}, and what
   * constraints changed since. Constraints so act on positions at once; else what overlaps would
   * never be pushed apart.
   */
  public void integratePositions(DomainPhases phases) {
    if (!explicit) {
      phases.add(moving, 0);
      return;
    }
    phases.run();
    float[] s = state;
    System.arraycopy(s, 0, solved, 0, count * STRIDE);
    for (int at = STRIDE; at < count * STRIDE; at += STRIDE) {
      s[at + VX] = before[at + VX] + (solved[at + VX] - free[at + VX]);
      s[at + VY] = before[at + VY] + (solved[at + VY] - free[at + VY]);
      s[at + W] = before[at + W] + (solved[at + W] - free[at + W]);
    }
    move(1, count);
    for (int at = STRIDE; at < count * STRIDE; at += STRIDE) {
      s[at + VX] = finite(solved[at + VX]);
      s[at + VY] = finite(solved[at + VY]);
      s[at + W] = finite(solved[at + W]);
    }
  }

  private static float finite(float value) {
    return Math.abs(value) <= Float.MAX_VALUE ? value : 0;
  }

  private static void limit(float[] s, int at, float maxSpeed, float maxAngularSpeed) {
    float vx = s[at + VX];
    float vy = s[at + VY];
    float w = s[at + W];
    float square = vx * vx + vy * vy;
    if (!(square <= maxSpeed * maxSpeed)) {
      float cut = square <= Float.MAX_VALUE ? maxSpeed / (float) Math.sqrt(square) : 0;
      s[at + VX] = cut > 0 ? vx * cut : 0;
      s[at + VY] = cut > 0 ? vy * cut : 0;
    }
    if (!(Math.abs(w) <= maxAngularSpeed)) {
      s[at + W] = w > 0 ? maxAngularSpeed : w < 0 ? -maxAngularSpeed : 0;
    }
  }

  /**
   * Does the second half of a substep: x += h v, and the rotation by the angle a = h w. It computes
   * (cos, sin) to the fourth order, then normalises; the error of the angle is below a^5 / 120, and
   * no trigonometry is needed.
   *
   * <p>Constraints that were pulled far apart may ask for any speed here; what is absurd or not a
   * number is cut, so that it never gets into a pose.
   */
  private void move(int from, int to) {
    float[] s = state;
    for (int i = from; i < to; i++) {
      int at = i * STRIDE;
      hold(i);
      float moveX = h * s[at + VX];
      float moveY = h * s[at + VY];
      if (!(Math.abs(moveX) + Math.abs(moveY) <= MAX_TRANSLATION)) {
        moveX = 0;
        moveY = 0;
        withoutContacts[i * VELOCITY + VX] -= s[at + VX];
        withoutContacts[i * VELOCITY + VY] -= s[at + VY];
        s[at + VX] = 0;
        s[at + VY] = 0;
      }
      s[at + DX] += moveX;
      s[at + DY] += moveY;
      float a = h * s[at + W];
      if (!(Math.abs(a) <= MAX_ROTATION)) {
        a = a > 0 ? MAX_ROTATION : a < 0 ? -MAX_ROTATION : 0;
        withoutContacts[i * VELOCITY + W] += a / h - s[at + W];
        s[at + W] = a / h;
      }
      if (a != 0) {
        float aa = a * a;
        float dc = 1 - aa * (0.5f - aa * (1 / 24f));
        float ds = a * (1 - aa * (1 / 6f));
        float c = s[at + COS];
        float n = s[at + SIN];
        float newCos = c * dc - n * ds;
        float newSin = n * dc + c * ds;
        float inverse = 1 / (float) Math.sqrt(newCos * newCos + newSin * newSin);
        s[at + COS] = newCos * inverse;
        s[at + SIN] = newSin * inverse;
      }
    }
  }

  /** Returns how many bodies were put back since the step began. */
  public int putBackCount() {
    return putBackCount;
  }

  /** Returns a body that was put back. */
  public int putBack(int i) {
    return putBack[i];
  }

  /**
   * Notes that a body whose pose was written back is put elsewhere.
   *
   * @param b has its pose as it was written
   * @param pose where its centre goes
   */
  public void putBack(int body, BodyStore b, Transform pose) {
    if (putBack.length == putBackCount) {
      putBack = Arrays.copyOf(putBack, 2 * putBackCount + 8);
    }
    putBack[putBackCount++] = body;
    int at = slots.slotOf[body] * STRIDE;
    float c = pose.cos * b.cos[body] + pose.sin * b.sin[body];
    float n = pose.sin * b.cos[body] - pose.cos * b.sin[body];
    float cos = state[at + COS];
    float sin = state[at + SIN];
    state[at + DX] += pose.x - b.x[body];
    state[at + DY] += pose.y - b.y[body];
    state[at + COS] = c * cos - n * sin;
    state[at + SIN] = n * cos + c * sin;
  }

  /**
   * Adds the phase that writes velocities, cut to the limits, and poses back. A body at the edge of
   * the world stops there.
   */
  public void store(DomainPhases phases) {
    phases.add(storing, 0);
  }

  /**
   * Writes bodies back. Every other domain goes backwards, because threads of domains that have
   * mixed write to the same lines of memory and should do so at different times.
   */
  private void store(int from, int to, boolean backwards) {
    for (int i = from; i < to && !backwards; i++) {
      store(i);
    }
    for (int i = to - 1; i >= from && backwards; i--) {
      store(i);
    }
  }

  private void store(int slot) {
    BodyStore b = bodies;
    float[] s = state;
    int body = slots.body[slot];
    int at = slot * STRIDE;
    hold(slot);
    limit(s, at, settings.maxSpeed(), settings.maxAngularSpeed());
    b.vx[body] = s[at + VX];
    b.vy[body] = s[at + VY];
    b.w[body] = s[at + W];
    b.x[body] = inside(b, body, b.x[body] + s[at + DX]);
    b.y[body] = inside(b, body, b.y[body] + s[at + DY]);
    if (s[at + SIN] != 0) {
      float dc = s[at + COS];
      float ds = s[at + SIN];
      float c = b.cos[body] * dc - b.sin[body] * ds;
      float n = b.sin[body] * dc + b.cos[body] * ds;
      float inverse = 1 / (float) Math.sqrt(c * c + n * n);
      b.cos[body] = c * inverse;
      b.sin[body] = n * inverse;
    }
  }

  private static float inside(BodyStore b, int body, float coordinate) {
    if (Math.abs(coordinate) <= Limits.MAX_POSITION) {
      return coordinate;
    }
    b.vx[body] = 0;
    b.vy[body] = 0;
    return coordinate > 0 ? Limits.MAX_POSITION : -Limits.MAX_POSITION;
  }
}
