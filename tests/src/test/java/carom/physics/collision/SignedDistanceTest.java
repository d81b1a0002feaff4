package carom.physics.collision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.geometry.Box;
import carom.physics.geometry.Capsule;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Convex;
import carom.physics.geometry.Polygon;
import carom.physics.geometry.Segment;
import carom.physics.math.Transform;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** The quick signed distance against the exact one. */
final class SignedDistanceTest {
  private static final Convex[] SHAPES = {
    new Circle(.5f, 1, 2),
    new Box(1, .3f, -.5f, 1),
    new Capsule(-1, 0, 2, 1, .4f),
    new Segment(-1, -1, 2, 0),
    Polygon.of(0, 0, 4, 0, 4.2f, .1f, 3, 3),
    Polygon.of(-3, 0, 3, -.05f, 3.1f, 0, 3, .05f),
  };

  @Test
  void agreesWithTheExactDistanceOutside() {
    long seed = 7;
    Random random = new Random(seed);
    SignedDistance quick = new SignedDistance();
    Distance exact = new Distance();
    ClosestPoints points = new ClosestPoints();
    for (int i = 0; i < 20000; i++) {
      Convex shape = SHAPES[i % SHAPES.length];
      float x = 12 * random.nextFloat() - 6;
      float y = 12 * random.nextFloat() - 6;
      float truth = exact.toPoint(shape, new Transform(), x, y, points);
      String what = "seed=" + seed + " " + shape + " at " + x + " " + y;
      float d = quick.measure(shape, x, y);
      if (truth > 1e-3f) {
        assertEquals(truth, d, 2e-5f, what);
        assertEquals(-points.normalX * -1, quick.normalX, 2e-3f / truth, what);
        assertEquals(points.normalY, quick.normalY, 2e-3f / truth, what);
      } else if (truth == 0) {
        assertTrue(d <= 1e-5f, what + " d=" + d);
      }
    }
  }

  @Test
  void insideIsTheWayToTheNearestEdge() {
    SignedDistance d = new SignedDistance();
    assertEquals(-.25f, d.measure(new Box(1, 2), .75f, .5f), 1e-6f);
    assertEquals(1, d.normalX);
    assertEquals(-.4f, d.measure(new Circle(.5f), 0, .1f), 1e-6f);
    assertEquals(1, d.normalY);
    assertEquals(-.3f, d.measure(new Capsule(-1, 0, 1, 0, .5f), .2f, -.2f), 1e-6f);
    assertEquals(-1, d.normalY);
  }
}
