package carom.net.field;

import carom.net.snapshot.table.TableLayout;
import carom.sim.pool.OrderLog;
import java.util.Arrays;

/**
 * The table of what acts on pools from outside: the rows of the {@link OrderLog} of the last
 * {@value #ROWS} periods, each under the remainder of its period. All players are told.
 */
public final class PoolTable {
  /** Number of keys. */
  public static final int ROWS = 16;

  private static final int ALL_CLASSES = 0xfffe;

  /** The shape of the table. */
  static final TableLayout LAYOUT =
      new TableLayout(ROWS, 0, true, all(Integer.SIZE), all(0), all(0), all(ALL_CLASSES), false);

  private PoolTable() {}

  /** Returns the key of a period's row. */
  public static int key(int period) {
    return period % ROWS;
  }

  private static int[] all(int value) {
    int[] words = new int[OrderLog.WORDS];
    Arrays.fill(words, value);
    return words;
  }
}
