package carom.physics.dynamics.contact;

import static carom.physics.dynamics.contact.ContactTable.CONTACT;
import static carom.physics.dynamics.contact.ContactTable.NORMAL0;
import static carom.physics.dynamics.contact.ContactTable.NORMAL1;
import static carom.physics.dynamics.contact.ContactTable.TANGENT0;
import static carom.physics.dynamics.contact.ContactTable.TANGENT1;
import static carom.physics.dynamics.contact.ContactTable.TOTAL0;
import static carom.physics.dynamics.contact.ContactTable.TOTAL1;
import static carom.physics.dynamics.contact.ContactTable.TOUCHING;

import carom.physics.dynamics.store.ColumnHash;
import carom.physics.math.StateHash;
import java.util.Arrays;

/**
 * The hash of the rows of a contact table that touch. Every word of a row is multiplied by an odd
 * number that follows from the row's key, and what is at the same place of all rows is added up: so
 * no word waits for another, and neither the order of the rows matters nor which others there are.
 * What points that aren't there hold must be zero, which the table sees to.
 *
 * <p>Normals, places, gaps and sliding impulses of the whole step aren't in it: they follow from
 * the state before the step, and nothing in a step reads them.
 *
 * <p>Vectors do it where the JVM has them ({@link ContactHashLanes}), with the same bits. One
 * thread; allocates nothing.
 */
public final class ContactHash {
  /** Flags that count. */
  public static final int FLAGS = 0xff & ~(ContactTable.FRESH | ContactTable.WAS_PUSHED);

  /** Number of points, above the flags. */
  public static final int POINTS_SHIFT = 8;

  // Places of a row's words, by which sums are kept.
  static final int STATE = 0;
  static final int IDS = 1;
  public static final int START0 = 2;
  public static final int TOTALS0 = 3;
  public static final int START1 = 4;
  public static final int TOTALS1 = 5;
  private static final int ROLL = 6;
  private static final int PLACES = 7;

  private final long[] sums = new long[PLACES];

  /** Scratch of {@link ContactHashLanes}. */
  private final long[] factors = new long[ContactHashLanes.PIECE];

  private final long[] lanes = new long[3 * ContactHashLanes.SUMS];

  /**
   * Returns the odd number that stands for a key: its bits, mixed as {@link StateHash#finish} does.
   */
  static long factor(long key) {
    return StateHash.finish(key) | 1;
  }

  /**
   * Adds all touching rows.
   *
   * @param h the hash so far
   * @param rolls whether any row may have an impulse against rolling
   * @return the new hash
   */
  long mix(long h, ContactTable t, boolean rolls) {
    int n = t.count();
    Arrays.fill(sums, 0);
    int done =
        ContactHashLanes.FOUND == null ? 0 : ContactHashLanes.FOUND.rows(t, factors, lanes, sums);
    for (int row = done; row < n; row++) {
      if ((t.flags[row] & TOUCHING) != 0) {
        add(t, row);
      }
    }
    for (int row = 0; rolls && row < n; row++) {
      int roll = Float.floatToRawIntBits(t.roll[row]);
      if (roll != 0 && (t.flags[row] & TOUCHING) != 0) {
        sums[ROLL] += roll * factor(t.key[row]);
      }
    }
    for (long sum : sums) {
      h = StateHash.mix(h, sum);
    }
    return h;
  }

  private void add(ContactTable t, int row) {
    long factor = factor(t.key[row]);
    float[] c = t.contact;
    int at = row * CONTACT;
    sums[STATE] += (t.flags[row] & FLAGS | t.points[row] << POINTS_SHIFT) * factor;
    sums[IDS] += ColumnHash.scramble(t.id[2 * row], t.id[2 * row + 1]) * factor;
    sums[START0] += scramble(c[at + NORMAL0], c[at + TANGENT0]) * factor;
    sums[TOTALS0] += scramble(c[at + TOTAL0], 0) * factor;
    sums[START1] += scramble(c[at + NORMAL1], c[at + TANGENT1]) * factor;
    sums[TOTALS1] += scramble(c[at + TOTAL1], 0) * factor;
  }

  private static long scramble(float low, float high) {
    return ColumnHash.scramble(Float.floatToRawIntBits(low), Float.floatToRawIntBits(high));
  }
}
