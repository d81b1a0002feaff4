package carom.net.protocol;

import carom.net.codec.Sequence;

/**
 * The unreliable messages of one tick in a datagram, in either direction: its mark in a byte, a
 * sequence number, and each message with its length. Writing starts with {@link #clear}, reading
 * with {@link #decode}. A datagram that a newer one has overtaken is refused, so that each message
 * is heard at most once. One thread; allocates nothing but what {@link #next} returns.
 */
public final class MessageDatagram {
  private static final int HEAD = 1 + 2;

  private final byte[] bytes = new byte[ProtocolLimits.MAX_DATAGRAM_BYTES];
  private int length = HEAD;
  private int at;
  private byte mark = (byte) DatagramMark.ofMessages(0);
  private int sequence;
  private boolean heardAny;
  private int lastHeard;

  /** Creates a datagram without messages. */
  public MessageDatagram() {}

  /** Begins with a link or match: sets the epoch of its Welcome, and forgets what was heard. */
  public void begin(int epoch) {
    mark = (byte) DatagramMark.ofMessages(epoch);
    heardAny = false;
    sequence = 0;
    length = HEAD;
  }

  /** Adds a message; returns false when there is no room. */
  public boolean add(byte[] message) {
    if (length + 2 + message.length > bytes.length) {
      return false;
    }
    bytes[length++] = (byte) message.length;
    bytes[length++] = (byte) (message.length >>> 8);
    System.arraycopy(message, 0, bytes, length, message.length);
    length += message.length;
    return true;
  }

  /** Returns whether no message was added. */
  public boolean isEmpty() {
    return length == HEAD;
  }

  /** Completes the datagram: {@link #length} of {@link #bytes} are to be sent. */
  public void complete() {
    bytes[0] = mark;
    bytes[1] = (byte) sequence;
    bytes[2] = (byte) (sequence >>> 8);
    sequence = sequence + 1 & 0xffff;
  }

  /** Removes the messages. */
  public void clear() {
    length = HEAD;
  }

  /** Returns the bytes; the live array. */
  public byte[] bytes() {
    return bytes;
  }

  /** Returns how many bytes there are. */
  public int length() {
    return length;
  }

  /** Returns whether bytes that arrived are such a datagram of this epoch. */
  public boolean isOne(byte[] from, int count) {
    return count >= HEAD && from[0] == mark;
  }

  /**
   * Begins to read a datagram for which {@link #isOne} is true.
   *
   * @return false when it comes twice or too late
   */
  public boolean decode(byte[] from, int count) {
    int number = from[1] & 0xff | (from[2] & 0xff) << 8;
    if (heardAny && !Sequence.isNewer(number, lastHeard)) {
      return false;
    }
    heardAny = true;
    lastHeard = number;
    System.arraycopy(from, 0, bytes, 0, count);
    length = count;
    at = HEAD;
    return true;
  }

  /** Returns the next message, or null when there is none or the rest is cut off. */
  public byte[] next() {
    if (at + 2 > length) {
      return null;
    }
    int size = bytes[at] & 0xff | (bytes[at + 1] & 0xff) << 8;
    at += 2;
    if (size == 0 || size > length - at) {
      at = length;
      return null;
    }
    byte[] message = new byte[size];
    System.arraycopy(bytes, at, message, 0, size);
    at += size;
    return message;
  }
}
