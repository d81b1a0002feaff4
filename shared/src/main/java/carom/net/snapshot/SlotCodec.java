package carom.net.snapshot;

import carom.net.codec.BitCoder;
import carom.net.codec.SymbolTable;

/**
 * Codes which of 64 neighbouring slots a run has, described once for writing and reading. Each slot
 * is a bit whose probability depends on whether the slot before is in it (of the first, as if one
 * were), and on the run's density: from all, over some evenly spread, to one alone. Nothing depends
 * on other runs.
 */
final class SlotCodec {

  /** Number of bits of a density. */
  static final int DENSITY_BITS = 3;

  static final int DENSITIES = 1 << DENSITY_BITS;

  /** Least saving for which a run takes another density than most, in 1/16 bit. */
  private static final int OTHER = 16 * 6;

  /** By density: how likely a slot is in it if the one before isn't, and if it is; in 1/1,024. */
  private static final int[][] IN = {
    {24, 1_020},
    {20, 920},
    {700, 920},
    {512, 512},
    {256, 256},
    {110, 110},
    {40, 40},
    {12, 12},
  };

  /** Rows: density and state; symbols: how many more slots are in the state, up to all. */
  private static final SymbolTable LENGTHS = new SymbolTable(2 * DENSITIES, Long.SIZE + 1);

  /** By density, and whether this slot and the one before are in it: 1/16 bit. */
  private static final int[] COST = new int[4 * DENSITIES];

  static {
    for (int density = 0; density < DENSITIES; density++) {
      for (int before = 0; before < 2; before++) {
        double in = IN[density][before] / 1_024.0;
        COST[4 * density + 2 * before] = cost(1 - in);
        COST[4 * density + 2 * before + 1] = cost(in);
        LENGTHS.set(2 * density + before, lengths(before == 1 ? in : 1 - in));
      }
    }
  }

  private SlotCodec() {}

  /** Returns how likely each length of a row of slots in one state is. */
  private static double[] lengths(double stay) {
    double[] weights = new double[Long.SIZE + 1];
    double left = 1;
    for (int i = 0; i < Long.SIZE; i++) {
      weights[i] = left * (1 - stay);
      left *= stay;
    }
    weights[Long.SIZE] = left;
    return weights;
  }

  private static int cost(double probability) {
    return (int) Math.rint(-16 * StrictMath.log(probability) / StrictMath.log(2));
  }

  /**
   * Codes the slots.
   *
   * @param slots the lowest bit is the first slot
   */
  public static long code(BitCoder c, int density, long slots) {
    long result = 0;
    long in = -1;
    for (int at = 0; at < Long.SIZE; ) {
      int left = Long.SIZE - at;
      int alike = Math.min(left, Long.numberOfTrailingZeros((slots ^ in) >>> at));
      int length = c.symbol(LENGTHS, 2 * density + (int) (in & 1), alike, left);
      result |= in & mask(length) << at;
      in = ~in;
      at += length;
      if (at < Long.SIZE) {
        result |= in & 1L << at;
        at++;
      }
    }
    return result;
  }

  private static long mask(int bits) {
    return bits == Long.SIZE ? -1 : (1L << bits) - 1;
  }

  /** Returns what slots cost with a density, in 1/16 bit. */
  static int cost(int density, long slots) {
    long before = slots << 1 | 1;
    int both = Long.bitCount(slots & before);
    int begins = Long.bitCount(slots) - both;
    int ends = Long.bitCount(before) - both;
    int at = 4 * density;
    return both * COST[at + 3]
        + begins * COST[at + 1]
        + ends * COST[at + 2]
        + (Long.SIZE - both - begins - ends) * COST[at];
  }

  /**
   * Returns the density to code slots with: that of most, unless another one is much cheaper.
   *
   * @param usual the density of most
   */
  static int density(long slots, int usual) {
    int best = usual;
    int least = cost(usual, slots) - OTHER;
    for (int density = 0; density < DENSITIES; density++) {
      int cost = cost(density, slots);
      if (cost < least) {
        least = cost;
        best = density;
      }
    }
    return best;
  }
}
