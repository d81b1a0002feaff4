package carom.sim.message;

import carom.physics.math.Limits;
import carom.text.Texts;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * A message of a {@link MessageKind} with a value for each argument, made by {@link
 * MessageKind#of}. It never changes; any thread may read it.
 */
public final class Message {
  private final MessageKind kind;
  final int[] numbers;
  final String[] texts;

  Message(MessageKind kind) {
    this.kind = kind;
    numbers = new int[kind.arguments().size()];
    texts = new String[numbers.length];
  }

  /** Returns the kind. */
  public MessageKind kind() {
    return kind;
  }

  /** Returns whether the message is of a kind. */
  @SuppressWarnings("ReferenceEquality") // a kind is declared once
  public boolean is(MessageKind other) {
    return kind == Limits.notNull("other", other);
  }

  /**
   * Returns an integer.
   *
   * @throws IllegalArgumentException when the kind has no count of this name
   */
  public int count(String argument) {
    return numbers[index(argument, Argument.Type.COUNT)];
  }

  /**
   * Returns the id of a player, or -1. Nobody may have it any more.
   *
   * @throws IllegalArgumentException when the kind has no player of this name
   */
  public int player(String argument) {
    return numbers[index(argument, Argument.Type.PLAYER)];
  }

  /**
   * Returns the id of an entity, or -1. It may be gone, and its id another one's.
   *
   * @throws IllegalArgumentException when the kind has no entity of this name
   */
  public int entity(String argument) {
    return numbers[index(argument, Argument.Type.ENTITY)];
  }

  /**
   * Returns a flag.
   *
   * @throws IllegalArgumentException when the kind has no flag of this name
   */
  public boolean flag(String argument) {
    return numbers[index(argument, Argument.Type.FLAG)] != 0;
  }

  /**
   * Returns a number.
   *
   * @throws IllegalArgumentException when the kind has no real of this name
   */
  public float real(String argument) {
    return Float.intBitsToFloat(numbers[index(argument, Argument.Type.REAL)]);
  }

  /**
   * Returns a constant of an enum.
   *
   * @throws IllegalArgumentException when the kind has no choice of this name
   * @throws ClassCastException when the choice is of another enum
   */
  public <E extends Enum<E>> E choice(String argument, Class<E> type) {
    int i = index(argument, Argument.Type.CHOICE);
    return type.cast(kind.arguments().get(i).constants().get(numbers[i]));
  }

  /**
   * Returns a text.
   *
   * @throws IllegalArgumentException when the kind has no text of this name
   */
  public String text(String argument) {
    return texts[index(argument, Argument.Type.TEXT)];
  }

  /**
   * Returns the values as a record.
   *
   * @param type the record by which the kind was declared
   * @throws IllegalArgumentException when it was declared otherwise
   */
  public <R extends Record> R as(Class<R> type) {
    Limits.notNull("type", type);
    RecordForm form = kind.form();
    if (form == null || form.type() != type) {
      throw kind.refused("isn't declared by " + type.getSimpleName());
    }
    Object[] values = new Object[numbers.length];
    for (int i = 0; i < values.length; i++) {
      Argument a = kind.arguments().get(i);
      values[i] =
          switch (a.type()) {
            case TEXT -> texts[i];
            case REAL -> Float.intBitsToFloat(numbers[i]);
            case CHOICE -> a.constants().get(numbers[i]);
            case FLAG -> numbers[i] != 0;
            case COUNT, PLAYER, ENTITY -> numbers[i];
          };
    }
    return type.cast(form.make(values));
  }

  /**
   * Returns all values by the names of their arguments: Integer, Boolean, Float or String; a choice
   * is the name of its constant.
   */
  public Map<String, Object> values() {
    Map<String, Object> values = new LinkedHashMap<>();
    for (int i = 0; i < numbers.length; i++) {
      Argument a = kind.arguments().get(i);
      values.put(
          a.name(),
          switch (a.type()) {
            case TEXT -> texts[i];
            case REAL -> Float.intBitsToFloat(numbers[i]);
            case CHOICE -> ((Enum<?>) a.constants().get(numbers[i])).name();
            case FLAG -> numbers[i] != 0;
            case COUNT, PLAYER, ENTITY -> numbers[i];
          });
    }
    return values;
  }

  private int index(String argument, Argument.Type type) {
    int i = kind.indexOf(argument);
    if (kind.arguments().get(i).type() != type) {
      throw kind.refused("has the argument " + kind.arguments().get(i));
    }
    return i;
  }

  /** Returns this message without the characters of its texts that can't be shown. */
  public Message cleaned() {
    Message clean = new Message(kind);
    for (int i = 0; i < numbers.length; i++) {
      clean.numbers[i] = numbers[i];
      clean.texts[i] = texts[i] == null ? null : Texts.clean(texts[i]);
    }
    return clean;
  }

  @Override
  public String toString() {
    StringBuilder s = new StringBuilder(kind.name());
    for (int i = 0; i < numbers.length; i++) {
      Argument a = kind.arguments().get(i);
      s.append(' ').append(a.name()).append('=');
      switch (a.type()) {
        case TEXT -> s.append('"').append(texts[i]).append('"');
        case REAL -> s.append(Float.intBitsToFloat(numbers[i]));
        case CHOICE -> s.append(a.constants().get(numbers[i]));
        default -> s.append(numbers[i]);
      }
    }
    return s.toString();
  }
}
