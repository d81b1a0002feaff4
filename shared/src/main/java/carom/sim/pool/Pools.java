package carom.sim.pool;

import carom.physics.Body;
import carom.physics.World;
import carom.physics.archive.ArchiveReader;
import carom.physics.geometry.Shape;
import carom.physics.math.Aabb;
import carom.physics.math.Limits;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.IntConsumer;

/**
 * The pools of one simulation. The server {@linkplain #step steps} them with its ticks and closes a
 * row of {@linkplain OrderLog orders} for each tenth of a second; a client {@linkplain #follow
 * follows} with the rows that it {@linkplain #hear hears}. Both then have the same particles, bit
 * by bit, and {@link #act} does the same to the same bodies.
 *
 * <pre>
 *  server   row of period p closed ─────── 4 periods ───────► period p runs
 *                  └──── datagrams ────► client has the row ──► period p runs, before or after
 * </pre>
 *
 * <p>Particles collide with the level's statics and with bodies on its paths. Other bodies pass
 * through them: they are lifted, braked and carried along as in an area of water, and stir what is
 * around them a delay later. A client that lacks a row waits with the particles as they are.
 *
 * <p>One thread; a tick allocates nothing in the steady state.
 */
public final class Pools {
  /** Most pools of a level. */
  public static final int MAX_POOLS = OrderLog.MAX_POOLS;

  /** Ticks whose cells a client remembers, for what it predicts anew; a power of two. */
  private static final int REMEMBERED = 64;

  private final List<Pool> pools = new ArrayList<>();
  private final int tickRate;
  private final int ticksPerPeriod;
  private final float dt;
  private final boolean decides;
  private final OrderLog log = new OrderLog();

  /** Orders of the game since the last row was closed. */
  private final int[] requests = new int[OrderLog.WORDS];

  private int open;
  private int requestedOpen;
  private int spouts;
  private int particles;
  private boolean begun;
  private ParticleWorld own;
  private List<ShownParticles> shown = List.of();
  private World<?> ground;
  private IntConsumer drive;
  private boolean groundMoves;
  private int tick;

  private boolean known;
  private boolean wrong;
  private int stillSince;

  /** The first period that began after the state that was restored last. */
  private int firstPeriod;

  private final PeriodHashes hashes = new PeriodHashes();

  private final BodyForces forces = new BodyForces();

  /**
   * Creates the pools of a simulation; there are none yet.
   *
   * @param tickRate steps per second
   * @param decides whether this is the server
   */
  public Pools(int tickRate, boolean decides) {
    this.tickRate = tickRate;
    ticksPerPeriod = Math.max(1, tickRate / 10);
    dt = 1f / tickRate;
    this.decides = decides;
    known = decides;
  }

  /**
   * Adds a pool, in {@code setUp}, on both sides alike.
   *
   * @return the pool
   * @throws IllegalArgumentException if there are too many pools, spouts or particles, or two of
   *     one name
   * @throws IllegalStateException after {@code setUp}
   */
  public Pool add(PoolDef def) {
    Limits.notNull("def", def);
    if (begun) {
      throw new IllegalStateException("pool " + def.name() + " must be added in Game.setUp");
    }
    PoolDef.limit("pools", pools.size() + 1, OrderLog.MAX_POOLS);
    PoolDef.limit("spouts", spouts + def.spouts().size(), PoolDef.MAX_SPOUTS);
    PoolDef.limit("particles of all pools", particles + def.most(), PoolDef.MAX_PARTICLES);
    if (find(def.name()) != null) {
      throw new IllegalArgumentException(
          "pool " + def.name() + " is declared twice; give one another name");
    }
    Pool pool = new Pool(this, pools.size(), def, spouts, decides ? 1 : REMEMBERED);
    for (PoolDef.Spout s : def.spouts()) {
      open |= s.open() ? 1 << spouts : 0;
      spouts++;
    }
    particles += def.most();
    requestedOpen = open;
    pools.add(pool);
    return pool;
  }

  /**
   * Adds a world whose particles nobody acts on, in {@code setUp}, on both sides: at a client a
   * {@link ParticleWorld.Copy}. The server's is stepped by its game.
   *
   * @throws IllegalStateException if there is one already
   */
  public void follow(ParticleWorld world) {
    if (own != null) {
      throw new IllegalStateException("worlds of particles=2 is more than 1");
    }
    own = world;
  }

  /**
   * Begins: no pool can be added from now on.
   *
   * @param newGround a world of what particles collide with, for these pools alone; null if there
   *     are no pools
   * @param newDrive moves what is on a path for a tick
   * @param moves whether anything is
   */
  public void begin(World<?> newGround, IntConsumer newDrive, boolean moves) {
    begun = true;
    ground = newGround;
    drive = newDrive;
    groundMoves = moves;
    List<ShownParticles> all = new ArrayList<>(own == null ? List.of() : own.particles());
    pools.forEach(pool -> all.add(new ShownParticles(pool.particles(), pool.def().rgb())));
    shown = List.copyOf(all);
  }

  /** Returns whether there are no particles at all: neither pools nor a world of particles. */
  public boolean isEmpty() {
    return pools.isEmpty() && own == null;
  }

  /** Returns whether clients follow a world of particles; what they see of its bodies is older. */
  public boolean followsWorld() {
    return own != null;
  }

  /** Returns all particles, in the order in which pictures draw them; unmodifiable. */
  public List<ShownParticles> shown() {
    return shown;
  }

  /** Returns the number of pools. */
  public int count() {
    return pools.size();
  }

  /** Returns the pool of a number, 0..{@link #count} - 1, in the order of their declarations. */
  public Pool get(int index) {
    return pools.get(index);
  }

  /** Returns the pool of a name, or null. */
  public Pool find(String name) {
    for (Pool pool : pools) {
      if (pool.def().name().equals(name)) {
        return pool;
      }
    }
    return null;
  }

  /** Returns the ticks between an order and its effect. */
  public int delay() {
    return OrderLog.AHEAD * ticksPerPeriod;
  }

  /** Returns the tick that the particles are of. */
  public int tick() {
    return tick;
  }

  /** Returns the rows of orders. For reading only. */
  public OrderLog log() {
    return log;
  }

  int open() {
    return open;
  }

  void request(int spout, boolean on) {
    if (decides) {
      requestedOpen = on ? requestedOpen | 1 << spout : requestedOpen & ~(1 << spout);
    }
  }

  boolean isOrderedOpen(int spout) {
    return (requestedOpen >>> spout & 1) != 0;
  }

  boolean order(int kind, int pool, float x, float y, float radius, float vx, float vy) {
    PoolDef.Rectangle box = pools.get(pool).def().box();
    return decides && OrderLog.add(requests, box, kind, pool, x, y, radius, vx, vy);
  }

  // ---- time

  /**
   * Computes a tick at the server, before bodies are acted on.
   *
   * @param newTick the tick after the last one
   */
  public void step(int newTick) {
    if (!isEmpty()) {
      forces.begin();
      compute(newTick, log.row(newTick / ticksPerPeriod));
    }
  }

  /** Closes a row of orders at the server, if it is time; after bodies were acted on. */
  public void close() {
    if (isEmpty() || tick % ticksPerPeriod != 0) {
      return;
    }
    int period = tick / ticksPerPeriod + OrderLog.AHEAD;
    if (isQuiet(period)) {
      return;
    }
    int[] row = log.begin(period, requestedOpen, particleHash());
    OrderLog.copyOrders(requests, row);
    forces.order(row, pools);
    Arrays.fill(requests, 0);
  }

  /** Returns the row that the last tick of the server closed, or null. */
  public int[] closedRow() {
    boolean closes = !isEmpty() && tick % ticksPerPeriod == 0;
    return closes ? log.row(tick / ticksPerPeriod + OrderLog.AHEAD) : null;
  }

  /** Returns whether nothing happens until a period, so that its row needn't be told. */
  private boolean isQuiet(int period) {
    if (!areStill()
        || forces.areStirring()
        || OrderLog.orders(requests) > 0
        || requestedOpen != open) {
      return false;
    }
    return log.isQuiet(period - OrderLog.AHEAD, period, open);
  }

  private boolean areStill() {
    boolean still = !groundMoves && own == null;
    for (int i = 0; still && i < pools.size(); i++) {
      still = pools.get(i).isStill();
    }
    return still;
  }

  /**
   * Follows the server up to a tick, as far as rows are known; nothing happens until a {@linkplain
   * #restore state} has come.
   *
   * @param newTick the tick that should be reached
   * @param mostSteps most ticks to compute now, so that catching up takes bounded time
   */
  public void follow(int newTick, int mostSteps) {
    for (int left = mostSteps; known && tick < newTick && left > 0; left--) {
      int[] row = log.row((tick + 1) / ticksPerPeriod);
      boolean still = areStill();
      if (row == null && !still && (tick + 1) / ticksPerPeriod > OrderLog.AHEAD) {
        return; // the first periods have no rows
      }
      stillSince = still && stillSince >= 0 ? stillSince : still ? tick : -1;
      compute(tick + 1, row);
      if (tick % ticksPerPeriod == 0) {
        hashes.put(tick / ticksPerPeriod, particleHash());
        compare(tick / ticksPerPeriod);
      }
    }
  }

  /**
   * Takes a row of orders from the server. It may hold anything.
   *
   * @param row {@link OrderLog#WORDS} words
   */
  public void hear(int[] row) {
    int period = OrderLog.period(row);
    if (period < 0 || log.row(period) != null) {
      return;
    }
    boolean isFar = Math.abs(period - tick / ticksPerPeriod) > OrderLog.KEPT / 2;
    if (known && (isFar || period < firstPeriod)) {
      return;
    }
    log.take(row);
    int begin = period * ticksPerPeriod;
    boolean missed = OrderLog.orders(row) > 0 || OrderLog.open(row) != open;
    if (known && begin <= tick && missed) {
      // Still particles are today what they were then, so time can be turned back.
      if (stillSince >= 0 && stillSince < begin) {
        tick = begin - 1;
        hashes.forget();
      } else {
        wrong = true;
      }
    }
    compare(period - OrderLog.AHEAD);
  }

  private void compare(int period) {
    int[] row = log.row(period + OrderLog.AHEAD);
    if (known && row != null && period >= firstPeriod) {
      wrong |= hashes.differs(period, OrderLog.hash(row));
    }
  }

  /**
   * Returns whether a client needs the server's state: it has none, it is wrong, or it is so late
   * that the rows it lacks are gone.
   *
   * @param now the tick that the client predicts
   */
  public boolean needsState(int now) {
    return !isEmpty() && (!known || wrong || now - tick > 12 * ticksPerPeriod);
  }

  /** Returns whether there is a state of the server's to follow. */
  public boolean isKnown() {
    return known;
  }

  private void compute(int newTick, int[] row) {
    boolean begins = newTick % ticksPerPeriod == 0;
    tick = newTick;
    if (row != null) {
      open = begins ? OrderLog.open(row) : open;
      float seconds = newTick % ticksPerPeriod * dt;
      for (int i = 0; i < OrderLog.orders(row); i++) {
        int pool = OrderLog.pool(row, i);
        if (pool < pools.size()) {
          log.read(row, i, pools.get(pool).def().box());
          pools.get(pool).obey(log, seconds, begins);
        }
      }
    }
    if (groundMoves) {
      drive.accept(newTick);
    }
    for (Pool pool : pools) {
      pool.step(ground, groundMoves, newTick, dt);
    }
    if (own instanceof ParticleWorld.Copy) {
      ((ParticleWorld.Copy) own).step();
    }
  }

  // ---- bodies

  /**
   * Tells where particles move so fast at a tick that bodies must stay awake there.
   *
   * @param out receives the box, metres
   * @return false if there is no such place
   */
  public boolean readMoving(int index, int atTick, Aabb out) {
    PoolGrid grid = pools.get(index).grid(atTick);
    if (!known || grid.minX > grid.maxX) {
      return false;
    }
    out.set(grid.minX, grid.minY, grid.maxX, grid.maxY);
    return true;
  }

  /**
   * Lifts, brakes and carries an awake body along in the next step, and notes at the server that it
   * stirs.
   *
   * @param world the body's world
   * @param body the body
   * @param atTick the tick that the next step computes
   * @param kind number of the body's archetype
   * @param shapes the archetype's shapes
   * @param reach radius of a circle around the body's origin that holds them, m
   */
  public void act(
      World<?> world, Body<?> body, int atTick, int kind, List<Shape> shapes, float reach) {
    for (int i = 0; known && i < pools.size(); i++) {
      PoolDef def = pools.get(i).def();
      PoolDef.Rectangle box = def.box();
      if (body.x() > box.minX() - reach
          && body.x() < box.maxX() + reach
          && body.y() > box.minY() - reach
          && body.y() < box.maxY() + reach) {
        boolean notes = decides && tick % ticksPerPeriod == 0;
        forces.act(world, body, i, def, pools.get(i).grid(atTick), kind, shapes, dt, notes);
      }
    }
  }

  // ---- state

  private int particleHash() {
    long h = 0;
    for (int i = 0; i < shown.size(); i++) {
      h = h * 31 + shown.get(i).particles().stateHash();
    }
    return (int) (h ^ h >>> 32);
  }

  /** Returns 64 bits of everything that decides the future of the pools. */
  public long stateHash() {
    long h = tick * 31L + open;
    h = h * 31 + requestedOpen;
    for (int word : requests) {
      h = h * 31 + word;
    }
    for (Pool pool : pools) {
      h = h * 31 + pool.particles().stateHash();
      h = h * 31 + pool.stillTicks();
    }
    return log.hash(h, tick / ticksPerPeriod);
  }

  /**
   * Saves the state.
   *
   * @param reuse a state of these pools to overwrite, or null for a new one
   */
  public PoolsState save(PoolsState reuse) {
    PoolsState s = reuse == null ? new PoolsState(pools.size()) : reuse;
    s.tick = tick;
    s.open = open;
    s.requestedOpen = requestedOpen;
    s.copyRequests(requests);
    s.log.copy(log);
    s.own = own == null ? null : own.save(s.own);
    for (int i = 0; i < pools.size(); i++) {
      s.particles[i] = pools.get(i).particles().save(s.particles[i]);
      s.copyStill(i, pools.get(i).stillTicks());
    }
    return s;
  }

  /**
   * Takes over a saved state. A client keeps the rows that it has heard since.
   *
   * @param s a state of these pools
   */
  public void restore(PoolsState s) {
    tick = s.tick;
    open = s.open;
    requestedOpen = s.requestedOpen;
    System.arraycopy(s.requests, 0, requests, 0, requests.length);
    if (decides) {
      log.copy(s.log);
    } else {
      log.add(s.log, tick / ticksPerPeriod);
    }
    for (int i = 0; i < pools.size(); i++) {
      pools.get(i).particles().restore(s.particles[i]);
      pools.get(i).restored(tick, s.stillTicks[i]);
    }
    if (own instanceof ParticleWorld.Copy) {
      ((ParticleWorld.Copy) own).restore(s.own);
    }
    known = true;
    wrong = false;
    stillSince = -1;
    firstPeriod = tick / ticksPerPeriod + 1;
    hashes.forget();
  }

  /**
   * Reads a state that {@link PoolsState#write} wrote, for {@link #restore}. It trusts nothing and
   * changes nothing here.
   *
   * @throws ArchiveException if the bytes are damaged or of other pools
   */
  public PoolsState read(ArchiveReader archive) {
    PoolsState s = PoolsState.read(this, archive);
    s.own = own instanceof ParticleWorld.Copy ? ((ParticleWorld.Copy) own).read(archive) : null;
    return s;
  }

  @Override
  public String toString() {
    return "pools=" + pools.size() + " tick=" + tick + " rate=" + tickRate;
  }
}
