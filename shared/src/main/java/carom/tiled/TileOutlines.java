package carom.tiled;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * The outlines of solid tiles: closed lines around all that hang together, and around their holes.
 * Edges that two tiles share are gone, so nothing can catch on a seam.
 *
 * <p>Coordinates are whole numbers, y down. A line runs so that what is solid lies on its right as
 * seen with y up: once y is turned, it is a chain that is solid from outside.
 */
final class TileOutlines {
  /**
   * A closed line.
   *
   * @param points x and y of each corner
   * @param materials of the line from each corner to the next
   */
  record Loop(List<Point> points, List<Integer> materials) {}

  /** A corner. */
  record Point(int x, int y) {}

  private record Edge(Point from, Point to) {}

  private final Map<Edge, Integer> edges = new LinkedHashMap<>();
  private final int cellWidth;
  private final int cellHeight;

  /** Creates outlines without tiles; the size of a cell only makes the search fast. */
  TileOutlines(int cellWidth, int cellHeight) {
    this.cellWidth = cellWidth;
    this.cellHeight = cellHeight;
  }

  /**
   * Adds a polygon.
   *
   * @param corners simple, in either winding; it overlaps no other one
   * @param material number of its material
   */
  void add(List<Point> corners, int material) {
    int n = corners.size();
    boolean forwards = doubleArea(corners) > 0;
    for (int i = 0; i < n; i++) {
      Point a = corners.get(forwards ? i : n - 1 - i);
      Point b = corners.get(forwards ? (i + 1) % n : (2 * n - 2 - i) % n);
      cancelOrPut(edges, new Edge(a, b), material);
    }
  }

  /** Returns twice the area of a polygon, positive if it runs clockwise as seen with y down. */
  static long doubleArea(List<Point> corners) {
    long sum = 0;
    for (int i = 0; i < corners.size(); i++) {
      Point a = corners.get(i);
      Point b = corners.get((i + 1) % corners.size());
      sum += (long) a.x * b.y - (long) b.x * a.y;
    }
    return sum;
  }

  private static void cancelOrPut(Map<Edge, Integer> edges, Edge edge, int material) {
    if (edges.remove(new Edge(edge.to, edge.from)) == null) {
      edges.put(edge, material);
    }
  }

  /** Returns the outlines, each corner once in each. */
  List<Loop> loops() {
    Map<Edge, Integer> cut = cut();
    Map<Point, Deque<Edge>> leaving = new LinkedHashMap<>();
    cut.keySet().forEach(e -> leaving.computeIfAbsent(e.from, p -> new ArrayDeque<>()).add(e));
    List<Loop> loops = new ArrayList<>();
    for (Edge first : cut.keySet()) {
      Deque<Edge> start = leaving.get(first.from);
      if (!start.remove(first)) {
        continue; // in a loop already
      }
      List<Edge> way = new ArrayList<>(List.of(first));
      Edge last = first;
      while (!last.to.equals(first.from)) {
        last = takeSharpestRight(last, leaving.get(last.to));
        way.add(last);
      }
      split(way, cut, loops);
    }
    return loops;
  }

  /** Takes the edge that stays closest to the solid which the last one has on its right. */
  private static Edge takeSharpestRight(Edge last, Deque<Edge> leaving) {
    Edge best = null;
    double bestTurn = Double.NEGATIVE_INFINITY;
    for (Edge edge : leaving) {
      double ax = last.to.x - (double) last.from.x;
      double ay = last.to.y - (double) last.from.y;
      double bx = edge.to.x - (double) edge.from.x;
      double by = edge.to.y - (double) edge.from.y;
      double turn = Math.atan2(ax * by - ay * bx, ax * bx + ay * by); // y down: right is positive
      if (turn > bestTurn) {
        best = edge;
        bestTurn = turn;
      }
    }
    leaving.remove(best);
    return best;
  }

  /** Splits a way where it comes to a corner again, and adds the loops. */
  private static void split(List<Edge> way, Map<Edge, Integer> materials, List<Loop> loops) {
    List<Edge> open = new ArrayList<>();
    Map<Point, Integer> begins = new HashMap<>();
    for (Edge edge : way) {
      begins.put(edge.from, open.size());
      open.add(edge);
      Integer at = begins.get(edge.to);
      if (at != null) {
        List<Edge> loop = open.subList(at, open.size());
        loops.add(simplified(loop, materials));
        loop.forEach(e -> begins.remove(e.from));
        loop.clear();
      }
    }
  }

  /** Returns a loop without corners at which neither direction nor material changes. */
  private static Loop simplified(List<Edge> edges, Map<Edge, Integer> materials) {
    Loop loop = new Loop(new ArrayList<>(), new ArrayList<>());
    for (int i = 0; i < edges.size(); i++) {
      Edge before = edges.get((i + edges.size() - 1) % edges.size());
      Edge edge = edges.get(i);
      int material = materials.get(edge);
      if (cross(before.from, before.to, edge.to) != 0 || material != materials.get(before)) {
        loop.points.add(edge.from);
        loop.materials.add(material);
      }
    }
    return loop;
  }

  private static long cross(Point a, Point b, Point c) {
    return ((long) b.x - a.x) * ((long) c.y - a.y) - ((long) b.y - a.y) * ((long) c.x - a.x);
  }

  /** Returns the edges, cut where a corner of another lies on one, without what then cancels. */
  private Map<Edge, Integer> cut() {
    Map<Point, List<Point>> corners = new HashMap<>(); // by cell
    for (Edge edge : edges.keySet()) {
      List<Point> cell = corners.computeIfAbsent(cell(edge.from), key -> new ArrayList<>(4));
      if (!cell.contains(edge.from)) {
        cell.add(edge.from);
      }
    }
    Map<Edge, Integer> cut = new LinkedHashMap<>();
    edges.forEach(
        (edge, material) -> {
          Point from = edge.from;
          for (Point on : cornersOn(edge, corners)) {
            cancelOrPut(cut, new Edge(from, on), material);
            from = on;
          }
          cancelOrPut(cut, new Edge(from, edge.to), material);
        });
    return cut;
  }

  private Point cell(Point p) {
    return new Point(Math.floorDiv(p.x, cellWidth), Math.floorDiv(p.y, cellHeight));
  }

  private List<Point> cornersOn(Edge edge, Map<Point, List<Point>> corners) {
    List<Point> found = new ArrayList<>();
    Point a = cell(edge.from);
    Point b = cell(edge.to);
    for (int y = Math.min(a.y, b.y); y <= Math.max(a.y, b.y); y++) {
      for (int x = Math.min(a.x, b.x); x <= Math.max(a.x, b.x); x++) {
        for (Point p : corners.getOrDefault(new Point(x, y), List.of())) {
          if (isInside(edge, p)) {
            found.add(p);
          }
        }
      }
    }
    found.sort((p, q) -> Long.compare(distance(edge.from, p), distance(edge.from, q)));
    return found;
  }

  private static boolean isInside(Edge e, Point p) {
    long dx = (long) e.to.x - e.from.x;
    long dy = (long) e.to.y - e.from.y;
    long along = dx * ((long) p.x - e.from.x) + dy * ((long) p.y - e.from.y);
    return cross(e.from, e.to, p) == 0 && along > 0 && along < dx * dx + dy * dy;
  }

  private static long distance(Point a, Point b) {
    return Math.abs((long) a.x - b.x) + Math.abs((long) a.y - b.y);
  }
}
