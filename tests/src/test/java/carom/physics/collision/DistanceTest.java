package carom.physics.collision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Convex;
import carom.physics.geometry.Polygon;
import carom.physics.math.Transform;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

final class DistanceTest {
  private final Distance distance = new Distance();
  private final ClosestPoints out = new ClosestPoints();

  /** Goal: true distances for all pairs. Method: gaps of the shadows over many directions. */
  @Test
  void agreesWithBruteForceForEveryOrderedPairOfShapes() {
    for (int kinds = 0; kinds < Oracle.KINDS * Oracle.KINDS; kinds++) {
      for (long seed = 1; seed <= 80; seed++) {
        SplittableRandom random = new SplittableRandom(seed);
        Convex a = Oracle.shape(kinds / Oracle.KINDS, random);
        Convex b = Oracle.shape(kinds % Oracle.KINDS, random);
        Transform ta = Oracle.pose(random, 1.5);
        Transform tb = Oracle.pose(random, 1.5);
        String message = "kinds=" + kinds + " seed=" + seed + " ";
        double expected = Oracle.separation(a, ta, b, tb);
        float d = distance.between(a, ta, b, tb, out);
        message += out;
        assertEquals(d, out.distance);
        assertEquals(Math.max(0, expected), d, 2e-6, message);
        checkPoints(a, ta, b, tb, expected, message);
      }
    }
  }

  private void checkPoints(
      Convex a, Transform ta, Convex b, Transform tb, double expected, String message) {
    double onA = Oracle.distance(a, ta, ta.x + out.ax, ta.y + out.ay);
    double onB = Oracle.distance(b, tb, ta.x + out.bx, ta.y + out.by);
    if (expected > 1e-5) {
      assertEquals(0, onA, 2e-6, message);
      assertEquals(0, onB, 2e-6, message);
      assertEquals(1, Math.hypot(out.normalX, out.normalY), 1e-6, message);
      assertEquals(out.bx - out.ax, out.distance * out.normalX, 2e-6, message);
      assertEquals(out.by - out.ay, out.distance * out.normalY, 2e-6, message);
    } else if (expected < -1e-5) {
      assertTrue(onA < 1e-6 && onB < 1e-6, message + " onA=" + onA + " onB=" + onB);
      assertEquals(out.ax, out.bx, 1e-6, message);
      assertEquals(out.ay, out.by, 1e-6, message);
    }
  }

  @Test
  void closestFeaturesAreNamed() {
    Box box = new Box(1, 1);
    distance.between(box, new Transform(), Polygon.regular(4, 1), new Transform(3, 0, 0), out);
    assertEquals(1, out.distance, 1e-6);
    assertEquals(3, out.vertexA0 + out.vertexA1, "right edge, vertices 1 and 2");
    assertEquals(out.vertexB0, out.vertexB1, "left corner");
    assertEquals("1.0 0.0", out.normalX + " " + out.normalY);
    distance.between(box, new Transform(), box, new Transform(3, 4, 0), out);
    assertEquals(Math.sqrt(1 + 4), out.distance, 1e-6);
    assertEquals(
        "2 2 0 0", out.vertexA0 + " " + out.vertexA1 + " " + out.vertexB0 + " " + out.vertexB1);
  }

  @Test
  void touchingIsZeroAndGapsOfANanometreHaveTheirNormal() {
    Box box = new Box(1, 1);
    assertEquals(0, distance.between(box, new Transform(), box, new Transform(2, 0.3f, 0), out));
    Circle disc = new Circle(0.5f);
    distance.between(disc, new Transform(), disc, new Transform(), out);
    assertEquals("0.0 0.0 0.0", out.distance + " " + out.normalX + " " + out.normalY);
    distance.between(disc, new Transform(), disc, new Transform(0.6f, 0, 0), out);
    assertEquals("0.0 1.0 0.3", out.distance + " " + out.normalX + " " + out.ax);
    float gap = 1.2e-7f;
    distance.between(box, new Transform(), box, new Transform(2 + 2 * gap, 1.9f, 0), out);
    assertTrue(out.distance > 1e-7 && out.distance < 4e-7, out.toString());
    assertEquals("1.0 0.0", out.normalX + " " + out.normalY);
  }

  @Test
  void farFromTheOriginIsAsExactAsNear() {
    Transform ta = new Transform(1e6f, -1e6f, 0.5f);
    Transform tb = new Transform(1e6f + 3, -1e6f + 1, -0.3f);
    Transform near = new Transform(3, 1, -0.3f);
    Polygon p = Polygon.regular(5, 0.8f);
    float far = distance.between(p, ta, p, tb, out);
    assertEquals(distance.between(p, new Transform(0, 0, 0.5f), p, near, out), far);
  }

  @Test
  void pointsAreMeasuredLikeDiscsWithoutRadius() {
    for (long seed = 1; seed <= 200; seed++) {
      SplittableRandom random = new SplittableRandom(seed);
      Convex a = Oracle.shape((int) (seed % Oracle.KINDS), random);
      Transform ta = Oracle.pose(random, 2);
      float x = (float) random.nextDouble(-2, 2);
      float y = (float) random.nextDouble(-2, 2);
      double expected = Math.max(0, Oracle.distance(a, ta, x, y));
      assertEquals(expected, distance.toPoint(a, ta, x, y, out), 2e-6, "seed=" + seed);
    }
  }
}
