package carom.sim.message;

import carom.physics.math.Limits;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/**
 * A kind of message between a client and the game at the server, such as a purchase or a vote: its
 * name, its direction, and its arguments with their ranges. A game declares each kind once, as a
 * constant, and registers it in {@code Game.setUp}:
 *
 * <pre>{@code
 * static final MessageKind BUY =
 *     MessageKind.named("buy").fromClient().count("item", 0, 31).text("note", 60);
 * }</pre>
 *
 * <p>Without a direction a kind goes both ways. It is reliable unless {@link #unreliable} says
 * otherwise. Each method returns another kind and leaves this one as it is. Any thread may use it.
 */
public final class MessageKind {
  /** Largest message in bytes, as its arguments bound it. */
  public static final int MAX_BYTES = 900;

  /** Largest unreliable message in bytes, so that several fit a datagram. */
  public static final int MAX_UNRELIABLE_BYTES = 300;

  /** Largest number of arguments. */
  public static final int MAX_ARGUMENTS = 32;

  /** Messages a second that a client may send unless {@link #atMost} says otherwise. */
  public static final int DEFAULT_PER_SECOND = 10;

  /** Largest number of messages a second, as many as there are ticks at the fastest rate. */
  public static final int MAX_PER_SECOND = 240;

  /** The direction in which messages of a kind go. */
  public enum Direction {
    /** A client sends it to the game. */
    FROM_CLIENT,
    /** The game sends it to clients. */
    FROM_SERVER,
    /** Clients and the game send it. */
    BOTH;

    /** Returns whether messages of this direction come from there. */
    boolean allows(Direction from) {
      return this == BOTH || this == from;
    }
  }

  private final String name;
  private final Direction direction;
  private final boolean reliable;
  private final int perSecond;
  private final List<Argument> arguments;
  private final int maxBytes;
  private final RecordForm form; // null for a kind without a record

  private MessageKind(
      String name,
      Direction direction,
      boolean reliable,
      int perSecond,
      List<Argument> arguments,
      RecordForm form) {
    this.form = form;
    this.name = name;
    this.direction = direction;
    this.reliable = reliable;
    this.perSecond = perSecond;
    this.arguments = arguments;
    int bytes = 1;
    for (Argument argument : arguments) {
      bytes += argument.maxBytes();
    }
    maxBytes = bytes;
    int limit = reliable ? MAX_BYTES : MAX_UNRELIABLE_BYTES;
    if (maxBytes > limit) {
      throw refused("has bytes=" + maxBytes + ", limit=" + limit + "; shorten its texts");
    }
  }

  /**
   * Begins a kind without arguments that goes both ways, reliably.
   *
   * @param name unique in the game, 1..64 characters
   * @throws IllegalArgumentException when the name is empty or too long
   */
  public static MessageKind named(String name) {
    if (Limits.notNull("name", name).isEmpty() || name.length() > 64) {
      throw new IllegalArgumentException(
          "name=\"" + name + "\" of a message kind must have 1 to 64 characters");
    }
    return new MessageKind(name, Direction.BOTH, true, DEFAULT_PER_SECOND, List.of(), null);
  }

  /**
   * Declares a kind by a record. Its name is that of the record with a small first letter, and its
   * arguments are the components: boolean, int and float with {@link Bounds}, int with {@link
   * IdOfPlayer} or {@link IdOfEntity}, String with {@link Longest}, and enums. It goes both ways,
   * reliably, until told otherwise.
   *
   * <pre>{@code
   * record Throw(@IdOfEntity int ball, @Bounds(min = 0, max = 9) float power) {}
   * static final MessageKind THROW = MessageKind.of(Throw.class).fromClient();
   * ...
   * client.send(THROW.of(new Throw(3, 0.5f)));
   * Throw thrown = message.as(Throw.class);
   * }</pre>
   *
   * @throws IllegalArgumentException when a component has no bounds or another type; says which
   */
  public static MessageKind of(Class<? extends Record> type) {
    String simple = Limits.notNull("type", type).getSimpleName();
    if (!type.isRecord()) {
      throw new IllegalArgumentException("type=" + type.getName() + " is no record");
    }
    if (simple.isEmpty()) {
      throw new IllegalArgumentException("type=" + type.getName() + " has no name of its own");
    }
    RecordForm form = RecordForm.of(type);
    MessageKind kind = named(Character.toLowerCase(simple.charAt(0)) + simple.substring(1));
    if (form.arguments().size() > MAX_ARGUMENTS) {
      throw kind.refused("has more than " + MAX_ARGUMENTS + " arguments");
    }
    return new MessageKind(
        kind.name, kind.direction, kind.reliable, kind.perSecond, form.arguments(), form);
  }

  /** Returns this kind, sent by clients only. */
  public MessageKind fromClient() {
    return new MessageKind(name, Direction.FROM_CLIENT, reliable, perSecond, arguments, form);
  }

  /** Returns this kind, sent by the game at the server only. */
  public MessageKind fromServer() {
    return new MessageKind(name, Direction.FROM_SERVER, reliable, perSecond, arguments, form);
  }

  /**
   * Returns this kind, sent in datagrams: quick, at most once, and lost when the datagram is lost
   * or overtaken by a newer one. It suits what the next message replaces, such as a pointer.
   *
   * @throws IllegalArgumentException when it may be larger than {@value #MAX_UNRELIABLE_BYTES}
   *     bytes
   */
  public MessageKind unreliable() {
    return new MessageKind(name, direction, false, perSecond, arguments, form);
  }

  /**
   * Returns this kind with another limit on what one client may send. What exceeds it is dropped.
   *
   * @param messagesPerSecond 1..{@value #MAX_PER_SECOND}
   * @throws IllegalArgumentException when the number is out of range
   */
  public MessageKind atMost(int messagesPerSecond) {
    if (messagesPerSecond < 1 || messagesPerSecond > MAX_PER_SECOND) {
      throw refused("has atMost=" + messagesPerSecond + " outside 1.." + MAX_PER_SECOND);
    }
    return new MessageKind(name, direction, reliable, messagesPerSecond, arguments, form);
  }

  /** Returns this kind with one more argument, an integer min..max, inclusive. */
  public MessageKind count(String argument, int min, int max) {
    return with(Argument.count(argument, min, max));
  }

  /** Returns this kind with one more argument, true or false. */
  public MessageKind flag(String argument) {
    return with(Argument.flag(argument));
  }

  /** Returns this kind with one more argument, a number min..max, inclusive. */
  public MessageKind real(String argument, float min, float max) {
    return with(Argument.real(argument, min, max));
  }

  /** Returns this kind with one more argument, a constant of an enum. */
  public <E extends Enum<E>> MessageKind choice(String argument, Class<E> type) {
    return with(Argument.choice(argument, type));
  }

  /** Returns this kind with one more argument, a text of at most so many characters. */
  public MessageKind text(String argument, int maxLength) {
    return with(Argument.text(argument, maxLength));
  }

  /** Returns this kind with one more argument, the id of a player, or -1. */
  public MessageKind player(String argument) {
    return with(Argument.player(argument));
  }

  /** Returns this kind with one more argument, the id of an entity, or -1. */
  public MessageKind entity(String argument) {
    return with(Argument.entity(argument));
  }

  private MessageKind with(Argument argument) {
    for (Argument other : arguments) {
      if (other.name().equals(argument.name())) {
        throw refused("has two arguments " + argument.name() + "; rename one");
      }
    }
    if (arguments.size() == MAX_ARGUMENTS) {
      throw refused("has more than " + MAX_ARGUMENTS + " arguments");
    }
    List<Argument> more = new ArrayList<>(arguments);
    more.add(argument);
    return new MessageKind(name, direction, reliable, perSecond, List.copyOf(more), null);
  }

  /**
   * Returns a message of this kind. Characters that can't be shown are removed from texts.
   *
   * @param values one for each argument, in the order of the declaration: Integer, Boolean, Float,
   *     a constant, String; the Integer of a player or entity is its id
   * @throws IllegalArgumentException when a value is missing, of another type or out of range
   */
  public Message of(Object... values) {
    if (Limits.notNull("values", values).length != arguments.size()) {
      throw refused("takes arguments=" + arguments.size() + ", not " + values.length);
    }
    Message message = new Message(this);
    for (int i = 0; i < values.length; i++) {
      try {
        arguments.get(i).set(message, i, values[i]);
      } catch (IllegalArgumentException e) {
        throw refused(e.getMessage());
      }
    }
    return message;
  }

  /**
   * Returns a message with the values of a record.
   *
   * @param values of the record by which the kind was declared
   * @throws IllegalArgumentException when it is another class, or a value is out of range
   */
  public Message of(Record values) {
    Limits.notNull("values", values);
    if (form == null || form.type() != values.getClass()) {
      throw refused("isn't declared by " + values.getClass().getSimpleName());
    }
    return of(form.values(values));
  }

  /** Returns the record by which the kind was declared, or null. */
  RecordForm form() {
    return form;
  }

  /**
   * Returns a message whose values come from outside by the names of their arguments.
   *
   * @param values a Number for a count, a real or an id, a Boolean, a String for a text, the name
   *     of a constant for a choice; others are ignored
   * @return the message, or null when a value is missing, of another type or out of range
   */
  public Message parse(Map<String, ?> values) {
    Message message = new Message(this);
    for (int i = 0; i < arguments.size(); i++) {
      if (!arguments.get(i).parse(message, i, values.get(arguments.get(i).name()))) {
        return null;
      }
    }
    return message;
  }

  /** Returns the name. */
  public String name() {
    return name;
  }

  /** Returns who may send it. */
  public Direction direction() {
    return direction;
  }

  /** Returns whether messages of this kind come from there. */
  public boolean comesFrom(Direction from) {
    return direction.allows(from);
  }

  /** Returns each argument with its range, such as {@code item count 0..31}. */
  public List<String> argumentLines() {
    List<String> lines = new ArrayList<>();
    arguments.forEach(argument -> lines.add(argument.toString()));
    return lines;
  }

  /** Returns whether each message arrives, in order. */
  public boolean isReliable() {
    return reliable;
  }

  /** Returns how many messages a second one client may send, in the long run. */
  public int perSecond() {
    return perSecond;
  }

  /** Returns the size of the largest message, in bytes. */
  public int maxBytes() {
    return maxBytes;
  }

  /** Returns the arguments, in their order. */
  public List<Argument> arguments() {
    return arguments;
  }

  int indexOf(String argument) {
    for (int i = 0; i < arguments.size(); i++) {
      if (arguments.get(i).name().equals(argument)) {
        return i;
      }
    }
    throw refused("has no argument " + argument + "; it has " + arguments);
  }

  IllegalArgumentException refused(String why) {
    return new IllegalArgumentException("message kind " + name + " " + why);
  }

  /** Returns everything that client and server must agree on, in one line. */
  @Override
  public String toString() {
    return name + " " + direction + (reliable ? " reliable " : " unreliable ") + arguments;
  }
}
