package carom.sim.message;

import java.nio.charset.StandardCharsets;

/**
 * Writer and reader of messages as bytes. A message is the index of its kind, one byte, and its
 * arguments: a count or an id as varint of its distance from the least one, a flag or choice as one
 * byte, a real as four bytes, big-endian, and a text as varint length and UTF-8. A varint has 7
 * bits a byte, the lowest first. Reading is safe on any bytes.
 */
final class MessageBytes {
  private byte[] bytes;
  private int at;
  private int end;

  /** Returns how many bytes a number takes as a varint. */
  static int size(int value) {
    int size = 1;
    for (int rest = value >>> 7; rest != 0; rest >>>= 7) {
      size++;
    }
    return size;
  }

  /** Writes a message; returns its number of bytes. */
  int write(Message message, int index, byte[] out, int offset) {
    bytes = out;
    at = offset;
    bytes[at++] = (byte) index;
    for (int i = 0; i < message.numbers.length; i++) {
      Argument a = message.kind().arguments().get(i);
      switch (a.type()) {
        case COUNT, PLAYER, ENTITY -> varint(message.numbers[i] - a.min());
        case FLAG, CHOICE -> bytes[at++] = (byte) message.numbers[i];
        case REAL -> {
          for (int shift = 24; shift >= 0; shift -= 8) {
            bytes[at++] = (byte) (message.numbers[i] >>> shift);
          }
        }
        case TEXT -> {
          byte[] text = message.texts[i].getBytes(StandardCharsets.UTF_8);
          varint(text.length);
          System.arraycopy(text, 0, bytes, at, text.length);
          at += text.length;
        }
      }
    }
    return at - offset;
  }

  private void varint(int value) {
    int rest = value;
    for (; (rest & ~0x7f) != 0; rest >>>= 7) {
      bytes[at++] = (byte) (rest | 0x80);
    }
    bytes[at++] = (byte) rest;
  }

  /** Begins to read. */
  void begin(byte[] from, int offset, int length) {
    bytes = from;
    at = offset;
    end = offset + length;
  }

  /** Returns whether everything is read. */
  boolean isEmpty() {
    return at >= end;
  }

  /** Returns the next byte, 0..255, or -1 at the end. */
  int next() {
    return at < end ? bytes[at++] & 0xff : -1;
  }

  /** Reads the arguments of a kind. Returns null when they are cut off or out of range. */
  Message read(MessageKind kind) {
    Message message = new Message(kind);
    for (int i = 0; i < message.numbers.length; i++) {
      Argument a = kind.arguments().get(i);
      boolean fits =
          switch (a.type()) {
            case COUNT, PLAYER, ENTITY -> readCount(message, i, a);
            case FLAG, CHOICE -> a.takes(message, i, next());
            case REAL -> readReal(message, i, a);
            case TEXT -> readText(message, i, a);
          };
      if (!fits) {
        return null;
      }
    }
    return message;
  }

  private boolean readCount(Message message, int i, Argument a) {
    long distance = readVarint();
    return distance >= 0
        && distance <= (long) a.max() - a.min()
        && a.takes(message, i, (int) (a.min() + distance));
  }

  private boolean readReal(Message message, int i, Argument a) {
    if (end - at < Float.BYTES) {
      return false;
    }
    int bits = 0;
    for (int b = 0; b < Float.BYTES; b++) {
      bits = bits << 8 | bytes[at++] & 0xff;
    }
    return a.takes(message, i, bits);
  }

  private boolean readText(Message message, int i, Argument a) {
    long length = readVarint();
    if (length < 0 || length > end - at || length > a.maxBytes()) {
      return false;
    }
    String text = new String(bytes, at, (int) length, StandardCharsets.UTF_8);
    byte[] again = text.getBytes(StandardCharsets.UTF_8);
    boolean valid = again.length == length; // what is no UTF-8 comes back as other bytes
    for (int b = 0; valid && b < again.length; b++) {
      valid = again[b] == bytes[at + b];
    }
    at += (int) length;
    return valid && a.takes(message, i, text);
  }

  /** Returns an unsigned number of at most 32 bits, or -1 when there is none. */
  private long readVarint() {
    long value = 0;
    for (int shift = 0; shift < 35; shift += 7) {
      int b = next();
      if (b < 0) {
        return -1;
      }
      value |= (long) (b & 0x7f) << shift;
      if (b < 0x80) {
        return value;
      }
    }
    return -1;
  }
}
