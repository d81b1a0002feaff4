package carom.physics.collision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Compound;
import carom.physics.geometry.Convex;
import carom.physics.geometry.Polygon;
import carom.physics.math.Transform;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

final class SatTest {
  private final Sat sat = new Sat();
  private final Mtv mtv = new Mtv();
  private final Mtv back = new Mtv();

  /**
   * Goal: the shortest way out, for all pairs. Method: gaps of the shadows over many directions.
   */
  @Test
  void isTheTrueMinimumForEveryOrderedPairOfShapes() {
    for (int kinds = 0; kinds < Oracle.KINDS * Oracle.KINDS; kinds++) {
      for (long seed = 1; seed <= 120; seed++) {
        SplittableRandom random = new SplittableRandom(seed);
        Convex a = Oracle.shape(kinds / Oracle.KINDS, random);
        Convex b = Oracle.shape(kinds % Oracle.KINDS, random);
        Transform ta = Oracle.pose(random, seed % 3 == 0 ? 0.1 : 0.8);
        Transform tb = Oracle.pose(random, seed % 3 == 0 ? 0.1 : 0.8);
        String message = "kinds=" + kinds + " seed=" + seed;
        double separation = Oracle.separation(a, ta, b, tb);
        boolean overlap = sat.mtv(a, ta, b, tb, mtv);
        assertEquals(separation < 0, overlap, message + " separation=" + separation);
        assertEquals(Math.max(0, -separation), mtv.length(), 1e-4, message);
        assertEquals(overlap, sat.mtv(b, tb, a, ta, back), message);
        assertTrue(mtv.x == -back.x && mtv.y == -back.y, message + " reversal");
        if (overlap) {
          Transform out = new Transform().set(ta.x + mtv.x, ta.y + mtv.y, ta.cos, ta.sin);
          assertEquals(0, Oracle.separation(a, out, b, tb), 1e-4, message);
          out.set(ta.x + 0.9f * mtv.x, ta.y + 0.9f * mtv.y, ta.cos, ta.sin);
          assertTrue(sat.mtv(a, out, b, tb, back), message + " 0.9 of the way");
        }
      }
    }
  }

  @Test
  void tiesAndCoincidencesHaveTheirDocumentedAnswers() {
    Transform t = new Transform();
    Circle small = new Circle(1);
    Circle large = new Circle(2);
    assertMtv(small, t, large, t, 0, -3);
    assertMtv(large, t, small, t, 0, 3);
    Box box = new Box(2, 1);
    assertMtv(small, new Transform(0, 1, 0), box, t, 0, 1);
    assertMtv(small, new Transform(2, 1, 0), box, t, 1, 0);
    assertMtv(small, new Transform(0.5f, 0.9f, 0), box, t, 0, 1.1f);
    assertMtv(new Box(0.1f, 0.1f), new Transform(1.5f, 0, 0), box, t, 0.6f, 0);
    assertFalse(sat.mtv(small, new Transform(3, 0, 0), box, t, mtv));
    assertEquals(0f, mtv.length());
  }

  private void assertMtv(Convex a, Transform ta, Convex b, Transform tb, float x, float y) {
    assertTrue(sat.mtv(a, ta, b, tb, mtv));
    assertEquals(x, mtv.x, 1e-5f);
    assertEquals(y, mtv.y, 1e-5f);
  }

  @Test
  void compoundsAnswerTheirDeepestPair() {
    Compound l = Compound.of(new Box(1, 0.1f), new Box(0.1f, 1, -0.9f, 1));
    Transform t = new Transform();
    Transform above = new Transform(0.5f, 0.5f, 0);
    assertTrue(sat.mtv(new Circle(0.5f), above, l, t, mtv));
    assertEquals(0.1f, mtv.y, 1e-5f);
    assertTrue(sat.mtv(l, t, new Circle(0.5f), above, back));
    assertTrue(mtv.x == -back.x && mtv.y == -back.y);
    above.set(-0.05f, 0.03f, 0.2f);
    assertTrue(sat.mtv(l, t, l, above, mtv) && sat.mtv(l, above, l, t, back));
    assertTrue(mtv.x == -back.x && mtv.y == -back.y);
    assertFalse(sat.mtv(Polygon.regular(5, 0.2f), new Transform(0.6f, 1, 0), l, t, mtv));
  }
}
