package carom.sim.message;

import carom.physics.math.Limits;
import carom.text.Texts;
import java.util.List;

/**
 * An argument of a {@link MessageKind}: a name, a type and a range. Numbers of all types are kept
 * as ints: a real by its float bits, a flag as 0 or 1, a choice by its place, a player or entity by
 * its id. Immutable; any thread.
 *
 * @param min least int, or the least real's float bits, or the least length of a text
 * @param max greatest int, or the greatest real's float bits, or the greatest length of a text
 * @param constants of a choice in their order, otherwise empty; each an enum's
 */
public record Argument(String name, Type type, int min, int max, List<Object> constants) {
  /** Greatest length of a text, characters. */
  public static final int MAX_TEXT = 290;

  /** The id of no player and no entity. */
  private static final int NOBODY = -1;

  /** Largest id of a player, as {@code carom.sim.entity.PlayerTable} gives it. */
  static final int MAX_PLAYER = 1_023;

  /** Largest id of an entity, as {@code carom.sim.entity.EntityTable} gives it. */
  static final int MAX_ENTITY = 65_534;

  private static final int MAX_CHOICES = 256;

  /** A char takes at most three bytes; what takes four is two chars. */
  private static final int BYTES_PER_CHAR = 3;

  /** Types of arguments. */
  public enum Type {
    /** An integer. */
    COUNT,
    /** True or false. */
    FLAG,
    /** A number. */
    REAL,
    /** A constant of an enum. */
    CHOICE,
    /** A text. */
    TEXT,
    /** The id of a player, or -1. */
    PLAYER,
    /** The id of an entity, or -1. */
    ENTITY
  }

  /** Checks the name. */
  public Argument {
    if (Limits.notNull("name", name).isEmpty() || name.length() > 64) {
      throw new IllegalArgumentException(
          "name=\"" + name + "\" of an argument must have 1 to 64 characters");
    }
  }

  static Argument count(String name, int min, int max) {
    if (min > max) {
      throw new IllegalArgumentException(name + " has the empty range " + min + ".." + max);
    }
    return new Argument(name, Type.COUNT, min, max, List.of());
  }

  static Argument flag(String name) {
    return new Argument(name, Type.FLAG, 0, 1, List.of());
  }

  static Argument real(String name, float min, float max) {
    if (!(min <= max && Float.isFinite(min) && Float.isFinite(max))) {
      throw new IllegalArgumentException(
          name + " has the range " + min + ".." + max + ", which is empty or not finite");
    }
    return new Argument(
        name, Type.REAL, Float.floatToIntBits(min), Float.floatToIntBits(max), List.of());
  }

  static Argument choice(String name, Class<? extends Enum<?>> type) {
    List<Object> constants = List.of((Object[]) Limits.notNull("type", type).getEnumConstants());
    if (constants.size() < 1 || constants.size() > MAX_CHOICES) {
      throw new IllegalArgumentException(
          name + " has constants=" + constants.size() + " outside 1.." + MAX_CHOICES);
    }
    return new Argument(name, Type.CHOICE, 0, constants.size() - 1, constants);
  }

  static Argument player(String name) {
    return new Argument(name, Type.PLAYER, NOBODY, MAX_PLAYER, List.of());
  }

  static Argument entity(String name) {
    return new Argument(name, Type.ENTITY, NOBODY, MAX_ENTITY, List.of());
  }

  static Argument text(String name, int maxLength) {
    if (maxLength < 1 || maxLength > MAX_TEXT) {
      throw new IllegalArgumentException(
          name + " has maxLength=" + maxLength + " outside 1.." + MAX_TEXT);
    }
    return new Argument(name, Type.TEXT, 0, maxLength, List.of());
  }

  int maxBytes() {
    return switch (type) {
      case COUNT, PLAYER, ENTITY -> MessageBytes.size(max - min);
      case FLAG, CHOICE -> 1;
      case REAL -> Float.BYTES;
      case TEXT -> MessageBytes.size(BYTES_PER_CHAR * max) + BYTES_PER_CHAR * max;
    };
  }

  /** Puts a developer's value into a message. */
  void set(Message message, int at, Object value) {
    boolean fits =
        switch (type) {
          case COUNT, PLAYER, ENTITY -> value instanceof Integer i && takes(message, at, i);
          case FLAG -> value instanceof Boolean b && takes(message, at, b ? 1 : 0);
          case REAL -> value instanceof Float f && takes(message, at, Float.floatToIntBits(f));
          case CHOICE -> value instanceof Enum<?> e && takes(message, at, constants.indexOf(e));
          case TEXT -> value instanceof String s && takes(message, at, Texts.clean(s));
        };
    if (!fits) {
      throw new IllegalArgumentException("can't take " + name + "=" + value + "; it is " + this);
    }
  }

  /** Puts a value from outside into a message. Returns false when it doesn't fit. */
  boolean parse(Message message, int at, Object value) {
    if (value instanceof Number n && type == Type.REAL) {
      return takes(message, at, Float.floatToIntBits(n.floatValue()));
    }
    if (value instanceof Number n && isWhole()) {
      return n.doubleValue() == n.intValue() && takes(message, at, n.intValue());
    }
    if (value instanceof Boolean b && type == Type.FLAG) {
      return takes(message, at, b ? 1 : 0);
    }
    if (value instanceof String s && type == Type.TEXT) {
      return takes(message, at, Texts.clean(s));
    }
    if (value instanceof String s && type == Type.CHOICE) {
      for (int i = 0; i < constants.size(); i++) {
        if (((Enum<?>) constants.get(i)).name().equals(s)) {
          return takes(message, at, i);
        }
      }
    }
    return false;
  }

  private boolean isWhole() {
    return type == Type.COUNT || type == Type.PLAYER || type == Type.ENTITY;
  }

  /** Puts a number into a message. Returns false when it is out of range. */
  boolean takes(Message message, int at, int value) {
    boolean fits =
        type == Type.REAL
            ? Float.intBitsToFloat(value) >= Float.intBitsToFloat(min)
                && Float.intBitsToFloat(value) <= Float.intBitsToFloat(max)
            : value >= min && value <= max;
    message.numbers[at] = value;
    return fits;
  }

  /** Puts a text into a message. Returns false when it is too long. */
  boolean takes(Message message, int at, String text) {
    message.texts[at] = text;
    return text.length() <= max;
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof Argument a && toString().equals(a.toString());
  }

  @Override
  public int hashCode() {
    return toString().hashCode();
  }

  /** Returns the name, type and range, such as {@code item count 0..31}. */
  @Override
  public String toString() {
    return switch (type) {
      case COUNT -> name + " count " + min + ".." + max;
      case FLAG -> name + " flag";
      case REAL -> name + " real " + Float.intBitsToFloat(min) + ".." + Float.intBitsToFloat(max);
      case CHOICE -> name + " choice " + constants;
      case TEXT -> name + " text " + max;
      case PLAYER -> name + " player";
      case ENTITY -> name + " entity";
    };
  }
}
