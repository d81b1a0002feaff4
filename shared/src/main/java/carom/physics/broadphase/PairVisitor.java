package carom.physics.broadphase;

/** Receives overlapping pairs of boxes. */
@FunctionalInterface
public interface PairVisitor {
  /**
   * Receives a pair. Each unordered pair of overlapping boxes is passed exactly once.
   *
   * @param idA one id; in a search within one index the smaller of the two, in {@code KdTree.join}
   *     an id of the tree that is searched
   * @param idB the other id
   */
  void pair(int idA, int idB);
}
