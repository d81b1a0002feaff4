package carom.net.codec;

/**
 * Coder that stores nothing and adds up what bits and symbols would cost. An encoder uses it to
 * choose the cheaper of two encodings. Use it from one thread; it doesn't allocate.
 */
public final class BitCost extends BitCoder {

  /** Units of cost for each bit. */
  private static final int UNIT = 256;

  /** Shift from a probability in 1/{@link #ONE} to one in 1/{@link SymbolTable#ALL}. */
  private static final int SHIFT = 16 - SymbolTable.BITS;

  /** Cost of an event, by its probability in 1/{@link SymbolTable#ALL}. */
  private static final int[] COST = new int[SymbolTable.ALL + 1];

  static {
    for (int i = 0; i < COST.length; i++) {
      double probability = Math.max(0.5, i) / SymbolTable.ALL;
      COST[i] = (int) Math.rint(-UNIT * StrictMath.log(probability) / StrictMath.log(2));
    }
  }

  private long sum;

  /** Creates a counter at zero. */
  public BitCost() {}

  /** Sets the sum to zero. */
  public void reset() {
    sum = 0;
  }

  /** Returns the cost so far in 1/256 bit, exact to within a few per cent. */
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
