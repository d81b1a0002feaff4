package carom.physics.rows;

import carom.physics.math.StateHash;
import java.util.Arrays;

/**
 * The exact state of some bodies and of the joints and contacts among them, as rows of ints that
 * can be carried to another world. There the same bodies go on in the same way, to the bit.
 *
 * <p>Two worlds continue alike if three things are alike: the bodies, with what acts on them in the
 * next step; the order of the slots of bodies and joints, because constraints are solved in that
 * order; and the impulses that joints and contacts start with. So bodies and joints are listed by
 * ascending slot, and joints and contacts name bodies by their place in that list. The slots
 * themselves are no part of a row: each world has its own.
 *
 * <p>A row of a joint holds its state and what a game may change. The constants of a joint are its
 * {@link JointDefRow}, from which the other world has made it before.
 *
 * <pre>
 *   one world                                                       another world
 *   addBody(slot)   ┌───────────────────────────────────────────┐   setSlot(place, slot)
 *   readRows ──────►│ slots │ 12        │ 17        │ 40        │   setJointSlot(row, slot)
 *                   │ BODY  │ place 0   │ place 1   │ place 2   │──────► writeRows
 *                   │ JOINT    0-1                              │
 *                   │ CONTACT  0-1  1-2  2-~3                   │   (~3: a static of both worlds)
 *                   └───────────────────────────────────────────┘
 * </pre>
 *
 * <p>Mutable, reused; one thread; allocates only to grow.
 */
public final class ExactRows {
  private static final RowKind[] KINDS = RowKind.values();
  private static final int NO_SLOT = -1;

  /** By kind: its rows. */
  private final Rows[] rows = new Rows[KINDS.length];

  private final Rows bodies;
  private final Rows joints;
  private final Rows contacts;

  /** By place: the slot of the body in a world. */
  private int[] slots = new int[8];

  /** By row of a joint: its slot in a world. */
  private int[] jointSlots = new int[8];

  private int cutJoints;

  /** Creates an empty list. */
  public ExactRows() {
    for (RowKind kind : KINDS) {
      rows[kind.ordinal()] = Rows.of(kind);
    }
    bodies = of(RowKind.BODY);
    joints = of(RowKind.JOINT);
    contacts = of(RowKind.CONTACT);
  }

  /** Returns the rows of a kind: the live list. Bodies must be added by this class's methods. */
  public Rows of(RowKind kind) {
    return rows[kind.ordinal()];
  }

  /** Returns the rows of bodies, whose fields {@link BodyRow} declares. */
  public Rows bodies() {
    return bodies;
  }

  /** Returns the rows of joints, whose fields {@link JointRow} declares. */
  public Rows joints() {
    return joints;
  }

  /** Returns the rows of contacts, whose fields {@link ContactRow} declares. */
  public Rows contacts() {
    return contacts;
  }

  /** Removes all rows. */
  public void clear() {
    for (Rows of : rows) {
      of.clear();
    }
    cutJoints = 0;
  }

  /**
   * Adds a body of a world, whose row is zero until it is read.
   *
   * @param slot its index in the world, larger than that of the body before
   * @throws IllegalArgumentException if the slot isn't larger
   */
  public void addBody(int slot) {
    bodies.add();
    reserveSlots();
    setSlot(bodies.count() - 1, slot);
  }

  /**
   * Adds a copy of a row that comes from elsewhere. A body has no slot until {@link #setSlot}, a
   * joint none until {@link #setJointSlot}.
   *
   * @param from holds the row
   * @param at where it begins
   */
  public void add(RowKind kind, int[] from, int at) {
    of(kind).add(kind, from, at);
    if (kind == RowKind.BODY) {
      reserveSlots();
      slots[bodies.count() - 1] = NO_SLOT;
    } else if (kind == RowKind.JOINT) {
      reserveJointSlots();
      jointSlots[joints.count() - 1] = NO_SLOT;
    }
  }

  /**
   * Adds a joint of a world, whose row is zero until it is read.
   *
   * @param slot its index in the world, larger than that of the joint before
   * @return where its ints begin in the rows of joints
   */
  public int addJoint(int slot) {
    int at = joints.add();
    reserveJointSlots();
    jointSlots[joints.count() - 1] = slot;
    return at;
  }

  private void reserveJointSlots() {
    if (jointSlots.length < joints.count()) {
      jointSlots = Arrays.copyOf(jointSlots, 2 * joints.count());
    }
  }

  /** Returns the slot of the joint of a row, or -1 if it has none yet. */
  public int jointSlot(int row) {
    return jointSlots[row];
  }

  /** Says which joint of a world a row stands for: its index there. */
  public void setJointSlot(int row, int slot) {
    jointSlots[row] = slot;
  }

  /**
   * Returns how many joints of listed bodies hold bodies that are not listed, and so have no row,
   * as of the last time that a world read these rows. A world that lacks such a joint moves the
   * bodies in another way at once.
   */
  public int cutJoints() {
    return cutJoints;
  }

  /** Sets the number that {@link #cutJoints} returns. */
  public void cutJoints(int count) {
    cutJoints = count;
  }

  private void reserveSlots() {
    if (slots.length < bodies.count()) {
      slots = Arrays.copyOf(slots, 2 * slots.length);
    }
  }

  /** Returns the slot of the body at a place, or -1 if it has none yet. */
  public int slot(int place) {
    return slots[place];
  }

  /**
   * Says which body of a world a row stands for.
   *
   * @param slot its index in the world, larger than that of the body before
   * @throws IllegalArgumentException if the slot isn't larger
   */
  public void setSlot(int place, int slot) {
    if (place > 0 && slot <= slots[place - 1]) {
      throw new IllegalArgumentException(
          "slot=" + slot + " must follow " + slots[place - 1] + "; list bodies by index");
    }
    slots[place] = slot;
  }

  /** Returns whether the body at a place sleeps, or is to sleep. */
  public boolean isAsleep(int place) {
    return bodies.get(place, BodyRow.SLEEP_TIME) == BodyRow.ASLEEP;
  }

  /**
   * Returns a hash of all rows, 64 bits; slots don't count. Each row is hashed for itself first, so
   * that a processor does several at a time.
   */
  public long hash() {
    long h = StateHash.mix(StateHash.SEED, bodies.count());
    for (RowKind kind : KINDS) {
      Rows of = of(kind);
      for (int row = 0; row < of.count(); row++) {
        h = StateHash.mix(h, hash(of.ints(), of.at(row), kind.ints()));
      }
    }
    return StateHash.finish(h);
  }

  /** Returns a hash of one body's row, 64 bits. */
  public long bodyHash(int place) {
    return hash(bodies.ints(), bodies.at(place), BodyRow.INTS);
  }

  /** Mixes two ints at a time, and a first one alone if their number is odd. */
  private static long hash(int[] row, int at, int count) {
    long h = StateHash.SEED;
    int from = at;
    if ((count & 1) == 1) {
      h = StateHash.mix(h, row[from++]);
    }
    for (int i = from; i < at + count; i += 2) {
      h = StateHash.mix(h, (long) row[i] << Integer.SIZE | row[i + 1] & 0xffffffffL);
    }
    return h;
  }
}
