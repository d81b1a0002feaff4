package carom.net.codec;

/**
 * Probabilities of the bits at the nodes of a format. Each begins with what is given and adapts to
 * the bits that are coded there, new ones fast and old ones slowly. Integers only, so that both
 * ends of a link compute the same.
 *
 * <p>One thread, no allocation after construction.
 */
public final class BitTable {

  /** Most bits between a {@link #mark} and the {@link #rewind} to it. */
  public static final int MAX_MARKED = 64;

  // How fast a node moves: as if its prior were that many bits old, and never older than so many.
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

  /** By node: bits seen, and in the lower 16 bits the probability of a 1. */
  private final int[] states;

  /** Node and former state of the bits since the last mark. */
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

  /** Each node is as it was given. */
  public void begin() {
    System.arraycopy(prior, 0, states, 0, states.length);
    changes = 0;
  }

  /** Remembers this place for {@link #rewind}. */
  public void mark() {
    changes = 0;
  }

  /**
   * Goes back to the last {@link #mark}, since when at most {@link #MAX_MARKED} bits were coded.
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

  /** A node's state after a bit: without a branch, as nothing foresees the bit. */
  private static int next(int state, int bit) {
    int p = state & 0xffff;
    int seen = state >>> 16;
    p += (LEAST + SPAN * bit - p) * STEP[seen] >> 16;
    return seen + (seen - MAX_SEEN >>> 31) << 16 | p;
  }
}
