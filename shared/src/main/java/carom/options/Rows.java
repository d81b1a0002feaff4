package carom.options;

import java.math.BigDecimal;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;

/**
 * The settings of a program, in the order of {@code --help}. Each method adds a row and returns it,
 * for a constant; {@link Setting#text} then says what it does.
 */
public final class Rows {
  private static final List<String> YES = List.of("true", "yes", "on");
  private static final List<String> NO = List.of("false", "no", "off");

  private final String prefix;
  private final List<Setting<?>> all = new ArrayList<>();

  private Rows(String prefix) {
    this.prefix = prefix;
  }

  /** Returns an empty list for settings that are flags, variables and lines of a file. */
  public static Rows ofFlags() {
    return new Rows("--");
  }

  /** Returns an empty list for settings that only programs and files set, without flags. */
  public static Rows inner() {
    return new Rows("");
  }

  /** Returns all rows. */
  public List<Setting<?>> all() {
    return Collections.unmodifiableList(all);
  }

  /** Adds the rows of another list. */
  public void addAll(Rows others) {
    all.addAll(others.all);
  }

  /** Adds rows that belong to another list. */
  public void addAll(Setting<?>... rows) {
    all.addAll(List.of(rows));
  }

  private <T> Setting<T> add(Setting<T> row) {
    all.add(row);
    return row;
  }

  private <T> Setting<T> one(
      String name, String label, Function<String, T> parser, Object initial) {
    return add(
        new Setting<>(
            Setting.Form.VALUE, prefix, name, label, t -> parser.apply(t.get(0)), initial));
  }

  /**
   * Adds a setting of some type.
   *
   * @param label kind of the value, such as {@code FILE}
   * @param parser reads a value; IllegalArgumentException says why it can't
   * @param initial default as it would be written, or null for none
   */
  public <T> Setting<T> of(String name, String label, Function<String, T> parser, Object initial) {
    return one(name, label, explained(parser), initial);
  }

  /** Returns a parser whose problem stands behind the value and a colon. */
  private static <T> Function<String, T> explained(Function<String, T> parser) {
    return value -> {
      try {
        return parser.apply(value);
      } catch (IllegalArgumentException e) {
        throw new IllegalArgumentException("=" + value + ": " + e.getMessage(), e);
      }
    };
  }

  /** Adds a text. */
  public Setting<String> text(String name, String label, String initial) {
    return one(name, label, value -> value, initial);
  }

  /** Adds a text of some length, in characters. */
  public Setting<String> text(String name, String label, int min, int max, String initial) {
    return text(name, label, initial)
        .limitedTo(
            min + ".." + max,
            value -> {
              int length = value.isBlank() ? 0 : value.length();
              return length < min || length > max
                  ? ": length=" + length + " is outside " + min + ".." + max
                  : null;
            });
  }

  /** Adds a text that may be given several times. */
  public Setting<List<String>> texts(String name, String label) {
    return list(name, label, value -> value);
  }

  /** Adds something that may be given several times; empty by default. */
  public <T> Setting<List<T>> list(String name, String label, Function<String, T> parser) {
    Function<String, T> each = explained(parser);
    return add(
        new Setting<>(
            Setting.Form.LIST,
            prefix,
            name,
            label,
            values -> values.stream().map(each).toList(),
            null));
  }

  /** Adds a whole number. */
  public Setting<Integer> whole(String name, String label, int min, int max, Object initial) {
    return limited(one(name, label, value -> toInt(label, value), initial), min, max);
  }

  /** Adds a port; 0 asks for any free one. */
  public Setting<Integer> port(String name, Object initial) {
    return whole(name, "N", 0, Sockets.MAX_PORT, initial);
  }

  /** Adds a whole number of 64 bits, such as the start of random numbers. */
  public Setting<Long> seed(String name, Object initial) {
    return one(name, "N", Rows::toLong, initial);
  }

  /** Adds a real number. */
  public Setting<Double> number(String name, String label, double min, double max, Object initial) {
    return limited(one(name, label, value -> toDouble(label, value), initial), min, max);
  }

  private static <T extends Number> Setting<T> limited(Setting<T> row, double min, double max) {
    String range = String.format(Locale.ROOT, "%.0f..%.0f", min, max);
    String unit = row.unit().isEmpty() ? "" : " " + row.unit();
    return row.limitedTo(
        range,
        value -> // NaN is in no range
        value.doubleValue() >= min && value.doubleValue() <= max
                ? null
                : "is outside " + range + unit);
  }

  private static int toInt(String label, String text) {
    if (Units.plain(label).isEmpty()) {
      long number = toLong(text);
      if (number != (int) number) {
        throw new IllegalArgumentException("is too large");
      }
      return (int) number;
    }
    BigDecimal number = Units.parse(label, text);
    try {
      return number.intValueExact();
    } catch (ArithmeticException e) {
      boolean whole = number.stripTrailingZeros().scale() <= 0;
      throw new IllegalArgumentException(
          whole ? "is too large" : "is not a whole number of " + Units.plain(label), e);
    }
  }

  private static long toLong(String text) {
    try {
      return Long.parseLong(text);
    } catch (NumberFormatException e) {
      throw new IllegalArgumentException("is not a whole number", e);
    }
  }

  private static double toDouble(String label, String text) {
    if (!Units.plain(label).isEmpty()) {
      return Units.parse(label, text).doubleValue();
    }
    try {
      return Double.parseDouble(text);
    } catch (NumberFormatException e) {
      throw new IllegalArgumentException("is not a number", e);
    }
  }

  /** Adds a switch, written {@code --name}, {@code --no-name} or {@code --name=true}. */
  public Setting<Boolean> toggle(String name, boolean initial) {
    return onOrOff(Setting.Form.TOGGLE, name, initial).alone("true");
  }

  /** Adds a switch that is off unless its name is there. */
  public Setting<Boolean> mark(String name) {
    return onOrOff(Setting.Form.MARK, name, false);
  }

  private Setting<Boolean> onOrOff(Setting.Form form, String name, boolean initial) {
    return add(new Setting<>(form, prefix, name, "true|false", t -> isYes(t.get(0)), initial));
  }

  private static boolean isYes(String text) {
    String word = text.toLowerCase(Locale.ROOT);
    if (!YES.contains(word) && !NO.contains(word)) {
      throw new IllegalArgumentException("is neither true nor false");
    }
    return YES.contains(word);
  }

  /** Adds a file or folder. */
  public Setting<Path> path(String name, String label, String initial) {
    return one(name, label, Rows::toPath, initial);
  }

  private static Path toPath(String text) {
    try {
      return Path.of(text);
    } catch (InvalidPathException e) {
      throw new IllegalArgumentException("can't be a path: " + e.getReason(), e);
    }
  }

  /** Adds a choice; {@code {choices}} in the text becomes a list of the words. */
  public <E extends Enum<E>> Setting<E> choice(String name, String label, E initial) {
    List<E> values = List.of(initial.getDeclaringClass().getEnumConstants());
    String words = String.join(", ", values.stream().map(Rows::word).toList());
    return one(
            name,
            label,
            value ->
                values.stream()
                    .filter(each -> word(each).equalsIgnoreCase(value))
                    .findFirst()
                    .orElseThrow(() -> new IllegalArgumentException("is none of " + words)),
            word(initial))
        .choices(() -> words);
  }

  private static String word(Enum<?> value) {
    return value.name().toLowerCase(Locale.ROOT).replace('_', '-');
  }
}
