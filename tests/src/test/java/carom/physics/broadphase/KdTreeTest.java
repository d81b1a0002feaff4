package carom.physics.broadphase;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.lab.broadphase.BroadphaseScene;
import carom.physics.broadphase.Boxes.Layout;
import java.lang.management.ManagementFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

class KdTreeTest {
  private static long[] oracle(Boxes boxes) {
    BruteForce brute = new BruteForce();
    int[] ids = boxes.ids();
    brute.rebuild(boxes.array, ids, ids.length);
    return Pairs.of(brute);
  }

  private static KdTree treeOf(Boxes boxes) {
    KdTree tree = new KdTree(boxes.array);
    int[] ids = boxes.ids();
    tree.rebuild(boxes.array, ids, ids.length);
    return tree;
  }

  @ParameterizedTest
  @EnumSource(Layout.class)
  void movingWorldAgreesWithBruteForceWhileBoxesComeAndGo(Layout layout) {
    for (long seed = 1; seed <= 3; seed++) {
      Boxes boxes = new Boxes(layout, 300, seed);
      for (int id = 0; id < 300; id += 2) {
        boxes.setPresent(id, false);
      }
      KdTree tree = treeOf(boxes);
      for (int tick = 0; tick < 60; tick++) {
        boxes.drift(tick % 10 == 9 ? 5 : 0.05);
        tree.refit();
        for (int change = boxes.below(12); change > 0; change--) {
          int id = boxes.below(300);
          if (boxes.isPresent(id)) {
            assertTrue(tree.remove(id));
          } else {
            boxes.place(id);
            tree.add(id);
          }
          boxes.setPresent(id, !boxes.isPresent(id));
          assertEquals(boxes.isPresent(id), tree.contains(id));
        }
        String where = boxes + " tick=" + tick;
        assertEquals(boxes.ids().length, tree.size(), where);
        assertArrayEquals(oracle(boxes), Pairs.of(tree), where);
        TreeCheck.check(tree, boxes.array, where);
      }
    }
  }

  @ParameterizedTest
  @EnumSource(Layout.class)
  void crowdsMayComeAndGoAtOnce(Layout layout) {
    Boxes boxes = new Boxes(layout, 300, 8);
    for (int id = 0; id < 300; id++) {
      boxes.setPresent(id, id < 150);
    }
    KdTree tree = treeOf(boxes);
    int[] crowd = new int[300];
    for (int tick = 0; tick < 60; tick++) {
      boxes.drift(0.05);
      tree.refit();
      boolean come = tick % 2 == 0;
      int share = tick % 3 == 0 ? 100 : 1 + boxes.below(30);
      int n = 0;
      for (int id = 0; id < 300; id++) {
        if (boxes.isPresent(id) != come && boxes.below(100) < share) {
          boxes.setPresent(id, come);
          crowd[n++] = id;
        }
      }
      if (come) {
        tree.addAll(crowd, n);
      } else {
        tree.removeAll(crowd, n);
      }
      String where = boxes + " tick=" + tick;
      assertEquals(boxes.ids().length, tree.size(), where);
      assertArrayEquals(oracle(boxes), Pairs.of(tree), where);
      TreeCheck.check(tree, boxes.array, where);
    }
  }

  @ParameterizedTest
  @EnumSource(Layout.class)
  void refitIsRightAfterAnyMotion(Layout layout) {
    Boxes boxes = new Boxes(layout, 257, 5);
    KdTree tree = treeOf(boxes);
    for (int tick = 0; tick < 12; tick++) {
      int moved = tick % 4 == 0 ? 257 : tick % 4 == 1 ? 1 : 20;
      for (int i = 0; i < moved; i++) {
        int id = boxes.below(257);
        boxes.shift(id, boxes.between(-1e4, 1e4), boxes.between(-1e4, 1e4));
      }
      tree.refit();
      assertArrayEquals(oracle(boxes), Pairs.of(tree), boxes + " tick=" + tick);
      TreeCheck.check(tree, boxes.array, boxes + " tick=" + tick);
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 7, 300})
  void slicesListEveryBoxOnce(int n) {
    Boxes boxes = new Boxes(Layout.CLUSTERED, 300, 15);
    for (int id = n; id < 300; id++) {
      boxes.setPresent(id, false);
    }
    KdTree tree = treeOf(boxes);
    int[] out = new int[300];
    for (int parts : new int[] {1, 2, 10, 33, 1000}) {
      int[] seen = new int[300];
      for (int part = 0; part < parts; part++) {
        int count = tree.slice(part, parts, out);
        for (int i = 0; i < count; i++) {
          seen[out[i]]++;
        }
      }
      for (int id = 0; id < 300; id++) {
        assertEquals(id < n ? 1 : 0, seen[id], "id=" + id + " parts=" + parts);
      }
    }
  }

  @Test
  void everythingGatheringInOnePlaceAndScatteringStaysRight() {
    Boxes boxes = new Boxes(Layout.UNIFORM, 600, 6);
    KdTree tree = treeOf(boxes);
    for (int tick = 0; tick < 120; tick++) {
      for (int id = 0; id < 600; id++) {
        float pull = tick < 60 ? -0.1f : 0.15f;
        boxes.shift(id, pull * (boxes.array.minX(id) - 10), pull * (boxes.array.minY(id) - 10));
      }
      tree.refit();
      if (tick % 10 == 0) {
        assertArrayEquals(oracle(boxes), Pairs.of(tree), boxes + " tick=" + tick);
        TreeCheck.check(tree, boxes.array, boxes + " tick=" + tick);
      }
    }
  }

  @Test
  void swarmInFormationKeepsItsCells() {
    Boxes boxes = new Boxes(Layout.UNIFORM, 4000, 7);
    KdTree tree = treeOf(boxes);
    for (int tick = 0; tick < 50; tick++) {
      for (int id = 0; id < 4000; id++) {
        boxes.shift(id, 0.8f, -0.5f);
      }
      tree.refit();
    }
    assertTrue(tree.strays() < 40, "strays in the last tick=" + tree.strays());
    assertArrayEquals(oracle(boxes), Pairs.of(tree), boxes.toString());
  }

  @Test
  void fewFastBoxesDoNotCarryTheCellsOfRestingOnesAway() {
    Boxes boxes = new Boxes(Layout.UNIFORM, 4000, 7);
    KdTree tree = treeOf(boxes);
    for (int tick = 0; tick < 50; tick++) {
      for (int id = 0; id < 200; id++) {
        boxes.shift(id, 1.5f, 0);
      }
      tree.refit();
      assertTrue(tree.strays() <= 200, "strays=" + tree.strays() + " tick=" + tick);
    }
    assertArrayEquals(oracle(boxes), Pairs.of(tree), boxes.toString());
  }

  @Test
  void addingDoesNotTakeOverMotionOfOthers() {
    Boxes boxes = new Boxes(Layout.IDENTICAL, 400, 13);
    KdTree tree = new KdTree(boxes.array);
    for (int id = 0; id < 400; id++) {
      tree.add(id);
      boxes.shift(id, 1000, 0);
    }
    assertEquals(400 * 399 / 2, Pairs.of(tree).length, "all where they were when added");
    assertEquals(0, Pairs.query(tree, 1003, 4, 1005, 6).length);
    tree.refit();
    assertEquals(400, Pairs.query(tree, 1003, 4, 1005, 6).length);
  }

  @Test
  void visitorThatThrowsLeavesTheTreeUsable() {
    Boxes boxes = new Boxes(Layout.UNIFORM, 300, 14);
    KdTree tree = treeOf(boxes);
    PairVisitor angry =
        (a, b) -> {
          throw new IllegalStateException("enough");
        };
    assertThrows(IllegalStateException.class, () -> tree.pairs(angry));
    assertThrows(IllegalStateException.class, () -> tree.join(tree, angry));
    assertArrayEquals(oracle(boxes), Pairs.of(tree), boxes.toString());
  }

  @ParameterizedTest
  @EnumSource(Layout.class)
  void joinFindsPairsAcrossTwoTrees(Layout layout) {
    for (int cut : new int[] {0, 1, 3, 40, 200, 299, 300}) {
      Boxes boxes = new Boxes(layout, 300, 8);
      KdTree left = new KdTree(boxes.array);
      KdTree right = new KdTree(boxes.array);
      for (int id = 0; id < 300; id++) {
        (id < cut ? left : right).add(id);
      }
      long[] expected =
          Pairs.of(
              visitor -> {
                for (int a = 0; a < cut; a++) {
                  for (int b = cut; b < 300; b++) {
                    if (boxes.array.overlaps(a, b)) {
                      visitor.pair(a, b);
                    }
                  }
                }
              });
      assertArrayEquals(expected, Pairs.of(v -> left.join(right, v)), boxes + " cut=" + cut);
      long[] swapped = Pairs.of(v -> right.join(left, (b, a) -> v.pair(a, b)));
      assertArrayEquals(expected, swapped, boxes + " cut=" + cut);
    }
  }

  @Test
  void joinWithItselfSeesEveryPairTwiceAndEveryBoxOnce() {
    Boxes boxes = new Boxes(Layout.UNIFORM, 100, 9);
    KdTree tree = treeOf(boxes);
    assertEquals(2 * Pairs.of(tree).length + 100, Pairs.of(v -> tree.join(tree, v)).length);
  }

  @Test
  void hundredThousandIdenticalBoxesNeedNoDeepStack() throws InterruptedException {
    int n = 100_000;
    Boxes boxes = new Boxes(Layout.IDENTICAL, n, 10);
    boolean[] done = new boolean[1];
    Runnable work =
        () -> {
          KdTree tree = treeOf(boxes);
          QuadTree quad = new QuadTree();
          quad.rebuild(boxes.array, boxes.ids(), n);
          for (int i = 0; i < 3; i++) {
            tree.refit();
            tree.remove(i);
            tree.add(i);
          }
          int[] seen = new int[2];
          tree.query(4, 5, 4, 5, id -> ++seen[0] > 0);
          quad.query(4, 5, 4, 5, id -> ++seen[1] > 0);
          assertArrayEquals(new int[] {n, n}, seen);
          int[] depth = new int[1];
          tree.cells((x0, y0, x1, y1, d) -> depth[0] = Math.max(depth[0], d));
          assertTrue(depth[0] <= 15, "depth=" + depth[0]);
          KdTree point = new KdTree(boxes.array);
          point.add(0);
          tree.remove(0);
          assertEquals(n - 1, Pairs.of(v -> point.join(tree, v)).length);
          done[0] = true;
        };
    Thread small = new Thread(null, work, "small stack", 200_000);
    small.start();
    small.join();
    assertTrue(done[0], "see the other thread's exception above");
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void insertingOneByOneInOrderStaysCheap(boolean identical) {
    int n = 20_000;
    AabbArray boxes = new AabbArray(n);
    KdTree tree = new KdTree(boxes);
    for (int id = 0; id < n; id++) {
      float x = identical ? 0 : id;
      boxes.set(id, x, 0, x + 1, 1);
      tree.add(id);
    }
    TreeCheck.check(tree, boxes, "identical=" + identical);
    assertTrue(tree.built() < 60L * n, "boxes built again=" + tree.built() + " n=" + n);
  }

  @Test
  void steadyTicksDoNotAllocate() {
    int n = 3000;
    BroadphaseScene scene = new BroadphaseScene(n, false);
    KdTree tree = new KdTree(scene.boxes());
    KdTree other = new KdTree(scene.boxes());
    other.rebuild(scene.boxes(), scene.ids(), n / 10);
    tree.rebuild(scene.boxes(), scene.ids(), n);
    PairSearch search = new PairSearch(tree, other);
    long[] count = new long[1];
    int[] changed = {5, 50, 500};
    boolean[] marked = new boolean[n];
    marked[500] = true;
    PairVisitor pairs = (a, b) -> count[0]++;
    IntVisitor ids = id -> ++count[0] > 0;
    com.sun.management.ThreadMXBean threads =
        (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
    long least = Long.MAX_VALUE;
    for (int round = 0; round < 8; round++) {
      long before = threads.getCurrentThreadAllocatedBytes();
      for (int tick = 0; tick < 50; tick++) {
        scene.step();
        tree.refit();
        tree.remove(tick);
        tree.add(tick);
        tree.pairs(pairs);
        tree.join(other, pairs);
        tree.refit(changed, changed.length);
        int pieces = search.begin(marked, 2);
        for (int piece = 0; piece < pieces; piece++) {
          search.run(piece, piece % 2, pairs);
        }
        search.end();
        tree.query(0, 0, 20, 20, ids);
        if (tick % 10 == 0) {
          tree.rebuild(scene.boxes(), scene.ids(), n);
        }
      }
      least = Math.min(least, threads.getCurrentThreadAllocatedBytes() - before);
    }
    assertTrue(least < 200, "bytes in 50 ticks=" + least + " (the counter itself needs a few)");
  }

  @Test
  void treesGrowAndShrinkWithTheirContents() {
    Boxes boxes = new Boxes(Layout.UNIFORM, 5000, 12);
    KdTree tree = treeOf(boxes);
    for (int id = 5; id < 5000; id++) {
      assertTrue(tree.remove(id));
      boxes.setPresent(id, false);
    }
    assertFalse(tree.remove(4999));
    assertFalse(tree.remove(-1));
    assertFalse(tree.remove(1 << 30));
    tree.refit();
    int[] cells = new int[1];
    tree.cells((x0, y0, x1, y1, depth) -> cells[0]++);
    assertEquals(1, cells[0], "five boxes are one leaf");
    assertArrayEquals(oracle(boxes), Pairs.of(tree));
    tree.clear();
    assertEquals(0, tree.size());
    assertEquals(0, Pairs.query(tree, -1e9f, -1e9f, 1e9f, 1e9f).length);
    tree.refit();
    tree.add(7);
    assertEquals(1, tree.size());
  }

  @Test
  void mistakesOfTheCallerAreNamed() {
    AabbArray boxes = new AabbArray(4);
    KdTree tree = new KdTree(boxes);
    tree.add(2);
    Exception twice = assertThrows(IllegalArgumentException.class, () -> tree.add(2));
    assertTrue(twice.getMessage().contains("id=2"), twice.getMessage());
    Exception repeated =
        assertThrows(
            IllegalArgumentException.class, () -> tree.rebuild(boxes, new int[] {1, 3, 1}, 3));
    assertTrue(repeated.getMessage().contains("index=2"), repeated.getMessage());
    tree.add(1);
    boxes.set(3, 0, 0, Float.NaN, 1);
    assertThrows(IllegalArgumentException.class, () -> tree.add(3));
    assertEquals(1, tree.size(), "a refused box leaves the tree as it was");
    boxes.set(1, 0, 0, Float.POSITIVE_INFINITY, 1);
    assertThrows(IllegalArgumentException.class, tree::refit);
    assertEquals(0, tree.size(), "a refit that failed leaves an empty tree");
    boxes.set(1, 0, 0, 1, 1);
    for (int id = 0; id < 3; id++) {
      tree.add(id);
    }
    boxes.set(1, 0, 0, Float.NaN, 1);
    assertThrows(IllegalArgumentException.class, () -> tree.refit(new int[] {1}, 1));
    assertEquals(0, tree.size(), "a refit that failed leaves an empty tree");
  }

  /** What a refit had begun before it met a bad box must not be taken for done in a later one. */
  @Test
  void aRefitThatFailedHalfwayLeavesNoTrace() {
    int n = 200;
    AabbArray boxes = new AabbArray(n);
    int[] ids = new int[n];
    for (int id = 0; id < n; id++) {
      ids[id] = id;
      boxes.set(id, id, 0, id + 0.5f, 1);
    }
    KdTree tree = new KdTree(boxes);
    tree.rebuild(boxes, ids, n);
    boxes.set(n - 1, 0, 0, Float.NaN, 1);
    int[] some = {0, 40, 80, 120, 160, n - 1};
    assertThrows(IllegalArgumentException.class, () -> tree.refit(some, some.length));
    boxes.set(n - 1, n - 1, 0, n - 0.5f, 1);
    tree.rebuild(boxes, ids, n);
    for (int id : some) {
      boxes.set(id, id, 3, id + 0.5f, 4);
    }
    tree.refit(some, some.length);
    TreeCheck.check(tree, boxes, "after a refit that failed");
  }

  @Test
  void benchmarkSceneGivesTheSamePairsWhateverTheMethod() {
    int n = 1000;
    for (boolean clustered : new boolean[] {false, true}) {
      BroadphaseScene scene = new BroadphaseScene(n, clustered);
      KdTree kept = new KdTree(scene.boxes());
      kept.rebuild(scene.boxes(), scene.ids(), n);
      KdTree fresh = new KdTree(scene.boxes());
      QuadTree quad = new QuadTree();
      BruteForce brute = new BruteForce();
      for (int tick = 0; tick < 200; tick++) {
        scene.step();
        kept.refit();
        if (tick < 3 || tick % 40 == 0) {
          fresh.rebuild(scene.boxes(), scene.ids(), n);
          quad.rebuild(scene.boxes(), scene.ids(), n);
          brute.rebuild(scene.boxes(), scene.ids(), n);
          long[] expected = Pairs.of(brute);
          assertArrayEquals(expected, Pairs.of(kept), "kept tree, tick=" + tick);
          assertArrayEquals(expected, Pairs.of(fresh), "fresh tree, tick=" + tick);
          assertArrayEquals(expected, Pairs.of(quad), "quadtree, tick=" + tick);
        }
      }
    }
  }
}
