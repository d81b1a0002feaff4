package carom.lab.trace;

import carom.net.codec.BitCoder;
import java.util.Arrays;

/**
 * Estimates the probability of a bit from the bits seen before in several contexts. Each context
 * has a count: the share of ones and the number of bits seen, so that new counts move fast and old
 * ones slowly. The log odds of all counts are added with weights that learn which contexts predict
 * well. Each situation has its own set of weights. All numbers are integers, so both ends of a link
 * compute the same.
 *
 * <p>Use: {@link #select} a count for each input, {@link #weights} for the situation, then {@link
 * #code}. One thread, no allocation.
 */
public final class Mixture {

  private static final int SEEN_BITS = 10;
  private static final int SEEN_MASK = (1 << SEEN_BITS) - 1;
  private static final int UNKNOWN = 1 << 31;
  private static final int WEIGHT_ONE = 1 << 16;
  private static final int RATE = 3;
  private static final int[] STEP = new int[SEEN_MASK + 1];

  static {
    for (int i = 0; i < STEP.length; i++) {
      STEP[i] = (1 << 16) * 10 / (10 * i + 16);
    }
  }

  private final int inputs;
  private final int memory;
  private final int[] counts;
  private final int[] weights;
  private final int[] selected;
  private final int[] odds;
  private int set;
  private int estimate;

  /**
   * Creates a mixture that knows nothing.
   *
   * @param inputs number of contexts per bit
   * @param slots number of counts
   * @param sets number of sets of weights
   * @param memory most bits that a count averages over, 1..1023
   */
  public Mixture(int inputs, int slots, int sets, int memory) {
    if (memory < 1 || memory > SEEN_MASK) {
      throw new IllegalArgumentException("memory=" + memory + " is outside 1.." + SEEN_MASK);
    }
    this.inputs = inputs;
    this.memory = memory;
    counts = new int[slots];
    weights = new int[inputs * sets];
    selected = new int[inputs];
    odds = new int[inputs];
    reset();
  }

  /** Forgets everything. */
  public void reset() {
    Arrays.fill(counts, UNKNOWN);
    // The sum weighs more than the mean: contexts that agree raise the certainty.
    Arrays.fill(weights, WEIGHT_ONE * 14 / (10 * inputs));
  }

  /** Chooses the count of an input. */
  public void select(int input, int slot) {
    selected[input] = slot;
  }

  /** Chooses the set of weights. */
  public void weights(int set) {
    this.set = set * inputs;
  }

  /**
   * Codes a bit.
   *
   * @param bit 0 or 1; ignored when the coder reads
   * @param learning whether to remember it
   * @return the bit
   */
  public int code(BitCoder coder, int bit, boolean learning) {
    long sum = 0;
    for (int i = 0; i < inputs; i++) {
      int o = Logistic.stretch(counts[selected[i]] >>> 20);
      odds[i] = o;
      sum += (long) o * weights[set + i];
    }
    estimate = Logistic.squash((int) (sum >> 16));
    int result = coder.code(bit, estimate);
    if (learning) {
      learn(result);
    }
    return result;
  }

  private void learn(int bit) {
    int error = ((bit << 16) - bit - estimate) * RATE;
    int target = bit == 0 ? 0 : (1 << 22) - 1;
    for (int i = 0; i < inputs; i++) {
      weights[set + i] += (int) ((long) odds[i] * error + (1 << 17) >> 18);
      int count = counts[selected[i]];
      int seen = count & SEEN_MASK;
      int share = count >>> SEEN_BITS;
      share += (int) ((long) (target - share) * STEP[seen] >> 16);
      counts[selected[i]] = share << SEEN_BITS | Math.min(seen + 1, memory);
    }
  }
}
