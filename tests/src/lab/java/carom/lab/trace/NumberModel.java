package carom.lab.trace;

import carom.net.codec.BitCoder;

/**
 * Codes mostly small whole numbers as bits of an Exp-Golomb tree: zero or not, sign, number of
 * binary digits, digits behind the first. Each node of the tree is a {@link Mixture} of the given
 * contexts. The low digits of long numbers are noise and coded without a model. One thread, no
 * allocation.
 */
public final class NumberModel {

  /** Largest magnitude that can be coded: 2^27 - 1. */
  public static final int MAX = (1 << 27) - 1;

  private static final int MAX_DIGITS = 27;
  private static final int NODES = 64;
  private static final int ZERO = 0;
  private static final int NEGATIVE = 1;
  private static final int LENGTH = 2;
  private static final int DIGITS = LENGTH + MAX_DIGITS - 1;

  /** The two digits behind the first are modelled, in numbers of up to this many digits. */
  private static final int MODELLED = (NODES - DIGITS) / 3;

  private final Mixture mixture;
  private final int inputs;
  private final int contexts;
  private final int[] context;
  private int situation;

  /**
   * Creates a model that knows nothing.
   *
   * @param inputs contexts used for each number
   * @param contexts how many values each of them can have
   * @param situations sets of weights
   */
  public NumberModel(int inputs, int contexts, int situations) {
    this.inputs = inputs;
    this.contexts = contexts;
    context = new int[inputs];
    mixture = new Mixture(inputs, inputs * contexts * NODES, situations * NODES, 1_000);
  }

  /** Forgets everything. */
  public void reset() {
    mixture.reset();
  }

  /**
   * Sets one of the contexts of the next number.
   *
   * @param value 0..contexts - 1
   */
  public void context(int input, int value) {
    context[input] = (input * contexts + value) * NODES;
  }

  /** Sets the situation of the next number. */
  public void situation(int value) {
    situation = value * NODES;
  }

  /**
   * Codes a number.
   *
   * @param value within plus or minus {@link #MAX}; ignored when the coder reads
   * @param learning whether to remember it
   * @return the number
   */
  public int code(BitCoder coder, int value, boolean learning) {
    int magnitude = Math.abs(value);
    if (node(ZERO, coder, magnitude == 0 ? 1 : 0, learning) != 0) {
      return 0;
    }
    int negative = node(NEGATIVE, coder, value >>> 31, learning);
    int digits = 1;
    while (digits < MAX_DIGITS
        && node(LENGTH + digits - 1, coder, magnitude >>> digits != 0 ? 1 : 0, learning) != 0) {
      digits++;
    }
    int result = 1;
    for (int at = digits - 2; at >= 0; at--) {
      int digit = magnitude >>> at & 1;
      int depth = digits - 2 - at;
      if (depth < 2 && digits <= MODELLED) {
        int node = DIGITS + 3 * (digits - 1) + (depth == 0 ? 0 : 1 + (result & 1));
        digit = node(node, coder, digit, learning);
      } else {
        digit = coder.code(digit, BitCoder.ONE / 2);
      }
      result = result << 1 | digit;
    }
    return negative != 0 ? -result : result;
  }

  private int node(int node, BitCoder coder, int bit, boolean learning) {
    for (int i = 0; i < inputs; i++) {
      mixture.select(i, context[i] + node);
    }
    mixture.weights(situation + node);
    return mixture.code(coder, bit, learning);
  }
}
