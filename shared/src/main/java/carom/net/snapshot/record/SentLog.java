package carom.net.snapshot.record;

import carom.net.codec.Sequence;
import carom.net.snapshot.frame.FrameRing;
import java.util.Arrays;

/**
 * Remembers what each datagram held until its ack comes or is too old to matter. The slots of all
 * datagrams stand in one circular log, as sets of 64 neighbours. A datagram whose sets were
 * overwritten counts as lost.
 */
public final class SentLog {

  /** Datagrams remembered. */
  public static final int SIZE = 512;

  private static final int MASK = SIZE - 1;
  private static final int MIN_ENTRIES = 1 << 8;
  private static final int MAX_ENTRIES = 1 << 18;

  private final long[] number = new long[SIZE];
  private final int[] tick = new int[SIZE];
  private final boolean[] own = new boolean[SIZE];
  private final boolean[] news = new boolean[SIZE];
  private final boolean[] open = new boolean[SIZE];
  private final long[] start = new long[SIZE];
  private final int[] count = new int[SIZE];
  private final int[] bytes = new int[SIZE];
  private char[] words = new char[MIN_ENTRIES];
  private long[] slots = new long[MIN_ENTRIES];
  private long written;
  private long newest = -1;

  /** The oldest datagram that is young enough to be acked in time. */
  private long oldest;

  /** Creates an empty log. */
  public SentLog() {}

  /** Begins the next datagram and returns its 16-bit sequence number. */
  public int begin(int tickNow, boolean withOwn, boolean withNews) {
    newest++;
    int at = (int) newest & MASK;
    number[at] = newest;
    tick[at] = tickNow;
    own[at] = withOwn;
    news[at] = withNews;
    open[at] = true;
    start[at] = written;
    count[at] = 0;
    oldest = Math.max(oldest, newest - MASK);
    while (tickNow - tick[(int) oldest & MASK] >= FrameRing.SIZE) {
      oldest++;
    }
    return sequence();
  }

  /** Notes that the datagram begun last holds some of 64 neighbouring slots. */
  public void add(int word, long slots) {
    if (written - start[(int) oldest & MASK] == this.slots.length
        && this.slots.length < MAX_ENTRIES) {
      grow();
    }
    int at = (int) written & (this.slots.length - 1);
    words[at] = (char) word;
    this.slots[at] = slots;
    written++;
    count[(int) newest & MASK]++;
  }

  /** Doubles the log; each entry keeps its number. */
  private void grow() {
    int length = slots.length;
    words = Arrays.copyOf(words, 2 * length);
    slots = Arrays.copyOf(slots, 2 * length);
    System.arraycopy(words, 0, words, length, length);
    System.arraycopy(slots, 0, slots, length, length);
  }

  /** Notes the size of the datagram begun last. */
  public void end(int length) {
    bytes[(int) newest & MASK] = length;
  }

  /** Returns the sequence number of the datagram begun last, 16 bits. */
  public int sequence() {
    return (int) newest & 0xffff;
  }

  /** Forgets all datagrams that are on their way. */
  public void forget() {
    Arrays.fill(open, false);
  }

  /**
   * Takes the ack of a datagram.
   *
   * @return its place for {@link #tickAt} and the others, or -1 when it was never sent, acked
   *     before, or is forgotten
   */
  public int take(int sequence, int before) {
    long acked = newest + Sequence.difference(sequence, sequence()) - before;
    if (acked < 0 || acked > newest) {
      return -1;
    }
    int at = (int) acked & MASK;
    if (number[at] != acked || !open[at]) {
      return -1;
    }
    open[at] = false;
    return written - start[at] > slots.length ? -1 : at;
  }

  /** Returns the tick of a datagram. */
  public int tickAt(int at) {
    return tick[at];
  }

  /** Returns the size of a datagram. */
  public int bytesAt(int at) {
    return bytes[at];
  }

  /** Returns whether a datagram had an own section. */
  public boolean ownAt(int at) {
    return own[at];
  }

  /** Returns whether a datagram held anything that the client wasn't known to have. */
  public boolean newsAt(int at) {
    return news[at];
  }

  /** Returns how many sets of slots the datagram held. */
  public int countAt(int at) {
    return count[at];
  }

  /** Returns the word of a set of slots. */
  public int wordAt(int at, int index) {
    return words[(int) (start[at] + index) & (words.length - 1)];
  }

  /** Returns the slots of a set, of its word. */
  public long slotsAt(int at, int index) {
    return slots[(int) (start[at] + index) & (slots.length - 1)];
  }
}
