package carom.net.snapshot.exact;

import carom.physics.rows.BodyRow;
import carom.physics.rows.RowKind;
import carom.physics.rows.Rows;
import java.util.Arrays;

/**
 * The entities that the server counts as near a player's body, the own one included, and a hash of
 * their exact state: what tells a client that it simulates them right.
 *
 * <p>When somebody comes near, or the client's hash was another, or the game pushed one of them,
 * the server tells exact state, in an <em>update</em>: the state at one tick, its <em>base</em>, of
 * those entities of the list that are <em>told</em>, with their contacts. An update is a number of
 * rows, spread over as many snapshots as it takes; whoever has all of them knows the state at the
 * base tick, and computes what follows. First come the told entities, each a {@link BodyRow} with
 * its key and the memory of its player, in the order of the list; then contacts, each a {@link
 * carom.physics.rows.ContactRow} whose ends are places in the list or inverted slots of static
 * bodies.
 *
 * <p>The order of the list is that of the server's world and part of the state. Mutable, reused.
 */
public final class NearState {
  /** Most entities. */
  public static final int MAX_ENTITIES = 255;

  /** Most rows of an update: five for each entity, four of them contacts. */
  public static final int MAX_ROWS = 5 * MAX_ENTITIES;

  /** Most rows of an update in one snapshot. */
  public static final int MAX_PART = 63;

  private static final int FIRST_ROOM = 16;
  private static final int[] NONE = {};

  boolean present;
  int hash;
  int count;
  int[] keys = NONE;
  public boolean updating;
  int age;
  int toldCount;
  int[] told = NONE;
  int totalRows;
  int firstRow;

  /** The part's rows, of mixed kinds. */
  final Rows rows = Rows.mixed();

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
    if (count == keys.length) {
      keys = Arrays.copyOf(keys, Math.min(MAX_ENTITIES, Math.max(FIRST_ROOM, 2 * count)));
    }
    keys[count++] = key;
  }

  /**
   * Says that a part of an update follows: who is told in the update, by {@link #tell}, and then
   * the part's rows by {@link #addRow}.
   *
   * @param ticksAgo how long ago the base tick was, 0..63
   * @param total rows of the whole update, 0..{@value #MAX_ROWS}
   * @param first number of the first row that follows
   */
  public void beginPart(int ticksAgo, int total, int first) {
    updating = true;
    age = ticksAgo;
    toldCount = 0;
    totalRows = total;
    firstRow = first;
    rows.clear();
  }

  /**
   * Says that the update tells a listed entity.
   *
   * @param place in the list, ascending from call to call
   */
  public void tell(int place) {
    if (toldCount == told.length) {
      told = Arrays.copyOf(told, Math.max(FIRST_ROOM, 2 * toldCount));
    }
    told[toldCount++] = place;
  }

  /**
   * Adds the next row of the part; at most {@value #MAX_PART}.
   *
   * @param from holds it
   * @param at where it begins; as many ints as its kind has are copied
   */
  public void addRow(int[] from, int at) {
    rows.add(kind(rows.count()), from, at);
  }

  /** Adds the next row, to be decoded: all zero but the key of an entity, which the list has. */
  void growRow() {
    int at = rows.add();
    int row = rows.count() - 1;
    if (kind(row) == RowKind.BODY) {
      rows.ints()[at + BodyRow.KEY] = key(told[firstRow + row]);
    }
  }

  /** Returns the kind of a row that is here. */
  public RowKind kind(int row) {
    return RowKind.of(firstRow + row, toldCount);
  }

  void endUpdate() {
    updating = false;
    age = 0;
    toldCount = 0;
    totalRows = 0;
    firstRow = 0;
    rows.clear();
  }

  void set(NearState other) {
    setList(other);
    updating = other.updating;
    age = other.age;
    toldCount = 0;
    for (int i = 0; i < other.toldCount; i++) {
      tell(other.told[i]);
    }
    totalRows = other.totalRows;
    firstRow = other.firstRow;
    rows.set(other.rows);
  }

  /** Copies who is near, and the hash, but no update. */
  void setList(NearState other) {
    present = other.present;
    hash = other.hash;
    endUpdate();
    count = other.count;
    if (count > keys.length) {
      keys = new int[other.keys.length];
    }
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

  /** How many of the entities are told. */
  public int toldCount() {
    return toldCount;
  }

  /** Place in the list of a told entity, index 0..{@link #toldCount} - 1, ascending. */
  public int told(int index) {
    return told[index];
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
    return rows.count();
  }

  /** The rows that are here, of mixed kinds; see {@link #kind}. */
  public Rows rows() {
    return rows;
  }

  /** How many bits the list takes for a client that has no other, at most. */
  public int listBits() {
    int bits = 0;
    for (int i = 0; i < count; i++) {
      bits += NearCodec.insertBits(i == 0 ? 0 : keys[i - 1], keys[i]);
    }
    return bits;
  }

  /** Whether both list the same entities, with the same hash. */
  public boolean sameAs(NearState other) {
    return present == other.present && hash == other.hash && sameList(other);
  }

  boolean sameList(NearState other) {
    return Arrays.equals(keys, 0, count, other.keys, 0, other.count);
  }
}
