package carom.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.collision.Cast;
import carom.physics.collision.CastHit;
import carom.physics.collision.ClosestPoints;
import carom.physics.collision.Distance;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Compound;
import carom.physics.geometry.Convex;
import carom.physics.geometry.Shape;
import carom.physics.math.Aabb;
import carom.physics.math.Transform;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

final class QueryTest {
  private final Cast cast = new Cast();
  private final CastHit castHit = new CastHit();
  private final Distance distance = new Distance();
  private final ClosestPoints points = new ClosestPoints();
  private final QueryHit<String> hit = new QueryHit<>();

  private record Found(float fraction, int body) {}

  private interface Measure {
    /** The fraction at which a part is met, or -1. */
    float of(Convex part, Transform pose);
  }

  /** Every body, every part, one after the other; sorted as documented. */
  private static List<Found> oracle(World<String> w, QueryFilter<String> filter, Measure measure) {
    List<Found> all = new ArrayList<>();
    w.forEachBody(
        b -> {
          float best = Float.POSITIVE_INFINITY;
          Transform centre = new Transform().set(b.centerX(), b.centerY(), b.cos(), b.sin());
          for (int i = 0; i < b.shapeCount(); i++) {
            if (filter == null ? b.sensor(i) : !filter.accepts(b, i)) {
              continue;
            }
            // The engine's own parts are relative to the centre of mass; so must these be.
            float lx = b.centerX() - b.x();
            float ly = b.centerY() - b.y();
            float localX = b.cos() * lx + b.sin() * ly;
            float localY = b.cos() * ly - b.sin() * lx;
            for (Convex part : b.shape(i).moved(-localX, -localY).parts()) {
              float f = measure.of(part, centre);
              best = f >= 0 ? Math.min(best, f) : best;
            }
          }
          if (best < Float.POSITIVE_INFINITY) {
            all.add(new Found(best, b.index()));
          }
        });
    all.sort(Comparator.comparing(Found::fraction).thenComparing(Found::body));
    return all;
  }

  private void compare(List<Found> expected, List<Found> actual, String message) {
    assertEquals(expected.size(), actual.size(), message + " " + expected + " " + actual);
    for (int i = 0; i < expected.size(); i++) {
      assertEquals(expected.get(i).fraction(), actual.get(i).fraction(), 1e-4, message);
    }
    List<Integer> a = new ArrayList<>(expected.stream().map(Found::body).toList());
    List<Integer> b = new ArrayList<>(actual.stream().map(Found::body).toList());
    Collections.sort(a);
    Collections.sort(b);
    assertEquals(a, b, message);
  }

  private static World<String> world(long seed) {
    World<String> w = Scenes.pile(120, seed);
    Scenes.steps(w, 30);
    return w;
  }

  @Test
  void raysFindWhatBruteForceFinds() {
    for (long seed = 1; seed <= 3; seed++) {
      World<String> w = world(seed);
      SplittableRandom random = new SplittableRandom(seed);
      for (int i = 0; i < 200; i++) {
        float x = in(random, -8, 8);
        float y = in(random, -2, 20);
        float dx = in(random, -15, 15);
        float dy = in(random, -15, 15);
        QueryFilter<String> filter = i % 3 == 0 ? null : (b, shape) -> (b.index() + shape) % 3 != 0;
        List<Found> expected =
            oracle(
                w,
                filter,
                (part, pose) ->
                    cast.ray(part, pose, x, y, dx, dy, 1, castHit) ? castHit.fraction : -1);
        List<Found> actual = new ArrayList<>();
        w.queries().rayAll(x, y, dx, dy, filter, h -> actual.add(found(h)));
        String message = "seed=" + seed + " ray=" + i;
        compare(expected, actual, message);
        for (int k = 1; k < actual.size(); k++) {
          assertTrue(actual.get(k - 1).fraction() <= actual.get(k).fraction(), message);
        }
        boolean any = w.queries().rayClosest(x, y, dx, dy, filter, hit);
        assertEquals(!actual.isEmpty(), any, message);
        assertEquals(any, w.queries().rayAny(x, y, dx, dy, filter), message);
        if (any) {
          assertEquals(actual.get(0), found(hit), message);
          assertEquals(hit.fraction() * Math.hypot(dx, dy), hit.distance(), 1e-4, message);
        }
      }
    }
  }

  private static Found found(QueryHit<String> h) {
    return new Found(h.fraction(), h.body().index());
  }

  private static float in(SplittableRandom random, double min, double max) {
    return (float) random.nextDouble(min, max);
  }

  @Test
  void movingShapesOverlapsAndNearestPointsFindWhatBruteForceFinds() {
    Shape shape = Compound.of(new Circle(0.3f, -0.5f, 0), new Box(0.4f, 0.2f));
    for (long seed = 4; seed <= 5; seed++) {
      World<String> w = world(seed);
      SplittableRandom random = new SplittableRandom(seed);
      for (int i = 0; i < 100; i++) {
        float x = in(random, -5, 5);
        float y = in(random, -2, 15);
        Transform at = new Transform(x, y, in(random, -3, 3));
        float dx = in(random, -8, 8);
        float dy = in(random, -8, 8);
        String message = "seed=" + seed + " query=" + i;
        List<Found> actual = new ArrayList<>();
        w.queries().shapeAll(shape, at, dx, dy, null, h -> actual.add(found(h)));
        compare(
            oracle(w, null, (p, pose) -> castShape(shape, at, dx, dy, p, pose)), actual, message);
        boolean any = w.queries().shapeClosest(shape, at, dx, dy, null, hit);
        assertEquals(any, w.queries().shapeAny(shape, at, dx, dy, null), message);
        if (any) {
          assertEquals(actual.get(0), found(hit), message);
        }
        actual.clear();
        w.queries().overlaps(shape, at, null, h -> actual.add(found(h)));
        compare(oracle(w, null, (p, pose) -> overlap(shape, at, p, pose)), actual, message);
        List<Found> near = oracle(w, null, (p, pose) -> distance.toPoint(p, pose, x, y, points));
        boolean within = w.queries().nearest(x, y, 1, null, hit);
        assertEquals(near.get(0).fraction() <= 1, within, message);
        if (within) {
          assertEquals(near.get(0).fraction(), hit.distance(), 1e-5, message);
          assertEquals(hit.distance(), Math.hypot(hit.x() - x, hit.y() - y), 1e-5, message);
        }
        actual.clear();
        w.queries().containing(x, y, null, h -> actual.add(found(h)));
        near.removeIf(f -> f.fraction() > 0);
        compare(near, actual, message);
      }
    }
  }

  private float castShape(
      Shape shape, Transform at, float dx, float dy, Convex part, Transform pose) {
    float best = -1;
    for (Convex own : shape.parts()) {
      if (cast.shape(own, at, dx, dy, part, pose, 1, castHit)
          && (best < 0 || castHit.fraction < best)) {
        best = castHit.fraction;
      }
    }
    return best;
  }

  private float overlap(Shape shape, Transform at, Convex part, Transform pose) {
    for (Convex own : shape.parts()) {
      if (distance.between(own, at, part, pose, points) == 0) {
        return 0;
      }
    }
    return -1;
  }

  @Test
  void equalFractionsComeByBodyIndexAndAVisitorClips() {
    World<String> w = Scenes.space();
    for (int i = 0; i < 40; i++) {
      Scenes.box(w, 5 + i / 4, 0, 0.4f, 0.4f, Material.DEFAULT);
    }
    List<Integer> order = new ArrayList<>();
    w.queries().rayAll(0, 0.1f, 20, 0, null, h -> order.add(h.body().index()));
    for (int i = 0; i < 40; i++) {
      assertEquals(i, order.get(i));
    }
    order.clear();
    w.queries().rayAll(0, 0.1f, 20, 0, null, h -> order.add(h.body().index()) && order.size() < 5);
    assertEquals(List.of(0, 1, 2, 3, 4), order);
    assertTrue(w.queries().rayClosest(0, 0.1f, 20, 0, (b, shape) -> b.index() >= 10, hit));
    assertEquals(10, hit.body().index());
  }

  @Test
  void movingBoxesMeetBoundingBoxes() {
    World<String> w = Scenes.space();
    Scenes.disc(w, 5, 0, 1, Material.DEFAULT);
    Aabb area = new Aabb(-1, 0.95f, 0, 2);
    assertTrue(w.queries().boxClosest(area, 10, 0, null, hit), "the disc itself is missed");
    assertTrue(w.queries().boxAny(area, 10, 0, null));
    assertFalse(w.queries().boxAny(area, 3.9f, 0, null), "the way ends before it");
    assertFalse(w.queries().boxAny(area, -10, 0, null));
    assertEquals(0.4f, hit.fraction(), 1e-6f);
    assertEquals("-1.0 0.0", hit.normalX() + " " + hit.normalY());
    assertEquals(4, hit.x(), 1e-6);
    assertFalse(w.queries().boxClosest(area.set(-1, 1.01f, 0, 2), 10, 0, null, hit));
    assertTrue(w.queries().boxClosest(area.set(4, 0, 6, 3), 10, 0, null, hit));
    assertEquals("0.0 0.0 0.0", hit.fraction() + " " + hit.normalX() + " " + hit.normalY());
    w.queries().boxAll(area.set(5, 5, 5, 5), 0, -10, null, h -> hit == null);
  }

  @Test
  void sensorsAreSeenOnlyWhenAskedFor() {
    World<String> w = Scenes.space();
    BodyDef def = new BodyDef().position(5, 0);
    def.shape(new ShapeDef(new Circle(1)).withSensor(true));
    w.createBody(def, "sensor");
    assertFalse(w.queries().rayAny(0, 0, 10, 0, null));
    assertTrue(w.queries().rayAny(0, 0, 10, 0, (b, shape) -> true));
  }

  @Test
  void badQuestionsAreRefusedAndQueriesCannotBeNested() {
    World<String> w = Scenes.space();
    Body<String> b = Scenes.disc(w, 5, 0, 1, Material.DEFAULT);
    Queries<String> q = w.queries();
    assertThrows(IllegalArgumentException.class, () -> q.rayAny(Float.NaN, 0, 1, 0, null));
    assertThrows(IllegalArgumentException.class, () -> q.rayAny(0, 0, 1e9f, 0, null));
    assertThrows(IllegalArgumentException.class, () -> q.nearest(0, 0, -1, null, hit));
    assertThrows(
        IllegalStateException.class,
        () -> q.rayAll(0, 0, 10, 0, null, h -> q.rayAny(0, 0, 1, 0, null)));
    assertThrows(
        IllegalStateException.class,
        () ->
            q.rayAny(
                0,
                0,
                10,
                0,
                (body, shape) -> {
                  w.destroyBody(body);
                  return true;
                }));
    assertTrue(b.isValid() && q.rayAny(0, 0, 10, 0, null), "an exception leaves it usable");
  }
}
