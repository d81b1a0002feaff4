package carom.tiled;

import carom.sim.level.Level;
import carom.sim.level.LevelException;
import carom.sim.level.LevelFields;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;

/**
 * Makes levels of maps of the editor Tiled. {@code docs/games/TILED.md} says what becomes of what.
 * Stateless; any thread.
 */
public final class TiledImport {
  private static final int MAX_LAYERS = 256;
  private static final int MAX_OBJECTS = 16_384;
  private static final int MAX_DEPTH = 16;

  /** A layer that isn't a group, with the offsets of the groups around it. */
  private record Layer(TiledNode node, String title, double offsetX, double offsetY) {}

  private final TiledFile file;
  private final LevelDraft draft = new LevelDraft();
  private final List<Layer> layers = new ArrayList<>();
  private int cells;
  private int objects;

  private TiledImport(TiledFile file) {
    this.file = file;
  }

  /** Returns whether a file is a map by its name. */
  public static boolean isMap(Path file) {
    String name = file.toString().toLowerCase(Locale.ROOT);
    return name.endsWith(".tmx") || name.endsWith(".tmj");
  }

  /**
   * Reads a level file, or a map as a level.
   *
   * @throws LevelException when it can't be read or used
   */
  public static Level load(Path file) throws LevelException {
    return isMap(file) ? read(file, TiledOptions.NONE).level() : Level.load(file);
  }

  /**
   * Reads a map as a level.
   *
   * @param map XML or JSON of Tiled; its tilesets may be files beside it
   * @throws LevelException when it can't be read, or makes no level
   */
  public static TiledLevel read(Path map, TiledOptions options) throws LevelException {
    TiledFile file = new TiledFile(map);
    return new TiledImport(file).level(options);
  }

  private TiledLevel level(TiledOptions options) throws LevelException {
    collect(file.map, "", 0, 0, 1);
    Properties properties = new Properties().read(file.map, "map", draft);
    int tileWidth = file.map.whole("tilewidth", 0, 1, 4096);
    int tileHeight = file.map.whole("tileheight", 0, 1, 4096);
    double pixels = options.pixelsPerMetre();
    if (pixels == 0) {
      pixels = properties.values.get("pixelsPerMetre") instanceof Double d ? d : tileWidth;
    }
    if (!(pixels >= 1 && pixels <= 10_000)) {
      throw file.map.wrong("pixelsPerMetre=" + pixels + " must be in 1..10000");
    }
    double width = (double) tileWidth * file.map.whole("width", 0, 0, 1 << 20);
    double height = (double) tileHeight * file.map.whole("height", 0, 0, 1 << 20);
    boolean isInfinite = file.map.flag("infinite");
    MapScale scale = new MapScale(pixels, isInfinite ? 0 : height);
    head(properties, options);
    double[] box = convert(scale);
    if (!isInfinite) {
      box = new double[] {0, 0, width, height};
    }
    if (!draft.root.containsKey("bounds")) {
      Map<String, Object> bounds = new LinkedHashMap<>();
      bounds.put("min", List.of(scale.x(box[0]), scale.y(box[3])));
      bounds.put("max", List.of(scale.x(box[2]), scale.y(box[1])));
      draft.root.put("bounds", bounds);
    }
    return draft.level(file.name);
  }

  /** Finds the layers in groups. */
  private void collect(TiledNode group, String title, double offsetX, double offsetY, int depth)
      throws LevelException {
    if (depth > MAX_DEPTH) {
      throw file.map.wrong("groups of layers are nested more than " + MAX_DEPTH + " deep");
    }
    for (TiledNode layer : group.nodes("layers")) {
      String name = layer.text("name", "");
      String full =
          title
              + (title.isEmpty() ? "layer " : " / ")
              + (name.isEmpty() ? layer.text("id", "?") : "\"" + name + "\"");
      double x = offsetX + layer.number("offsetx", 0);
      double y = offsetY + layer.number("offsety", 0);
      if (layer.text("type", "").equals("group")) {
        collect(layer, full, x, y, depth + 1);
      } else {
        layers.add(new Layer(layer, full, x, y));
      }
    }
    if (layers.size() > MAX_LAYERS) {
      throw file.map.wrong("has more than " + MAX_LAYERS + " layers");
    }
  }

  /** Puts into the level what the map's properties say about it as a whole. */
  private void head(Properties properties, TiledOptions options) {
    Map<String, Object> root = draft.root;
    root.put("version", Level.VERSION);
    String ownName = file.name.replaceFirst("\\.[^.]*$", "");
    String name = options.name().isEmpty() ? properties.text("name") : options.name();
    root.put("name", name.isEmpty() ? ownName : name);
    String game = options.game().isEmpty() ? properties.text("game") : options.game();
    root.put("game", game.isEmpty() ? "platformer" : game);
    root.put("gravity", List.of(0, -20));
    String background = file.map.text("backgroundcolor", "");
    if (background.length() == 9 || background.length() == 7) {
      String rgb = "#" + background.substring(background.length() - 6);
      root.put("theme", Map.of("background", rgb));
    }
    List<String> unused = new ArrayList<>();
    properties.values.forEach(
        (field, value) -> {
          boolean isTaken =
              List.of("$schema", "version", "name", "game", "pixelsPerMetre").contains(field);
          if (draft.isList(field) && value instanceof List<?> items) {
            list(field, items);
          } else if (field.equals("materials") && value instanceof Map<?, ?> materials) {
            materials.forEach((key, material) -> draft.materials.put(key.toString(), material));
          } else if (!isTaken && LevelFields.root().contains(field)) {
            root.put(field, value);
          } else if (!isTaken) {
            unused.add(field);
          }
        });
    if (!unused.isEmpty()) {
      draft.skip("map", "properties that a level has no use for: " + String.join(", ", unused));
    }
  }

  private void list(String field, List<?> items) {
    for (int i = 0; i < items.size(); i++) {
      String origin = "map, property " + field + "[" + i + "]";
      if (items.get(i) instanceof Map<?, ?> item) {
        Map<String, Object> fields = new LinkedHashMap<>();
        item.forEach((key, value) -> fields.put(key.toString(), value));
        draft.add(field, fields, origin, List.of());
      } else {
        draft.skip(origin, "must be an object");
      }
    }
  }

  /** Converts the layers and returns the box of all that is in them, pixels. */
  private double[] convert(MapScale scale) throws LevelException {
    boolean isMarked = isMarked();
    nameObjects();
    double[] box = {0, 0, 1, 1};
    boolean isEmpty = true;
    for (Layer layer : layers) {
      TiledNode node = layer.node;
      double[] own = null;
      switch (node.text("type", "")) {
        case "tilelayer":
          own = tiles(layer, isMarked, scale);
          break;
        case "objectgroup":
          own = objects(layer, scale);
          break;
        case "imagelayer":
          draft.skip(layer.title, "pictures have no place in a level");
          break;
        default:
          draft.skip(layer.title, "type \"" + node.text("type", "") + "\" of layers isn't known");
      }
      if (own != null) {
        box = isEmpty ? own : union(box, own);
        isEmpty = false;
      }
    }
    return box;
  }

  private static double[] union(double[] a, double[] b) {
    return new double[] {
      Math.min(a[0], b[0]), Math.min(a[1], b[1]), Math.max(a[2], b[2]), Math.max(a[3], b[3])
    };
  }

  private double[] tiles(Layer layer, boolean isMarked, MapScale scale) throws LevelException {
    TiledNode node = layer.node;
    boolean slides = node.number("parallaxx", 1) != 1 || node.number("parallaxy", 1) != 1;
    if (slides) {
      draft.skip(layer.title, "it moves by parallax, so nothing in it is solid");
    }
    if (slides || node.text("class", "").equals("decor")) {
      return null;
    }
    TileLayer tiles;
    try {
      tiles = TileLayer.of(node);
      cells += tiles.width * tiles.height;
      if (cells > TileLayer.MAX_CELLS) {
        throw node.wrong("has more than " + TileLayer.MAX_CELLS + " cells in all layers");
      }
      new TileSolids(
              file, draft, layer.title, node, tiles, isMarked, scale, layer.offsetX, layer.offsetY)
          .convert();
    } catch (LevelException e) {
      throw new LevelException(
          e.file(),
          e.line(),
          e.column(),
          layer.title,
          " " + e.getMessage().substring(e.file().length() + 2));
    }
    double w = file.map.whole("tilewidth", 0, 1, 4096);
    double h = file.map.whole("tileheight", 0, 1, 4096);
    double x = tiles.column * w + layer.offsetX;
    double y = tiles.row * h + layer.offsetY;
    return tiles.width * tiles.height == 0
        ? null
        : new double[] {x, y, x + tiles.width * w, y + tiles.height * h};
  }

  private double[] objects(Layer layer, MapScale scale) throws LevelException {
    List<TiledNode> all = layer.node.nodes("objects");
    objects += all.size();
    if (objects > MAX_OBJECTS) {
      throw file.map.wrong("has more than " + MAX_OBJECTS + " objects");
    }
    new TiledObjects(file, draft, layer.node, layer.title, scale, layer.offsetX, layer.offsetY)
        .convert();
    double[] box = null;
    for (TiledNode object : all) {
      double x = object.number("x", 0) + layer.offsetX;
      double y = object.number("y", 0) + layer.offsetY;
      double[] own = {x, y, x + object.number("width", 0), y + object.number("height", 0)};
      box = box == null ? own : union(box, own);
    }
    return box != null && box[0] < box[2] && box[1] < box[3] ? box : null;
  }

  /** Returns whether the map says anywhere which of its tiles are solid. */
  private boolean isMarked() {
    for (Layer layer : layers) {
      boolean isTiles = layer.node.text("type", "").equals("tilelayer");
      if (isTiles && TileSolids.isWord(layer.node.text("class", ""))) {
        return true;
      }
    }
    for (Tileset set : file.tilesets()) {
      for (TiledNode tile : set.tiles()) {
        if (tile.has("objectgroup")
            || TileSolids.isSolidWord(tile.text("type", tile.text("class", "")))) {
          return true;
        }
      }
    }
    return false;
  }

  /** Gives names to the objects that properties of others name. */
  private void nameObjects() throws LevelException {
    Set<Integer> wanted = new TreeSet<>();
    for (Layer layer : layers) {
      for (TiledNode object : layer.node.nodes("objects")) {
        for (TiledNode property : object.nodes("properties")) {
          if (property.text("type", "").equals("object")) {
            wanted.add(property.whole("value", 0, 0, Integer.MAX_VALUE));
          }
        }
      }
    }
    for (Layer layer : layers) {
      for (TiledNode object : layer.node.nodes("objects")) {
        int id = object.whole("id", 0, 0, Integer.MAX_VALUE);
        String name = object.text("name", "");
        if (wanted.contains(id)) {
          draft.objectNames.put(id, name.isEmpty() ? "object-" + id : name);
        }
      }
    }
  }
}
