package carom.sim.pool;

import carom.physics.Body;
import carom.physics.World;
import carom.physics.geometry.Shape;
import java.util.Arrays;
import java.util.List;

/**
 * Applies the forces of pools' particles to bodies, one after the other, and finds which of these
 * stir the particles. One thread; allocates only for the first body of an archetype.
 */
final class BodyForces {
  /** Relative speed, m/s, from which a body stirs. */
  private static final float STIRS_FROM = 0.5f;

  /** Part of a body's area that must be in the particles for it to stir. */
  private static final float STIRS_WITH = 0.08f;

  /** Radius in which a body stirs, in radii of a disc of its area. */
  private static final float STIRRED = 1.5f;

  private static final float INVERSE_PI = 0.31830988f;
  private static final int STIR_FLOATS = 7;

  /** By archetype. */
  private BodySamples[] samples = {};

  // The body that is acted on, and what the particles are around it.
  private double mass;
  private double momentX;
  private double momentY;
  private double second;
  private double flowX;
  private double flowY;

  // Bodies that stir, the strongest first: strength, pool, x, y, radius, velocity.
  private final float[] stirs = new float[OrderLog.MAX_ORDERS * STIR_FLOATS];
  private int stirCount;

  /** Begins a tick: no body stirs yet. */
  void begin() {
    stirCount = 0;
  }

  /** Returns whether any body stirs. */
  boolean areStirring() {
    return stirCount > 0;
  }

  /**
   * Lifts, brakes and carries a body along in the next step.
   *
   * @param pool the number of the pool
   * @param kind number of the body's archetype
   * @param shapes the archetype's shapes
   * @param notes whether to note that the body stirs
   */
  void act(
      World<?> world,
      Body<?> body,
      int pool,
      PoolDef def,
      PoolGrid grid,
      int kind,
      List<Shape> shapes,
      float dt,
      boolean notes) {
    BodySamples of = samples(kind, shapes);
    measure(body, of, grid, def.density());
    if (mass > 0) {
      push(world, body, def, dt);
      if (notes && mass > STIRS_WITH * of.area * def.density()) {
        noteStir(pool, body, of);
      }
    }
  }

  private BodySamples samples(int kind, List<Shape> shapes) {
    if (kind >= samples.length) {
      samples = Arrays.copyOf(samples, Math.max(kind + 1, 2 * samples.length));
    }
    if (samples[kind] == null) {
      samples[kind] = new BodySamples(shapes);
    }
    return samples[kind];
  }

  /** Measures what the particles displaced by a body weigh, where they are, and how they move. */
  private void measure(Body<?> body, BodySamples of, PoolGrid grid, float density) {
    mass = 0;
    momentX = 0;
    momentY = 0;
    second = 0;
    flowX = 0;
    flowY = 0;
    float cos = body.cos();
    float sin = body.sin();
    for (int i = 0; i < of.points.length; i += 3) {
      float lx = of.points[i];
      float ly = of.points[i + 1];
      float x = body.x() + cos * lx - sin * ly;
      float y = body.y() + sin * lx + cos * ly;
      if (grid.read(x, y)) {
        double share = (double) density * of.points[i + 2];
        double m = share * grid.full;
        double rx = (double) x - body.centerX();
        double ry = (double) y - body.centerY();
        mass += m;
        momentX += m * rx;
        momentY += m * ry;
        second += m * (rx * rx + ry * ry);
        flowX += share * grid.momentumX;
        flowY += share * grid.momentumY;
      }
    }
  }

  /** Applies lift and drag, implicitly over the step, as {@code Buoyancy} does. */
  private void push(World<?> world, Body<?> body, PoolDef def, float dt) {
    double rx = momentX / mass;
    double ry = momentY / mass;
    double inverseInertia = body.inertia() > 0 ? 1.0 / body.inertia() : 0;
    double arm = (rx * rx + ry * ry) * inverseInertia;
    double rate = def.drag() * mass;
    double pull = rate / (1 + dt * rate * (1.0 / body.mass() + arm));
    double w = body.angularVelocity();
    double fx = -mass * world.gravityX() + pull * (flowX / mass - (body.velocityX() - w * ry));
    double fy = -mass * world.gravityY() + pull * (flowY / mass - (body.velocityY() + w * rx));
    double turn = def.drag() * Math.max(0, second - mass * (rx * rx + ry * ry));
    double brake = turn / (1 + dt * turn * inverseInertia);
    body.applyAmbientForce((float) fx, (float) fy, (float) (rx * fy - ry * fx - brake * w));
  }

  private void noteStir(int pool, Body<?> body, BodySamples of) {
    double dx = body.velocityX() - flowX / mass;
    double dy = body.velocityY() - flowY / mass;
    double speed = Math.sqrt(dx * dx + dy * dy);
    if (speed < STIRS_FROM) {
      return;
    }
    float strength = (float) (speed * mass);
    int place = Math.min(stirCount, OrderLog.MAX_ORDERS);
    while (place > 0 && stirs[(place - 1) * STIR_FLOATS] < strength) {
      place--;
    }
    if (place == OrderLog.MAX_ORDERS) {
      return;
    }
    int at = place * STIR_FLOATS;
    int moved = Math.min(stirCount, OrderLog.MAX_ORDERS - 1) - place;
    System.arraycopy(stirs, at, stirs, at + STIR_FLOATS, moved * STIR_FLOATS);
    stirs[at] = strength;
    stirs[at + 1] = pool;
    stirs[at + 2] = body.centerX();
    stirs[at + 3] = body.centerY();
    stirs[at + 4] = STIRRED * (float) Math.sqrt(of.area * INVERSE_PI);
    stirs[at + 5] = body.velocityX();
    stirs[at + 6] = body.velocityY();
    stirCount = Math.min(OrderLog.MAX_ORDERS, stirCount + 1);
  }

  /** Orders the stirring of the strongest in a row, as many as fit. */
  void order(int[] row, List<Pool> pools) {
    for (int at = 0; at < stirCount * STIR_FLOATS; at += STIR_FLOATS) {
      int pool = (int) stirs[at + 1];
      PoolDef.Rectangle box = pools.get(pool).def().box();
      OrderLog.add(
          row,
          box,
          OrderLog.STIR,
          pool,
          stirs[at + 2],
          stirs[at + 3],
          stirs[at + 4],
          stirs[at + 5],
          stirs[at + 6]);
    }
  }
}
