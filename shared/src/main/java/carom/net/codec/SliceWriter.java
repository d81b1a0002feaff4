package carom.net.codec;

/**
 * Writing side of the arithmetic coder, which collects bits and symbols in slices. A slice is a
 * range of the numbers from 0 to below 2^{@value #BITS}. Each bit or symbol narrows the range to
 * the part that belongs to it; a range that has become short ends the slice, and the next slice
 * begins with all numbers again. A slice depends only on its own bits, symbols and probabilities,
 * not on what was written before. So the sender computes the slices that many messages share once
 * ({@link SliceList}) and writes them into each message at the cost of two products ({@link
 * RangeEncoder#slices}).
 */
public abstract class SliceWriter extends BitCoder {

  /** Number of bits of the numbers in a slice. */
  static final int BITS = 48;

  static final long ALL = 1L << BITS;

  /** A slice narrower than 2^{@value} ends. Wider ones lose little to rounding. */
  static final int LEAST_BITS = 22;

  private long first;
  long width = ALL;

  /** Limits subclasses to this package. */
  SliceWriter() {}

  @Override
  public final int code(int bit, int probability) {
    long ones = ones(width, probability);
    long one = -(long) bit; // no branch on the bit, because a processor can't predict it
    first += ones & ~one;
    width = ones & one | width - ones & ~one;
    if (width >>> LEAST_BITS == 0) {
      cut();
    }
    return bit;
  }

  @Override
  public final int symbol(SymbolTable table, int row, int symbol, int most) {
    long part = width >>> SymbolTable.BITS;
    int from = table.from(row, symbol);
    int to = symbol < most ? table.from(row, symbol + 1) : SymbolTable.ALL;
    first += from * part;
    width = (to - from) * part;
    if (width >>> LEAST_BITS == 0) {
      cut();
    }
    return symbol;
  }

  @Override
  public final int even(int value, int count) {
    int result = value & (1 << count) - 1;
    width >>>= count;
    first += result * width;
    if (width >>> LEAST_BITS == 0) {
      cut();
    }
    return result;
  }

  /**
   * Ends the current slice, if one is begun. Cuts belong to the format: the reader must cut at the
   * same places.
   */
  public final void cut() {
    if (width != ALL) {
      slice(first, width);
      begin(0, ALL);
    }
  }

  /**
   * Takes a finished slice. The writer calls this at cuts only.
   *
   * @param first the first number of the slice
   * @param width how many numbers it has, at least 1
   */
  abstract void slice(long first, long width);

  final void begin(long first, long width) {
    this.first = first;
    this.width = width;
  }

  final long first() {
    return first;
  }

  /**
   * Returns how many of the lowest numbers of a slice belong to a 1. As long as the slice has two
   * numbers, each of the two bits gets at least one.
   */
  static long ones(long width, int probability) {
    return 1 + ((width - 1) * probability >>> 16); // 48 bits times 16 bits
  }
}
