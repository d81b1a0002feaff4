package carom.client.prediction;

import carom.net.snapshot.exact.NearState;
import java.util.Arrays;

/**
 * An update of what is near, put together from the parts that snapshots bring, in any order. One
 * thread; allocates only to grow.
 */
final class NearUpdate {
  private static final int STRIDE = Math.max(NearState.ENTITY_INTS, NearState.CONTACT_INTS);

  private int baseTick = -1;
  private final int[] keys = new int[NearState.MAX_ENTITIES];

  /** By place in the list: which of the told entities it is, or -1. */
  private final int[] toldAs = new int[NearState.MAX_ENTITIES];

  private int count;
  private int told;
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

  /** Whether a snapshot belongs to a later update than this. */
  boolean isFollowedBy(NearState near, int tick) {
    return near.present() && near.updating() && tick - near.age() > baseTick;
  }

  /** Takes what a snapshot brings. */
  void hear(NearState near, int tick) {
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
    told = near.toldCount();
    Arrays.fill(toldAs, -1);
    for (int i = 0; i < told; i++) {
      toldAs[near.told(i)] = i;
    }
    total = Math.max(told, near.totalRows());
    missing = total;
    if (has.length < total) {
      has = new boolean[Math.max(2 * has.length, total)];
      rows = new int[has.length * STRIDE];
    }
    Arrays.fill(has, 0, total, false);
  }

  /** Whether all of an update is here that was not used yet. */
  boolean isReady() {
    return !used && baseTick >= 0 && missing == 0;
  }

  /** It is used now, or of no use. */
  void use() {
    used = true;
  }

  /** The tick whose state it tells. */
  int baseTick() {
    return baseTick;
  }

  /** Whether nothing is left of what was near before. */
  boolean tellsAll() {
    return told == count;
  }

  /** Whether an entity is near. */
  boolean lists(int key) {
    for (int i = 0; i < count; i++) {
      if (keys[i] == key) {
        return true;
      }
    }
    return false;
  }

  /** Entities near. */
  int count() {
    return count;
  }

  /** Key of an entity. */
  int key(int index) {
    return keys[index];
  }

  /** Whether an entity's state is told. */
  boolean isTold(int index) {
    return toldAs[index] >= 0;
  }

  /** Where a told entity's row begins in {@link #rows}. */
  int entityAt(int index) {
    return toldAs[index] * STRIDE;
  }

  /** Contacts told. */
  int contacts() {
    return total - told;
  }

  /** Where a contact's row begins in {@link #rows}. */
  int contactAt(int index) {
    return (told + index) * STRIDE;
  }

  int[] rows() {
    return rows;
  }
}
