package carom.net.codec;

/**
 * How likely each of a few symbols is, in each of some rows. What is coded as one symbol takes one
 * division to read, where its bits would take a product and a branch that nothing foresees each.
 * Immutable once its rows are set; shared by threads from then on.
 */
public final class SymbolTable {

  /** Probabilities are whole multiples of 2^-{@value}. */
  static final int BITS = 14;

  static final int ALL = 1 << BITS;

  /** Most symbols. */
  private static final int MAX_SYMBOLS = 128;

  /** So many guesses a row, each good for 2^{@value} multiples. */
  private static final int GUESS_BITS = 6;

  private static final int GUESSES = ALL >> GUESS_BITS;

  private final int symbols;

  /** By row and symbol: the sum of what is before it. */
  private final char[] from;

  /** By row: the symbol of each so many-th multiple. */
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
   * Sets a row. Each symbol gets one multiple, and of those left as many whole ones as its weight
   * is of all weights; what rounding leaves over goes to the first of the heaviest. Sums and
   * quotients of doubles alone, in the order of the symbols, so that it is the same everywhere.
   *
   * @param weights not negative, finite, not all zero; one for each symbol
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

  /** The last symbol. */
  public int last() {
    return symbols - 1;
  }

  /** The multiples before a symbol, or before the end. */
  int from(int row, int symbol) {
    return from[row * (symbols + 1) + symbol];
  }

  /** The symbol that a multiple belongs to, 0..{@link #ALL} - 1. */
  int find(int row, int multiple) {
    int symbol = guess[row * GUESSES + (multiple >> GUESS_BITS)];
    int at = row * (symbols + 1) + 1;
    while (from[at + symbol] <= multiple) {
      symbol++;
    }
    return symbol;
  }
}
