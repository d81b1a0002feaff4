package carom.physics.dynamics.contact;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.collision.Collider;
import carom.physics.collision.Manifold;
import carom.physics.geometry.Box;
import carom.physics.geometry.Capsule;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Convex;
import carom.physics.geometry.Polygon;
import carom.physics.geometry.Segment;
import carom.physics.math.Transform;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

final class KeptManifoldsTest {
  private static final float SPECULATIVE = 0.02f;

  private final KeptManifolds.Scratch scratch = new KeptManifolds.Scratch();
  private final int[] hints = new int[1];
  private final Manifold m = new Manifold();
  private final Manifold fresh = new Manifold();

  /**
   * Goal: keeping shows in no bit. Method: wander in steps small and large; ask one that forgot.
   * What is known to be apart has no points either.
   */
  @Test
  void whatIsKeptIsWhatWouldBeComputed() {
    int touched = 0;
    int known = 0;
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
        boolean apart = kept.apart(0, ta, tb, 1.5f, true);
        find(kept, a, ta, b, tb, m);
        find(kept(), a, ta, b, tb, fresh);
        assertFalse(apart && fresh.count > 0, message);
        known += apart ? 1 : 0;
        assertEquals(fresh.count, m.count, message);
        if (m.count > 0) {
          touched++;
          assertEquals(fresh.toString(), m.toString(), message);
        }
      }
    }
    assertTrue(touched > 5000, "touched=" + touched);
    assertTrue(known > 5000, "known=" + known);
  }

  /**
   * Goal: gaps and normals are those of the true pose. Method: the collider itself, same points.
   */
  @Test
  void followsTheTruePose() {
    Collider collider = new Collider();
    int compared = 0;
    int others = 0;
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
        // A corner at the end of a face is on the one side of it in the rounded pose alone.
        others += fresh.otherId0 == m.otherId0 && fresh.otherId1 == m.otherId1 ? 1 : 0;
      }
    }
    assertTrue(compared > 1000, "compared=" + compared);
    assertTrue(others > 0.98 * compared, "compared=" + compared + " others=" + others);
  }

  /**
   * Goal: two corners with a gap have the true pose's direction and distance. Method: the collider.
   */
  @Test
  void cornersFollowTheTruePose() {
    Collider collider = new Collider();
    int compared = 0;
    for (long seed = 1; seed <= 5000; seed++) {
      SplittableRandom random = new SplittableRandom(seed);
      float half = (float) random.nextDouble(0.1, 0.7);
      float other = (float) random.nextDouble(0.1, 0.7);
      Convex a = new Box(half, half, 0, 0);
      Convex b = new Box(other, other, 0, 0);
      // B's corner of lowest index faces A's upper right one, a little askew.
      Transform ta = pose(random, 0.3, 3);
      Transform way = new Transform(0, 0, (float) random.nextDouble(0.5, 1.07));
      // Nearer than a cell and a half, corners may overlap in the rounded pose.
      float gap = (float) random.nextDouble(1.5e-3, SPECULATIVE);
      float x = half + gap * way.cos;
      float y = half + gap * way.sin;
      Transform turn = new Transform(0, 0, ta.angle() + (float) random.nextDouble(-0.3, 0.3));
      Transform tb = new Transform();
      tb.set(
          ta.worldX(x, y) + turn.rotateX(other, other),
          ta.worldY(x, y) + turn.rotateY(other, other),
          turn.cos,
          turn.sin);
      collider.collide(a, ta, b, tb, SPECULATIVE, fresh);
      find(kept(), a, ta, b, tb, m);
      if (fresh.count == 1 && m.count == 1 && collider.ofCorners()) {
        compared++;
        String message = "seed=" + seed + " " + fresh + " " + m;
        assertEquals(fresh.id0, m.id0, message);
        assertEquals(fresh.separation0, m.separation0, 1e-6f, message);
        float rounding = 1e-6f / gap;
        assertEquals(fresh.normalX, m.normalX, rounding, message);
        assertEquals(fresh.normalY, m.normalY, rounding, message);
        assertEquals(fresh.x0, m.x0, 1e-6f, message);
        assertEquals(fresh.y0, m.y0, 1e-6f, message);
      }
    }
    assertTrue(compared > 4000, "compared=" + compared);
  }

  /** Goal: what is known to be apart is. Method: wander; ask the collider each time. */
  @Test
  void whatIsApartDoesNotTouch() {
    Collider collider = new Collider();
    int known = 0;
    int touching = 0;
    for (long seed = 1; seed <= 500; seed++) {
      SplittableRandom random = new SplittableRandom(seed);
      Convex a = anyShape(random);
      Convex b = a instanceof Circle ? shape(random) : anyShape(random);
      Transform ta = pose(random, 0.3, 3);
      Transform tb = pose(random, 1, 3);
      float far = random.nextInt(3) == 0 ? 1e5f : 0;
      ta.x += far;
      tb.x += far;
      float speculative = random.nextBoolean() ? SPECULATIVE : 0;
      double step = random.nextBoolean() ? 1e-2 : 0.1;
      KeptManifolds kept = kept();
      for (int i = 0; i < 200; i++) {
        wander(ta, random, step);
        wander(tb, random, step);
        collider.collide(a, ta, b, tb, speculative, fresh);
        if (kept.apart(0, ta, tb, 1.5f, false)) {
          known++;
          assertEquals(0, fresh.count, "seed=" + seed + " step=" + i + " " + a + " " + b);
        } else if (fresh.count == 0) {
          kept.keepApart(0, ta, tb, collider.gap(), speculative);
        } else {
          touching++;
          kept.forget(0);
        }
      }
    }
    assertTrue(known > 10000 && touching > 10000, "known=" + known + " touching=" + touching);
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

  /**
   * Goal: when a table takes other rows over, what is kept follows its pairs. Method: per pair
   * another gap; pairs stay, go, come, and the table changes twice before anybody asks.
   */
  @Test
  void whatIsKeptFollowsItsPairs() {
    KeptManifolds kept = new KeptManifolds();
    kept.ensure(8);
    Transform here = new Transform();
    RowArrays first = pairs(3, 5, 6, 9, 12);
    for (int row = 0; row < 5; row++) {
      kept.keepApart(row, here, there(row), row + 1, 0);
    }
    kept.rows().rowsReplaced(first, 5);
    first.release();
    RowArrays second = pairs(1, 2);
    kept.rows().rowsReplaced(second, 2);
    assertEquals(5, kept.rows().rowsBefore());
    long[] now = {4, 5, 7, 9, 11, 12, 20};
    int[] then = {-1, 1, -1, 3, -1, 4, -1};
    kept.rows().realign(now, now.length, new RowShifts());
    assertEquals(0, kept.rows().rowsBefore());
    for (int row = 0; row < now.length; row++) {
      Transform b = there(then[row]);
      assertEquals(then[row] >= 0, kept.apart(row, here, b, 1, false), "row=" + row);
      b.x += then[row] + 0.9f;
      assertEquals(then[row] >= 0, kept.apart(row, here, b, 1, false), "nearly as far, row=" + row);
      b.x += 0.2f;
      assertFalse(kept.apart(row, here, b, 1, false), "further, row=" + row);
    }
    assertFalse(second.shared(), "it isn't held");
  }

  private static RowArrays pairs(long... keys) {
    RowArrays pairs = new RowArrays(keys.length, new int[] {1}, new long[0]);
    System.arraycopy(keys, 0, (long[]) pairs.array(0), 0, keys.length);
    return pairs;
  }

  private static Transform there(int row) {
    return new Transform().set(10 + row, row, 1, 0);
  }

  private static KeptManifolds kept() {
    KeptManifolds kept = new KeptManifolds();
    kept.ensure(1);
    return kept;
  }

  private void find(
      KeptManifolds kept, Convex a, Transform ta, Convex b, Transform tb, Manifold out) {
    kept.collide(0, a, ta, b, tb, 1.5f, SPECULATIVE, hints, scratch, out);
  }

  private static Convex anyShape(SplittableRandom random) {
    return switch (random.nextInt(5)) {
      case 0 -> new Circle(0.5f, 0.2f, 0);
      case 1 -> new Capsule(-0.4f, 0, 0.4f, 0.1f, 0.2f);
      case 2 -> new Segment(-0.7f, 0, 0.7f, 0.2f);
      case 3 -> Polygon.rounded(0.1f, -0.5f, -0.3f, 0.6f, -0.2f, 0, 0.6f);
      default -> shape(random);
    };
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
    return Polygon.hull(xy);
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
