package carom.net.snapshot.table;

import carom.net.codec.BitPass;

/**
 * The table section, described once for writing and reading: {@link #begin}, then {@link #next} and
 * the words of each row, and once more {@code next} for the end. Reads any bits without harm. One
 * object codes one section at a time.
 */
final class TableCodec {
  /** Bits of the section's end. */
  static final int END_BITS = 1;

  /** Largest number of tables. */
  static final int MAX_TABLES = 16;

  private static final int TABLE_BITS = 4;
  private static final int KEY_BITS = 16;
  private static final int CLOSE_BITS = 4;
  private static final int GROUP = 8;
  private static final int AGE_BITS = 6;
  private static final int MAX_AGE = (1 << AGE_BITS) - 1;

  private final TableLayout[] layouts;
  private int nextKey;

  /** Place of the row's table in the list of tables. */
  int table;

  /** Key of the row. */
  int key;

  /** True if the row doesn't build on what the client has acked. */
  boolean whole;

  /** True if a whole row exists; if not, the key is empty. */
  boolean present;

  /** Identity of a whole row that exists. */
  int identity;

  /** The words that follow: bit i for word i. */
  long mask;

  /** Ticks since the row changed, of an urgent table; 0 of others. */
  int age;

  TableCodec(TableLayout[] layouts) {
    this.layouts = layouts;
  }

  /** Begins a section. */
  void begin() {
    table = 0;
    nextKey = 0;
  }

  /**
   * Codes all of the next row but its words, or the end of the section.
   *
   * @param more whether there is another row, which the fields describe; a reader fills them
   * @return whether a row was coded; a reader answers false, too, after bits that make no sense
   */
  boolean next(BitPass c, boolean more, int rowTable) {
    if (!c.flag(more)) {
      return false;
    }
    if (!c.flag(rowTable == table)) {
      table = c.plain(rowTable, TABLE_BITS);
      nextKey = 0;
    }
    int close = key - nextKey;
    key =
        c.flag(close >= 0 && close < 1 << CLOSE_BITS)
            ? nextKey + c.plain(close, CLOSE_BITS)
            : c.plain(key, KEY_BITS);
    nextKey = key + 1;
    if (!c.require(table < layouts.length && key < layouts[table].keys())) {
      return false;
    }
    TableLayout layout = layouts[table];
    whole = c.flag(whole);
    present = !whole || !layout.startsEmpty() || c.flag(present);
    identity = whole && present ? c.plain(identity, layout.identityBits()) : 0;
    mask = present ? mask(c, layout.width(), mask) : 0;
    age = layout.isUrgent() ? c.plain(Math.min(age, MAX_AGE), AGE_BITS) : 0;
    return true;
  }

  private static long mask(BitPass c, int words, long mask) {
    long result = 0;
    for (int from = 0; from < words; from += GROUP) {
      int count = Math.min(GROUP, words - from);
      int some = (int) (mask >>> from) & (1 << count) - 1;
      if (c.flag(some != 0)) {
        result |= (long) c.plain(some, count) << from;
      }
    }
    return result;
  }

  /** Codes a word of the row. */
  int word(BitPass c, int word, int value) {
    TableLayout layout = layouts[table];
    int least = layout.least(key, word);
    return least + c.plain(value - least, layout.bits(key, word));
  }

  /** Returns the most bits that the row takes in a table, with its words. */
  int mostBits(int rowTable) {
    TableLayout layout = layouts[rowTable];
    int bits = 1 + 1 + TABLE_BITS + 1 + KEY_BITS + 2 + layout.identityBits() + AGE_BITS;
    bits += (layout.width() + GROUP - 1) / GROUP + layout.width();
    for (long rest = mask; rest != 0; rest &= rest - 1) {
      bits += layout.bits(key, Long.numberOfTrailingZeros(rest));
    }
    return bits;
  }
}
