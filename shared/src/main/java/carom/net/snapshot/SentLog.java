package carom.net.snapshot;

import carom.net.codec.Sequence;

/**
 * What went out in which datagram, until its ack comes or it is too old to matter. The slots of all
 * datagrams stand in one circular log; what was overwritten counts as lost.
 */
final class SentLog {

  /** Datagrams remembered. */
  static final int SIZE = 512;

  private static final int MASK = SIZE - 1;
  private static final int MIN_SLOTS = 1 << 10;
  private static final int MAX_SLOTS = 1 << 20;

  private final long[] number = new long[SIZE];
  private final int[] tick = new int[SIZE];
  private final boolean[] own = new boolean[SIZE];
  private final boolean[] news = new boolean[SIZE];
  private final boolean[] open = new boolean[SIZE];
  private final long[] start = new long[SIZE];
  private final int[] count = new int[SIZE];
  private final int[] bytes = new int[SIZE];
  private char[] slots = new char[MIN_SLOTS];
  private long written;
  private long newest = -1;

  /** Begins the next datagram and answers its 16-bit sequence number. */
  int begin(int tickNow, boolean withOwn, boolean withNews) {
    newest++;
    int at = (int) newest & MASK;
    number[at] = newest;
    tick[at] = tickNow;
    own[at] = withOwn;
    news[at] = withNews;
    open[at] = true;
    start[at] = written;
    count[at] = 0;
    return sequence();
  }

  void add(int slot) {
    slots[(int) written & (slots.length - 1)] = (char) slot;
    written++;
    count[(int) newest & MASK]++;
  }

  /** Notes the size of the datagram begun last. */
  void end(int length) {
    bytes[(int) newest & MASK] = length;
  }

  int sequence() {
    return (int) newest & 0xffff;
  }

  /** Makes the log long enough for a ring of frames at this many records a tick. */
  void reserve(int recordsPerTick) {
    long wanted = Math.min(MAX_SLOTS, (long) recordsPerTick * FrameRing.SIZE);
    if (wanted <= slots.length) {
      return;
    }
    char[] grown = new char[Integer.highestOneBit((int) wanted - 1) << 1];
    for (long i = Math.max(0, written - slots.length); i < written; i++) {
      grown[(int) i & (grown.length - 1)] = slots[(int) i & (slots.length - 1)];
    }
    slots = grown;
  }

  /** Forgets everything that is on its way. */
  void forget() {
    for (int i = 0; i < SIZE; i++) {
      open[i] = false;
    }
  }

  /**
   * Takes the ack of a datagram.
   *
   * @return its place for {@link #tickAt} and the others, or -1 when it was never sent, acked
   *     before, or is forgotten
   */
  int take(int sequence, int before) {
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

  int tickAt(int at) {
    return tick[at];
  }

  int bytesAt(int at) {
    return bytes[at];
  }

  boolean ownAt(int at) {
    return own[at];
  }

  boolean newsAt(int at) {
    return news[at];
  }

  int countAt(int at) {
    return count[at];
  }

  int slotAt(int at, int index) {
    return slots[(int) (start[at] + index) & (slots.length - 1)];
  }
}
