package carom.net.snapshot.table;

import carom.net.snapshot.frame.SlotSet;
import java.util.Arrays;

/**
 * The rows of one table, by key: what both the sender and the receiver keep. A key without a row is
 * absent. One thread; allocates only to grow with the highest key.
 */
final class TableRows {
  private static final int FIRST_ROOM = 64;

  private final TableLayout layout;
  private final int width;
  private final boolean startsEmpty;
  private int room;
  private int[] words = {};
  private int[] identities = {};

  /** Keys that are as not at the beginning: filled where the table starts empty, else emptied. */
  private final SlotSet turned = new SlotSet();

  /** Keys that have a start of their own, and what that is. */
  private final SlotSet placed = new SlotSet();

  private int[] placedWords = {};
  private int[] placedIdentities = {};

  TableRows(TableLayout layout) {
    this.layout = layout;
    width = layout.width();
    startsEmpty = layout.startsEmpty();
  }

  /** Returns one more than the highest key that there is room for; others are as at the start. */
  int room() {
    return room;
  }

  /** Makes room for a key; rows that are new are as at the start. */
  void ensure(int key) {
    if (key < 0 || key >= layout.keys()) {
      throw new IndexOutOfBoundsException("key=" + key + " is outside 0.." + (layout.keys() - 1));
    }
    if (key < room) {
      return;
    }
    int old = room;
    room = Math.min(layout.keys(), Math.max(FIRST_ROOM, Math.max(key + 1, 2 * old)));
    words = Arrays.copyOf(words, room * width);
    identities = Arrays.copyOf(identities, room);
    turned.ensure(room);
    for (int i = old; i < room; i++) {
      toStart(i);
    }
  }

  /** Gives a key a row of its own to start with, in which it is from now on. */
  void place(int key, int identity, int[] from, int at) {
    ensure(key);
    placed.ensure(room);
    if (placedIdentities.length < room) {
      placedWords = Arrays.copyOf(placedWords, room * width);
      placedIdentities = Arrays.copyOf(placedIdentities, room);
    }
    placed.add(key);
    placedIdentities[key] = identity;
    System.arraycopy(from, at, placedWords, key * width, width);
    toStart(key);
  }

  /** Returns whether a key has a row. */
  boolean isPresent(int key) {
    return key < room ? turned.has(key) == startsEmpty : !startsEmpty;
  }

  void setPresent(int key, boolean present) {
    if (present == startsEmpty) {
      turned.add(key);
    } else {
      turned.remove(key);
    }
  }

  int identity(int key) {
    return key < room ? identities[key] : 0;
  }

  void setIdentity(int key, int identity) {
    identities[key] = identity;
  }

  int get(int key, int word) {
    return key < room ? words[key * width + word] : layout.start(key, word);
  }

  void set(int key, int word, int value) {
    words[key * width + word] = value;
  }

  /** Returns what a word of a key's row is at the start. */
  int start(int key, int word) {
    return placed.has(key) ? placedWords[key * width + word] : layout.start(key, word);
  }

  /** Makes a row what it is at the start. */
  void toStart(int key) {
    setPresent(key, startsPresent(key));
    identities[key] = placed.has(key) ? placedIdentities[key] : 0;
    wordsToStart(key);
  }

  /** Makes all words of a row what they are at the start. */
  void wordsToStart(int key) {
    for (int word = 0; word < width; word++) {
      words[key * width + word] = start(key, word);
    }
  }

  private boolean startsPresent(int key) {
    return !startsEmpty || placed.has(key);
  }

  /**
   * Returns whether a row is what it is at the start. The identity counts only where the start has
   * one: elsewhere a row of start values says the same of whatever has the key.
   */
  boolean isAtStart(int key) {
    boolean same =
        isPresent(key) == startsPresent(key)
            && (!placed.has(key) || identities[key] == placedIdentities[key]);
    for (int word = 0; same && isPresent(key) && word < width; word++) {
      same = get(key, word) == start(key, word);
    }
    return same;
  }
}
