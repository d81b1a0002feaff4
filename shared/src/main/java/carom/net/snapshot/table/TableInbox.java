package carom.net.snapshot.table;

import carom.net.codec.BitReader;
import java.util.Arrays;

/**
 * Receives the rows of a server's tables: each key has the words of the newest tick that any
 * datagram told. One client's; one thread. Any bits are read without harm; allocates only to grow
 * with the highest key and the longest section.
 */
public final class TableInbox {
  private static final int FIRST_ROWS = 16;
  private static final int FIRST_WORDS = 64;
  private static final int UNKNOWN = -1;

  private final TableLayout[] layouts;
  private final TableRows[] rows;

  /** By table and key: the tick that the row is of. */
  private final int[][] ticks;

  /** By table and key: the tick of the row's last change, as far as the server told. */
  private final int[][] changedTicks;

  /** By table: how many rows were taken. */
  private final int[] changes;

  // A datagram is read into these first and counts only when all of it was good.
  private final TableCodec codec;
  private int readRows;
  private int[] readTable = new int[FIRST_ROWS];
  private int[] readKey = new int[FIRST_ROWS];
  private int[] readIdentity = new int[FIRST_ROWS];
  private boolean[] readWhole = new boolean[FIRST_ROWS];
  private boolean[] readPresent = new boolean[FIRST_ROWS];
  private long[] readMask = new long[FIRST_ROWS];
  private int[] readAge = new int[FIRST_ROWS];
  private int readWords;
  private int[] words = new int[FIRST_WORDS];

  /**
   * Creates an inbox in which every row is as at the start.
   *
   * @param layouts the tables' shapes, in the server's order
   */
  public TableInbox(TableLayout... layouts) {
    this.layouts = layouts.clone();
    codec = new TableCodec(this.layouts);
    rows = new TableRows[layouts.length];
    ticks = new int[layouts.length][0];
    changedTicks = new int[layouts.length][0];
    changes = new int[layouts.length];
    for (int i = 0; i < rows.length; i++) {
      rows[i] = new TableRows(layouts[i]);
    }
  }

  /**
   * Gives a key a row of its own to start with, before the first datagram; see {@link Table#place}.
   *
   * @param table its place in the list of tables
   */
  public void place(int table, int key, int identity, int[] from, int at) {
    rows[table].place(key, identity, from, at);
  }

  /** Reads the table section of a datagram; the reader fails when it makes no sense. */
  public void read(BitReader r) {
    readRows = 0;
    readWords = 0;
    codec.begin();
    while (codec.next(r, false, 0)) {
      if (readRows == readTable.length) {
        growRows();
      }
      readTable[readRows] = codec.table;
      readKey[readRows] = codec.key;
      readIdentity[readRows] = codec.identity;
      readWhole[readRows] = codec.whole;
      readPresent[readRows] = codec.present;
      readMask[readRows] = codec.mask;
      readAge[readRows] = codec.age;
      readRows++;
      if (words.length < readWords + TableLayout.ROW_WORDS) {
        words = Arrays.copyOf(words, 2 * words.length);
      }
      for (long rest = codec.mask; rest != 0; rest &= rest - 1) {
        words[readWords++] = codec.word(r, Long.numberOfTrailingZeros(rest), 0);
      }
    }
  }

  private void growRows() {
    int length = 2 * readRows;
    readTable = Arrays.copyOf(readTable, length);
    readKey = Arrays.copyOf(readKey, length);
    readIdentity = Arrays.copyOf(readIdentity, length);
    readWhole = Arrays.copyOf(readWhole, length);
    readPresent = Arrays.copyOf(readPresent, length);
    readMask = Arrays.copyOf(readMask, length);
    readAge = Arrays.copyOf(readAge, length);
  }

  /**
   * Accepts what was read last: the whole datagram was good. A row that is older than what is known
   * of its key is passed over.
   */
  public void keep(int tick) {
    int word = 0;
    for (int i = 0; i < readRows; i++) {
      take(i, word, tick);
      word += Long.bitCount(readMask[i]);
    }
  }

  private void take(int i, int firstWord, int tick) {
    int key = readKey[i];
    TableRows of = rows[readTable[i]];
    ensure(readTable[i], key);
    int[] known = ticks[readTable[i]];
    if (tick <= known[key] || !readWhole[i] && !of.isPresent(key)) {
      return;
    }
    known[key] = tick;
    changedTicks[readTable[i]][key] = tick - readAge[i];
    changes[readTable[i]]++;
    if (readWhole[i]) {
      of.setPresent(key, readPresent[i]);
      of.setIdentity(key, readIdentity[i]);
      of.wordsToStart(key);
    }
    int at = firstWord;
    for (long rest = readMask[i]; rest != 0; rest &= rest - 1) {
      of.set(key, Long.numberOfTrailingZeros(rest), words[at++]);
    }
  }

  private void ensure(int table, int key) {
    rows[table].ensure(key);
    int old = ticks[table].length;
    if (old < rows[table].room()) {
      ticks[table] = Arrays.copyOf(ticks[table], rows[table].room());
      Arrays.fill(ticks[table], old, ticks[table].length, UNKNOWN);
      changedTicks[table] = Arrays.copyOf(changedTicks[table], ticks[table].length);
    }
  }

  /** Returns the layout of a table. */
  public TableLayout layout(int table) {
    return layouts[table];
  }

  /** Returns how many rows the last datagram that was read had. */
  public int touchedCount() {
    return readRows;
  }

  /** Returns the table of a row of the last datagram; index 0..touchedCount - 1. */
  public int touchedTable(int index) {
    return readTable[index];
  }

  /** Returns the key of a row of the last datagram; index 0..touchedCount - 1. */
  public int touchedKey(int index) {
    return readKey[index];
  }

  /** Returns one more than the highest key that the server has told of, or a little more. */
  public int room(int table) {
    return rows[table].room();
  }

  /** Returns whether a key has a row. */
  public boolean isPresent(int table, int key) {
    return rows[table].isPresent(key);
  }

  /** Returns the identity of a key's user, as of the row's {@link #tick}. */
  public int identity(int table, int key) {
    return rows[table].identity(key);
  }

  /** Returns the newest tick of which the server told a row; -1 if it never did. */
  public int tick(int table, int key) {
    return key < ticks[table].length ? ticks[table][key] : UNKNOWN;
  }

  /** Returns the last tick at which a row changed, if its table is urgent; else {@link #tick}. */
  public int changedTick(int table, int key) {
    return tick(table, key) == UNKNOWN ? UNKNOWN : changedTicks[table][key];
  }

  /** Returns how many rows of a table were taken: it grows when anything may have changed. */
  public int changes(int table) {
    return changes[table];
  }

  /** Returns a word of a key's row. */
  public int get(int table, int key, int word) {
    return rows[table].get(key, word);
  }

  /**
   * Returns a word of the row of one user of a key. Without a row of that user, it is what the word
   * is at the start.
   */
  public int get(int table, int key, int identity, int word) {
    return rows[table].identity(key) == identity
        ? rows[table].get(key, word)
        : rows[table].start(key, word);
  }
}
