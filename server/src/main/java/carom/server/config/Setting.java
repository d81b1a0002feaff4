package carom.server.config;

import java.util.List;
import java.util.Locale;

/**
 * One setting with its effective value. Immutable.
 *
 * @param name its name, the same in the file, on the command line (behind {@code --}), in the
 *     environment (as {@link #variable}) and at the console
 * @param values effective value as text; several for a setting that may be repeated, none when it
 *     isn't set and has no default
 * @param origin where the value comes from, for people: {@code default}, {@code command line},
 *     {@code environment CAROM_SEED} or {@code data/carom.conf: 12}
 * @param defaultValue default as text, empty for none
 * @param kind what the value is, such as {@code FILE} or {@code HZ}
 * @param doc what the setting does, in a sentence or two without the default
 */
public record Setting(
    String name, List<String> values, String origin, String defaultValue, String kind, String doc) {
  /** Origin of a default value. */
  public static final String DEFAULT = "default";

  /** Beginning of the names of environment variables. */
  public static final String VARIABLE_PREFIX = "CAROM_";

  /** Copies the list. */
  public Setting {
    values = List.copyOf(values);
  }

  /** Returns the effective value as one text, empty if there is none. */
  public String value() {
    return String.join(", ", values);
  }

  /** Returns the effective value for people: with its unit, and a dash for none. */
  public String shown() {
    return shown(value());
  }

  /** Returns the default for people: with its unit, and a dash for none. */
  public String shownDefault() {
    return shown(defaultValue);
  }

  private String shown(String text) {
    return text.isEmpty() ? "-" : SettingUnits.with(kind, text);
  }

  /** Returns whether a layer above the default sets this. */
  public boolean isSet() {
    return !origin.equals(DEFAULT);
  }

  /** Returns the name of the environment variable that sets this. */
  public String variable() {
    return variable(name);
  }

  /** Returns the name of the environment variable of a setting. */
  static String variable(String name) {
    return VARIABLE_PREFIX + name.toUpperCase(Locale.ROOT).replace('-', '_');
  }
}
