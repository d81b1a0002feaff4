package carom.net.snapshot;

import java.util.Arrays;

/**
 * The entities that the server counts as near a player's body, the own one included, and a hash of
 * their exact state: what tells a client that it simulates them right.
 *
 * <p>When somebody comes near, or the client's hash was another, the server tells exact state, in
 * an <em>update</em>: the state at one tick, its <em>base</em>, of those entities of the list that
 * are <em>told</em>, with their contacts. An update is a number of rows, spread over as many
 * snapshots as it takes; whoever has all of them knows the state at the base tick, and computes
 * what follows. First come the told entities ({@value #ENTITY_INTS} ints: key, exact body, memory
 * of its player), in the order of the list; then contacts ({@value #CONTACT_INTS} ints: two ends,
 * each a place in the list or the inverted slot of a static body; parts; points and flags; feature
 * ids; floats).
 *
 * <p>The order of the list is that of the server's world and part of the state. Mutable, reused.
 */
public final class NearState {
  /** Ints per entity. */
  public static final int ENTITY_INTS = 13;

  /** Ints per contact. */
  public static final int CONTACT_INTS = 15;

  /** Most entities. */
  public static final int MAX_ENTITIES = 63;

  /** Most rows of an update. */
  public static final int MAX_ROWS = 511;

  /** Most rows of an update in one snapshot. */
  public static final int MAX_PART = 63;

  private static final int STRIDE = Math.max(ENTITY_INTS, CONTACT_INTS);

  boolean present;
  int hash;
  int count;
  int[] keys = new int[MAX_ENTITIES];
  boolean updating;
  int age;
  long told;
  int totalRows;
  int firstRow;
  int partRows;
  int[] rows = {};

  NearState() {}

  /** Removes everything: the client is told nothing about what is near. */
  public void clear() {
    present = false;
    hash = 0;
    count = 0;
    endUpdate();
  }

  /** Starts anew, without an update. */
  public void begin(long stateHash) {
    clear();
    present = true;
    hash = fold(stateHash);
  }

  /**
   * Lists an entity.
   *
   * @param key slot and generation: {@code slot | generation << 16}
   * @throws IllegalStateException beyond {@value #MAX_ENTITIES}
   */
  public void add(int key) {
    if (count == MAX_ENTITIES) {
      throw new IllegalStateException(
          "entities=" + count + " is the most that are near; take the nearest");
    }
    keys[count++] = key;
  }

  /**
   * Says that a part of an update follows by {@link #addRow}.
   *
   * @param ticksAgo how long ago the base tick was, 0..63
   * @param toldEntities bit i = entity i is told
   * @param total rows of the whole update, 0..{@value #MAX_ROWS}
   * @param first number of the first row that follows
   */
  public void beginPart(int ticksAgo, long toldEntities, int total, int first) {
    updating = true;
    age = ticksAgo;
    told = toldEntities;
    totalRows = total;
    firstRow = first;
    partRows = 0;
  }

  /**
   * Adds the next row of the part; at most {@value #MAX_PART}.
   *
   * @param from holds it
   * @param at where it begins; as many ints as its kind has are copied
   */
  public void addRow(int[] from, int at) {
    int to = growRow();
    System.arraycopy(from, at, rows, to, ints(partRows - 1));
  }

  int growRow() {
    if ((partRows + 1) * STRIDE > rows.length) {
      rows = Arrays.copyOf(rows, Math.max(8 * STRIDE, 2 * rows.length));
    }
    return partRows++ * STRIDE;
  }

  private int ints(int row) {
    return isEntity(row) ? ENTITY_INTS : CONTACT_INTS;
  }

  boolean isEntity(int row) {
    return firstRow + row < Long.bitCount(told);
  }

  void endUpdate() {
    updating = false;
    age = 0;
    told = 0;
    totalRows = 0;
    firstRow = 0;
    partRows = 0;
  }

  void set(NearState other) {
    setList(other);
    updating = other.updating;
    age = other.age;
    told = other.told;
    totalRows = other.totalRows;
    firstRow = other.firstRow;
    partRows = other.partRows;
    if (rows.length < partRows * STRIDE) {
      rows = new int[other.rows.length];
    }
    System.arraycopy(other.rows, 0, rows, 0, partRows * STRIDE);
  }

  /** Copies who is near, and the hash, but no update. */
  void setList(NearState other) {
    present = other.present;
    hash = other.hash;
    endUpdate();
    count = other.count;
    System.arraycopy(other.keys, 0, keys, 0, count);
  }

  /** Whether the client is told what is near at all. */
  public boolean present() {
    return present;
  }

  /** Entities near, the own one included. */
  public int count() {
    return count;
  }

  /** Slot and generation of an entity: {@code slot | generation << 16}. */
  public int key(int index) {
    return keys[index];
  }

  /** Hash of the exact state of all of them, see {@link #fold}. */
  public int hash() {
    return hash;
  }

  /** The 32 bits of a 64-bit hash that are sent. */
  public static int fold(long stateHash) {
    return (int) (stateHash ^ stateHash >>> 32);
  }

  /** Whether an update is under way, of which a part is here. */
  public boolean updating() {
    return updating;
  }

  /** How many ticks before the snapshot's the update's base is. */
  public int age() {
    return age;
  }

  /** Bit i = entity i is told. */
  public long told() {
    return told;
  }

  /** Rows of the whole update. */
  public int totalRows() {
    return totalRows;
  }

  /** Number of the first row that is here. */
  public int firstRow() {
    return firstRow;
  }

  /** Rows that are here. */
  public int partRows() {
    return partRows;
  }

  /** The rows that are here. */
  public int[] rows() {
    return rows;
  }

  /** Where a row begins in {@link #rows}. */
  public int rowAt(int row) {
    return row * STRIDE;
  }

  /** About how many bits a row takes. */
  public static int bits(int[] from, int at, int ints) {
    int bits = 0;
    for (int i = 0; i < ints; i++) {
      bits += from[at + i] == 0 ? 1 : 33;
    }
    return bits;
  }

  /** Whether both list the same entities, with the same hash. */
  boolean sameAs(NearState other) {
    return present == other.present && hash == other.hash && sameList(other);
  }

  boolean sameList(NearState other) {
    return Arrays.equals(keys, 0, count, other.keys, 0, other.count);
  }
}
