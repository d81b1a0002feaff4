package carom.sim.message;

import carom.physics.math.Limits;
import carom.sim.message.MessageKind.Direction;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * The kinds of messages of one simulation, in the order they were added: the {@link BuiltInKinds}
 * first. Server and client add the same kinds in the same order. No kind can be added after set-up.
 * One thread.
 */
public final class MessageKinds {
  /** Most kinds. An index fits 8 bits. */
  public static final int MAX = 256;

  private final List<MessageKind> list = new ArrayList<>(BuiltInKinds.ALL);
  private final MessageBytes coder = new MessageBytes();
  private final byte[] buffer = new byte[MessageKind.MAX_BYTES];
  private boolean closed;

  /** Creates a list of the built-in kinds. */
  public MessageKinds() {}

  /**
   * Registers a kind. Call it in {@code Game.setUp} only.
   *
   * @return the kind
   * @throws IllegalStateException after set-up, or beyond {@value #MAX}
   * @throws IllegalArgumentException when there is a kind of this name
   */
  public MessageKind add(MessageKind kind) {
    Limits.notNull("kind", kind);
    if (closed) {
      throw new IllegalStateException(
          "message kind " + kind.name() + " is registered after set-up; register it in Game.setUp");
    }
    if (list.size() == MAX) {
      throw new IllegalStateException(
          "message kind " + kind.name() + " exceeds the limit of " + MAX);
    }
    for (MessageKind other : list) {
      if (other.name().equals(kind.name())) {
        throw kind.refused("is registered already; names are unique");
      }
    }
    list.add(kind);
    return kind;
  }

  /** Closes the list: no kind can be added any more. */
  public void close() {
    closed = true;
  }

  /** Returns the number of kinds. */
  public int size() {
    return list.size();
  }

  /** Returns the kind at an index, or null if there is none. The index may come from the wire. */
  public MessageKind get(int index) {
    return index >= 0 && index < list.size() ? list.get(index) : null;
  }

  /** Returns the kind of a name, or null. */
  public MessageKind find(String name) {
    for (MessageKind kind : list) {
      if (kind.name().equals(name)) {
        return kind;
      }
    }
    return null;
  }

  /** Returns the game's own kinds, in their order. */
  public List<MessageKind> own() {
    return List.copyOf(list.subList(BuiltInKinds.ALL.size(), list.size()));
  }

  /**
   * Returns the index of a kind, 0..255, which the wire carries.
   *
   * @throws IllegalArgumentException when the kind isn't registered
   */
  @SuppressWarnings("ReferenceEquality") // a kind is declared once
  public int indexOf(MessageKind kind) {
    for (int i = 0; i < list.size(); i++) {
      if (list.get(i) == kind) {
        return i;
      }
    }
    throw kind.refused("isn't registered; add it in Game.setUp: s.messageKinds().add(...)");
  }

  /**
   * Returns the index of a kind that comes from there.
   *
   * @throws IllegalArgumentException when the kind isn't registered, or doesn't come from there
   */
  public int indexOf(MessageKind kind, Direction from) {
    if (!kind.direction().allows(from)) {
      throw kind.refused("is " + kind.direction() + ", not " + from);
    }
    return indexOf(kind);
  }

  /**
   * Returns a message as bytes.
   *
   * @throws IllegalArgumentException when its kind isn't registered, or doesn't come from there
   */
  public byte[] encode(Message message, Direction from) {
    int index = indexOf(message.kind(), from);
    return Arrays.copyOf(buffer, coder.write(message, index, buffer, 0));
  }

  /**
   * Reads one message. The bytes may be anything.
   *
   * @param from where they come from
   * @return the message, or null when the bytes aren't exactly one valid message from there
   */
  public Message decode(byte[] bytes, int offset, int length, Direction from) {
    coder.begin(bytes, offset, length);
    MessageKind kind = get(coder.next());
    if (kind == null || !kind.direction().allows(from)) {
      return null;
    }
    Message message = coder.read(kind);
    return message != null && coder.isEmpty() ? message : null;
  }

  /**
   * Returns the declarations of the game's own kinds, in their order: a line for each, {@code buy
   * FROM_CLIENT reliable}, and one for each of its arguments, {@code buy.item count 0..31}.
   */
  public List<String> lines() {
    List<String> lines = new ArrayList<>();
    for (MessageKind kind : list.subList(BuiltInKinds.ALL.size(), list.size())) {
      String name = kind.name().replace(' ', '_');
      lines.add(name + " " + kind.direction() + (kind.isReliable() ? " reliable" : " unreliable"));
      kind.arguments().forEach(argument -> lines.add(name + "." + argument));
    }
    return lines;
  }

  /** Returns a hash of all kinds and their order, on which client and server must agree. */
  public long digest() {
    long hash = 0xcbf29ce484222325L; // FNV-1a
    for (MessageKind kind : list) {
      String text = kind + "\n";
      for (int i = 0; i < text.length(); i++) {
        hash = (hash ^ text.charAt(i)) * 0x100000001b3L;
      }
    }
    return hash;
  }
}
