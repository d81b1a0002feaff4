package carom.net.codec;

/**
 * Stores nothing and adds up what bits and symbols would cost: to choose the cheaper of two ways to
 * say something. One thread, no allocation.
 */
public final class Surprise extends BitCoder {

  /** Parts of a bit. */
  private static final int UNIT = 256;

  /** From probabilities to multiples of 1/{@link SymbolTable#ALL}. */
  private static final int SHIFT = 16 - SymbolTable.BITS;

  /** By multiples. */
  private static final int[] COST = new int[SymbolTable.ALL + 1];

  static {
    for (int i = 0; i < COST.length; i++) {
      double probability = Math.max(0.5, i) / SymbolTable.ALL;
      COST[i] = (int) Math.rint(-UNIT * StrictMath.log(probability) / StrictMath.log(2));
    }
  }

  private long sum;

  /** Creates one that has seen nothing. */
  public Surprise() {}

  /** Forgets what it has seen. */
  public void reset() {
    sum = 0;
  }

  /** What the bits would cost, in 1/256 bit, to within a few percent. */
  public long sum() {
    return sum;
  }

  @Override
  public int code(int bit, int probability) {
    sum += COST[(bit != 0 ? probability : ONE - 1 - probability) >> SHIFT];
    return bit;
  }

  @Override
  public int symbol(SymbolTable table, int row, int symbol, int most) {
    int to = symbol < most ? table.from(row, symbol + 1) : SymbolTable.ALL;
    sum += COST[to - table.from(row, symbol)];
    return symbol;
  }

  @Override
  public int even(int value, int count) {
    sum += (long) UNIT * count;
    return value & (1 << count) - 1;
  }
}
