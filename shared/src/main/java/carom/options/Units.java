package carom.options;

import java.math.BigDecimal;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Units behind the numbers of settings: {@code 30}, {@code 30 s} and {@code 0.5 min} are the same
 * time. The label of a setting tells the unit of a plain number.
 */
final class Units {
  private static final Pattern NUMBER =
      Pattern.compile("([-+]?[0-9.]+(?:[eE][-+]?[0-9]{1,3})?)\\s*([a-zA-Z%]*)");

  private static final Pattern BARE = Pattern.compile("-?\\d+(\\.\\d+)?");

  /** Units by label; the first of each is that of plain numbers. */
  private static final Map<String, Map<String, BigDecimal>> UNITS =
      Map.of(
          "S", units("s", "1", "ms", "0.001", "min", "60", "h", "3600"),
          "MS", units("ms", "1", "s", "1000"),
          "HZ", units("Hz", "1"),
          "KBIT", units("kbit", "1", "Mbit", "1000"),
          "METRES", units("m", "1", "km", "1000"),
          "PERCENT", units("%", "1"));

  private Units() {}

  private static Map<String, BigDecimal> units(String... namesAndFactors) {
    Map<String, BigDecimal> units = new LinkedHashMap<>();
    for (int i = 0; i < namesAndFactors.length; i += 2) {
      units.put(namesAndFactors[i], new BigDecimal(namesAndFactors[i + 1]));
    }
    return units;
  }

  /**
   * Returns the unit of plain numbers, or empty for none.
   *
   * @param label of the value, such as {@code KBIT}
   */
  static String plain(String label) {
    Map<String, BigDecimal> units = UNITS.get(label);
    return units == null ? "" : units.keySet().iterator().next();
  }

  /** Returns a value with the unit that it is in, unless it names one or there is none. */
  static String with(String label, String value) {
    String unit = plain(label);
    return unit.isEmpty() || !BARE.matcher(value).matches() ? value : value + " " + unit;
  }

  /**
   * Returns a number in the unit of plain numbers.
   *
   * @throws IllegalArgumentException if it isn't one; the message stands behind the value
   */
  static BigDecimal parse(String label, String text) {
    Map<String, BigDecimal> units = UNITS.get(label);
    Matcher parts = NUMBER.matcher(text.strip());
    if (parts.matches()) {
      for (Map.Entry<String, BigDecimal> unit : units.entrySet()) {
        String given = parts.group(2);
        if (given.isEmpty() || given.equalsIgnoreCase(unit.getKey())) {
          try {
            return new BigDecimal(parts.group(1)).multiply(unit.getValue());
          } catch (NumberFormatException e) {
            break; // such as 1.2.3
          }
        }
      }
    }
    throw new IllegalArgumentException(
        "is not a number, alone or with one of these units: " + String.join(", ", units.keySet()));
  }
}
