package carom.sim.level.shape;

import static carom.json.JsonFields.bool;
import static carom.json.JsonFields.knownFields;
import static carom.json.JsonFields.list;
import static carom.json.JsonFields.number;
import static carom.json.JsonFields.require;
import static carom.json.JsonFields.required;
import static carom.json.JsonFields.vector;
import static carom.json.JsonFields.word;
import static carom.json.JsonFields.wrong;

import carom.json.Json;
import carom.json.JsonException;
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
import java.util.ArrayList;
import java.util.List;

/** Reads the shapes of a level file. */
public final class ShapeReader {
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
  private static final int MAX_CHAIN_POINTS = 256;

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
   * Reads the shape of a body with its material, or the pieces of a chain with several.
   *
   * @param node the shape; may be a line or a compound
   * @param material the body's, or null if it has none
   * @param materials finds materials by name
   * @return in the body's frame; the pieces of a chain in the order of its points
   * @throws JsonException naming the place, the value and the limit
   */
  public static List<ShapeDef> shapes(Json node, Json material, MaterialReader materials)
      throws JsonException {
    Shape shape = shape(node, true);
    if (!node.fields.containsKey("materials")) {
      return List.of(new ShapeDef(shape, materials.material(material)));
    }
    if (material != null) {
      throw wrong(material, " has no effect beside \"materials\" of the chain; remove one of them");
    }
    return pieces(node, shape.parts().size(), materials);
  }

  /** Returns the pieces of a chain with a material for each line. */
  private static List<ShapeDef> pieces(Json node, int lines, MaterialReader materials)
      throws JsonException {
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
    float[] xy = coordinates(node.fields.get("points").items);
    ChainDef chain = bool(node, "loop", false) ? ChainDef.loop(xy) : ChainDef.open(xy);
    for (int i = 0; i < lines; i++) {
      chain.material(i, materials.material(names.get(i)));
    }
    return chain.shapes();
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
        case "chain" -> chain(node);
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

  private static Chain chain(Json node) throws JsonException {
    required(node, "points");
    float[] xy = coordinates(list(node, "points", MAX_CHAIN_POINTS));
    return bool(node, "loop", false) ? Chain.loop(xy) : Chain.open(xy);
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
