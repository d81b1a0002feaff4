package carom.client.prediction;

import carom.net.snapshot.exact.NearState;
import carom.sim.near.Neighbourhood;

/**
 * A hash of every predicted body for each saved tick. When the server's state of a tick is known,
 * the hashes tell which bodies were predicted in every bit. Allocates only to grow.
 */
final class PredictedHashes {
  private final int[][] keys;
  private final long[][] hashes;
  private final boolean[][] awake;
  private final int[] count;
  private int[] pinnedKeys = {};
  private long[] pinnedHashes = {};
  private int pinnedCount;

  PredictedHashes(int ring) {
    keys = new int[ring][0];
    hashes = new long[ring][0];
    awake = new boolean[ring][0];
    count = new int[ring];
  }

  /** Stores the hashes of a tick's bodies in a slot of the ring. */
  void store(int slot, Neighbourhood bodies) {
    int n = bodies.count();
    if (keys[slot].length < n) {
      int room = Math.max(8, Integer.highestOneBit(n) << 1);
      keys[slot] = new int[room];
      hashes[slot] = new long[room];
      awake[slot] = new boolean[room];
    }
    for (int i = 0; i < n; i++) {
      keys[slot][i] = bodies.key(i);
      hashes[slot][i] = bodies.rows().bodyHash(i);
      awake[slot][i] = bodies.awake(i);
    }
    count[slot] = n;
  }

  /** Returns whether a list has some of a slot's bodies, in their order, and no others. */
  boolean hasMore(int slot, NearState near) {
    int found = 0;
    for (int i = 0; i < count[slot] && found < near.count(); i++) {
      found += keys[slot][i] == near.key(found) ? 1 : 0;
    }
    return found == near.count() && found < count[slot];
  }

  /** Copies a slot before a rollback overwrites it; the counts below compare with this copy. */
  void pin(int slot) {
    pinnedCount = count[slot];
    if (pinnedKeys.length < pinnedCount) {
      pinnedKeys = new int[keys[slot].length];
      pinnedHashes = new long[keys[slot].length];
    }
    System.arraycopy(keys[slot], 0, pinnedKeys, 0, pinnedCount);
    System.arraycopy(hashes[slot], 0, pinnedHashes, 0, pinnedCount);
  }

  /** Returns how many bodies that are awake in a slot were predicted at all. */
  int awakeCount(int slot) {
    int n = 0;
    for (int i = 0; i < count[slot]; i++) {
      n += awake[slot][i] && findPinned(keys[slot][i], i) >= 0 ? 1 : 0;
    }
    return n;
  }

  /** Returns how many bodies that are awake in a slot were predicted in every bit. */
  int exactCount(int slot) {
    int n = 0;
    for (int i = 0; i < count[slot]; i++) {
      int old = findPinned(keys[slot][i], i);
      n += awake[slot][i] && old >= 0 && pinnedHashes[old] == hashes[slot][i] ? 1 : 0;
    }
    return n;
  }

  /** Searches from a likely index on, because the order of bodies seldom changes. */
  private int findPinned(int key, int likely) {
    for (int i = 0, at = likely; i < pinnedCount; i++, at++) {
      at = at < pinnedCount ? at : 0;
      if (pinnedKeys[at] == key) {
        return at;
      }
    }
    return -1;
  }
}
