package carom.physics.particles;

import carom.physics.Filter;
import carom.physics.math.Limits;

/**
 * Definition of particles: their kind and properties. It is mutable, fluent and reusable; {@link
 * Particles} copies it. All particles of one {@link Particles} have the same definition.
 *
 * <pre>
 *   new ParticleDef(ParticleDef.Kind.WATER, 0.1f).density(1000).viscosity(2)
 * </pre>
 */
public final class ParticleDef {
  /** Kind of interaction between particles. */
  public enum Kind {
    /** An incompressible fluid: the density may be that of rest or lower. */
    WATER,
    /** Grains: discs with the spacing as diameter, with friction between them. */
    SAND
  }

  /** Largest number of particles. */
  public static final int MAX_COUNT = 1_000_000;

  final Kind kind;
  final float spacing;
  float density = 1;
  float viscosity;
  float cohesion;
  float friction;
  float gravityScale = 1;
  float lifetime = Float.POSITIVE_INFINITY;
  Filter filter = Filter.DEFAULT;
  boolean twoWay = true;
  int maxCount = 10_000;
  int substeps = 4;

  /**
   * Creates a definition with density 1: water of viscosity 2 without friction, or sand of friction
   * 0.6.
   *
   * @param kind kind of interaction
   * @param spacing side of the square whose area one particle has, and its diameter against bodies
   *     and other grains; 0.01 to 100 m
   */
  public ParticleDef(Kind kind, float spacing) {
    if (kind == null) {
      throw new IllegalArgumentException("kind=null must be WATER or SAND");
    }
    this.kind = kind;
    this.spacing = Limits.range("spacing", spacing, 0.01f, 100);
    viscosity = kind == Kind.WATER ? 2 : 0;
    friction = kind == Kind.WATER ? 0 : 0.6f;
  }

  /**
   * Sets the density; default 1, like that of bodies. A particle has the mass {@code density *
   * spacing^2}.
   *
   * @param kgPerSquareMetre density, 1e-3 to 1e6 kg/m^2
   * @return this
   */
  public ParticleDef density(float kgPerSquareMetre) {
    density = Limits.range("density", kgPerSquareMetre, 1e-3f, 1e6f);
    return this;
  }

  /**
   * Sets how quickly neighbours approach a common velocity.
   *
   * @param perSecond rate, 1/s, 0 to 1e4
   * @return this
   */
  public ParticleDef viscosity(float perSecond) {
    viscosity = Limits.range("viscosity", perSecond, 0, 1e4f);
    return this;
  }

  /**
   * Sets how strongly neighbours attract each other, which forms drops; default 0.
   *
   * @param acceleration greatest acceleration of a pair, m/s^2, 0 to 1e3; about 20 is like small
   *     amounts of water
   * @return this
   */
  public ParticleDef cohesion(float acceleration) {
    cohesion = Limits.range("cohesion", acceleration, 0, 1e3f);
    return this;
  }

  /**
   * Sets the friction between grains, and between particles and bodies. Against a body, it is the
   * geometric mean with the body's.
   *
   * @param coefficient coefficient of friction, 0 to 10
   * @return this
   */
  public ParticleDef friction(float coefficient) {
    friction = Limits.range("friction", coefficient, 0, 10);
    return this;
  }

  /**
   * Sets the factor on the world's gravity; default 1.
   *
   * @param factor factor, within 1e3; with a negative one, particles rise
   * @return this
   */
  public ParticleDef gravityScale(float factor) {
    gravityScale = Limits.range("gravityScale", factor, -1e3f, 1e3f);
    return this;
  }

  /**
   * Sets the lifetime of a particle; default infinite.
   *
   * @param seconds lifetime, s, above 0; infinity for ever
   * @return this
   */
  public ParticleDef lifetime(float seconds) {
    lifetime = Limits.range("lifetime", seconds, Float.MIN_VALUE, Float.POSITIVE_INFINITY);
    return this;
  }

  /**
   * Sets which shapes the particles collide with; default all. They never collide with sensors.
   *
   * @param newFilter category, mask and group of the particles
   * @return this
   */
  public ParticleDef filter(Filter newFilter) {
    if (newFilter == null) {
      throw new IllegalArgumentException("filter=null; Filter.DEFAULT meets everything");
    }
    filter = newFilter;
    return this;
  }

  /**
   * Sets whether particles push bodies; default true. One-way coupling suits decoration that must
   * not influence a game.
   *
   * @param both false for one-way coupling
   * @return this
   */
  public ParticleDef twoWay(boolean both) {
    twoWay = both;
    return this;
  }

  /**
   * Sets the largest number of particles at a time; default 10,000. Particles added beyond it are
   * dropped.
   *
   * @param count largest number, 1 to {@link #MAX_COUNT}
   * @return this
   */
  public ParticleDef maxCount(int count) {
    if (count < 1 || count > MAX_COUNT) {
      throw new IllegalArgumentException("maxCount=" + count + " is outside 1.." + MAX_COUNT);
    }
    maxCount = count;
    return this;
  }

  /**
   * Sets the number of substeps in a step; default 4. The compression at the bottom of a pool falls
   * with its square, and the cost rises in proportion.
   *
   * @param count number of substeps, 1 to 16
   * @return this
   */
  public ParticleDef substeps(int count) {
    if (count < 1 || count > 16) {
      throw new IllegalArgumentException("substeps=" + count + " is outside 1..16");
    }
    substeps = count;
    return this;
  }

  ParticleDef copy() {
    ParticleDef d = new ParticleDef(kind, spacing);
    d.density = density;
    d.viscosity = viscosity;
    d.cohesion = cohesion;
    d.friction = friction;
    d.gravityScale = gravityScale;
    d.lifetime = lifetime;
    d.filter = filter;
    d.twoWay = twoWay;
    d.maxCount = maxCount;
    d.substeps = substeps;
    return d;
  }
}
