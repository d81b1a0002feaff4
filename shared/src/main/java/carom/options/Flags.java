package carom.options;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.TypeConversionException;

/** Settings as flags of a command line. */
public final class Flags {
  /** Refusal of a switch's value by its row, while picocli reads the command line. */
  static final class Refusal extends TypeConversionException {
    private static final long serialVersionUID = 1;

    Refusal(IllegalArgumentException cause) {
      super(cause.getMessage());
    }
  }

  private Flags() {}

  /** Adds a flag for each row to a program, before those that it has. */
  public static void add(CommandSpec program, Rows rows) {
    List<OptionSpec> behind = List.copyOf(program.options());
    behind.forEach(program::remove);
    rows.all().forEach(row -> program.addOption(option(row)));
    behind.forEach(program::addOption);
  }

  private static OptionSpec option(Setting<?> row) {
    OptionSpec.Builder option =
        OptionSpec.builder("--" + row.name()).paramLabel(row.label()).description(row.help());
    switch (row.form()) {
      case LIST -> option.type(List.class).auxiliaryTypes(String.class);
      case MARK -> option.type(boolean.class).converters(text -> converted(row, text));
      case TOGGLE ->
          option
              .type(boolean.class)
              .negatable(true)
              .defaultValue(row.initialText())
              .converters(text -> converted(row, text));
      default -> option.type(String.class);
    }
    if (row.withoutValue() != null) {
      option.arity("0..1").fallbackValue(row.withoutValue());
    }
    return option.build();
  }

  /** Converts a switch, which picocli can't negate as a text; the row refuses it. */
  private static Object converted(Setting<?> row, String text) {
    try {
      return row.parse(List.of(text));
    } catch (IllegalArgumentException e) {
      throw new Refusal(e);
    }
  }

  /** Returns the values that a command line gives, by the names of their settings. */
  public static Map<String, List<String>> given(ParseResult parsed, Rows rows) {
    Map<String, List<String>> given = new LinkedHashMap<>();
    for (Setting<?> row : rows.all()) {
      if (parsed.hasMatchedOption("--" + row.name())) {
        Object value = parsed.matchedOption("--" + row.name()).getValue();
        given.put(
            row.name(),
            value instanceof List<?> list
                ? list.stream().map(String::valueOf).toList()
                : List.of(String.valueOf(value)));
      }
    }
    return given;
  }

  /**
   * Returns settings with what a command line gives.
   *
   * @throws BadFlag for the first value that can't be used
   */
  public static <S extends Settings<S>> S read(S settings, ParseResult parsed, Rows rows) {
    Map<String, List<String>> given = given(parsed, rows);
    S read = settings;
    for (Setting<?> row : rows.all()) {
      if (given.containsKey(row.name())) {
        try {
          read = read.parse(row, given.get(row.name()));
        } catch (IllegalArgumentException e) {
          throw new BadFlag(parsed.commandSpec().commandLine(), e.getMessage());
        }
      }
    }
    return read;
  }
}
