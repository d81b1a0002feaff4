package carom.tiled;

import carom.sim.level.LevelException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * A piece of collision geometry of a tile or an object, as points in pixels, y down.
 *
 * @param kind what the points are
 * @param points x and y; of a circle the centre and the radius; of a capsule two centres and the
 *     radius
 */
record TileShape(Kind kind, List<double[]> points) {
  /** Corners of an ellipse that isn't a circle. */
  private static final int ELLIPSE_CORNERS = 24;

  private static final int MAX_POINTS = 65_536;

  enum Kind {
    POLYGON,
    CIRCLE,
    CAPSULE,
    LINE
  }

  /**
   * Returns the shape of an object, relative to the object's place and not turned.
   *
   * @return null if it has none, as a point or a text
   */
  static TileShape of(TiledNode object) throws LevelException {
    double w = object.number("width", 0);
    double h = object.number("height", 0);
    if (object.has("point") || object.has("text")) {
      return null;
    }
    for (String field : List.of("polygon", "polyline")) {
      if (object.has(field)) {
        return new TileShape(
            field.equals("polygon") ? Kind.POLYGON : Kind.LINE, points(object, field));
      }
    }
    if (object.has("capsule") && w != h) {
      double r = Math.min(w, h) / 2;
      return new TileShape(Kind.CAPSULE, List.of(xy(r, r), xy(w - r, h - r), xy(r, 0)));
    }
    if (object.has("ellipse") || object.has("capsule")) {
      return w == h
          ? new TileShape(Kind.CIRCLE, List.of(xy(w / 2, h / 2), xy(w / 2, 0)))
          : new TileShape(Kind.POLYGON, ellipse(w, h));
    }
    return w > 0 && h > 0 ? rectangle(w, h) : null;
  }

  /** Returns a rectangle with one corner at the origin. */
  static TileShape rectangle(double w, double h) {
    return new TileShape(Kind.POLYGON, List.of(xy(0, 0), xy(w, 0), xy(w, h), xy(0, h)));
  }

  private static List<double[]> points(TiledNode object, String field) throws LevelException {
    List<TiledNode> nodes = object.nodes(field);
    if (nodes.size() > MAX_POINTS) {
      throw object.wrong("a " + field + " has " + nodes.size() + " points");
    }
    List<double[]> points = new ArrayList<>();
    for (TiledNode node : nodes) {
      points.add(xy(node.number("x", 0), node.number("y", 0)));
    }
    return points;
  }

  private static List<double[]> ellipse(double w, double h) {
    List<double[]> points = new ArrayList<>();
    for (int i = 0; i < ELLIPSE_CORNERS; i++) {
      double a = 2 * Math.PI * i / ELLIPSE_CORNERS;
      points.add(xy(w / 2 * (1 + Math.cos(a)), h / 2 * (1 + Math.sin(a))));
    }
    return points;
  }

  private static double[] xy(double x, double y) {
    return new double[] {x, y};
  }

  /** Moves points. */
  interface Move {
    /** Returns where a point comes to lie. */
    double[] of(double x, double y);
  }

  /**
   * Returns the shape elsewhere.
   *
   * @param scale factor on radii
   */
  TileShape moved(Move move, double scale) {
    List<double[]> moved = new ArrayList<>();
    int places = kind == Kind.CIRCLE ? 1 : kind == Kind.CAPSULE ? 2 : points.size();
    for (int i = 0; i < points.size(); i++) {
      double[] p = points.get(i);
      moved.add(i < places ? move.of(p[0], p[1]) : xy(p[0] * scale, p[1]));
    }
    return new TileShape(kind, moved);
  }

  /** Returns the shape turned clockwise about a point, as Tiled turns objects; degrees. */
  TileShape turned(double aboutX, double aboutY, double degrees) {
    double cos = Math.cos(Math.toRadians(degrees));
    double sin = Math.sin(Math.toRadians(degrees));
    return moved(
        (x, y) ->
            xy(
                aboutX + (x - aboutX) * cos - (y - aboutY) * sin,
                aboutY + (x - aboutX) * sin + (y - aboutY) * cos),
        1);
  }

  /** Returns the corners of the box around the points: least x and y, greatest x and y. */
  double[] box() {
    double[] box = {
      Double.POSITIVE_INFINITY,
      Double.POSITIVE_INFINITY,
      Double.NEGATIVE_INFINITY,
      Double.NEGATIVE_INFINITY
    };
    double radius = kind == Kind.CIRCLE || kind == Kind.CAPSULE ? last()[0] : 0;
    int places = radius > 0 ? points.size() - 1 : points.size();
    for (double[] p : points.subList(0, places)) {
      box[0] = Math.min(box[0], p[0] - radius);
      box[1] = Math.min(box[1], p[1] - radius);
      box[2] = Math.max(box[2], p[0] + radius);
      box[3] = Math.max(box[3], p[1] + radius);
    }
    return box;
  }

  private double[] last() {
    return points.get(points.size() - 1);
  }

  /**
   * Returns the shape in the notation of level files, in a frame with its origin at a point of the
   * map.
   */
  Map<String, Object> json(MapScale scale, double originX, double originY) {
    List<Object> out = new ArrayList<>();
    for (double[] p : points) {
      out.add(List.of(scale.length(p[0] - originX), -scale.length(p[1] - originY)));
    }
    double radius = scale.length(last()[0]);
    Map<String, Object> json = new LinkedHashMap<>();
    switch (kind) {
      case CIRCLE:
        json.put("type", "circle");
        json.put("radius", radius);
        json.put("at", out.get(0));
        break;
      case CAPSULE:
        json.put("type", "capsule");
        json.put("from", out.get(0));
        json.put("to", out.get(1));
        json.put("radius", radius);
        break;
      case LINE:
        json.put("type", "chain");
        json.put("points", out);
        break;
      default:
        if (isUprightRectangle()) {
          double[] box = box();
          json.put("type", "box");
          json.put("width", scale.length(box[2] - box[0]));
          json.put("height", scale.length(box[3] - box[1]));
          double x = scale.length((box[0] + box[2]) / 2 - originX);
          double y = -scale.length((box[1] + box[3]) / 2 - originY);
          if (Math.abs(x) > 1e-9 || Math.abs(y) > 1e-9) {
            json.put("at", List.of(x, y));
          }
        } else {
          json.put("type", "polygon");
          json.put("points", out);
        }
    }
    return json;
  }

  private boolean isUprightRectangle() {
    if (points.size() != 4) {
      return false;
    }
    for (int i = 0; i < 4; i++) {
      double[] a = points.get(i);
      double[] b = points.get((i + 1) % 4);
      double[] c = points.get((i + 2) % 4);
      boolean turns = (a[0] == b[0] && b[1] == c[1]) || (a[1] == b[1] && b[0] == c[0]);
      if (!turns || (a[0] == b[0] && a[1] == b[1])) {
        return false;
      }
    }
    return true;
  }
}
