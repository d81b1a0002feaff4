package carom.physics.dynamics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.collision.Collider;
import carom.physics.collision.Manifold;
import carom.physics.geometry.Box;
import carom.physics.geometry.Convex;
import carom.physics.geometry.Polygon;
import carom.physics.math.Transform;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

final class KeptManifoldsTest {
  private static final float SPECULATIVE = 0.02f;

  private final KeptManifolds.Desk desk = new KeptManifolds.Desk();
  private final int[] hints = new int[1];
  private final Manifold m = new Manifold();
  private final Manifold fresh = new Manifold();

  /**
   * Goal: keeping shows in no bit. Method: wander in steps small and large; ask one that forgot.
   */
  @Test
  void whatIsKeptIsWhatWouldBeComputed() {
    int touched = 0;
    for (long seed = 1; seed <= 200; seed++) {
      SplittableRandom random = new SplittableRandom(seed);
      Convex a = shape(random);
      Convex b = shape(random);
      Transform ta = pose(random, 0.3, 3);
      Transform tb = pose(random, 1, 3);
      KeptManifolds kept = kept();
      double step = random.nextBoolean() ? 1e-4 : 3e-3;
      for (int i = 0; i < 300; i++) {
        wander(ta, random, step);
        wander(tb, random, step);
        String message = "seed=" + seed + " step=" + i;
        find(kept, a, ta, b, tb, m);
        find(kept(), a, ta, b, tb, fresh);
        assertEquals(fresh.count, m.count, message);
        if (m.count > 0) {
          touched++;
          assertEquals(fresh.toString(), m.toString(), message);
        }
      }
    }
    assertTrue(touched > 5000, "touched=" + touched);
  }

  /**
   * Goal: gaps and normals are those of the true pose. Method: the collider itself, same points.
   */
  @Test
  void followsTheTruePose() {
    Collider collider = new Collider();
    int compared = 0;
    for (long seed = 1; seed <= 20000; seed++) {
      SplittableRandom random = new SplittableRandom(seed);
      Convex a = shape(random);
      Convex b = shape(random);
      Transform ta = pose(random, 0.3, 3);
      Transform tb = pose(random, 1, 3);
      find(kept(), a, ta, b, tb, m);
      collider.collide(a, ta, b, tb, SPECULATIVE, fresh);
      boolean same = m.count == 2 && fresh.count == 2 && m.id0 == fresh.id0 && m.id1 == fresh.id1;
      // Of two equally good faces the other one may be taken.
      if (same && m.normalX * fresh.normalX + m.normalY * fresh.normalY > 0.9999f) {
        String message = "seed=" + seed;
        compared++;
        assertEquals(fresh.normalX, m.normalX, 1e-5f, message);
        assertEquals(fresh.normalY, m.normalY, 1e-5f, message);
        // The end of a face may slide along the other by half a cell, where that is steep.
        assertEquals(fresh.separation0, m.separation0, KeptManifolds.CELL, message);
        assertEquals(fresh.separation1, m.separation1, KeptManifolds.CELL, message);
        assertEquals(fresh.x0, m.x0, 2 * KeptManifolds.CELL, message);
        assertEquals(fresh.y0, m.y0, 2 * KeptManifolds.CELL, message);
      }
    }
    assertTrue(compared > 1000, "compared=" + compared);
  }

  /**
   * Goal: a level face gives a level gap, smooth to rounding. Method: lower a box in 10 um steps.
   */
  @Test
  void gapOfAFaceHasNoSteps() {
    Convex ground = new Box(50, 1, 0, 0);
    Convex box = new Box(0.5f, 0.5f, 0, 0);
    Transform ta = new Transform();
    KeptManifolds kept = kept();
    for (int i = 0; i < 1000; i++) {
      float gap = 5e-3f - 1e-5f * i;
      find(kept, ground, ta, box, new Transform(3.3f, 1.5f + gap, 0), m);
      assertEquals(2, m.count);
      assertEquals(gap, m.separation0, 1e-6f);
      assertEquals(gap, m.separation1, 1e-6f);
      assertEquals(0, m.normalX);
      assertEquals(1, m.normalY);
    }
  }

  private static KeptManifolds kept() {
    KeptManifolds kept = new KeptManifolds();
    kept.ensure(1);
    return kept;
  }

  private void find(
      KeptManifolds kept, Convex a, Transform ta, Convex b, Transform tb, Manifold out) {
    kept.collide(0, a, ta, b, tb, 1.5f, SPECULATIVE, hints, desk, out);
  }

  private static Convex shape(SplittableRandom random) {
    if (random.nextBoolean()) {
      return new Box(
          (float) random.nextDouble(0.1, 0.7), (float) random.nextDouble(0.1, 0.7), 0, 0);
    }
    float[] xy = new float[2 * random.nextInt(3, 9)];
    for (int i = 0; i < xy.length; i += 2) {
      double angle = 2 * Math.PI * i / xy.length;
      xy[i] = (float) (random.nextDouble(0.4, 0.8) * Math.cos(angle));
      xy[i + 1] = (float) (random.nextDouble(0.4, 0.8) * Math.sin(angle));
    }
    return Polygon.of(xy);
  }

  private static Transform pose(SplittableRandom random, double spread, double turn) {
    return new Transform(
        (float) random.nextDouble(-spread, spread),
        (float) random.nextDouble(-spread, spread),
        (float) random.nextDouble(-turn, turn));
  }

  private static void wander(Transform t, SplittableRandom random, double step) {
    Transform by = pose(random, step, step);
    t.set(t.x + by.x, t.y + by.y, t.cos * by.cos - t.sin * by.sin, t.sin * by.cos + t.cos * by.sin);
    t.normalize();
  }
}
