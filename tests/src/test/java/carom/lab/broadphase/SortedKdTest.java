package carom.lab.broadphase;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Two sorts do the work of a sort per level. */
class SortedKdTest {
  @ParameterizedTest
  @ValueSource(ints = {0, 1, 8, 9, 1000, 4097})
  void bothWaysCutIntoTheSameParts(int count) {
    BroadphaseScene scene = new BroadphaseScene(count, true);
    SortedKd tree = new SortedKd(scene.boxes());
    tree.buildWithTwoSorts(count);
    int[] twice = leaves(tree, count);
    tree.buildWithSortPerLevel(count);
    assertArrayEquals(leaves(tree, count), twice);
    int[] sorted = twice.clone();
    Arrays.sort(sorted);
    for (int id = 0; id < count; id++) {
      assertEquals(id, sorted[id], "every box once");
    }
  }

  /** The ids in the order of the leaves, within a leaf in their own. */
  private static int[] leaves(SortedKd tree, int count) {
    int[] ids = new int[count];
    for (int i = 0; i < count; i++) {
      ids[i] = tree.at(i);
    }
    sortLeaves(ids, 0, count);
    return ids;
  }

  private static void sortLeaves(int[] ids, int from, int to) {
    if (to - from <= SortedKd.LEAF) {
      Arrays.sort(ids, from, to);
      return;
    }
    int middle = (from + to) >>> 1;
    sortLeaves(ids, from, middle);
    sortLeaves(ids, middle, to);
  }
}
