package carom.net.snapshot.table;

import carom.net.snapshot.frame.SlotSet;
import java.util.Arrays;

/**
 * A replicated table at the server: the rows, and the tick at which each word changed last. One per
 * room and kind of state, shared by all sessions. One thread; allocates only to grow with the
 * highest key.
 */
public final class Table {
  private static final int NEVER = -1;

  private final TableLayout layout;
  private final int width;
  private final TableRows rows;

  /** Keys whose rows differ from the start. */
  private final SlotSet unlikeStart = new SlotSet();

  private int[] wordTicks = {};
  private int[] rowTicks = {};
  private int[] identityTicks = {};

  /** By 64 keys: the last tick at which any of them changed. */
  private int[] blockTicks = {};

  /** Creates a table in which every row is as at the start. */
  public Table(TableLayout layout) {
    this.layout = layout;
    width = layout.width();
    rows = new TableRows(layout);
  }

  /** Returns the table's shape. */
  public TableLayout layout() {
    return layout;
  }

  /**
   * Gives a key a row of its own to start with, which all clients know; before the first session.
   * It costs nothing until it changes.
   *
   * @param from holds the row's words
   * @param at where they begin
   */
  public void place(int key, int identity, int[] from, int at) {
    ensure(key);
    rows.place(key, identity, from, at);
    unlikeStart.remove(key);
  }

  /**
   * Sets a row. Words that are what they were cost nothing.
   *
   * @param identity which user of the key it is, in the layout's bits; another one makes the row
   *     new
   * @param from holds the row's words
   * @param at where they begin
   * @param tick the tick after which the row is so; never before that of an earlier call, nor one
   *     that an outbox has looked at
   * @return whether anything changed
   */
  public boolean put(int key, int identity, int[] from, int at, int tick) {
    ensure(key);
    boolean isNew = !rows.isPresent(key) || rows.identity(key) != identity;
    boolean changed = isNew;
    for (int word = 0; word < width; word++) {
      int value = from[at + word];
      if (isNew || rows.get(key, word) != value) {
        rows.set(key, word, value);
        wordTicks[key * width + word] = tick;
        changed = true;
      }
    }
    if (isNew) {
      rows.setPresent(key, true);
      rows.setIdentity(key, identity);
      identityTicks[key] = tick;
    }
    if (changed) {
      touch(key, tick);
    }
    return changed;
  }

  /**
   * Removes a row, if there is one. Only in a table that starts empty.
   *
   * @param tick as for {@link #put}
   */
  public void remove(int key, int tick) {
    if (!layout.startsEmpty()) {
      throw new IllegalStateException("key=" + key + " can't be removed: every key has a row");
    }
    if (rows.isPresent(key)) {
      ensure(key);
      rows.setPresent(key, false);
      identityTicks[key] = tick;
      touch(key, tick);
    }
  }

  private void touch(int key, int tick) {
    rowTicks[key] = tick;
    blockTicks[key >> 6] = tick;
    if (rows.isAtStart(key)) {
      unlikeStart.remove(key);
    } else {
      unlikeStart.add(key);
    }
  }

  private void ensure(int key) {
    int old = rows.room();
    rows.ensure(key);
    int room = rows.room();
    if (room == old) {
      return;
    }
    wordTicks = grown(wordTicks, room * width);
    rowTicks = grown(rowTicks, room);
    identityTicks = grown(identityTicks, room);
    blockTicks = grown(blockTicks, (room + 63) >> 6);
    unlikeStart.ensure(room);
  }

  private static int[] grown(int[] ticks, int length) {
    int[] grown = Arrays.copyOf(ticks, length);
    Arrays.fill(grown, ticks.length, length, NEVER);
    return grown;
  }

  /** Returns one more than the highest key that has ever been put, or a little more. */
  int room() {
    return rows.room();
  }

  /** Returns the rows, for reading. */
  TableRows rows() {
    return rows;
  }

  /** Returns those of 64 neighbouring keys whose rows differ from the start. */
  long unlikeStart(int block) {
    return unlikeStart.word(block);
  }

  /** Returns the last tick at which any of 64 neighbouring keys changed, or -1. */
  int blockTick(int block) {
    return blockTicks[block];
  }

  /** Returns the last tick at which a row changed, or -1. */
  int rowTick(int key) {
    return rowTicks[key];
  }

  /** Returns the last tick at which a key got another user, or lost it, or -1. */
  int identityTick(int key) {
    return identityTicks[key];
  }

  /** Returns the words that changed after a tick: bit i for word i. */
  long changedAfter(int key, int tick) {
    long changed = 0;
    for (int word = 0; word < width; word++) {
      changed |= wordTicks[key * width + word] > tick ? 1L << word : 0;
    }
    return changed;
  }

  /** Returns the words that differ from the start: bit i for word i. */
  long unlikeStartWords(int key) {
    long unlike = 0;
    for (int word = 0; word < width; word++) {
      unlike |= rows.get(key, word) != rows.start(key, word) ? 1L << word : 0;
    }
    return unlike;
  }
}
