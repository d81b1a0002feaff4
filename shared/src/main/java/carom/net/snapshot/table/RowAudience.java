package carom.net.snapshot.table;

/** Says what one client may know of the tables, at present. */
public interface RowAudience {
  /** The class of audience that may know nothing of a row. */
  int NOBODY = 0;

  /**
   * Returns those of some keys, out of 64 neighbours, of which the client may know anything.
   *
   * @param table the table's place in the list of tables
   * @param block the neighbours are the 64 keys from 64 {@code block} on
   * @param keys the keys asked for: the lowest bit is the first of the block
   */
  long inSight(int table, int block, long keys);

  /**
   * Returns the class of the {@link TableLayout} that the client belongs to for a row in sight.
   * {@link #NOBODY}, if it may know nothing of it.
   */
  int of(int table, int key);
}
