package carom.physics.dynamics.solver;

import carom.physics.dynamics.body.ActiveBodies;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.body.Settings;
import carom.physics.dynamics.contact.ContactTable;
import carom.physics.dynamics.pairs.PairFinder;
import carom.physics.dynamics.parallel.DomainPhases;
import carom.physics.dynamics.parallel.ParallelFor;
import carom.physics.math.Limits;
import java.util.Arrays;

/**
 * What the solver touches of each moving body, packed to 32 bytes: velocity, and how far the body
 * has moved and turned since the step began.
 *
 * <p>Slot 0 is the one static body of all constraints: without mass and at rest, it absorbs
 * whatever is added to it (which is zero). Moving bodies follow, see {@link SolverSlots}. Positions
 * are differences, so the solver works with small numbers wherever in the world it is.
 */
public final class SolverBodies {
  /** Floats per slot, and their order. */
  public static final int STRIDE = 8;

  public static final int VX = 0;
  public static final int VY = 1;
  public static final int W = 2;
  public static final int DX = 3;
  public static final int DY = 4;
  public static final int COS = 5;
  public static final int SIN = 6;

  /** Furthest a body gets in a substep, m; a net under overflow, far above any sane speed. */
  private static final float FURTHEST = 1e6f;

  /** Furthest a body turns in a substep, rad; the series for the rotation is good up to here. */
  private static final float MOST_TURN = 2;

  public float[] state = new float[0];

  /**
   * Velocities without what contacts did in this substep, {@value #PLAIN} floats per slot. What
   * they did is what the next substep starts with: their impulses times the lever arms, which stay
   * the same for a whole step, are known in sum, so nobody has to visit the contacts again.
   */
  private float[] plain = new float[0];

  private static final int PLAIN = 4;

  /** Velocities before joints were solved, in the same places. */
  private float[] marked = new float[0];

  /** Acceleration by gravity and forces, and the factor that damping leaves, per slot. */
  private float[] ax = new float[0];

  private float[] ay = new float[0];
  private float[] aw = new float[0];
  private float[] keep = new float[0];
  private float[] keepW = new float[0];

  /**
   * Explicit Euler only, in the places of {@link #state}: velocity before and after a substep's
   * acceleration, and after its constraints.
   */
  private float[] before = new float[0];

  private float[] free = new float[0];
  private float[] solved = new float[0];
  private boolean explicit;

  private int count;

  /** Bodies that make a piece of work for a worker. */
  private static final int GRAIN = 128;

  private final ParallelFor parallel;
  final ActiveBodies active;
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
  private final ParallelFor.Range marking = (from, to, worker) -> mark(from, to);
  private final ParallelFor.Range excepting = (from, to, worker) -> except(from, to);

  /**
   * Makes it empty.
   *
   * @param active whom it is of
   * @param pairs tells who is near whom; null where no step is shared
   * @param parallel does the stages that joints need
   */
  public SolverBodies(ActiveBodies active, PairFinder pairs, ParallelFor parallel) {
    this.active = active;
    this.parallel = parallel;
    domains = new Domains(active, pairs);
    slots = new SolverSlots(active, domains);
  }

  /** The slot of a body, 0 if it doesn't move. */
  public int slot(int body) {
    return slots.slotOf[body];
  }

  /** Per body: its slot, 0 if it doesn't move; until the next step. */
  public int[] slotOf() {
    return slots.slotOf;
  }

  /** Slots there are, the static one and unused ones included. */
  public int count() {
    return count;
  }

  /** Offset in {@link #state} of what a domain may write to where there is no body: it is zero. */
  int idle(int domain) {
    return slots.idle(domain) * STRIDE;
  }

  private int from(int domain, boolean border) {
    return slots.from(domain, border);
  }

  private int to(int domain, boolean border) {
    return slots.to(domain, border);
  }

  float ax(int slot) {
    return ax[slot];
  }

  float ay(int slot) {
    return ay[slot];
  }

  /** A step begins: finds domains. Contacts are laid next, which {@link #assignSlots}. */
  public void begin(BodyStore b, Settings s, float substep, ContactTable contacts) {
    bodies = b;
    settings = s;
    h = substep;
    explicit = s.explicitEuler();
    domains.find(parallel.isSharing() ? parallel.count() : 1, contacts);
  }

  /** Gives active bodies their slots, when it is known who is at the border of a domain. */
  void assignSlots() {
    slots.assign();
    count = slots.count();
    if (ax.length < count) {
      int capacity = Math.max(count, ax.length * 2);
      state = new float[capacity * STRIDE];
      plain = new float[capacity * PLAIN];
      ax = new float[capacity];
      ay = new float[capacity];
      aw = new float[capacity];
      keep = new float[capacity];
      keepW = new float[capacity];
    }
    rest(0);
    for (int domain = 0; domain < domains.count(); domain++) {
      rest(slots.idle(domain));
    }
  }

  /** Has a slot stay where it is. */
  private void rest(int slot) {
    Arrays.fill(state, slot * STRIDE, (slot + 1) * STRIDE, 0);
    state[slot * STRIDE + COS] = 1;
    ax[slot] = 0;
    ay[slot] = 0;
    aw[slot] = 0;
  }

  /** Adds: the moving bodies are loaded, speeds above the limits cut; their forces are used up. */
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
        keep[i] = 1 / (1 + h * b.linearDamping[body]);
        keepW[i] = 1 / (1 + h * b.angularDamping[body]);
        b.useForces(body);
      } else {
        ax[i] = 0;
        ay[i] = 0;
        aw[i] = 0;
        keep[i] = 1;
        keepW[i] = 1;
      }
    }
  }

  /**
   * Adds the first half of symplectic Euler: v += h a. Damping is implicit, v / (1 + h c), hence
   * stable for any rate. Speeds above the limits are cut; what isn't a number becomes zero, so that
   * one broken body stays one.
   *
   * @param warm whether bodies also get what contacts did to them in the last substep
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
    float[] p = plain;
    float maxSpeed = settings.maxSpeed();
    float maxSpin = settings.maxAngularSpeed();
    for (int i = from; i < to; i++) {
      int at = i * STRIDE;
      int q = i * PLAIN;
      float vx = s[at + VX];
      float vy = s[at + VY];
      float w = s[at + W];
      float gotX = vx - p[q + VX];
      float gotY = vy - p[q + VY];
      float gotW = w - p[q + W];
      s[at + VX] = (vx + h * ax[i]) * keep[i];
      s[at + VY] = (vy + h * ay[i]) * keep[i];
      s[at + W] = (w + h * aw[i]) * keepW[i];
      limit(s, at, maxSpeed, maxSpin);
      p[q + VX] = s[at + VX];
      p[q + VY] = s[at + VY];
      p[q + W] = s[at + W];
      if (warm && Math.abs(gotX) + Math.abs(gotY) + Math.abs(gotW) <= Float.MAX_VALUE) {
        s[at + VX] += gotX;
        s[at + VY] += gotY;
        s[at + W] += gotW;
      }
    }
  }

  /** Remembers velocities, before something other than contacts changes them. */
  public void mark() {
    if (marked.length < plain.length) {
      marked = new float[plain.length];
    }
    parallel.run(1, count, GRAIN, marking);
  }

  private void mark(int from, int to) {
    for (int i = from; i < to; i++) {
      marked[i * PLAIN + VX] = state[i * STRIDE + VX];
      marked[i * PLAIN + VY] = state[i * STRIDE + VY];
      marked[i * PLAIN + W] = state[i * STRIDE + W];
    }
  }

  /** Takes note that the changes since {@link #mark} weren't made by contacts. */
  public void except() {
    parallel.run(1, count, GRAIN, excepting);
  }

  private void except(int from, int to) {
    for (int i = from; i < to; i++) {
      plain[i * PLAIN + VX] += state[i * STRIDE + VX] - marked[i * PLAIN + VX];
      plain[i * PLAIN + VY] += state[i * STRIDE + VY] - marked[i * PLAIN + VY];
      plain[i * PLAIN + W] += state[i * STRIDE + W] - marked[i * PLAIN + W];
    }
  }

  /**
   * Adds the second half: bodies move.
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

  private static void limit(float[] s, int at, float maxSpeed, float maxSpin) {
    float vx = s[at + VX];
    float vy = s[at + VY];
    float w = s[at + W];
    float square = vx * vx + vy * vy;
    if (!(square <= maxSpeed * maxSpeed)) {
      float cut = square <= Float.MAX_VALUE ? maxSpeed / (float) Math.sqrt(square) : 0;
      s[at + VX] = cut > 0 ? vx * cut : 0;
      s[at + VY] = cut > 0 ? vy * cut : 0;
    }
    if (!(Math.abs(w) <= maxSpin)) {
      s[at + W] = w > 0 ? maxSpin : w < 0 ? -maxSpin : 0;
    }
  }

  /**
   * Second half: x += h v, and the rotation by the angle a = h w: (cos, sin) to the fourth order,
   * then normalised; the error of the angle is below a^5 / 120, and no trigonometry is needed.
   *
   * <p>Constraints that were torn far apart may ask for any speed here; what is absurd or not a
   * number is cut, so that it never gets into a pose.
   */
  private void move(int from, int to) {
    float[] s = state;
    for (int i = from; i < to; i++) {
      int at = i * STRIDE;
      float moveX = h * s[at + VX];
      float moveY = h * s[at + VY];
      if (!(Math.abs(moveX) + Math.abs(moveY) <= FURTHEST)) {
        moveX = 0;
        moveY = 0;
        plain[i * PLAIN + VX] -= s[at + VX];
        plain[i * PLAIN + VY] -= s[at + VY];
        s[at + VX] = 0;
        s[at + VY] = 0;
      }
      s[at + DX] += moveX;
      s[at + DY] += moveY;
      float a = h * s[at + W];
      if (!(Math.abs(a) <= MOST_TURN)) {
        a = a > 0 ? MOST_TURN : a < 0 ? -MOST_TURN : 0;
        plain[i * PLAIN + W] += a / h - s[at + W];
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

  /**
   * Adds: velocities, speeds above the limits cut, and poses are written back. A body at the edge
   * of the world stops there.
   */
  public void store(DomainPhases phases) {
    phases.add(storing, 0);
  }

  /**
   * Every other domain goes backwards: where domains have mixed, all their threads write to the
   * same lines of memory, and are to do so at different times.
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
    if (Math.abs(coordinate) <= Limits.MAX_COORDINATE) {
      return coordinate;
    }
    b.vx[body] = 0;
    b.vy[body] = 0;
    return coordinate > 0 ? Limits.MAX_COORDINATE : -Limits.MAX_COORDINATE;
  }
}
