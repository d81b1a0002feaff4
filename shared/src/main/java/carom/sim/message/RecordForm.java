package carom.sim.message;

import java.lang.reflect.Constructor;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.List;

/**
 * A record as the form of a message: its components are the arguments. Immutable; any thread.
 *
 * @param type the record's class
 * @param arguments one for each component, in their order
 */
record RecordForm(Class<? extends Record> type, List<Argument> arguments) {
  /**
   * Reads the declaration.
   *
   * @throws IllegalArgumentException if a component can't be an argument; says which and why
   */
  static RecordForm of(Class<? extends Record> type) {
    List<Argument> arguments = new ArrayList<>();
    for (RecordComponent component : type.getRecordComponents()) {
      arguments.add(argument(type, component));
    }
    return new RecordForm(type, List.copyOf(arguments));
  }

  @SuppressWarnings("unchecked") // an enum's class is checked before
  private static Argument argument(Class<?> type, RecordComponent component) {
    String name = component.getName();
    Class<?> of = component.getType();
    Bounds bounds = component.getAnnotation(Bounds.class);
    if (of == boolean.class) {
      return Argument.flag(name);
    }
    if (of.isEnum()) {
      return Argument.choice(name, (Class<? extends Enum<?>>) of);
    }
    if (of == int.class && component.isAnnotationPresent(IdOfPlayer.class)) {
      return Argument.player(name);
    }
    if (of == int.class && component.isAnnotationPresent(IdOfEntity.class)) {
      return Argument.entity(name);
    }
    if (of == int.class && bounds != null) {
      requireWhole(type, name, bounds.min());
      requireWhole(type, name, bounds.max());
      return Argument.count(name, (int) bounds.min(), (int) bounds.max());
    }
    if (of == float.class && bounds != null) {
      return Argument.real(name, (float) bounds.min(), (float) bounds.max());
    }
    if (of == String.class && component.isAnnotationPresent(Longest.class)) {
      return Argument.text(name, component.getAnnotation(Longest.class).value());
    }
    String need =
        of == int.class || of == float.class
            ? "needs @Bounds(min = ..., max = ...)"
                + (of == int.class ? ", @IdOfPlayer or @IdOfEntity" : "")
            : of == String.class
                ? "needs @Longest(...)"
                : "is no boolean, int, float, text or enum";
    throw new IllegalArgumentException(
        "record " + type.getSimpleName() + ": " + of.getSimpleName() + " " + name + " " + need);
  }

  private static void requireWhole(Class<?> type, String name, double bound) {
    if (bound != (int) bound) {
      throw new IllegalArgumentException(
          "record "
              + type.getSimpleName()
              + ": the bound "
              + bound
              + " of int "
              + name
              + " is no int");
    }
  }

  /** Returns the values of a record of this class, in the order of the arguments. */
  Object[] values(Record from) {
    Object[] values = new Object[arguments.size()];
    RecordComponent[] components = type.getRecordComponents();
    for (int i = 0; i < values.length; i++) {
      try {
        components[i].getAccessor().setAccessible(true); // the game's record needn't be public
        values[i] = components[i].getAccessor().invoke(from);
      } catch (ReflectiveOperationException e) {
        throw new IllegalStateException(from + " can't be read", e);
      }
    }
    return values;
  }

  /** Returns a record of values, in the order of the arguments. */
  Record make(Object[] values) {
    RecordComponent[] components = type.getRecordComponents();
    Class<?>[] types = new Class<?>[components.length];
    for (int i = 0; i < types.length; i++) {
      types[i] = components[i].getType();
    }
    try {
      Constructor<? extends Record> constructor = type.getDeclaredConstructor(types);
      constructor.setAccessible(true);
      return constructor.newInstance(values);
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException(type.getSimpleName() + " can't be made", e);
    }
  }
}
