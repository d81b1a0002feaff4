package carom.net.codec;

/**
 * One side of an arithmetic coder. A codec describes its bits once, as calls of {@link #code}; who
 * is behind them decides whether that description writes, reads, or only learns.
 */
public abstract class BitCoder {

  /** One in the unit of probabilities. */
  public static final int ONE = 1 << 16;

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

  /** Codes the lowest {@code count} bits of a value, highest first, as equally likely; 0..32. */
  public final int plain(int value, int count) {
    int result = 0;
    for (int i = count - 1; i >= 0; i--) {
      result = result << 1 | code(value >>> i & 1, ONE / 2);
    }
    return result;
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
  }
}
