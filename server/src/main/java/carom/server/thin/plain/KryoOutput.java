package carom.server.thin.plain;

import java.util.Arrays;

/**
 * Bytes as Kryo 2.24 writes them with its default serializers. It grows as needed. One thread at a
 * time.
 */
final class KryoOutput {
  private static final int INITIAL_BYTES = 256;

  private byte[] bytes = new byte[INITIAL_BYTES];
  private int length;

  byte[] bytes() {
    return bytes;
  }

  int length() {
    return length;
  }

  /** Shortens it to its first bytes. */
  void truncate(int newLength) {
    length = newLength;
  }

  /** Removes the first bytes. */
  void drop(int count) {
    System.arraycopy(bytes, count, bytes, 0, length - count);
    length -= count;
    if (length == 0 && bytes.length > 1 << 16) {
      bytes = new byte[INITIAL_BYTES]; // a level's worth isn't kept for the rest of a match
    }
  }

  void write(int value) {
    if (length == bytes.length) {
      bytes = Arrays.copyOf(bytes, 2 * length);
    }
    bytes[length++] = (byte) value;
  }

  void write(byte[] source, int offset, int count) {
    if (length + count > bytes.length) {
      bytes = Arrays.copyOf(bytes, Math.max(length + count, 2 * bytes.length));
    }
    System.arraycopy(source, offset, bytes, length, count);
    length += count;
  }

  /** Writes four bytes, the highest first. */
  void fixed(int value) {
    write(value >> 24);
    write(value >> 16);
    write(value >> 8);
    write(value);
  }

  /** Writes four bytes at a place that is there already. */
  void fixedAt(int place, int value) {
    bytes[place] = (byte) (value >> 24);
    bytes[place + 1] = (byte) (value >> 16);
    bytes[place + 2] = (byte) (value >> 8);
    bytes[place + 3] = (byte) value;
  }

  void real(float value) {
    fixed(Float.floatToRawIntBits(value));
  }

  /** Writes lengths and class numbers: seven bits a byte, the lowest first. */
  void count(int value) {
    int rest = value;
    while ((rest & ~0x7f) != 0) {
      write(rest & 0x7f | 0x80);
      rest >>>= 7;
    }
    write(rest);
  }

  /** Writes an int field: small numbers of either sign are short. */
  void whole(int value) {
    count(value << 1 ^ value >> 31);
  }

  /** Writes a long field. */
  void whole(long value) {
    long rest = value << 1 ^ value >> 63;
    for (int i = 0; i < 8 && (rest & ~0x7fL) != 0; i++) {
      write((int) (rest & 0x7f | 0x80));
      rest >>>= 7;
    }
    write((int) rest); // the ninth byte has eight bits
  }

  void flag(boolean value) {
    write(value ? 1 : 0);
  }

  /** Writes a text: its length and one plus that, and each UTF-16 unit in one to three bytes. */
  void text(String value) {
    int characters = value.length() + 1;
    if (characters >>> 6 == 0) {
      write(0x80 | characters);
    } else {
      write(0xc0 | characters & 0x3f);
      count(characters >>> 6);
    }
    for (int i = 0; i < value.length(); i++) {
      char c = value.charAt(i);
      if (c < 0x80) {
        write(c);
      } else if (c < 0x800) {
        write(0xc0 | c >> 6);
        write(0x80 | c & 0x3f);
      } else {
        write(0xe0 | c >> 12);
        write(0x80 | c >> 6 & 0x3f);
        write(0x80 | c & 0x3f);
      }
    }
  }

  /** Returns the bytes that {@link #whole(int)} takes. */
  static int sizeOf(int value) {
    int bits = 32 - Integer.numberOfLeadingZeros(value << 1 ^ value >> 31 | 1);
    return (bits + 6) / 7;
  }
}
