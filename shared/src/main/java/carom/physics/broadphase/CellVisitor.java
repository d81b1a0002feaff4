package carom.physics.broadphase;

/** Receives the nodes of a spatial index, for debug drawing and statistics. */
@FunctionalInterface
public interface CellVisitor {
  /**
   * Receives a node. Each node that holds at least one box is passed once.
   *
   * @param minX left edge of the node's tight bounds, m
   * @param minY lower edge, m
   * @param maxX right edge, m
   * @param maxY upper edge, m
   * @param depth distance from the root, 0 for the root itself
   */
  void cell(float minX, float minY, float maxX, float maxY, int depth);
}
