package carom.net.codec;

/**
 * One side of an arithmetic coder. A codec describes its bits and symbols once, as calls of {@link
 * #code}, {@link #symbol} and {@link #even}; who is behind them decides whether that description
 * writes, reads, or only learns.
 */
public abstract class BitCoder implements PlainBits {

  /** One in the unit of probabilities. */
  public static final int ONE = 1 << 16;

  /** Most bits of {@link #even}. */
  static final int MAX_EVEN = 16;

  /** For the coders of this package. */
  BitCoder() {}

  /**
   * Codes a bit.
   *
   * @param bit 0 or 1, what to write; a reader ignores it
   * @param probability of a 1, in 1/65,536: 1..65,535
   * @return the bit written, or the bit read
   */
  public abstract int code(int bit, int probability);

  /**
   * Codes a symbol of a table.
   *
   * @param row whose probabilities hold
   * @param symbol what to write, 0..most; a reader ignores it
   * @param most the last symbol that can come: it has the probability of all behind it, too
   * @return the symbol written, or the symbol read
   */
  public abstract int symbol(SymbolTable table, int row, int symbol, int most);

  /**
   * Codes the lowest {@code count} bits of a value as equally likely, in one step.
   *
   * @param count 0..{@value #MAX_EVEN}
   * @return these bits
   */
  public abstract int even(int value, int count);

  /** Codes the lowest {@code count} bits of a value, highest first, as equally likely; 0..32. */
  @Override
  public final int plain(int value, int count) {
    if (count <= MAX_EVEN) {
      return even(value, count);
    }
    int high = even(value >>> MAX_EVEN, count - MAX_EVEN);
    return high << MAX_EVEN | even(value, MAX_EVEN);
  }

  /** A coder that takes every bit as given and stores nothing: for learning what is known. */
  public static BitCoder known() {
    return Known.INSTANCE;
  }

  private static final class Known extends BitCoder {
    static final Known INSTANCE = new Known();

    @Override
    public int code(int bit, int probability) {
      return bit;
    }

    @Override
    public int symbol(SymbolTable table, int row, int symbol, int most) {
      return symbol;
    }

    @Override
    public int even(int value, int count) {
      return value & (1 << count) - 1;
    }
  }
}
