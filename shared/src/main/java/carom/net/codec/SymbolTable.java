package carom.net.codec;

/**
 * Fixed probabilities of a few symbols, one row for each context. Reading a symbol takes one
 * division. Coding it as bits would take a product and an unpredictable branch for each bit. A
 * table is immutable once its rows are set; threads may share it from then on.
 */
public final class SymbolTable {

  /** Binary digits of a probability: probabilities are multiples of 2^-{@value}. */
  static final int BITS = 14;

  static final int ALL = 1 << BITS;

  /** Largest number of symbols. */
  private static final int MAX_SYMBOLS = 128;

  /** Binary digits of the multiples that one lookup entry covers. */
  private static final int GUESS_BITS = 6;

  private static final int GUESSES = ALL >> GUESS_BITS;

  private final int symbols;

  /** Cumulative probability before each symbol, by row and symbol. */
  private final char[] from;

  /** First candidate symbol for each run of 2^GUESS_BITS multiples, by row. */
  private final byte[] guess;

  /**
   * Creates a table whose symbols are all equally likely.
   *
   * @param rows at least 1
   * @param symbols 1..128
   */
  public SymbolTable(int rows, int symbols) {
    if (symbols < 1 || symbols > MAX_SYMBOLS) {
      throw new IllegalArgumentException("symbols=" + symbols + " is outside 1.." + MAX_SYMBOLS);
    }
    this.symbols = symbols;
    from = new char[rows * (symbols + 1)];
    guess = new byte[rows * GUESSES];
    double[] even = new double[symbols];
    java.util.Arrays.fill(even, 1);
    for (int row = 0; row < rows; row++) {
      set(row, even);
    }
  }

  /**
   * Sets the probabilities of a row in proportion to weights. Each symbol gets one multiple, plus
   * the rounded-down share of the others that its weight is of the sum. The first of the heaviest
   * symbols gets what the rounding leaves over. The computation uses sums, products and quotients
   * of doubles in the order of the symbols, so the result is the same on every machine.
   *
   * @param weights one for each symbol; not negative, finite and not all zero
   */
  public void set(int row, double[] weights) {
    if (weights.length != symbols) {
      throw new IllegalArgumentException("weights=" + weights.length + " for symbols=" + symbols);
    }
    double sum = 0;
    int heaviest = 0;
    for (int s = 0; s < symbols; s++) {
      sum += weights[s];
      heaviest = weights[s] > weights[heaviest] ? s : heaviest;
    }
    int[] multiples = new int[symbols];
    int left = ALL;
    for (int s = 0; s < symbols; s++) {
      multiples[s] = 1 + (int) (weights[s] / sum * (ALL - symbols));
      left -= multiples[s];
    }
    multiples[heaviest] += left;
    int at = row * (symbols + 1);
    int before = 0;
    for (int s = 0; s < symbols; s++) {
      from[at + s] = (char) before;
      before += multiples[s];
    }
    from[at + symbols] = (char) ALL;
    for (int i = 0, s = 0; i < GUESSES; i++) {
      while (from[at + s + 1] <= i << GUESS_BITS) {
        s++;
      }
      guess[row * GUESSES + i] = (byte) s;
    }
  }

  /** Returns the index of the last symbol. */
  public int last() {
    return symbols - 1;
  }

  /**
   * Returns the cumulative probability before a symbol, in multiples; {@code symbol} may be one
   * past the last.
   */
  int from(int row, int symbol) {
    return from[row * (symbols + 1) + symbol];
  }

  /** Returns the symbol whose interval contains a multiple, 0..{@link #ALL} - 1. */
  int find(int row, int multiple) {
    int symbol = guess[row * GUESSES + (multiple >> GUESS_BITS)];
    int at = row * (symbols + 1) + 1;
    while (from[at + symbol] <= multiple) {
      symbol++;
    }
    return symbol;
  }
}
