package carom.options;

import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import java.util.function.Supplier;

/**
 * One setting of a program: a row that says all there is to know of it. Command line, environment,
 * file, checks, help and documentation follow from the row. {@link Rows} makes rows; {@link
 * Settings} holds their values. Immutable; two rows are equal only if they are the same.
 *
 * @param <T> type of the value; {@code List} for a setting that may be given several times
 */
public final class Setting<T> {
  /** Beginning of the names of environment variables. */
  public static final String VARIABLE_PREFIX = "CAROM_";

  /** Way in which a setting is written. */
  enum Form {
    /** One value. */
    VALUE,
    /** A list of values, each written by itself. */
    LIST,
    /** A switch: {@code --web}, {@code --no-web}, {@code --web=false}. */
    TOGGLE,
    /** A switch that is off unless it is there. */
    MARK
  }

  private final Form form;
  private final String prefix;
  private final String name;
  private final String label;
  private final Function<List<String>, T> parser;
  private final String initialText;
  private final T initial;
  private String text = "";
  private String range = "";
  private Function<T, String> problem = value -> null;
  private Function<T, String> writer = String::valueOf;
  private String withoutValue;
  private Supplier<String> choices = () -> "";
  private boolean live;

  /**
   * Creates a row, which {@link Rows} completes.
   *
   * @param prefix of the name in messages: two dashes for a setting that has a flag
   * @param label kind of the value, such as {@code FILE} or {@code HZ}
   * @param initialText default as it would be written, or null for none
   */
  Setting(
      Form form,
      String prefix,
      String name,
      String label,
      Function<List<String>, T> parser,
      Object initialText) {
    this.form = form;
    this.prefix = prefix;
    this.name = name;
    this.label = label;
    this.parser = parser;
    this.initialText = initialText == null ? "" : String.valueOf(initialText);
    this.initial =
        form == Form.LIST
            ? parser.apply(List.of())
            : initialText == null ? null : parser.apply(List.of(this.initialText));
  }

  /**
   * Sets what it does, and returns this row. {@code {range}} and {@code {default}} stand for those
   * of the row; a default in parentheses comes last.
   */
  public Setting<T> text(String words) {
    text = words;
    return this;
  }

  /** Limits the values. The text tells the range where it has {@code {range}}. */
  Setting<T> limitedTo(String allowed, Function<T, String> rule) {
    range = allowed;
    problem = rule;
    return this;
  }

  /**
   * Adds a rule, and returns this row.
   *
   * @param rule returns what is wrong with a value, or null: words behind {@code --name=value}
   */
  public Setting<T> checked(Function<T, String> rule) {
    Function<T, String> before = problem;
    problem =
        value -> {
          String first = before.apply(value);
          return first == null ? rule.apply(value) : first;
        };
    return this;
  }

  /** Lets {@code reload} and {@code set} change it while the server runs, and returns this row. */
  public Setting<T> live() {
    live = true;
    return this;
  }

  /** Makes the name alone mean this value ({@code --watch}), and returns this row. */
  public Setting<T> alone(String value) {
    withoutValue = value;
    return this;
  }

  /** Sets how values are written where that isn't their {@code toString}, and returns this row. */
  public Setting<T> written(Function<T, String> words) {
    writer = words;
    return this;
  }

  /** Returns a value as it would be written. */
  String write(T value) {
    return value instanceof List<?> list ? joined(list) : writer.apply(value);
  }

  private static String joined(List<?> list) {
    return String.join(", ", list.stream().map(String::valueOf).toList());
  }

  /** Sets what the text tells at {@code {choices}}, and returns this row. */
  public Setting<T> choices(Supplier<String> words) {
    choices = words;
    return this;
  }

  /**
   * Returns the value that is written like this.
   *
   * @param texts one, or several for a setting that may be given several times
   * @throws IllegalArgumentException if it can't be used; the message names setting, value, limit
   */
  public T parse(List<String> texts) {
    T value;
    try {
      value = parser.apply(texts);
    } catch (IllegalArgumentException e) {
      throw refusal(texts, e.getMessage());
    }
    require(value, texts);
    return value;
  }

  /**
   * Checks a value.
   *
   * @throws IllegalArgumentException as {@link #parse}
   */
  void require(T value) {
    require(value, value);
  }

  private void require(T value, Object shown) {
    String wrong = problem.apply(value);
    if (wrong != null) {
      throw refusal(shown, wrong);
    }
  }

  private IllegalArgumentException refusal(Object shown, String wrong) {
    String value = shown instanceof List<?> list ? joined(list) : String.valueOf(shown);
    return new IllegalArgumentException(
        prefix
            + name
            + (wrong.startsWith(":") || wrong.startsWith("=") ? "" : "=" + value + " ")
            + wrong);
  }

  /** Returns the name: in the file, behind {@code --} on the command line, at the console. */
  public String name() {
    return name;
  }

  /** Returns the name of the environment variable. */
  public String variable() {
    return variable(name);
  }

  /** Returns the name of the environment variable of a setting. */
  public static String variable(String name) {
    return VARIABLE_PREFIX + name.toUpperCase(Locale.ROOT).replace('-', '_');
  }

  /** Returns the kind of the value, such as {@code FILE} or {@code HZ}. */
  public String label() {
    return label;
  }

  /** Returns the default, or null if there is none. */
  public T initial() {
    return initial;
  }

  /** Returns the default as it would be written; empty for none. */
  public String initialText() {
    return initialText;
  }

  /** Returns the range as a text, in the unit of plain numbers; empty if there is none. */
  public String range() {
    return range;
  }

  /** Returns the unit of plain numbers; empty if there is none. */
  public String unit() {
    return Units.plain(label);
  }

  /** Returns a value, as somebody wrote it, with its unit; a dash for none. */
  public String shown(String value) {
    return value.isEmpty() ? "-" : Units.with(label, value);
  }

  /** Returns what it does, in a sentence or two without the default. */
  public String doc() {
    return filled(text.replace(" ({default})", ""));
  }

  /** Returns what it does with its default, for {@code --help}. */
  String help() {
    return filled(text);
  }

  private String filled(String words) {
    String all = words.replace("{range}", range).replace("{default}", initialText);
    return all.contains("{choices}") ? all.replace("{choices}", choices.get()) : all;
  }

  /** Returns whether {@code reload} and {@code set} change it while the server runs. */
  public boolean isLive() {
    return live;
  }

  /** Returns whether it may be given several times. */
  public boolean isList() {
    return form == Form.LIST;
  }

  /** Returns whether it is on or off. */
  public boolean isSwitch() {
    return form == Form.TOGGLE || form == Form.MARK;
  }

  Form form() {
    return form;
  }

  /** Returns what its name alone means, or null if it needs a value. */
  String withoutValue() {
    return withoutValue;
  }

  @Override
  public String toString() {
    return prefix + name;
  }
}
