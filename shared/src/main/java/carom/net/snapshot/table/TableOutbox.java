package carom.net.snapshot.table;

import carom.net.codec.BitWriter;
import java.util.Arrays;
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
public final class TableOutbox {
  /** Rows that may be on their way; of more, the oldest count as lost. A power of two. */
  private static final int LOG = 1 << 12;

  private static final int MASK = LOG - 1;
  private static final int KEY_BITS = 16;

  /** Bits that rows may take of a datagram, unless the first one is longer. */
  private static final int MAX_BITS = 2_400;

  /** Time beyond the quickest ack that an ack is waited for, ticks. */
  private static final int PATIENCE = 3;

  private static final int MAX_WAIT = 60;

  private final Tables tables;
  private final RowKnowledge[] known;

  /** The places of the tables, urgent ones first. */
  private final int[] order;

  private final TableCodec codec;

  // By datagram: the rows that it had, as places in the log.
  private final long[] start;
  private final int[] count;

  /** Table and key of each row that was sent; nothing before the first row. */
  private int[] log = {};

  private long written;
  private int tick = -1;
  private boolean stale = true;
  private int unacked;
  private int waitTicks = MAX_WAIT / 2;

  /**
   * Creates the outbox of a client that knows nothing but the rows at the start.
   *
   * @param tables the room's tables
   * @param audience what this client may know of them
   * @param datagrams how many are remembered until their ack comes, a power of two
   */
  public TableOutbox(Tables tables, RowAudience audience, int datagrams) {
    this.tables = tables;
    codec = new TableCodec(tables.layouts());
    known = new RowKnowledge[tables.count()];
    for (int i = 0; i < known.length; i++) {
      known[i] = new RowKnowledge(tables.get(i), i, audience);
    }
    order =
        IntStream.range(0, known.length)
            .boxed()
            .sorted(Comparator.comparing(i -> !tables.get(i).layout().isUrgent()))
            .mapToInt(i -> i)
            .toArray();
    start = new long[datagrams];
    count = new int[datagrams];
  }

  /** Forgets all acks: the client knows nothing but the start. */
  public void reset() {
    for (RowKnowledge of : known) {
      of.reset();
    }
    Arrays.fill(count, 0);
    stale = true;
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
      of.look(now, waitTicks);
      unacked += of.unacked();
    }
  }

  /**
   * Writes the table section of a datagram.
   *
   * @param now tick of the tables' state, the datagram's
   * @param datagram its sequence number
   * @param budgetBits for the rows; one is written anyway if it fits the writer
   */
  public void write(BitWriter w, int now, int datagram, int budgetBits) {
    look(now);
    int at = datagram & start.length - 1;
    start[at] = written;
    count[at] = 0;
    int room = Math.min(Math.min(budgetBits, MAX_BITS), w.room() - TableCodec.END_BITS);
    int begin = w.bits();
    codec.begin();
    for (int table : order) {
      RowKnowledge of = known[table];
      for (int key; (key = of.nextDue()) >= 0; ) {
        of.describe(key, now, codec);
        int most = codec.mostBits(table);
        boolean first = count[at] == 0 && most + TableCodec.END_BITS <= w.room();
        if (!first && w.bits() - begin + most > room) {
          codec.next(w, false, 0);
          return;
        }
        codec.next(w, true, table);
        writeWords(w, tables.get(table).rows(), key);
        of.wrote(key, now);
        note(at, table, key);
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

  private void note(int at, int table, int key) {
    if (log.length == 0) {
      log = new int[LOG];
    }
    log[(int) written++ & MASK] = table << KEY_BITS | key;
    count[at]++;
  }

  /**
   * Takes the ack of a datagram.
   *
   * @param datagram its sequence number
   * @param datagramTick its tick
   */
  public void ack(int datagram, int datagramTick) {
    int at = datagram & start.length - 1;
    if (count[at] == 0 || written - start[at] > LOG) {
      return;
    }
    for (long i = start[at]; i < start[at] + count[at]; i++) {
      int row = log[(int) i & MASK];
      known[row >>> KEY_BITS].ack(row & (1 << KEY_BITS) - 1, datagramTick);
    }
    count[at] = 0;
    stale = true;
  }

  /** Takes how long the quickest ack took, ticks. */
  public void ackTook(int ticks) {
    waitTicks = Math.max(PATIENCE, Math.min(MAX_WAIT, ticks + PATIENCE));
  }
}
