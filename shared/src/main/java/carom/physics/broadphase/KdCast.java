package carom.physics.broadphase;

/**
 * Moves a box through a {@link KdTree} and visits near nodes before far ones. Only one cast may run
 * at a time.
 */
final class KdCast {
  private final KdTree tree;
  private final MovingBox moving = new MovingBox();

  /**
   * Stack of the nodes still to visit, the nearest on top, and the fraction of the way at which the
   * box meets each.
   */
  private final int[] castNode = new int[64];

  private final double[] castEnter = new double[64];

  KdCast(KdTree tree) {
    this.tree = tree;
  }

  /** Runs a cast as {@code SpatialIndex.cast} describes. */
  void run(
      float minX,
      float minY,
      float maxX,
      float maxY,
      float dx,
      float dy,
      float maxFraction,
      CastVisitor visitor) {
    moving.set(minX, minY, maxX, maxY, dx, dy);
    float end = maxFraction;
    int top = 0;
    castNode[0] = 1;
    castEnter[0] = enter(1);
    while (top >= 0 && end >= 0) {
      int node = castNode[top];
      double at = castEnter[top--];
      if (!(at <= end)) {
        continue;
      }
      if (node >= tree.leaves) {
        end = castLeaf(node - tree.leaves, end, visitor);
        continue;
      }
      double low = enter(2 * node);
      double high = enter(2 * node + 1);
      int near = high < low ? 1 : 0;
      castNode[top + 1] = 2 * node + 1 - near;
      castEnter[top + 1] = Math.max(low, high);
      castNode[top + 2] = 2 * node + near;
      castEnter[top + 2] = Math.min(low, high);
      top += 2;
    }
  }

  private double enter(int node) {
    float[] n = tree.bounds;
    int b = 4 * node;
    return moving.enter(n[b], n[b + 1], n[b + 2], n[b + 3]);
  }

  /** Casts against the boxes of a leaf and returns where the way ends now. */
  private float castLeaf(int leaf, float maxFraction, CastVisitor visitor) {
    float end = maxFraction;
    for (int k = 0; k < tree.fill[leaf] && end >= 0; k++) {
      int at = leaf * KdTree.BLOCK + k;
      double enter =
          moving.enter(
              tree.slots[at],
              tree.slots[at + KdTree.ROW],
              tree.slots[at + 2 * KdTree.ROW],
              tree.slots[at + 3 * KdTree.ROW]);
      if (enter <= end) {
        end = visitor.visit(tree.ids[leaf * KdTree.SLOTS + k], end);
      }
    }
    return end;
  }
}
