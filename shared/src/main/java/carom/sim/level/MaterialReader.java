package carom.sim.level;

import static carom.text.JsonFields.color;
import static carom.text.JsonFields.knownFields;
import static carom.text.JsonFields.number;
import static carom.text.JsonFields.require;
import static carom.text.JsonFields.unknownWord;
import static carom.text.JsonFields.word;

import carom.physics.Material;
import carom.physics.settings.MixingRule;
import carom.text.Json;
import carom.text.JsonException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Reads the materials of a level file, and finds those that have names. */
final class MaterialReader {
  /** The fields of a material, in the order of {@code level.schema.json}. */
  public static final List<String> FIELDS =
      List.of(
          "density",
          "friction",
          "restitution",
          "surfaceSpeed",
          "frictionMixing",
          "restitutionMixing",
          "color");

  private static final List<String> MIXING =
      List.of("average", "geometricMean", "min", "multiply", "max");
  private static final Material DEFAULT = new Material(1, 0.5f, 0);
  private static final Surface PLAIN = new Surface(DEFAULT, -1);

  private final Map<String, Surface> named = new LinkedHashMap<>();

  /**
   * A material with the colour of what is made of it.
   *
   * @param material of the physics
   * @param rgb 0xRRGGBB, or -1 for none
   */
  record Surface(Material material, int rgb) {}

  /**
   * Reads the materials that have names.
   *
   * @param node an object of materials by name, or null for none
   * @throws JsonException naming the place, the value and the limit
   */
  public void readNamed(Json node) throws JsonException {
    if (node == null) {
      return;
    }
    require(node, Json.Kind.OBJECT);
    for (Map.Entry<String, Json> entry : node.fields.entrySet()) {
      named.put(entry.getKey(), read(entry.getValue()));
    }
  }

  /**
   * Returns the material that a node names or describes, with its colour.
   *
   * @param node a name, an object with a material's fields, or null for the default
   * @throws JsonException naming the place, the value and the limit
   */
  Surface surface(Json node) throws JsonException {
    if (node == null) {
      return PLAIN;
    }
    if (node.kind != Json.Kind.STRING) {
      return read(node);
    }
    Surface surface = named.get(node.text);
    if (surface == null) {
      throw unknownWord(node, named.keySet(), "a name under \"materials\"");
    }
    return surface;
  }

  private static Surface read(Json node) throws JsonException {
    knownFields(node, FIELDS);
    Material material =
        new Material(
            number(node, "density", DEFAULT.density(), 0.001f, 1000),
            number(node, "friction", DEFAULT.friction(), 0, 10),
            number(node, "restitution", DEFAULT.restitution(), 0, 2),
            0,
            number(node, "surfaceSpeed", 0, -1000, 1000),
            0,
            mixing(node, "frictionMixing"),
            mixing(node, "restitutionMixing"));
    return new Surface(material, color(node, "color", -1));
  }

  private static MixingRule mixing(Json node, String field) throws JsonException {
    return node.fields.containsKey(field)
        ? MixingRule.values()[MIXING.indexOf(word(node, field, MIXING, ""))]
        : null;
  }
}
