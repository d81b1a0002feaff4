package carom.physics;

/** Receives the boxes of shapes, for debug drawing. */
@FunctionalInterface
public interface AabbVisitor {
  /**
   * Receives a box; called once per convex part of a shape.
   *
   * @param minX left edge, m
   * @param minY lower edge, m
   * @param maxX right edge, m
   * @param maxY upper edge, m
   */
  void aabb(float minX, float minY, float maxX, float maxY);
}
