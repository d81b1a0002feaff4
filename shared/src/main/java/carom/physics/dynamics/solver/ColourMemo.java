package carom.physics.dynamics.solver;

import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.contact.ContactTable;
import java.util.Arrays;

/**
 * Remembers the inputs of the last colouring, to tell whether this step's colours are the same. The
 * inputs are the rows, their numbers of points, which bodies are active, their domains, and their
 * masses.
 *
 * <p>A memo isn't state. It only says that colouring anew would give the same colours, since
 * everything that colouring reads is equal, number by number; so nothing of it is saved, hashed or
 * sent, and no bit depends on which steps came before. Comparing costs a tenth of colouring.
 */
final class ColourMemo {
  /** Flags of rows that aren't solved, or only look so. Steps with any aren't remembered. */
  private static final int REFUSED = ContactTable.DORMANT | ContactTable.VETOED;

  /** Most bodies per row of a step that is remembered. Where there are more, most of them sleep. */
  private static final int BODIES_PER_ROW = 4;

  private boolean valid;
  private int rows;
  private int slots;

  /** {@code Domains.edition}. */
  private int edition;

  /** {@code JointTrees.edition}. */
  private int treeEdition;

  private long[] key = new long[0];
  private byte[] points = new byte[0];
  private float[] inverseMass = new float[0];

  /** Returns whether the colours of what was {@link #note noted} are those of this step. */
  public boolean holds(ContactTable t, BodyStore b, int edition, int treeEdition) {
    return valid
        && this.edition == edition
        && this.treeEdition == treeEdition
        && rows == t.count()
        && slots == b.slots()
        && Arrays.equals(points, 0, rows, t.points, 0, rows)
        && plain(t)
        && Arrays.equals(inverseMass, 0, slots, b.invMass, 0, slots)
        && Arrays.equals(key, 0, rows, t.key, 0, rows);
  }

  /** Notes what the colours of this step follow from. */
  public void note(ContactTable t, BodyStore b, int edition, int treeEdition) {
    valid = b.slots() <= BODIES_PER_ROW * t.count() && plain(t);
    if (!valid) {
      return;
    }
    this.edition = edition;
    this.treeEdition = treeEdition;
    rows = t.count();
    slots = b.slots();
    if (key.length < rows) {
      key = new long[t.capacity()];
      points = new byte[key.length];
    }
    if (inverseMass.length < slots) {
      inverseMass = new float[slots + slots / 2];
    }
    System.arraycopy(t.key, 0, key, 0, rows);
    System.arraycopy(t.points, 0, points, 0, rows);
    System.arraycopy(b.invMass, 0, inverseMass, 0, slots);
  }

  private static boolean plain(ContactTable t) {
    int any = 0;
    for (int row = 0; row < t.count(); row++) {
      any |= t.flags[row];
    }
    return (any & REFUSED & 0xff) == 0;
  }
}
