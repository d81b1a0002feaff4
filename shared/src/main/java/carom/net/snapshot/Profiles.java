package carom.net.snapshot;

import carom.net.codec.BitCoder;
import carom.net.codec.SymbolTable;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;

/**
 * Holds how likely the symbols of a delta are, by head and tree of {@link DeltaCodec}. There is one
 * set of tables for each of a few kinds of scenes, because bodies that roll apart on a plane and a
 * heap that settles differ in almost every bit. The server finds out which one fits its world best,
 * tick by tick, and says so in each datagram. Counted over records of scenes by {@code
 * ProfileTraining} in the tests; other tables are another protocol.
 *
 * <p>The file {@code profiles.txt} has one line for each profile: how likely each bit of a delta is
 * a 1, by node. A letter is a probability on a scale of log odds. The file {@code shares.txt} has
 * the shares of {@link Predictor}, a line for each profile: first those of places, then those of
 * angles; of each class, from the smallest bend on, the share of the last speed and that of the
 * bend.
 */
final class Profiles {

  /** Number of bits of a profile. */
  static final int BITS = 3;

  /** Number of profiles. */
  static final int COUNT = 1 << BITS;

  /** The letters '#' to '[': log odds from -8 to 8. */
  private static final char FIRST = '#';

  private static final int LETTERS = 57;
  private static final double STEP = 16.0 / (LETTERS - 1);

  /** By profile and head of {@link DeltaCodec}. */
  static final SymbolTable HEADS =
      new SymbolTable(COUNT * DeltaCodec.HEADS, DeltaCodec.HEAD_SYMBOLS);

  /** By profile and tree of {@link DeltaCodec}. */
  static final SymbolTable NUMBERS =
      new SymbolTable(COUNT * DeltaCodec.TREES, DeltaCodec.NUMBER_SYMBOLS);

  /** Largest share, either way. */
  private static final int MAX_SHARE = 2 * Predictor.WHOLE;

  /** By profile: how long bodies rest on. */
  static final SymbolTable RESTS = new SymbolTable(COUNT, DeltaCodec.REST_SYMBOLS);

  /** By profile: the shares of its predictions, as they are in the file. */
  static final short[] SHARES = new short[COUNT * Predictor.SHARES];

  static {
    read();
    shares(new String(bytes("shares.txt"), StandardCharsets.US_ASCII), SHARES);
  }

  private Profiles() {}

  private static void read() {
    double[] probability = new double[LETTERS];
    for (int i = 0; i < LETTERS; i++) {
      probability[i] = (double) probability((char) (FIRST + i)) / BitCoder.ONE;
    }
    byte[] text = bytes("profiles.txt");
    if (text.length != COUNT * (DeltaCodec.NODES + 1)) {
      throw new IllegalStateException(
          "profiles.txt has length=" + text.length + " for nodes=" + DeltaCodec.NODES);
    }
    double[] nodes = new double[DeltaCodec.NODES];
    for (int i = 0; i < COUNT; i++) {
      for (int node = 0; node < DeltaCodec.NODES; node++) {
        nodes[node] = probability[text[i * (DeltaCodec.NODES + 1) + node] - FIRST];
      }
      set(i, nodes);
    }
  }

  private static byte[] bytes(String name) {
    try (InputStream in = Profiles.class.getResourceAsStream(name)) {
      return in.readAllBytes();
    } catch (IOException e) {
      throw new UncheckedIOException(name + " can't be read", e);
    }
  }

  private static void shares(String text, short[] to) {
    String[] numbers = text.trim().split("\\s+");
    if (numbers.length != to.length) {
      throw new IllegalStateException("shares.txt has numbers=" + numbers.length);
    }
    for (int i = 0; i < to.length; i++) {
      to[i] = Short.parseShort(numbers[i]);
      if (Math.abs(to[i]) > MAX_SHARE) {
        throw new IllegalStateException("shares.txt has share=" + to[i] + " above " + MAX_SHARE);
      }
    }
  }

  /** Sets each symbol as likely as all the bits together that it was made of. */
  private static void set(int number, double[] nodes) {
    double[] weights = new double[DeltaCodec.HEAD_SYMBOLS];
    double[] product = new double[1];
    DeltaCodec.Steps times = (node, bit) -> product[0] *= bit != 0 ? nodes[node] : 1 - nodes[node];
    for (int head = 0; head < DeltaCodec.HEADS; head++) {
      for (int symbol = 0; symbol < weights.length; symbol++) {
        product[0] = 1;
        DeltaCodec.headSteps(head, symbol, times);
        weights[symbol] = product[0];
      }
      HEADS.set(number * DeltaCodec.HEADS + head, weights);
    }
    weights = new double[DeltaCodec.NUMBER_SYMBOLS];
    for (int tree = 0; tree < DeltaCodec.TREES; tree++) {
      for (int symbol = 0; symbol < weights.length; symbol++) {
        product[0] = 1;
        DeltaCodec.numberSteps(tree, symbol, times);
        weights[symbol] = product[0];
      }
      NUMBERS.set(number * DeltaCodec.TREES + tree, weights);
    }
    weights = new double[DeltaCodec.REST_SYMBOLS];
    for (int symbol = 0; symbol < weights.length; symbol++) {
      product[0] = 1;
      DeltaCodec.restSteps(symbol, times);
      weights[symbol] = product[0];
    }
    RESTS.set(number, weights);
  }

  /** Returns the probability that a letter stands for, in 1/65,536. */
  static int probability(char letter) {
    double odds = (letter - FIRST - LETTERS / 2) * STEP;
    return (int) StrictMath.round(BitCoder.ONE / (1 + StrictMath.exp(-odds)));
  }

  /** Returns the letter that stands for a probability. */
  static char letter(double probability) {
    double odds = StrictMath.log(probability / (1 - probability));
    long at = StrictMath.round(odds / STEP) + LETTERS / 2;
    return (char) (FIRST + Math.max(0, Math.min(LETTERS - 1, at)));
  }
}
