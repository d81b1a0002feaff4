package carom.net.snapshot.frame;

import java.util.Arrays;

/**
 * A set of entity slots, walked in ascending order. It is an array of bits, and above each 64 words
 * a word that says which of them aren't empty, so that a walk costs what is in the set and not what
 * could be. Grows as needed; nothing else allocates. One thread.
 */
public final class SlotSet {

  /** The answer of {@link #next} when there is no further slot. */
  public static final int NONE = -1;

  private long[] words = {};
  private long[] filled = {};

  /** Makes room for slots below a limit. */
  public void ensure(int limit) {
    int length = (limit + 63) >> 6;
    if (length > words.length) {
      words = Arrays.copyOf(words, length);
      filled = Arrays.copyOf(filled, (length + 63) >> 6);
    }
  }

  /** Returns whether a slot is in the set. */
  public boolean has(int slot) {
    int word = slot >> 6;
    return word < words.length && (words[word] & 1L << slot) != 0;
  }

  /** Adds a slot for which there is room. */
  public void add(int slot) {
    int word = slot >> 6;
    words[word] |= 1L << slot;
    filled[word >> 6] |= 1L << word;
  }

  /** Removes a slot for which there is room. */
  public void remove(int slot) {
    int word = slot >> 6;
    words[word] &= ~(1L << slot);
    if (words[word] == 0) {
      filled[word >> 6] &= ~(1L << word);
    }
  }

  /** Returns those of 64 neighbouring slots, from 64 {@code word} on, that are in the set. */
  public long word(int word) {
    return word < words.length ? words[word] : 0;
  }

  /** Adds some of 64 neighbouring slots, at least one. */
  public void addWord(int word, long slots) {
    words[word] |= slots;
    filled[word >> 6] |= 1L << word;
  }

  /** Removes some of 64 neighbouring slots. */
  public void removeWord(int word, long slots) {
    if (word < words.length) {
      words[word] &= ~slots;
      if (words[word] == 0) {
        filled[word >> 6] &= ~(1L << word);
      }
    }
  }

  /** Removes all slots. */
  public void clear() {
    for (int group = 0; group < filled.length; group++) {
      for (long rest = filled[group]; rest != 0; rest &= rest - 1) {
        words[(group << 6) + Long.numberOfTrailingZeros(rest)] = 0;
      }
      filled[group] = 0;
    }
  }

  /** Adds all slots from 0 to below a limit. */
  public void addBelow(int limit) {
    for (int slot = 0; slot < limit; slot++) {
      add(slot);
    }
  }

  /** Adds all of another set, which must not reach further than this one has room for. */
  public void addAll(SlotSet other) {
    for (int group = 0; group < other.filled.length; group++) {
      for (long rest = other.filled[group]; rest != 0; rest &= rest - 1) {
        int word = (group << 6) + Long.numberOfTrailingZeros(rest);
        words[word] |= other.words[word];
      }
      filled[group] |= other.filled[group];
    }
  }

  /** Adds what two other sets have in common; neither may reach further than this one. */
  public void addCommon(SlotSet a, SlotSet b) {
    int groups = Math.min(a.filled.length, b.filled.length);
    for (int group = 0; group < groups; group++) {
      for (long rest = a.filled[group] & b.filled[group]; rest != 0; rest &= rest - 1) {
        int word = (group << 6) + Long.numberOfTrailingZeros(rest);
        long common = a.words[word] & b.words[word];
        if (common != 0) {
          words[word] |= common;
          filled[group] |= 1L << word;
        }
      }
    }
  }

  /** Copies another set into this one. */
  public void set(SlotSet other) {
    clear();
    ensure(other.words.length << 6);
    addAll(other);
  }

  /** Returns the smallest slot of the set that isn't below {@code from}, or {@link #NONE}. */
  public int next(int from) {
    int word = from >> 6;
    if (word >= words.length) {
      return NONE;
    }
    long rest = words[word] & -1L << from;
    if (rest != 0) {
      return (word << 6) + Long.numberOfTrailingZeros(rest);
    }
    word = nextWord(word + 1);
    return word < 0 ? NONE : (word << 6) + Long.numberOfTrailingZeros(words[word]);
  }

  /** Returns the first word from {@code from} on that isn't empty, or {@link #NONE}. */
  public int nextWord(int from) {
    int group = from >> 6;
    if (group >= filled.length) {
      return NONE;
    }
    long groups = filled[group] & -1L << from;
    while (groups == 0) {
      if (++group == filled.length) {
        return NONE;
      }
      groups = filled[group];
    }
    return (group << 6) + Long.numberOfTrailingZeros(groups);
  }
}
