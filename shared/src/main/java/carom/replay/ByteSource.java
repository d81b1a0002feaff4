package carom.replay;

import carom.text.Texts;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/**
 * Reader of what {@link ByteSink} wrote, safe on any bytes. It checks every read against the end.
 */
final class ByteSource {
  private byte[] bytes = {};
  private int at;
  private int end;

  void set(byte[] from, int length) {
    bytes = from;
    at = 0;
    end = length;
  }

  boolean isEmpty() {
    return at == end;
  }

  int u8() throws RecordingException {
    need(1);
    return bytes[at++] & 0xff;
  }

  int i32() throws RecordingException {
    need(4);
    int value = 0;
    for (int i = 0; i < 4; i++) {
      value = value << 8 | (bytes[at++] & 0xff);
    }
    return value;
  }

  long i64() throws RecordingException {
    long high = i32();
    return high << 32 | (i32() & 0xffffffffL);
  }

  long varint() throws RecordingException {
    long value = 0;
    for (int shift = 0; shift < 64; shift += 7) {
      int b = u8();
      value |= (long) (b & 0x7f) << shift;
      if ((b & 0x80) == 0) {
        return value;
      }
    }
    throw new RecordingException("damaged: a number is longer than 10 bytes");
  }

  int varint(String name, int min, int max) throws RecordingException {
    long value = varint();
    if (value < min || value > max) {
      throw new RecordingException(
          "damaged: " + name + "=" + value + " is outside " + min + ".." + max);
    }
    return (int) value;
  }

  /**
   * Returns a text as it may be shown: the author of a file can put escape sequences of a terminal
   * into it.
   */
  String text(String name, int maxBytes) throws RecordingException {
    int length = varint("bytes of " + name, 0, maxBytes);
    need(length);
    try {
      String text =
          StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(bytes, at, length)).toString();
      at += length;
      return Texts.clean(text);
    } catch (CharacterCodingException e) {
      throw new RecordingException("damaged: " + name + " is no UTF-8");
    }
  }

  int left() {
    return end - at;
  }

  byte[] bytes(int count) throws RecordingException {
    need(count);
    at += count;
    return Arrays.copyOfRange(bytes, at - count, at);
  }

  private void need(int count) throws RecordingException {
    if (end - at < count) {
      throw new RecordingException(
          "damaged: a block ends " + (count - (end - at)) + " bytes before its content does");
    }
  }
}
