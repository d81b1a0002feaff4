package carom.server.config;

import java.math.BigDecimal;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.TypeConversionException;

/**
 * Units behind the numbers of settings: {@code 30}, {@code 30 s} and {@code 0.5 min} are the same
 * time. The label of an option tells the unit of a plain number.
 */
public final class SettingUnits {
  private static final Pattern NUMBER = Pattern.compile("([-+]?[0-9.]+)\\s*([a-zA-Z%]*)");

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

  private SettingUnits() {}

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
   * @param label of the option's value, such as {@code KBIT}
   */
  public static String plain(String label) {
    Map<String, BigDecimal> units = UNITS.get(label);
    return units == null ? "" : units.keySet().iterator().next();
  }

  /** Returns a value with the unit that it is in, unless it names one or there is none. */
  static String with(String label, String value) {
    String unit = plain(label);
    return unit.isEmpty() || !BARE.matcher(value).matches() ? value : value + " " + unit;
  }

  /** Makes all options of a program that are measured in a unit accept it. */
  static void accept(CommandSpec program) {
    for (OptionSpec option : List.copyOf(program.options())) {
      program.remove(option); // all of them, which keeps their order
      Map<String, BigDecimal> units = UNITS.get(option.paramLabel());
      program.addOption(
          units == null
              ? option
              : option.toBuilder().converters(converter(units, option.type())).build());
    }
  }

  private static ITypeConverter<Number> converter(Map<String, BigDecimal> units, Class<?> type) {
    return text -> {
      BigDecimal number = parse(text, units);
      if (type == Double.class) {
        return number.doubleValue();
      }
      try {
        return number.intValueExact();
      } catch (ArithmeticException e) {
        boolean whole = number.stripTrailingZeros().scale() <= 0;
        String unit = units.keySet().iterator().next();
        throw new TypeConversionException(
            "'%s' is %s".formatted(text, whole ? "too large" : "not a whole number of " + unit));
      }
    };
  }

  private static BigDecimal parse(String text, Map<String, BigDecimal> units) {
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
    throw new TypeConversionException(
        String.format(
            Locale.ROOT,
            "'%s' is not a number, alone or with one of these units: %s",
            text,
            String.join(", ", units.keySet())));
  }
}
