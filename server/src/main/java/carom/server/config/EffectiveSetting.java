package carom.server.config;

import carom.options.Setting;
import java.util.List;
import java.util.Objects;

/**
 * One setting with its effective value. Immutable.
 *
 * @param row the setting
 * @param given what a layer above the default says, one text for each value; empty for nothing
 * @param origin where the value comes from, for people: {@code default}, {@code command line},
 *     {@code environment CAROM_SEED} or {@code data/carom.conf: 12}
 */
public record EffectiveSetting(Setting<?> row, List<String> given, String origin) {
  /** Origin of a default value. */
  public static final String DEFAULT = "default";

  /** Copies the list. */
  public EffectiveSetting {
    given = List.copyOf(given);
  }

  /** Returns the setting's name. */
  public String name() {
    return row.name();
  }

  /** Returns the effective value as texts; none when it isn't set and has no default. */
  public List<String> values() {
    if (isSet() && row.isSwitch()) {
      return List.of(String.valueOf(row.parse(given))); // whatever word it was
    }
    return isSet() || row.initialText().isEmpty() ? given : List.of(row.initialText());
  }

  /** Returns the effective value as one text, empty if there is none. */
  public String value() {
    return String.join(", ", values());
  }

  /**
   * Returns whether another has the same value, in any words and units.
   *
   * @param other of the same row
   * @throws IllegalArgumentException if the row refuses either value
   */
  public boolean isSameAs(EffectiveSetting other) {
    return values().equals(other.values()) || Objects.equals(parsed(), other.parsed());
  }

  private Object parsed() {
    return isSet() ? row.parse(given) : row.initial();
  }

  /** Returns whether a layer above the default sets this. */
  public boolean isSet() {
    return !origin.equals(DEFAULT);
  }
}
