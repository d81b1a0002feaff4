package carom.net.snapshot.table;

import carom.net.codec.BitWriter;
import carom.net.snapshot.ledger.DatagramLedger;
import java.util.Comparator;
import java.util.stream.IntStream;

/**
 * Tells one client of the rows of a room's tables that it may know and lacks, over datagrams that
 * get lost. A row is sent as soon as it changes, and again when its ack should have come, each time
 * with its newest words.
 *
 * <p>A row out of sight isn't told that it changed: what the client holds of it grows old, as with
 * entities. It is told anew when it comes back into sight.
 *
 * <p>One thread; allocates only to grow with the highest key.
 */
public final class TableOutbox implements DatagramLedger.Section {
  private static final int KEY_BITS = 16;

  private final Tables tables;
  private final RowKnowledge[] known;

  /** The places of the tables, urgent ones first. */
  private final int[] order;

  private final TableCodec codec;
  private final DatagramLedger ledger;
  private int tick = -1;
  private boolean stale = true;
  private int unacked;

  /**
   * Creates the outbox of a client that knows nothing but the rows at the start.
   *
   * @param tables the room's tables
   * @param audience what this client may know of them
   * @param ledger of the datagrams that rows are written into
   */
  public TableOutbox(Tables tables, RowAudience audience, DatagramLedger ledger) {
    this.tables = tables;
    this.ledger = ledger;
    codec = new TableCodec(tables.layouts());
    known = new RowKnowledge[tables.count()];
    for (int i = 0; i < known.length; i++) {
      known[i] = new RowKnowledge(tables.get(i), i, audience, ledger);
    }
    order =
        IntStream.range(0, known.length)
            .boxed()
            .sorted(Comparator.comparing(i -> !tables.get(i).layout().isUrgent()))
            .mapToInt(i -> i)
            .toArray();
  }

  /**
   * Tells that the class of audience of some rows in sight may have changed.
   *
   * @param table its place in the list of tables
   * @param block the keys are among the 64 from 64 {@code block} on
   * @param keys the lowest bit is the first of the block
   */
  public void audienceChanged(int table, int block, long keys) {
    known[table].audienceChanged(block, keys);
    stale = true;
  }

  /** Tells that the class of audience of any row may have changed. */
  public void audienceChanged() {
    for (RowKnowledge of : known) {
      of.audienceChanged();
    }
    stale = true;
  }

  /**
   * Returns how many rows the client isn't known to have.
   *
   * @param now tick of the tables' state
   */
  public int unacked(int now) {
    look(now);
    return unacked;
  }

  /**
   * Returns whether any row would be written now.
   *
   * @param now tick of the tables' state
   */
  public boolean hasDue(int now) {
    look(now);
    for (RowKnowledge of : known) {
      if (of.hasDue()) {
        return true;
      }
    }
    return false;
  }

  private void look(int now) {
    if (tick == now && !stale) {
      return;
    }
    tick = now;
    stale = false;
    unacked = 0;
    for (RowKnowledge of : known) {
      of.look(now);
      unacked += of.unacked();
    }
  }

  /**
   * Writes the table section of the datagram begun last.
   *
   * @param now tick of the tables' state, the datagram's
   * @param budgetBits for the rows; one is written anyway if it fits the writer
   */
  public void write(BitWriter w, int now, int budgetBits) {
    look(now);
    int room = Math.min(budgetBits, w.room() - TableCodec.END_BITS);
    int begin = w.bits();
    boolean first = true;
    codec.begin();
    for (int table : order) {
      RowKnowledge of = known[table];
      for (int key; (key = of.nextDue()) >= 0; ) {
        of.describe(key, now, codec);
        int most = codec.mostBits(table);
        first &= most + TableCodec.END_BITS <= w.room();
        if (!first && w.bits() - begin + most > room) {
          codec.next(w, false, 0);
          return;
        }
        codec.next(w, true, table);
        writeWords(w, tables.get(table).rows(), key);
        of.wrote(key, now);
        ledger.append(this, table << KEY_BITS | key, 0);
        first = false;
      }
    }
    codec.next(w, false, 0);
  }

  private void writeWords(BitWriter w, TableRows rows, int key) {
    for (long rest = codec.mask; rest != 0; rest &= rest - 1) {
      int word = Long.numberOfTrailingZeros(rest);
      codec.word(w, word, rows.get(key, word));
    }
  }

  @Override
  public void acknowledged(int datagramTick, int row, long bits) {
    known[row >>> KEY_BITS].ack(row & (1 << KEY_BITS) - 1, datagramTick);
    stale = true;
  }
}
