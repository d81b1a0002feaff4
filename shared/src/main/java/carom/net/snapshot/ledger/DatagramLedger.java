package carom.net.snapshot.ledger;

import carom.net.codec.Sequence;
import java.util.Arrays;

/**
 * Keeps account of the datagrams sent to one client: what each held, and whether it arrived. The
 * sections of a datagram {@linkplain #append append} what they wrote. The ledger tells each of them
 * once what became of it:
 *
 * <ul>
 *   <li>A datagram is <em>acknowledged</em> by the first acknowledgement that names it, unless it
 *       is lost by then.
 *   <li>It is <em>overtaken</em> when a younger one is acknowledged before it. The network may have
 *       changed their order, and it may yet arrive.
 *   <li>It is <em>lost</em> when one overtakes it that was sent {@value #LOST_TICKS} ticks after it
 *       or later, or when the ledger has no room for it any more. It stays lost: if it is
 *       acknowledged after all, it counts for {@link #ackedBytes} and {@link #ackDelayTicks}, and
 *       no section is told.
 * </ul>
 *
 * <p>So losses are told in the order of sending, and what one call of {@link #receive} decides is
 * told in that order, too. A section hears of the acknowledgement of an overtaken datagram after
 * that of the younger one.
 *
 * <p>An acknowledgement is <em>overdue</em> when it takes {@value #PATIENCE_TICKS} ticks longer
 * than the quickest one did lately. That is no loss: it is a reason to send something small again
 * while nothing is heard. (RFC 9002, on QUIC, has the same two: a time threshold for losses, and a
 * probe time-out.)
 *
 * <p>One thread; allocates only until as much has been on its way at once as ever will.
 */
public final class DatagramLedger {
  /** Number of datagrams that may be on their way; of more, the oldest is lost. */
  public static final int SIZE = 512;

  /** Ticks between a datagram and one that overtakes it from which on it is lost. */
  public static final int LOST_TICKS = 3;

  /** Time beyond the quickest acknowledgement that one is waited for, ticks. */
  private static final int PATIENCE_TICKS = 3;

  /** Longest time that an acknowledgement is waited for, ticks. */
  private static final int MAX_WAIT_TICKS = 60;

  /** The line counts as one that loses datagrams for this long after a loss, ticks. */
  private static final int LOSSY_TICKS = 600;

  /**
   * Acknowledged datagrams after which a loss says something about the line. Those before may have
   * come when the client couldn't read them yet.
   */
  private static final int WARM_UP = 128;

  private static final int MASK = SIZE - 1;
  private static final int MIN_ENTRIES = 1 << 8;
  private static final int MAX_ENTRIES = 1 << 18;

  private static final byte ON_ITS_WAY = 0;
  private static final byte ARRIVED = 1;
  private static final byte ACKNOWLEDGED = 2;
  private static final byte LOST = 3;

  /** A part of the datagrams that sends again what didn't arrive. */
  public interface Section {
    /**
     * Learns that something has arrived.
     *
     * @param tick of the datagram
     * @param key as appended
     * @param bits as appended
     */
    void acknowledged(int tick, int key, long bits);

    /**
     * Learns that something is lost. A section that doesn't wait for this has nothing to do.
     *
     * @param tick of the datagram
     * @param key as appended
     * @param bits as appended
     */
    default void lost(int tick, int key, long bits) {}
  }

  // By datagram.
  private final int[] ticks = new int[SIZE];
  private final int[] bytes = new int[SIZE];
  private final boolean[] news = new boolean[SIZE];
  private final byte[] states = new byte[SIZE];

  /** By datagram: the place in the log from which on its entries stand, up to the next one's. */
  private final long[] starts = new long[SIZE];

  // A circular log of what sections appended.
  private final int maxEntries;
  private Section[] sections;
  private int[] keys;
  private long[] sets;
  private long written;

  private long newest = -1;

  /** The oldest datagram that is on its way, or the next one if none is. */
  private long oldest;

  private int ackedTick = Integer.MIN_VALUE;
  private int lossTick = -LOSSY_TICKS;
  private int ackDelayTicks = -1;
  private int waitTicks = MAX_WAIT_TICKS / 2;
  private long ackedBytes;
  private long ackedDatagrams;
  private long settled;

  /** Creates a ledger without datagrams. */
  public DatagramLedger() {
    this(MIN_ENTRIES, MAX_ENTRIES);
  }

  /**
   * Creates a ledger with another room than usual, powers of two.
   *
   * @param entries room at the beginning
   * @param maxEntries largest room; what one datagram holds must fit
   */
  DatagramLedger(int entries, int maxEntries) {
    this.maxEntries = maxEntries;
    sections = new Section[entries];
    keys = new int[entries];
    sets = new long[entries];
  }

  // ---- what is sent

  /**
   * Begins the next datagram and returns its 16-bit sequence number.
   *
   * @param tick of the snapshot, not before the last one's
   * @param withNews whether the client is asked to acknowledge it soon
   */
  public int begin(int tick, boolean withNews) {
    if (newest - oldest == MASK) {
      loseOldest();
    }
    newest++;
    int at = (int) newest & MASK;
    ticks[at] = tick;
    bytes[at] = 0;
    news[at] = withNews;
    states[at] = ON_ITS_WAY;
    starts[at] = written;
    return sequence();
  }

  /**
   * Notes that the datagram begun last holds something of a section.
   *
   * @param section which is told what becomes of it
   * @param key says what, to the section
   * @param bits say more
   */
  public void append(Section section, int key, long bits) {
    while (written - starts[(int) oldest & MASK] == keys.length) {
      if (keys.length < maxEntries) {
        grow();
      } else {
        loseOldest();
      }
    }
    int at = (int) written++ & keys.length - 1;
    sections[at] = section;
    keys[at] = key;
    sets[at] = bits;
  }

  /** Doubles the log; each entry keeps its number. */
  private void grow() {
    int length = keys.length;
    sections = Arrays.copyOf(sections, 2 * length);
    keys = Arrays.copyOf(keys, 2 * length);
    sets = Arrays.copyOf(sets, 2 * length);
    System.arraycopy(sections, 0, sections, length, length);
    System.arraycopy(keys, 0, keys, length, length);
    System.arraycopy(sets, 0, sets, length, length);
  }

  /** Notes the size of the datagram begun last. */
  public void end(int length) {
    bytes[(int) newest & MASK] = length;
  }

  /** Returns the sequence number of the datagram begun last, 16 bits. */
  public int sequence() {
    return (int) newest & 0xffff;
  }

  // ---- what became of it

  /**
   * Takes a client's acknowledgements. Anything is accepted: what was never sent, or is too old,
   * changes nothing.
   *
   * @param sequence newest datagram that the client received, 16 bits
   * @param older bit i = datagram {@code sequence - 1 - i} was received
   * @param now present tick
   */
  public void receive(int sequence, long older, int now) {
    ackDelayTicks = -1;
    long top = newest + Sequence.difference(sequence, sequence());
    for (long rest = older; rest != 0; rest &= ~Long.highestOneBit(rest)) {
      arrive(top - 1 - (Long.SIZE - 1 - Long.numberOfLeadingZeros(rest)), now);
    }
    arrive(top, now);
    if (ackDelayTicks >= 0) {
      waitTicks = Math.min(MAX_WAIT_TICKS, ackDelayTicks + PATIENCE_TICKS);
    }
    for (long number = oldest; number <= Math.min(top, newest); number++) {
      int at = (int) number & MASK;
      if (states[at] == ARRIVED) {
        settle(number, ACKNOWLEDGED);
      } else if (states[at] == ON_ITS_WAY && ackedTick - LOST_TICKS >= ticks[at]) {
        settle(number, LOST);
        lossTick = ackedDatagrams >= WARM_UP ? now : lossTick;
      }
    }
    advance();
  }

  private void arrive(long number, int now) {
    if (number < 0 || number > newest || newest - number >= SIZE) {
      return;
    }
    int at = (int) number & MASK;
    if (states[at] == ACKNOWLEDGED) {
      return;
    }
    states[at] = states[at] == LOST ? ACKNOWLEDGED : ARRIVED;
    ackedTick = Math.max(ackedTick, ticks[at]);
    ackedBytes += bytes[at];
    ackedDatagrams++;
    settled = Math.max(settled, number + 1);
    if (news[at]) { // others the client acknowledges when it happens to write
      int delay = now - ticks[at];
      ackDelayTicks = ackDelayTicks < 0 ? delay : Math.min(ackDelayTicks, delay);
    }
  }

  private void loseOldest() {
    settle(oldest, LOST);
    advance();
  }

  private void advance() {
    while (oldest <= newest && states[(int) oldest & MASK] != ON_ITS_WAY) {
      oldest++;
    }
  }

  private void settle(long number, byte state) {
    int datagram = (int) number & MASK;
    states[datagram] = state;
    long end = number == newest ? written : starts[(int) (number + 1) & MASK];
    for (long i = starts[datagram]; i < end; i++) {
      int at = (int) i & keys.length - 1;
      if (state == ACKNOWLEDGED) {
        sections[at].acknowledged(ticks[datagram], keys[at], sets[at]);
      } else {
        sections[at].lost(ticks[datagram], keys[at], sets[at]);
      }
    }
  }

  // ---- when to send again

  /**
   * Returns whether something should be sent that hasn't arrived.
   *
   * @param rule not one that waits for losses, which are told
   * @param sends number of snapshots that have held it as it is now
   * @param sentTick tick of the last of them
   * @param now tick of the snapshot that may hold it
   */
  public boolean isDue(Resend rule, int sends, int sentTick, int now) {
    if (sends == 0 || sends < copies(rule, now) && now > sentTick) {
      return true;
    }
    return switch (rule.again()) {
      case EACH_SNAPSHOT -> now > sentTick;
      case WHEN_OVERDUE -> now - sentTick >= waitTicks;
      case WHEN_LOST -> false;
    };
  }

  /** Returns in how many snapshots in a row something new is sent, at present. */
  public int copies(Resend rule, int now) {
    return isLossy(now) ? rule.lossyCopies() : rule.copies();
  }

  /** Returns whether the line has lost datagrams in the last ten seconds of 60 ticks. */
  public boolean isLossy(int now) {
    return now - lossTick < LOSSY_TICKS;
  }

  // ---- figures of the line

  /**
   * Returns the ticks from sending to acknowledgement of the quickest datagram with news that the
   * last {@link #receive} was the first to name, or -1 when it named none.
   */
  public int ackDelayTicks() {
    return ackDelayTicks;
  }

  /** Returns the payload bytes of all datagrams that have arrived. */
  public long ackedBytes() {
    return ackedBytes;
  }

  /** Returns the number of datagrams that have arrived. */
  public long ackedDatagrams() {
    return ackedDatagrams;
  }

  /** Returns how many datagrams have arrived or were overtaken by one that has. */
  public long settledDatagrams() {
    return settled;
  }

  /** Returns the number of entries kept for datagrams that are on their way, or in between. */
  long entries() {
    return oldest > newest ? 0 : written - starts[(int) oldest & MASK];
  }
}
