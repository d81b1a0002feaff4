package carom.physics.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.math.Aabb;
import carom.physics.math.Transform;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Concave outlines become convex parts that cover just them. */
final class ConvexDecompositionTest {
  private static final float[] L = {0, 0, 2, 0, 2, 1, 1, 1, 1, 2, 0, 2};

  private static double area(float[] xy) {
    double twice = 0;
    for (int i = 0; i < xy.length; i += 2) {
      int next = (i + 2) % xy.length;
      twice += (double) xy[i] * xy[next + 1] - (double) xy[next] * xy[i + 1];
    }
    return twice / 2;
  }

  private static float[] reversed(float[] xy) {
    float[] r = new float[xy.length];
    for (int i = 0; i < xy.length; i += 2) {
      r[i] = xy[xy.length - 2 - i];
      r[i + 1] = xy[xy.length - 1 - i];
    }
    return r;
  }

  /** Whether a point is inside an outline, by counting crossings; independent of the code. */
  private static boolean inside(float[] xy, double px, double py) {
    boolean in = false;
    for (int i = 0, j = xy.length - 2; i < xy.length; j = i, i += 2) {
      if (xy[i + 1] > py != xy[j + 1] > py
          && px < (xy[j] - xy[i]) * (py - xy[i + 1]) / (xy[j + 1] - xy[i + 1]) + xy[i]) {
        in = !in;
      }
    }
    return in;
  }

  /** The area of the intersection of two convex parts, by Sutherland and Hodgman. */
  private static double overlap(Convex p, Convex q) {
    double[] xs = new double[p.vertexCount()];
    double[] ys = new double[p.vertexCount()];
    for (int i = 0; i < xs.length; i++) {
      xs[i] = p.vertexX(i);
      ys[i] = p.vertexY(i);
    }
    for (int e = 0; e < q.vertexCount() && xs.length > 0; e++) {
      double ax = q.vertexX(e);
      double ay = q.vertexY(e);
      double ex = q.vertexX((e + 1) % q.vertexCount()) - ax;
      double ey = q.vertexY((e + 1) % q.vertexCount()) - ay;
      double[] nx = new double[2 * xs.length];
      double[] ny = new double[2 * xs.length];
      int n = 0;
      for (int i = 0; i < xs.length; i++) {
        int j = (i + 1) % xs.length;
        double di = ex * (ys[i] - ay) - ey * (xs[i] - ax);
        double dj = ex * (ys[j] - ay) - ey * (xs[j] - ax);
        if (di >= 0) {
          nx[n] = xs[i];
          ny[n++] = ys[i];
        }
        if (di > 0 && dj < 0 || di < 0 && dj > 0) {
          nx[n] = xs[i] + (xs[j] - xs[i]) * di / (di - dj);
          ny[n++] = ys[i] + (ys[j] - ys[i]) * di / (di - dj);
        }
      }
      xs = java.util.Arrays.copyOf(nx, n);
      ys = java.util.Arrays.copyOf(ny, n);
    }
    double twice = 0;
    for (int i = 0; i < xs.length; i++) {
      int j = (i + 1) % xs.length;
      twice += xs[i] * ys[j] - xs[j] * ys[i];
    }
    return twice / 2;
  }

  /**
   * Returns the area of the parts that are left out, each of which must be thin. With them, nothing
   * of the outline may be missing.
   */
  private static double slivers(String what, float[] xy) {
    SimpleOutline outline = new SimpleOutline(xy, Compound.MAX_OUTLINE_POINTS);
    List<float[]> kept = ConvexDecomposition.parts(outline, Shape.MIN_SIZE, Convex.MAX_VERTICES);
    double all = 0;
    double slivers = 0;
    for (float[] part : ConvexDecomposition.parts(outline, 0, Convex.MAX_VERTICES)) {
      all += area(part);
      if (kept.stream().noneMatch(other -> Arrays.equals(other, part))) {
        assertTrue(thickness(part) <= 1.6 * Shape.MIN_SIZE, what + " left out " + thickness(part));
        slivers += area(part);
      }
    }
    double expected = Math.abs(area(xy));
    assertEquals(expected, all, 1e-5 * expected, what + ", with slivers");
    return slivers;
  }

  /** Returns the least width of a convex polygon: that across one of its edges. */
  private static double thickness(float[] xy) {
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < xy.length; i += 2) {
      double ex = (double) xy[(i + 2) % xy.length] - xy[i];
      double ey = (double) xy[(i + 3) % xy.length] - xy[i + 1];
      double widest = 0;
      for (int k = 0; k < xy.length; k += 2) {
        widest = Math.max(widest, ex * (xy[k + 1] - xy[i + 1]) - ey * (xy[k] - xy[i]));
      }
      least = Math.min(least, widest / Math.hypot(ex, ey));
    }
    return least;
  }

  private static void check(String what, float[] xy, SplittableRandom random) {
    double expected = Math.abs(area(xy));
    Compound c = Compound.ofOutline(xy);
    assertEquals(expected - slivers(what, xy), c.area(), 2e-4 * expected, what);
    List<Convex> parts = c.parts();
    assertTrue(parts.size() <= Math.max(1, xy.length / 2 - 2), what + " parts=" + parts.size());
    for (int i = 0; i < parts.size(); i++) {
      Convex p = parts.get(i);
      assertTrue(p.vertexCount() <= Convex.MAX_VERTICES, what);
      for (int k = 0; k < p.vertexCount(); k++) {
        int l = (k + 1) % p.vertexCount();
        int m = (k + 2) % p.vertexCount();
        double turn =
            ((double) p.vertexX(l) - p.vertexX(k)) * ((double) p.vertexY(m) - p.vertexY(l))
                - ((double) p.vertexY(l) - p.vertexY(k)) * ((double) p.vertexX(m) - p.vertexX(l));
        assertTrue(turn > 0, what + " part=" + i + " isn't strictly convex");
      }
      for (int j = 0; j < i; j++) {
        assertTrue(overlap(p, parts.get(j)) <= 1e-4 * expected, what + " parts=" + j + "," + i);
      }
    }
    Aabb box = new Aabb();
    c.aabb(new Transform(0, 0, 0), box);
    int wrong = 0;
    for (int i = 0; i < 300; i++) {
      float x = (float) (box.minX + random.nextDouble() * box.width());
      float y = (float) (box.minY + random.nextDouble() * box.height());
      wrong += c.containsPoint(x, y) == inside(xy, x, y) ? 0 : 1;
    }
    assertTrue(wrong <= 2, what + " points on the wrong side: " + wrong);
    assertEquals(c.toString(), Compound.ofOutline(xy.clone()).toString(), what);
    double other = Compound.ofOutline(reversed(xy)).area();
    double otherSlivers = slivers(what, reversed(xy));
    assertEquals(expected - otherSlivers, other, 2e-4 * expected, what + ", the other way round");
  }

  @Test
  void anLAStarACombAndASpiralAreCovered() {
    SplittableRandom random = new SplittableRandom(1);
    check("L", L, random);
    assertEquals(2, Compound.ofOutline(L).parts().size());
    float[] star = new float[20];
    for (int i = 0; i < 10; i++) {
      star[2 * i] = (float) ((i % 2 == 0 ? 2 : 0.8) * Math.cos(Math.PI * i / 5));
      star[2 * i + 1] = (float) ((i % 2 == 0 ? 2 : 0.8) * Math.sin(Math.PI * i / 5));
    }
    check("star", star, random);
    float[] comb = new float[2 * (4 * 20 + 2)];
    int n = 0;
    for (int i = 0; i < 20; i++) {
      for (float[] p : new float[][] {{0, 0}, {0, 3}, {.5f, 3}, {.5f, 0}}) {
        comb[n++] = i + p[0];
        comb[n++] = p[1];
      }
    }
    comb[n++] = 19.5f;
    comb[n++] = -1;
    comb[n++] = 0;
    comb[n++] = -1;
    check("comb", comb, random);
    float[] spiral = new float[800];
    for (int i = 0; i < 200; i++) {
      double angle = i * .15;
      double r = .5 + i * .05;
      spiral[2 * i] = (float) (r * Math.cos(angle));
      spiral[2 * i + 1] = (float) (r * Math.sin(angle));
      spiral[798 - 2 * i] = (float) ((r + .5) * Math.cos(angle));
      spiral[799 - 2 * i] = (float) ((r + .5) * Math.sin(angle));
    }
    check("spiral", spiral, random);
  }

  /** A random simple polygon: points by angle around the middle, at random distances. */
  private static float[] starShaped(SplittableRandom random) {
    int n = random.nextInt(3, 80);
    float scale = (float) Math.pow(10, random.nextDouble(-1, 3));
    float[] xy = new float[2 * n];
    for (int i = 0; i < n; i++) {
      double angle = 2 * Math.PI * (i + random.nextDouble(.1, .9)) / n;
      double r = scale * random.nextDouble(.2, 1);
      xy[2 * i] = (float) (r * Math.cos(angle)) + 3 * scale;
      xy[2 * i + 1] = (float) (r * Math.sin(angle));
    }
    return xy;
  }

  /** A random rectilinear skyline on a grid, so that many corners are on common lines. */
  private static float[] skyline(SplittableRandom random) {
    int n = random.nextInt(2, 30);
    float[] xy = new float[4 * n + 4];
    int at = 0;
    for (int i = 0; i < n; i++) {
      float top = random.nextInt(1, 5);
      xy[at++] = i;
      xy[at++] = top;
      xy[at++] = i + 1;
      xy[at++] = top;
    }
    xy[at++] = n;
    xy[at++] = 0;
    xy[at++] = 0;
    xy[at] = 0;
    return xy;
  }

  @Test
  void randomSimplePolygonsAreCovered() {
    long seed = Long.getLong("carom.seed", System.nanoTime());
    System.out.println("ConvexDecompositionTest seed=" + seed);
    SplittableRandom random = new SplittableRandom(seed);
    for (int i = 0; i < 400; i++) {
      float[] xy = i % 2 == 0 ? starShaped(random) : skyline(random);
      check("seed=" + seed + " i=" + i, random.nextBoolean() ? xy : reversed(xy), random);
    }
  }

  @Test
  void flatAndRepeatedPointsDoNotMatter() {
    float[] more = {0, 0, 1, 0, 2, 0, 2, 0, 2, 1, 1, 1, 1, 1.5f, 1, 2, .5f, 2, 0, 2, 0, 1, 0, 0};
    assertEquals(3, Compound.ofOutline(more).area(), 1e-6);
    assertEquals(2, Compound.ofOutline(more).parts().size());
  }

  @Test
  void aConvexOutlineIsOnePart() {
    Polygon hexagon = Polygon.regular(6, 1);
    float[] xy = new float[12];
    for (int i = 0; i < 6; i++) {
      xy[2 * i] = hexagon.vertexX(i);
      xy[2 * i + 1] = hexagon.vertexY(i);
    }
    assertEquals("Compound[" + hexagon + "]", Compound.ofOutline(xy).toString());
    float[] many = new float[400];
    for (int i = 0; i < 200; i++) {
      many[2 * i] = (float) (50 * Math.cos(i * Math.PI / 100));
      many[2 * i + 1] = (float) (50 * Math.sin(i * Math.PI / 100));
    }
    check("more corners than a polygon may have", many, new SplittableRandom(1));
    assertTrue(Compound.ofOutline(many).parts().size() > 1);
  }

  private static void refused(String start, float... xy) {
    String message =
        assertThrows(IllegalArgumentException.class, () -> Compound.ofOutline(xy)).getMessage();
    assertTrue(message.startsWith(start), message);
  }

  @Test
  void wrongOutlinesAreRefusedByName() {
    refused("outline coordinates=5 must be even", 0, 0, 1, 0, 1);
    refused("outline points=2 must be in 3..2048", 0, 0, 1, 0);
    refused("outline points=2049 must be in 3..2048", new float[2 * 2049]);
    refused("outline y1=NaN", 0, 0, 1, Float.NaN, 1, 1);
    refused("outline area=0 must be > 0", 1, 1, 1, 1, 1, 1);
    refused("outline turns back on itself at point=0", 0, 0, 1, 0, 2, 0);
    refused("outline turns back on itself at point=2", 0, 0, 2, 0, 2, 3, 2, 1, 0, 1);
    refused("outline edge=0 (from point 0) meets edge=2 (from point 2);", 0, 0, 2, 2, 2, 0, 0, 2);
    refused(
        "outline edge=0 (from point 0) meets edge=3 (from point 3)", 0, 0, 4, 0, 4, 2, 2, 0, 0, 2);
  }

  @Test
  void aPolygonRefusesWhatIsNotConvexAndNamesTheAlternatives() {
    String concave = assertThrows(IllegalArgumentException.class, () -> Polygon.of(L)).getMessage();
    assertEquals(
        "polygon point=3 is inside the hull, so the outline is concave; Compound.ofOutline cuts it"
            + " into convex parts, Polygon.hull takes its hull",
        concave);
    String order =
        assertThrows(
                IllegalArgumentException.class, () -> Polygon.rounded(.1f, 0, 0, 1, 1, 1, 0, 0, 1))
            .getMessage();
    assertTrue(order.startsWith("polygon points are not in the order of an outline"), order);
    assertThrows(
        IllegalArgumentException.class,
        () -> Polygon.of(0, 0, 1, 0, 1, 1, 0, 1, 0, 0, 1, 0, 1, 1, 0, 1),
        "twice around");
    assertEquals(5, Polygon.hull(L).vertexCount());
    assertEquals(3.5, Polygon.hull(L).area(), 1e-6);
  }

  @Test
  void aPolygonForgivesWhatItDropsAnyway() {
    assertEquals(4, Polygon.of(0, 0, .5f, 1e-6f, 1, 0, 1, .00001f, 1, 1, 0, 1).vertexCount());
    assertEquals(4, Polygon.of(0, 1, 1, 1, 1, 0, 0, 0, 0, .5f, 0, 1).vertexCount());
  }
}
