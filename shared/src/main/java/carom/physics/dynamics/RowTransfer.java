package carom.physics.dynamics;

import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.body.ShapeTable;
import carom.physics.dynamics.contact.BodyContacts;
import carom.physics.dynamics.contact.ContactKey;
import carom.physics.dynamics.contact.ContactTable;
import carom.physics.dynamics.contact.SleepingContacts;
import carom.physics.dynamics.joint.JointTransfer;
import carom.physics.rows.BodyRow;
import carom.physics.rows.ContactRow;
import carom.physics.rows.ExactRows;
import carom.physics.rows.Rows;
import java.util.Arrays;

/**
 * Reads bodies and their contacts out of a world into {@link ExactRows}, and writes such rows into
 * it; joints by {@link JointTransfer}. One world's; allocates only to grow.
 */
final class RowTransfer {
  private static final int KEPT_FLAGS = ContactTable.VETOED;

  private final BodyStore store;
  private final ShapeTable parts;
  private final ContactTable awake;
  private final SleepingContacts asleep;
  private final BodyContacts links;
  private final JointTransfer joints;
  private final EndedContacts ended;

  /** By slot: the place of a listed body, or -1; all are -1 between calls. */
  private int[] placeOf = new int[0];

  // Contacts found: their keys, and 2 * row, plus 1 if they sleep.
  private int found;
  private long[] keys = new long[8];
  private int[] ends = new int[8];
  private int leaks;

  /** Contacts that come from another world. */
  private final ContactTable arrived = new ContactTable();

  /** Rows of {@link #arrived} by ascending key. */
  private int[] order = new int[0];

  RowTransfer(
      BodyStore store,
      ShapeTable parts,
      ContactTable awake,
      SleepingContacts asleep,
      BodyContacts links,
      JointTransfer joints,
      EndedContacts ended) {
    this.store = store;
    this.parts = parts;
    this.awake = awake;
    this.asleep = asleep;
    this.links = links;
    this.joints = joints;
    this.ended = ended;
  }

  /**
   * Reads the listed bodies, and the joints and contacts among them and with statics.
   *
   * @return what may have acted on listed bodies in the last step and isn't among the rows:
   *     contacts whose other body is not listed, near misses included, and bodies of contacts that
   *     a call has ended since
   */
  int read(ExactRows rows) {
    int count = rows.bodies().count();
    if (placeOf.length < store.slots()) {
      placeOf = new int[Math.max(store.slots(), 2 * placeOf.length)];
      Arrays.fill(placeOf, -1);
    }
    for (int i = 0; i < count; i++) {
      placeOf[rows.slot(i)] = i;
      readBody(rows.slot(i), rows.bodies().ints(), rows.bodies().at(i));
    }
    leaks = 0;
    found = 0;
    for (int i = 0; i < count; i++) {
      int body = rows.slot(i);
      leaks += ended.has(body) ? 1 : 0;
      for (int end = links.firstEnd(body); end >= 0; end = links.nextEnd(end)) {
        find(awake, end, body, false);
      }
      for (int end = asleep.first(body); end >= 0; end = asleep.next(end)) {
        find(asleep.rows, end, body, true);
      }
    }
    sort();
    Rows contacts = rows.contacts();
    contacts.clear();
    for (int i = 0; i < found; i++) {
      ContactTable table = (ends[i] & 1) == 0 ? awake : asleep.rows;
      int at = contacts.add();
      readContact(table, ends[i] >> 1, contacts.ints(), at);
    }
    joints.read(rows, placeOf);
    for (int i = 0; i < count; i++) {
      placeOf[rows.slot(i)] = -1;
    }
    return leaks;
  }

  /** Reads the state of a body into its row, which begins at an index. */
  void readBody(int slot, int[] row, int at) {
    row[at + BodyRow.X] = Float.floatToRawIntBits(store.x[slot]);
    row[at + BodyRow.Y] = Float.floatToRawIntBits(store.y[slot]);
    row[at + BodyRow.COS] = Float.floatToRawIntBits(store.cos[slot]);
    row[at + BodyRow.SIN] = Float.floatToRawIntBits(store.sin[slot]);
    row[at + BodyRow.VX] = Float.floatToRawIntBits(store.vx[slot]);
    row[at + BodyRow.VY] = Float.floatToRawIntBits(store.vy[slot]);
    row[at + BodyRow.OMEGA] = Float.floatToRawIntBits(store.w[slot]);
    row[at + BodyRow.SLEEP_TIME] =
        store.asleep(slot) ? BodyRow.ASLEEP : Float.floatToRawIntBits(store.sleepTime[slot]);
    row[at + BodyRow.IMPULSE_X] = Float.floatToRawIntBits(store.impulseX[slot]);
    row[at + BodyRow.IMPULSE_Y] = Float.floatToRawIntBits(store.impulseY[slot]);
    row[at + BodyRow.ANGULAR_IMPULSE] = Float.floatToRawIntBits(store.impulseW[slot]);
    row[at + BodyRow.FORCE_X] = Float.floatToRawIntBits(store.forceX[slot]);
    row[at + BodyRow.FORCE_Y] = Float.floatToRawIntBits(store.forceY[slot]);
    row[at + BodyRow.TORQUE] = Float.floatToRawIntBits(store.torque[slot]);
  }

  /** Notes a contact that belongs to the rows, once. */
  private void find(ContactTable table, int end, int body, boolean sleeps) {
    int row = end >> 1;
    int other = (end & 1) == 0 ? table.bodyB(row) : table.bodyA(row);
    boolean listed = placeOf[other] >= 0;
    if (!listed && store.type[other] != BodyStore.STATIC) {
      leaks += table.sensor(row) ? 0 : 1; // also if it is only near: elsewhere it may touch
      return;
    }
    if (table.points[row] == 0 || (table.flags[row] & ContactTable.TOUCHING) == 0) {
      return;
    }
    if (listed && table.bodyA(row) != body) {
      return; // A's list has it, too
    }
    if (found == keys.length) {
      keys = Arrays.copyOf(keys, 2 * found);
      ends = Arrays.copyOf(ends, 2 * found);
    }
    keys[found] = table.key[row];
    ends[found] = 2 * row + (sleeps ? 1 : 0);
    found++;
  }

  private void sort() {
    for (int i = 1; i < found; i++) {
      long key = keys[i];
      int end = ends[i];
      int j = i;
      for (; j > 0 && keys[j - 1] > key; j--) {
        keys[j] = keys[j - 1];
        ends[j] = ends[j - 1];
      }
      keys[j] = key;
      ends[j] = end;
    }
  }

  private void readContact(ContactTable t, int from, int[] row, int at) {
    boolean two = t.points[from] > 1;
    row[at + ContactRow.END_A] = end(t.bodyA(from));
    row[at + ContactRow.END_B] = end(t.bodyB(from));
    row[at + ContactRow.PARTS] =
        ContactKey.partA(t.key[from]) << BodyStore.PART_BITS | ContactKey.partB(t.key[from]);
    row[at + ContactRow.POINTS_AND_FLAGS] =
        t.points[from] | (t.flags[from] & KEPT_FLAGS) << ContactRow.FLAGS_SHIFT;
    row[at + ContactRow.ID_0] = t.id[2 * from];
    row[at + ContactRow.ID_1] = two ? t.id[2 * from + 1] : 0;
    row[at + ContactRow.NORMAL_X] = bits(t, from, ContactTable.NX);
    row[at + ContactRow.NORMAL_Y] = bits(t, from, ContactTable.NY);
    row[at + ContactRow.NORMAL_IMPULSE_0] = bits(t, from, ContactTable.NORMAL0);
    row[at + ContactRow.TANGENT_IMPULSE_0] = bits(t, from, ContactTable.TANGENT0);
    row[at + ContactRow.NORMAL_IMPULSE_1] = two ? bits(t, from, ContactTable.NORMAL1) : 0;
    row[at + ContactRow.TANGENT_IMPULSE_1] = two ? bits(t, from, ContactTable.TANGENT1) : 0;
    row[at + ContactRow.ROLLING_IMPULSE] = Float.floatToRawIntBits(t.roll[from]);
    row[at + ContactRow.TOTAL_IMPULSE_0] = bits(t, from, ContactTable.TOTAL0);
    row[at + ContactRow.TOTAL_IMPULSE_1] = two ? bits(t, from, ContactTable.TOTAL1) : 0;
  }

  private static int bits(ContactTable t, int from, int column) {
    return Float.floatToRawIntBits(t.contact[from * ContactTable.CONTACT + column]);
  }

  private int end(int slot) {
    return placeOf[slot] >= 0 ? placeOf[slot] : ~slot;
  }

  /** Gives the listed bodies the state of their rows; none falls asleep by that. */
  void writeBodies(ExactRows rows) {
    for (int i = 0; i < rows.bodies().count(); i++) {
      writeBody(rows.slot(i), rows.isAsleep(i), rows.bodies().ints(), rows.bodies().at(i));
    }
  }

  /** Gives a body the state of its row; it doesn't fall asleep by that. */
  void writeBody(int slot, boolean sleeps, int[] row, int at) {
    store.x[slot] = Float.intBitsToFloat(row[at + BodyRow.X]);
    store.y[slot] = Float.intBitsToFloat(row[at + BodyRow.Y]);
    store.cos[slot] = Float.intBitsToFloat(row[at + BodyRow.COS]);
    store.sin[slot] = Float.intBitsToFloat(row[at + BodyRow.SIN]);
    store.vx[slot] = Float.intBitsToFloat(row[at + BodyRow.VX]);
    store.vy[slot] = Float.intBitsToFloat(row[at + BodyRow.VY]);
    store.w[slot] = Float.intBitsToFloat(row[at + BodyRow.OMEGA]);
    store.sleepTime[slot] = sleeps ? 0 : Float.intBitsToFloat(row[at + BodyRow.SLEEP_TIME]);
    store.impulseX[slot] = Float.intBitsToFloat(row[at + BodyRow.IMPULSE_X]);
    store.impulseY[slot] = Float.intBitsToFloat(row[at + BodyRow.IMPULSE_Y]);
    store.impulseW[slot] = Float.intBitsToFloat(row[at + BodyRow.ANGULAR_IMPULSE]);
    store.forceX[slot] = Float.intBitsToFloat(row[at + BodyRow.FORCE_X]);
    store.forceY[slot] = Float.intBitsToFloat(row[at + BodyRow.FORCE_Y]);
    store.torque[slot] = Float.intBitsToFloat(row[at + BodyRow.TORQUE]);
  }

  /**
   * Adds the contacts to the world's. A row that names no body, or no part, of this world is left
   * out, and so is a contact that came before.
   */
  void writeContacts(ExactRows rows) {
    arrived.clear();
    for (int i = 0; i < rows.contacts().count(); i++) {
      writeContact(rows, rows.contacts().ints(), rows.contacts().at(i));
    }
    int written = arrived.count();
    if (order.length < written) {
      order = new int[2 * written];
    }
    for (int i = 0; i < written; i++) {
      order[i] = i;
    }
    arrived.sortByKey(order, written);
    int unique = 0;
    for (int i = 0; i < written; i++) {
      if (i == 0 || arrived.key[order[i]] != arrived.key[order[i - 1]]) {
        order[unique++] = order[i];
      }
    }
    awake.order().insert(arrived, order, unique);
  }

  private void writeContact(ExactRows rows, int[] row, int at) {
    int a = slotOfEnd(rows, row[at + ContactRow.END_A]);
    int b = slotOfEnd(rows, row[at + ContactRow.END_B]);
    int partA = row[at + ContactRow.PARTS] >>> BodyStore.PART_BITS;
    int partB = row[at + ContactRow.PARTS] & (1 << BodyStore.PART_BITS) - 1;
    int pointsAndFlags = row[at + ContactRow.POINTS_AND_FLAGS];
    int points = pointsAndFlags & ContactRow.POINTS_MASK;
    if (a < 0
        || b <= a
        || partA >= store.partCount[a]
        || partB >= store.partCount[b]
        || points < 1
        || points > 2) {
      return;
    }
    int to = arrived.append();
    arrived.start(to, ContactKey.of(a, partA, b, partB), store, parts);
    arrived.flags[to] |=
        (byte) (ContactTable.TOUCHING | (pointsAndFlags >> ContactRow.FLAGS_SHIFT & KEPT_FLAGS));
    arrived.points[to] = (byte) points;
    arrived.id[2 * to] = row[at + ContactRow.ID_0];
    arrived.id[2 * to + 1] = row[at + ContactRow.ID_1];
    setFloat(to, ContactTable.NX, row[at + ContactRow.NORMAL_X]);
    setFloat(to, ContactTable.NY, row[at + ContactRow.NORMAL_Y]);
    setFloat(to, ContactTable.NORMAL0, row[at + ContactRow.NORMAL_IMPULSE_0]);
    setFloat(to, ContactTable.TANGENT0, row[at + ContactRow.TANGENT_IMPULSE_0]);
    setFloat(to, ContactTable.NORMAL1, row[at + ContactRow.NORMAL_IMPULSE_1]);
    setFloat(to, ContactTable.TANGENT1, row[at + ContactRow.TANGENT_IMPULSE_1]);
    arrived.roll[to] = Float.intBitsToFloat(row[at + ContactRow.ROLLING_IMPULSE]);
    setFloat(to, ContactTable.TOTAL0, row[at + ContactRow.TOTAL_IMPULSE_0]);
    setFloat(to, ContactTable.TOTAL1, row[at + ContactRow.TOTAL_IMPULSE_1]);
  }

  private void setFloat(int to, int column, int bits) {
    arrived.contact[to * ContactTable.CONTACT + column] = Float.intBitsToFloat(bits);
  }

  /** Returns the slot of a contact's end, or -1 if this world has no such body. */
  private int slotOfEnd(ExactRows rows, int end) {
    if (end >= 0) {
      return end < rows.bodies().count() ? rows.slot(end) : -1;
    }
    int slot = ~end;
    return slot < store.slots() && store.type[slot] == BodyStore.STATIC ? slot : -1;
  }
}
