package carom.tiled;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** Writes level files: an item on each line, in a stable order, so that differences are small. */
final class LevelText {
  private static final int DECIMALS = 5;

  private LevelText() {}

  /** Returns the text of a level; values are maps, lists, texts, numbers and truths. */
  static String of(Map<String, Object> root) {
    StringBuilder out = new StringBuilder("{\n");
    String separator = "  ";
    for (Map.Entry<String, Object> field : root.entrySet()) {
      out.append(separator).append(quoted(field.getKey())).append(": ");
      separator = ",\n  ";
      if (field.getValue() instanceof List<?> items
          && !items.isEmpty()
          && items.get(0) instanceof Map) {
        String line = "[\n    ";
        for (Object item : items) {
          write(out.append(line), item);
          line = ",\n    ";
        }
        out.append("\n  ]");
      } else {
        write(out, field.getValue());
      }
    }
    return out.append("\n}\n").toString();
  }

  /** Returns a value on one line. */
  static String line(Object value) {
    StringBuilder out = new StringBuilder();
    write(out, value);
    return out.toString();
  }

  private static void write(StringBuilder out, Object value) {
    if (value instanceof Map<?, ?> fields) {
      String separator = "{ ";
      for (Map.Entry<?, ?> field : fields.entrySet()) {
        out.append(separator).append(quoted(String.valueOf(field.getKey()))).append(": ");
        write(out, field.getValue());
        separator = ", ";
      }
      out.append(fields.isEmpty() ? "{}" : " }");
    } else if (value instanceof List<?> items) {
      String separator = "[";
      for (Object item : items) {
        write(out.append(separator), item);
        separator = ", ";
      }
      out.append(items.isEmpty() ? "[]" : "]");
    } else if (value instanceof Number number) {
      out.append(plain(number.doubleValue()));
    } else if (value instanceof Boolean truth) {
      out.append(truth);
    } else {
      out.append(quoted(String.valueOf(value)));
    }
  }

  private static String plain(double value) {
    BigDecimal rounded = BigDecimal.valueOf(value).setScale(DECIMALS, RoundingMode.HALF_EVEN);
    return rounded.signum() == 0 ? "0" : rounded.stripTrailingZeros().toPlainString();
  }

  private static String quoted(String text) {
    StringBuilder out = new StringBuilder("\"");
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      if (c == '"' || c == '\\') {
        out.append('\\').append(c);
      } else if (c < ' ') {
        out.append(String.format(Locale.ROOT, "\\u%04x", (int) c));
      } else {
        out.append(c);
      }
    }
    return out.append('"').toString();
  }
}
