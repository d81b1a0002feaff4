package carom.net.snapshot.exact;

import carom.physics.rows.BodyRow;
import carom.physics.rows.RowCounts;
import carom.physics.rows.RowKind;
import carom.physics.rows.Rows;
import java.util.Arrays;

/**
 * The list of entities that the server counts as near a player's body, the own one included, and a
 * hash of their exact state. The hash tells a client whether it simulates them exactly.
 *
 * <p>The server sends exact state in an <em>update</em> when an entity comes near, when the
 * client's hash differs, or when the game pushed one of the entities. An update holds the state at
 * one tick, its <em>base</em>, of those entities of the list that are <em>told</em>, with their
 * contacts. Its rows are spread over as many snapshots as they take. A client that has all of them
 * knows the state at the base tick and computes what follows. The told entities come first, each a
 * {@link BodyRow} with its key, in the order of the list; then rows of the other kinds, whose ends
 * are places in the list or inverted slots of static bodies.
 *
 * <p>What the game did to a listed body, and the client can't compute, is told as a
 * <em>ruling</em>: the new bits of the numbers that changed, at a tick. A client that applies it at
 * that tick computes what the server did.
 *
 * <p>The order of the list is that of the server's world and is part of the state. Mutable, reused.
 */
public final class NearState {
  /** Largest number of entities in the list. */
  public static final int MAX_ENTITIES = 255;

  /** Largest number of rows in an update: eight for each entity. */
  public static final int MAX_ROWS = 8 * MAX_ENTITIES;

  /** Largest number of rows of an update in one snapshot. */
  public static final int MAX_PART = 63;

  /** Largest number of rulings in one snapshot. */
  public static final int MAX_RULINGS = 63;

  /**
   * Largest age at which the base of an update, or a ruling, is of use, ticks. The client forgets
   * its states of older ticks.
   */
  public static final int MOST_AGE = 60;

  /** Number of moments of a tick at which a ruling is made. */
  static final int MOMENTS = 3;

  /** Bits of a moment. */
  static final int MOMENT_BITS = 2;

  /** Ints of a ruling that say what it is about, before those that changed. */
  private static final int RULING_HEAD = 4;

  private static final int RULING_INTS = RULING_HEAD + BodyRow.CHANGING_INTS;
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
  int firstRow;

  int rulings;
  private int[] rulingInts = NONE;

  /** Rows of the whole update by kind; bodies are the told entities. */
  final RowCounts counts = new RowCounts();

  /** The part's rows, of mixed kinds. */
  final Rows rows = Rows.mixed();

  NearState() {}

  /** Removes everything, so that the client is told nothing about near entities. */
  public void clear() {
    present = false;
    hash = 0;
    count = 0;
    rulings = 0;
    endUpdate();
  }

  /** Starts an empty list with a state hash and without an update. */
  public void begin(long stateHash) {
    clear();
    present = true;
    hash = fold(stateHash);
  }

  /**
   * Lists an entity.
   *
   * @param key slot and generation: {@code slot | generation << 16}
   * @throws IllegalStateException if the list already holds {@value #MAX_ENTITIES}
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
   * Begins a part of an update. Call {@link #tell} next for each entity that the update tells, then
   * {@link #addRow} for each row of the part.
   *
   * @param ticksAgo age of the base tick, ticks, 0..63
   * @param total rows of the whole update, at most {@value #MAX_ROWS}; bodies are counted by {@link
   *     #tell}; copied
   * @param first number within the update of the part's first row
   */
  public void beginPart(int ticksAgo, RowCounts total, int first) {
    updating = true;
    age = ticksAgo;
    toldCount = 0;
    counts.set(total);
    counts.set(RowKind.BODY, 0);
    firstRow = first;
    rows.clear();
  }

  /**
   * Marks a listed entity as told by the update.
   *
   * @param place in the list, ascending from call to call
   */
  public void tell(int place) {
    if (toldCount == told.length) {
      told = Arrays.copyOf(told, Math.max(FIRST_ROOM, 2 * toldCount));
    }
    told[toldCount++] = place;
    counts.set(RowKind.BODY, toldCount);
  }

  /**
   * Adds the next row of the part. A part holds at most {@value #MAX_PART}.
   *
   * @param from array that holds the row
   * @param at index at which the row begins; as many ints as its kind has are copied
   */
  public void addRow(int[] from, int at) {
    rows.add(kind(rows.count()), from, at);
  }

  /**
   * Adds the next row for a reader to fill: all zero except for the key of an entity, which comes
   * from the list.
   */
  void growRow() {
    int at = rows.add();
    int row = rows.count() - 1;
    if (kind(row) == RowKind.BODY) {
      rows.ints()[at + BodyRow.KEY] = key(told[firstRow + row]);
    }
  }

  /**
   * Adds a ruling of a body without changed numbers; {@link #setRulingWord} follows for each.
   *
   * @param place of its entity in the list
   * @param ticksAgo age of its tick, ticks, 0..63
   * @param moment when in its tick it was made: 0 before the inputs, 1 in the owner's input, 2
   *     after the physics
   * @param mask bit i says that the int {@code BodyRow.MOTION + i} of the body's row changed, or
   *     number i of the joint's settings
   * @throws IllegalStateException if there are {@value #MAX_RULINGS}
   */
  public void addRuling(int place, int ticksAgo, int moment, int mask) {
    if (rulings == MAX_RULINGS) {
      throw new IllegalStateException("rulings=" + rulings + " is the most in one snapshot");
    }
    int at = rulings++ * RULING_INTS;
    if (at == rulingInts.length) {
      rulingInts = Arrays.copyOf(rulingInts, Math.max(4 * RULING_INTS, 2 * at));
    }
    rulingInts[at] = place;
    rulingInts[at + 1] = ticksAgo << MOMENT_BITS | moment;
    rulingInts[at + 2] = mask;
    rulingInts[at + 3] = -1;
  }

  /** Makes the ruling added last one of a joint: one of its body's, by its index in the table. */
  public void setRulingJoint(int index) {
    rulingInts[(rulings - 1) * RULING_INTS + 3] = index;
  }

  /** Sets the new bits of a number that the ruling added last changed; 0 is the first one. */
  public void setRulingWord(int word, int bits) {
    rulingInts[(rulings - 1) * RULING_INTS + RULING_HEAD + word] = bits;
  }

  /** Returns the number of rulings. */
  public int rulings() {
    return rulings;
  }

  /** Returns the place in the list of a ruling's entity. */
  public int rulingPlace(int index) {
    return rulingInts[index * RULING_INTS];
  }

  /** Returns the age of a ruling's tick, in ticks before the snapshot's tick. */
  public int rulingAge(int index) {
    return rulingInts[index * RULING_INTS + 1] >> MOMENT_BITS;
  }

  /** Returns when in its tick a ruling was made, see {@link #addRuling}. */
  public int rulingMoment(int index) {
    return rulingInts[index * RULING_INTS + 1] & (1 << MOMENT_BITS) - 1;
  }

  /** Returns the index in the table of joints of the joint that a ruling is about, or -1. */
  public int rulingJoint(int index) {
    return rulingInts[index * RULING_INTS + 3];
  }

  /** Returns which numbers of a body's row a ruling changed, see {@link #addRuling}. */
  public int rulingMask(int index) {
    return rulingInts[index * RULING_INTS + 2];
  }

  /** Returns the new bits of a number that a ruling changed. */
  public int rulingWord(int index, int word) {
    return rulingInts[index * RULING_INTS + RULING_HEAD + word];
  }

  /** Returns whether a ruling changed the same numbers to the same as the one before it did. */
  boolean hasSameWords(int index) {
    int mask = rulingMask(index);
    for (int word = 0; word < BodyRow.CHANGING_INTS; word++) {
      if ((mask & 1 << word) != 0 && rulingWord(index, word) != rulingWord(index - 1, word)) {
        return false;
      }
    }
    return true;
  }

  /** Returns the kind of a row of this part. */
  public RowKind kind(int row) {
    return counts.kind(firstRow + row);
  }

  void endUpdate() {
    updating = false;
    age = 0;
    toldCount = 0;
    counts.clear();
    firstRow = 0;
    rows.clear();
  }

  void set(NearState other) {
    setList(other);
    rulings = other.rulings;
    if (rulingInts.length < rulings * RULING_INTS) {
      rulingInts = new int[other.rulingInts.length];
    }
    System.arraycopy(other.rulingInts, 0, rulingInts, 0, rulings * RULING_INTS);
    updating = other.updating;
    age = other.age;
    toldCount = 0;
    for (int i = 0; i < other.toldCount; i++) {
      tell(other.told[i]);
    }
    counts.set(other.counts);
    firstRow = other.firstRow;
    rows.set(other.rows);
  }

  /** Copies the list and the hash of another state, but not its update and its rulings. */
  void setList(NearState other) {
    rulings = 0;
    present = other.present;
    hash = other.hash;
    endUpdate();
    count = other.count;
    if (count > keys.length) {
      keys = new int[other.keys.length];
    }
    System.arraycopy(other.keys, 0, keys, 0, count);
  }

  /** Returns whether the client is told about near entities at all. */
  public boolean present() {
    return present;
  }

  /** Returns the number of near entities, the own one included. */
  public int count() {
    return count;
  }

  /** Returns whether the list has an entity, told by slot and generation. */
  public boolean lists(int key) {
    return find(key) >= 0;
  }

  /** Returns the place of an entity in the list, or -1. */
  int find(int key) {
    for (int i = 0; i < count; i++) {
      if (keys[i] == key) {
        return i;
      }
    }
    return -1;
  }

  /** Returns the slot and generation of an entity: {@code slot | generation << 16}. */
  public int key(int index) {
    return keys[index];
  }

  /** Returns the folded hash of the exact state of all listed entities, see {@link #fold}. */
  public int hash() {
    return hash;
  }

  /** Returns the 32 bits that are sent for a 64-bit hash. */
  public static int fold(long stateHash) {
    return (int) (stateHash ^ stateHash >>> 32);
  }

  /** Returns whether this section holds a part of an update. */
  public boolean updating() {
    return updating;
  }

  /** Returns the age of the update's base tick, in ticks before the snapshot's tick. */
  public int age() {
    return age;
  }

  /** Returns the number of entities that the update tells. */
  public int toldCount() {
    return toldCount;
  }

  /**
   * Returns the place in the list of a told entity. The index is 0..{@link #toldCount} - 1; places
   * ascend.
   */
  public int told(int index) {
    return told[index];
  }

  /** Returns the number of rows of the whole update. */
  public int totalRows() {
    return counts.total();
  }

  /** Returns the rows of the whole update by kind. The counts are live. */
  public RowCounts counts() {
    return counts;
  }

  /** Returns the number within the update of this part's first row. */
  public int firstRow() {
    return firstRow;
  }

  /** Returns the number of rows of this part. */
  public int partRows() {
    return rows.count();
  }

  /** Returns the rows of this part, of mixed kinds; see {@link #kind}. The rows are live. */
  public Rows rows() {
    return rows;
  }

  /** Returns an upper bound of the bits that the list takes for a client without a baseline. */
  public int listBits() {
    int bits = 0;
    for (int i = 0; i < count; i++) {
      bits += NearCodec.insertBits(i == 0 ? 0 : keys[i - 1], keys[i]);
    }
    return bits;
  }

  /** Returns whether both states list the same entities and have the same hash. */
  public boolean sameAs(NearState other) {
    return present == other.present && hash == other.hash && sameList(other);
  }

  boolean sameList(NearState other) {
    return Arrays.equals(keys, 0, count, other.keys, 0, other.count);
  }
}
