package carom.physics.broadphase;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.broadphase.Boxes.Layout;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Moving boxes and rays in every index. */
class CastTest {
  private final int[] found = new int[500];
  private int count;

  private int[] cast(SpatialIndex index, float[] box, float dx, float dy) {
    count = 0;
    index.cast(
        box[0],
        box[1],
        box[2],
        box[3],
        dx,
        dy,
        1,
        (id, end) -> {
          found[count++] = id;
          return end;
        });
    int[] ids = Arrays.copyOf(found, count);
    Arrays.sort(ids);
    return ids;
  }

  @ParameterizedTest
  @EnumSource(Layout.class)
  void allIndexesVisitTheSameBoxes(Layout layout) {
    Boxes boxes = new Boxes(layout, 400, 31);
    int[] ids = boxes.ids();
    BruteForce oracle = new BruteForce();
    oracle.rebuild(boxes.array, ids, ids.length);
    for (SpatialIndex index : List.of(new KdTree(boxes.array), new QuadTree())) {
      index.rebuild(boxes.array, ids, ids.length);
      for (int i = 0; i < 200; i++) {
        int to = (i * 7 + 1) % 400;
        float x = boxes.array.minX(i);
        float y = boxes.array.minY(i);
        float size = i % 3 == 0 ? 0 : 1;
        float dx = i % 5 == 0 ? 0 : boxes.array.minX(to) - x;
        float dy = i % 7 == 0 ? 0 : boxes.array.maxY(to) - y;
        float[] box = {x, y, x + size, y + size};
        assertArrayEquals(
            cast(oracle, box, dx, dy), cast(index, box, dx, dy), index.getClass() + " " + boxes);
      }
    }
  }

  /** Goal: nobody on the way is missed. Method: boxes at 1,000 moments along it. */
  @Test
  void whatTheBoxOverlapsOnItsWayIsVisited() {
    Boxes boxes = new Boxes(Layout.UNIFORM, 300, 32);
    int[] ids = boxes.ids();
    KdTree tree = new KdTree(boxes.array);
    tree.rebuild(boxes.array, ids, ids.length);
    for (int i = 0; i < 100; i++) {
      float x = boxes.between(-5, 30);
      float y = boxes.between(-5, 30);
      float dx = boxes.between(-30, 30);
      float dy = boxes.between(-30, 30);
      boolean[] met = new boolean[300];
      for (int k = 0; k <= 1000; k++) {
        float px = x + dx * k / 1000;
        float py = y + dy * k / 1000;
        tree.query(px, py, px + 0.5f, py + 0.2f, id -> met[id] = true);
      }
      int[] visited = cast(tree, new float[] {x, y, x + 0.5f, y + 0.2f}, dx, dy);
      int[] missed =
          IntStream.range(0, 300)
              .filter(id -> met[id] && Arrays.binarySearch(visited, id) < 0)
              .toArray();
      assertEquals(0, missed.length, boxes + " cast=" + i + " " + Arrays.toString(missed));
      assertTrue(visited.length <= 300);
    }
  }

  @Test
  void aVisitorThatShortensTheWaySeesLittleOfTheRest() {
    Boxes boxes = new Boxes(Layout.GRID, 400, 33);
    int[] ids = boxes.ids();
    KdTree tree = new KdTree(boxes.array);
    tree.rebuild(boxes.array, ids, ids.length);
    count = 0;
    tree.cast(
        -20,
        0.5f,
        -20,
        0.5f,
        40,
        0,
        1,
        (id, end) -> {
          count++;
          return Math.min(end, (boxes.array.minX(id) + 20) / 40);
        });
    assertTrue(count <= 6, "visits=" + count + " of 20 boxes in the row");
    count = 0;
    tree.cast(
        -20,
        0.5f,
        -20,
        0.5f,
        40,
        0,
        1,
        (id, end) -> {
          count++;
          return -1;
        });
    assertEquals(1, count);
  }
}
