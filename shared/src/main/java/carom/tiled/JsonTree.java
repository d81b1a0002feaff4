package carom.tiled;

import carom.sim.level.LevelException;
import carom.text.Json;
import carom.text.JsonException;
import java.util.ArrayList;
import java.util.List;

/** Reads Tiled's JSON. Stateless. */
final class JsonTree {
  private JsonTree() {}

  static TiledNode read(String file, byte[] bytes) throws LevelException {
    try {
      Json root = Json.parseMachineMade(bytes, bytes.length);
      if (root.kind != Json.Kind.OBJECT) {
        throw new LevelException(file, 1, 1, "", "the file holds " + root.kind.words);
      }
      return (TiledNode) value(file, root);
    } catch (JsonException e) {
      throw new LevelException(file, e.line(), e.column(), e.path(), e.getMessage());
    }
  }

  private static Object value(String file, Json json) {
    switch (json.kind) {
      case OBJECT:
        TiledNode node = new TiledNode(file);
        json.fields.forEach(
            (name, field) -> {
              if (field.kind != Json.Kind.NULL) {
                node.fields.put(name, value(file, field));
              }
            });
        return node;
      case ARRAY:
        List<Object> items = new ArrayList<>(json.items.size());
        json.items.forEach(item -> items.add(value(file, item)));
        return items;
      case NUMBER:
        return json.number;
      case BOOLEAN:
        return json.truth;
      default:
        return json.text;
    }
  }
}
