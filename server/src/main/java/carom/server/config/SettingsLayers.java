package carom.server.config;

import carom.text.Suggestion;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.ParseResult;

/**
 * Puts the layers of settings on top of each other: command line over environment over file over
 * defaults. The options of the program declare the settings, once for all layers. What a file or
 * the environment sets goes in front of the command line, unless the command line sets it, too; so
 * every layer is parsed and checked by the same code.
 */
public final class SettingsLayers {
  /** Name of the setting that is the data folder. */
  public static final String DATA = "data";

  /** Name of the option that is the file of settings. */
  public static final String CONFIG = "config";

  /** Name of the option that prints the settings as a file. */
  public static final String PRINT_CONFIG = "print-config";

  /** Options that are no settings, although other layers could set them. */
  private static final Set<String> ONLY_FLAGS = Set.of(CONFIG, PRINT_CONFIG);

  private static final String COMMAND_LINE = "command line";
  private static final String FLAG = "--";

  private final CommandSpec program;
  private final List<String> commandLine;
  private final Map<String, ConfigFile.Value> below = new TreeMap<>();
  private final List<String> warnings = new ArrayList<>();
  private final Path file;

  /**
   * Reads the environment and the file.
   *
   * @param program its options are the settings; from now on they also accept units
   * @param commandLine arguments of the program
   * @param environment environment variables; those with {@link Setting#VARIABLE_PREFIX} count
   * @throws BadSettingException if the file can't be used
   */
  public SettingsLayers(
      CommandSpec program, List<String> commandLine, Map<String, String> environment)
      throws BadSettingException {
    this(program, commandLine, environment, Map.of());
  }

  /**
   * Reads the environment and the file.
   *
   * @param set values that win over all layers, because an operator has set them by a command
   * @throws BadSettingException if the file can't be used
   */
  public SettingsLayers(
      CommandSpec program,
      List<String> commandLine,
      Map<String, String> environment,
      Map<String, String> set)
      throws BadSettingException {
    this.program = program;
    this.commandLine = without(set.keySet(), commandLine);
    SettingUnits.accept(program);
    Map<String, ConfigFile.Value> fromEnvironment = readEnvironment(environment);
    String named = commandLineValue(CONFIG);
    if (named == null) {
      named = textOf(fromEnvironment.remove(CONFIG));
    }
    String data = commandLineValue(DATA);
    if (data == null) {
      data = textOf(fromEnvironment.get(DATA));
    }
    if (data == null) {
      data = option(DATA).defaultValue();
    }
    Path usual = path(data, DATA).resolve(DataFolder.CONFIG);
    file =
        named != null
            ? path(named, CONFIG)
            : Files.exists(usual, LinkOption.NOFOLLOW_LINKS) ? usual : null;
    if (file != null) {
      readFile(named == null ? path(data, DATA) : null);
    }
    below.putAll(fromEnvironment);
    below.keySet().removeIf(name -> commandLineValue(name) != null);
    set.forEach(
        (name, value) -> below.put(name, new ConfigFile.Value(List.of(value), "the command set")));
  }

  /** Returns a command line without some options and their values. */
  private static List<String> without(Set<String> names, List<String> commandLine) {
    List<String> left = new ArrayList<>();
    for (int i = 0; i < commandLine.size(); i++) {
      String word = commandLine.get(i);
      String name = word.startsWith(FLAG) ? word.substring(FLAG.length()).split("=", 2)[0] : "";
      String positive = name.startsWith("no-") ? name.substring(3) : name;
      if (!names.contains(positive)) {
        left.add(word);
      } else if (!word.contains("=") && name.equals(positive) && takesNext(commandLine, i)) {
        i++;
      }
    }
    return left;
  }

  private static boolean takesNext(List<String> commandLine, int i) {
    return i + 1 < commandLine.size() && !commandLine.get(i + 1).startsWith(FLAG);
  }

  /** Returns the file of settings, or null if there is none. */
  public Path file() {
    return file;
  }

  /** Returns what is odd about the environment, in sentences for the log. */
  public List<String> warnings() {
    return Collections.unmodifiableList(warnings);
  }

  /** Returns the arguments for the program's parser: the lower layers' and the command line's. */
  public String[] arguments() {
    List<String> all = new ArrayList<>();
    below.forEach(
        (name, value) ->
            value.texts().forEach(text -> all.add(FLAG + name + "=" + argument(name, text))));
    all.addAll(commandLine);
    return all.toArray(new String[0]);
  }

  /** Returns a value as the parser takes it: HOCON has four more words for true and false. */
  private String argument(String name, String text) {
    if (option(name).type() != boolean.class) {
      return text;
    }
    return switch (text.toLowerCase(Locale.ROOT)) {
      case "yes", "on" -> "true";
      case "no", "off" -> "false";
      default -> text;
    };
  }

  /**
   * Returns where the settings that an error message names come from, in a sentence. Empty if all
   * are from the command line.
   */
  public String origins(String message) {
    List<String> origins = new ArrayList<>();
    below.forEach(
        (name, value) -> {
          if (message.matches("(?s).*" + FLAG + name + "\\b(?!-).*")) {
            origins.add(name + " is set by " + value.origin());
          }
        });
    return String.join("; ", origins);
  }

  /**
   * Returns the effective settings.
   *
   * @param parsed what the parser made of {@link #arguments}
   */
  public EffectiveSettings settings(ParseResult parsed) {
    List<Setting> settings = new ArrayList<>();
    for (OptionSpec option : program.options()) {
      if (isSetting(option)) {
        settings.add(setting(option, parsed));
      }
    }
    return new EffectiveSettings(settings);
  }

  private Setting setting(OptionSpec option, ParseResult parsed) {
    String name = name(option);
    String defaultValue = option.defaultValue() == null ? "" : option.defaultValue();
    List<String> values = defaultValue.isEmpty() ? List.of() : List.of(defaultValue);
    String origin = Setting.DEFAULT;
    if (parsed.hasMatchedOption(option)) {
      values = parsed.matchedOption(FLAG + name).originalStringValues();
      origin = below.containsKey(name) ? below.get(name).origin() : COMMAND_LINE;
    }
    return new Setting(name, values, origin, defaultValue, option.paramLabel(), doc(option));
  }

  /** Returns the description without the default at its end, which stands beside it. */
  private static String doc(OptionSpec option) {
    return String.join(" ", option.description()).replace(" (" + option.defaultValue() + ")", "");
  }

  private Map<String, ConfigFile.Value> readEnvironment(Map<String, String> environment) {
    Map<String, String> names = new TreeMap<>();
    settingNames().forEach(name -> names.put(Setting.variable(name), name));
    names.put(Setting.variable(CONFIG), CONFIG);
    Map<String, ConfigFile.Value> values = new TreeMap<>();
    for (Map.Entry<String, String> variable : new TreeMap<>(environment).entrySet()) {
      String key = variable.getKey();
      if (!key.startsWith(Setting.VARIABLE_PREFIX) || variable.getValue().isEmpty()) {
        continue; // an empty variable counts as none, as in compose files
      }
      if (names.containsKey(key)) {
        List<String> text = List.of(variable.getValue());
        values.put(names.get(key), new ConfigFile.Value(text, "environment " + key));
      } else {
        // Orchestrators make variables of their own, so an unknown one is no error.
        warnings.add(
            "environment variable "
                + key
                + " is no setting, ignored"
                + Suggestion.didYouMean(key, names.keySet()));
      }
    }
    return values;
  }

  /**
   * Reads the file.
   *
   * @param foundIn the data folder in which it was found, or null if it was named
   */
  private void readFile(Path foundIn) throws BadSettingException {
    Set<String> known = settingNames();
    for (Map.Entry<String, ConfigFile.Value> entry : ConfigFile.read(file).entrySet()) {
      String name = entry.getKey();
      ConfigFile.Value value = entry.getValue();
      if (!known.contains(name)) {
        throw new BadSettingException(
            "%s: unknown setting=%s%s; carom-server --print-config shows all"
                .formatted(value.origin(), name, Suggestion.didYouMean(name, known)));
      }
      if (name.equals(DATA) && foundIn != null && !isSame(path(textOf(value), DATA), foundIn)) {
        throw new BadSettingException(
            value.origin()
                + ": data can't be another folder in the file that is found in the data folder;"
                + " set it with --data or CAROM_DATA, or name the file with --config");
      }
      if (value.texts().size() > 1 && !option(name).isMultiValue()) {
        throw new BadSettingException(value.origin() + ": " + name + " takes one value, no list");
      }
      below.put(name, value);
    }
  }

  private static boolean isSame(Path a, Path b) {
    return a.toAbsolutePath().normalize().equals(b.toAbsolutePath().normalize());
  }

  private static Path path(String text, String name) throws BadSettingException {
    try {
      return Path.of(text);
    } catch (InvalidPathException e) {
      throw new BadSettingException(name + "=" + text + " can't be a path: " + e.getReason());
    }
  }

  /** Returns the value of an option on the command line, or null. */
  private String commandLineValue(String name) {
    String flag = FLAG + name;
    String negated = FLAG + "no-" + name;
    String found = null;
    for (int i = 0; i < commandLine.size(); i++) {
      String word = commandLine.get(i);
      if (word.startsWith(flag + "=")) {
        found = word.substring(flag.length() + 1);
      } else if (word.equals(flag) || word.equals(negated)) {
        found = i + 1 < commandLine.size() ? commandLine.get(i + 1) : "";
      }
    }
    return found;
  }

  private static String textOf(ConfigFile.Value value) {
    return value == null ? null : value.texts().get(0);
  }

  private Set<String> settingNames() {
    Set<String> names = new TreeSet<>();
    program.options().stream()
        .filter(SettingsLayers::isSetting)
        .forEach(option -> names.add(name(option)));
    return names;
  }

  private static boolean isSetting(OptionSpec option) {
    return !option.usageHelp() && !option.versionHelp() && !ONLY_FLAGS.contains(name(option));
  }

  private OptionSpec option(String name) {
    return program.findOption(FLAG + name);
  }

  private static String name(OptionSpec option) {
    return option.longestName().substring(FLAG.length());
  }
}
