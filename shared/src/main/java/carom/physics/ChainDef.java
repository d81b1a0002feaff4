package carom.physics;

import carom.physics.geometry.Chain;
import carom.physics.geometry.Shape;
import carom.physics.math.Limits;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * A long line of ground: more segments than one {@link Chain} may have, with a material for each.
 * {@link World#createChain} makes bodies of it.
 *
 * <pre>
 *   ChainDef ground = ChainDef.open(xy).material(0, 200, GRASS).material(200, 260, ICE);
 *   List&lt;Body&lt;T&gt;&gt; bodies = world.createChain(ground, new BodyDef(), user);
 * </pre>
 *
 * <p>The line is cut wherever the material changes, and after {@link Chain#MAX_SEGMENTS} segments.
 * A piece becomes one shape, and a body takes as many shapes as its parts allow ({@value
 * #MAX_BODY_PARTS}). Pieces know where the next one goes on, so bodies slide over the cuts as over
 * the joints within a chain, also from one body to the next.
 *
 * <p>Each segment is a part of its own in the trees of the broadphase. So what a query or a body
 * near the line costs doesn't depend on the length of the line but for the depth of a tree.
 *
 * <p>A definition copies its points. It may be used again; bodies copy it.
 */
public final class ChainDef {
  /** Largest number of segments of a definition. */
  public static final int MAX_SEGMENTS = 200_000;

  /** Largest number of segments that one body takes. */
  public static final int MAX_BODY_PARTS = 1024;

  private final float[] xy;
  private final boolean loop;
  private final Material[] materials;
  private Filter filter = Filter.DEFAULT;

  private ChainDef(float[] xy, boolean loop) {
    Limits.notNull("xy", xy);
    int segments = loop ? xy.length / 2 : xy.length / 2 - 1;
    int least = loop ? 3 : 1;
    if (xy.length % 2 != 0) {
      throw new IllegalArgumentException(
          "chain coordinates=" + xy.length + " must be even: x and y of each point");
    }
    if (segments < least || segments > MAX_SEGMENTS) {
      throw new IllegalArgumentException(
          "chain segments=" + segments + " must be in " + least + ".." + MAX_SEGMENTS);
    }
    this.xy = xy.clone();
    this.loop = loop;
    materials = new Material[segments];
    Arrays.fill(materials, Material.DEFAULT);
  }

  /**
   * Makes the definition of an open line.
   *
   * @param xy x0, y0, x1, y1, ... in metres, as for {@link Chain#open}, up to {@link #MAX_SEGMENTS}
   */
  public static ChainDef open(float... xy) {
    return new ChainDef(xy, false);
  }

  /**
   * Makes the definition of a closed line, whose last segment leads back to the first point.
   *
   * @param xy x0, y0, x1, y1, ... in metres, as for {@link Chain#loop}, up to {@link #MAX_SEGMENTS}
   */
  public static ChainDef loop(float... xy) {
    return new ChainDef(xy, true);
  }

  /**
   * Sets the material of all segments; default {@link Material#DEFAULT}.
   *
   * @return this
   */
  public ChainDef material(Material material) {
    return material(0, materials.length, material);
  }

  /**
   * Sets the material of one segment.
   *
   * @param segment its number: segment i leads from point i to the next
   * @return this
   */
  public ChainDef material(int segment, Material material) {
    return material(segment, segment + 1, material);
  }

  /**
   * Sets the material of a stretch of segments.
   *
   * @param from the first one
   * @param to the one behind the last
   * @return this
   * @throws IndexOutOfBoundsException if the line has no such segments
   */
  public ChainDef material(int from, int to, Material material) {
    if (from < 0 || to > materials.length || from >= to) {
      throw new IndexOutOfBoundsException(
          "from="
              + from
              + " to="
              + to
              + " must be a stretch of 0.."
              + materials.length
              + "; see segmentCount()");
    }
    if (material == null) {
      throw new IllegalArgumentException("material=null; use Material.DEFAULT for the default");
    }
    Arrays.fill(materials, from, to, material);
    return this;
  }

  /**
   * Sets what the line collides with; default {@link Filter#DEFAULT}.
   *
   * @return this
   */
  public ChainDef filter(Filter newFilter) {
    if (newFilter == null) {
      throw new IllegalArgumentException("filter=null; use Filter.DEFAULT for the default");
    }
    filter = newFilter;
    return this;
  }

  /** Returns the number of segments. */
  public int segmentCount() {
    return materials.length;
  }

  /** Returns whether the last point is joined to the first. */
  public boolean isLoop() {
    return loop;
  }

  /** Returns the material of a segment. */
  public Material material(int segment) {
    return materials[Limits.index("segment", segment, materials.length)];
  }

  /**
   * Returns the pieces of the line, in the order of the points, each with its material.
   *
   * @return one shape for each stretch of one material, at most {@link Chain#MAX_SEGMENTS} long
   * @throws IllegalArgumentException when the line crosses itself or turns back on itself
   */
  public List<ShapeDef> shapes() {
    int[] cuts = new int[materials.length];
    int count = 0;
    int from = 0;
    for (int i = 1; i < materials.length; i++) {
      if (!materials[i].equals(materials[i - 1]) || i - from == Chain.MAX_SEGMENTS) {
        cuts[count++] = i;
        from = i;
      }
    }
    List<ShapeDef> shapes = new ArrayList<>(count + 1);
    int segment = 0;
    for (Shape piece : Chain.pieces(xy, loop, Arrays.copyOf(cuts, count))) {
      shapes.add(new ShapeDef(piece, materials[segment]).withFilter(filter));
      segment += piece.parts().size();
    }
    return shapes;
  }

  /** Returns the shapes of each body that the line needs. */
  List<List<ShapeDef>> bodies() {
    List<List<ShapeDef>> bodies = new ArrayList<>();
    List<ShapeDef> body = new ArrayList<>();
    int parts = 0;
    for (ShapeDef shape : shapes()) {
      int more = shape.shape().parts().size();
      if (parts + more > MAX_BODY_PARTS) {
        bodies.add(body);
        body = new ArrayList<>();
        parts = 0;
      }
      body.add(shape);
      parts += more;
    }
    bodies.add(body);
    return bodies;
  }
}
