package carom.physics.dynamics;

import carom.physics.dynamics.body.ShapeTable;
import carom.physics.dynamics.contact.ContactTable;
import java.util.Arrays;

/**
 * The friction, restitution and surface speed that callbacks set for single contacts. They hold for
 * the step in which they are set: {@link #end} mixes the materials of the parts again, with the
 * same bits as before. So they are no state, and a step without any pays nothing.
 *
 * <p>One thread; allocates only to grow.
 */
public final class ContactOverrides {
  private final ContactTable table;
  private final ShapeTable parts;

  /** The row that a callback decides about, -1 for none. */
  private int deciding = -1;

  /** The changed rows, some perhaps twice. */
  private int[] rows = new int[16];

  private int count;

  /** Changes contacts of this table, whose rows are of these parts. */
  public ContactOverrides(ContactTable table, ShapeTable parts) {
    this.table = table;
    this.parts = parts;
  }

  /** Begins a step; what a step before has left behind, because a callback failed, is forgotten. */
  public void begin() {
    count = 0;
    deciding = -1;
  }

  /**
   * Sets the row that may be changed from now on.
   *
   * @param row -1 for none
   */
  public void decide(int row) {
    deciding = row;
  }

  /** Returns whether a row may be changed now. */
  public boolean decides(int row) {
    return row == deciding;
  }

  /**
   * Sets one of the mixed numbers of a row for this step.
   *
   * @param row one that {@link #decides}
   * @param place {@code ContactColumns.FRICTION}, {@code ContactColumns.RESTITUTION} or {@code
   *     ContactColumns.SURFACE}
   * @param value in the unit of that place
   */
  public void set(int row, int place, float value) {
    if (count == rows.length) {
      rows = Arrays.copyOf(rows, 2 * count);
    }
    rows[count++] = row;
    table.setMaterial(row, place, value);
  }

  /** Ends a step: the contacts have the materials of their parts again. Rows haven't moved. */
  public void end() {
    for (int i = 0; i < count; i++) {
      table.mix(rows[i], parts);
    }
    count = 0;
  }
}
