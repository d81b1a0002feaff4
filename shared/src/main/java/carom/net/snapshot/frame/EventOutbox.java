package carom.net.snapshot.frame;

import carom.net.codec.BitWriter;
import carom.net.snapshot.ledger.DatagramLedger;
import carom.net.snapshot.ledger.Resend;
import java.util.function.LongConsumer;

/**
 * Sends events to one client, reliably and in order over datagrams that get lost. Each event gets
 * the session's next sequence number. It is sent twice, and again whenever its acknowledgement is
 * overdue, until a datagram that held it is acknowledged.
 *
 * <p>At most {@value #CAPACITY} events wait, of which the oldest {@value #WINDOW} are sent. The
 * outbox drops the oldest beyond that, and those that have left the {@link EventRing}, and counts
 * them. The client learns that from the number of the oldest event that waits.
 *
 * <p>One thread; allocates only until as many events have waited at once as ever will.
 */
public final class EventOutbox implements DatagramLedger.Section {
  /** Number of events that may wait for their ack. */
  static final int CAPACITY = 512;

  private static final int WINDOW = EventCodec.WINDOW;

  /** An event goes out twice, so that a single loss costs no round trip. */
  private static final Resend RESEND = new Resend(2, 2, Resend.Again.WHEN_OVERDUE);

  private static final int FIRST_ROOM = 16;

  private final EventRing ring;
  private final DatagramLedger ledger;
  private final EventCodec codec = new EventCodec();

  // By the lowest bits of the event's number here: a ring that grows.
  private long[] numbers = {};
  private int[] ticks = {};
  private int[] sentTick = {};
  private int[] sends = {};
  private boolean[] acked = {};

  private long base;

  /** The first event that happened in the tick of the one before {@link #base}. */
  private long kept;

  private long next;
  private long lost;

  /**
   * Creates an empty outbox.
   *
   * @param ring the room's events
   * @param ledger of the datagrams that events are written into
   */
  public EventOutbox(EventRing ring, DatagramLedger ledger) {
    this.ring = ring;
    this.ledger = ledger;
  }

  /** Adds an event of the ring to those that are sent. */
  public void offer(long number) {
    if (next - base == CAPACITY) {
      forget();
      lost++;
    }
    if (next - kept == numbers.length) {
      grow();
    }
    int at = at(next++);
    numbers[at] = number;
    ticks[at] = ring.at(number).tick;
    sends[at] = 0;
    acked[at] = false;
  }

  private void grow() {
    int roomy = Math.max(FIRST_ROOM, 2 * numbers.length);
    long[] roomyNumbers = new long[roomy];
    int[] roomyTicks = new int[roomy];
    int[] roomySentTick = new int[roomy];
    int[] roomySends = new int[roomy];
    boolean[] roomyAcked = new boolean[roomy];
    for (long i = kept; i < next; i++) {
      int to = (int) i & roomy - 1;
      roomyNumbers[to] = numbers[at(i)];
      roomyTicks[to] = ticks[at(i)];
      roomySentTick[to] = sentTick[at(i)];
      roomySends[to] = sends[at(i)];
      roomyAcked[to] = acked[at(i)];
    }
    numbers = roomyNumbers;
    ticks = roomyTicks;
    sentTick = roomySentTick;
    sends = roomySends;
    acked = roomyAcked;
  }

  /**
   * Offers what another outbox's client lacks, from the first event of the oldest tick on of which
   * it lacks any. That client has become this one, and passes over as many events of a tick as it
   * has. So a tick whose first events don't fit, or have left the ring, is dropped as a whole.
   */
  public void takeOver(EventOutbox before) {
    long from = before.kept;
    while (from < before.next
        && (before.next - from > CAPACITY || !ring.holds(before.numbers[before.at(from)]))) {
      from = before.nextTick(from);
    }
    for (long i = before.base; i < from; i++) {
      lost += before.acked[before.at(i)] ? 0 : 1;
    }
    for (long i = from; i < before.next; i++) {
      offer(before.numbers[before.at(i)]);
    }
  }

  /**
   * Passes on the numbers of the events that the client may lack, from the first event of the
   * oldest tick on of which it lacks any.
   */
  public void forEachUnacknowledged(LongConsumer reader) {
    for (long i = base < next ? kept : next; i < next; i++) {
      if (ring.holds(numbers[at(i)])) {
        reader.accept(numbers[at(i)]);
      }
    }
  }

  /** Returns the first event that happened in a later tick than this one. */
  private long nextTick(long event) {
    long later = event + 1;
    while (later < next && ticks[at(later)] == ticks[at(event)]) {
      later++;
    }
    return later;
  }

  /** Drops the oldest event. */
  private void forget() {
    if (ticks[at(base)] != ticks[at(kept)]) {
      kept = base;
    }
    base++;
  }

  private int at(long event) {
    return (int) event & numbers.length - 1;
  }

  /** Returns whether any event is not acked yet. */
  public boolean hasUnacked() {
    return base < next;
  }

  /** Returns whether any event would be written now. */
  public boolean isDue(int tick) {
    for (long i = base; i < Math.min(next, base + WINDOW); i++) {
      if (isDue(at(i), tick)) {
        return true;
      }
    }
    return false;
  }

  private boolean isDue(int at, int tick) {
    return !acked[at] && ledger.isDue(RESEND, sends[at], sentTick[at], tick);
  }

  /**
   * Writes the event section of the datagram begun last.
   *
   * @param tick the datagram's
   * @param budgetBits for the events; one is written anyway if it fits the writer
   */
  public void write(BitWriter w, int tick, int budgetBits) {
    forgetLost();
    codec.begin(w, tick, (int) base, waiting());
    if (!hasUnacked()) {
      return;
    }
    int room = Math.min(budgetBits, w.room() - EventCodec.END_BITS);
    int begin = w.bits();
    long set = 0;
    for (long i = base; i < Math.min(next, base + WINDOW); i++) {
      int at = at(i);
      if (!isDue(at, tick)) {
        continue;
      }
      boolean fits = w.bits() - begin + EventCodec.MAX_BITS <= room;
      boolean first = set == 0 && EventCodec.MAX_BITS + EventCodec.END_BITS <= w.room();
      if (!fits && !first) {
        break;
      }
      codec.next(w, true, (int) (i - base), ring.at(numbers[at]));
      set |= 1L << (i - base);
      sends[at]++;
      sentTick[at] = tick;
    }
    codec.next(w, false, 0, null);
    if (set != 0) {
      ledger.append(this, (int) base, set);
    }
  }

  /** Drops the oldest events that are acked, or that the ring no longer holds. */
  private void forgetLost() {
    while (base < next && (acked[at(base)] || !ring.holds(numbers[at(base)]))) {
      lost += acked[at(base)] ? 0 : 1;
      forget();
    }
  }

  @Override
  public void acknowledged(int tick, int sentBase, long sent) {
    long from = base + (sentBase - (int) base);
    for (long set = sent; set != 0; set &= set - 1) {
      long i = from + Long.numberOfTrailingZeros(set);
      if (i >= base && i < next) {
        acked[at(i)] = true;
      }
    }
    forgetLost();
  }

  /** Returns the number of events that were dropped. */
  public long lost() {
    return lost;
  }

  /** Returns the number of events that wait for their ack. */
  public int waiting() {
    return (int) (next - base);
  }
}
