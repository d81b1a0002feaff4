package carom.tiled;

import carom.sim.level.LevelException;
import carom.sim.level.LevelFields;
import carom.text.Json;
import carom.text.JsonException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Custom properties as values of level files: a text that begins with a bracket is JSON, a colour
 * loses its alpha, an object is a name.
 */
final class Properties {
  private static final int MAX = 1_000;

  final Map<String, Object> values = new LinkedHashMap<>();

  Properties() {}

  /**
   * Reads the properties of a layer, object, tile or map; they take the place of those that are
   * here already.
   *
   * @param origin names it
   * @param draft hears what can't be read
   * @return this
   */
  Properties read(TiledNode of, String origin, LevelDraft draft) throws LevelException {
    List<TiledNode> nodes = of.nodes("properties");
    if (nodes.size() > MAX) {
      throw of.wrong(origin + " has " + nodes.size() + " properties, the limit is " + MAX);
    }
    for (TiledNode property : nodes) {
      String name = property.text("name", "");
      try {
        Object value = value(property, draft);
        if (value == null) {
          draft.skip(origin, "property " + name + " has parts, which aren't read");
        } else {
          values.put(name, value);
        }
      } catch (JsonException e) {
        draft.skip(origin, "property " + name + " isn't JSON: " + e.getMessage());
      }
    }
    return this;
  }

  private static Object value(TiledNode property, LevelDraft draft)
      throws LevelException, JsonException {
    Object value = property.fields.get("value");
    switch (property.text("type", "string")) {
      case "int", "float":
        return property.number("value", 0);
      case "bool":
        return property.flag("value");
      case "color":
        String text = property.text("value", "");
        return text.length() == 9 ? "#" + text.substring(3) : text;
      case "object":
        int id = property.whole("value", 0, 0, Integer.MAX_VALUE);
        return draft.objectNames.getOrDefault(id, "");
      case "class":
        return null;
      default:
        String said = value == null ? "" : property.text("value", "");
        boolean isJson = said.startsWith("[") || said.startsWith("{");
        return isJson ? tree(Json.parse(said.getBytes(StandardCharsets.UTF_8))) : said;
    }
  }

  private static Object tree(Json json) {
    switch (json.kind) {
      case OBJECT:
        Map<String, Object> fields = new LinkedHashMap<>();
        json.fields.forEach((name, field) -> fields.put(name, tree(field)));
        return fields;
      case ARRAY:
        List<Object> items = new ArrayList<>();
        json.items.forEach(item -> items.add(tree(item)));
        return items;
      case NUMBER:
        return json.number;
      case BOOLEAN:
        return json.truth;
      default:
        return json.text;
    }
  }

  /** Returns a text, empty if it is missing. */
  String text(String name) {
    Object value = values.get(name);
    return value instanceof String text ? text : "";
  }

  /** Returns whether a property is there and true. */
  boolean flag(String name) {
    return Boolean.TRUE.equals(values.get(name));
  }

  /**
   * Returns those that are fields of an item. What makes a material becomes one, unless the item
   * names its material.
   *
   * @param known fields of the item
   * @param materialName for a material that has no name
   * @param withColour whether the colour is the material's, so that lines of a chain can differ
   */
  Map<String, Object> fields(
      List<String> known, String materialName, boolean withColour, LevelDraft draft) {
    Map<String, Object> fields = new LinkedHashMap<>();
    values.forEach(
        (name, value) -> {
          if (known.contains(name)) {
            fields.put(name, value);
          }
        });
    if (known.contains("material") && !fields.containsKey("material")) {
      Map<String, Object> material = new LinkedHashMap<>();
      for (String field : LevelFields.material()) {
        if (values.containsKey(field) && (withColour || !field.equals("color"))) {
          material.put(field, values.get(field));
        }
      }
      if (withColour) {
        fields.remove("color");
      }
      if (!material.isEmpty()) {
        fields.put("material", draft.material(materialName, material));
      }
    }
    return fields;
  }

  /** Returns the names of those that neither an item nor its making uses. */
  List<String> unused(List<String> known) {
    List<String> unused = new ArrayList<>();
    for (String name : values.keySet()) {
      boolean isMaterial = known.contains("material") && LevelFields.material().contains(name);
      if (!known.contains(name) && !isMaterial) {
        unused.add(name);
      }
    }
    return unused;
  }
}
