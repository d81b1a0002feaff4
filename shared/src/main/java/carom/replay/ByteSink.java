package carom.replay;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/**
 * Growing array of big-endian numbers and varints. A varint has seven bits a byte, lowest bits
 * first.
 */
final class ByteSink {
  private byte[] bytes = new byte[1 << 12];
  private int length;

  byte[] array() {
    return bytes;
  }

  int length() {
    return length;
  }

  /** Drops everything from a position on. */
  void truncate(int to) {
    length = to;
  }

  void u8(int value) {
    ensure(1);
    bytes[length++] = (byte) value;
  }

  void i32(int value) {
    ensure(4);
    for (int shift = 24; shift >= 0; shift -= 8) {
      bytes[length++] = (byte) (value >>> shift);
    }
  }

  void i64(long value) {
    i32((int) (value >>> 32));
    i32((int) value);
  }

  /** Appends an unsigned number in 1 to 10 bytes. */
  void varint(long value) {
    ensure(10);
    long rest = value;
    while ((rest & ~0x7fL) != 0) {
      bytes[length++] = (byte) (rest | 0x80);
      rest >>>= 7;
    }
    bytes[length++] = (byte) rest;
  }

  void text(String text) {
    byte[] utf8 = text.getBytes(StandardCharsets.UTF_8);
    varint(utf8.length);
    bytes(utf8, utf8.length);
  }

  void bytes(byte[] from, int count) {
    bytes(from, 0, count);
  }

  void bytes(byte[] from, int at, int count) {
    ensure(count);
    System.arraycopy(from, at, bytes, length, count);
    length += count;
  }

  private void ensure(int more) {
    if (length + more > bytes.length) {
      bytes = Arrays.copyOf(bytes, Math.max(length + more, bytes.length * 2));
    }
  }
}
