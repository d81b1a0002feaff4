package carom.net.snapshot.exact;

import carom.net.codec.SymbolTable;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;

/**
 * The probabilities of the symbols of {@link NearRowCodec}. The file {@code near.txt} has one line
 * for each context of each row, with one letter per symbol: its weight on a logarithmic scale.
 * {@code NearTraining} in the tests counts them over games played by bots. Changing a table changes
 * the protocol.
 */
final class NearTables {

  /** Number of symbols in each line; not every row uses all of them. */
  static final int SYMBOLS = 67;

  /** Letter of the likeliest symbol. Each following letter is half a bit less likely. */
  private static final char LIKELIEST = '#';

  private static final int LETTERS = 33;

  /** The quantities that symbols describe, each in a few contexts. */
  enum Quantity {
    REST_KIND(1),
    REST(1),
    PLACE(2),
    LARGER(2),
    SMALLER(2),
    OTHER(2),
    VELOCITY(6),
    OMEGA(4),
    PUSHED(1),
    PUSH(1),
    END(3),
    KIND(1),
    ID(4),
    NORMAL(2),
    TANGENT(6),
    SECOND(4),
    ROLLING(1),
    LAST(6),
    JOINT_KEY(1),
    JOINT_END(2),
    JOINT_SET(2),
    JOINT_TURNED(1),
    JOINT_PUSHED(2),
    JOINT_IMPULSE(2),
    JOINT_LOAD(3);

    private final int contexts;

    Quantity(int contexts) {
      this.contexts = contexts;
    }
  }

  /** The first line of each row, by ordinal. */
  private static final int[] FIRST = new int[Quantity.values().length];

  /** Number of lines in the file. */
  static final int LINES;

  static {
    int lines = 0;
    for (Quantity row : Quantity.values()) {
      FIRST[row.ordinal()] = lines;
      lines += row.contexts;
    }
    LINES = lines;
  }

  static final SymbolTable TABLE = read();

  private NearTables() {}

  /** Returns the line of a row's context. */
  static int line(Quantity row, int context) {
    return FIRST[row.ordinal()] + context;
  }

  private static SymbolTable read() {
    SymbolTable table = new SymbolTable(LINES, SYMBOLS);
    try (InputStream in = NearTables.class.getResourceAsStream("near.txt")) {
      byte[] text = in.readAllBytes();
      if (text.length != LINES * (SYMBOLS + 1)) {
        throw new IllegalStateException(
            "near.txt has length=" + text.length + " for lines=" + LINES);
      }
      double[] weights = new double[SYMBOLS];
      for (int line = 0; line < LINES; line++) {
        for (int s = 0; s < SYMBOLS; s++) {
          weights[s] = weight((char) text[line * (SYMBOLS + 1) + s]);
        }
        table.set(line, weights);
      }
    } catch (IOException e) {
      throw new UncheckedIOException("near.txt can't be read", e);
    }
    return table;
  }

  /** Returns the weight that a letter stands for. */
  static double weight(char letter) {
    return StrictMath.pow(2, (LIKELIEST - letter) / 2.0);
  }

  /** Returns the letter that stands for a probability. */
  static char letter(double probability) {
    long halves = StrictMath.round(-2 * StrictMath.log(probability) / StrictMath.log(2));
    return (char) (LIKELIEST + Math.max(0, Math.min(LETTERS - 1, halves)));
  }
}
