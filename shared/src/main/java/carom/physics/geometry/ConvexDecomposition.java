package carom.physics.geometry;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Cuts a simple polygon into convex ones. Ears are cut off until triangles are left (Meisters
 * 1975); diagonals are flipped until they are Delaunay's, as far as the outline allows, so that
 * triangles are as thick as they can be (Lawson 1977); then diagonals that no corner needs are
 * removed, the longest first (Hertel and Mehlhorn 1983, who show that at most four times as many
 * parts remain as the fewest possible).
 *
 * <p>Corners of parts are corners of the outline. The result depends on the outline alone. Costs
 * time in proportion to the square of the number of points, mostly.
 */
final class ConvexDecomposition {
  /** Sine of the turn of a corner that is clearly convex. */
  private static final double CLEARLY = 1e-3;

  private final SimpleOutline outline;
  private final float minSize;
  private final int mostVertices;
  private final int triangles;

  /** Three per triangle: its corners, counter-clockwise. */
  private final int[] corner;

  /** Three per triangle: the triangle beyond the edge that begins at this corner; -1 for none. */
  private final int[] beyond;

  private ConvexDecomposition(SimpleOutline outline, float minSize, int mostVertices) {
    this.outline = outline;
    this.minSize = minSize;
    this.mostVertices = mostVertices;
    triangles = outline.count() - 2;
    corner = new int[3 * triangles];
    beyond = new int[3 * triangles];
  }

  /**
   * Returns the corners of the convex parts of an outline, x0, y0, x1, y1, ... of each.
   *
   * @param minSize parts that are hardly thicker are left out, m
   * @param mostVertices of a part
   * @throws IllegalArgumentException when no part is thick enough
   */
  public static List<float[]> parts(SimpleOutline outline, float minSize, int mostVertices) {
    ConvexDecomposition d = new ConvexDecomposition(outline, minSize, mostVertices);
    d.cutEars();
    d.findNeighbours();
    d.flip();
    return d.merge();
  }

  // ---------------------------------------------------------------- triangles

  /** Cuts one ear after the other off, going round the outline. */
  private void cutEars() {
    int n = outline.count();
    int[] next = new int[n];
    int[] before = new int[n];
    for (int i = 0; i < n; i++) {
      next[i] = (i + 1) % n;
      before[i] = (i + n - 1) % n;
    }
    int left = n;
    int at = 0;
    int tried = 0;
    for (int t = 0; t < triangles; ) {
      if (left == 3 || isEar(before[at], at, next[at], next)) {
        corner[3 * t] = before[at];
        corner[3 * t + 1] = at;
        corner[3 * t + 2] = next[at];
        t++;
        next[before[at]] = next[at];
        before[next[at]] = before[at];
        at = next[next[at]]; // not the neighbour: fans of one corner are thin
        left--;
        tried = 0;
      } else if (++tried > left) {
        throw new IllegalArgumentException(
            "outline is too narrow to be cut near x="
                + outline.x[at]
                + " y="
                + outline.y[at]
                + "; move its edges further apart");
      } else {
        at = next[at];
      }
    }
  }

  /** Returns whether no other corner of what is left is in a triangle, or on its border. */
  private boolean isEar(int a, int b, int c, int[] next) {
    if (!(outline.turn(a, b, c) > 0)) {
      return false;
    }
    for (int p = next[c]; p != a; p = next[p]) {
      if (outline.turn(a, b, p) >= 0 && outline.turn(b, c, p) >= 0 && outline.turn(c, a, p) >= 0) {
        return false;
      }
    }
    return true;
  }

  /** Finds the triangle beyond each edge, by sorting the edges by their ends. */
  private void findNeighbours() {
    int n = corner.length;
    long[] edges = new long[n];
    for (int e = 0; e < n; e++) {
      long a = corner[e];
      long b = corner[following(e)];
      edges[e] = (Math.min(a, b) * outline.count() + Math.max(a, b)) * n + e;
    }
    Arrays.sort(edges);
    Arrays.fill(beyond, -1);
    for (int i = 0; i + 1 < n; i++) {
      if (edges[i] / n == edges[i + 1] / n) {
        int e = (int) (edges[i] % n);
        int f = (int) (edges[i + 1] % n);
        beyond[e] = f / 3;
        beyond[f] = e / 3;
      }
    }
  }

  /** Returns the edge after another one of the same triangle. */
  private static int following(int edge) {
    return edge % 3 == 2 ? edge - 2 : edge + 1;
  }

  /** Returns the edge of a triangle beyond which another one is. */
  private int edgeTowards(int triangle, int other) {
    int e = 3 * triangle;
    while (beyond[e] != other) {
      e++;
    }
    return e;
  }

  /** Flips diagonals until each is Delaunay's; the bound only ends what rounding might prolong. */
  private void flip() {
    boolean changed = true;
    for (int round = 0; changed && round < 2 * triangles; round++) {
      changed = false;
      for (int e = 0; e < corner.length; e++) {
        if (beyond[e] > e / 3 && isWorse(e)) {
          flip(e);
          changed = true;
        }
      }
    }
  }

  /** Returns whether the other diagonal of the two triangles at an edge would be better. */
  private boolean isWorse(int e) {
    int f = edgeTowards(beyond[e], e / 3);
    int a = corner[e];
    int b = corner[following(e)];
    int c = corner[following(following(e))];
    int d = corner[following(following(f))];
    // The other diagonal is from c to d, and must leave a and b on either side.
    if (!(outline.turn(c, d, b) > 0 && outline.turn(d, c, a) > 0)) {
      return false;
    }
    return inCircle(a, b, c, d);
  }

  /** Returns whether d is clearly inside the circle through a, b and c. */
  private boolean inCircle(int a, int b, int c, int d) {
    double ax = outline.x[a] - outline.x[d];
    double ay = outline.y[a] - outline.y[d];
    double bx = outline.x[b] - outline.x[d];
    double by = outline.y[b] - outline.y[d];
    double cx = outline.x[c] - outline.x[d];
    double cy = outline.y[c] - outline.y[d];
    double aa = ax * ax + ay * ay;
    double bb = bx * bx + by * by;
    double cc = cx * cx + cy * cy;
    double in = aa * (bx * cy - by * cx) + bb * (cx * ay - cy * ax) + cc * (ax * by - ay * bx);
    double scale = aa + bb + cc;
    return in > 1e-12 * scale * scale;
  }

  /** Replaces the edge from a to b, with c on its left and d on its right, by that from c to d. */
  private void flip(int e) {
    int t = e / 3;
    int u = beyond[e];
    int f = edgeTowards(u, t);
    int a = corner[e];
    int b = corner[following(e)];
    int c = corner[following(following(e))];
    int d = corner[following(following(f))];
    int bc = beyond[following(e)];
    int ca = beyond[following(following(e))];
    int ad = beyond[following(f)];
    int db = beyond[following(following(f))];
    set(t, d, b, c, db, bc, u);
    set(u, c, a, d, ca, ad, t);
    redirect(db, u, t);
    redirect(ca, t, u);
  }

  private void set(int t, int a, int b, int c, int beyondAb, int beyondBc, int beyondCa) {
    corner[3 * t] = a;
    corner[3 * t + 1] = b;
    corner[3 * t + 2] = c;
    beyond[3 * t] = beyondAb;
    beyond[3 * t + 1] = beyondBc;
    beyond[3 * t + 2] = beyondCa;
  }

  private void redirect(int triangle, int from, int to) {
    if (triangle >= 0) {
      beyond[edgeTowards(triangle, from)] = to;
    }
  }

  // ---------------------------------------------------------------- parts

  /**
   * Removes the diagonals that no corner needs, and returns what is left: in two orders, of which
   * the better one counts.
   */
  private List<float[]> merge() {
    int[] diagonals = diagonals();
    List<int[]> loops = merged(diagonals);
    for (int i = 0, j = diagonals.length - 1; i < j; i++, j--) {
      int kept = diagonals[i];
      diagonals[i] = diagonals[j];
      diagonals[j] = kept;
    }
    List<int[]> shortestFirst = merged(diagonals);
    List<float[]> parts = new ArrayList<>();
    for (int[] loop : shortestFirst.size() < loops.size() ? shortestFirst : loops) {
      if (isThickEnough(loop)) {
        parts.add(corners(loop));
      }
    }
    if (parts.isEmpty()) {
      throw new IllegalArgumentException(
          "outline is thinner than " + minSize + " m everywhere; scale it up");
    }
    return parts;
  }

  /**
   * Removes diagonals in an order, first those that leave corners clearly convex: at a straight
   * angle no other diagonal could go later.
   */
  private List<int[]> merged(int[] diagonals) {
    int[][] loops = new int[triangles][];
    int[] partOf = new int[triangles];
    for (int t = 0; t < triangles; t++) {
      loops[t] = Arrays.copyOfRange(corner, 3 * t, 3 * t + 3);
      partOf[t] = t;
    }
    for (double least : new double[] {CLEARLY, 0}) {
      for (int e : diagonals) {
        int p = find(partOf, e / 3);
        int q = find(partOf, beyond[e]);
        int[] both = p == q ? null : joined(loops[p], loops[q], e, least);
        if (both != null) {
          loops[p] = both;
          loops[q] = null;
          partOf[q] = p;
        }
      }
    }
    List<int[]> left = new ArrayList<>();
    for (int[] loop : loops) {
      if (loop != null) {
        left.add(loop);
      }
    }
    return left;
  }

  /** Returns the diagonals, each once, the longest first. */
  private int[] diagonals() {
    List<Integer> list = new ArrayList<>();
    for (int e = 0; e < corner.length; e++) {
      if (beyond[e] > e / 3) {
        list.add(e);
      }
    }
    list.sort((e, f) -> Double.compare(square(f), square(e)));
    int[] sorted = new int[list.size()];
    for (int i = 0; i < sorted.length; i++) {
      sorted[i] = list.get(i);
    }
    return sorted;
  }

  private double square(int e) {
    double dx = outline.x[corner[following(e)]] - outline.x[corner[e]];
    double dy = outline.y[corner[following(e)]] - outline.y[corner[e]];
    return dx * dx + dy * dy;
  }

  private static int find(int[] partOf, int triangle) {
    int p = triangle;
    while (partOf[p] != p) {
      p = partOf[p];
    }
    return p;
  }

  /**
   * Returns the loop of two parts together, or null if that isn't convex or has too many corners.
   *
   * @param p has the edge
   * @param q has it the other way round
   * @param least sine of the least turn at its ends
   */
  private int[] joined(int[] p, int[] q, int e, double least) {
    int a = corner[e];
    int b = corner[following(e)];
    int n = p.length + q.length - 2;
    if (n > mostVertices) {
      return null;
    }
    int inP = indexOf(p, a);
    int inQ = indexOf(q, b);
    // From b round p to a, then round q back to b.
    int[] loop = new int[n];
    for (int i = 0; i < p.length; i++) {
      loop[i] = p[(inP + 1 + i) % p.length];
    }
    for (int i = 2; i < q.length; i++) {
      loop[p.length + i - 2] = q[(inQ + i) % q.length];
    }
    int last = p.length - 1;
    boolean convex =
        turns(loop[n - 1], loop[0], loop[1], least)
            && turns(loop[last - 1], loop[last], loop[(last + 1) % n], least);
    return convex ? loop : null;
  }

  /** Returns whether a way turns left at b, by an angle of at least this sine. */
  private boolean turns(int a, int b, int c, double least) {
    double ux = outline.x[b] - outline.x[a];
    double uy = outline.y[b] - outline.y[a];
    double vx = outline.x[c] - outline.x[b];
    double vy = outline.y[c] - outline.y[b];
    double lengths = Math.sqrt((ux * ux + uy * uy) * (vx * vx + vy * vy));
    return ux * vy - uy * vx >= least * lengths;
  }

  private static int indexOf(int[] loop, int corner) {
    int i = 0;
    while (loop[i] != corner) {
      i++;
    }
    return i;
  }

  /** Returns whether a part is thick enough to be a shape. Thinner slivers are left out. */
  private boolean isThickEnough(int[] loop) {
    double thinnest = Double.POSITIVE_INFINITY;
    for (int i = 0; i < loop.length; i++) {
      int a = loop[i];
      int b = loop[(i + 1) % loop.length];
      double dx = outline.x[b] - outline.x[a];
      double dy = outline.y[b] - outline.y[a];
      double farthest = 0;
      for (int c : loop) {
        farthest = Math.max(farthest, outline.turn(a, b, c));
      }
      thinnest = Math.min(thinnest, farthest / Math.sqrt(dx * dx + dy * dy));
    }
    return thinnest > 1.5 * minSize;
  }

  private float[] corners(int[] loop) {
    float[] xy = new float[2 * loop.length];
    for (int i = 0; i < loop.length; i++) {
      xy[2 * i] = (float) outline.x[loop[i]];
      xy[2 * i + 1] = (float) outline.y[loop[i]];
    }
    return xy;
  }
}
