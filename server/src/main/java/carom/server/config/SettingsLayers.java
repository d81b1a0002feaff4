package carom.server.config;

import carom.options.Setting;
import carom.text.Suggestion;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;

/**
 * Puts the layers of settings on top of each other: command line over environment over file over
 * defaults. All layers have texts, which the rows of the settings parse and check alike.
 */
public final class SettingsLayers {
  private static final String COMMAND_LINE = "command line";
  private static final String DATA = ServerConfig.DATA.name();
  private static final String CONFIG = ServerConfig.CONFIG.name();

  private final Map<String, Setting<?>> rows = new LinkedHashMap<>();
  private final Map<String, ConfigFile.Value> values = new TreeMap<>();
  private final List<String> warnings = new ArrayList<>();
  private final Path file;

  /**
   * Reads the environment and the file.
   *
   * @param commandLine values that the command line gives, also of {@code --config}
   * @param environment environment variables; those with {@link Setting#VARIABLE_PREFIX} count
   * @param set values that win over all layers, because an operator has set them by a command
   * @throws BadSettingException if the file can't be used
   */
  public SettingsLayers(
      Map<String, List<String>> commandLine,
      Map<String, String> environment,
      Map<String, String> set)
      throws BadSettingException {
    ServerConfig.ROWS.all().forEach(row -> this.rows.put(row.name(), row));
    Map<String, ConfigFile.Value> above = readEnvironment(environment);
    commandLine.forEach(
        (name, texts) -> above.put(name, new ConfigFile.Value(texts, COMMAND_LINE)));
    set.forEach(
        (name, text) -> above.put(name, new ConfigFile.Value(List.of(text), "the command set")));
    ConfigFile.Value data = above.get(DATA);
    Path folder = data == null ? ServerConfig.DATA.initial() : path(data, DATA);
    ConfigFile.Value named = above.remove(CONFIG);
    Path usual = folder.resolve(DataFolder.CONFIG);
    file =
        named != null
            ? path(named, CONFIG)
            : Files.exists(usual, LinkOption.NOFOLLOW_LINKS) ? usual : null;
    if (file != null) {
      readFile(named == null ? folder : null);
    }
    values.putAll(above);
  }

  /** Returns the file of settings, or null if there is none. */
  public Path file() {
    return file;
  }

  /** Returns what is odd about the environment, in sentences for the log. */
  public List<String> warnings() {
    return Collections.unmodifiableList(warnings);
  }

  /**
   * Returns where the settings that an error message names come from, in a sentence. Empty if all
   * are from the command line.
   */
  public String origins(String message) {
    List<String> origins = new ArrayList<>();
    values.forEach(
        (name, value) -> {
          if (!value.origin().equals(COMMAND_LINE)
              && message.matches("(?s).*--" + name + "\\b(?!-).*")) {
            origins.add(name + " is set by " + value.origin());
          }
        });
    return String.join("; ", origins);
  }

  /** Returns the effective settings, which nobody has checked yet. */
  public EffectiveSettings settings() {
    List<EffectiveSetting> settings = new ArrayList<>();
    for (Setting<?> row : rows.values()) {
      ConfigFile.Value value = values.get(row.name());
      settings.add(
          value == null
              ? new EffectiveSetting(row, List.of(), EffectiveSetting.DEFAULT)
              : new EffectiveSetting(row, value.texts(), value.origin()));
    }
    return new EffectiveSettings(settings);
  }

  private Map<String, ConfigFile.Value> readEnvironment(Map<String, String> environment) {
    Map<String, String> names = new TreeMap<>();
    rows.keySet().forEach(name -> names.put(Setting.variable(name), name));
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
    Set<String> known = rows.keySet();
    for (Map.Entry<String, ConfigFile.Value> entry : ConfigFile.read(file).entrySet()) {
      String name = entry.getKey();
      ConfigFile.Value value = entry.getValue();
      if (!known.contains(name)) {
        throw new BadSettingException(
            "%s: unknown setting=%s%s; carom-server --print-config shows all"
                .formatted(value.origin(), name, Suggestion.didYouMean(name, known)));
      }
      if (name.equals(DATA) && foundIn != null && !isSame(path(value, DATA), foundIn)) {
        throw new BadSettingException(
            value.origin()
                + ": data can't be another folder in the file that is found in the data folder;"
                + " set it with --data or CAROM_DATA, or name the file with --config");
      }
      if (value.texts().size() > 1 && !rows.get(name).isList()) {
        throw new BadSettingException(value.origin() + ": " + name + " takes one value, no list");
      }
      values.put(name, value);
    }
  }

  private static boolean isSame(Path a, Path b) {
    return a.toAbsolutePath().normalize().equals(b.toAbsolutePath().normalize());
  }

  private static Path path(ConfigFile.Value value, String name) throws BadSettingException {
    String text = value.texts().get(0);
    try {
      return Path.of(text);
    } catch (InvalidPathException e) {
      throw new BadSettingException(name + "=" + text + " can't be a path: " + e.getReason());
    }
  }
}
