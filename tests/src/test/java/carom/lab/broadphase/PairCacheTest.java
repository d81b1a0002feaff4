package carom.lab.broadphase;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.fixtures.Allocations;
import carom.physics.broadphase.Boxes;
import carom.physics.broadphase.Boxes.Layout;
import carom.physics.broadphase.BruteForce;
import carom.physics.broadphase.KdTree;
import carom.physics.broadphase.PairVisitor;
import carom.physics.broadphase.Pairs;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

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

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void boxesThatBounceBetweenWallsAgreeWithTheTree(boolean clustered) {
    BroadphaseScene scene = new BroadphaseScene(2000, clustered);
    KdTree tree = new KdTree(scene.boxes());
    tree.rebuild(scene.boxes(), scene.ids(), 2000);
    PairCache cache = new PairCache();
    cache.rebuild(scene.boxes(), scene.ids(), 2000);
    for (int tick = 0; tick < 150; tick++) {
      scene.step();
      tree.refit();
      cache.refit();
      assertArrayEquals(Pairs.of(tree), Pairs.of(cache::pairs), "tick=" + tick);
    }
  }

  /** Most rest, so rooms are for many ticks; some jitter, some fall, some fly away for good. */
  @ParameterizedTest
  @EnumSource(Layout.class)
  void roomsGrowOneByOne(Layout layout) {
    Boxes boxes = new Boxes(layout, 131, 45);
    BruteForce oracle = new BruteForce();
    PairCache cache = new PairCache(1); // as if far away in memory
    cache.rebuild(boxes.array, boxes.ids(), 131);
    for (int tick = 0; tick < 50; tick++) {
      for (int id = 0; id < 10; id++) {
        boxes.shift(id, 0.2f * id, -0.001f * tick * id);
        boxes.shift(100 + id, boxes.between(-0.3, 0.3), boxes.between(-0.3, 0.3));
      }
      boxes.shift(130, 1e30f, 0);
      cache.refit();
      oracle.rebuild(boxes.array, boxes.ids(), 131);
      assertArrayEquals(Pairs.of(oracle), Pairs.of(cache::pairs), boxes + " tick=" + tick);
    }
  }

  /** Few boxes for long, many seeds, each with a mix of its own of speeds, turns, rests, sizes. */
  @ParameterizedTest
  @ValueSource(ints = {1, 2, 5, 31, 33, 64, 150})
  void longRunsOfAnyMotionAreExact(int count) {
    for (int seed = 0; seed < 8; seed++) {
      Boxes boxes = new Boxes(seed % 2 == 0 ? Layout.UNIFORM : Layout.CLUSTERED, count, seed);
      float[] way = new float[2 * count];
      double moving = boxes.between(0, 1);
      double turning = Math.pow(boxes.between(0, 0.7), 3);
      double speed = Math.pow(10, boxes.between(-3, 0.3));
      float side = (float) (2 * Math.sqrt(count));
      BruteForce oracle = new BruteForce();
      PairCache cache = new PairCache(seed % 4 < 2 ? 1 : BOXES); // some as if far away in memory
      cache.rebuild(boxes.array, boxes.ids(), count);
      for (int tick = 0; tick < 40_000 / (count + 20); tick++) {
        for (int id = 0; id < count * moving; id++) {
          if (tick == 0 || boxes.between(0, 1) < turning) {
            way[2 * id] = boxes.between(-speed, speed);
            way[2 * id + 1] = boxes.between(-speed, speed);
          }
          boolean out =
              Math.abs(boxes.array.minX(id)) > side || Math.abs(boxes.array.minY(id)) > side;
          if (out && boxes.below(3) > 0) {
            boxes.place(id);
          } else {
            boxes.shift(id, way[2 * id], way[2 * id + 1]);
          }
        }
        cache.refit();
        oracle.rebuild(boxes.array, boxes.ids(), count);
        assertArrayEquals(Pairs.of(oracle), Pairs.of(cache::pairs), boxes + " tick=" + tick);
      }
    }
  }

  /** After hours as after a minute: what was near once is forgotten. */
  @ParameterizedTest
  @ValueSource(ints = {30, 150})
  void fewThatFlyAboutDoNotFillTheLists(int flying) {
    Boxes boxes = new Boxes(Layout.UNIFORM, 300, 47);
    BruteForce oracle = new BruteForce();
    PairCache cache = new PairCache();
    cache.rebuild(boxes.array, boxes.ids(), 300);
    float[] way = new float[2 * flying];
    int most = 0;
    for (int tick = 0; tick < 12_000; tick++) {
      for (int id = 0; id < flying; id++) {
        for (int axis = 0; axis < 2; axis++) {
          float at = boxes.array.edges[4 * id + axis];
          float speed = at < 0 ? 0.1f : at > 25 ? -0.1f : way[2 * id + axis];
          way[2 * id + axis] = tick % 97 == id ? boxes.between(-0.1, 0.1) : speed;
        }
        boxes.shift(id, way[2 * id], way[2 * id + 1]);
      }
      cache.refit();
      most = Math.max(most, tick < 200 ? 0 : cache.kept());
      if (tick % 100 == 0) {
        oracle.rebuild(boxes.array, boxes.ids(), 300);
        assertArrayEquals(Pairs.of(oracle), Pairs.of(cache::pairs), boxes + " tick=" + tick);
      }
    }
    assertTrue(most < 4000, boxes + " most=" + most);
  }

  @Test
  void idsThatComeTwiceOrAreTooManyAreRefused() {
    Boxes boxes = new Boxes(Layout.UNIFORM, 50, 46);
    PairCache cache = new PairCache();
    Exception twice =
        assertThrows(
            IllegalArgumentException.class,
            () -> cache.rebuild(boxes.array, new int[] {3, 9, 3}, 3));
    assertTrue(twice.getMessage().contains("id=3 comes twice in ids, index=2"));
    Exception beyond =
        assertThrows(
            IllegalArgumentException.class, () -> cache.rebuild(boxes.array, new int[] {50}, 1));
    assertTrue(beyond.getMessage().contains("id=50"), beyond.getMessage());
    Exception many =
        assertThrows(
            IllegalArgumentException.class, () -> cache.rebuild(boxes.array, new int[3], 4));
    assertTrue(many.getMessage().contains("count=4, limit 0..3"), many.getMessage());
    assertEquals(0, cache.size());
  }

  @Test
  void steadyTicksDoNotAllocate() {
    BroadphaseScene scene = new BroadphaseScene(3000, false);
    PairCache cache = new PairCache();
    cache.rebuild(scene.boxes(), scene.ids(), 3000);
    long[] count = new long[1];
    PairVisitor visitor = (a, b) -> count[0]++;
    long least =
        Allocations.least(
            6,
            () -> {
              for (int tick = 0; tick < 60; tick++) {
                scene.step();
                cache.refit();
                cache.pairs(visitor);
              }
            });
    assertTrue(least < 200, "bytes in 60 ticks=" + least + " (the counter itself needs a few)");
  }
}
