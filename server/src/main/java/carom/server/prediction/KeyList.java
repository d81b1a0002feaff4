package carom.server.prediction;

import java.util.Arrays;

/**
 * A list of entities by their {@linkplain carom.sim.near.Neighbourhood#key keys}, which tell an
 * entity from another that had the same id. Allocates only to grow.
 */
final class KeyList {
  private int[] keys = new int[16];
  private int count;

  void clear() {
    count = 0;
  }

  void add(int key) {
    if (count == keys.length) {
      keys = Arrays.copyOf(keys, 2 * count);
    }
    keys[count++] = key;
  }

  void set(KeyList other) {
    clear();
    for (int i = 0; i < other.count; i++) {
      add(other.keys[i]);
    }
  }

  int count() {
    return count;
  }

  int get(int index) {
    return keys[index];
  }

  /**
   * Returns where a key stands, or -1.
   *
   * @param likely where it probably stands, not negative: the search begins there
   */
  int find(int key, int likely) {
    for (int i = 0, at = likely; i < count; i++, at++) {
      at = at < count ? at : 0;
      if (keys[at] == key) {
        return at;
      }
    }
    return -1;
  }

  /** Returns whether these are the keys of some entities, in their order. */
  boolean isOf(EntityList entities) {
    if (count != entities.count()) {
      return false;
    }
    for (int i = 0; i < count; i++) {
      if (keys[i] != entities.key(i)) {
        return false;
      }
    }
    return true;
  }
}
