package carom.options;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * Values of settings. Immutable: each {@code with} returns a changed copy, and throws {@link
 * IllegalArgumentException} for a value that the row refuses. What isn't set has its row's default.
 *
 * @param <S> type of the copies
 */
public abstract class Settings<S extends Settings<S>> implements Cloneable {
  private Map<Setting<?>, Object> values = Map.of(); // those that aren't as by default

  /** Starts with the defaults. */
  protected Settings() {}

  /** Returns the value of a setting; null if it isn't set and has no default. */
  public final <T> T get(Setting<T> row) {
    @SuppressWarnings("unchecked") // with() puts nothing else
    T value = (T) values.get(row);
    return value == null ? row.initial() : value;
  }

  /** Returns the value of a setting, or another if it isn't set and has no default. */
  public final <T> T get(Setting<T> row, T otherwise) {
    T value = get(row);
    return value == null ? otherwise : value;
  }

  /** Returns the value of a setting as it would be written. */
  public final <T> String text(Setting<T> row) {
    return row.write(get(row));
  }

  /** Returns a copy with a value; null for the default. */
  public final <T> S with(Setting<T> row, T value) {
    if (value != null) {
      row.require(value);
    }
    Map<Setting<?>, Object> changed = new HashMap<>(values);
    if (value == null || value.equals(row.initial())) {
      changed.remove(row);
    } else {
      changed.put(row, value);
    }
    try {
      @SuppressWarnings("unchecked") // subclasses name themselves
      S copy = (S) clone();
      ((Settings<?>) copy).values = changed;
      return copy;
    } catch (CloneNotSupportedException e) {
      throw new AssertionError(e);
    }
  }

  /** Returns a copy with a whole number. */
  public final S with(Setting<Long> row, long value) {
    return with(row, (Long) value);
  }

  /** Returns a copy with a real number. */
  public final S with(Setting<Double> row, double value) {
    return with(row, (Double) value);
  }

  /**
   * Returns a copy with a value that is written like this.
   *
   * @param texts one, or several for a setting that may be given several times
   */
  public final <T> S parse(Setting<T> row, List<String> texts) {
    return with(row, row.parse(texts));
  }

  /**
   * Returns a copy with the values of other settings, as far as they change in a running program.
   */
  public final S withLiveOf(S other, Rows rows) {
    @SuppressWarnings("unchecked") // subclasses name themselves
    S changed = (S) this;
    for (Setting<?> row : rows.all()) {
      changed = row.isLive() ? ((Settings<S>) changed).withValueOf(other, row) : changed;
    }
    return changed;
  }

  private <T> S withValueOf(S other, Setting<T> row) {
    return with(row, other.get(row));
  }

  /** Returns what isn't as by default. */
  @Override
  public String toString() {
    Map<String, Object> sorted = new TreeMap<>();
    values.forEach((row, value) -> sorted.put(row.name(), value));
    return sorted.toString();
  }

  @Override
  public final boolean equals(Object other) {
    return other instanceof Settings<?> settings && values.equals(settings.values);
  }

  @Override
  public final int hashCode() {
    return values.hashCode();
  }
}
