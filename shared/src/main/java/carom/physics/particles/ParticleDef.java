package carom.physics.particles;

import carom.physics.Filter;
import carom.physics.math.Limits;

/**
 * What particles are made of; mutable, fluent, reusable. {@link Particles} copies what it needs.
 * All particles of one {@link Particles} are of one kind.
 *
 * <pre>
 *   new ParticleDef(ParticleDef.Kind.WATER, 0.1f).density(1000).viscosity(2)
 * </pre>
 */
public final class ParticleDef {
  /** How particles hold each other off. */
  public enum Kind {
    /** An incompressible fluid: as many particles per area as at rest, or fewer. */
    WATER,
    /** Grains: discs of the spacing's diameter that rub against each other. */
    SAND
  }

  /** Most particles there can be. */
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
   * Water of viscosity 2, without friction, or sand of friction 0.6; density 1.
   *
   * @param kind how they hold each other off
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
   * Sets the density; default 1, as that of bodies. A particle weighs {@code density * spacing^2}.
   *
   * @param kgPerSquareMetre kg/m^2, 1e-3 to 1e6
   * @return this
   */
  public ParticleDef density(float kgPerSquareMetre) {
    density = Limits.range("density", kgPerSquareMetre, 1e-3f, 1e6f);
    return this;
  }

  /**
   * Sets how quickly neighbours come to a common velocity.
   *
   * @param perSecond 1/s, 0 to 1e4
   * @return this
   */
  public ParticleDef viscosity(float perSecond) {
    viscosity = Limits.range("viscosity", perSecond, 0, 1e4f);
    return this;
  }

  /**
   * Sets how strongly neighbours attract each other, which makes drops; default 0.
   *
   * @param acceleration greatest of a pair, m/s^2, 0 to 1e3; about 20 is water in the small
   * @return this
   */
  public ParticleDef cohesion(float acceleration) {
    cohesion = Limits.range("cohesion", acceleration, 0, 1e3f);
    return this;
  }

  /**
   * Sets the friction: of grains on each other, and of particles on bodies, there as the geometric
   * mean with the body's.
   *
   * @param coefficient 0 to 10
   * @return this
   */
  public ParticleDef friction(float coefficient) {
    friction = Limits.range("friction", coefficient, 0, 10);
    return this;
  }

  /**
   * Sets the factor on the world's gravity; default 1.
   *
   * @param factor negative rises; within 1e3
   * @return this
   */
  public ParticleDef gravityScale(float factor) {
    gravityScale = Limits.range("gravityScale", factor, -1e3f, 1e3f);
    return this;
  }

  /**
   * Sets how long a particle lasts; default for ever.
   *
   * @param seconds s, above 0; infinity for ever
   * @return this
   */
  public ParticleDef lifetime(float seconds) {
    lifetime = Limits.range("lifetime", seconds, Float.MIN_VALUE, Float.POSITIVE_INFINITY);
    return this;
  }

  /**
   * Sets which shapes the particles meet; default all. Sensors are never met.
   *
   * @param newFilter the particles' category, mask and group
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
   * Sets whether particles push bodies; default true. If not they only feel them, which is cheaper
   * to think about: decoration that must not influence a game.
   *
   * @param both false for one-way coupling
   * @return this
   */
  public ParticleDef twoWay(boolean both) {
    twoWay = both;
    return this;
  }

  /**
   * Sets how many there can be at a time; default 10,000. What is added beyond is dropped.
   *
   * @param count 1 to {@link #MAX_COUNT}
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
   * Sets into how many substeps a step is divided; default 4. Compression at the bottom of a pool
   * falls with the square, cost rises in proportion.
   *
   * @param count 1 to 16
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
