package carom.tiled;

import carom.sim.level.LevelException;
import carom.sim.level.LevelFields;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Turns the objects of a layer into items of a level, by their classes. */
final class TiledObjects {
  private final TiledFile file;
  private final LevelDraft draft;
  private final TiledNode layer;
  private final String layerTitle;
  private final MapScale scale;
  private final double offsetX;
  private final double offsetY;

  /** Prepares a layer. */
  TiledObjects(
      TiledFile file,
      LevelDraft draft,
      TiledNode layer,
      String layerTitle,
      MapScale scale,
      double offsetX,
      double offsetY) {
    this.file = file;
    this.draft = draft;
    this.layer = layer;
    this.layerTitle = layerTitle;
    this.scale = scale;
    this.offsetX = offsetX;
    this.offsetY = offsetY;
  }

  /** Adds the items. */
  void convert() throws LevelException {
    for (TiledNode object : layer.nodes("objects")) {
      int id = object.whole("id", 0, 0, Integer.MAX_VALUE);
      String name = object.text("name", "");
      String title = layerTitle + ", object " + id + (name.isEmpty() ? "" : " \"" + name + "\"");
      new Convert(object, id, name, title).run();
    }
  }

  /** The conversion of one object. */
  private final class Convert {
    private final TiledNode object;
    private final int id;
    private final String name;
    private final String title;
    private final Properties properties = new Properties();
    private final double x;
    private final double y;
    private final double width;
    private final double height;
    private final double rotation;
    private List<TileShape> shapes = new ArrayList<>();
    private String word;

    Convert(TiledNode object, int id, String name, String title) throws LevelException {
      this.object = object;
      this.id = id;
      this.name = name;
      this.title = title;
      x = object.number("x", 0) + offsetX;
      y = object.number("y", 0) + offsetY;
      width = object.number("width", 0);
      height = object.number("height", 0);
      rotation = object.number("rotation", 0) % 360;
    }

    void run() throws LevelException {
      if (object.has("template")) {
        draft.skip(title, "templates aren't read; detach the object in Tiled");
        return;
      }
      properties.read(layer, layerTitle, draft);
      word = object.text("type", object.text("class", ""));
      if (object.has("gid")) {
        tile();
      } else {
        TileShape shape = TileShape.of(object);
        if (shape != null && !shape.points().isEmpty()) {
          shapes.add(shape);
        }
      }
      properties.read(object, title, draft);
      if (word.isEmpty()) {
        word = layer.text("class", "");
      }
      if (word.isEmpty()) {
        word = usual();
      }
      convert();
    }

    /** Returns what an object without a class is. */
    private String usual() {
      if (object.has("text")) {
        return "text";
      }
      if (object.has("gid") && shapes.isEmpty()) {
        return "decor";
      }
      return shapes.isEmpty() ? "spawn" : "static";
    }

    /** Takes class, properties and shapes of the tile that the object shows. */
    private void tile() throws LevelException {
      double raw = object.number("gid", 0);
      TileGid gid = TileGid.of((int) (long) raw);
      Tileset set = file.tileset(gid.gid());
      if (set == null) {
        draft.skip(title, "tile " + gid.gid() + " is of no tileset");
        return;
      }
      TiledNode tile = set.tile(gid.gid());
      if (tile == null) {
        return;
      }
      properties.read(tile, title, draft);
      if (word.isEmpty()) {
        word = tile.text("type", tile.text("class", ""));
      }
      TiledNode group = tile.node("objectgroup");
      for (TiledNode part : group == null ? List.<TiledNode>of() : group.nodes("objects")) {
        TileShape shape = TileShape.of(part);
        if (shape == null || shape.points().isEmpty()) {
          continue;
        }
        double px = part.number("x", 0);
        double py = part.number("y", 0);
        double sx = width / set.tileWidth;
        double sy = height / set.tileHeight;
        shapes.add(
            shape
                .turned(0, 0, part.number("rotation", 0))
                .moved((ax, ay) -> new double[] {px + ax, py + ay}, 1)
                .moved(
                    (ax, ay) -> {
                      double[] p = gid.place(ax, ay, set.tileWidth, set.tileHeight);
                      return new double[] {p[0] * sx, p[1] * sy - height};
                    },
                    Math.min(sx, sy)));
      }
    }

    private void convert() throws LevelException {
      switch (word) {
        case "static", "solid", "sensor", "oneWay", "chain", "loop":
          body("statics");
          break;
        case "body", "dynamic", "kinematic":
          body("bodies");
          break;
        case "spawn":
          spawn();
          break;
        case "zone":
          zone();
          break;
        case "decor":
          break;
        case "text":
          draft.skip(title, "texts have no place in a level");
          break;
        default:
          if (LevelFields.areas().contains(word)) {
            area();
          } else if (LevelFields.joints().contains(word)) {
            joint();
          } else {
            draft.skip(
                title,
                "class \""
                    + word
                    + "\" isn't known; known are static, sensor, oneWay, body, kinematic, spawn,"
                    + " zone, decor, areas "
                    + LevelFields.areas()
                    + " and joints "
                    + LevelFields.joints());
          }
      }
    }

    private Map<String, Object> fields(List<String> known) {
      Map<String, Object> fields = properties.fields(known, "", false, draft);
      List<String> unused = properties.unused(known);
      if (!unused.isEmpty()) {
        draft.skip(title, "properties that a level has no use for: " + String.join(", ", unused));
      }
      return fields;
    }

    private void body(String list) throws LevelException {
      List<String> known = LevelFields.item(list);
      if (shapes.isEmpty() && width > 0 && height > 0) { // a tile without collision shapes
        shapes = List.of(tileBox());
      }
      if (shapes.isEmpty()) {
        draft.skip(title, "it has no area, and a " + word + " needs a shape");
        return;
      }
      Map<String, Object> fields = new LinkedHashMap<>();
      String itemName = name.isEmpty() ? draft.objectNames.getOrDefault(id, "") : name;
      if (!itemName.isEmpty()) {
        fields.put("name", itemName);
      }
      Map<String, Object> custom = fields(known);
      fields.putAll(custom);
      if (word.equals("sensor") || word.equals("oneWay")) {
        fields.put(word, true);
      } else if (word.equals("kinematic")) {
        fields.put("type", "kinematic");
      }
      double[] centre = centre();
      fields.put("at", List.of(scale.x(x + turnX(centre)), scale.y(y + turnY(centre))));
      if (rotation != 0) {
        fields.put("angle", -rotation);
      }
      fields.put("shape", shape(centre));
      draft.add(list, fields, title, custom.keySet());
    }

    /** Returns the box of a tile object, whose place is its lower left corner. */
    private TileShape tileBox() {
      return TileShape.rectangle(width, height)
          .moved((px, py) -> new double[] {px, object.has("gid") ? py - height : py}, 1);
    }

    private Object shape(double[] centre) {
      if (shapes.size() == 1) {
        TileShape shape = shapes.get(0);
        Map<String, Object> json = shape.json(scale, centre[0], centre[1]);
        if (word.equals("loop") && shape.kind() == TileShape.Kind.POLYGON) {
          return loop(shape, centre);
        }
        return json;
      }
      List<Object> parts = new ArrayList<>();
      shapes.forEach(part -> parts.add(part.json(scale, centre[0], centre[1])));
      Map<String, Object> compound = new LinkedHashMap<>();
      compound.put("type", "compound");
      compound.put("parts", parts);
      return compound;
    }

    private Object loop(TileShape shape, double[] centre) {
      Map<String, Object> chain =
          new TileShape(TileShape.Kind.LINE, shape.points()).json(scale, centre[0], centre[1]);
      chain.put("loop", true);
      return chain;
    }

    /** Returns the middle of the shapes, relative to the object and not turned. */
    private double[] centre() {
      double[] all = null;
      for (TileShape shape : shapes) {
        double[] box = shape.box();
        if (all == null) {
          all = box;
        }
        all[0] = Math.min(all[0], box[0]);
        all[1] = Math.min(all[1], box[1]);
        all[2] = Math.max(all[2], box[2]);
        all[3] = Math.max(all[3], box[3]);
      }
      return all == null
          ? new double[2]
          : new double[] {(all[0] + all[2]) / 2, (all[1] + all[3]) / 2};
    }

    private double turnX(double[] p) {
      double angle = Math.toRadians(rotation);
      return p[0] * Math.cos(angle) - p[1] * Math.sin(angle);
    }

    private double turnY(double[] p) {
      double angle = Math.toRadians(rotation);
      return p[0] * Math.sin(angle) + p[1] * Math.cos(angle);
    }

    /** Returns the middle of the object in the level, whatever it is. */
    private List<Double> middle() {
      if (shapes.isEmpty() && width > 0 && height > 0) {
        shapes = List.of(tileBox());
      }
      double[] centre = centre();
      return List.of(scale.x(x + turnX(centre)), scale.y(y + turnY(centre)));
    }

    private void spawn() {
      Map<String, Object> custom = fields(LevelFields.item("spawns"));
      Map<String, Object> fields = new LinkedHashMap<>();
      if (!name.isEmpty()) {
        fields.put("name", name);
      }
      fields.putAll(custom);
      fields.put("at", middle());
      draft.add("spawns", fields, title, custom.keySet());
    }

    private void zone() {
      Map<String, Object> custom = fields(LevelFields.item("zones"));
      Map<String, Object> fields = new LinkedHashMap<>();
      fields.put("name", name.isEmpty() ? "zone" : name);
      fields.putAll(custom);
      if (corners(fields)) {
        draft.add("zones", fields, title, custom.keySet());
      }
    }

    private void area() {
      Map<String, Object> custom = fields(LevelFields.area(word));
      Map<String, Object> fields = new LinkedHashMap<>();
      fields.put("type", word);
      if (!name.isEmpty()) {
        fields.put("name", name);
      }
      fields.putAll(custom);
      if (word.equals("attractor")) {
        List<Double> at = middle();
        fields.put("at", at);
        if (width > 0) {
          fields.putIfAbsent("range", scale.length(width / 2));
        }
        draft.add("areas", fields, title, custom.keySet());
      } else if (corners(fields)) {
        draft.add("areas", fields, title, custom.keySet());
      }
    }

    /** Puts the corners of the object's box into an item; false if it has no area. */
    private boolean corners(Map<String, Object> fields) {
      if (shapes.isEmpty()) {
        draft.skip(title, "it has no area, and a " + word + " needs a rectangle");
        return false;
      }
      double[] box = shapes.get(0).turned(0, 0, rotation).box();
      fields.put("min", List.of(scale.x(x + box[0]), scale.y(y + box[3])));
      fields.put("max", List.of(scale.x(x + box[2]), scale.y(y + box[1])));
      if (rotation % 90 != 0) {
        draft.skip(title, "its rotation; a " + word + " is upright");
      }
      return true;
    }

    private void joint() {
      List<String> known = LevelFields.joint(word);
      Map<String, Object> custom = fields(known);
      Map<String, Object> fields = new LinkedHashMap<>();
      fields.put("type", word);
      if (!name.isEmpty()) {
        fields.put("name", name);
      }
      fields.putAll(custom);
      boolean isLine = shapes.size() == 1 && shapes.get(0).kind() == TileShape.Kind.LINE;
      if (isLine && known.contains("from")) {
        TileShape line = shapes.get(0).turned(0, 0, rotation);
        List<double[]> points = line.points();
        fields.put("from", place(points.get(0)));
        fields.put("to", place(points.get(points.size() - 1)));
      }
      if (known.contains("at")) {
        fields.putIfAbsent("at", isLine ? place(shapes.get(0).points().get(0)) : middle());
      }
      draft.add("joints", fields, title, custom.keySet());
    }

    private List<Double> place(double[] p) {
      return List.of(scale.x(x + p[0]), scale.y(y + p[1]));
    }
  }
}
