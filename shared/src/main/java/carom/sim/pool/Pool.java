package carom.sim.pool;

import carom.physics.World;
import carom.physics.math.Aabb;
import carom.physics.math.Transform;
import carom.physics.particles.Emitter;
import carom.physics.particles.Particles;

/**
 * Water or sand in a rectangle of the level. Server and clients compute it alike; it is stirred by
 * bodies and pushes them. What a game orders here takes effect {@link Pools#delay} ticks later, on
 * all sides at the same tick.
 *
 * <p>The thread of its simulation. A step allocates nothing once there are all particles.
 */
public final class Pool {
  /** Ticks for which particles must hardly move before the pool stands still. */
  private static final int STILL_TICKS = 60;

  /** Mean speed, m/s, below which particles hardly move. */
  private static final float SLOW = 0.06f;

  /** Fraction of the gap to the velocity a body imposes that particles close each tick. */
  private static final float TAKEN_ALONG = 0.3f;

  /**
   * Part of a stirring body's way that the stirred place goes. With all of it, a stone that falls
   * in takes the water down before it can give way.
   */
  private static final float ALONG_WAY = 0.5f;

  /** Part of a stirring body's velocity that it wants particles to have. */
  private static final float ALONG = 0.4f;

  /** Part of a stirring body's speed with which it drives particles apart at its edge. */
  private static final float APART = 0.8f;

  private final Pools pools;
  private final int index;
  private final PoolDef def;
  private final Particles particles;
  private final Emitter[] spouts;

  /** Bit of the first spout among those of all pools. */
  private final int firstSpout;

  private final Aabb box = new Aabb();
  private final Aabb[] drains;

  /** The cells of the last ticks, by tick; a power of two. */
  private final PoolGrid[] grids;

  private PoolGrid newest;
  private int stillTicks;
  private boolean ordered;

  Pool(Pools pools, int index, PoolDef def, int firstSpout, int remembered) {
    this.pools = pools;
    this.index = index;
    this.def = def;
    this.firstSpout = firstSpout;
    particles = new Particles(def.particles());
    PoolDef.Rectangle b = def.box();
    box.set(b.minX(), b.minY(), b.maxX(), b.maxY());
    spouts = new Emitter[def.spouts().size()];
    for (int i = 0; i < spouts.length; i++) {
      PoolDef.Spout s = def.spouts().get(i);
      spouts[i] = new Emitter(s.x(), s.y(), s.dirX(), s.dirY()).width(s.width()).speed(s.speed());
    }
    drains = new Aabb[def.drains().size()];
    for (int i = 0; i < drains.length; i++) {
      PoolDef.Rectangle d = def.drains().get(i);
      drains[i] = new Aabb();
      drains[i].set(d.minX(), d.minY(), d.maxX(), d.maxY());
    }
    grids = new PoolGrid[remembered];
    for (int i = 0; i < remembered; i++) {
      grids[i] = new PoolGrid(def);
    }
    for (PoolDef.Rectangle f : def.fills()) {
      fill(f);
    }
    newest = grids[0];
    newest.measure(particles);
    newest.tick = 0;
  }

  private void fill(PoolDef.Rectangle f) {
    float halfWidth = 0.5f * (f.maxX() - f.minX());
    float halfHeight = 0.5f * (f.maxY() - f.minY());
    particles.fill(
        new carom.physics.geometry.Box(halfWidth, halfHeight),
        new Transform(f.minX() + halfWidth, f.minY() + halfHeight, 0),
        0,
        0);
  }

  /** Returns the definition. */
  public PoolDef def() {
    return def;
  }

  /** Returns the particles, for drawing and counting. Do not change them. */
  public Particles particles() {
    return particles;
  }

  /** Returns whether nothing moves, so that ticks cost nothing. */
  public boolean isStill() {
    return stillTicks == STILL_TICKS && !hasOpenSpout();
  }

  private boolean hasOpenSpout() {
    int mine = ((1 << spouts.length) - 1) << firstSpout;
    return spouts.length > 0 && (pools.open() & mine) != 0;
  }

  /**
   * Returns how full the place around a point is at the present tick.
   *
   * @return 0 for empty, 1 for as full as at rest
   */
  public float fullness(float x, float y) {
    newest.read(x, y);
    return newest.full;
  }

  /**
   * Opens or closes a spout. Nothing happens on a client: it hears of it.
   *
   * @param name of a {@link PoolDef.Spout} of this pool
   * @throws IllegalArgumentException if there is none of that name
   */
  public void open(String name, boolean open) {
    pools.request(firstSpout + spout(name), open);
  }

  /** Returns whether a spout is open, or will be after the delay. */
  public boolean isOpen(String name) {
    return pools.isOrderedOpen(firstSpout + spout(name));
  }

  private int spout(String name) {
    for (int i = 0; i < spouts.length; i++) {
      if (def.spouts().get(i).name().equals(name)) {
        return i;
      }
    }
    throw new IllegalArgumentException(
        "pool " + def.name() + " has no spout=" + name + "; declare it in its definition");
  }

  /**
   * Pours particles into a disc where there are none. Nothing happens on a client.
   *
   * @param x middle, metres
   * @param y middle, metres
   * @param radius metres, at most 6.35
   * @param vx velocity, m/s, within 25.6
   * @param vy velocity, m/s, within 25.6
   * @return false if the pool has too many orders in this tenth of a second; it ignores this one
   */
  public boolean pour(float x, float y, float radius, float vx, float vy) {
    return pools.order(OrderLog.POUR, index, x, y, radius, vx, vy);
  }

  /** Takes away the particles in a disc; see {@link #pour}. */
  public boolean take(float x, float y, float radius) {
    return pools.order(OrderLog.TAKE, index, x, y, radius, 0, 0);
  }

  // ---- for Pools

  /** Carries out the order that the log has read; stirring is done in each tick of the period. */
  void obey(OrderLog order, float seconds, boolean begins) {
    ordered = true;
    stillTicks = 0;
    if (order.kind == OrderLog.STIR) {
      stir(
          order,
          order.x + ALONG_WAY * seconds * order.vx,
          order.y + ALONG_WAY * seconds * order.vy);
    } else if (begins && order.kind == OrderLog.POUR) {
      pourNow(order);
    } else if (begins && order.kind == OrderLog.TAKE) {
      for (int i = particles.count() - 1; i >= 0; i--) {
        if (isWithin(i, order.x, order.y, order.radius)) {
          particles.remove(particles.id(i));
        }
      }
    }
  }

  private boolean isWithin(int i, float x, float y, float radius) {
    float dx = particles.x(i) - x;
    float dy = particles.y(i) - y;
    return dx * dx + dy * dy < radius * radius;
  }

  private void stir(OrderLog order, float x, float y) {
    float speed = (float) Math.sqrt(order.vx * order.vx + order.vy * order.vy);
    float apart = order.radius > 0 ? APART * speed / order.radius : 0;
    for (int i = 0; i < particles.count(); i++) {
      if (isWithin(i, x, y, order.radius)) {
        float vx = particles.velocityX(i);
        float vy = particles.velocityY(i);
        float toX = ALONG * order.vx + apart * (particles.x(i) - x);
        float toY = ALONG * order.vy + apart * (particles.y(i) - y);
        particles.setVelocity(i, vx + TAKEN_ALONG * (toX - vx), vy + TAKEN_ALONG * (toY - vy));
      }
    }
  }

  /** Adds particles in rows, where the cells aren't full. */
  private void pourNow(OrderLog order) {
    float pitch = def.spacing();
    int most = (int) (order.radius / pitch);
    for (int row = -most; row <= most; row++) {
      for (int column = -most; column <= most; column++) {
        float dx = column * pitch;
        float dy = row * pitch;
        boolean within = dx * dx + dy * dy <= order.radius * order.radius;
        newest.read(order.x + dx, order.y + dy);
        if (within && newest.full < 0.5f && def.box().contains(order.x + dx, order.y + dy)) {
          particles.add(order.x + dx, order.y + dy, order.vx, order.vy);
        }
      }
    }
  }

  /** Computes a tick. */
  void step(World<?> ground, boolean groundMoves, int tick, float dt) {
    PoolGrid next = grids[tick & grids.length - 1];
    if (isStill() && !ordered && !groundMoves) {
      if (next != newest) {
        next.copy(newest);
      }
    } else {
      for (int i = 0; i < spouts.length; i++) {
        if ((pools.open() >>> firstSpout + i & 1) != 0) {
          spouts[i].emit(particles, tick, dt);
        }
      }
      particles.step(ground, dt);
      for (Aabb drain : drains) {
        particles.removeInside(drain);
      }
      particles.removeOutside(box);
      double sum = next.measure(particles);
      boolean slow = sum <= (double) SLOW * SLOW * particles.count();
      stillTicks = slow && !ordered && !groundMoves ? Math.min(STILL_TICKS, stillTicks + 1) : 0;
    }
    ordered = false;
    next.tick = tick;
    newest = next;
  }

  /** Returns the cells of a tick; the newest ones if that tick isn't known. */
  PoolGrid grid(int tick) {
    PoolGrid grid = grids[tick & grids.length - 1];
    return grid.tick == tick ? grid : newest;
  }

  int stillTicks() {
    return stillTicks;
  }

  /** Takes note that the particles are those of a restored state. */
  void restored(int tick, int still) {
    stillTicks = Math.max(0, Math.min(STILL_TICKS, still));
    for (PoolGrid grid : grids) {
      grid.tick = -1;
    }
    newest = grids[tick & grids.length - 1];
    newest.measure(particles);
    newest.tick = tick;
  }
}
