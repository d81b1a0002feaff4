package carom.physics.collision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.physics.math.Transform;
import org.junit.jupiter.api.Test;

final class PointOfCollisionTest {
  private final PointOfCollision point = new PointOfCollision();
  private final Manifold m = new Manifold();
  private final Box box = new Box(1, 1);
  private final Transform here = new Transform();

  @Test
  void theThreeRulesAgreeOnABoxThatSitsEvenlyOnAnother() {
    Box small = new Box(0.5f, 0.5f);
    Transform above = new Transform(0.2f, 1.4f, 0);
    new Collider().collide(box, here, small, above, 0.1f, m);
    assertTrue(point.clippedMiddle(m));
    assertPoint(0.2f, 0.95f);
    assertTrue(point.deepest(m));
    assertPoint(0.2f, 0.95f);
    assertTrue(point.verticesInside(box, here, small, above));
    assertPoint(0.2f, 0.9f);
  }

  @Test
  void aTiltedBoxIsDeepestAtItsCorner() {
    Transform tilted = new Transform(0, 1.9f, 0.2f);
    new Collider().collide(box, here, box, tilted, 0.3f, m);
    assertTrue(point.deepest(m));
    assertTrue(point.x < -0.5f || point.x > 0.5f, point.toString());
    float deepestX = point.x;
    assertTrue(point.clippedMiddle(m));
    assertTrue(Math.abs(point.x) < Math.abs(deepestX), point + " x=" + deepestX);
  }

  @Test
  void withoutVerticesInsideOrWithoutContactThereIsNoPoint() {
    Circle disc = new Circle(1);
    assertFalse(point.verticesInside(disc, here, disc, new Transform(1.5f, 0, 0)));
    assertFalse(point.deepest(new Manifold()) || point.clippedMiddle(new Manifold()));
    assertPoint(0, 0);
    Transform away = new Transform(10, 1.5f, 0);
    assertTrue(point.verticesInside(new Box(1, 1, 10, 0), here, box, away));
    assertPoint(10, 0.75f);
  }

  private void assertPoint(float x, float y) {
    assertEquals(x, point.x, 1e-5f);
    assertEquals(y, point.y, 1e-5f);
  }
}
