package carom.client.prediction;

import carom.net.snapshot.NearState;
import carom.physics.dynamics.StateHash;
import carom.sim.Neighbourhood;

/**
 * For each saved tick, a hash of every predicted body: so that, when the truth of a tick is known,
 * it can be said which bodies had been foreseen in every bit.
 */
final class Foreseen {
  private static final int MOST = NearState.MAX_ENTITIES + 1;

  private final int[][] keys;
  private final long[][] hashes;
  private final boolean[][] awake;
  private final int[] count;
  private final int[] oldKeys = new int[MOST];
  private final long[] oldHashes = new long[MOST];
  private int oldCount;

  Foreseen(int ring) {
    keys = new int[ring][MOST];
    hashes = new long[ring][MOST];
    awake = new boolean[ring][MOST];
    count = new int[ring];
  }

  /** Notes what was computed for a tick. */
  void keep(int slot, Neighbourhood bodies) {
    int n = Math.min(MOST, bodies.count());
    for (int i = 0; i < n; i++) {
      int at = i * Neighbourhood.ENTITY_INTS;
      long h = StateHash.SEED;
      for (int k = 0; k < Neighbourhood.ENTITY_INTS; k++) {
        h = StateHash.mix(h, bodies.entities()[at + k]);
      }
      keys[slot][i] = bodies.entities()[at];
      hashes[slot][i] = h;
      awake[slot][i] = bodies.awake(i);
    }
    count[slot] = n;
  }

  /** What stands for this tick now is what was foreseen; from here on it may be computed again. */
  void remember(int slot) {
    oldCount = count[slot];
    System.arraycopy(keys[slot], 0, oldKeys, 0, oldCount);
    System.arraycopy(hashes[slot], 0, oldHashes, 0, oldCount);
  }

  /** Bodies awake in a tick that had been foreseen at all. */
  int awake(int slot) {
    int n = 0;
    for (int i = 0; i < count[slot]; i++) {
      n += awake[slot][i] && find(keys[slot][i]) >= 0 ? 1 : 0;
    }
    return n;
  }

  /** Bodies awake in a tick that had been foreseen as they now are, in every bit. */
  int right(int slot) {
    int n = 0;
    for (int i = 0; i < count[slot]; i++) {
      int old = find(keys[slot][i]);
      n += awake[slot][i] && old >= 0 && oldHashes[old] == hashes[slot][i] ? 1 : 0;
    }
    return n;
  }

  private int find(int key) {
    for (int i = 0; i < oldCount; i++) {
      if (oldKeys[i] == key) {
        return i;
      }
    }
    return -1;
  }
}
