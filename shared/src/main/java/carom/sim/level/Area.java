package carom.sim.level;

import carom.physics.World;
import carom.physics.effects.AreaEffect;
import carom.physics.effects.Attractor;
import carom.physics.effects.Attractor.Falloff;
import carom.physics.effects.Buoyancy;
import carom.physics.effects.Effect;
import carom.physics.effects.Wind;
import carom.physics.math.Aabb;
import carom.physics.math.Limits;

/**
 * A part of the world that acts on the bodies in it: water, wind, another gravity, drag, or a point
 * that attracts. A level has areas that stay where they are, and an {@linkplain ArchetypeDef#area
 * archetype} may have one that its entities carry along.
 *
 * <p>Server and client compute what areas do, so clients predict it. Immutable: the methods that
 * change something return a changed copy.
 *
 * <pre>{@code
 * Area lake = Area.water(-20, -8, 20, 0, 1).drag(2, 1).flow(0.5f, 0);
 * Area fan = Area.wind(0, -1, 6, 1, 12, 0, 2);        // in the frame of the body that carries it
 * Area magnet = Area.attractor(0, 0, 8, 30).onlyTag(METAL);
 * }</pre>
 */
public final class Area implements Cloneable {
  /** The effect of an area. */
  public enum Kind {
    /** A fluid that lifts, brakes and carries. */
    WATER,
    /** Air that moves, and takes bodies along. */
    WIND,
    /** A gravity of its own. */
    GRAVITY,
    /** A thick substance, such as mud, that brakes. */
    DRAG,
    /** A point that attracts or repels. */
    ATTRACTOR
  }

  /** Value of {@link #tag} of an area that acts on every body. */
  public static final int ANY_TAG = -1;

  private final Kind kind;
  private final float minX;
  private final float minY;
  private final float maxX;
  private final float maxY;
  private String name = "";
  private int tag = ANY_TAG;
  private int rgb;
  private float density;
  private float x;
  private float y;
  private float rate;
  private float angularRate;

  /** True if a wind acts on edges, with the rates as its coefficients of drag and lift. */
  private boolean edges;

  private float strength;
  private float swirl;
  private Falloff falloff = Falloff.CONSTANT;
  private float core;

  private Area(Kind kind, float minX, float minY, float maxX, float maxY, int rgb) {
    if (!(minX < maxX && minY < maxY)) {
      throw new IllegalArgumentException(
          String.format(
              java.util.Locale.ROOT,
              "max=[%s, %s] must be right of and above min=[%s, %s]",
              maxX,
              maxY,
              minX,
              minY));
    }
    this.kind = kind;
    this.minX = Limits.coordinate("minX", minX);
    this.minY = Limits.coordinate("minY", minY);
    this.maxX = Limits.coordinate("maxX", maxX);
    this.maxY = Limits.coordinate("maxY", maxY);
    this.rgb = rgb;
  }

  /**
   * Returns a rectangle of water that is at rest. Its upper edge is the surface, and it stays
   * upright when it is carried. Bodies of less than its density float.
   *
   * @param minX left edge, metres
   * @param minY lower edge, metres
   * @param maxX right edge, metres
   * @param maxY upper edge, metres
   * @param density kg/m^2, 0..1e6
   */
  public static Area water(float minX, float minY, float maxX, float maxY, float density) {
    Area area = new Area(Kind.WATER, minX, minY, maxX, maxY, 0x3a86c8);
    area.density = Limits.range("density", density, 0, 1e6f);
    return area.drag(1, 1);
  }

  /**
   * Returns a rectangle of wind. In each tick the difference between a body's velocity and the
   * wind's shrinks by {@code 1 / (1 + rate dt)}. Carried, it turns with the body.
   *
   * @param minX left edge, metres
   * @param minY lower edge, metres
   * @param maxX right edge, metres
   * @param maxY upper edge, metres
   * @param vx velocity of the air, m/s
   * @param vy velocity of the air, m/s
   * @param rate how strongly it takes bodies along, 1/s, 0..1e4
   */
  public static Area wind(
      float minX, float minY, float maxX, float maxY, float vx, float vy, float rate) {
    Area area = new Area(Kind.WIND, minX, minY, maxX, maxY, 0xcfe8ff);
    area.x = Limits.velocity("vx", vx);
    area.y = Limits.velocity("vy", vy);
    area.rate = Limits.range("rate", rate, 0, 1e4f);
    return area;
  }

  /**
   * Returns a rectangle with a gravity of its own, which replaces the world's. Where several
   * overlap, their differences from the world's gravity add up. Carried, it doesn't turn.
   *
   * @param minX left edge, metres
   * @param minY lower edge, metres
   * @param maxX right edge, metres
   * @param maxY upper edge, metres
   * @param gx gravity, m/s^2, within 1e4
   * @param gy gravity, m/s^2, within 1e4
   */
  public static Area gravity(float minX, float minY, float maxX, float maxY, float gx, float gy) {
    Area area = new Area(Kind.GRAVITY, minX, minY, maxX, maxY, 0xb388eb);
    area.x = Limits.range("gx", gx, -1e4f, 1e4f);
    area.y = Limits.range("gy", gy, -1e4f, 1e4f);
    return area;
  }

  /**
   * Returns a rectangle that brakes like mud: velocities shrink by {@code 1 / (1 + rate dt)} in
   * each tick.
   *
   * @param minX left edge, metres
   * @param minY lower edge, metres
   * @param maxX right edge, metres
   * @param maxY upper edge, metres
   * @param rate rate for the velocity, 1/s, 0..1e4
   * @param angularRate rate for the angular velocity, 1/s, 0..1e4
   */
  public static Area drag(
      float minX, float minY, float maxX, float maxY, float rate, float angularRate) {
    return new Area(Kind.DRAG, minX, minY, maxX, maxY, 0x8d6e4a).drag(rate, angularRate);
  }

  /**
   * Returns a point that attracts bodies of any mass equally strongly at every distance up to its
   * range.
   *
   * @param x the point, metres
   * @param y the point, metres
   * @param range metres, 0.05..1e6
   * @param strength acceleration, m/s^2, within 1e5; negative repels
   */
  public static Area attractor(float x, float y, float range, float strength) {
    Limits.range("range", range, 0.05f, 1e6f);
    Area area = new Area(Kind.ATTRACTOR, x - range, y - range, x + range, y + range, 0xef476f);
    area.x = x;
    area.y = y;
    area.strength = Limits.range("strength", strength, -1e5f, 1e5f);
    return area.falloff(Falloff.CONSTANT, 0.01f * range);
  }

  /** Returns this area with a name, for people. */
  public Area named(String newName) {
    Area area = copy();
    area.name = Limits.notNull("name", newName);
    return area;
  }

  /** Returns this area in another colour, 0xRRGGBB. */
  public Area colored(int newRgb) {
    Area area = copy();
    area.rgb = newRgb;
    return area;
  }

  /**
   * Returns this area so that it acts only on entities of {@linkplain Archetype#tag archetypes with
   * a tag}.
   *
   * @param onlyTag the tag, or {@link #ANY_TAG}
   */
  public Area onlyTag(int onlyTag) {
    Area area = copy();
    area.tag = onlyTag;
    return area;
  }

  /**
   * Returns this water or drag with other rates at which bodies take on its velocity.
   *
   * @param newRate 1/s, 0..1e4
   * @param newAngularRate for the rotation, 1/s, 0..1e4
   * @throws IllegalStateException for another kind
   */
  public Area drag(float newRate, float newAngularRate) {
    require(kind == Kind.WATER || kind == Kind.DRAG, "drag");
    Area area = copy();
    area.rate = Limits.range("drag", newRate, 0, 1e4f);
    area.angularRate = Limits.range("angularDrag", newAngularRate, 0, 1e4f);
    return area;
  }

  /**
   * Returns this wind so that it acts on the edges of shapes, by {@link Wind}: it turns sails and
   * lifts kites. Its rate then means nothing.
   *
   * @param newDrag coefficient, 0..1000
   * @param newLift coefficient, 0..1000
   * @throws IllegalStateException for another kind
   */
  public Area onEdges(float newDrag, float newLift) {
    require(kind == Kind.WIND, "onEdges");
    Area area = copy();
    area.edges = true;
    area.rate = Limits.range("drag", newDrag, 0, 1000);
    area.angularRate = Limits.range("lift", newLift, 0, 1000);
    return area;
  }

  /**
   * Returns this water with a flow, which acts through its drag.
   *
   * @param vx velocity, m/s
   * @param vy velocity, m/s
   * @throws IllegalStateException for another kind
   */
  public Area flow(float vx, float vy) {
    require(kind == Kind.WATER, "flow");
    Area area = copy();
    area.x = Limits.velocity("flowX", vx);
    area.y = Limits.velocity("flowY", vy);
    return area;
  }

  /**
   * Returns this attractor with an acceleration around the point.
   *
   * @param acceleration m/s^2, counterclockwise, within 1e5
   * @throws IllegalStateException for another kind
   */
  public Area swirl(float acceleration) {
    require(kind == Kind.ATTRACTOR, "swirl");
    Area area = copy();
    area.swirl = Limits.range("swirl", acceleration, -1e5f, 1e5f);
    return area;
  }

  /**
   * Returns this attractor with another law.
   *
   * @param law how the acceleration depends on the distance
   * @param newCore distance within which it falls to nothing, metres, 1e-4 to the range
   * @throws IllegalStateException for another kind
   */
  public Area falloff(Falloff law, float newCore) {
    require(kind == Kind.ATTRACTOR, "falloff");
    Area area = copy();
    area.falloff = law;
    area.core = Limits.range("core", newCore, 1e-4f, range());
    return area;
  }

  private void require(boolean holds, String what) {
    if (!holds) {
      throw new IllegalStateException(what + " is no property of an area of kind " + kind);
    }
  }

  private Area copy() {
    try {
      return (Area) clone();
    } catch (CloneNotSupportedException e) {
      throw new AssertionError(e);
    }
  }

  /** Returns what the area does. */
  public Kind kind() {
    return kind;
  }

  /** Returns the name, for people; empty if it has none. */
  public String name() {
    return name;
  }

  /** Returns the tag of the archetypes it acts on, or {@link #ANY_TAG}. */
  public int tag() {
    return tag;
  }

  /** Returns the colour, 0xRRGGBB. */
  public int rgb() {
    return rgb;
  }

  /** Returns the left edge, metres. */
  public float minX() {
    return minX;
  }

  /** Returns the lower edge, metres. */
  public float minY() {
    return minY;
  }

  /** Returns the right edge, metres. */
  public float maxX() {
    return maxX;
  }

  /** Returns the upper edge, metres. */
  public float maxY() {
    return maxY;
  }

  /** Returns the range of an attractor, or half of the width of another area, metres. */
  public float range() {
    return (maxX - minX) / 2;
  }

  /** Returns the x component of the flow, wind or gravity, or the x of the attractor's point. */
  public float x() {
    return x;
  }

  /** Returns the y component of the flow, wind or gravity, or the y of the attractor's point. */
  public float y() {
    return y;
  }

  /** Returns the acceleration of an attractor, m/s^2. */
  public float strength() {
    return strength;
  }

  /** Returns a new effect of the engine that does what this area says, for one world. */
  public Effect effect(World<?> world) {
    Aabb box = new Aabb(minX, minY, maxX, maxY);
    return switch (kind) {
      case WATER -> new Buoyancy(box, density).drag(rate).angularDrag(angularRate).flow(x, y);
      case WIND ->
          edges
              ? new Wind(box, x, y).drag(rate).lift(angularRate)
              : AreaEffect.wind(box, x, y, rate);
      case GRAVITY -> AreaEffect.gravity(box, x - world.gravityX(), y - world.gravityY());
      case DRAG -> AreaEffect.drag(box, rate, angularRate);
      case ATTRACTOR ->
          new Attractor(x, y, range()).strength(strength).swirl(swirl).falloff(falloff, core);
    };
  }

  @Override
  public String toString() {
    return kind.name().toLowerCase(java.util.Locale.ROOT) + (name.isEmpty() ? "" : " " + name);
  }
}
