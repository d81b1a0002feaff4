package carom.server.config;

import com.typesafe.config.ConfigValueFactory;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;

/**
 * All settings with their effective values, in the order of {@code --help}. Immutable; any thread.
 *
 * @param all the settings
 */
public record EffectiveSettings(List<Setting> all) {
  /** Texts that need no quotes. */
  private static final Pattern PLAIN = Pattern.compile("(?!.*//)[-\\w./%]([-\\w./% ]*[-\\w./%])?");

  private static final int LINE = 100;

  /** Copies the list. */
  public EffectiveSettings {
    all = List.copyOf(all);
  }

  /** Returns the names of all settings. */
  public List<String> names() {
    return all.stream().map(Setting::name).toList();
  }

  /** Returns the setting of this name. */
  public Optional<Setting> find(String name) {
    return all.stream().filter(setting -> setting.name().equals(name)).findFirst();
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
    for (Setting setting : all) {
      file.append('\n');
      wrap(file, setting.doc());
      file.append(setting.isSet() ? "" : "#");
      file.append(setting.name()).append(" = ").append(value(setting)).append('\n');
    }
    return file.toString();
  }

  private static String value(Setting setting) {
    List<String> values = setting.values();
    if (values.isEmpty()) {
      return "<" + setting.kind() + ">";
    }
    if (values.size() > 1) {
      return "["
          + String.join(", ", values.stream().map(EffectiveSettings::literal).toList())
          + "]";
    }
    return literal(SettingUnits.with(setting.kind(), values.get(0)));
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
