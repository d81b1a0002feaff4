package carom.net.codec;

/**
 * Stores nothing and adds up what bits would cost: to choose the cheaper of two ways to say
 * something. One thread, no allocation.
 */
public final class Surprise extends BitCoder {

  /** Parts of a bit. */
  private static final int UNIT = 256;

  private static final int SHIFT = 4;
  private static final int[] COST = new int[ONE >> SHIFT];

  static {
    for (int i = 0; i < COST.length; i++) {
      double probability = (i + 0.5) / COST.length;
      COST[i] = (int) Math.rint(-UNIT * StrictMath.log(probability) / StrictMath.log(2));
    }
  }

  private long sum;

  /** Creates one that has seen nothing. */
  public Surprise() {}

  /** Forgets what it has seen. */
  public void reset() {
    sum = 0;
  }

  /** What the bits would cost, in 1/256 bit, to within a few percent. */
  public long sum() {
    return sum;
  }

  @Override
  public int code(int bit, int probability) {
    sum += COST[(bit != 0 ? probability : ONE - 1 - probability) >> SHIFT];
    return bit;
  }
}
