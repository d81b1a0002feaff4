package carom.net.snapshot.table;

import carom.net.snapshot.frame.SlotSet;
import carom.net.snapshot.ledger.DatagramLedger;
import carom.net.snapshot.ledger.Resend;
import java.util.Arrays;

/**
 * The server's knowledge of what one client knows of one table. It tells which tick of each row the
 * client has acked as a member of its class of audience, and so which rows there is something to
 * say about. A look costs a few operations per 64 keys, and more only for rows that are unlike the
 * start, in sight, and not acked. One thread; allocates only to grow with the highest key.
 */
final class RowKnowledge {
  private static final int NEVER = -1;

  /**
   * Rule of tables that prediction depends on, so that each datagram tells the state at its tick.
   */
  private static final Resend URGENT = new Resend(1, 1, Resend.Again.EACH_SNAPSHOT);

  private static final Resend RESEND = new Resend(1, 1, Resend.Again.WHEN_OVERDUE);

  private final Table table;
  private final int place;
  private final RowAudience audience;
  private final DatagramLedger ledger;
  private final Resend resend;

  /** Keys of which the client has everything it may know, unless they changed since. */
  private final SlotSet known = new SlotSet();

  /** Keys of which the client may hold anything but the start. */
  private final SlotSet mayHold = new SlotSet();

  /** Keys whose rows should be sent now. */
  private final SlotSet due = new SlotSet();

  private int room;
  private int[] ackedTick = {};
  private int[] sentTick = {};

  /** By key: the class of audience that the client was seen to belong to. */
  private byte[] audiences = {};

  /** By key: the tick since which it belongs to that class; acks of older rows mean nothing. */
  private int[] since = {};

  private int lookedTick = NEVER;
  private int unacked;
  private int cursor;

  RowKnowledge(Table table, int place, RowAudience audience, DatagramLedger ledger) {
    this.table = table;
    this.place = place;
    this.audience = audience;
    this.ledger = ledger;
    resend = table.layout().isUrgent() ? URGENT : RESEND;
  }

  private void ensure(int wanted) {
    if (wanted <= room) {
      return;
    }
    int old = room;
    room = wanted;
    known.ensure(room);
    mayHold.ensure(room);
    due.ensure(room);
    ackedTick = Arrays.copyOf(ackedTick, room);
    sentTick = Arrays.copyOf(sentTick, room);
    audiences = Arrays.copyOf(audiences, room);
    since = Arrays.copyOf(since, room);
    Arrays.fill(ackedTick, old, room, NEVER);
    Arrays.fill(sentTick, old, room, NEVER);
  }

  /** Looks again at some of 64 neighbouring keys: the client's audience may have changed. */
  void audienceChanged(int block, long keys) {
    known.removeWord(block, keys);
  }

  /** Looks again at all keys: the client's audience may have changed. */
  void audienceChanged() {
    known.clear();
  }

  /**
   * Finds out which rows are due.
   *
   * @param tick the tick of the table's state
   */
  void look(int tick) {
    ensure(table.room());
    due.clear();
    unacked = 0;
    for (int block = 0; block << 6 < room; block++) {
      if (table.blockTick(block) > lookedTick) {
        forgetChanged(block);
      }
      long some = table.unlikeStart(block) | mayHold.word(block);
      if (some == 0) {
        continue;
      }
      long inSight = audience.inSight(place, block, some);
      known.removeWord(block, some & ~inSight); // when it comes back, its audience may be another
      for (long rest = inSight & ~known.word(block); rest != 0; rest &= rest - 1) {
        look((block << 6) + Long.numberOfTrailingZeros(rest), tick);
      }
    }
    lookedTick = tick;
  }

  private void forgetChanged(int block) {
    for (long rest = known.word(block); rest != 0; rest &= rest - 1) {
      int bit = Long.numberOfTrailingZeros(rest);
      if (table.rowTick((block << 6) + bit) > lookedTick) {
        known.removeWord(block, 1L << bit);
      }
    }
  }

  private void look(int key, int tick) {
    int as = audience.of(place, key);
    if (as == RowAudience.NOBODY || table.layout().known(key, as) == 0) {
      known.add(key);
      return;
    }
    if (as != audiences[key]) {
      audiences[key] = (byte) as;
      since[key] = tick;
      ackedTick[key] = NEVER;
      sentTick[key] = NEVER;
    }
    if (ackedTick[key] >= Math.max(0, table.rowTick(key))) {
      known.add(key);
      if ((table.unlikeStart(key >> 6) >>> key & 1) == 0) {
        mayHold.remove(key);
      }
      return;
    }
    unacked++;
    boolean onItsWay = sentTick[key] >= Math.max(0, table.rowTick(key));
    if (ledger.isDue(resend, onItsWay ? 1 : 0, sentTick[key], tick)) {
      due.add(key);
    }
  }

  /** Returns how many rows the client isn't known to have, as of the last look. */
  int unacked() {
    return unacked;
  }

  /** Returns whether any row is due, as of the last look. */
  boolean hasDue() {
    return due.next(0) >= 0;
  }

  /**
   * Returns the next row that is due, going round from where the last snapshot ended; -1 if there
   * is none.
   */
  int nextDue() {
    int key = due.next(cursor);
    return key >= 0 ? key : due.next(0);
  }

  /** Fills in what the row's message holds: the words that the client may know and lacks. */
  void describe(int key, int tick, TableCodec codec) {
    TableRows rows = table.rows();
    codec.key = key;
    codec.age = tick - table.rowTick(key);
    codec.present = rows.isPresent(key);
    codec.identity = rows.identity(key);
    codec.whole = ackedTick[key] < Math.max(0, table.identityTick(key));
    long unlike =
        codec.whole ? table.unlikeStartWords(key) : table.changedAfter(key, ackedTick[key]);
    codec.mask = codec.present ? unlike & table.layout().known(key, audiences[key]) : 0;
  }

  /** Notes that a row was written. */
  void wrote(int key, int tick) {
    due.remove(key);
    mayHold.add(key);
    sentTick[key] = tick;
    cursor = key + 1;
  }

  /** Takes the ack of a row that was written at a tick. */
  void ack(int key, int tick) {
    if (tick >= since[key]) {
      ackedTick[key] = Math.max(ackedTick[key], tick);
    }
  }
}
