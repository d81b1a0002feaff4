package carom.server.thin.web;

import java.nio.ByteBuffer;
import java.util.Arrays;

/** Bytes that grow, written one after the other and kept from message to message. One thread. */
final class Bytes {
  private byte[] bytes = new byte[512];
  private int length;

  /** Empties them. */
  void clear() {
    length = 0;
  }

  int length() {
    return length;
  }

  /** Returns the bytes for one who reads them before they are written again. */
  ByteBuffer view() {
    return ByteBuffer.wrap(bytes, 0, length);
  }

  /** Returns a copy of the bytes. */
  byte[] toArray() {
    return Arrays.copyOf(bytes, length);
  }

  private void need(int more) {
    if (length + more > bytes.length) {
      bytes = Arrays.copyOf(bytes, Math.max(length + more, 2 * bytes.length));
    }
  }

  /** Writes a byte. */
  Bytes put(int value) {
    need(1);
    bytes[length++] = (byte) value;
    return this;
  }

  /** Writes bytes. */
  Bytes put(byte[] some) {
    need(some.length);
    System.arraycopy(some, 0, bytes, length, some.length);
    length += some.length;
    return this;
  }

  /** Writes seven bits a byte, the lowest first; the highest bit says that another byte follows. */
  Bytes varint(int value) {
    int rest = value;
    while ((rest & ~0x7f) != 0) {
      put(rest & 0x7f | 0x80);
      rest >>>= 7;
    }
    return put(rest);
  }

  /** Writes a number of either sign as a varint: 0, -1, 1, -2, 2 become 0, 1, 2, 3, 4. */
  Bytes signed(int value) {
    return varint(value << 1 ^ value >> 31);
  }

  /** Writes characters below 128. */
  Bytes ascii(String text) {
    need(text.length());
    for (int i = 0; i < text.length(); i++) {
      bytes[length++] = (byte) text.charAt(i);
    }
    return this;
  }

  /** Writes a number in decimal. */
  Bytes number(long value) {
    if (value < 0) {
      put('-');
      return number(-value);
    }
    int begin = length;
    long rest = value;
    do {
      put((int) ('0' + rest % 10));
      rest /= 10;
    } while (rest > 0);
    for (int i = begin, j = length - 1; i < j; i++, j--) {
      byte swapped = bytes[i];
      bytes[i] = bytes[j];
      bytes[j] = swapped;
    }
    return this;
  }

  /** Writes a number of thousandths with at most three decimals, such as {@code -0.5}. */
  Bytes thousandths(long value) {
    long size = Math.abs(value);
    if (value < 0) {
      put('-');
    }
    number(size / 1_000);
    int rest = (int) (size % 1_000);
    if (rest > 0) {
      put('.').put('0' + rest / 100);
      if (rest % 100 > 0) {
        put('0' + rest / 10 % 10);
        if (rest % 10 > 0) {
          put('0' + rest % 10);
        }
      }
    }
    return this;
  }
}
