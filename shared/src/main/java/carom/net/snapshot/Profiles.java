package carom.net.snapshot;

import carom.net.codec.BitCoder;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;

/**
 * How likely each bit of a delta is a 1, by node of {@link DeltaCodec}: one table for each of a few
 * kinds of scenes, as bodies that roll apart on a plane and a heap that settles differ in almost
 * every bit. The server finds out which one fits its world best, tick by tick, and says so in each
 * datagram. Counted over records of scenes by {@code ProfileTraining} in the tests; other tables
 * are another protocol.
 *
 * <p>The file {@code profiles.txt} has one line for each table. A letter is a probability on a
 * scale of log odds.
 */
final class Profiles {

  /** Bits that tell a profile. */
  static final int BITS = 3;

  /** How many there are. */
  static final int COUNT = 1 << BITS;

  /** The letters '#' to '[': log odds from -8 to 8. */
  private static final char FIRST = '#';

  private static final int LETTERS = 57;
  private static final double STEP = 16.0 / (LETTERS - 1);
  private static final char[][] TABLES = read();

  private Profiles() {}

  /**
   * A profile: probabilities of a 1 in 1/65,536 by node. Shared, not to be changed.
   *
   * @param number 0..{@link #COUNT} - 1
   */
  static char[] table(int number) {
    return TABLES[number];
  }

  private static char[][] read() {
    char[] probability = new char[LETTERS];
    for (int i = 0; i < LETTERS; i++) {
      probability[i] = (char) probability((char) (FIRST + i));
    }
    try (InputStream in = Profiles.class.getResourceAsStream("profiles.txt")) {
      byte[] text = in.readAllBytes();
      if (text.length != COUNT * (DeltaCodec.NODES + 1)) {
        throw new IllegalStateException(
            "profiles.txt has length=" + text.length + " for nodes=" + DeltaCodec.NODES);
      }
      char[][] tables = new char[COUNT][DeltaCodec.NODES];
      for (int i = 0; i < COUNT; i++) {
        for (int node = 0; node < DeltaCodec.NODES; node++) {
          tables[i][node] = probability[text[i * (DeltaCodec.NODES + 1) + node] - FIRST];
        }
      }
      return tables;
    } catch (IOException e) {
      throw new UncheckedIOException("profiles.txt can't be read", e);
    }
  }

  /** What a letter stands for, in 1/65,536. */
  static int probability(char letter) {
    double odds = (letter - FIRST - LETTERS / 2) * STEP;
    return (int) StrictMath.round(BitCoder.ONE / (1 + StrictMath.exp(-odds)));
  }

  /** The letter that stands for a probability. */
  static char letter(double probability) {
    double odds = StrictMath.log(probability / (1 - probability));
    long at = StrictMath.round(odds / STEP) + LETTERS / 2;
    return (char) (FIRST + Math.max(0, Math.min(LETTERS - 1, at)));
  }
}
