package carom.tiled;

import carom.sim.level.LevelException;
import carom.sim.level.LevelFields;
import carom.tiled.TileOutlines.Loop;
import carom.tiled.TileOutlines.Point;
import carom.tiled.TileRectangles.Rectangle;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Turns the tiles of a layer into few items of a level.
 *
 * <p>Solid tiles become chains along their common outline, because bodies slide over the joints of
 * a chain and would catch on the seams of boxes. Within the outline lie boxes that nothing reaches:
 * a window draws the walls by them, and they push out what gets in all the same. Sensors and
 * one-way platforms become rectangles, in which seams do nothing or are few.
 */
final class TileSolids {
  /** Parts of a pixel in which corners are compared: coordinates are whole numbers then. */
  private static final int FINE = 64;

  /** Part of a tile by which boxes stay away from the outline. */
  private static final double INSET = 0.125;

  private static final int MAX_CORNERS = 64;
  private static final int COMPOUND_PARTS = 32;
  private static final int LOOSE_PARTS = 4;
  private static final double MAX_COORDINATE = 1e7; // pixels, so that fine ones are ints

  /** Says what a tile is. */
  private enum Use {
    NOTHING,
    SOLID,
    ONE_WAY,
    SENSOR,
    SPAWN
  }

  /**
   * A tile in the layer, with its flips.
   *
   * @param fields of the item, without what says the use
   * @param material number of the material in {@link #materials}, for outlines
   * @param shapes within the tile; null if it fills its cell
   */
  private record Kind(Use use, Map<String, Object> fields, int material, List<TileShape> shapes) {}

  private static final Kind NONE = new Kind(Use.NOTHING, Map.of(), 0, null);

  private final TiledFile file;
  private final LevelDraft draft;
  private final String origin;
  private final TiledNode layer;
  private final boolean isMarked;
  private final MapScale scale;
  private final TileLayer cells;
  private final int tileWidth;
  private final int tileHeight;
  private final double offsetX;
  private final double offsetY;
  private final Map<Integer, Kind> kinds = new HashMap<>();
  private final List<Object> materials = new ArrayList<>();

  /**
   * Prepares a layer.
   *
   * @param isMarked whether the map says anywhere which tiles are solid
   */
  TileSolids(
      TiledFile file,
      LevelDraft draft,
      String origin,
      TiledNode layer,
      TileLayer cells,
      boolean isMarked,
      MapScale scale,
      double offsetX,
      double offsetY)
      throws LevelException {
    this.file = file;
    this.draft = draft;
    this.origin = origin;
    this.layer = layer;
    this.cells = cells;
    this.isMarked = isMarked;
    this.scale = scale;
    this.offsetX = offsetX;
    this.offsetY = offsetY;
    tileWidth = file.map.whole("tilewidth", 0, 1, 4096);
    tileHeight = file.map.whole("tileheight", 0, 1, 4096);
    double far =
        Math.max(
            Math.max(Math.abs((double) cells.column), Math.abs((double) cells.column + cells.width))
                * tileWidth,
            Math.max(Math.abs((double) cells.row), Math.abs((double) cells.row + cells.height))
                * tileHeight);
    if (far > MAX_COORDINATE) {
      throw layer.wrong("lies farther than " + (long) MAX_COORDINATE + " pixels from the origin");
    }
  }

  /** Adds the items. */
  void convert() throws LevelException {
    Map<Map<String, Object>, TileOutlines> outlines = new LinkedHashMap<>();
    Map<Map<String, Object>, List<TileShape>> loose = new LinkedHashMap<>();
    for (int row = cells.row; row < cells.row + cells.height; row++) {
      for (int column = cells.column; column < cells.column + cells.width; column++) {
        Kind kind = kind(cells.at(column, row));
        if (kind.use == Use.SPAWN) {
          spawn(kind, column, row);
        } else if (kind.use != Use.NOTHING) {
          List<Point> outline = kind.use == Use.SOLID ? outline(kind, column, row) : null;
          if (outline != null) {
            Map<String, Object> group = new LinkedHashMap<>(kind.fields);
            group.remove("material");
            outlines
                .computeIfAbsent(group, g -> new TileOutlines(tileWidth * FINE, tileHeight * FINE))
                .add(outline, kind.material);
          } else if (kind.shapes != null && (kind.use == Use.SOLID || platform(kind) == null)) {
            double x = (double) column * tileWidth;
            double y = (row + 1.0) * tileHeight;
            for (TileShape shape : kind.shapes) {
              loose
                  .computeIfAbsent(marked(kind), fields -> new ArrayList<>())
                  .add(shape.moved((px, py) -> new double[] {x + px, y + py}, 1));
            }
          }
        }
      }
    }
    outlines.forEach((fields, lines) -> lines.loops().forEach(loop -> chain(fields, loop)));
    fills();
    rectangles();
    loose.forEach((fields, shapes) -> compounds(fields, shapes, LOOSE_PARTS));
  }

  private void add(Map<String, Object> fields, Object shape, double x, double y) {
    Map<String, Object> item = new LinkedHashMap<>(fields);
    item.put("at", List.of(scale.x(x + offsetX), scale.y(y + offsetY)));
    item.put("shape", shape);
    draft.add("statics", item, origin, fields.keySet());
  }

  private static Map<String, Object> marked(Kind kind) {
    Map<String, Object> fields = new LinkedHashMap<>(kind.fields);
    if (kind.use == Use.ONE_WAY) {
      fields.put("oneWay", true);
    } else if (kind.use == Use.SENSOR) {
      fields.put("sensor", true);
    }
    return fields;
  }

  private void chain(Map<String, Object> fields, Loop loop) {
    Point first = loop.points().get(0);
    double x = (double) first.x() / FINE;
    double y = (double) first.y() / FINE;
    List<Object> points = new ArrayList<>();
    for (Point p : loop.points()) {
      points.add(
          List.of(
              scale.length((double) p.x() / FINE - x), -scale.length((double) p.y() / FINE - y)));
    }
    Map<String, Object> shape = new LinkedHashMap<>();
    shape.put("type", "chain");
    shape.put("loop", true);
    shape.put("points", points);
    Map<String, Object> item = new LinkedHashMap<>(fields);
    if (loop.materials().stream().distinct().count() == 1) {
      Object material = materials.get(loop.materials().get(0));
      if (!isNone(material)) {
        item.put("material", material);
      }
    } else {
      shape.put("materials", loop.materials().stream().map(materials::get).toList());
    }
    add(item, shape, x, y);
  }

  private static boolean isNone(Object material) {
    return material instanceof Map;
  }

  /** Adds boxes and polygons within the outlines. */
  private void fills() throws LevelException {
    Map<Kind, Integer> numbers = new LinkedHashMap<>();
    Map<Map<String, Object>, List<TileShape>> parts = new LinkedHashMap<>();
    List<Kind> byNumber = new ArrayList<>();
    List<Rectangle> whole =
        TileRectangles.cover(
            cells.column,
            cells.row,
            cells.width,
            cells.height,
            (column, row) -> {
              Kind kind = known(column, row);
              return kind.use == Use.SOLID && kind.shapes == null
                  ? number(numbers, byNumber, kind)
                  : 0;
            });
    for (Rectangle r : whole) {
      Kind kind = byNumber.get(r.kind() - 1);
      parts.computeIfAbsent(kind.fields, f -> new ArrayList<>()).add(inset(r));
    }
    for (int row = cells.row; row < cells.row + cells.height; row++) {
      for (int column = cells.column; column < cells.column + cells.width; column++) {
        Kind kind = known(column, row);
        List<Point> outline =
            kind.use == Use.SOLID && kind.shapes != null ? outline(kind, column, row) : null;
        if (outline != null && isConvex(outline)) {
          parts.computeIfAbsent(kind.fields, f -> new ArrayList<>()).add(shrunk(outline));
        }
      }
    }
    parts.forEach((fields, shapes) -> compounds(fields, shapes, COMPOUND_PARTS));
  }

  /** Returns the rectangle without a margin along each side at which anything may come near. */
  private TileShape inset(Rectangle r) {
    double dx = INSET * tileWidth;
    double dy = INSET * tileHeight;
    double left = isCovered(r.column() - 1, r.row() - 1, 1, r.height() + 2) ? 0 : dx;
    double right = isCovered(r.column() + r.width(), r.row() - 1, 1, r.height() + 2) ? 0 : dx;
    double top = isCovered(r.column() - 1, r.row() - 1, r.width() + 2, 1) ? 0 : dy;
    double bottom = isCovered(r.column() - 1, r.row() + r.height(), r.width() + 2, 1) ? 0 : dy;
    double x = (double) r.column() * tileWidth + left;
    double y = (double) r.row() * tileHeight + top;
    double w = (double) r.width() * tileWidth - left - right;
    double h = (double) r.height() * tileHeight - top - bottom;
    return TileShape.rectangle(w, h).moved((px, py) -> new double[] {x + px, y + py}, 1);
  }

  private boolean isCovered(int column, int row, int width, int height) {
    for (int y = row; y < row + height; y++) {
      for (int x = column; x < column + width; x++) {
        Kind kind = known(x, y);
        if (kind.use != Use.SOLID || kind.shapes != null) {
          return false;
        }
      }
    }
    return true;
  }

  private static TileShape shrunk(List<Point> outline) {
    double x = outline.stream().mapToDouble(Point::x).average().orElse(0);
    double y = outline.stream().mapToDouble(Point::y).average().orElse(0);
    List<double[]> points = new ArrayList<>();
    for (Point p : outline) {
      double keep = 1 - 2 * INSET;
      points.add(new double[] {(x + (p.x() - x) * keep) / FINE, (y + (p.y() - y) * keep) / FINE});
    }
    return new TileShape(TileShape.Kind.POLYGON, points);
  }

  private static boolean isConvex(List<Point> outline) {
    int sign = 0;
    for (int i = 0; i < outline.size(); i++) {
      Point a = outline.get(i);
      Point b = outline.get((i + 1) % outline.size());
      Point c = outline.get((i + 2) % outline.size());
      int turn =
          Long.signum(
              ((long) b.x() - a.x()) * ((long) c.y() - b.y())
                  - ((long) b.y() - a.y()) * ((long) c.x() - b.x()));
      if (turn * sign < 0) {
        return false;
      }
      sign = turn == 0 ? sign : turn;
    }
    return true;
  }

  private static int number(Map<Kind, Integer> numbers, List<Kind> byNumber, Kind kind) {
    return numbers.computeIfAbsent(
        kind,
        k -> {
          byNumber.add(k);
          return byNumber.size();
        });
  }

  /** Adds sensors, and one-way platforms, which grow to the side only. */
  private void rectangles() {
    Map<Kind, Integer> numbers = new LinkedHashMap<>();
    List<Kind> byNumber = new ArrayList<>();
    List<Rectangle> all =
        TileRectangles.cover(
            cells.column,
            cells.row,
            cells.width,
            cells.height,
            (column, row) -> {
              Kind kind = known(column, row);
              boolean isMerged = kind.shapes == null || platform(kind) != null;
              if (!isMerged || (kind.use != Use.SENSOR && kind.use != Use.ONE_WAY)) {
                return 0;
              }
              int number = number(numbers, byNumber, kind);
              return kind.use == Use.SENSOR && kind.shapes == null ? number : -number;
            });
    for (Rectangle r : all) {
      Kind kind = byNumber.get(Math.abs(r.kind()) - 1);
      double[] band = kind.shapes == null ? null : platform(kind);
      double top = band == null ? 0 : tileHeight + band[0];
      double height = band == null ? r.height() * tileHeight : band[1] - band[0];
      TileShape box = TileShape.rectangle((double) r.width() * tileWidth, height);
      double x = (double) r.column() * tileWidth + (double) r.width() * tileWidth / 2;
      double y = (double) r.row() * tileHeight + top + height / 2;
      double halfWidth = (double) r.width() * tileWidth / 2;
      add(marked(kind), box.json(scale, halfWidth, height / 2), x, y);
    }
  }

  /** Returns the upper and lower edge of the one rectangle as wide as its tile, or null. */
  private double[] platform(Kind kind) {
    double[] box = kind.shapes.get(0).box();
    boolean isBand =
        kind.shapes.size() == 1
            && isRectangle(kind.shapes.get(0))
            && box[0] == 0
            && box[2] == tileWidth;
    return isBand ? new double[] {box[1], box[3]} : null;
  }

  private void compounds(Map<String, Object> fields, List<TileShape> shapes, int most) {
    for (int from = 0; from < shapes.size(); from += most) {
      List<TileShape> parts = shapes.subList(from, Math.min(shapes.size(), from + most));
      double[] box = parts.get(0).box();
      double x = (box[0] + box[2]) / 2;
      double y = (box[1] + box[3]) / 2;
      List<Object> all = new ArrayList<>();
      for (TileShape part : parts) {
        all.add(part.json(scale, x, y));
      }
      Map<String, Object> compound = new LinkedHashMap<>();
      compound.put("type", "compound");
      compound.put("parts", all);
      add(fields, all.size() == 1 ? all.get(0) : compound, x, y);
    }
  }

  private void spawn(Kind kind, int column, int row) {
    Map<String, Object> item = new LinkedHashMap<>(kind.fields);
    double x = (column + 0.5) * tileWidth + offsetX;
    double y = (row + 0.5) * tileHeight + offsetY;
    item.put("at", List.of(scale.x(x), scale.y(y)));
    draft.add("spawns", item, origin, kind.fields.keySet());
  }

  /** Returns the kind of a cell that {@link #convert} has seen before. */
  private Kind known(int column, int row) {
    return kinds.getOrDefault(cells.at(column, row), NONE);
  }

  private Kind kind(int raw) throws LevelException {
    Kind kind = kinds.get(raw);
    if (kind == null) {
      kind = raw == 0 ? NONE : find(TileGid.of(raw));
      kinds.put(raw, kind);
    }
    return kind;
  }

  private Kind find(TileGid gid) throws LevelException {
    Tileset set = file.tileset(gid.gid());
    if (set == null) {
      draft.skip(origin, "tile " + gid.gid() + " is of no tileset");
      return NONE;
    }
    TiledNode tile = set.tile(gid.gid());
    Properties properties = new Properties().read(layer, origin, draft);
    String name = "";
    if (tile != null) {
      String title = origin + ", tile " + gid.gid();
      properties.read(tile, title, draft);
      name = tile.text("type", tile.text("class", ""));
    }
    String word = name.isEmpty() ? layer.text("class", "") : name;
    List<TileShape> shapes = shapes(tile, set, gid);
    Use use = use(word, properties, !shapes.isEmpty());
    if (use == Use.NOTHING) {
      return NONE;
    }
    boolean isSpawn = use == Use.SPAWN;
    List<String> known = LevelFields.item(isSpawn ? "spawns" : "statics");
    Map<String, Object> fields = properties.fields(known, name, use == Use.SOLID, draft);
    fields.remove("oneWay");
    fields.remove("sensor");
    int material = material(fields.get("material"));
    boolean fills = shapes.isEmpty() && set.tileWidth == tileWidth && set.tileHeight == tileHeight;
    if (shapes.isEmpty() && !fills) {
      shapes = List.of(placed(TileShape.rectangle(set.tileWidth, set.tileHeight), set, gid));
    }
    return new Kind(use, fields, material, fills || isSpawn || isWhole(shapes) ? null : shapes);
  }

  private int material(Object name) {
    Object material = name == null ? Map.of() : name;
    int at = materials.indexOf(material);
    if (at < 0) {
      materials.add(material);
    }
    return at < 0 ? materials.size() - 1 : at;
  }

  private Use use(String word, Properties properties, boolean hasShapes) {
    if (properties.flag("sensor") || word.equals("sensor")) {
      return Use.SENSOR;
    }
    if (properties.flag("oneWay") || word.equals("oneWay")) {
      return Use.ONE_WAY;
    }
    if (word.equals("decor")) {
      return Use.NOTHING;
    }
    if (word.equals("spawn")) {
      return Use.SPAWN;
    }
    boolean isSolid = hasShapes || isSolidWord(word) || !isMarked;
    return isSolid ? Use.SOLID : Use.NOTHING;
  }

  /** Returns whether a class says that tiles are solid. */
  static boolean isSolidWord(String word) {
    return word.equals("solid") || word.equals("static");
  }

  /** Returns whether a class says of what use tiles are. */
  static boolean isWord(String word) {
    return isSolidWord(word)
        || word.equals("sensor")
        || word.equals("oneWay")
        || word.equals("spawn")
        || word.equals("decor");
  }

  /** Returns the collision shapes of a tile as it lies; places are from the cell's lower left. */
  private List<TileShape> shapes(TiledNode tile, Tileset set, TileGid gid) throws LevelException {
    List<TileShape> shapes = new ArrayList<>();
    TiledNode group = tile == null ? null : tile.node("objectgroup");
    if (group != null) {
      for (TiledNode object : group.nodes("objects")) {
        TileShape shape = TileShape.of(object);
        if (shape == null || shape.kind() == TileShape.Kind.LINE || shape.points().isEmpty()) {
          draft.skip(origin, "tile " + gid.gid() + " has a collision shape without area");
          continue;
        }
        double x = object.number("x", 0);
        double y = object.number("y", 0);
        shapes.add(
            placed(
                shape
                    .turned(0, 0, object.number("rotation", 0))
                    .moved((px, py) -> new double[] {x + px, y + py}, 1),
                set,
                gid));
      }
    }
    return shapes;
  }

  private static TileShape placed(TileShape shape, Tileset set, TileGid gid) {
    double height = gid.swapped() ? set.tileWidth : set.tileHeight;
    return shape.moved(
        (x, y) -> {
          double[] p = gid.place(x, y, set.tileWidth, set.tileHeight);
          return new double[] {p[0], p[1] - height};
        },
        1);
  }

  /** Returns whether a rectangle fills the cell. */
  private boolean isWhole(List<TileShape> shapes) {
    if (shapes.size() != 1 || !isRectangle(shapes.get(0))) {
      return false;
    }
    double[] box = shapes.get(0).box();
    return box[0] == 0 && box[2] == tileWidth && box[1] == -tileHeight && box[3] == 0;
  }

  private static boolean isRectangle(TileShape shape) {
    double[] box = shape.box();
    boolean isRectangle = shape.kind() == TileShape.Kind.POLYGON && shape.points().size() == 4;
    for (double[] p : shape.points()) {
      isRectangle &= (p[0] == box[0] || p[0] == box[2]) && (p[1] == box[1] || p[1] == box[3]);
    }
    return isRectangle;
  }

  /** Returns the outline of a solid tile in fine coordinates, or null if it has none of its own. */
  private List<Point> outline(Kind kind, int column, int row) {
    int left = column * tileWidth * FINE;
    int bottom = (row + 1) * tileHeight * FINE;
    int width = tileWidth * FINE;
    int height = tileHeight * FINE;
    if (kind.shapes == null) {
      return List.of(
          new Point(left, bottom - height),
          new Point(left + width, bottom - height),
          new Point(left + width, bottom),
          new Point(left, bottom));
    }
    if (kind.shapes.size() != 1 || kind.shapes.get(0).kind() != TileShape.Kind.POLYGON) {
      return null;
    }
    List<Point> points = new ArrayList<>();
    for (double[] p : kind.shapes.get(0).points()) {
      double x = Math.rint(p[0] * FINE);
      double y = Math.rint(p[1] * FINE);
      if (!(x >= 0 && x <= width && y <= 0 && y >= -height)) {
        return null;
      }
      points.add(new Point(left + (int) x, bottom + (int) y));
    }
    boolean isGood = points.size() <= MAX_CORNERS && isSimple(points);
    return isGood && TileOutlines.doubleArea(points) != 0 ? points : null;
  }

  private static boolean isSimple(List<Point> points) {
    int n = points.size();
    for (int i = 0; i < n; i++) {
      for (int j = i + 1; j < n; j++) {
        boolean areNeighbours = j == i + 1 || (i == 0 && j == n - 1);
        if (points.get(i).equals(points.get(j))
            || (!areNeighbours
                && crosses(
                    points.get(i),
                    points.get((i + 1) % n),
                    points.get(j),
                    points.get((j + 1) % n)))) {
          return false;
        }
      }
    }
    return n >= 3;
  }

  private static boolean crosses(Point a, Point b, Point c, Point d) {
    return side(a, b, c) * side(a, b, d) <= 0 && side(c, d, a) * side(c, d, b) <= 0;
  }

  private static int side(Point a, Point b, Point c) {
    return Long.signum(
        ((long) b.x() - a.x()) * ((long) c.y() - a.y())
            - ((long) b.y() - a.y()) * ((long) c.x() - a.x()));
  }
}
