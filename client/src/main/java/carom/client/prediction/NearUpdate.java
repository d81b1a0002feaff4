package carom.client.prediction;

import carom.net.snapshot.exact.NearState;
import java.util.Arrays;

/**
 * One update of exact states, assembled from the parts that snapshots bring in any order.
 *
 * <p>It lists all entities near the own body at its base tick. Entities that are new or wrong come
 * with their state; the others are only listed. One thread; allocates only to grow.
 *
 * <pre>
 * EMPTY ── add (newer base tick) ──► COLLECTING ── last row ──► READY ── use ──► USED
 *                                        ▲                                        │
 *                                        └────────── add (newer base tick) ───────┘
 * </pre>
 */
final class NearUpdate {
  private static final int STRIDE = Math.max(NearState.ENTITY_INTS, NearState.CONTACT_INTS);

  private int baseTick = -1;
  private final int[] keys = new int[NearState.MAX_ENTITIES];

  /** By place in the list: index of the entity's state, or -1 if it comes without one. */
  private final int[] stateOf = new int[NearState.MAX_ENTITIES];

  private int count;
  private int states;
  private int total;
  private int missing;
  private boolean[] has = {};
  private int[] rows = {};
  private boolean used;

  /** Forgets everything. */
  void clear() {
    baseTick = -1;
    missing = 0;
    used = true;
  }

  /** Returns whether the near section of a snapshot belongs to a later update than this. */
  boolean isFollowedBy(NearState near, int tick) {
    return near.present() && near.updating() && tick - near.age() > baseTick;
  }

  /** Adds the rows that a snapshot brings. A newer update replaces this one. */
  void add(NearState near, int tick) {
    if (!near.present() || !near.updating()) {
      return;
    }
    int base = tick - near.age();
    if (base < baseTick) {
      return;
    }
    if (base > baseTick) {
      begin(near, base);
    }
    for (int i = 0; i < near.partRows(); i++) {
      int row = near.firstRow() + i;
      if (row < total && !has[row]) {
        has[row] = true;
        missing--;
        System.arraycopy(near.rows(), near.rowAt(i), rows, row * STRIDE, STRIDE);
      }
    }
  }

  private void begin(NearState near, int base) {
    baseTick = base;
    used = false;
    count = near.count();
    for (int i = 0; i < count; i++) {
      keys[i] = near.key(i);
    }
    states = near.toldCount();
    Arrays.fill(stateOf, -1);
    for (int i = 0; i < states; i++) {
      stateOf[near.told(i)] = i;
    }
    total = Math.max(states, near.totalRows());
    missing = total;
    if (has.length < total) {
      has = new boolean[Math.max(2 * has.length, total)];
      rows = new int[has.length * STRIDE];
    }
    Arrays.fill(has, 0, total, false);
  }

  /** Returns whether the update is complete and was not used yet. */
  boolean isReady() {
    return !used && baseTick >= 0 && missing == 0;
  }

  /** Marks the update as used, or as of no use. */
  void use() {
    used = true;
  }

  /** Returns the tick after which the states are valid. */
  int baseTick() {
    return baseTick;
  }

  /** Returns whether every listed entity comes with its state. */
  boolean isWhole() {
    return states == count;
  }

  /** Returns whether an entity is listed. */
  boolean contains(int key) {
    for (int i = 0; i < count; i++) {
      if (keys[i] == key) {
        return true;
      }
    }
    return false;
  }

  /** Returns the number of listed entities. */
  int count() {
    return count;
  }

  /** Returns the key of a listed entity. */
  int key(int index) {
    return keys[index];
  }

  /** Returns whether a listed entity comes with its state. */
  boolean hasState(int index) {
    return stateOf[index] >= 0;
  }

  /** Returns where the row of a listed entity begins in {@link #rows}. */
  int entityAt(int index) {
    return stateOf[index] * STRIDE;
  }

  /** Returns the number of contacts. */
  int contacts() {
    return total - states;
  }

  /** Returns where the row of a contact begins in {@link #rows}. */
  int contactAt(int index) {
    return (states + index) * STRIDE;
  }

  /** Returns the rows of entities and contacts. */
  int[] rows() {
    return rows;
  }
}
