package carom.physics.broadphase;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A refit in pieces, in any order, is that of one thread. */
final class KdRefitTest {
  private static final int COUNT = 3_000;

  private final AabbArray boxes = new AabbArray(COUNT);
  private final KdTree whole = new KdTree(boxes);
  private final KdTree pieces = new KdTree(boxes);

  private void place(SplittableRandom r) {
    for (int id = 0; id < COUNT; id++) {
      move(id, (float) r.nextDouble() * 100, (float) r.nextDouble() * 100);
    }
    int[] ids = IntStream.range(0, COUNT).toArray();
    whole.rebuild(boxes, ids, COUNT);
    pieces.rebuild(boxes, ids, COUNT);
  }

  private void move(int id, float x, float y) {
    boxes.set(id, x, y, x + 1, y + 1);
  }

  private static void refitBackwards(KdTree tree) {
    KdRefit refit = tree.refitting();
    for (int piece = refit.begin() - 1; piece >= 0; piece--) {
      refit.read(piece);
    }
    for (int piece = refit.gather() - 1; piece >= 0; piece--) {
      refit.route(piece);
    }
    refit.end();
  }

  private static List<String> cells(KdTree tree) {
    List<String> all = new ArrayList<>();
    tree.cells(
        (minX, minY, maxX, maxY, depth) -> all.add(minX + " " + minY + " " + maxX + " " + maxY));
    return all;
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3})
  void piecesMakeTheSameTree(long seed) {
    SplittableRandom r = new SplittableRandom(seed);
    place(r);
    boolean strayed = false;
    for (int round = 0; round < 40; round++) {
      float drift = round / 10 % 2; // all together, so that cells ride along
      float way = round % 5 == 4 ? 50 : 0.5f; // so that many leave their cells, or few
      for (int id = 0; id < COUNT; id++) {
        float dx = drift + way * ((float) r.nextDouble() - 0.5f);
        float dy = way * ((float) r.nextDouble() - 0.5f);
        move(id, boxes.minX(id) + dx, boxes.minY(id) + dy);
      }
      whole.refit();
      refitBackwards(pieces);
      String when = "seed=" + seed + " round=" + round;
      strayed |= whole.strays() > 0;
      assertEquals(whole.strays(), pieces.strays(), when);
      assertEquals(whole.built(), pieces.built(), when);
      assertEquals(cells(whole), cells(pieces), when);
      int[] ids = new int[COUNT];
      int[] same = new int[COUNT];
      assertEquals(COUNT, whole.slice(0, 1, ids), when);
      assertEquals(COUNT, pieces.slice(0, 1, same), when);
      assertArrayEquals(ids, same, when);
    }
    assertTrue(strayed);
  }

  @Test
  void aBadBoxEmptiesTheTreeInAnyOrderOfReading() {
    place(new SplittableRandom(1));
    float[] bad = {Float.NaN, Float.POSITIVE_INFINITY, 1e30f};
    for (float x : bad) {
      boxes.set(1_234, x, 0, x == 1e30f ? -x : x, 1);
      IllegalArgumentException e =
          assertThrows(IllegalArgumentException.class, () -> refitBackwards(pieces));
      assertTrue(e.getMessage().contains("1234"), e.getMessage());
      assertEquals(0, pieces.size());
      place(new SplittableRandom(2));
    }
  }

  @Test
  void anEmptyTreeHasNoPieces() {
    assertEquals(0, whole.refitting().begin());
    assertEquals(0, whole.refitting().gather());
    whole.refitting().end();
    assertEquals(0, whole.size());
  }
}
