package carom.physics.dynamics.continuous;

import carom.physics.collision.distance.Sweep;
import carom.physics.dynamics.body.ActiveBodies;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.body.ShapeTable;
import carom.physics.dynamics.solver.SolverBodies;
import carom.physics.dynamics.store.KeySorter;
import carom.physics.geometry.Convex;
import carom.physics.math.Limits;
import carom.physics.math.Trig;
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

  /** Bodies pressed into static or kinematic ones when the step began. */
  private boolean[] isPressed = new boolean[FIRST_CAPACITY];

  private boolean anyPressed;

  /** Whether anything that moves may be a target. */
  private boolean moving;

  /** The farthest any point of a slow body gets, m. */
  private float drift;

  // The step at present.
  private SolverBodies solverBodies;
  private float stepS;
  private final Sweep sweep = new Sweep();

  FastBodies(BodyStore bodies, ActiveBodies active, ShapeTable parts) {
    this.bodies = bodies;
    this.active = active;
    this.parts = parts;
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
    int flight = flightOf[body];
    return flight < 0 ? null : flights[flight];
  }

  /** Returns whether anything that moves may be a target. */
  boolean movingTargets() {
    return moving;
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
   * Notes that a dynamic body overlaps a static or kinematic one when the step begins: one that is
   * pressed in deep is swept however slow it is, or it could be squeezed through bit by bit.
   *
   * @param overlap how deep, m
   */
  void press(int body, float overlap) {
    if (overlap > ContinuousCollision.DEEP * bodies.innerRadius[body]) {
      if (isPressed.length <= body) {
        isPressed = Arrays.copyOf(isPressed, bodies.type.length);
      }
      anyPressed |= !isPressed[body];
      isPressed[body] = true;
    }
  }

  /** Forgets which bodies were pressed in, before a step notes them anew. */
  void forgetPressed() {
    if (anyPressed) {
      Arrays.fill(isPressed, false);
      anyPressed = false;
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
    moving = false;
    float[] s = solved.state;
    for (int i = 0; i < active.count; i++) {
      int body = active.list[i];
      if (bodies.type[body] != BodyStore.DYNAMIC) {
        moving = true;
        continue;
      }
      int at = solved.slot(body) * SolverBodies.STRIDE;
      float dx = s[at + SolverBodies.DX];
      float dy = s[at + SolverBodies.DY];
      float turn = ANGLE_BY_SINE * Math.abs(s[at + SolverBodies.SIN]);
      float free = ContinuousCollision.GATE * bodies.innerRadius[body] - bodies.reach[body] * turn;
      boolean slow = s[at + SolverBodies.COS] > 0 && free >= 0 && dx * dx + dy * dy <= free * free;
      boolean pressedIn = anyPressed && body < isPressed.length && isPressed[body];
      if (!slow || pressedIn) {
        add(body, pressedIn);
      }
    }
    return count > 0;
  }

  private void add(int body, boolean pressedIn) {
    float limit = ContinuousCollision.GATE * bodies.innerRadius[body];
    boolean atEdge =
        Math.abs(bodies.x[body]) >= Limits.MAX_COORDINATE
            || Math.abs(bodies.y[body]) >= Limits.MAX_COORDINATE;
    if (atEdge || limit == Float.POSITIVE_INFINITY) {
      return;
    }
    if (count == flights.length) {
      flights = Arrays.copyOf(flights, Math.max(FIRST_CAPACITY, count * 2));
      for (int i = count; i < flights.length; i++) {
        flights[i] = new Flight();
      }
    }
    Flight f = flights[count];
    motion(body, f.whole);
    float way = (float) Math.sqrt(f.whole.dx * f.whole.dx + f.whole.dy * f.whole.dy);
    if (way == 0 && f.whole.angleRad == 0) {
      return;
    }
    if (!pressedIn && way + arm(body) * Math.abs(f.whole.angleRad) <= limit) {
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
    if (flightOf.length < bodies.slots()) {
      flightOf = new int[bodies.type.length];
      Arrays.fill(flightOf, -1);
    }
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
