package carom.physics.dynamics.simd;

import carom.physics.dynamics.store.ColumnHash;
import carom.physics.dynamics.store.ColumnHashLanes;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.LongVector;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/** Hashes a column by vectors, with the Vector API. */
public final class VectorColumnHash extends ColumnHashLanes {
  private static final VectorSpecies<Long> LONGS = LongVector.SPECIES_PREFERRED;
  private static final VectorSpecies<Float> FLOATS = FloatVector.SPECIES_PREFERRED;
  private static final int WIDTH = LONGS.length();

  /** Longs that a vector must have: shorter ones gain nothing. */
  private static final int LEAST_WIDTH = 4;

  private final long[] warmUpFactors = new long[BLOCK / 2];
  private final long[] warmUpSums = new long[SUMS];

  /** Creates the kernels; called by name, see {@link ColumnHashLanes#FOUND}. */
  public VectorColumnHash() {
    if (WIDTH < LEAST_WIDTH || WIDTH > SUMS) {
      throw new UnsupportedOperationException("vectors of " + WIDTH + " longs");
    }
  }

  @Override
  protected int warmUpSize() {
    return BLOCK;
  }

  @Override
  protected void warmUp(float[] numbers) {
    column(numbers, warmUpFactors, 0, BLOCK, warmUpSums);
  }

  @Override
  public void column(float[] column, long[] factors, int from, int to, long[] sums) {
    LongVector sum = LongVector.fromArray(LONGS, sums, 0);
    for (int i = from; i < to; i += 2 * WIDTH) {
      LongVector word = FloatVector.fromArray(FLOATS, column, i).reinterpretAsLongs();
      word = word.mul(ColumnHash.SPREAD);
      word = word.lanewise(VectorOperators.LSHR, 32).lanewise(VectorOperators.XOR, word);
      sum = sum.add(word.mul(LongVector.fromArray(LONGS, factors, i >> 1)));
    }
    sum.intoArray(sums, 0);
  }
}
