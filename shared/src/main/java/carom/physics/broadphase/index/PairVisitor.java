package carom.physics.broadphase.index;

/** Receives overlapping pairs of boxes. */
@FunctionalInterface
public interface PairVisitor {
  /**
   * Called exactly once per unordered pair of overlapping boxes.
   *
   * @param idA one id; in a search within one index the smaller of the two, in {@code KdTree.join}
   *     the id of the tree that was asked
   * @param idB the other id
   */
  void pair(int idA, int idB);
}
