package carom.physics.math;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

final class IntervalTest {
  /** The shortest way out, positive up; touching needs none; of two equal ways the one down. */
  @ParameterizedTest
  @CsvSource({
    "0,2,1,5,-1",
    "1,5,0,2,1",
    "0,1,1,2,0",
    "0,1,3,4,0",
    "0,10,4,5,5",
    "4,5,0,10,-5",
    "6,7,0,10,4",
    "0,2,0,2,-2",
    "-1,1,-3,3,-4",
    "1,2,0,3,-2"
  })
  void theMtvIsTheShortestWayOut(float min, float max, float from, float to, float expected) {
    Interval a = new Interval(min, max);
    Interval b = new Interval(from, to);
    assertEquals(expected, a.mtv(b));
    boolean apart = max <= from || to <= min;
    assertEquals(apart ? Math.max(from - max, min - to) : -Math.abs(expected), a.separation(b));
    assertEquals(max >= from && to >= min, a.overlaps(b));
    Interval moved = new Interval(min + expected, max + expected);
    assertEquals(Math.max(0, a.separation(b)), moved.separation(b), 1e-6);
  }

  @Test
  void theReverseIsNegatedUnlessBothWaysAreEqual() {
    SplittableRandom r = new SplittableRandom(5);
    for (int i = 0; i < 1000; i++) {
      float x = (float) r.nextDouble(-2, 2);
      float y = (float) r.nextDouble(-2, 2);
      Interval a = new Interval(x, x + (float) r.nextDouble(0, 2));
      Interval b = new Interval(y, y + (float) r.nextDouble(0, 2));
      assertEquals(0f, a.mtv(b) + b.mtv(a), "i=" + i + " " + a + b);
    }
  }

  @Test
  void aShadowHoldsAllPointsAndNoMore() {
    float[] xs = {1, -2, 3};
    float[] ys = {4, 0, -1};
    Interval i = new Interval().project(xs, ys, 3, 1, 0);
    assertEquals("[-2.0, 3.0]", i.toString());
    assertEquals("[-1.0, 4.0]", i.project(xs, ys, 3, 0, 1).toString());
    assertEquals("[-2.0, 5.0]", i.project(xs, ys, 3, 1, 1).toString());
    assertEquals(7f, i.length());
    assertThrows(IllegalArgumentException.class, () -> i.project(xs, ys, 0, 1, 0));
  }

  @Test
  void intervalsAreSets() {
    Interval a = new Interval(0, 3);
    Interval b = new Interval(2, 5);
    assertTrue(a.contains(0) && a.contains(3) && !a.contains(3.01f) && !a.contains(Float.NaN));
    assertTrue(a.contains(new Interval(1, 3)) && !a.contains(b));
    assertEquals(new Interval(0, 5), a.union(b));
    assertEquals(new Interval(2, 3), a.intersection(b));
    assertEquals(new Interval(3, 3), a.intersection(new Interval(3, 4)));
    assertEquals(null, a.intersection(new Interval(4, 5)));
    assertEquals(a.hashCode(), new Interval(0, 3).hashCode());
  }
}
