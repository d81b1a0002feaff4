package carom.net.codec;

/**
 * Writes bits of known probability into a caller's array, each at the cost of its surprise: a
 * binary arithmetic coder without carries. The state is an interval of 48-bit numbers; each bit
 * keeps the part of the interval that belongs to it, and bytes leave when both ends agree on them.
 *
 * <p>What is longer than the room sets a sticky overflow. One thread, no allocation.
 */
public final class RangeEncoder extends BitCoder {

  static final int STATE_BITS = 48;
  static final long MASK = (1L << STATE_BITS) - 1;

  private byte[] bytes = new byte[0];
  private int start;
  private int limit;
  private int position;
  private boolean overflow;
  private long low;
  private long high = MASK;
  private int markedPosition;
  private long markedLow;
  private long markedHigh;

  /** Creates an encoder without room; call {@link #reset}. */
  public RangeEncoder() {}

  /** Starts at {@code offset}, with room for {@code length} bytes. */
  public void reset(byte[] bytes, int offset, int length) {
    if (offset < 0 || length < 0 || length > bytes.length - offset) {
      throw new IndexOutOfBoundsException(
          "offset=" + offset + " length=" + length + " array=" + bytes.length);
    }
    this.bytes = bytes;
    start = offset;
    limit = offset + length;
    position = offset;
    overflow = false;
    low = 0;
    high = MASK;
    mark();
  }

  /** Remembers this place for {@link #rewind}. */
  public void mark() {
    markedPosition = position;
    markedLow = low;
    markedHigh = high;
  }

  /** Goes back to the last {@link #mark} and forgets an overflow since. */
  public void rewind() {
    position = markedPosition;
    low = markedLow;
    high = markedHigh;
    overflow = false;
  }

  /**
   * Bits written since {@link #reset}, rounded down. A message of n bits takes {@link #finish} at
   * most n / 8 + 1 bytes.
   */
  public int bits() {
    return 8 * (position - start) + STATE_BITS - (64 - Long.numberOfLeadingZeros(high - low));
  }

  @Override
  public int code(int bit, int probability) {
    long middle = split(low, high, probability);
    if (bit != 0) {
      high = middle;
    } else {
      low = middle + 1;
    }
    while ((low ^ high) >>> (STATE_BITS - 8) == 0) {
      put((int) (high >>> (STATE_BITS - 8)));
      low = low << 8 & MASK;
      high = high << 8 & MASK | 0xff;
    }
    return bit;
  }

  /**
   * Writes what {@link BitTable#code} would bit by bit, in a fraction of the time: that of an
   * unforeseen bit is mostly its branches, and here it has none.
   *
   * @param table whose nodes adapt
   * @param steps each 2 node + bit
   * @param from index of the first step
   * @param to index behind the last step
   */
  public void code(BitTable table, char[] steps, int from, int to) {
    int[] states = table.states;
    long[] changed = table.changed;
    int changes = table.changes;
    long low = this.low;
    long high = this.high;
    for (int i = from; i < to; i++) {
      int node = steps[i] >>> 1;
      int bit = steps[i] & 1;
      int state = states[node];
      changed[changes++ & BitTable.MAX_MARKED - 1] = (long) node << 32 | state;
      states[node] = BitTable.next(state, bit);
      long middle = split(low, high, state & 0xffff);
      long one = -(long) bit;
      high ^= (high ^ middle) & one;
      low = low & one | middle + 1 & ~one;
      while ((low ^ high) >>> (STATE_BITS - 8) == 0) {
        put((int) (high >>> (STATE_BITS - 8)));
        low = low << 8 & MASK;
        high = high << 8 & MASK | 0xff;
      }
    }
    table.changes = changes;
    this.low = low;
    this.high = high;
  }

  /**
   * The last number of the part that belongs to a 1. Each part has at least one number while the
   * interval has two.
   */
  static long split(long low, long high, int probability) {
    return low + ((high - low) * probability >>> 16); // 48 and 16 bits: the product has 64
  }

  /**
   * Ends the message with the fewest bytes that decide it; the reader takes zeros behind them.
   *
   * @return bytes written since {@link #reset}
   */
  public int finish() {
    long end = shortest(low, high);
    while (end != 0) {
      put((int) (end >>> (STATE_BITS - 8)));
      end = end << 8 & MASK;
    }
    while (!overflow && position > start && bytes[position - 1] == 0) {
      position--;
    }
    return position - start;
  }

  /** The number within an interval that has the most zeros at its end, in bytes. */
  static long shortest(long low, long high) {
    for (int shift = STATE_BITS; shift > 0; shift -= 8) {
      long step = 1L << shift;
      long up = low + step - 1 & -step;
      if (up <= high) {
        return up;
      }
    }
    return low;
  }

  private void put(int octet) {
    if (position == limit) {
      overflow = true;
      return;
    }
    bytes[position++] = (byte) octet;
  }

  /** Whether something did not fit since {@link #reset}. */
  public boolean overflow() {
    return overflow;
  }
}
