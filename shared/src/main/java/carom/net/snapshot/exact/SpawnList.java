package carom.net.snapshot.exact;

import carom.net.codec.BitPass;

/**
 * The living entities that a player's own inputs have spawned: the origin of each, by which the
 * client knows its provisional one, and its key. What isn't listed at a tick after its origin
 * doesn't exist, or was never spawned. Sorted by origin. Mutable, reused; allocates once, when it
 * is first used.
 */
public final class SpawnList {
  /** Most entities in the list. */
  public static final int MOST = 32;

  /** Smallest origin. Origins have 31 bits, of which this one is set. */
  public static final int FIRST_ORIGIN = 1 << 30;

  private static final int ORIGIN_MASK = FIRST_ORIGIN - 1;
  private static final int KEY_BITS = 24;
  private static final int[] NONE = {};

  private int count;
  private int[] origins = NONE;
  private int[] keys = NONE;

  SpawnList() {}

  /** Removes all. */
  public void clear() {
    count = 0;
  }

  /**
   * Adds an entity, unless there are {@value #MOST}.
   *
   * @param origin at least {@link #FIRST_ORIGIN}
   * @param key slot and generation: {@code slot | generation << 16}
   * @return whether it was added
   */
  public boolean add(int origin, int key) {
    if (count == MOST) {
      return false;
    }
    if (origins.length == 0) {
      origins = new int[MOST];
      keys = new int[MOST];
    }
    int at = count++;
    for (; at > 0 && (origin - origins[at - 1]) << 2 < 0; at--) {
      origins[at] = origins[at - 1];
      keys[at] = keys[at - 1];
    }
    origins[at] = origin;
    keys[at] = key;
    return true;
  }

  /** Returns the number of entities. */
  public int count() {
    return count;
  }

  /** Returns the origin of an entity; index 0..count - 1, the oldest first. */
  public int origin(int index) {
    return origins[index];
  }

  /** Returns slot and generation of an entity; index 0..count - 1. */
  public int key(int index) {
    return keys[index];
  }

  /** Copies another list. */
  void set(SpawnList other) {
    clear();
    for (int i = 0; i < other.count; i++) {
      add(other.origins[i], other.keys[i]);
    }
  }

  /** Returns whether both list the same. */
  boolean sameAs(SpawnList other) {
    boolean same = count == other.count;
    for (int i = 0; same && i < count; i++) {
      same = origins[i] == other.origins[i] && keys[i] == other.keys[i];
    }
    return same;
  }

  private boolean has(int origin, int key) {
    for (int i = 0; i < count; i++) {
      if (origins[i] == origin && keys[i] == key) {
        return true;
      }
    }
    return false;
  }

  /**
   * Codes a list as changes of another: which of those stay, then those that are new.
   *
   * @param list to write; a reader fills it
   */
  static void code(BitPass c, SpawnList baseline, SpawnList list) {
    if (c.isReading()) {
      list.clear();
    }
    for (int i = 0; i < baseline.count; i++) {
      boolean stays = c.flag(list.has(baseline.origins[i], baseline.keys[i]));
      if (stays && c.isReading()) {
        list.add(baseline.origins[i], baseline.keys[i]);
      }
    }
    int before = baseline.count == 0 ? FIRST_ORIGIN : baseline.origins[baseline.count - 1];
    int at = nextNew(baseline, list, 0);
    while (c.flag(at < list.count && !c.isReading())) {
      int written = c.isReading() ? 0 : list.origins[at];
      before = FIRST_ORIGIN | (before + c.difference(written - before)) & ORIGIN_MASK;
      int key = c.plain(c.isReading() ? 0 : list.keys[at], KEY_BITS);
      if (c.isReading() && !c.require(list.add(before, key))) {
        return;
      }
      at = c.isReading() ? at : nextNew(baseline, list, at + 1);
    }
  }

  /** Returns the place of the next entity that another list lacks, or the end. */
  private static int nextNew(SpawnList baseline, SpawnList list, int from) {
    int at = from;
    while (at < list.count && baseline.has(list.origins[at], list.keys[at])) {
      at++;
    }
    return at;
  }
}
