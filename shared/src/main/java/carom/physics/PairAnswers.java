package carom.physics;

/**
 * The last answer of a {@link CollisionFilter} about each pair of shapes: every pair may meet until
 * it is refused. Recorder and replay keep one each; a recording has only the changes. So a
 * recording doesn't depend on how often, in which order or by which thread pairs were found.
 *
 * <p>A hash table of longs; nothing iterates over it, so its order shows nowhere.
 */
final class PairAnswers {
  /** A key plus 1, and in the lowest bit whether the pair is refused; 0 if the place is free. */
  private long[] table = new long[64];

  private int count;

  /**
   * Sets the answer about a pair.
   *
   * @param key as {@code ContactKey} makes it, with numbers of shapes for those of parts
   * @return whether it was another before
   */
  boolean set(long key, boolean refused) {
    int at = find(table, key);
    if (table[at] == 0 && !refused) {
      return false;
    }
    long entry = key + 1 << 1 | (refused ? 1 : 0);
    boolean changes = table[at] != entry;
    if (table[at] == 0 && 2 * ++count > table.length) {
      grow();
      at = find(table, key);
    }
    table[at] = entry;
    return changes;
  }

  /** Returns whether the last answer about a pair was no. */
  boolean refuses(long key) {
    return (table[find(table, key)] & 1) != 0;
  }

  private void grow() {
    long[] larger = new long[2 * table.length];
    for (long entry : table) {
      if (entry != 0) {
        larger[find(larger, (entry >>> 1) - 1)] = entry;
      }
    }
    table = larger;
  }

  /** Returns the place of a key, or the free one where it would be. */
  private static int find(long[] table, long key) {
    long mixed = key * 0x9e37_79b9_7f4a_7c15L;
    int at = (int) (mixed >>> 32) & table.length - 1;
    while (table[at] != 0 && table[at] >>> 1 != key + 1) {
      at = at + 1 & table.length - 1;
    }
    return at;
  }
}
