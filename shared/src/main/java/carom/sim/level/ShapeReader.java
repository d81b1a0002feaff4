package carom.sim.level;

import static carom.text.JsonFields.bool;
import static carom.text.JsonFields.knownFields;
import static carom.text.JsonFields.list;
import static carom.text.JsonFields.number;
import static carom.text.JsonFields.require;
import static carom.text.JsonFields.required;
import static carom.text.JsonFields.vector;
import static carom.text.JsonFields.word;
import static carom.text.JsonFields.wrong;

import carom.physics.ChainDef;
import carom.physics.ShapeDef;
import carom.physics.geometry.Box;
import carom.physics.geometry.Capsule;
import carom.physics.geometry.Chain;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Compound;
import carom.physics.geometry.Convex;
import carom.physics.geometry.Segment;
import carom.physics.geometry.Shape;
import carom.text.Json;
import carom.text.JsonException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/** Reads the shapes of a level file. */
final class ShapeReader {
  /** Smallest length of a part of a level, metres. */
  public static final float MIN_SIZE = 0.05f;

  /** Largest length of a part of a level, and its farthest point in a body's frame, metres. */
  public static final float MAX_SIZE = 2_000;

  /** The types of shapes that have no mass. */
  public static final List<String> LINES = List.of("segment", "chain");

  /** The types of shapes. */
  public static final List<String> TYPES =
      List.of("circle", "box", "polygon", "capsule", "segment", "chain", "compound");

  private static final int MAX_PARTS = 32;
  private static final int MAX_POINTS = 64;
  private static final int MAX_CHAIN_POINTS = 65_536;

  private ShapeReader() {}

  /**
   * Returns the fields that a shape may have.
   *
   * @param type one of {@link #TYPES}
   * @return in the order of {@code level.schema.json}
   */
  public static List<String> fields(String type) {
    return switch (type) {
      case "circle" -> List.of("type", "radius", "at");
      case "box" -> List.of("type", "width", "height", "at");
      case "polygon" -> List.of("type", "points");
      case "capsule" -> List.of("type", "from", "to", "radius");
      case "segment" -> List.of("type", "from", "to");
      case "chain" -> List.of("type", "points", "loop", "materials");
      default -> List.of("type", "parts");
    };
  }

  /**
   * The shapes and the colour of one body of an item.
   *
   * @param shapes in the body's frame
   * @param rgb the colour of their material, 0xRRGGBB, or -1 for none
   */
  public record BodyShapes(List<ShapeDef> shapes, int rgb) {
    /** Returns the number of convex parts. */
    public int parts() {
      int parts = 0;
      for (ShapeDef shape : shapes) {
        parts += shape.shape().parts().size();
      }
      return parts;
    }
  }

  /**
   * Reads the shape of an item with its material. It needs one body; a chain needs one for each
   * colour of its materials, and for every {@value ChainDef#MAX_BODY_PARTS} lines.
   *
   * @param node the shape; may be a line or a compound
   * @param material the item's, or null if it has none
   * @param materials finds materials by name
   * @return one or more bodies at the same place
   * @throws JsonException naming the place, the value and the limit
   */
  public static List<BodyShapes> bodies(Json node, Json material, MaterialReader materials)
      throws JsonException {
    if (node.kind == Json.Kind.OBJECT && isChain(node.fields.get("type"))) {
      return chain(node, material, materials);
    }
    Shape shape = shape(node, true);
    MaterialReader.Surface surface = materials.surface(material);
    return List.of(new BodyShapes(List.of(new ShapeDef(shape, surface.material())), surface.rgb()));
  }

  private static boolean isChain(Json type) {
    return type != null && "chain".equals(type.text);
  }

  private static List<BodyShapes> chain(Json node, Json material, MaterialReader materials)
      throws JsonException {
    knownFields(node, fields("chain"));
    required(node, "points");
    float[] xy = coordinates(list(node, "points", MAX_CHAIN_POINTS));
    boolean loop = bool(node, "loop", false);
    MaterialReader.Surface[] surfaces = surfaces(node, xy.length / 2, loop, material, materials);
    int[] cuts = new int[surfaces.length];
    int count = 0;
    int from = 0;
    for (int i = 1; i < surfaces.length; i++) {
      if (!surfaces[i].equals(surfaces[i - 1]) || i - from == Chain.MAX_SEGMENTS) {
        cuts[count++] = i;
        from = i;
      }
    }
    try {
      if (count == 0) {
        Chain chain = loop ? Chain.loop(xy) : Chain.open(xy);
        return grouped(List.of(chain), surfaces);
      }
      return grouped(Chain.pieces(xy, loop, Arrays.copyOf(cuts, count)), surfaces);
    } catch (IllegalArgumentException e) {
      throw wrong(node, ": " + e.getMessage());
    }
  }

  /** Returns the material of each line of a chain. */
  private static MaterialReader.Surface[] surfaces(
      Json node, int points, boolean loop, Json material, MaterialReader materials)
      throws JsonException {
    int lines = Math.max(1, loop ? points : points - 1);
    MaterialReader.Surface[] surfaces = new MaterialReader.Surface[lines];
    if (!node.fields.containsKey("materials")) {
      Arrays.fill(surfaces, materials.surface(material));
      return surfaces;
    }
    if (material != null) {
      throw wrong(material, " has no effect beside \"materials\" of the chain; remove one of them");
    }
    List<Json> names = list(node, "materials", MAX_CHAIN_POINTS);
    if (names.size() != lines) {
      throw wrong(
          node.fields.get("materials"),
          " has "
              + names.size()
              + " entries, must have "
              + lines
              + ": one material for each line from a point to the next");
    }
    for (int i = 0; i < lines; i++) {
      surfaces[i] = materials.surface(names.get(i));
    }
    return surfaces;
  }

  /**
   * Returns bodies of the pieces of a chain: pieces of one colour share them while there is room.
   */
  private static List<BodyShapes> grouped(List<Chain> pieces, MaterialReader.Surface[] surfaces) {
    List<BodyShapes> bodies = new ArrayList<>();
    Map<Integer, BodyShapes> open = new TreeMap<>();
    Map<Integer, Integer> parts = new TreeMap<>();
    int line = 0;
    for (Chain piece : pieces) {
      MaterialReader.Surface surface = surfaces[line];
      int more = piece.parts().size();
      line += more;
      int sum = parts.merge(surface.rgb(), more, Integer::sum);
      if (sum == more || sum > ChainDef.MAX_BODY_PARTS) {
        BodyShapes body = new BodyShapes(new ArrayList<>(), surface.rgb());
        bodies.add(body);
        open.put(surface.rgb(), body);
        parts.put(surface.rgb(), more);
      }
      open.get(surface.rgb()).shapes().add(new ShapeDef(piece, surface.material()));
    }
    return bodies;
  }

  private static Shape shape(Json node, boolean compoundAllowed) throws JsonException {
    require(node, Json.Kind.OBJECT);
    required(node, "type");
    String type = word(node, "type", TYPES, "");
    if (type.equals("compound") && !compoundAllowed) {
      throw wrong(node.fields.get("type"), "=\"compound\" can't be part of a compound");
    }
    if (LINES.contains(type) && !compoundAllowed) {
      throw wrong(
          node.fields.get("type"),
          "=\"" + type + "\" is a line and can't be part of a compound; give it a body of its own");
    }
    knownFields(node, fields(type));
    try {
      return switch (type) {
        case "circle" -> circle(node);
        case "box" -> boxShape(node);
        case "polygon" -> polygon(node);
        case "capsule" -> capsule(node);
        case "segment" -> segment(node);
        default -> compound(node);
      };
    } catch (IllegalArgumentException e) {
      throw wrong(node, ": " + e.getMessage());
    }
  }

  private static Circle circle(Json node) throws JsonException {
    float[] at = offset(node);
    return new Circle(size(node, "radius"), at[0], at[1]);
  }

  private static Box boxShape(Json node) throws JsonException {
    float[] at = offset(node);
    return new Box(size(node, "width") / 2, size(node, "height") / 2, at[0], at[1]);
  }

  /** Returns a polygon, or the convex parts of a concave one. */
  private static Shape polygon(Json node) throws JsonException {
    required(node, "points");
    List<Json> points = list(node, "points", MAX_POINTS);
    if (points.size() < 3) {
      throw wrong(node.fields.get("points"), " has " + points.size() + " points, needs 3 at least");
    }
    List<Convex> parts = Compound.ofOutline(coordinates(points)).parts();
    return parts.size() == 1 ? parts.get(0) : compound(node.fields.get("points"), parts);
  }

  private static float[] coordinates(List<Json> points) throws JsonException {
    float[] xy = new float[2 * points.size()];
    for (int i = 0; i < points.size(); i++) {
      float[] point = vector(points.get(i), MAX_SIZE);
      xy[2 * i] = point[0];
      xy[2 * i + 1] = point[1];
    }
    return xy;
  }

  private static Capsule capsule(Json node) throws JsonException {
    float[] from = vector(required(node, "from"), MAX_SIZE);
    float[] to = vector(required(node, "to"), MAX_SIZE);
    return new Capsule(from[0], from[1], to[0], to[1], size(node, "radius"));
  }

  private static Segment segment(Json node) throws JsonException {
    float[] from = vector(required(node, "from"), MAX_SIZE);
    float[] to = vector(required(node, "to"), MAX_SIZE);
    return new Segment(from[0], from[1], to[0], to[1]);
  }

  private static Compound compound(Json node) throws JsonException {
    required(node, "parts");
    List<Json> parts = list(node, "parts", MAX_PARTS);
    if (parts.isEmpty()) {
      throw wrong(node.fields.get("parts"), " has no part, needs 1 at least");
    }
    List<Convex> convex = new ArrayList<>();
    for (Json part : parts) {
      convex.addAll(shape(part, false).parts());
    }
    return compound(node.fields.get("parts"), convex);
  }

  private static Compound compound(Json place, List<Convex> parts) throws JsonException {
    if (parts.size() > MAX_PARTS) {
      throw wrong(
          place, " needs " + parts.size() + " convex parts, more than " + MAX_PARTS + "; split it");
    }
    return Compound.of(parts);
  }

  private static float size(Json node, String field) throws JsonException {
    required(node, field);
    return number(node, field, 1, MIN_SIZE, MAX_SIZE);
  }

  private static float[] offset(Json node) throws JsonException {
    Json at = node.fields.get("at");
    return at == null ? new float[2] : vector(at, MAX_SIZE);
  }
}
