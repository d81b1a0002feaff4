package carom.server.config;

import carom.options.Setting;
import com.typesafe.config.ConfigValueFactory;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;

/**
 * All settings with their effective values, in the order of {@code --help}. Immutable; any thread.
 *
 * @param all the settings
 */
public record EffectiveSettings(List<EffectiveSetting> all) {
  /** Texts that need no quotes. */
  private static final Pattern PLAIN = Pattern.compile("(?!.*//)[-\\w./%]([-\\w./% ]*[-\\w./%])?");

  private static final int LINE = 100;

  /** Copies the list. */
  public EffectiveSettings {
    all = List.copyOf(all);
  }

  /** Returns the names of all settings. */
  public List<String> names() {
    return all.stream().map(EffectiveSetting::name).toList();
  }

  /** Returns the setting of this name. */
  public Optional<EffectiveSetting> find(String name) {
    return all.stream().filter(setting -> setting.name().equals(name)).findFirst();
  }

  /** Returns whether a layer above the default sets this. */
  public boolean isSet(Setting<?> row) {
    return find(row.name()).orElseThrow().isSet();
  }

  /**
   * Returns the values.
   *
   * @throws IllegalArgumentException for the first that can't be used
   */
  public ServerConfig config() {
    ServerConfig config = new ServerConfig();
    for (EffectiveSetting setting : all) {
      if (setting.isSet()) {
        config = config.parse(setting.row(), setting.given());
      }
    }
    return config;
  }

  /**
   * Returns a file of settings. It explains each, has those that are set, and has the defaults of
   * the others as comments.
   */
  public String file() {
    StringBuilder file = new StringBuilder();
    wrap(
        file,
        "Settings of carom-server. Each is also a flag (--tick-rate) and an environment variable"
            + " (CAROM_TICK_RATE). Flags win over variables, variables over this file, and this"
            + " file over the defaults, which are shown in comments. Numbers may have a unit.");
    for (EffectiveSetting setting : all) {
      file.append('\n');
      wrap(file, setting.row().doc());
      file.append(setting.isSet() ? "" : "#");
      file.append(setting.name()).append(" = ").append(value(setting)).append('\n');
    }
    return file.toString();
  }

  private static String value(EffectiveSetting setting) {
    List<String> values = setting.values();
    if (values.isEmpty()) {
      return "<" + setting.row().label() + ">";
    }
    if (values.size() > 1) {
      return "["
          + String.join(", ", values.stream().map(EffectiveSettings::literal).toList())
          + "]";
    }
    String only = values.get(0);
    return literal(only.isEmpty() ? only : setting.row().shown(only));
  }

  private static String literal(String text) {
    return PLAIN.matcher(text).matches() ? text : ConfigValueFactory.fromAnyRef(text).render();
  }

  private static void wrap(StringBuilder file, String text) {
    int column = 0;
    for (String word : text.split("\\s+")) {
      if (column > 0 && column + 1 + word.length() > LINE) {
        file.append('\n');
        column = 0;
      }
      String gap = column == 0 ? "# " : " ";
      file.append(gap).append(word);
      column += gap.length() + word.length();
    }
    file.append('\n');
  }
}
