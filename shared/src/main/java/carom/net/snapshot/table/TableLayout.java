package carom.net.snapshot.table;

import java.util.Arrays;

/**
 * The shape of a replicated table: how many targets it tells of, the width and start value of each
 * of a target's words, and which words each class of audience may know. Server and client must have
 * equal layouts. Immutable.
 *
 * <p>A target with more words than a row holds has several rows, its chunks. The key of a row is
 * its target's number times {@link #chunks}, plus the chunk.
 */
public final class TableLayout {
  /** Largest number of words in a row. */
  public static final int ROW_WORDS = 64;

  /** Largest number of keys: targets times chunks. */
  public static final int MAX_KEYS = 65_535;

  /** Number of classes of audience; class 0 may know nothing. */
  public static final int AUDIENCES = 16;

  private final int targets;
  private final int chunks;
  private final int width;
  private final int identityBits;
  private final boolean startsEmpty;
  private final boolean urgent;

  // Of all words of a target, filled up to whole rows.
  private final int[] bits;
  private final int[] least;
  private final int[] start;

  /** By chunk and class: the words that the class may know. */
  private final long[] known;

  /**
   * Creates a layout. The arrays are copied; each has a number for each word of a target.
   *
   * @param targets number of targets, from 1 on; with the chunks of each at most {@value #MAX_KEYS}
   *     keys
   * @param identityBits bits that tell successive users of a key apart, 0..16
   * @param startsEmpty whether a key has no row until one is put; otherwise every key has a row of
   *     start values from the beginning
   * @param bits width, 1..32
   * @param least smallest value: a word is sent as what exceeds this, in its width
   * @param start value at the start
   * @param audiences bit i is set if class i may know the word; bit 0 must be clear
   * @param urgent whether prediction depends on the table: a row that changed is in every snapshot
   *     until it is acked, so that each datagram tells the state at its tick
   * @throws IllegalArgumentException if a number is outside its range
   */
  public TableLayout(
      int targets,
      int identityBits,
      boolean startsEmpty,
      int[] bits,
      int[] least,
      int[] start,
      int[] audiences,
      boolean urgent) {
    int words = bits.length;
    chunks = Math.max(1, (words + ROW_WORDS - 1) / ROW_WORDS);
    width = Math.min(words, ROW_WORDS);
    long keys = (long) targets * chunks;
    check(keys >= 1 && keys <= MAX_KEYS, "keys", keys, "1.." + MAX_KEYS);
    check(identityBits >= 0 && identityBits <= 16, "identityBits", identityBits, "0..16");
    check(least.length == words, "least.length", least.length, "" + words);
    check(start.length == words, "start.length", start.length, "" + words);
    check(audiences.length == words, "audiences.length", audiences.length, "" + words);
    this.targets = targets;
    this.identityBits = identityBits;
    this.startsEmpty = startsEmpty;
    this.urgent = urgent;
    this.bits = new int[chunks * width];
    this.least = new int[chunks * width];
    this.start = new int[chunks * width];
    known = new long[chunks * AUDIENCES];
    Arrays.fill(this.bits, 1);
    for (int i = 0; i < words; i++) {
      check(bits[i] >= 1 && bits[i] <= Integer.SIZE, "bits", bits[i], "1..32");
      check((audiences[i] & ~0xfffe) == 0, "audiences", audiences[i], "bits 1..15");
      this.bits[i] = bits[i];
      this.least[i] = least[i];
      this.start[i] = start[i];
      for (int as = 0; as < AUDIENCES; as++) {
        known[i / ROW_WORDS * AUDIENCES + as] |= (long) (audiences[i] >>> as & 1) << i;
      }
    }
  }

  private static void check(boolean holds, String name, long value, String range) {
    if (!holds) {
      throw new IllegalArgumentException(name + "=" + value + " is outside " + range);
    }
  }

  /** Returns the number of keys. */
  public int keys() {
    return targets * chunks;
  }

  /** Returns the number of rows of a target. */
  public int chunks() {
    return chunks;
  }

  /** Returns the number of words in a row. */
  public int width() {
    return width;
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

  /** Returns the width of a word in bits. */
  int bits(int key, int word) {
    return bits[key % chunks * width + word];
  }

  /** Returns the smallest value of a word. */
  int least(int key, int word) {
    return least[key % chunks * width + word];
  }

  /** Returns the value of a word at the start, unless the key has a start of its own. */
  int start(int key, int word) {
    return start[key % chunks * width + word];
  }

  /** Returns the words of a row that a class of audience may know: bit i for word i. */
  long known(int key, int audience) {
    return known[key % chunks * AUDIENCES + audience];
  }
}
