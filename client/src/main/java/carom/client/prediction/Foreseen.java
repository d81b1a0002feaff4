package carom.client.prediction;

import carom.sim.Neighbourhood;

/**
 * For each saved tick, a hash of every predicted body: so that, when the truth of a tick is known,
 * it can be said which bodies had been foreseen in every bit. Allocates only to grow.
 */
final class Foreseen {
  private final int[][] keys;
  private final long[][] hashes;
  private final boolean[][] awake;
  private final int[] count;
  private int[] oldKeys = {};
  private long[] oldHashes = {};
  private int oldCount;

  Foreseen(int ring) {
    keys = new int[ring][0];
    hashes = new long[ring][0];
    awake = new boolean[ring][0];
    count = new int[ring];
  }

  /** Notes what was computed for a tick. */
  void keep(int slot, Neighbourhood bodies) {
    int n = bodies.count();
    if (keys[slot].length < n) {
      int room = Math.max(8, Integer.highestOneBit(n) << 1);
      keys[slot] = new int[room];
      hashes[slot] = new long[room];
      awake[slot] = new boolean[room];
    }
    for (int i = 0; i < n; i++) {
      keys[slot][i] = bodies.entities()[i * Neighbourhood.ENTITY_INTS];
      hashes[slot][i] = bodies.entityHash(i);
      awake[slot][i] = bodies.awake(i);
    }
    count[slot] = n;
  }

  /** What stands for this tick now is what was foreseen; from here on it may be computed again. */
  void remember(int slot) {
    oldCount = count[slot];
    if (oldKeys.length < oldCount) {
      oldKeys = new int[keys[slot].length];
      oldHashes = new long[keys[slot].length];
    }
    System.arraycopy(keys[slot], 0, oldKeys, 0, oldCount);
    System.arraycopy(hashes[slot], 0, oldHashes, 0, oldCount);
  }

  /** Bodies awake in a tick that had been foreseen at all. */
  int awake(int slot) {
    int n = 0;
    for (int i = 0; i < count[slot]; i++) {
      n += awake[slot][i] && find(keys[slot][i], i) >= 0 ? 1 : 0;
    }
    return n;
  }

  /** Bodies awake in a tick that had been foreseen as they now are, in every bit. */
  int right(int slot) {
    int n = 0;
    for (int i = 0; i < count[slot]; i++) {
      int old = find(keys[slot][i], i);
      n += awake[slot][i] && old >= 0 && oldHashes[old] == hashes[slot][i] ? 1 : 0;
    }
    return n;
  }

  /** The order seldom changes: whoever stood here probably stands here. */
  private int find(int key, int likely) {
    for (int i = 0, at = likely; i < oldCount; i++, at++) {
      at = at < oldCount ? at : 0;
      if (oldKeys[at] == key) {
        return at;
      }
    }
    return -1;
  }
}
