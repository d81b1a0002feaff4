package carom.tiled;

import carom.text.JsonText;
import java.util.List;
import java.util.Map;

/** Writes level files: an item on each line, in a stable order, so that differences are small. */
final class LevelText {
  private LevelText() {}

  /** Returns the text of a level; values are maps, lists, texts, numbers and truths. */
  static String of(Map<String, Object> root) {
    StringBuilder out = new StringBuilder("{\n");
    String separator = "  ";
    for (Map.Entry<String, Object> field : root.entrySet()) {
      out.append(separator).append(JsonText.of(field.getKey())).append(": ");
      separator = ",\n  ";
      if (field.getValue() instanceof List<?> items
          && !items.isEmpty()
          && items.get(0) instanceof Map) {
        String line = "[\n    ";
        for (Object item : items) {
          out.append(line).append(JsonText.of(item));
          line = ",\n    ";
        }
        out.append("\n  ]");
      } else {
        out.append(JsonText.of(field.getValue()));
      }
    }
    return out.append("\n}\n").toString();
  }
}
