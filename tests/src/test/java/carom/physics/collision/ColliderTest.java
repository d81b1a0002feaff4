package carom.physics.collision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.fixtures.Allocations;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Convex;
import carom.physics.geometry.Polygon;
import carom.physics.math.Transform;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

final class ColliderTest {
  private static final float SPECULATIVE = 0.3f;

  private final Collider collider = new Collider();
  private final Manifold m = new Manifold();
  private final Manifold swapped = new Manifold();

  /**
   * Goal: exact depth and distance, points between the surfaces. Method: gaps over many directions,
   * distances to all edges.
   */
  @Test
  void agreesWithBruteForceForEveryOrderedPairOfShapes() {
    for (int kinds = 0; kinds < Oracle.KINDS * Oracle.KINDS; kinds++) {
      for (long seed = 1; seed <= 250; seed++) {
        SplittableRandom random = new SplittableRandom(seed);
        Convex a = Oracle.shape(kinds / Oracle.KINDS, random);
        Convex b = Oracle.shape(kinds % Oracle.KINDS, random);
        Transform ta = Oracle.pose(random, 0.9);
        Transform tb = Oracle.pose(random, 0.9);
        String message = "kinds=" + kinds + " seed=" + seed;
        double separation = Oracle.separation(a, ta, b, tb);
        collider.collide(a, ta, b, tb, SPECULATIVE, m);
        assertEquals(separation <= SPECULATIVE, m.count > 0, message + " " + separation);
        collider.collide(b, tb, a, ta, SPECULATIVE, swapped);
        assertEquals(m.count > 0, swapped.count > 0, message);
        if (m.count > 0) {
          // In overlap A's face may be preferred to one that is better by 0.5 mm.
          // Nearly flat pairs of vertices count as faces when shapes are rounded.
          double apart = a.isSimple() && b.isSimple() ? 2e-5 : 2e-4;
          double tolerance = separation > 0 ? apart : 6e-4;
          assertEquals(separation, m.minSeparation(), tolerance, message);
          assertEquals(1, Math.hypot(m.normalX, m.normalY), 1e-5, message);
          assertEquals(m.minSeparation(), swapped.minSeparation(), tolerance, message);
          checkPoint(a, ta, b, tb, m.x0, m.y0, m.separation0, message);
          if (m.count == 2) {
            checkPoint(a, ta, b, tb, m.x1, m.y1, m.separation1, message);
            assertNotEquals(m.id0, m.id1, message);
          }
          if (m.normalX * swapped.normalX + m.normalY * swapped.normalY < -0.99999) {
            checkSwapped(ta, tb, message);
          }
        }
      }
    }
  }

  private static void checkPoint(
      Convex a, Transform ta, Convex b, Transform tb, float x, float y, float s, String message) {
    double limit = Math.abs(s) / 2 + 1e-4;
    double fromA = Oracle.distance(a, ta, (double) ta.x + x, (double) ta.y + y);
    double fromB = Oracle.distance(b, tb, (double) ta.x + x, (double) ta.y + y);
    assertTrue(fromA <= limit && fromB <= limit, message + " " + fromA + " " + fromB + " " + s);
  }

  private void checkSwapped(Transform ta, Transform tb, String message) {
    assertEquals(m.count, swapped.count, message);
    boolean sameOrder = Manifold.swappedId(swapped.id0) == m.id0;
    assertTrue(sameOrder || Manifold.swappedId(swapped.id1) == m.id0, message + m + swapped);
    float x = (sameOrder ? swapped.x0 : swapped.x1) + tb.x;
    float y = (sameOrder ? swapped.y0 : swapped.y1) + tb.y;
    float s = sameOrder ? swapped.separation0 : swapped.separation1;
    double tolerance = 1e-2 * (1 + Math.abs(s));
    assertEquals(m.x0 + ta.x, x, tolerance, message);
    assertEquals(m.y0 + ta.y, y, tolerance, message);
    assertEquals(m.separation0, s, tolerance, message);
  }

  /**
   * Goal: a corner that stands on a face keeps an id, whichever of its two edges lies flatter on
   * the face. Method: corners of random polygons stand on random faces with both edges equally
   * steep, tilted a little to either side.
   */
  @Test
  void aCornerKeepsAnIdWhicheverOfItsEdgesFacesTheFace() {
    int compared = 0;
    int flipped = 0;
    for (long seed = 1; seed <= 5000; seed++) {
      SplittableRandom random = new SplittableRandom(seed);
      Convex a = Oracle.shape(random.nextInt(1, 3), random);
      Convex b = Oracle.shape(random.nextInt(1, 3), random);
      int face = random.nextInt(a.vertexCount());
      int end = (face + 1) % a.vertexCount();
      int corner = random.nextInt(b.vertexCount());
      int before = (corner + b.vertexCount() - 1) % b.vertexCount();
      double along = random.nextDouble(0.1, 0.9);
      double depth = random.nextDouble(-0.01, 0.01);
      double x = a.vertexX(face) + along * (a.vertexX(end) - a.vertexX(face));
      double y = a.vertexY(face) + along * (a.vertexY(end) - a.vertexY(face));
      x += depth * a.normalX(face);
      y += depth * a.normalY(face);
      double outX = b.normalX(corner) + b.normalX(before);
      double outY = b.normalY(corner) + b.normalY(before);
      double upright = Math.atan2(-a.normalY(face), -a.normalX(face)) - Math.atan2(outY, outX);
      touch(a, b, corner, x, y, upright - 1e-3, m);
      touch(a, b, corner, x, y, upright + 1e-3, swapped);
      int one = pointAt(m, x, y);
      int other = pointAt(swapped, x, y);
      boolean sameFace = m.normalX * swapped.normalX + m.normalY * swapped.normalY > 0.99999f;
      if (one >= 0 && other >= 0 && sameFace) {
        compared++;
        int id = one == 0 ? m.id0 : m.id1;
        int otherId = one == 0 ? m.otherId0 : m.otherId1;
        int then = other == 0 ? swapped.id0 : swapped.id1;
        int otherThen = other == 0 ? swapped.otherId0 : swapped.otherId1;
        flipped += id != then ? 1 : 0;
        boolean known = then == id || then == otherId && otherThen == id;
        assertTrue(known, "seed=" + seed + " " + m + " " + swapped);
      }
    }
    assertTrue(compared > 2000 && flipped > 1000, "compared=" + compared + " flipped=" + flipped);
  }

  /** Collides A with B, of which one corner is at a place in A's frame. */
  private void touch(
      Convex a, Convex b, int corner, double x, double y, double angle, Manifold out) {
    Transform turn = new Transform(0, 0, (float) angle);
    float px = (float) x - turn.rotateX(b.vertexX(corner), b.vertexY(corner));
    float py = (float) y - turn.rotateY(b.vertexX(corner), b.vertexY(corner));
    Transform tb = new Transform().set(px, py, turn.cos, turn.sin);
    collider.collide(a, new Transform(), b, tb, SPECULATIVE, out);
  }

  /** Returns which point of a manifold is at a place, or -1. */
  private static int pointAt(Manifold m, double x, double y) {
    if (m.count > 0 && Math.hypot(m.x0 - x, m.y0 - y) < 0.01) {
      return 0;
    }
    return m.count > 1 && Math.hypot(m.x1 - x, m.y1 - y) < 0.01 ? 1 : -1;
  }

  @Test
  void unrotatedBoxesGetTheAnswerOfEqualPolygons() {
    for (long seed = 1; seed <= 5000; seed++) {
      SplittableRandom random = new SplittableRandom(seed);
      Box a = (Box) Oracle.shape(1, random);
      Box b = (Box) Oracle.shape(1, random);
      Transform ta = new Transform().set((float) random.nextDouble(-1.5, 1.5), 0.25f, 1, 0);
      Transform tb = new Transform().set(0, (float) random.nextDouble(-1.5, 1.5), 1, 0);
      collider.collide(a, ta, b, tb, SPECULATIVE, m);
      collider.collide(polygon(a), ta, polygon(b), tb, SPECULATIVE, swapped);
      String message = "seed=" + seed + " " + m + " " + swapped;
      assertEquals(swapped.count, m.count, message);
      assertEquals(swapped.normalX, m.normalX, 1e-6, message);
      assertEquals(swapped.normalY, m.normalY, 1e-6, message);
      if (m.count > 0) {
        assertEquals(swapped.id0, m.id0, message);
        assertEquals(swapped.otherId0, m.otherId0, message);
        assertEquals(swapped.x0, m.x0, 1e-6, message);
        assertEquals(swapped.y0, m.y0, 1e-6, message);
        assertEquals(swapped.separation0, m.separation0, 1e-6, message);
      }
      if (m.count > 1) {
        assertEquals(swapped.id1, m.id1, message);
        assertEquals(swapped.otherId1, m.otherId1, message);
        assertEquals(swapped.x1, m.x1, 1e-6, message);
        assertEquals(swapped.y1, m.y1, 1e-6, message);
        assertEquals(swapped.separation1, m.separation1, 1e-6, message);
      }
    }
  }

  /** Boxes have code of their own; the same corners as a polygon don't. */
  @Test
  void turnedBoxesGetTheAnswerOfEqualPolygons() {
    int touching = 0;
    int alike = 0;
    for (long seed = 1; seed <= 20000; seed++) {
      SplittableRandom random = new SplittableRandom(seed);
      Box a = (Box) Oracle.shape(1, random);
      Box b = (Box) Oracle.shape(1, random);
      Transform ta = new Transform(0.5f, 0.25f, (float) random.nextDouble(-4, 4));
      float x = (float) random.nextDouble(-1.5, 1.5);
      float y = (float) random.nextDouble(-1.5, 1.5);
      // Every fourth pair is turned by quarters, where faces are equally good.
      double turn =
          seed % 4 == 0 ? random.nextInt(4) * Math.PI / 2 : random.nextDouble(-Math.PI, Math.PI);
      Transform tb = new Transform(x, y, (float) (ta.angle() + turn));
      collider.collide(a, ta, b, tb, SPECULATIVE, m);
      collider.collide(polygon(a), ta, polygon(b), tb, SPECULATIVE, swapped);
      String message = "seed=" + seed + " " + m + " " + swapped;
      boolean near = m.count > 0 && m.separation0 > SPECULATIVE - 1e-5f;
      if (near || (swapped.count > 0 && swapped.separation0 > SPECULATIVE - 1e-5f)) {
        continue;
      }
      assertEquals(swapped.count > 0, m.count > 0, message);
      if (m.count > 0) {
        float deepest = deepest(m);
        assertEquals(deepest(swapped), deepest, 2e-3, message);
        touching++;
        // Of nearly equally good faces either may be chosen.
        if (m.normalX * swapped.normalX + m.normalY * swapped.normalY > .9999f) {
          alike++;
          assertEquals(swapped.count, m.count, message);
          assertEquals(middleX(swapped), middleX(m), 1e-4, message);
          assertEquals(deepest(swapped), deepest, 1e-4, message);
        }
      }
    }
    assertTrue(touching > 5000 && alike > .95 * touching, alike + " of " + touching);
  }

  /** Where a disc is above a box is found without a search; the bits are those of the search. */
  @Test
  void aDiscOnABoxGetsTheAnswerOfAnEqualPolygon() {
    int touching = 0;
    for (long seed = 1; seed <= 20000; seed++) {
      SplittableRandom random = new SplittableRandom(seed);
      Box a = (Box) Oracle.shape(1, random);
      Convex b = Oracle.shape(0, random, 0.5);
      // Every fourth disc is on a diagonal, where faces are equally good, or in a middle.
      Transform ta = seed % 4 == 0 ? new Transform() : Oracle.pose(random, 0.5);
      Transform tb = Oracle.pose(random, 1);
      if (seed % 4 == 0) {
        float d = random.nextInt(3) - 1;
        a = new Box(0.5f, 0.5f);
        b = new Circle(0.25f);
        tb.set(d * random.nextInt(9) / 8f, d * random.nextInt(9) / 8f, 0);
      }
      collider.collide(a, ta, b, tb, SPECULATIVE, m);
      float gap = collider.gap();
      collider.collide(polygon(a), ta, b, tb, SPECULATIVE, swapped);
      String message = "seed=" + seed;
      // Normals of an edge along an axis may hold a zero of either sign.
      m.normalX += 0f;
      m.normalY += 0f;
      swapped.normalX += 0f;
      swapped.normalY += 0f;
      assertEquals(swapped.toString(), m.toString(), message);
      assertEquals(collider.gap(), gap, message);
      touching += m.count;
    }
    assertTrue(touching > 5000, "touching=" + touching);
  }

  private static float middleX(Manifold m) {
    return m.count > 1 ? (m.x0 + m.x1) / 2 : m.x0;
  }

  private static float deepest(Manifold m) {
    return m.count > 1 ? Math.min(m.separation0, m.separation1) : m.separation0;
  }

  private static Polygon polygon(Box box) {
    float[] xy = new float[8];
    for (int i = 0; i < 4; i++) {
      xy[2 * i] = box.vertexX(i);
      xy[2 * i + 1] = box.vertexY(i);
    }
    return Polygon.of(xy);
  }

  /** A hint only says where to start; ties included, which quarter turns of regular shapes have. */
  @Test
  void noBitDependsOnTheHint() {
    int touching = 0;
    for (long seed = 1; seed <= 40_000; seed++) {
      SplittableRandom random = new SplittableRandom(seed);
      boolean regular = seed % 3 == 0;
      Convex a = regular ? regular(random) : Oracle.shape(random.nextInt(Oracle.KINDS), random);
      Convex b = regular ? regular(random) : Oracle.shape(random.nextInt(Oracle.KINDS), random);
      Transform ta = Oracle.pose(random, 0.9);
      Transform tb = Oracle.pose(random, 0.9);
      if (regular) {
        ta.set(0.5f * random.nextInt(-3, 4), 0.5f * random.nextInt(-3, 4), 0, 1);
        tb.set(0, 0, random.nextBoolean() ? 1 : -1, 0);
      }
      collider.collide(a, ta, b, tb, SPECULATIVE, m);
      int known = collider.hint();
      touching += m.count > 0 ? 1 : 0;
      for (int i = 0; i < 8; i++) {
        int hint = i == 0 ? known : random.nextInt() >>> random.nextInt(32);
        collider.collide(a, ta, b, tb, SPECULATIVE, hint, swapped);
        assertEquals(m.toString(), swapped.toString(), "seed=" + seed + " hint=" + hint);
      }
    }
    assertTrue(touching > 10_000, "touching=" + touching);
  }

  private static Convex regular(SplittableRandom random) {
    int corners = 2 + 2 * random.nextInt(4);
    return corners == 2 ? new Box(0.5f, 0.5f) : Polygon.regular(corners, 0.5f);
  }

  @Test
  void aRestingBoxKeepsFaceAndIdsWhileItJitters() {
    Box ground = new Box(10, 1);
    Box box = new Box(0.5f, 0.5f);
    SplittableRandom random = new SplittableRandom(7);
    collider.collide(
        ground, new Transform(), box, new Transform(0.2f, 1.495f, 0), SPECULATIVE, swapped);
    assertEquals(2, swapped.count);
    for (int i = 0; i < 2000; i++) {
      float tilt = (float) random.nextDouble(-4e-4, 4e-4);
      Transform tb =
          new Transform(
              (float) random.nextDouble(-5, 5),
              1.495f + (float) random.nextDouble(-1e-3, 1e-3),
              tilt);
      collider.collide(ground, new Transform(), box, tb, SPECULATIVE, m);
      assertEquals(2, m.count, "i=" + i);
      assertEquals(1f, m.normalY, "i=" + i);
      assertEquals(swapped.id0, m.id0, "i=" + i);
      assertEquals(swapped.id1, m.id1, "i=" + i);
    }
  }

  @Test
  void theGapBetweenTwoCornersIsMeasuredAlongTheirLine() {
    Box box = new Box(1, 1);
    collider.collide(box, new Transform(), box, new Transform(2.03f, 2.04f, 0), 0.1f, m);
    assertEquals(1, m.count);
    assertEquals(0.05f, m.separation0, 1e-5f);
    assertEquals(0.6f, m.normalX, 1e-4f);
    assertEquals(0.8f, m.normalY, 1e-4f);
    collider.collide(box, new Transform(), box, new Transform(2.09f, 2.09f, 0), 0.1f, m);
    assertEquals(0, m.count);
    collider.collide(box, new Transform(), new Circle(1), new Transform(2.03f, 2.04f, 0), 1, m);
    assertEquals((float) Math.hypot(1.03, 1.04) - 1, m.separation0, 1e-5f);
  }

  @Test
  void coincidentCentresHaveTheirDocumentedNormal() {
    collider.collide(new Circle(1), new Transform(), new Circle(2), new Transform(), 0, m);
    assertEquals(1f, m.normalY);
    assertEquals(-3f, m.separation0);
    collider.collide(
        new Box(1, 1), new Transform(), new Circle(0.5f), new Transform(0, 1, 0), 0, m);
    assertEquals(1f, m.normalY);
    assertEquals(-0.5f, m.separation0);
  }

  @Test
  void staysExactFarFromTheOrigin() {
    Convex p = Polygon.regular(6, 0.5f);
    Convex q = new Box(0.5f, 0.25f);
    for (float far : new float[] {4096, 65536, -65536}) {
      collider.collide(p, new Transform(0, 0, 0.4f), q, new Transform(0.5f, 0.5f, 1), 1, m);
      collider.collide(
          p,
          new Transform(far, far, 0.4f),
          q,
          new Transform(far + 0.5f, far + 0.5f, 1),
          1,
          swapped);
      assertEquals(m.toString(), swapped.toString());
    }
  }

  @Test
  void pointOfCollisionIsWeightedByDepth() {
    m.set(0, 1, 2);
    m.setPoint0(0, 0, -0.1f, 1);
    m.setPoint1(4, 0, -0.3f, 2);
    assertEquals(3f, m.pointX(), 1e-6f);
    m.setPoint0(0, 0, 0.1f, 1);
    assertEquals(4f, m.pointX());
    m.clear();
    assertEquals(0f, m.pointX());
  }

  @Test
  void allocatesNothing() {
    Convex[] shapes = {new Circle(0.5f), new Box(0.5f, 0.5f), Polygon.regular(8, 0.5f)};
    Transform ta = new Transform(0, 0, 0.1f);
    Transform tb = new Transform(0.7f, 0.3f, 0.5f);
    Sat sat = new Sat();
    Mtv mtv = new Mtv();
    long least =
        Allocations.least(
            5,
            () -> {
              for (int i = 0; i < 90_000; i++) {
                Convex a = shapes[i % 3];
                Convex b = shapes[i / 3 % 3];
                collider.collide(a, ta, b, tb, 0.1f, m);
                sat.mtv(a, ta, b, tb, mtv);
              }
            });
    assertTrue(least < 1024, "bytes=" + least);
  }
}
