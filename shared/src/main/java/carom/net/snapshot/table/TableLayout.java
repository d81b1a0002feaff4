package carom.net.snapshot.table;

import java.util.Arrays;

/**
 * The shape of a replicated table: how many keys it has, the width and start value of each word of
 * a row, and which words each class of audience may know. Server and client must have equal
 * layouts. Immutable.
 */
public final class TableLayout {
  /** Largest number of words in a row. */
  public static final int MAX_WORDS = 64;

  /** Largest number of keys. */
  public static final int MAX_KEYS = 65_535;

  /** Number of classes of audience; class 0 may know nothing. */
  public static final int AUDIENCES = 16;

  private final int keys;
  private final int identityBits;
  private final boolean startsEmpty;
  private final int[] bits;
  private final int[] least;
  private final int[] start;
  private final long[] audiences;
  private final boolean urgent;

  /**
   * Creates a layout. The arrays are copied.
   *
   * @param keys number of keys, 1..{@value #MAX_KEYS}; a key is 0..keys - 1
   * @param identityBits bits that tell successive users of a key apart, 0..16
   * @param startsEmpty whether a key has no row until one is put; otherwise every key has a row of
   *     start values from the beginning
   * @param bits width of each word, 1..32; their number is at most {@value #MAX_WORDS}
   * @param least smallest value of each word: it is sent as what exceeds this, in its width
   * @param start value of each word at the start
   * @param audiences by class from 0 on: bit i is set if the class may know word i; at most {@value
   *     #AUDIENCES} classes, of which class 0 may know nothing
   * @throws IllegalArgumentException if a number is outside its range
   */
  public TableLayout(
      int keys,
      int identityBits,
      boolean startsEmpty,
      int[] bits,
      int[] least,
      int[] start,
      long[] audiences) {
    check(keys >= 1 && keys <= MAX_KEYS, "keys", keys, "1.." + MAX_KEYS);
    check(identityBits >= 0 && identityBits <= 16, "identityBits", identityBits, "0..16");
    check(bits.length <= MAX_WORDS, "words", bits.length, "0.." + MAX_WORDS);
    check(least.length == bits.length, "least.length", least.length, "" + bits.length);
    check(start.length == bits.length, "start.length", start.length, "" + bits.length);
    int classes = audiences.length;
    check(classes >= 1 && classes <= AUDIENCES, "audiences", classes, "1.." + AUDIENCES);
    check(audiences[0] == 0, "audiences[0]", audiences[0], "0");
    for (int width : bits) {
      check(width >= 1 && width <= Integer.SIZE, "bits", width, "1..32");
    }
    this.keys = keys;
    this.identityBits = identityBits;
    this.startsEmpty = startsEmpty;
    this.bits = bits.clone();
    this.least = least.clone();
    this.start = start.clone();
    this.audiences = Arrays.copyOf(audiences, AUDIENCES);
    urgent = false;
  }

  private TableLayout(TableLayout of, boolean urgent) {
    keys = of.keys;
    identityBits = of.identityBits;
    startsEmpty = of.startsEmpty;
    bits = of.bits;
    least = of.least;
    start = of.start;
    audiences = of.audiences;
    this.urgent = urgent;
  }

  /**
   * Returns the same layout for a table that prediction depends on. A row that changed is in every
   * snapshot until it is acked, so that each datagram tells the state at its tick.
   */
  public TableLayout urgent() {
    return new TableLayout(this, true);
  }

  private static void check(boolean holds, String name, long value, String range) {
    if (!holds) {
      throw new IllegalArgumentException(name + "=" + value + " is outside " + range);
    }
  }

  /** Returns the number of keys. */
  public int keys() {
    return keys;
  }

  /** Returns the number of words in a row. */
  public int words() {
    return bits.length;
  }

  /** Returns the number of bits that tell successive users of a key apart. */
  int identityBits() {
    return identityBits;
  }

  /** Returns whether a key has no row until one is put. */
  boolean startsEmpty() {
    return startsEmpty;
  }

  /** Returns whether a row that changed is in every snapshot until it is acked. */
  boolean isUrgent() {
    return urgent;
  }

  /** Returns the width of a word. */
  int bits(int word) {
    return bits[word];
  }

  /** Returns the smallest value of a word. */
  int least(int word) {
    return least[word];
  }

  /** Returns the value of a word at the start, unless the key has a start of its own. */
  int start(int word) {
    return start[word];
  }

  /** Returns the words that a class of audience may know: bit i for word i. */
  long words(int audience) {
    return audiences[audience];
  }
}
