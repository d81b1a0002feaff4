package carom.physics.broadphase;

/**
 * The engine's own index: a KD-tree over the centres of the boxes, with tight bounds per node.
 *
 * <p>Cheap from tick to tick: {@link #add}, {@link #remove} and {@link #refit()} repair the tree in
 * place; nobody needs to call {@link #rebuild} again.
 */
public final class KdTree implements SpatialIndex {
  /**
   * Makes an empty tree over these boxes.
   *
   * @param boxes the boxes, indexed by id; a reference is kept
   */
  public KdTree(AabbArray boxes) {
    throw new UnsupportedOperationException("soon");
  }

  @Override
  public void rebuild(AabbArray boxes, int[] ids, int count) {
    throw new UnsupportedOperationException("soon");
  }

  /**
   * Adds a box, as it is in the box array now. Amortised O(log n).
   *
   * @param id index of the box in the box array
   * @throws IllegalArgumentException if the id is in the tree already or its box isn't valid
   */
  public void add(int id) {
    throw new UnsupportedOperationException("soon");
  }

  /**
   * Removes a box. O(log n); bounds stay tight.
   *
   * @param id which
   * @return false if it wasn't in the tree
   */
  public boolean remove(int id) {
    throw new UnsupportedOperationException("soon");
  }

  /**
   * Whether a box is in the tree.
   *
   * @param id which; any number
   * @return true if it is
   */
  public boolean contains(int id) {
    throw new UnsupportedOperationException("soon");
  }

  /** Removes all boxes; keeps the memory. */
  public void clear() {
    throw new UnsupportedOperationException("soon");
  }

  /**
   * Takes over the boxes' new places: call once per tick, after they moved. O(n), plus the repair
   * of what left its place.
   */
  public void refit() {
    throw new UnsupportedOperationException("soon");
  }

  @Override
  public void query(float minX, float minY, float maxX, float maxY, IntVisitor visitor) {
    throw new UnsupportedOperationException("soon");
  }

  @Override
  public void pairs(PairVisitor visitor) {
    throw new UnsupportedOperationException("soon");
  }

  /**
   * Visits every pair of overlapping boxes, the first from this tree and the second from the other,
   * each exactly once. Not ordered by id: idA belongs to this tree, idB to the other.
   *
   * @param other another tree; the same tree gives each pair twice and each box with itself
   * @param visitor receives the pairs
   */
  public void join(KdTree other, PairVisitor visitor) {
    throw new UnsupportedOperationException("soon");
  }

  /**
   * Visits all nodes that hold a box, parents before children.
   *
   * @param visitor receives bounds and depths
   */
  public void cells(CellVisitor visitor) {
    throw new UnsupportedOperationException("soon");
  }

  @Override
  public int size() {
    throw new UnsupportedOperationException("soon");
  }
}
