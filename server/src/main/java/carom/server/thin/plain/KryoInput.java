package carom.server.thin.plain;

/**
 * Reads bytes as Kryo 2.24 writes them with its default serializers. Nothing throws: what is
 * missing or out of bounds reads as nothing, and {@link #problem} says what was wrong first. One
 * thread.
 */
final class KryoInput {
  private byte[] bytes;
  private int position;
  private int end;
  private String problem;
  private final StringBuilder text = new StringBuilder();

  /** Begins to read. */
  void begin(byte[] source, int from, int to) {
    bytes = source;
    position = from;
    end = to;
    problem = null;
  }

  /** Returns what is wrong with the bytes, or null. */
  String problem() {
    return problem;
  }

  int remaining() {
    return end - position;
  }

  /** Notes that the bytes are wrong, unless they were before. */
  void fail(String what) {
    if (problem == null) {
      problem = what;
    }
    position = end;
  }

  int read() {
    if (position >= end) {
      fail("it ends early");
      return 0;
    }
    return bytes[position++] & 0xff;
  }

  private int fixed(int count) {
    int value = 0;
    for (int i = 0; i < count; i++) {
      value = value << 8 | read();
    }
    return value;
  }

  float real() {
    return Float.intBitsToFloat(fixed(4));
  }

  double longReal() {
    long high = fixed(4);
    return Double.longBitsToDouble(high << 32 | fixed(4) & 0xffffffffL);
  }

  int shortWhole() {
    return (short) fixed(2);
  }

  char unit() {
    return (char) fixed(2);
  }

  /** Reads a length or class number. */
  int count() {
    int value = 0;
    for (int shift = 0; shift < 35; shift += 7) {
      int next = read();
      value |= (next & 0x7f) << shift;
      if ((next & 0x80) == 0) {
        return value;
      }
    }
    fail("a number has more than 5 bytes");
    return 0;
  }

  /** Reads an int field. */
  int whole() {
    int value = count();
    return value >>> 1 ^ -(value & 1);
  }

  /** Reads a long field. */
  long longWhole() {
    long value = 0;
    for (int i = 0; i < 9; i++) {
      long next = read();
      value |= (i == 8 ? next : next & 0x7f) << 7 * i;
      if ((next & 0x80) == 0) {
        break;
      }
    }
    return value >>> 1 ^ -(value & 1);
  }

  boolean flag() {
    int value = read();
    if (value > 1) {
      fail("boolean=" + value);
    }
    return value == 1;
  }

  /**
   * Reads a text.
   *
   * @param most characters that it may have
   * @return null for null
   */
  String text(int most) {
    int first = read();
    text.setLength(0);
    if ((first & 0x80) == 0) {
      return plainText(first, most);
    }
    int characters = first & 0x3f;
    if ((first & 0x40) != 0) {
      int more = count();
      if (more > most >> 6) {
        fail("a text has more than " + most + " characters");
        return "";
      }
      characters |= more << 6;
    }
    if (characters == 0) {
      return null;
    }
    if (characters - 1 > Math.min(most, remaining())) {
      fail("a text has more than " + most + " characters, or ends early");
      return "";
    }
    for (int i = 1; i < characters; i++) {
      text.append(character());
    }
    return text.toString();
  }

  /** Reads a text of ASCII, whose last byte has the highest bit. */
  private String plainText(int first, int most) {
    int next = first;
    while (problem == null) {
      text.append((char) (next & 0x7f));
      if ((next & 0x80) != 0) {
        return text.toString();
      }
      if (text.length() >= most) {
        fail("a text has more than " + most + " characters");
      }
      next = read();
    }
    return "";
  }

  private char character() {
    int first = read();
    if (first < 0x80) {
      return (char) first;
    }
    if (first >> 5 == 6) {
      return (char) ((first & 0x1f) << 6 | read() & 0x3f);
    }
    if (first >> 4 == 14) {
      int second = read();
      return (char) ((first & 0xf) << 12 | (second & 0x3f) << 6 | read() & 0x3f);
    }
    fail("a text has the byte " + first);
    return ' ';
  }

  /**
   * Reads the length of an array.
   *
   * @param most elements that it may have
   * @return 0 for null
   */
  int length(int most) {
    int value = count() - 1;
    if (value > most) {
      fail("an array has " + value + " elements, more than " + most);
    }
    return problem == null ? Math.max(0, value) : 0;
  }

  /** Returns whether an element that may be null is there. */
  boolean isThere() {
    return flag();
  }
}
