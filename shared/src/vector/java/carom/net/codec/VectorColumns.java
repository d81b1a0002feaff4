package carom.net.codec;

import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/**
 * The numbers of a column by vectors, with the Vector API. Small methods that pass each other
 * arrays, never vectors: these would be boxed. Floats become integers by adding a number so large
 * that no fraction is left, as this API converts slowly on some JVMs.
 */
final class VectorColumns extends ColumnLanes {
  private static final VectorSpecies<Float> LANE = FloatVector.SPECIES_PREFERRED;
  private static final int WIDTH = LANE.length();
  private static final int LEAST_WIDTH = 8;

  /** Floats of up to 2^22 of either sign are rounded to integers when this is added. */
  private static final float LARGE = 1.5f * (1 << 23);

  private static final int LARGE_BITS = Float.floatToRawIntBits(LARGE);

  /** The same for floats that aren't negative, of up to 2^23. */
  private static final float POSITIVE = 1 << 23;

  private static final int POSITIVE_BITS = Float.floatToRawIntBits(POSITIVE);

  /** A whole turn of {@code Trig.roughTurn}. */
  private static final int TURN = 1 << 26;

  private static final float HALF_TURNS_PER_RADIAN = (float) (TURN / (4 * Math.PI));

  private static final int STEP_SHIFT = 16;
  private static final int STEP = 1 << STEP_SHIFT;

  /** Loaded by name, see {@link ColumnLanes#FOUND}. */
  VectorColumns() {
    if (WIDTH < LEAST_WIDTH) {
      throw new UnsupportedOperationException("vectors have fewer than " + LEAST_WIDTH + " lanes");
    }
  }

  @Override
  int width() {
    return WIDTH;
  }

  @Override
  boolean round(float[] from, int at, float scale, float max, int[] to) {
    FloatVector steps = FloatVector.fromArray(LANE, from, at).mul(scale);
    FloatVector moved = steps.add(LARGE);
    // Nearest, halves to even; a half is left where that was down, and here it must be up.
    FloatVector rest = steps.sub(moved.sub(LARGE));
    IntVector down = rest.sub(0.5f).reinterpretAsInts().lanewise(VectorOperators.ASHR, 31);
    moved.reinterpretAsInts().sub(LARGE_BITS - 1).add(down).intoArray(to, at);
    return steps.abs().compare(VectorOperators.LE, max).allTrue();
  }

  @Override
  void turn(float[] cos, float[] sin, int at, int error, int[] to) {
    ratio(cos, sin, at, to);
    fold(cos, sin, at, to);
    step(at, error, to);
  }

  /** The angle to the nearer axis, 0 to an eighth of a turn; 0 if it isn't a number. */
  private static void ratio(float[] cos, float[] sin, int at, int[] to) {
    IntVector x = FloatVector.fromArray(LANE, cos, at).reinterpretAsInts().and(Integer.MAX_VALUE);
    IntVector y = FloatVector.fromArray(LANE, sin, at).reinterpretAsInts().and(Integer.MAX_VALUE);
    IntVector more = x.sub(y);
    IntVector shift = more.lanewise(VectorOperators.ASHR, 31).and(more);
    FloatVector t = y.add(shift).reinterpretAsFloats().div(x.sub(shift).reinterpretAsFloats());
    FloatVector q = t.mul(t);
    FloatVector p = q.mul(0.0208351f).sub(0.0851330f);
    p = p.mul(q).add(0.1801410f);
    p = p.mul(q).sub(0.3302995f);
    p = p.mul(q).add(0.9998660f);
    FloatVector halves = t.mul(p).mul(HALF_TURNS_PER_RADIAN).add(POSITIVE);
    // What isn't a number has either sign, and abs() may leave it.
    IntVector turn = halves.reinterpretAsInts().and(Integer.MAX_VALUE).sub(POSITIVE_BITS);
    IntVector number = turn.sub(TURN / 8).lanewise(VectorOperators.ASHR, 31);
    turn.add(turn).and(number).intoArray(to, at);
  }

  /** From that angle to the one of the whole turn. */
  private static void fold(float[] cos, float[] sin, int at, int[] to) {
    IntVector x = FloatVector.fromArray(LANE, cos, at).reinterpretAsInts();
    IntVector y = FloatVector.fromArray(LANE, sin, at).reinterpretAsInts();
    IntVector more = x.and(Integer.MAX_VALUE).sub(y.and(Integer.MAX_VALUE));
    IntVector steep = more.lanewise(VectorOperators.ASHR, 31);
    IntVector left = x.lanewise(VectorOperators.ASHR, 31);
    IntVector below = y.lanewise(VectorOperators.ASHR, 31);
    IntVector turn = IntVector.fromArray(IntVector.SPECIES_PREFERRED, to, at);
    turn = turn.lanewise(VectorOperators.XOR, steep).sub(steep).add(steep.and(TURN / 4));
    turn = turn.lanewise(VectorOperators.XOR, left).sub(left).add(left.and(TURN / 2));
    turn.lanewise(VectorOperators.XOR, below).sub(below).intoArray(to, at);
  }

  /** Rounds to steps; -1 where the error may decide. */
  private static void step(int at, int error, int[] to) {
    IntVector moved = IntVector.fromArray(IntVector.SPECIES_PREFERRED, to, at).add(STEP / 2);
    IntVector rest = moved.and(STEP - 1);
    IntVector early = rest.sub(error + 1);
    IntVector late = rest.neg().add(STEP - error - 1);
    IntVector unsure = early.or(late).lanewise(VectorOperators.ASHR, 31);
    moved
        .lanewise(VectorOperators.ASHR, STEP_SHIFT)
        .and(Quantizer.ANGLE_STEPS - 1)
        .or(unsure)
        .intoArray(to, at);
  }
}
