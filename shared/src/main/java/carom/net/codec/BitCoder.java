package carom.net.codec;

/**
 * One side of an arithmetic coder. A codec describes its format once, as calls of {@link #code},
 * {@link #symbol} and {@link #even}. The subclass decides whether that description writes, reads,
 * measures or only trains the tables.
 */
public abstract class BitCoder implements PlainBits {

  /** Denominator of probabilities: a probability {@code p} means {@code p / ONE}. */
  public static final int ONE = 1 << 16;

  /** Largest number of bits that one call of {@link #even} codes. */
  static final int MAX_EVEN = 16;

  /** Limits subclasses to this package. */
  BitCoder() {}

  /**
   * Codes a bit.
   *
   * @param bit 0 or 1, what to write; a reader ignores it
   * @param probability of a 1, in 1/65,536; 1..65,535
   * @return the bit written, or the bit read
   */
  public abstract int code(int bit, int probability);

  /**
   * Codes a symbol of a table.
   *
   * @param row row of the table that holds the probabilities
   * @param symbol what to write, 0..{@code most}; a reader ignores it
   * @param most the last symbol that can occur here; it takes over the probability of all symbols
   *     after it
   * @return the symbol written, or the symbol read
   */
  public abstract int symbol(SymbolTable table, int row, int symbol, int most);

  /**
   * Codes the lowest {@code count} bits of a value in one step, all values equally likely.
   *
   * @param count 0..{@value #MAX_EVEN}
   * @return the bits written, or the bits read
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

  /**
   * Returns a coder that stores nothing and returns every bit and symbol as given. It trains
   * adaptive tables with values that both sides already know.
   */
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
