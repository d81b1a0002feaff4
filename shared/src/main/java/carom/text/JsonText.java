package carom.text;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** Writes JSON values as people do: on one line, with a space behind commas and colons. */
public final class JsonText {
  private static final int DECIMALS = 5;

  private JsonText() {}

  /**
   * Returns a value on one line. Numbers have at most five decimals.
   *
   * @param value a map, list, text, number or truth
   */
  public static String of(Object value) {
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
