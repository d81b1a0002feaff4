package carom.physics.broadphase;

import static org.junit.jupiter.api.Assertions.assertEquals;

/** The invariants of a tree, as far as they can be seen from outside. */
final class TreeCheck {
  private TreeCheck() {}

  /** The root's bounds are tight, no cell is outside it, and every box is found at its place. */
  static void check(KdTree tree, AabbArray boxes, String where) {
    float[] union = {
      Float.POSITIVE_INFINITY,
      Float.POSITIVE_INFINITY,
      Float.NEGATIVE_INFINITY,
      Float.NEGATIVE_INFINITY
    };
    int found = 0;
    for (int id = 0; id < boxes.capacity(); id++) {
      if (!tree.contains(id)) {
        continue;
      }
      found++;
      int wanted = id;
      int[] seen = new int[1];
      tree.query(
          boxes.minX(id),
          boxes.minY(id),
          boxes.maxX(id),
          boxes.maxY(id),
          other -> {
            seen[0] += other == wanted ? 1 : 0;
            return true;
          });
      assertEquals(1, seen[0], () -> "id=" + wanted + " found once; " + where);
      union[0] = Math.min(union[0], boxes.minX(id));
      union[1] = Math.min(union[1], boxes.minY(id));
      union[2] = Math.max(union[2], boxes.maxX(id));
      union[3] = Math.max(union[3], boxes.maxY(id));
    }
    assertEquals(tree.size(), found, where);
    tree.cells(
        (x0, y0, x1, y1, depth) -> {
          boolean inside = x0 >= union[0] && y0 >= union[1] && x1 <= union[2] && y1 <= union[3];
          boolean tight = x0 == union[0] && y0 == union[1] && x1 == union[2] && y1 == union[3];
          assertEquals(
              true, depth == 0 ? tight : inside, () -> "cell at depth=" + depth + "; " + where);
        });
  }
}
