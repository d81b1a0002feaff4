package carom.values;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.RecordComponent;

/**
 * Factory of changed copies of records. With it, a record of many settings has each {@code with...}
 * method in one line:
 *
 * <pre>{@code
 * public record Limits(int rate, int burst) {
 *   public Limits withRate(int rate) {
 *     return Records.with(this, "rate", rate);
 *   }
 * }
 * }</pre>
 *
 * <p>It uses reflection, which takes microseconds, so it suits settings but not loops. Call each
 * {@code with...} method in a test, because the compiler doesn't check the names.
 */
public final class Records {
  private Records() {}

  /**
   * Returns a copy of a record with some other values. The canonical constructor checks them.
   *
   * @param record the original, which stays as it is
   * @param changes names of components, each followed by its new value
   * @param <R> a record whose canonical constructor is public
   * @throws IllegalArgumentException if the record has no component of this name
   */
  public static <R extends Record> R with(R record, Object... changes) {
    @SuppressWarnings("unchecked") // getClass() of an R returns this type
    Class<R> type = (Class<R>) record.getClass();
    RecordComponent[] components = type.getRecordComponents();
    Class<?>[] types = new Class<?>[components.length];
    Object[] values = new Object[components.length];
    try {
      for (int i = 0; i < components.length; i++) {
        types[i] = components[i].getType();
        values[i] = components[i].getAccessor().invoke(record);
      }
      for (int i = 0; i < changes.length; i += 2) {
        values[indexOf(components, changes[i])] = changes[i + 1];
      }
      return type.getConstructor(types).newInstance(values);
    } catch (InvocationTargetException e) {
      if (e.getCause() instanceof RuntimeException refusal) {
        throw refusal;
      }
      throw new IllegalStateException(e);
    } catch (ReflectiveOperationException e) {
      throw new IllegalArgumentException(type + " must be public, with a public constructor", e);
    }
  }

  private static int indexOf(RecordComponent[] components, Object name) {
    for (int i = 0; i < components.length; i++) {
      if (components[i].getName().equals(name)) {
        return i;
      }
    }
    throw new IllegalArgumentException("name=" + name + " is no component of the record");
  }
}
