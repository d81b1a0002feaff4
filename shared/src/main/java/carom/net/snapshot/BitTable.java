package carom.net.snapshot;

import carom.net.codec.BitCoder;

/**
 * Adaptive probabilities of the bits at the nodes of a format. Each node starts with a given
 * probability and adapts to the bits coded there, fast at first and more slowly with every bit. The
 * arithmetic uses integers only, so that both ends of a link compute the same.
 *
 * <p>Use it from one thread; it doesn't allocate after construction.
 */
final class BitTable {

  /** Largest number of bits between a {@link #mark} and the {@link #rewind} to it. */
  public static final int MAX_MARKED = 64;

  // The adaptation rate of a node is 1 / (bits seen + PRIOR_AGE), with at most MAX_SEEN bits
  // counted.
  private static final int PRIOR_AGE = 12;
  private static final int MAX_SEEN = 60;
  private static final int LEAST = 32;
  private static final int SPAN = BitCoder.ONE - 2 * LEAST;
  private static final int[] STEP = new int[MAX_SEEN + 1];

  static {
    for (int seen = 0; seen <= MAX_SEEN; seen++) {
      STEP[seen] = BitCoder.ONE / (seen + PRIOR_AGE);
    }
  }

  private final int[] prior;

  /**
   * By node: the number of bits seen in the upper 16 bits, and the probability of a 1 in the lower
   * 16.
   */
  private final int[] states;

  /** Ring of node and former state for each bit since the last mark. */
  private final long[] changed = new long[MAX_MARKED];

  private int changes;

  /**
   * Creates a table; call {@link #begin}.
   *
   * @param prior probability of a 1 for each node, in 1/65,536: 1..65,535; copied
   */
  public BitTable(char[] prior) {
    this.prior = new int[prior.length];
    for (int node = 0; node < prior.length; node++) {
      this.prior[node] = prior[node];
    }
    states = new int[prior.length];
  }

  /** Resets every node to its prior. */
  public void begin() {
    System.arraycopy(prior, 0, states, 0, states.length);
    changes = 0;
  }

  /** Marks the current state for {@link #rewind}. */
  public void mark() {
    changes = 0;
  }

  /**
   * Restores the state at the last {@link #mark}. At most {@link #MAX_MARKED} bits may have been
   * coded after it.
   */
  public void rewind() {
    while (changes > 0) {
      long change = changed[--changes & MAX_MARKED - 1];
      states[(int) (change >>> 32)] = (int) change;
    }
  }

  /**
   * Codes a bit at a node.
   *
   * @return the bit written, or the bit read
   */
  public int code(BitCoder c, int node, int bit) {
    int state = states[node];
    int result = c.code(bit, state & 0xffff);
    changed[changes++ & MAX_MARKED - 1] = (long) node << 32 | state;
    states[node] = next(state, result);
    return result;
  }

  /**
   * Returns the state of a node after a bit. It has no branch on the bit, because a processor can't
   * predict it.
   */
  private static int next(int state, int bit) {
    int p = state & 0xffff;
    int seen = state >>> 16;
    p += (LEAST + SPAN * bit - p) * STEP[seen] >> 16;
    return seen + (seen - MAX_SEEN >>> 31) << 16 | p;
  }
}
