package carom.physics.collision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.geometry.Box;
import carom.physics.geometry.Capsule;
import carom.physics.geometry.Chain;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Compound;
import carom.physics.geometry.Convex;
import carom.physics.geometry.Polygon;
import carom.physics.geometry.Segment;
import carom.physics.geometry.Shape;
import carom.physics.math.Transform;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * The minimum translation vector: for every ordered pair of kinds, at every depth, size and place,
 * against gaps of the shadows over all directions.
 */
final class MtvLawTest {
  private final Sat sat = new Sat();
  private final Collider collider = new Collider();
  private final Mtv mtv = new Mtv();
  private final Mtv back = new Mtv();
  private final Manifold m = new Manifold();

  /** Distance of the centres in sizes: from containment to a slight touch. */
  private static final double[] SPREADS = {0, .05, .3, .8};

  static List<Arguments> pairs() {
    List<Arguments> all = new ArrayList<>();
    for (int a = 0; a < Oracle.KINDS; a++) {
      for (int b = 0; b < Oracle.KINDS; b++) {
        all.add(Arguments.of(a, b));
      }
    }
    return all;
  }

  private static String name(int kindA, int kindB, long seed, double size) {
    return "kinds=" + kindA + "," + kindB + " seed=" + seed + " size=" + size + " ";
  }

  @ParameterizedTest
  @MethodSource("pairs")
  void isTheTrueMinimumAtEveryDepth(int kindA, int kindB) {
    for (double spread : SPREADS) {
      for (long seed = 1; seed <= 15; seed++) {
        check(kindA, kindB, seed * 7 + (long) (100 * spread), 1, 1, spread, 0, 0);
      }
    }
  }

  /** A small shape deep inside a large one, and the other way round. */
  @ParameterizedTest
  @MethodSource("pairs")
  void isTheTrueMinimumOfContainedShapes(int kindA, int kindB) {
    for (long seed = 1; seed <= 8; seed++) {
      check(kindA, kindB, seed, .1, 1, .3, 0, 0);
      check(kindA, kindB, seed, 1, .1, .3, 0, 0);
    }
  }

  /** Positions are floats, but all sums are made of differences, in double. */
  @ParameterizedTest
  @ValueSource(doubles = {1e4, 1e5, 1e6, -1e6, 9e6})
  void isAsExactFarFromTheOrigin(double far) {
    for (int kinds = 0; kinds < Oracle.KINDS * Oracle.KINDS; kinds++) {
      for (long seed = 1; seed <= 4; seed++) {
        check(kinds / Oracle.KINDS, kinds % Oracle.KINDS, seed, 1, 1, .8, far, -far);
      }
    }
  }

  @ParameterizedTest
  @CsvSource({"0.05,0.05", "0.05,5", "100,100", "1,1000", "10000,10000", "0.1,10000"})
  void isAsExactForTinyAndHugeShapes(double sizeA, double sizeB) {
    for (int kinds = 0; kinds < Oracle.KINDS * Oracle.KINDS; kinds++) {
      for (long seed = 1; seed <= 4; seed++) {
        check(kinds / Oracle.KINDS, kinds % Oracle.KINDS, seed, sizeA, sizeB, .8, 0, 0);
      }
    }
  }

  private void check(
      int kindA,
      int kindB,
      long seed,
      double sizeA,
      double sizeB,
      double spread,
      double x,
      double y) {
    SplittableRandom random = new SplittableRandom(seed);
    double size = Math.max(sizeA, sizeB);
    Convex a = Oracle.shape(kindA, random, sizeA);
    Convex b = Oracle.shape(kindB, random, sizeB);
    Transform ta = Oracle.pose(random, spread * size + 1e-9);
    Transform tb = Oracle.pose(random, spread * size + 1e-9);
    ta.set((float) (x + ta.x), (float) (y + ta.y), ta.cos, ta.sin);
    tb.set((float) (x + tb.x), (float) (y + tb.y), tb.cos, tb.sin);
    String message = name(kindA, kindB, seed, size);
    double separation = Oracle.separation(a, ta, b, tb, size);
    boolean overlap = sat.mtv(a, ta, b, tb, mtv);
    double tolerance = 1e-4 * size;
    assertEquals(Math.max(0, -separation), mtv.length(), tolerance, message);
    if (Math.abs(separation) > 1e-6 * size) {
      assertEquals(separation < 0, overlap, message + separation);
    }
    assertEquals(overlap, sat.mtv(b, tb, a, ta, back), message);
    assertTrue(mtv.x == -back.x && mtv.y == -back.y, message + "reversal " + mtv + back);
    if (overlap) {
      // Where A goes, seen from B: exact, as long as the difference of the positions is.
      Transform moved = new Transform();
      moved.set((float) ((double) ta.x - tb.x), (float) ((double) ta.y - tb.y), ta.cos, ta.sin);
      moved.set(moved.x + mtv.x, moved.y + mtv.y, ta.cos, ta.sin);
      Transform origin = new Transform().set(0, 0, tb.cos, tb.sin);
      assertEquals(0, Oracle.separation(a, moved, b, origin, size), tolerance, message + "moved");
    }
    collider.collide(a, ta, b, tb, 0, m);
    if (Math.abs(separation) > 1e-3 * size) {
      assertEquals(overlap, m.count > 0, message + separation);
    }
    if (m.count > 0) {
      double bias = 6e-4 + 2e-5 * size;
      assertEquals(separation, m.minSeparation(), bias, message + "manifold");
    }
  }

  /** Any two shapes of any parts: the reverse question has exactly the negated answer. */
  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
  void reversalNegatesExactlyForCompoundsAndChains(long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    int overlaps = 0;
    for (int i = 0; i < 300; i++) {
      Shape a = anything(random);
      Shape b = anything(random);
      Transform ta = Oracle.pose(random, 1);
      Transform tb = Oracle.pose(random, 1);
      String message = "seed=" + seed + " i=" + i + " " + a + " " + b;
      boolean overlap = sat.mtv(a, ta, b, tb, mtv);
      assertEquals(overlap, sat.mtv(b, tb, a, ta, back), message);
      assertTrue(mtv.x == -back.x && mtv.y == -back.y, message);
      overlaps += overlap ? 1 : 0;
    }
    assertTrue(overlaps > 100, "overlaps=" + overlaps);
  }

  private static Shape anything(SplittableRandom random) {
    int kind = random.nextInt(Oracle.KINDS + 2);
    if (kind < Oracle.KINDS) {
      return Oracle.shape(kind, random);
    }
    if (kind == Oracle.KINDS) {
      return Compound.of(
          Oracle.shape(random.nextInt(Oracle.KINDS), random),
          Oracle.shape(random.nextInt(Oracle.KINDS), random).moved(.5f, 0),
          Oracle.shape(random.nextInt(Oracle.KINDS), random).moved(0, .5f));
    }
    float y = (float) random.nextDouble(-.5, .5);
    return Chain.open(-1, y, -.3f, y + .2f, .4f, y - .1f, 1, y);
  }

  /** Equal shapes in different poses, ties of faces: still exactly negated. */
  @Test
  void reversalNegatesExactlyInTies() {
    Shape[] shapes = {
      new Circle(1),
      new Box(1, 1),
      Polygon.regular(6, 1),
      new Capsule(-1, 0, 1, 0, .5f),
      new Segment(-1, 0, 1, 0),
      Polygon.rounded(.2f, -1, -1, 1, -1, 1, 1, -1, 1)
    };
    float[][] offsets = {{0, .5f}, {.5f, 0}, {.5f, .5f}, {-.5f, .5f}, {1e-7f, 0}, {0, -1e-20f}};
    for (Shape a : shapes) {
      for (Shape b : shapes) {
        for (float[] at : offsets) {
          Transform t = new Transform().set(at[0], at[1], 1, 0);
          Transform origin = new Transform();
          boolean overlap = sat.mtv(a, t, b, origin, mtv);
          assertEquals(overlap, sat.mtv(b, origin, a, t, back));
          assertTrue(mtv.x == -back.x && mtv.y == -back.y, a + " " + b + " " + at[0]);
        }
      }
    }
  }

  /** Coincident centres: along y, whatever the radii; the smaller is told where to go downwards. */
  @ParameterizedTest
  @CsvSource({"1,2", "0.01,1", "5,5.5", "0.5,100"})
  void concentricCirclesPartAlongY(float small, float large) {
    Transform t = new Transform(3, 4, 1);
    assertTrue(sat.mtv(new Circle(small), t, new Circle(large), t, mtv));
    assertEquals(0f, mtv.x);
    assertEquals(-(small + large), mtv.y, 1e-4);
    assertTrue(sat.mtv(new Circle(large), t, new Circle(small), t, mtv));
    assertEquals(small + large, mtv.y, 1e-4);
  }

  /** A centre on an edge: along its normal by one radius; on a vertex: along one of its edges'. */
  @ParameterizedTest
  @ValueSource(ints = {3, 4, 5, 8, 13})
  void centresOnTheBorderLeaveAlongAnEdgesNormal(int corners) {
    Polygon p = Polygon.regular(corners, 2);
    Transform t = new Transform();
    Circle c = new Circle(.25f);
    for (int i = 0; i < corners; i++) {
      int k = (i + 1) % corners;
      float x = (p.vertexX(i) + p.vertexX(k)) / 2;
      float y = (p.vertexY(i) + p.vertexY(k)) / 2;
      assertTrue(sat.mtv(c, new Transform(x, y, 0), p, t, mtv));
      assertEquals(.25 * p.normalX(i), mtv.x, 1e-5, "edge " + i);
      assertEquals(.25 * p.normalY(i), mtv.y, 1e-5, "edge " + i);
      assertTrue(sat.mtv(c, new Transform(p.vertexX(i), p.vertexY(i), 0), p, t, mtv));
      assertEquals(.25, mtv.length(), 1e-5, "vertex " + i);
      int before = (i + corners - 1) % corners;
      double one = Math.hypot(mtv.x - .25 * p.normalX(i), mtv.y - .25 * p.normalY(i));
      double two = Math.hypot(mtv.x - .25 * p.normalX(before), mtv.y - .25 * p.normalY(before));
      assertEquals(0, Math.min(one, two), 1e-4, "vertex " + i);
    }
  }

  /** What only touches doesn't overlap, and has no way out. */
  @Test
  void touchingIsNoOverlap() {
    Transform o = new Transform();
    assertFalse(sat.mtv(new Box(1, 1), o, new Box(1, 1), new Transform(2, 0, 0), mtv));
    assertFalse(sat.mtv(new Circle(1), o, new Circle(1), new Transform(0, 2, 0), mtv));
    assertFalse(sat.mtv(new Box(1, 1), o, new Circle(1), new Transform(2, 0, 0), mtv));
    assertFalse(sat.mtv(new Box(1, 1), o, new Box(1, 1), new Transform(2, 2, 0), mtv));
    assertFalse(
        sat.mtv(new Segment(0, 0, 1, 0), o, new Segment(0, 0, 1, 0), new Transform(0, 1, 0), mtv));
    assertEquals("0.0 0.0", mtv.x + " " + mtv.y);
  }

  /** Moving by the answer again and again frees compounds, each time by at most what is left. */
  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6})
  void compoundsComeFreeAfterAFewMoves(long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    for (int i = 0; i < 50; i++) {
      Shape cross = Compound.of(new Box(1, .2f), new Box(.2f, 1));
      Shape corner = Compound.of(new Box(.8f, .2f), new Box(.2f, .8f, .6f, .6f), new Circle(.3f));
      Transform ta = Oracle.pose(random, .8);
      Transform tb = Oracle.pose(random, .8);
      int moves = 0;
      while (sat.mtv(cross, ta, corner, tb, mtv) && mtv.length() > 1e-4) {
        ta.set(ta.x + mtv.x, ta.y + mtv.y, ta.cos, ta.sin);
        moves++;
        assertTrue(moves < 60, "seed=" + seed + " i=" + i);
      }
    }
  }

  /** Turning and shifting both shapes together turns the answer. */
  @ParameterizedTest
  @MethodSource("pairs")
  void theAnswerTurnsWithTheShapes(int kindA, int kindB) {
    for (long seed = 1; seed <= 20; seed++) {
      SplittableRandom random = new SplittableRandom(seed);
      Convex a = Oracle.shape(kindA, random);
      Convex b = Oracle.shape(kindB, random);
      double turn = random.nextDouble(-3, 3);
      float x = (float) random.nextDouble(-.5, .5);
      float y = (float) random.nextDouble(-.5, .5);
      sat.mtv(a, new Transform(), b, new Transform(x, y, .5f), mtv);
      float c = (float) Math.cos(turn);
      float s = (float) Math.sin(turn);
      Transform ta = new Transform(0, 0, (float) turn);
      Transform tb = new Transform(c * x - s * y, s * x + c * y, (float) turn + .5f);
      sat.mtv(a, ta, b, tb, back);
      String message = name(kindA, kindB, seed, 1);
      assertEquals(mtv.length(), back.length(), 2e-5, message);
      double second = c * mtv.x - s * mtv.y;
      double third = s * mtv.x + c * mtv.y;
      double off = Math.hypot(second - back.x, third - back.y);
      assertTrue(off < 1e-3 || mtv.length() > .3, message + "another equally short way? " + off);
    }
  }
}
