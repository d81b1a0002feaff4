package carom.physics.particles;

import carom.physics.World;
import carom.physics.archive.ArchiveReader;
import carom.physics.geometry.Shape;
import carom.physics.math.Aabb;
import carom.physics.math.Limits;
import carom.physics.math.Transform;

/**
 * A system of many small particles of one kind, water or sand. The particles move on their own,
 * keep their distance from each other, and collide with a world's bodies.
 *
 * <pre>
 *   Particles water = new Particles(new ParticleDef(ParticleDef.Kind.WATER, 0.1f));
 *   water.fill(new Box(2, 1), new Transform(0, 1, 0), 0, 0);
 *   ...
 *   water.step(world, dt); // then:
 *   world.step(dt);
 * </pre>
 *
 * <p><b>Model.</b> Position-based dynamics in substeps (M&uuml;ller and others 2007; Macklin and
 * others 2019): positions are corrected until constraints hold, and every correction divided by the
 * substep is also a change of velocity. Water: a particle's density, the sum of {@code (1 - r /
 * h)^2} over its neighbours, may not exceed that of rest (Macklin and M&uuml;ller 2013, with one
 * kernel for density and gradient). Sand: grains may not overlap, with friction by Coulomb's law
 * (Macklin and others 2014). Corrections of a pair are opposite, so momentum is conserved up to
 * rounding.
 *
 * <p><b>Bodies.</b> A particle is a disc of the spacing's diameter. It is moved out of bodies along
 * their surface's normal, never bounces, and never passes through a wall however fast it is. Bodies
 * are pushed back, unless {@link ParticleDef#twoWay} is false, by one impulse per step that takes
 * effect in the next {@code World.step}. That is the reason for the order above. Bodies that touch
 * particles stay awake.
 *
 * <p><b>Order and ids.</b> Every step sorts particles 0 to count() - 1 by position, so keep the id
 * of a particle to find it again. Equal calls in equal order give equal bits.
 *
 * <p>Particles are not part of a world's state: save and restore both. Use them from one thread at
 * a time. A steady step allocates nothing. At 10,000 particles, a step with four substeps costs a
 * few milliseconds.
 */
public final class Particles {
  /** Result of {@link #add} when there is no room for another particle. */
  public static final long NONE = -1;

  private final ParticleDef def;
  private final ParticleStore store;
  private final Neighbours neighbours = new Neighbours();
  private final ParticleContacts contacts = new ParticleContacts();
  private final PairSolver pairs;
  private float[] oldX = new float[0];
  private float[] oldY = new float[0];

  /**
   * Creates an empty particle system.
   *
   * @param def definition of the particles, copied
   */
  public Particles(ParticleDef def) {
    this.def = Limits.notNull("def", def).copy();
    store = new ParticleStore(Math.min(def.maxCount, 256));
    pairs = def.kind == ParticleDef.Kind.WATER ? new Water(this.def) : new Sand(this.def);
  }

  /**
   * Returns the number of particles.
   *
   * @return 0 or more
   */
  public int count() {
    return store.count;
  }

  /**
   * Returns the kind of all particles.
   *
   * @return water or sand
   */
  public ParticleDef.Kind kind() {
    return def.kind;
  }

  /**
   * Returns a particle's diameter.
   *
   * @return m
   */
  public float spacing() {
    return def.spacing;
  }

  /**
   * Returns the mass of a particle.
   *
   * @return kg
   */
  public float mass() {
    return def.density * def.spacing * def.spacing;
  }

  /**
   * Adds a particle.
   *
   * @param x x, m, within 32,768 of the origin
   * @param y y, m, within 32,768 of the origin
   * @param vx velocity along x, m/s, within 1e5
   * @param vy velocity along y, m/s, within 1e5
   * @return its id, or {@link #NONE} if the largest number is reached
   */
  public long add(float x, float y, float vx, float vy) {
    Limits.position("x", x);
    Limits.position("y", y);
    Limits.velocity("vx", vx);
    Limits.velocity("vy", vy);
    return store.count < def.maxCount ? store.add(x, y, vx, vy, def.maxCount) : NONE;
  }

  /**
   * Fills a shape with particles at rest density, in rows.
   *
   * @param area the shape
   * @param at pose of the shape, read only
   * @param vx velocity of the particles along x, m/s
   * @param vy velocity of the particles along y, m/s
   * @return the number of particles added, which the largest number may limit
   */
  public int fill(Shape area, Transform at, float vx, float vy) {
    Aabb box = new Aabb();
    Limits.notNull("area", area).aabb(Limits.notNull("at", at), box);
    Limits.position("minX", box.minX);
    Limits.position("minY", box.minY);
    Limits.position("maxX", box.maxX);
    Limits.position("maxY", box.maxY);
    Limits.velocity("vx", vx);
    Limits.velocity("vy", vy);
    float pitch = pairs.pitch();
    float rise = pitch * HALF_ROOT_3;
    int rows = (int) (box.height() / rise);
    int columns = (int) (box.width() / pitch);
    int before = store.count;
    for (int row = 0; row <= rows && store.count < def.maxCount; row++) {
      float y = box.minY + 0.5f * (box.height() - rows * rise) + row * rise;
      float left = box.minX + 0.25f * pitch + (row % 2) * 0.5f * pitch;
      for (int column = 0; column <= columns; column++) {
        float x = left + column * pitch;
        if (area.containsPoint(at, x, y)) {
          add(x, y, vx, vy);
        }
      }
    }
    return store.count - before;
  }

  private static final float HALF_ROOT_3 = 0.8660254f;

  /**
   * Removes a particle.
   *
   * @param id id from {@link #add} or {@link #id}
   * @return false if it was gone already
   */
  public boolean remove(long id) {
    int gone = store.indexOf(id);
    if (gone < 0) {
      return false;
    }
    store.release(gone);
    for (int i = gone + 1; i < store.count; i++) {
      store.move(i, i - 1);
    }
    store.count--;
    return true;
  }

  /**
   * Removes the particles whose centre is in a box, borders included.
   *
   * @param area m, read only
   * @return the number of particles removed
   */
  public int removeInside(Aabb area) {
    Limits.notNull("area", area);
    int kept = 0;
    for (int i = 0; i < store.count; i++) {
      if (area.contains(store.x[i], store.y[i])) {
        store.release(i);
      } else {
        store.move(i, kept++);
      }
    }
    return shrink(kept);
  }

  /**
   * Removes the particles whose centre is outside a box.
   *
   * @param area m, read only
   * @return the number of particles removed
   */
  public int removeOutside(Aabb area) {
    Limits.notNull("area", area);
    int kept = 0;
    for (int i = 0; i < store.count; i++) {
      if (area.contains(store.x[i], store.y[i])) {
        store.move(i, kept++);
      } else {
        store.release(i);
      }
    }
    return shrink(kept);
  }

  /**
   * Removes the particles whose centre is in a shape, borders included.
   *
   * @param area the shape
   * @param at pose of the shape, read only
   * @return the number of particles removed
   */
  public int removeInside(Shape area, Transform at) {
    Limits.notNull("area", area);
    Limits.notNull("at", at);
    int kept = 0;
    for (int i = 0; i < store.count; i++) {
      if (area.containsPoint(at, store.x[i], store.y[i])) {
        store.release(i);
      } else {
        store.move(i, kept++);
      }
    }
    return shrink(kept);
  }

  /** Removes all particles. Their ids stay invalid. */
  public void clear() {
    for (int i = 0; i < store.count; i++) {
      store.release(i);
    }
    store.count = 0;
  }

  private int shrink(int kept) {
    int gone = store.count - kept;
    store.count = kept;
    return gone;
  }

  /**
   * Returns the index of a particle.
   *
   * @param id id from {@link #add} or {@link #id}
   * @return 0 to count() - 1, valid until the next step, addition or removal; -1 if the particle is
   *     gone
   */
  public int indexOf(long id) {
    return store.indexOf(id);
  }

  /**
   * Returns the id of a particle, which it keeps for life.
   *
   * @param i below {@link #count}
   * @return its id
   */
  public long id(int i) {
    return store.id(check(i));
  }

  /**
   * Returns the x of a particle's centre.
   *
   * @param i below {@link #count}
   * @return x, m
   */
  public float x(int i) {
    return store.x[check(i)];
  }

  /**
   * Returns the y of a particle's centre.
   *
   * @param i below {@link #count}
   * @return y, m
   */
  public float y(int i) {
    return store.y[check(i)];
  }

  /**
   * Returns a particle's velocity along x.
   *
   * @param i below {@link #count}
   * @return x, m/s
   */
  public float velocityX(int i) {
    return store.vx[check(i)];
  }

  /**
   * Returns a particle's velocity along y.
   *
   * @param i below {@link #count}
   * @return y, m/s
   */
  public float velocityY(int i) {
    return store.vy[check(i)];
  }

  /**
   * Sets a particle's velocity.
   *
   * @param i below {@link #count}
   * @param vx velocity along x, m/s, within 1e5
   * @param vy velocity along y, m/s, within 1e5
   */
  public void setVelocity(int i, float vx, float vy) {
    check(i);
    Limits.velocity("vx", vx);
    Limits.velocity("vy", vy);
    store.vx[i] = vx;
    store.vy[i] = vy;
  }

  /**
   * Returns the age of a particle.
   *
   * @param i below {@link #count}
   * @return s
   */
  public float age(int i) {
    return store.age[check(i)];
  }

  /**
   * Copies the centres of all particles, for drawing.
   *
   * @param xy receives x0, y0, x1, y1, ..., 2 count() floats
   * @return count()
   * @throws IllegalArgumentException if the array is too short
   */
  public int copyPositions(float[] xy) {
    if (Limits.notNull("xy", xy).length < 2 * store.count) {
      throw new IllegalArgumentException(
          "xy.length=" + xy.length + " must be at least 2 count()=" + 2 * store.count);
    }
    for (int i = 0; i < store.count; i++) {
      xy[2 * i] = store.x[i];
      xy[2 * i + 1] = store.y[i];
    }
    return store.count;
  }

  private int check(int i) {
    return Limits.index("particle", i, store.count);
  }

  /**
   * Advances the particles by one tick, and pushes the bodies they touch. Call it before {@code
   * World.step}, outside of callbacks and queries.
   *
   * @param world world whose bodies and gravity act on the particles; only its bodies' pending
   *     impulses change
   * @param dtSeconds length of the tick, s, more than 0, at most 0.1; use the world's
   */
  public void step(World<?> world, float dtSeconds) {
    Limits.timeStep(dtSeconds);
    Limits.notNull("world", world).refuseDuringQuery("step");
    retire(dtSeconds);
    if (store.count == 0) {
      return;
    }
    if (oldX.length < store.capacity()) {
      oldX = new float[store.capacity()];
      oldY = new float[store.capacity()];
    }
    float gx = def.gravityScale * world.gravityX();
    float gy = def.gravityScale * world.gravityY();
    neighbours.find(store, 0.5f * dtSeconds, pairs.reach());
    contacts.find(world, store, def, gx, gy, dtSeconds);
    pairs.begin(store, neighbours, dtSeconds);
    float h = dtSeconds / def.substeps;
    for (int i = 0; i < def.substeps; i++) {
      move(gx * h, gy * h, h);
      contacts.bodies.move(world.gravityX(), world.gravityY(), h);
      pairs.solve(store, neighbours, h);
      contacts.confine(store);
      contacts.solve(store, oldX, oldY, h);
    }
    contacts.bodies.end();
  }

  private void move(float dvx, float dvy, float h) {
    int n = store.count;
    float[] x = store.x;
    float[] y = store.y;
    float[] vx = store.vx;
    float[] vy = store.vy;
    for (int i = 0; i < n; i++) {
      oldX[i] = x[i];
      oldY[i] = y[i];
      vx[i] += dvx;
      vy[i] += dvy;
      x[i] += vx[i] * h;
      y[i] += vy[i] * h;
    }
  }

  /**
   * Removes particles that are too old, and those too far away or too fast for the number range.
   */
  private void retire(float dt) {
    int kept = 0;
    for (int i = 0; i < store.count; i++) {
      store.age[i] += dt;
      boolean here =
          Math.abs(store.x[i]) + Math.abs(store.y[i]) < Limits.MAX_POSITION
              && Math.abs(store.vx[i]) + Math.abs(store.vy[i]) < 3 * Limits.MAX_VELOCITY;
      if (here && store.age[i] <= def.lifetime) {
        store.move(i, kept++);
      } else {
        store.release(i);
      }
    }
    store.count = kept;
  }

  /**
   * Saves the state.
   *
   * @param reuseOrNull a state of these particles to overwrite, or null for a new one
   * @return the state
   */
  public ParticleState save(ParticleState reuseOrNull) {
    ParticleState s = reuseOrNull == null ? new ParticleState(this) : reuseOrNull;
    checkOwner(s);
    s.store.copy(store);
    return s;
  }

  /**
   * Restores a saved state, bit for bit.
   *
   * @param s a state that {@link #save} of these particles made; it stays as it is
   */
  public void restore(ParticleState s) {
    checkOwner(Limits.notNull("s", s));
    store.copy(s.store);
  }

  /**
   * Reads a state that {@link ParticleState#write} wrote, of particles with an equal definition,
   * for {@link #restore}. It trusts nothing and leaves these particles as they are.
   *
   * @param archive archive at the start of the state, which is read to its end
   * @return the state, of these particles
   * @throws carom.physics.archive.ArchiveException if the bytes are damaged
   */
  public ParticleState read(ArchiveReader archive) {
    Limits.notNull("archive", archive);
    ParticleState s = new ParticleState(this);
    s.store.pass(archive, most());
    return s;
  }

  int most() {
    return def.maxCount;
  }

  private void checkOwner(ParticleState s) {
    if (s.owner != this) {
      throw new IllegalArgumentException(
          "the state was saved by other particles; restore it there");
    }
  }

  /**
   * Returns a 64-bit hash of positions, velocities, ages, ids and their order. Two systems of equal
   * definitions with equal hashes behave equally in equal worlds.
   *
   * @return the hash
   */
  public long stateHash() {
    return store.hash();
  }
}
