package carom.physics.dynamics.continuous;

import carom.physics.collision.Sweep;
import carom.physics.dynamics.body.ActiveBodies;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.body.ShapeTable;
import carom.physics.dynamics.domain.SolverBodies;
import carom.physics.dynamics.store.IntList;
import carom.physics.dynamics.store.KeySorter;
import carom.physics.geometry.Convex;
import carom.physics.math.Limits;
import carom.physics.math.Trig;
import carom.physics.settings.Settings;
import java.util.Arrays;

/**
 * Finds the bodies that moved so far in a step that they could have passed through something, and
 * holds their flights. {@link ContinuousCollision} says which bodies these are.
 */
final class FastBodies {
  private static final float TWO_PI = (float) (2 * Math.PI);

  /** Bound on an angle in (0, pi/2) divided by its sine. */
  private static final float ANGLE_BY_SINE = 1.571f;

  private static final int FIRST_CAPACITY = 16;

  private final Settings settings;
  private final BodyStore bodies;
  private final ActiveBodies active;
  private final ShapeTable parts;
  private Flight[] flights = new Flight[0];
  private int count;

  /** Flight of each body, -1 if it isn't fast. */
  private int[] flightOf = new int[0];

  /** Flights in the order in which they are settled: bullets last, by slot. */
  private long[] order = new long[FIRST_CAPACITY];

  private final KeySorter sorter = new KeySorter();

  /** Bodies that overlapped static or kinematic ones deeply when the step began. */
  private boolean[] isDeep = new boolean[FIRST_CAPACITY];

  private boolean anyDeep;

  /** True if a body that moves may be a target. */
  private boolean moving;

  /** The kinematic bodies that may pass over slow bodies in this step. */
  private final IntList strikers = new IntList();

  /** The farthest any point of a slow body gets, m. */
  private float drift;

  // The step at present.
  private SolverBodies solverBodies;
  private float stepS;
  private final Sweep sweep = new Sweep();
  private final SweptBox own;
  private final SweptBox theirs;

  FastBodies(Settings settings, BodyStore bodies, ActiveBodies active, ShapeTable parts) {
    this.settings = settings;
    this.bodies = bodies;
    this.active = active;
    this.parts = parts;
    own = new SweptBox(parts);
    theirs = new SweptBox(parts);
  }

  /** Returns the number of fast bodies. */
  int count() {
    return count;
  }

  /** Returns a flight, in the order in which bodies were collected. */
  Flight flight(int i) {
    return flights[i];
  }

  /** Returns the flight to settle as the i-th one. */
  Flight inOrder(int i) {
    return flights[flightOf[(int) order[i]]];
  }

  /** Returns the flight of a body, null if it isn't fast. */
  Flight flightOf(int body) {
    int flight = body < flightOf.length ? flightOf[body] : -1; // a callback may just have made it
    return flight < 0 ? null : flights[flight];
  }

  /** Returns whether anything that moves may be a target. */
  boolean movingTargets() {
    return moving;
  }

  /** Returns the number of kinematic bodies that move far in this step. */
  int strikers() {
    return strikers.count;
  }

  /** Sets a flight to the motion of a kinematic body that moves far in this step. */
  void striker(int i, Flight out) {
    out.body = strikers.values[i];
    out.split = 1;
    motion(out.body, out.whole);
  }

  /** Returns how far a moving target may be outside of the box that the tree has of it, m. */
  float drift() {
    return drift;
  }

  /** Notes that a target may be farther outside of the box that the tree has of it, m. */
  void widenDrift(float outside) {
    drift = Math.max(drift, outside);
  }

  /** Forgets the flights, after all are settled. */
  void clear() {
    for (int k = 0; k < count; k++) {
      flightOf[flights[k].body] = -1;
    }
  }

  /**
   * Notes that a dynamic body overlaps a static or kinematic one when the step begins. A body that
   * overlaps deeply is swept however slow it is, because it could be squeezed through bit by bit.
   *
   * @param overlap how deep, m
   */
  void noteOverlap(int body, float overlap) {
    if (overlap > ContinuousCollision.DEEP * bodies.innerRadius[body]) {
      if (isDeep.length <= body) {
        isDeep = Arrays.copyOf(isDeep, bodies.type.length);
      }
      anyDeep |= !isDeep[body];
      isDeep[body] = true;
    }
  }

  /** Forgets which bodies overlapped deeply, before a step notes them anew. */
  void forgetOverlaps() {
    if (anyDeep) {
      Arrays.fill(isDeep, false);
      anyDeep = false;
    }
  }

  /**
   * Collects the fast bodies of the step that the solver has just finished.
   *
   * @param dt length of that step, s
   * @return whether there are any
   */
  boolean collect(SolverBodies solved, float dt) {
    solverBodies = solved;
    stepS = dt;
    count = 0;
    reserve(1);
    if (flightOf.length < bodies.type.length) { // now, not in the step that first needs it
      flightOf = new int[bodies.type.length];
      Arrays.fill(flightOf, -1);
      isDeep = Arrays.copyOf(isDeep, flightOf.length);
    }
    moving = false;
    strikers.count = 0;
    for (int i = 0; i < active.count; i++) {
      int body = active.list[i];
      if (bodies.type[body] != BodyStore.DYNAMIC) {
        moving = true;
        noteStriker(body);
        continue;
      }
      boolean deep = anyDeep && body < isDeep.length && isDeep[body];
      if (deep || !isSlow(body)) {
        add(body, deep ? 0 : ContinuousCollision.GATE * bodies.innerRadius[body]);
      } else if (parts.anySensors() && bodies.innerRadius[body] == Float.POSITIVE_INFINITY) {
        add(body, settings.speculativeDistance());
      }
      moving = moving || hasSensor(body);
    }
    if (strikers.count > 0) {
      addStruck();
    }
    return count > 0 || (strikers.count > 0 && parts.anySensors());
  }

  private void reserve(int least) {
    int old = flights.length;
    if (least > old) {
      flights = Arrays.copyOf(flights, Math.max(FIRST_CAPACITY, 2 * old));
      for (int i = old; i < flights.length; i++) {
        flights[i] = new Flight();
      }
    }
  }

  private boolean hasSensor(int body) {
    int end = parts.anySensors() ? bodies.firstPart[body] + bodies.partCount[body] : 0;
    for (int part = bodies.firstPart[body]; part < end; part++) {
      if (parts.sensor[part]) {
        return true;
      }
    }
    return false;
  }

  /** Returns whether a body surely moved less than a swept one; most do. */
  private boolean isSlow(int body) {
    float[] s = solverBodies.state;
    int at = solverBodies.slot(body) * SolverBodies.STRIDE;
    float dx = s[at + SolverBodies.DX];
    float dy = s[at + SolverBodies.DY];
    float turn = ANGLE_BY_SINE * Math.abs(s[at + SolverBodies.SIN]);
    float free = ContinuousCollision.GATE * bodies.innerRadius[body] - bodies.reach[body] * turn;
    return s[at + SolverBodies.COS] > 0 && free >= 0 && dx * dx + dy * dy <= free * free;
  }

  /** Notes a kinematic body that moves so far in the step that contacts may not predict it. */
  private void noteStriker(int body) {
    motion(body, sweep);
    float turned = bodies.reach[body] * Math.abs(sweep.angleRad);
    if (way(sweep) + turned > settings.speculativeDistance()) {
      strikers.add(body);
    }
  }

  /** Adds the bullets that a fast kinematic body may pass over, however slow they are. */
  private void addStruck() {
    for (int i = 0; i < active.count; i++) {
      int body = active.list[i];
      if (bodies.bullet(body) && bodies.type[body] == BodyStore.DYNAMIC && !flies(body)) {
        measure(body, own);
        for (int k = 0; k < strikers.count; k++) {
          measure(strikers.values[k], theirs);
          if (own.box().overlaps(theirs.box())) {
            add(body, -1);
            break;
          }
        }
      }
    }
  }

  private boolean flies(int body) {
    for (int k = 0; k < count; k++) {
      if (flights[k].body == body) {
        return true;
      }
    }
    return false;
  }

  /** Computes the box that a body sweeps in the step. */
  private void measure(int body, SweptBox box) {
    motion(body, sweep);
    box.setEmpty();
    int first = bodies.firstPart[body];
    for (int part = first; part < first + bodies.partCount[body]; part++) {
      box.add(part, sweep);
    }
  }

  private static float way(Sweep s) {
    return (float) Math.sqrt(s.dx * s.dx + s.dy * s.dy);
  }

  /** Adds a body, if its points may have moved by more than a way, m. */
  private void add(int body, float least) {
    boolean atEdge =
        Math.abs(bodies.x[body]) >= Limits.MAX_POSITION
            || Math.abs(bodies.y[body]) >= Limits.MAX_POSITION;
    if (atEdge) {
      return;
    }
    reserve(count + 1);
    Flight f = flights[count];
    motion(body, f.whole);
    if (way(f.whole) + arm(body) * Math.abs(f.whole.angleRad) <= least) {
      return;
    }
    f.body = body;
    f.split = 1;
    count++;
  }

  /**
   * Returns the distance of the farthest vertex from the centre of mass, which is what turning
   * moves.
   */
  private float arm(int body) {
    float square = 0;
    int first = bodies.firstPart[body];
    for (int part = first; part < first + bodies.partCount[body]; part++) {
      Convex c = parts.convex[part];
      for (int i = 0; i < c.vertexCount(); i++) {
        float x = c.vertexX(i);
        float y = c.vertexY(i);
        square = Math.max(square, x * x + y * y);
      }
    }
    return (float) Math.sqrt(square);
  }

  /** Reads how an awake body moved in this step, as the solver left it. */
  void motion(int body, Sweep out) {
    int at = solverBodies.slot(body) * SolverBodies.STRIDE;
    float[] s = solverBodies.state;
    float dc = s[at + SolverBodies.COS];
    float ds = s[at + SolverBodies.SIN];
    float c = bodies.cos[body];
    float n = bodies.sin[body];
    out.dx = s[at + SolverBodies.DX];
    out.dy = s[at + SolverBodies.DY];
    out.x = bodies.x[body] - out.dx;
    out.y = bodies.y[body] - out.dy;
    out.cos = c * dc + n * ds;
    out.sin = n * dc - c * ds;
    out.angleRad = 0;
    if (ds != 0 || dc < 0) {
      // The way round that fits the speed, but at most one full turn more than the shortest: then
      // every direction has been swept.
      float shortest = Trig.atan2(ds, dc);
      float more = (bodies.w[body] * stepS - shortest) / TWO_PI;
      out.angleRad = shortest + TWO_PI * Math.max(-1, Math.min(1, Math.round(more)));
    }
  }

  /**
   * Puts the flights in the order in which they are settled, and measures how far the other bodies
   * moved.
   */
  void sort() {
    if (order.length < count) {
      order = new long[flights.length];
    }
    for (int k = 0; k < count; k++) {
      int body = flights[k].body;
      flightOf[body] = k;
      boolean last = bodies.bullet(body);
      moving |= last;
      order[k] = (last ? 1L << 32 : 0) | body;
    }
    order = sorter.sort(order, count);
    drift = 0;
    for (int i = 0; i < active.count && moving; i++) {
      int body = active.list[i];
      if (flightOf[body] < 0) {
        motion(body, sweep);
        float turn = Math.min(2, Math.abs(sweep.angleRad));
        drift =
            Math.max(drift, Math.abs(sweep.dx) + Math.abs(sweep.dy) + bodies.reach[body] * turn);
      }
    }
  }
}
