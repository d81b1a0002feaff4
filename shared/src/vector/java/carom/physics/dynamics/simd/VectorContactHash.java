package carom.physics.dynamics.simd;

import carom.physics.dynamics.contact.ContactHash;
import carom.physics.dynamics.contact.ContactHashLanes;
import carom.physics.dynamics.contact.ContactTable;
import carom.physics.dynamics.store.ColumnHash;
import carom.physics.math.StateHash;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.LongVector;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/**
 * Hashes contact rows by vectors, with the Vector API. Small methods that pass each other arrays,
 * never vectors: these would be boxed. The impulses of a row are the second half of its record: the
 * last four longs of a vector that ends where the record does.
 */
public final class VectorContactHash extends ContactHashLanes {
  private static final VectorSpecies<Long> LONGS = LongVector.SPECIES_PREFERRED;
  private static final VectorSpecies<Float> FLOATS = FloatVector.SPECIES_PREFERRED;
  private static final VectorSpecies<Integer> INTS = IntVector.SPECIES_PREFERRED;
  private static final int WIDTH = LONGS.length();

  /** Longs of a row's impulses. */
  private static final int IMPULSES = 4;

  private static final VarHandle BYTES =
      MethodHandles.byteArrayViewVarHandle(long[].class, ByteOrder.LITTLE_ENDIAN);

  /** Byte by byte. */
  private static final LongVector SHIFTS = LongVector.zero(LONGS).addIndex(Byte.SIZE);

  /** Mask of all but the friction impulses of the whole step. */
  private static final LongVector COUNTED = counted();

  /** Rows of a warm-up call: few, because calls go on when the kernels are long compiled. */
  private static final int WARM_UP_ROWS = 2 * ROWS;

  private final long[] warmUpKeys = new long[WARM_UP_ROWS];
  private final byte[] warmUpBytes = new byte[WARM_UP_ROWS];
  private final int[] warmUpIds = new int[2 * WARM_UP_ROWS];
  private final long[] warmUpFactors = new long[WARM_UP_ROWS];
  private final long[] warmUpSums = new long[3 * SUMS];

  /** Creates the kernels; called by name, see {@link ContactHashLanes#FOUND}. */
  public VectorContactHash() {
    if (WIDTH < IMPULSES || WIDTH > SUMS) {
      throw new UnsupportedOperationException("vectors of " + WIDTH + " longs");
    }
  }

  private static LongVector counted() {
    long[] mask = new long[WIDTH];
    for (int i = 0; i < WIDTH; i++) {
      mask[i] = i % 2 == 0 ? -1 : 0xffffffffL;
    }
    return LongVector.fromArray(LONGS, mask, 0);
  }

  @Override
  protected int warmUpSize() {
    return WARM_UP_ROWS * ContactTable.CONTACT;
  }

  @Override
  protected void warmUp(float[] numbers) {
    findFactors(warmUpKeys, warmUpBytes, 0, WARM_UP_ROWS, warmUpFactors);
    states(warmUpBytes, warmUpBytes, 0, WARM_UP_ROWS, warmUpFactors, warmUpSums);
    ids(warmUpIds, 0, WARM_UP_ROWS, warmUpFactors, warmUpSums);
    impulses(numbers, 0, WARM_UP_ROWS, warmUpFactors, warmUpSums);
  }

  @Override
  public void names(ContactTable t, int from, int to, long[] factors, long[] sums) {
    findFactors(t.key, t.flags, from, to, factors);
    states(t.flags, t.points, from, to, factors, sums);
    ids(t.id, from, to, factors, sums);
  }

  /** Finds the {@link ContactHash#factor} of rows, zero where nothing touches. */
  private static void findFactors(long[] key, byte[] flags, int from, int to, long[] factors) {
    for (int row = from; row < to; row += ROWS) {
      long eight = (long) BYTES.get(flags, row);
      for (int i = 0; i < ROWS; i += WIDTH) {
        LongVector flag =
            LongVector.broadcast(LONGS, eight >>> i * Byte.SIZE)
                .lanewise(VectorOperators.LSHR, SHIFTS);
        LongVector touching = flag.and(ContactTable.TOUCHING).neg();
        LongVector h = LongVector.fromArray(LONGS, key, row + i);
        h = h.lanewise(VectorOperators.LSHR, 33).lanewise(VectorOperators.XOR, h);
        h = h.mul(StateHash.FINISH_FIRST);
        h = h.lanewise(VectorOperators.LSHR, 33).lanewise(VectorOperators.XOR, h);
        h = h.mul(StateHash.FINISH_SECOND);
        h = h.lanewise(VectorOperators.LSHR, 33).lanewise(VectorOperators.XOR, h);
        h.or(1).and(touching).intoArray(factors, row - from + i);
      }
    }
  }

  private static void states(
      byte[] flags, byte[] points, int from, int to, long[] factors, long[] sums) {
    LongVector sum = LongVector.fromArray(LONGS, sums, 0);
    for (int row = from; row < to; row += ROWS) {
      long flagsOfAll = (long) BYTES.get(flags, row);
      long pointsOfAll = (long) BYTES.get(points, row);
      for (int i = 0; i < ROWS; i += WIDTH) {
        LongVector flag =
            LongVector.broadcast(LONGS, flagsOfAll >>> i * Byte.SIZE)
                .lanewise(VectorOperators.LSHR, SHIFTS)
                .and(ContactHash.FLAGS);
        LongVector point =
            LongVector.broadcast(LONGS, pointsOfAll >>> i * Byte.SIZE)
                .lanewise(VectorOperators.LSHR, SHIFTS)
                .and(0xff)
                .lanewise(VectorOperators.LSHL, ContactHash.POINTS_SHIFT);
        sum = sum.add(flag.or(point).mul(LongVector.fromArray(LONGS, factors, row - from + i)));
      }
    }
    sum.intoArray(sums, 0);
  }

  private static void ids(int[] id, int from, int to, long[] factors, long[] sums) {
    LongVector sum = LongVector.fromArray(LONGS, sums, SUMS);
    for (int row = from; row < to; row += WIDTH) {
      LongVector word = IntVector.fromArray(INTS, id, 2 * row).reinterpretAsLongs();
      word = word.mul(ColumnHash.SPREAD);
      word = word.lanewise(VectorOperators.LSHR, 32).lanewise(VectorOperators.XOR, word);
      sum = sum.add(word.mul(LongVector.fromArray(LONGS, factors, row - from)));
    }
    sum.intoArray(sums, SUMS);
  }

  @Override
  public void impulses(float[] contact, int from, int to, long[] factors, long[] sums) {
    LongVector sum = LongVector.fromArray(LONGS, sums, 2 * SUMS);
    int at = ContactTable.CONTACT - 2 * WIDTH;
    for (int row = from; row < to; row++) {
      LongVector word =
          FloatVector.fromArray(FLOATS, contact, row * ContactTable.CONTACT + at)
              .reinterpretAsLongs()
              .and(COUNTED);
      word = word.mul(ColumnHash.SPREAD);
      word = word.lanewise(VectorOperators.LSHR, 32).lanewise(VectorOperators.XOR, word);
      sum = sum.add(word.mul(LongVector.broadcast(LONGS, factors[row - from])));
    }
    sum.intoArray(sums, 2 * SUMS);
  }

  @Override
  public void gather(long[] sums, long[] to) {
    int first = 2 * SUMS + WIDTH - IMPULSES;
    to[ContactHash.START0] += sums[first];
    to[ContactHash.TOTALS0] += sums[first + 1];
    to[ContactHash.START1] += sums[first + 2];
    to[ContactHash.TOTALS1] += sums[first + 3];
  }
}
