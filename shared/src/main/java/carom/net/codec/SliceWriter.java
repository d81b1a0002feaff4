package carom.net.codec;

/**
 * The writing side of the arithmetic coder, in slices. A slice is a run of the numbers from 0 to
 * below 2^{@value #BITS}: each bit or symbol keeps the part of it that belongs to it, and a slice
 * that has become short is done; what follows begins with all numbers again. What a slice is
 * depends on these and their probabilities alone and not on what was written before. So what many
 * messages have in common is worked out once ({@link SliceList}), and put into each at the cost of
 * two products ({@link RangeEncoder#slice}).
 */
public abstract class SliceWriter extends BitCoder {

  /** Slices are of the numbers that have so many bits. */
  static final int BITS = 48;

  static final long ALL = 1L << BITS;

  /** A slice shorter than 2^{@value} is done: what is left of longer ones by rounding is little. */
  static final int LEAST_BITS = 22;

  private long first;
  long width = ALL;

  /** For the writers of this package. */
  SliceWriter() {}

  @Override
  public final int code(int bit, int probability) {
    long ones = ones(width, probability);
    long one = -(long) bit; // without a branch, as nothing foresees the bit
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
   * Ends the slice that was begun, if any. Cuts belong to the format: a reader must make the same.
   */
  public final void cut() {
    if (width != ALL) {
      slice(first, width);
      begin(0, ALL);
    }
  }

  /**
   * Takes a slice that is done; called at cuts only.
   *
   * @param first its first number
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
   * How many numbers of a slice, the lowest, belong to a 1. Each of both bits has one while there
   * are two.
   */
  static long ones(long width, int probability) {
    return 1 + ((width - 1) * probability >>> 16); // 48 and 16 bits
  }
}
