package carom.physics.dynamics.contact;

import static carom.physics.dynamics.contact.ContactTable.CONTACT;
import static carom.physics.dynamics.contact.ContactTable.GAP1;
import static carom.physics.dynamics.contact.ContactTable.TOUCHING;
import static carom.physics.dynamics.contact.ContactTable.X1;

import carom.physics.archive.Archive;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.body.ShapeTable;
import java.util.Arrays;

/** A contact table as bytes. */
public final class ContactArchive {
  /** Most rows in an archive. */
  private static final int MAX_ROWS = 1 << 24;

  private ContactArchive() {}

  /**
   * Passes all rows through an archive, which must be copies; reading begins with an empty table.
   * Parts and materials aren't in it: they follow from the bodies. What points that aren't there
   * have left behind is zeroed first, so that equal states are equal bytes.
   */
  public static void pass(ContactTable t, Archive a, BodyStore bodies, ShapeTable parts) {
    for (int row = 0; row < t.count(); row++) {
      if (t.points[row] < 2) {
        t.id[2 * row + 1] = 0;
        Arrays.fill(t.contact, CONTACT * row + X1, CONTACT * row + GAP1 + 1, 0);
      }
    }
    int perRow = Long.BYTES + 2 + 2 * Integer.BYTES + Float.BYTES * (CONTACT + 1);
    int n = a.count("contacts", t.count(), MAX_ROWS, perRow);
    t.resize(n);
    a.bits("contact", t.key, n);
    for (int row = 0; a.reads() && row < n; row++) {
      checkKey(t, a, row, bodies);
      t.start(row, t.key[row], bodies, parts);
    }
    a.bytes("flags of contact", t.flags, n, Byte.MIN_VALUE, Byte.MAX_VALUE);
    a.bytes("points of contact", t.points, n, 0, 2);
    a.integers("feature of contact", t.id, 2 * n, Integer.MIN_VALUE, Integer.MAX_VALUE);
    a.numbers("number of contact", t.contact, CONTACT * n, BodyStore.MOST);
    a.numbers("rolling impulse of contact", t.roll, n, BodyStore.MOST);
    for (int row = 0; a.reads() && row < n; row++) {
      boolean sensor = parts.sensor[t.partA(row)] || parts.sensor[t.partB(row)];
      boolean touches = (t.flags[row] & TOUCHING) != 0;
      a.require(
          sensor == t.sensor(row) && touches && (t.points[row] > 0) != sensor,
          "flags=" + t.flags[row] + " points=" + t.points[row] + " of contact=" + row);
    }
  }

  private static void checkKey(ContactTable t, Archive a, int row, BodyStore bodies) {
    long k = t.key[row];
    int bodyA = t.bodyA(row);
    int bodyB = t.bodyB(row);
    a.require(
        (row == 0 || k > t.key[row - 1])
            && bodyA < bodyB
            && bodyB < bodies.slots()
            && bodies.type[bodyA] != BodyStore.FREE
            && bodies.type[bodyB] != BodyStore.FREE
            && ContactKey.partA(k) < bodies.partCount[bodyA]
            && ContactKey.partB(k) < bodies.partCount[bodyB],
        "contact=" + row + " of body=" + bodyA + " with body=" + bodyB);
  }
}
