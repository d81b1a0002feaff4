package carom.physics.broadphase;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.broadphase.Boxes.Layout;
import carom.physics.threads.WorkerThreads;
import java.util.Arrays;
import java.util.function.LongPredicate;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

class PairSearchTest {
  private static KdTree treeOf(Boxes boxes, int from, int to) {
    KdTree tree = new KdTree(boxes.array);
    int[] ids = Arrays.copyOfRange(boxes.ids(), from, to);
    tree.rebuild(boxes.array, ids, ids.length);
    return tree;
  }

  /** All overlapping pairs, but those among boxes from {@code cut} on. */
  private static long[] oracle(Boxes boxes, int cut) {
    BruteForce brute = new BruteForce();
    int[] ids = boxes.ids();
    brute.rebuild(boxes.array, ids, ids.length);
    return Arrays.stream(Pairs.of(brute)).filter(p -> (int) (p >> 32) < cut).toArray();
  }

  /** What a search reports, the last piece first. */
  private static long[] found(PairSearch search, boolean[] marked, int workers) {
    int pieces = search.begin(marked, workers);
    try {
      return Pairs.of(
          v -> {
            for (int piece = pieces - 1; piece >= 0; piece--) {
              search.run(piece, piece % workers, v);
            }
          });
    } finally {
      search.end();
    }
  }

  @ParameterizedTest
  @EnumSource(Layout.class)
  void anyNumberOfWorkersFindsThePairsOfBruteForce(Layout layout) {
    for (int n : new int[] {0, 1, 2, 30, 1500}) {
      Boxes boxes = new Boxes(layout, n, 21);
      for (int cut : new int[] {0, n / 2, n - n / 5, n}) {
        PairSearch search = new PairSearch(treeOf(boxes, 0, cut), treeOf(boxes, cut, n));
        long[] expected = oracle(boxes, cut);
        for (int workers : new int[] {1, 2, 5}) {
          String where = boxes + " cut=" + cut + " workers=" + workers;
          assertArrayEquals(expected, found(search, null, workers), where);
        }
      }
    }
  }

  @ParameterizedTest
  @EnumSource(Layout.class)
  void onlyWhatMovedNeedBeLookedAt(Layout layout) {
    int cut = 400;
    for (long seed = 1; seed <= 3; seed++) {
      Boxes boxes = new Boxes(layout, 520, seed);
      KdTree tree = treeOf(boxes, 0, cut);
      PairSearch search = new PairSearch(tree, treeOf(boxes, cut, 520));
      int[] changed = new int[cut];
      for (int tick = 0; tick < 80; tick++) {
        boolean[] marked = new boolean[520];
        int n = 0;
        int share = tick % 4 == 0 ? 60 : 1 + boxes.below(20);
        float far = tick % 9 == 8 ? 300 : 0.3f;
        for (int id = 0; id < cut; id++) {
          if (boxes.below(100) < share) {
            boxes.shift(id, boxes.between(-far, far), boxes.between(-far, far));
            marked[id] = true;
            changed[n++] = id;
          }
        }
        tree.refit(changed, n);
        String where = boxes + " tick=" + tick;
        TreeCheck.check(tree, boxes.array, where);
        long[] all = oracle(boxes, cut);
        LongPredicate near = p -> marked[(int) (p >> 32)] || marked[(int) p];
        long[] expected = Arrays.stream(all).filter(near).toArray();
        long[] found = found(search, marked, 1 + tick % 2);
        assertArrayEquals(expected, Arrays.stream(found).filter(near).toArray(), where);
        if (tick % 4 == 0) {
          assertArrayEquals(all, found(search, null, 2), where);
        }
      }
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2})
  void whatRestsIsSkipped(int workers) {
    Boxes boxes = new Boxes(Layout.UNIFORM, 4000, 9);
    PairSearch search = new PairSearch(treeOf(boxes, 0, 4000), treeOf(boxes, 4000, 4000));
    boolean[] marked = new boolean[4000];
    assertEquals(0, found(search, marked, workers).length);
    marked[77] = true;
    int few = found(search, marked, workers).length;
    assertTrue(few < oracle(boxes, 4000).length / 20, "pairs near one marked box=" + few);
  }

  @Test
  void threadsSideBySideFindEveryPairOnce() {
    int n = 6000;
    Boxes boxes = new Boxes(Layout.UNIFORM, n, 10);
    PairSearch search = new PairSearch(treeOf(boxes, 0, 5000), treeOf(boxes, 5000, n));
    long[] expected = found(search, null, 1);
    try (WorkerThreads threads = new WorkerThreads(3)) {
      for (int round = 0; round < 20; round++) {
        LongStream.Builder[] lists = {
          LongStream.builder(), LongStream.builder(), LongStream.builder()
        };
        int pieces = search.begin(null, 3);
        threads.run(
            pieces,
            (piece, worker) ->
                search.run(piece, worker, (a, b) -> lists[worker].add((long) a << 32 | b)));
        search.end();
        long[] all =
            Arrays.stream(lists).flatMapToLong(LongStream.Builder::build).sorted().toArray();
        assertArrayEquals(expected, all, "round=" + round);
      }
    }
  }

  @Test
  void aVisitorThatThrowsLeavesTheSearchUsable() {
    Boxes boxes = new Boxes(Layout.UNIFORM, 300, 14);
    PairSearch search = new PairSearch(treeOf(boxes, 0, 200), treeOf(boxes, 200, 300));
    boolean[] marked = new boolean[300];
    Arrays.fill(marked, true);
    search.begin(marked, 2);
    PairVisitor angry =
        (a, b) -> {
          throw new IllegalStateException("enough");
        };
    assertThrows(IllegalStateException.class, () -> search.run(0, 0, angry));
    search.end();
    assertEquals(0, found(search, new boolean[300], 2).length);
    assertArrayEquals(oracle(boxes, 200), found(search, null, 2), boxes.toString());
  }
}
