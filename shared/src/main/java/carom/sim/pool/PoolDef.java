package carom.sim.pool;

import carom.physics.math.Limits;
import carom.physics.particles.ParticleDef;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * Definition of a pool: particles of one kind in a rectangle, where they are at the start, the
 * spouts that pour more, and the drains that take them away. Immutable: the methods that change
 * something return a changed copy. Levels declare pools, and games add theirs in {@code setUp}.
 *
 * <pre>{@code
 * PoolDef lake = PoolDef.water("lake", -20, -8, 20, 6, 0.3f)
 *     .fill(-20, -8, 20, -2)
 *     .spout(new PoolDef.Spout("spring", -18, 5, 1, 0, 0.9f, 4, true))
 *     .drain(19, -8, 20, -7);
 * }</pre>
 */
public final class PoolDef implements Cloneable {
  /** Most particles of a pool, and of all pools of a level together. */
  public static final int MAX_PARTICLES = 4_096;

  /** Longest lifetime of a particle, s; it then lasts for ever. */
  public static final float MAX_LIFETIME = 3_600;

  /** Most cells of a pool, see {@link PoolGrid}. */
  public static final int MAX_CELLS = 8_192;

  /** Most spouts of all pools of a level. */
  public static final int MAX_SPOUTS = 32;

  /** Most rectangles that are filled, and most drains of a pool. */
  public static final int MAX_BOXES = 32;

  /**
   * A nozzle of a pool.
   *
   * @param name by which the game finds it; not empty
   * @param x middle of the nozzle, metres
   * @param y middle of the nozzle, metres
   * @param dirX direction; any length but 0
   * @param dirY direction
   * @param width 0..100 m; 0 is one particle
   * @param speed of the particles, 0..50 m/s
   * @param open whether it pours from the start
   */
  public record Spout(
      String name,
      float x,
      float y,
      float dirX,
      float dirY,
      float width,
      float speed,
      boolean open) {
    /** Checks the numbers. */
    public Spout {
      Limits.notNull("name", name);
      Limits.coordinate("x", x);
      Limits.coordinate("y", y);
      if (!(dirX * dirX + dirY * dirY > 1e-6f)) {
        throw new IllegalArgumentException("direction=[" + dirX + ", " + dirY + "] has no length");
      }
      Limits.range("width", width, 0, 100);
      Limits.range("speed", speed, 0, 50);
    }
  }

  /** A rectangle: left, lower, right and upper edge, metres. */
  public record Rectangle(float minX, float minY, float maxX, float maxY) {
    /** Checks the order. */
    public Rectangle {
      if (!(minX < maxX && minY < maxY)) {
        throw new IllegalArgumentException(
            "max=[%s, %s] must be right of and above min=[%s, %s]"
                .formatted(maxX, maxY, minX, minY));
      }
    }

    boolean contains(float x, float y) {
      return x >= minX && x <= maxX && y >= minY && y <= maxY;
    }
  }

  private final ParticleDef.Kind kind;
  private final String name;
  private final Rectangle box;
  private final float spacing;
  private float density;
  private float drag;
  private int rgb;
  private int most = 2_000;
  private float lifetime = MAX_LIFETIME;
  private List<Rectangle> fills = List.of();
  private List<Rectangle> drains = List.of();
  private List<Spout> spouts = List.of();

  private PoolDef(ParticleDef.Kind kind, String name, Rectangle box, float spacing) {
    this.kind = kind;
    this.name = Limits.notNull("name", name);
    this.box = box;
    this.spacing = Limits.range("spacing", spacing, 0.125f, 2);
    boolean water = kind == ParticleDef.Kind.WATER;
    density = water ? 1 : 2.5f;
    drag = water ? 2 : 14;
    rgb = water ? 0x3a86c8 : 0xe0b872;
    long cells = (long) PoolGrid.columns(this) * PoolGrid.rows(this);
    if (cells > MAX_CELLS) {
      throw new IllegalArgumentException(
          String.format(
              Locale.ROOT,
              "pool %s has cells=%d, more than %d; make it smaller, or its spacing=%s wider: a cell"
                  + " is %s spacings wide",
              name,
              cells,
              MAX_CELLS,
              spacing,
              PoolGrid.SPACINGS));
    }
  }

  /**
   * Returns an empty pool for water, of density 1 kg/m^2 and drag 2/s.
   *
   * @param name by which the game finds it
   * @param minX left edge of the rectangle, metres; particles that leave it are gone
   * @param minY lower edge, metres
   * @param maxX right edge, metres
   * @param maxY upper edge, metres
   * @param spacing metres between particles, 0.125..2; a particle has this diameter
   * @throws IllegalArgumentException if a number is out of range
   */
  public static PoolDef water(
      String name, float minX, float minY, float maxX, float maxY, float spacing) {
    return new PoolDef(
        ParticleDef.Kind.WATER, name, new Rectangle(minX, minY, maxX, maxY), spacing);
  }

  /** Returns an empty pool for sand, of density 2.5 kg/m^2 and drag 14/s; see {@link #water}. */
  public static PoolDef sand(
      String name, float minX, float minY, float maxX, float maxY, float spacing) {
    return new PoolDef(ParticleDef.Kind.SAND, name, new Rectangle(minX, minY, maxX, maxY), spacing);
  }

  /** Returns this pool with another density, kg/m^2, 0.001..1000: what is lighter floats. */
  public PoolDef density(float value) {
    PoolDef def = copy();
    def.density = Limits.range("density", value, 0.001f, 1000);
    return def;
  }

  /** Returns this pool with another drag, 1/s, 0..1000: how fast bodies take its velocity on. */
  public PoolDef drag(float value) {
    PoolDef def = copy();
    def.drag = Limits.range("drag", value, 0, 1000);
    return def;
  }

  /** Returns this pool in another colour, 0xRRGGBB. */
  public PoolDef colored(int value) {
    PoolDef def = copy();
    def.rgb = value;
    return def;
  }

  /** Returns this pool with room for another number of particles, 1..{@link #MAX_PARTICLES}. */
  public PoolDef most(int value) {
    if (value < 1 || value > MAX_PARTICLES) {
      throw new IllegalArgumentException("most=" + value + " is outside 1.." + MAX_PARTICLES);
    }
    PoolDef def = copy();
    def.most = value;
    return def;
  }

  /** Returns this pool with particles that last so long, s, 0.125 to {@link #MAX_LIFETIME}. */
  public PoolDef lifetime(float seconds) {
    PoolDef def = copy();
    def.lifetime = Limits.range("lifetime", seconds, 0.125f, MAX_LIFETIME);
    return def;
  }

  /** Returns this pool with another rectangle that is full at the start, metres. */
  public PoolDef fill(float minX, float minY, float maxX, float maxY) {
    PoolDef def = copy();
    def.fills = added("fills", fills, new Rectangle(minX, minY, maxX, maxY), MAX_BOXES);
    return def;
  }

  /** Returns this pool with another rectangle in which particles disappear, metres. */
  public PoolDef drain(float minX, float minY, float maxX, float maxY) {
    PoolDef def = copy();
    def.drains = added("drains", drains, new Rectangle(minX, minY, maxX, maxY), MAX_BOXES);
    return def;
  }

  /** Returns this pool with another nozzle. */
  public PoolDef spout(Spout spout) {
    PoolDef def = copy();
    Limits.notNull("spout", spout);
    def.spouts = added("spouts", spouts, spout, MAX_SPOUTS);
    return def;
  }

  private static <E> List<E> added(String what, List<E> list, E element, int most) {
    if (list.size() == most) {
      throw new IllegalArgumentException(what + "=" + (most + 1) + " is outside 0.." + most);
    }
    List<E> longer = new ArrayList<>(list);
    longer.add(element);
    return List.copyOf(longer);
  }

  static void limit(String what, int value, int most) {
    if (value > most) {
      throw new IllegalArgumentException(what + "=" + value + " is more than " + most);
    }
  }

  private PoolDef copy() {
    try {
      return (PoolDef) clone();
    } catch (CloneNotSupportedException e) {
      throw new AssertionError(e);
    }
  }

  /** Returns whether it is of water or sand. */
  public ParticleDef.Kind kind() {
    return kind;
  }

  /** Returns the name by which the game finds it. */
  public String name() {
    return name;
  }

  /** Returns the rectangle. */
  public Rectangle box() {
    return box;
  }

  /** Returns the distance between particles, metres. */
  public float spacing() {
    return spacing;
  }

  /** Returns the density, kg/m^2. */
  public float density() {
    return density;
  }

  /** Returns the drag, 1/s. */
  public float drag() {
    return drag;
  }

  /** Returns the colour, 0xRRGGBB. */
  public int rgb() {
    return rgb;
  }

  /** Returns the largest number of particles. */
  public int most() {
    return most;
  }

  /** Returns the rectangles that are full at the start; unmodifiable. */
  public List<Rectangle> fills() {
    return fills;
  }

  /** Returns the rectangles in which particles disappear; unmodifiable. */
  public List<Rectangle> drains() {
    return drains;
  }

  /** Returns the nozzles; unmodifiable. */
  public List<Spout> spouts() {
    return spouts;
  }

  /** Returns what the particles are made of; they don't push bodies, the {@link PoolGrid} does. */
  ParticleDef particles() {
    return new ParticleDef(kind, spacing)
        .density(density)
        .twoWay(false)
        .substeps(kind == ParticleDef.Kind.WATER ? 2 : 3)
        .lifetime(lifetime < MAX_LIFETIME ? lifetime : Float.POSITIVE_INFINITY)
        .maxCount(most);
  }
}
