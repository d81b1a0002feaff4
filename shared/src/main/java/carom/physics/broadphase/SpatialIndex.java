package carom.physics.broadphase;

/**
 * An index that finds overlapping boxes among many.
 *
 * <p>An index remembers the boxes as they were at the last {@link #rebuild} (a {@code KdTree} also
 * at the last {@code KdTree.refit()}); changing the {@link AabbArray} afterwards doesn't change a
 * result until then. Intervals are closed: boxes that merely touch overlap, as do boxes of zero
 * size. There are no world bounds and no cell size.
 *
 * <p><b>Order.</b> The set of ids or pairs found depends on the boxes alone. The order in which
 * they come is unspecified, and a caller whose result depends on it sorts first.
 *
 * <p><b>Ownership.</b> The index keeps a reference to the box array it was given, reads it in the
 * updating methods only and never writes to it. The id array is copied.
 *
 * <p><b>Threads.</b> An index is not thread-safe: only one thread at a time may use it. A visitor
 * may call {@link #query} on the index that calls it, but no updating method and not {@link
 * #pairs}.
 *
 * <p><b>Cost.</b> No method allocates once the index has seen its largest number of boxes and its
 * largest id.
 *
 * <p><b>Errors.</b> Boxes must be finite with min &lt;= max (and not wider than {@code
 * Float.MAX_VALUE}); updating methods check it and throw IllegalArgumentException with id and
 * values. A rebuild that fails for a box or an id leaves the index empty.
 */
public interface SpatialIndex {
  /**
   * Replaces all boxes by these.
   *
   * @param boxes the boxes, indexed by id
   * @param ids distinct ids, the first {@code count} entries are read
   * @param count number of ids, 0 for an empty index
   * @throws IllegalArgumentException if count or an id is out of range, an id comes twice (where
   *     that is cheap to see), or a box isn't finite with min &lt;= max
   */
  void rebuild(AabbArray boxes, int[] ids, int count);

  /**
   * Visits the id of every box that overlaps the given one, each once, until the visitor returns
   * false.
   *
   * @param minX left edge of the box, m; infinite edges are fine here
   * @param minY lower edge, m
   * @param maxX right edge, m
   * @param maxY upper edge, m
   * @param visitor receives the ids
   */
  void query(float minX, float minY, float maxX, float maxY, IntVisitor visitor);

  /**
   * Moves a box along (dx, dy) and visits the id of every box it meets on the way, each once; a box
   * of zero size is a ray. The end of the way may change with every visit: a caller that looks for
   * the nearest box returns how near the nearest one found so far is.
   *
   * <p>Trees visit near boxes before far ones, roughly. With a visitor that never shortens the way,
   * all indexes visit the same ids. A visitor must not start another cast in the same index.
   *
   * @param minX left edge of the box at its start, m, finite
   * @param minY lower edge, m
   * @param maxX right edge, m
   * @param maxY upper edge, m
   * @param dx way along x, m, finite
   * @param dy way along y, m
   * @param maxFraction where the way ends, in units of (dx, dy); 1 is the whole way
   * @param visitor receives the ids
   */
  void cast(
      float minX,
      float minY,
      float maxX,
      float maxY,
      float dx,
      float dy,
      float maxFraction,
      CastVisitor visitor);

  /**
   * Visits every unordered pair of overlapping boxes exactly once, with idA &lt; idB.
   *
   * @param visitor receives the pairs
   */
  void pairs(PairVisitor visitor);

  /**
   * Returns the number of boxes in the index.
   *
   * @return the number of boxes
   */
  int size();
}
