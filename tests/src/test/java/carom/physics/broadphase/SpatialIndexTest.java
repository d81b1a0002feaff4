package carom.physics.broadphase;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.broadphase.Boxes.Layout;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;

/** What holds for every index, checked against the definition written down as two loops. */
class SpatialIndexTest {
  private static final int[] COUNTS = {0, 1, 2, 3, 8, 9, 17, 64, 65, 400};

  static Stream<SpatialIndex> indexes() {
    return Stream.of(new KdTree(new AabbArray(0)), new QuadTree(), new BruteForce());
  }

  /** The definition: every two ids whose closed boxes share a point. */
  private static long[] definition(Boxes boxes) {
    int[] ids = boxes.ids();
    return Pairs.of(
        visitor -> {
          for (int a : ids) {
            for (int b : ids) {
              if (a < b && boxes.array.overlaps(a, b)) {
                visitor.pair(a, b);
              }
            }
          }
        });
  }

  @ParameterizedTest
  @EnumSource(Layout.class)
  void pairsAreThoseOfTheDefinition(Layout layout) {
    for (int n : COUNTS) {
      Boxes boxes = new Boxes(layout, n, 11 + n);
      long[] expected = definition(boxes);
      indexes()
          .forEach(
              index -> {
                index.rebuild(boxes.array, boxes.ids(), n);
                assertEquals(n, index.size());
                assertArrayEquals(expected, Pairs.of(index), index.getClass() + " " + boxes);
              });
    }
  }

  @ParameterizedTest
  @EnumSource(Layout.class)
  void queriesFindWhatOverlaps(Layout layout) {
    Boxes boxes = new Boxes(layout, 300, 21);
    int[] ids = boxes.ids();
    BruteForce oracle = new BruteForce();
    oracle.rebuild(boxes.array, ids, ids.length);
    for (SpatialIndex index : List.of(new KdTree(boxes.array), new QuadTree())) {
      index.rebuild(boxes.array, ids, ids.length);
      for (int i = 0; i < 300; i++) {
        // the box of another at twice its size, a touching one, a far one
        float width = boxes.array.maxX(i) - boxes.array.minX(i);
        float x0 = boxes.array.minX(i) - width / 2;
        float y0 = i % 3 == 0 ? boxes.array.maxY(i) : boxes.array.minY(i);
        float x1 = boxes.array.maxX(i) + width / 2;
        float y1 = i % 3 == 0 ? y0 + 1 : boxes.array.maxY(i);
        assertArrayEquals(
            Pairs.query(oracle, x0, y0, x1, y1),
            Pairs.query(index, x0, y0, x1, y1),
            index.getClass() + " " + boxes + " i=" + i);
      }
      float all = Float.POSITIVE_INFINITY;
      assertEquals(300, Pairs.query(index, -all, -all, all, all).length, "infinite box: all");
      assertEquals(0, Pairs.query(index, all, all, all, all).length, "far off: none");
    }
  }

  @ParameterizedTest
  @MethodSource("indexes")
  void visitorThatAnswersFalseStopsTheSearch(SpatialIndex index) {
    Boxes boxes = new Boxes(Layout.IDENTICAL, 100, 1);
    index.rebuild(boxes.array, boxes.ids(), 100);
    int[] seen = new int[1];
    index.query(3, 4, 5, 6, id -> ++seen[0] < 7);
    assertEquals(7, seen[0]);
  }

  @ParameterizedTest
  @MethodSource("indexes")
  void visitorMayQueryTheSameIndex(SpatialIndex index) {
    Boxes boxes = new Boxes(Layout.UNIFORM, 200, 2);
    index.rebuild(boxes.array, boxes.ids(), 200);
    long[] outer = Pairs.of(index);
    long[] nested =
        Pairs.of(
            visitor ->
                index.pairs(
                    (a, b) -> {
                      AabbArray all = boxes.array;
                      long[] around =
                          Pairs.query(index, all.minX(a), all.minY(a), all.maxX(a), all.maxY(a));
                      assertTrue(Arrays.binarySearch(around, b) >= 0);
                      visitor.pair(a, b);
                    }));
    assertArrayEquals(outer, nested);
  }

  @ParameterizedTest
  @MethodSource("indexes")
  void answersAreThoseOfTheLastUpdate(SpatialIndex index) {
    AabbArray boxes = new AabbArray(2);
    boxes.set(0, 0, 0, 1, 1);
    boxes.set(1, 1, 1, 2, 2);
    index.rebuild(boxes, new int[] {1, 0}, 2);
    boxes.set(1, 5, 5, 6, 6);
    assertArrayEquals(new long[] {1}, Pairs.of(index), "touching corners, as rebuilt");
    index.rebuild(boxes, new int[] {1, 0}, 2);
    assertEquals(0, Pairs.of(index).length);
    index.rebuild(boxes, new int[] {1}, 1);
    assertArrayEquals(new long[] {1}, Pairs.query(index, 6, 6, 7, 7));
    assertEquals(0, Pairs.query(index, 0, 0, 1, 1).length);
  }

  @ParameterizedTest
  @MethodSource("indexes")
  void invalidBoxesAreNamed(SpatialIndex index) {
    float nan = Float.NaN;
    float inf = Float.POSITIVE_INFINITY;
    float[][] wrong = {
      {nan, 0, 1, 1},
      {0, nan, 1, 1},
      {0, 0, nan, 1},
      {0, 0, 1, nan},
      {2, 0, 1, 1},
      {0, 2, 1, 1},
      {-inf, 0, 1, 1},
      {0, 0, 1, inf},
      {inf, 0, inf, 1},
      {-3e38f, 0, 3e38f, 1}
    };
    for (float[] w : wrong) {
      AabbArray boxes = new AabbArray(3);
      boxes.set(1, w[0], w[1], w[2], w[3]);
      IllegalArgumentException e =
          assertThrows(
              IllegalArgumentException.class,
              () -> index.rebuild(boxes, new int[] {0, 1, 2}, 3),
              Arrays.toString(w));
      assertTrue(e.getMessage().contains("id=1"), e.getMessage());
      assertTrue(e.getMessage().contains("minX=" + w[0]), e.getMessage());
      assertEquals(0, index.size(), "empty after a failure");
      assertEquals(0, Pairs.of(index).length);
    }
    AabbArray boxes = new AabbArray(3);
    assertThrows(
        IllegalArgumentException.class, () -> index.rebuild(boxes, new int[] {0, 3}, 2), "id=3");
    assertThrows(
        IllegalArgumentException.class, () -> index.rebuild(boxes, new int[] {-1}, 1), "id=-1");
    assertThrows(
        IllegalArgumentException.class, () -> index.rebuild(boxes, new int[] {0}, 2), "count=2");
  }

  @Test
  void treesReportTheirCells() {
    Boxes boxes = new Boxes(Layout.UNIFORM, 100, 3);
    KdTree kd = new KdTree(boxes.array);
    QuadTree quad = new QuadTree();
    kd.cells((x0, y0, x1, y1, depth) -> assertEquals(-1, depth, "an empty tree has no cells"));
    kd.rebuild(boxes.array, boxes.ids(), 100);
    quad.rebuild(boxes.array, boxes.ids(), 100);
    for (boolean useKd : new boolean[] {true, false}) {
      int[] levels = new int[40];
      CellVisitor visitor =
          (x0, y0, x1, y1, depth) -> {
            assertTrue(x0 <= x1 && y0 <= y1);
            levels[depth]++;
          };
      if (useKd) {
        kd.cells(visitor);
      } else {
        quad.cells(visitor);
      }
      assertEquals(1, levels[0], "one root");
      assertTrue(levels[1] >= 2 && levels[2] >= 4);
    }
  }
}
