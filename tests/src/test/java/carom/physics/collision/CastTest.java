package carom.physics.collision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Convex;
import carom.physics.geometry.Polygon;
import carom.physics.math.Transform;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

final class CastTest {
  private static final int SAMPLES = 400;

  private final Cast cast = new Cast();
  private final CastHit hit = new CastHit();
  private final Distance distance = new Distance();
  private final ClosestPoints points = new ClosestPoints();

  /** Goal: rays stop at the border, not earlier or later. Method: sample the way. */
  @Test
  void raysAgreeWithSampling() {
    int hits = 0;
    for (int kind = 0; kind < Oracle.KINDS; kind++) {
      for (long seed = 1; seed <= 400; seed++) {
        SplittableRandom random = new SplittableRandom(seed);
        Convex shape = Oracle.shape(kind, random);
        Transform t = Oracle.pose(random, 1);
        float x = (float) random.nextDouble(-3, 3);
        float y = (float) random.nextDouble(-3, 3);
        float dx = (float) random.nextDouble(-6, 6);
        float dy = (float) random.nextDouble(-6, 6);
        String message = "kind=" + kind + " seed=" + seed;
        boolean met = cast.ray(shape, t, x, y, dx, dy, 1, hit);
        boolean thin = shape.area() == 0;
        double end = met ? hit.fraction : 1;
        for (int i = 0; i <= SAMPLES && !thin; i++) {
          double f = end * i / SAMPLES;
          double d = Oracle.distance(shape, t, x + f * dx, y + f * dy);
          assertTrue(i == SAMPLES || hit.isInside() || d > -1e-5, message + " f=" + f + " d=" + d);
        }
        if (!met) {
          continue;
        }
        hits++;
        double start = Oracle.distance(shape, t, x, y);
        assertEquals(start < 0, hit.isInside(), message + " start=" + start);
        if (hit.isInside()) {
          assertEquals(0, hit.fraction, message);
          continue;
        }
        assertEquals(0, Oracle.distance(shape, t, hit.x, hit.y), 1e-5, message);
        assertEquals(1, Math.hypot(hit.normalX, hit.normalY), 1e-6, message);
        assertTrue(hit.normalX * dx + hit.normalY * dy <= 0, message);
        double px = hit.x + 0.01 * hit.normalX;
        double py = hit.y + 0.01 * hit.normalY;
        assertEquals(0.01, Oracle.distance(shape, t, px, py), 1e-5, message);
      }
    }
    assertTrue(hits > 40 * Oracle.KINDS, "hits=" + hits);
  }

  @Test
  void raysHaveTheirClosedForms() {
    Transform t = new Transform();
    assertTrue(cast.ray(new Circle(1), t, -3, 0.6f, 4, 0, 1, hit));
    assertEquals((3 - 0.8) / 4, hit.fraction, 1e-7);
    assertEquals(-0.8f, hit.normalX, 1e-6f);
    assertEquals(0.6f, hit.normalY, 1e-6f);
    assertTrue(cast.ray(new Circle(1), t, -3, 1, 4, 0, 1, hit), "touches at one point");
    assertFalse(cast.ray(new Circle(1), t, -3, 0, 4, 0, 0.49f, hit), "ends before");
    assertTrue(cast.ray(new Circle(1), t, -3, 0, 4, 0, 0.5f, hit), "ends on the border");
    Box box = new Box(1, 1);
    assertTrue(cast.ray(box, t, 5, 0.5f, -8, 0, 1, hit));
    assertEquals("0.5 1.0 0.0", hit.fraction + " " + hit.normalX + " " + hit.normalY);
    assertTrue(cast.ray(box, t, 5, 1, -8, 0, 1, hit), "slides along an edge");
    assertEquals("0.5 1.0 0.0", hit.fraction + " " + hit.normalX + " " + hit.normalY);
    assertFalse(cast.ray(box, t, 2, 0, 1, 0, 1, hit), "goes away");
    assertTrue(cast.ray(box, t, 0.3f, 0.3f, 0, 0, 1, hit) && hit.isInside(), "no length, inside");
    assertFalse(cast.ray(box, t, 1.3f, 0.3f, 0, 0, 1, hit), "no length, outside");
    assertTrue(cast.ray(box, t, 1, 0, 1, 0, 1, hit) && hit.isInside(), "begins on the border");
  }

  /** Goal: shapes stop when they touch, not earlier or later. Method: sample the way. */
  @Test
  void movingShapesAgreeWithSampling() {
    int hits = 0;
    for (int kinds = 0; kinds < Oracle.KINDS * Oracle.KINDS; kinds++) {
      for (long seed = 1; seed <= 60; seed++) {
        SplittableRandom random = new SplittableRandom(seed);
        Convex a = Oracle.shape(kinds / Oracle.KINDS, random);
        Convex b = Oracle.shape(kinds % Oracle.KINDS, random);
        Transform ta = Oracle.pose(random, 3);
        Transform tb = Oracle.pose(random, 1);
        float dx = (float) random.nextDouble(-6, 6);
        float dy = (float) random.nextDouble(-6, 6);
        String message = "kinds=" + kinds + " seed=" + seed;
        boolean met = cast.shape(a, ta, dx, dy, b, tb, 1, hit);
        Transform moved = new Transform().set(ta);
        double end = met ? hit.fraction : 1;
        if (!(met && hit.isInside())) {
          for (int i = 0; i < 100; i++) {
            double f = end * i / 100;
            moved.set((float) (ta.x + f * dx), (float) (ta.y + f * dy), ta.cos, ta.sin);
            assertTrue(distance.between(a, moved, b, tb, points) > 0, message + " f=" + f);
          }
        }
        if (met) {
          hits++;
          moved.set((float) (ta.x + end * dx), (float) (ta.y + end * dy), ta.cos, ta.sin);
          assertEquals(0, distance.between(a, moved, b, tb, points), 2e-6, message);
        }
        if (met && !hit.isInside()) {
          assertTrue(hit.normalX * dx + hit.normalY * dy < 0, message);
          assertEquals(0, Oracle.distance(b, tb, hit.x, hit.y), 1e-5, message);
          assertEquals(0, Oracle.distance(a, moved, hit.x, hit.y), 1e-5, message);
          moved.set(moved.x + 0.01f * hit.normalX, moved.y + 0.01f * hit.normalY, ta.cos, ta.sin);
          assertEquals(0.01, distance.between(a, moved, b, tb, points), 1e-5, message);
        }
      }
    }
    assertTrue(hits > 10 * Oracle.KINDS * Oracle.KINDS, "hits=" + hits);
  }

  @Test
  void aMovingBoxHasItsClosedForm() {
    Box box = new Box(0.5f, 0.5f);
    Transform t = new Transform();
    assertTrue(cast.shape(box, new Transform(-3, 0.2f, 0), 4, 0, box, t, 1, hit));
    assertEquals(0.5f, hit.fraction, 1e-6f);
    assertEquals("-1.0 0.0", hit.normalX + " " + hit.normalY);
    assertEquals(-0.5f, hit.x, 1e-6f);
    assertFalse(cast.shape(box, new Transform(-3, 1.001f, 0), 4, 0, box, t, 1, hit), "passes");
    assertFalse(cast.shape(box, new Transform(-3, 0, 0), 4, 0, box, t, 0.49f, hit), "ends before");
    assertTrue(cast.shape(box, new Transform(0.3f, 0, 0), -4, 0, box, t, 1, hit));
    assertTrue(hit.isInside(), "begins overlapping");
    Polygon tip = Polygon.of(0, 0, 1, 1, -1, 1);
    assertTrue(cast.shape(tip, new Transform(0.2f, 3, 0), 0, -10, box, t, 1, hit));
    assertEquals(0.25f, hit.fraction, 1e-6f);
  }
}
