package carom.physics.broadphase;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.broadphase.Boxes.Layout;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Cached pairs against those of all boxes against all, in every tick of all kinds of motion. */
class PairCacheTest {
  private static final int BOXES = 257;

  @ParameterizedTest
  @EnumSource(Layout.class)
  void pairsAreExactInEveryTick(Layout layout) {
    Boxes boxes = new Boxes(layout, BOXES, 41);
    for (int id = 0; id < BOXES; id += 9) {
      boxes.setPresent(id, false);
    }
    int[] ids = boxes.ids();
    BruteForce oracle = new BruteForce();
    PairCache cache = new PairCache();
    cache.rebuild(boxes.array, ids, ids.length);
    assertEquals(ids.length, cache.size());
    for (int tick = 0; tick < 80; tick++) {
      for (int id : ids) {
        boxes.shift(id, id % 7 * 0.01f - 0.03f, id % 5 * 0.01f - 0.02f);
      }
      if (tick % 20 == 19) {
        boxes.drift(0.5);
      }
      for (int i = 0; i < tick % 4; i++) {
        boxes.place(ids[boxes.below(ids.length)]);
      }
      cache.refit();
      oracle.rebuild(boxes.array, ids, ids.length);
      assertArrayEquals(Pairs.of(oracle), Pairs.of(cache::pairs), boxes + " tick=" + tick);
    }
  }

  @Test
  void startsAnewWithOtherBoxes() {
    PairCache cache = new PairCache();
    Boxes many = new Boxes(Layout.UNIFORM, 100, 42);
    Boxes few = new Boxes(Layout.UNIFORM, 40, 43);
    cache.rebuild(many.array, many.ids(), 100);
    cache.rebuild(few.array, few.ids(), 40);
    BruteForce oracle = new BruteForce();
    oracle.rebuild(few.array, few.ids(), 40);
    assertArrayEquals(Pairs.of(oracle), Pairs.of(cache::pairs));
    cache.rebuild(few.array, new int[0], 0);
    cache.refit();
    assertEquals(0, Pairs.of(cache::pairs).length);
  }

  @Test
  void badBoxesAreRefusedByName() {
    Boxes boxes = new Boxes(Layout.UNIFORM, 50, 44);
    PairCache cache = new PairCache();
    cache.rebuild(boxes.array, boxes.ids(), 50);
    boxes.array.set(17, 3, Float.NaN, 4, 5);
    Exception moved = assertThrows(IllegalArgumentException.class, cache::refit);
    assertTrue(moved.getMessage().contains("id=17"), moved.getMessage());
    assertEquals(0, cache.size());
    Exception made =
        assertThrows(
            IllegalArgumentException.class, () -> cache.rebuild(boxes.array, boxes.ids(), 50));
    assertTrue(made.getMessage().contains("id=17"), made.getMessage());
    assertEquals(0, cache.size());
    boxes.array.set(17, 4, 3, 3, 5);
    assertThrows(IllegalArgumentException.class, () -> cache.rebuild(boxes.array, boxes.ids(), 50));
  }
}
