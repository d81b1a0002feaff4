package carom.physics.dynamics;

import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.body.ShapeTable;
import carom.physics.dynamics.contact.BodyContacts;
import carom.physics.dynamics.contact.ContactKey;
import carom.physics.dynamics.contact.ContactTable;
import carom.physics.dynamics.contact.SleepingContacts;
import java.util.Arrays;

/**
 * The exact state of some bodies, with what they learnt about each other by touching, as numbers
 * that can be carried to another world: there the same bodies go on in the same way, to the bit.
 *
 * <p>A world continues alike if three things are alike: its bodies, with what pushes them in the
 * next step, the order of their slots (constraints are solved in that order), and the impulses its
 * contacts start with. So an excerpt lists bodies by ascending slot and names them by their place
 * in that list; static bodies that are not listed are named by their slot, so both worlds must have
 * the same ones there. What touches bodies outside of the list is left out and counted as a
 * {@linkplain #leaks leak}: such an excerpt goes on alike only until those bodies matter.
 *
 * <p>Mutable, reused; allocates only to grow. Joints are not in it.
 */
public final class Excerpt {
  /**
   * Numbers per body: x, y, cos, sin, vx, vy, omega, time of rest, and what acts in the next step:
   * impulse (x, y, turning) and force (x, y, torque); all are floats but {@link #ASLEEP}.
   */
  public static final int BODY_INTS = 14;

  /** The place of the time of rest among a body's numbers. */
  public static final int REST = 7;

  /**
   * Numbers per contact: A, B (places in the list, or the slot of a static body, inverted), parts,
   * points and flags, two feature ids, nine floats: normal (x, y), impulses to start with (normal
   * and tangential of each point, rolling), impulses of the last step.
   */
  public static final int CONTACT_INTS = 15;

  /** The first of a contact's numbers that are floats. */
  public static final int CONTACT_FLOATS = 6;

  /** In place of a time of rest: the body sleeps. */
  public static final int ASLEEP = -1;

  private static final int KEPT_FLAGS = ContactTable.VETOED;

  private int count;
  private int[] slots = new int[8];
  private int[] bodies = new int[8 * BODY_INTS];
  private int contactCount;
  private int[] contacts = new int[8 * CONTACT_INTS];
  private int leaks;
  private int[] placeOf = new int[0];
  private long[] keys = new long[8];
  private int[] ends = new int[8];

  /** Of contacts that come from another world, and their numbers by ascending key. */
  private final ContactTable rows = new ContactTable();

  private int[] order = new int[0];

  /** Makes an empty excerpt. */
  public Excerpt() {}

  /** Removes all bodies and contacts. */
  public void clear() {
    count = 0;
    contactCount = 0;
    leaks = 0;
  }

  /**
   * Lists a body.
   *
   * @param slot its index, larger than the last one's
   */
  public void add(int slot) {
    if (count > 0 && slot <= slots[count - 1]) {
      throw new IllegalArgumentException(
          "slot=" + slot + " must follow " + slots[count - 1] + "; list bodies by index");
    }
    if (count == slots.length) {
      slots = Arrays.copyOf(slots, 2 * count);
      bodies = Arrays.copyOf(bodies, slots.length * BODY_INTS);
    }
    slots[count++] = slot;
  }

  /**
   * Adds room for a contact, zeroed.
   *
   * @return where its numbers begin in {@link #contacts}
   */
  public int addContact() {
    if ((contactCount + 1) * CONTACT_INTS > contacts.length) {
      contacts = Arrays.copyOf(contacts, 2 * contacts.length);
    }
    int at = contactCount++ * CONTACT_INTS;
    Arrays.fill(contacts, at, at + CONTACT_INTS, 0);
    return at;
  }

  /** Bodies listed. */
  public int count() {
    return count;
  }

  /** The bodies' numbers, {@value #BODY_INTS} each; the live array, replaced when it grows. */
  public int[] bodies() {
    return bodies;
  }

  /** Contacts among the bodies, and with static ones. */
  public int contactCount() {
    return contactCount;
  }

  /** The contacts' numbers, {@value #CONTACT_INTS} each; the live array, replaced when it grows. */
  public int[] contacts() {
    return contacts;
  }

  /** Contacts that were left out, because they are with bodies that are not listed. */
  public int leaks() {
    return leaks;
  }

  void read(BodyStore store, BodyContacts links, ContactTable awake, SleepingContacts asleep) {
    if (placeOf.length < store.slots()) {
      placeOf = new int[Math.max(store.slots(), 2 * placeOf.length)];
      Arrays.fill(placeOf, -1);
    }
    for (int i = 0; i < count; i++) {
      placeOf[slots[i]] = i;
      readBody(store, slots[i], i * BODY_INTS);
    }
    contactCount = 0;
    leaks = 0;
    int found = 0;
    for (int i = 0; i < count; i++) {
      int body = slots[i];
      for (int end = links.firstEnd(body); end >= 0; end = links.nextEnd(end)) {
        found = find(store, awake, end, body, false, found);
      }
      for (int end = asleep.first(body); end >= 0; end = asleep.next(end)) {
        found = find(store, asleep.rows, end, body, true, found);
      }
    }
    sort(found);
    for (int i = 0; i < found; i++) {
      ContactTable table = (ends[i] & 1) == 0 ? awake : asleep.rows;
      readContact(table, ends[i] >> 1, addContact());
    }
    for (int i = 0; i < count; i++) {
      placeOf[slots[i]] = -1;
    }
  }

  private void readBody(BodyStore store, int slot, int at) {
    bodies[at] = Float.floatToRawIntBits(store.x[slot]);
    bodies[at + 1] = Float.floatToRawIntBits(store.y[slot]);
    bodies[at + 2] = Float.floatToRawIntBits(store.cos[slot]);
    bodies[at + 3] = Float.floatToRawIntBits(store.sin[slot]);
    bodies[at + 4] = Float.floatToRawIntBits(store.vx[slot]);
    bodies[at + 5] = Float.floatToRawIntBits(store.vy[slot]);
    bodies[at + 6] = Float.floatToRawIntBits(store.w[slot]);
    bodies[at + REST] =
        store.asleep(slot) ? ASLEEP : Float.floatToRawIntBits(store.sleepTime[slot]);
    bodies[at + 8] = Float.floatToRawIntBits(store.impulseX[slot]);
    bodies[at + 9] = Float.floatToRawIntBits(store.impulseY[slot]);
    bodies[at + 10] = Float.floatToRawIntBits(store.impulseW[slot]);
    bodies[at + 11] = Float.floatToRawIntBits(store.forceX[slot]);
    bodies[at + 12] = Float.floatToRawIntBits(store.forceY[slot]);
    bodies[at + 13] = Float.floatToRawIntBits(store.torque[slot]);
  }

  /** Remembers a row that belongs to the excerpt, once. */
  private int find(
      BodyStore store, ContactTable table, int end, int body, boolean asleep, int found) {
    int row = end >> 1;
    if (table.points[row] == 0 || (table.flags[row] & ContactTable.TOUCHING) == 0) {
      return found;
    }
    int other = (end & 1) == 0 ? table.bodyB(row) : table.bodyA(row);
    boolean listed = placeOf[other] >= 0;
    if (!listed && store.type[other] != BodyStore.STATIC) {
      leaks++;
      return found;
    }
    if (listed && table.bodyA(row) != body) {
      return found; // A's list has it, too
    }
    if (found == keys.length) {
      keys = Arrays.copyOf(keys, 2 * found);
      ends = Arrays.copyOf(ends, 2 * found);
    }
    keys[found] = table.key[row];
    ends[found] = 2 * row + (asleep ? 1 : 0);
    return found + 1;
  }

  private void sort(int n) {
    for (int i = 1; i < n; i++) {
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

  private void readContact(ContactTable t, int row, int at) {
    int n = t.points[row];
    contacts[at] = name(t.bodyA(row));
    contacts[at + 1] = name(t.bodyB(row));
    contacts[at + 2] =
        ContactKey.partA(t.key[row]) << BodyStore.PART_BITS | ContactKey.partB(t.key[row]);
    contacts[at + 3] = n | (t.flags[row] & KEPT_FLAGS) << 8;
    contacts[at + 4] = t.id[2 * row];
    contacts[at + 5] = n > 1 ? t.id[2 * row + 1] : 0;
    float[] c = t.contact;
    int from = row * ContactTable.CONTACT;
    contacts[at + 6] = Float.floatToRawIntBits(c[from + ContactTable.NX]);
    contacts[at + 7] = Float.floatToRawIntBits(c[from + ContactTable.NY]);
    contacts[at + 8] = Float.floatToRawIntBits(c[from + ContactTable.NORMAL0]);
    contacts[at + 9] = Float.floatToRawIntBits(c[from + ContactTable.TANGENT0]);
    contacts[at + 10] = n > 1 ? Float.floatToRawIntBits(c[from + ContactTable.NORMAL1]) : 0;
    contacts[at + 11] = n > 1 ? Float.floatToRawIntBits(c[from + ContactTable.TANGENT1]) : 0;
    contacts[at + 12] = Float.floatToRawIntBits(t.roll[row]);
    contacts[at + 13] = Float.floatToRawIntBits(c[from + ContactTable.TOTAL0]);
    contacts[at + 14] = n > 1 ? Float.floatToRawIntBits(c[from + ContactTable.TOTAL1]) : 0;
  }

  private int name(int slot) {
    return placeOf[slot] >= 0 ? placeOf[slot] : ~slot;
  }

  /** The slot of a listed body. */
  int slot(int place) {
    return slots[place];
  }

  void writeBody(BodyStore store, int place) {
    int slot = slots[place];
    int at = place * BODY_INTS;
    store.x[slot] = Float.intBitsToFloat(bodies[at]);
    store.y[slot] = Float.intBitsToFloat(bodies[at + 1]);
    store.cos[slot] = Float.intBitsToFloat(bodies[at + 2]);
    store.sin[slot] = Float.intBitsToFloat(bodies[at + 3]);
    store.vx[slot] = Float.intBitsToFloat(bodies[at + 4]);
    store.vy[slot] = Float.intBitsToFloat(bodies[at + 5]);
    store.w[slot] = Float.intBitsToFloat(bodies[at + 6]);
    store.sleepTime[slot] = sleeps(place) ? 0 : Float.intBitsToFloat(bodies[at + REST]);
    store.impulseX[slot] = Float.intBitsToFloat(bodies[at + 8]);
    store.impulseY[slot] = Float.intBitsToFloat(bodies[at + 9]);
    store.impulseW[slot] = Float.intBitsToFloat(bodies[at + 10]);
    store.forceX[slot] = Float.intBitsToFloat(bodies[at + 11]);
    store.forceY[slot] = Float.intBitsToFloat(bodies[at + 12]);
    store.torque[slot] = Float.intBitsToFloat(bodies[at + 13]);
  }

  boolean sleeps(int place) {
    return bodies[place * BODY_INTS + REST] == ASLEEP;
  }

  /**
   * Adds the contacts to a world's. What names no body, or no part, of this world is left out, and
   * so is a contact that came before.
   */
  void writeContacts(BodyStore store, ShapeTable parts, ContactTable to) {
    rows.clear();
    int written = readRows(store, parts);
    if (order.length < written) {
      order = new int[2 * written];
    }
    for (int i = 0; i < written; i++) {
      order[i] = i;
    }
    rows.sortByKey(order, written);
    int unique = 0;
    for (int i = 0; i < written; i++) {
      if (i == 0 || rows.key[order[i]] != rows.key[order[i - 1]]) {
        order[unique++] = order[i];
      }
    }
    to.order().insert(rows, order, unique);
  }

  /** Makes rows of the contacts; answers how many. */
  private int readRows(BodyStore store, ShapeTable parts) {
    int written = 0;
    for (int i = 0; i < contactCount; i++) {
      int at = i * CONTACT_INTS;
      int a = slotOf(store, contacts[at]);
      int b = slotOf(store, contacts[at + 1]);
      int partA = contacts[at + 2] >>> BodyStore.PART_BITS;
      int partB = contacts[at + 2] & (1 << BodyStore.PART_BITS) - 1;
      int points = contacts[at + 3] & 0xff;
      if (a < 0
          || b <= a
          || partA >= store.partCount[a]
          || partB >= store.partCount[b]
          || points < 1
          || points > 2) {
        continue;
      }
      long key = ContactKey.of(a, partA, b, partB);
      int row = rows.append();
      rows.start(row, key, store, parts);
      rows.flags[row] |= (byte) (ContactTable.TOUCHING | (contacts[at + 3] >> 8 & KEPT_FLAGS));
      rows.points[row] = (byte) points;
      rows.id[2 * row] = contacts[at + 4];
      rows.id[2 * row + 1] = contacts[at + 5];
      float[] c = rows.contact;
      int into = row * ContactTable.CONTACT;
      c[into + ContactTable.NX] = Float.intBitsToFloat(contacts[at + 6]);
      c[into + ContactTable.NY] = Float.intBitsToFloat(contacts[at + 7]);
      c[into + ContactTable.NORMAL0] = Float.intBitsToFloat(contacts[at + 8]);
      c[into + ContactTable.TANGENT0] = Float.intBitsToFloat(contacts[at + 9]);
      c[into + ContactTable.NORMAL1] = Float.intBitsToFloat(contacts[at + 10]);
      c[into + ContactTable.TANGENT1] = Float.intBitsToFloat(contacts[at + 11]);
      rows.roll[row] = Float.intBitsToFloat(contacts[at + 12]);
      c[into + ContactTable.TOTAL0] = Float.intBitsToFloat(contacts[at + 13]);
      c[into + ContactTable.TOTAL1] = Float.intBitsToFloat(contacts[at + 14]);
      written++;
    }
    return written;
  }

  private int slotOf(BodyStore store, int name) {
    if (name >= 0) {
      return name < count ? slots[name] : -1;
    }
    int slot = ~name;
    return slot < store.slots() && store.type[slot] == BodyStore.STATIC ? slot : -1;
  }
}
