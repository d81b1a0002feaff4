package carom.physics.collision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Polygon;
import carom.physics.geometry.Shape;
import carom.physics.math.Transform;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** The lecture's ways to separate bodies, and its points of collision of circles. */
class SeparationTest {
  private final long seed = new Random().nextLong();
  private final Random random = new Random(seed);

  private Shape shape() {
    return switch (random.nextInt(3)) {
      case 0 -> new Circle(0.2f + random.nextFloat());
      case 1 -> new Box(0.2f + random.nextFloat(), 0.2f + random.nextFloat());
      default -> Polygon.regular(3 + random.nextInt(6), 0.3f + random.nextFloat());
    };
  }

  @Test
  void movingByTheMtvSeparates() {
    Sat sat = new Sat();
    Mtv mtv = new Mtv();
    int overlaps = 0;
    for (int i = 0; i < 2000; i++) {
      Shape a = shape();
      Shape b = shape();
      Transform ta = new Transform(random.nextFloat(), random.nextFloat(), 6 * random.nextFloat());
      Transform tb = new Transform(0, 0, 6 * random.nextFloat());
      if (!sat.mtv(a, ta, b, tb, mtv)) {
        continue;
      }
      overlaps++;
      Separation how = random.nextBoolean() ? Separation.HALVES : Separation.BY_SPEED;
      float share = how.shareOfA(3 * random.nextFloat(), random.nextInt(2));
      ta.x += share * mtv.x;
      ta.y += share * mtv.y;
      tb.x -= (1 - share) * mtv.x;
      tb.y -= (1 - share) * mtv.y;
      float left = sat.mtv(a, ta, b, tb, mtv) ? mtv.length() : 0;
      assertEquals(0, left, 1e-5, "seed=" + seed + " " + a + " " + b);
    }
    assertTrue(overlaps > 500);
  }

  @Test
  void sharesFollowSpeeds() {
    assertEquals(0.5f, Separation.HALVES.shareOfA(3, 1));
    assertEquals(0.75f, Separation.BY_SPEED.shareOfA(3, 1));
    assertEquals(0, Separation.BY_SPEED.shareOfA(0, 1));
    assertEquals(0.5f, Separation.BY_SPEED.shareOfA(0, 0));
  }

  @Test
  void theImpulseReversesTheSpeedOfApproach() {
    Mtv mtv = new Mtv().set(-0.1f, 0);
    float j = Separation.impulse(mtv, 4, 2, 1, 3, 0.5f);
    assertEquals(1.5f, j, 1e-6);
    float after = 4 - j * (1 + 3); // the unit vector of the MTV is (-1, 0)
    assertEquals(-2, after, 1e-5);
    assertEquals(0, Separation.impulse(mtv, -4, 2, 1, 3, 0.5f));
    assertEquals(0, Separation.impulse(mtv, 4, 2, 0, 0, 0.5f));
  }

  @Test
  void circlesHaveTheirOwnRules() {
    PointOfCollision p = new PointOfCollision();
    p.betweenCircles(3, 0, 1, 2);
    assertEquals(1, p.x, 1e-6);
    Mtv mtv = new Mtv().set(0, 0.5f);
    assertTrue(p.onCircle(2, 3, 1, mtv, true));
    assertEquals(2, p.x);
    assertEquals(2, p.y);
    assertTrue(p.onCircle(2, 3, 1, mtv, false));
    assertEquals(4, p.y);
    assertFalse(p.onCircle(2, 3, 1, new Mtv(), true));
  }
}
