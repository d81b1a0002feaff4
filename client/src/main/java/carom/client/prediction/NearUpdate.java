package carom.client.prediction;

import carom.net.snapshot.exact.NearState;
import carom.physics.rows.RowCounts;
import carom.physics.rows.RowKind;
import carom.physics.rows.Rows;
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
  private int baseTick = -1;
  private final int[] keys = new int[NearState.MAX_ENTITIES];

  /** By place in the list: index of the entity's state, or -1 if it comes without one. */
  private final int[] stateOf = new int[NearState.MAX_ENTITIES];

  private int count;
  private int states;
  private final RowCounts counts = new RowCounts();
  private int missing;
  private boolean[] has = {};

  /** All rows of the update; those that are missing hold anything. */
  private final Rows rows = Rows.mixed();

  private boolean used;

  /** Creates an update that has received nothing. */
  public NearUpdate() {}

  /** Forgets everything. */
  public void clear() {
    baseTick = -1;
    missing = 0;
    used = true;
  }

  /** Returns whether the near section of a snapshot belongs to a later update than this. */
  public boolean isFollowedBy(NearState near, int tick) {
    return near.present() && near.updating() && tick - near.age() > baseTick;
  }

  /** Adds the rows that a snapshot brings. A newer update replaces this one. */
  public void add(NearState near, int tick) {
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
      if (row < rows.count() && !has[row]) {
        has[row] = true;
        missing--;
        rows.set(row, near.rows(), i);
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
    counts.set(near.counts());
    Arrays.fill(stateOf, -1);
    for (int i = 0; i < states; i++) {
      stateOf[near.told(i)] = i;
    }
    missing = near.totalRows();
    rows.resize(missing);
    if (has.length < missing) {
      has = new boolean[Math.max(2 * has.length, missing)];
    }
    Arrays.fill(has, 0, missing, false);
  }

  /** Returns whether the update is complete and was not used yet. */
  public boolean isReady() {
    return !used && baseTick >= 0 && missing == 0;
  }

  /** Marks the update as used, or as of no use. */
  public void use() {
    used = true;
  }

  /** Returns the tick after which the states are valid. */
  public int baseTick() {
    return baseTick;
  }

  /** Returns whether every listed entity comes with its state. */
  public boolean isWhole() {
    return states == count;
  }

  /** Returns whether an entity is listed. */
  public boolean contains(int key) {
    for (int i = 0; i < count; i++) {
      if (keys[i] == key) {
        return true;
      }
    }
    return false;
  }

  /** Returns the number of listed entities. */
  public int count() {
    return count;
  }

  /** Returns the key of a listed entity. */
  public int key(int index) {
    return keys[index];
  }

  /** Returns whether a listed entity comes with its state. */
  public boolean hasState(int index) {
    return stateOf[index] >= 0;
  }

  /** Returns the row of a listed entity, if it has a state. */
  public int rowOf(int index) {
    return stateOf[index];
  }

  /** Returns the kind of a row. */
  public RowKind kind(int row) {
    return counts.kind(row);
  }

  /** Returns the rows: of entities with a state, then of the other kinds. */
  public Rows rows() {
    return rows;
  }
}
