package carom.physics.dynamics.body;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.geometry.Box;
import carom.physics.geometry.Capsule;
import carom.physics.geometry.Chain;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Convex;
import carom.physics.geometry.Polygon;
import carom.physics.geometry.Segment;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

final class ShapePoolTest {
  /** No two of these are the same, though some differ by a sign of zero or a neighbour only. */
  private static List<Convex> shapes() {
    List<Convex> all = new ArrayList<>();
    all.add(new Circle(0.5f));
    all.add(new Circle(0.5f, 0, 1));
    all.add(new Circle(0.5f, 0, -0f));
    all.add(new Box(0.5f, 0.5f));
    all.add(new Box(0.5f, 0.25f));
    all.add(new Box(0.5f, 0.5f, 0, 1));
    all.add(Polygon.regular(5, 0.3f));
    all.add(Polygon.of(-0.5f, -0.5f, 0.5f, -0.5f, 0.5f, 0.5f, -0.5f, 0.5f));
    all.add(Polygon.rounded(0.1f, -0.5f, -0.5f, 0.5f, -0.5f, 0.5f, 0.5f, -0.5f, 0.5f));
    all.add(new Capsule(0, 0, 1, 0, 0.1f));
    all.add(new Capsule(0, 0, 1, 0, 0.2f));
    all.add(new Segment(0, 0, 1, 0));
    all.addAll(Chain.open(0, 0, 1, 0, 2, 0).parts());
    return all;
  }

  @Test
  void onlyTheSameIsShared() {
    List<Convex> first = shapes();
    List<Convex> second = shapes();
    for (int i = 0; i < first.size(); i++) {
      ShapePool pool = new ShapePool();
      assertSame(first.get(i), pool.share(first.get(i)));
      for (int j = 0; j < second.size(); j++) {
        String message = first.get(i) + " and " + second.get(j);
        boolean same = first.get(i).isSame(second.get(j));
        assertTrue(i == j ? same : !same, message);
        assertFalse(same && !second.get(j).isSame(first.get(i)), message);
      }
      assertSame(first.get(i), pool.share(second.get(i)));
    }
  }

  @Test
  void partsThatMissEachOtherAreTwoObjects() {
    ShapePool pool = new ShapePool();
    Circle kept = new Circle(0.5f);
    pool.share(kept);
    for (int i = 1; i < 5000; i++) {
      Circle other = new Circle(0.5f + i * 1e-3f);
      assertTrue(pool.share(other).isSame(other));
    }
    assertNotSame(kept, pool.share(new Circle(0.5f)));
  }
}
