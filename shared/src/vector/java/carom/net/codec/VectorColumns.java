package carom.net.codec;

import static jdk.incubator.vector.VectorOperators.ADD;
import static jdk.incubator.vector.VectorOperators.ASHR;
import static jdk.incubator.vector.VectorOperators.DIV;
import static jdk.incubator.vector.VectorOperators.MUL;
import static jdk.incubator.vector.VectorOperators.OR;
import static jdk.incubator.vector.VectorOperators.SUB;
import static jdk.incubator.vector.VectorOperators.XOR;

import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorSpecies;

/**
 * Kernels of {@link ColumnLanes} built on the Vector API. They are small methods that pass each
 * other arrays and never vectors, which the JVM would box. Floats become integers by adding a
 * number so large that no fraction is left, because the conversion of this API is slow on some
 * JVMs.
 *
 * <p>The vectors are as long as the engine's, because a process should use one length only. Methods
 * of vectors that call others themselves, like {@code FloatVector.mul}, record for all callers
 * which lengths they saw. Large kernels depend on these records, so kernels of four lanes here make
 * those of the engine box vectors. For the same reason, these kernels have neither such calls on
 * floats nor masks; {@code lanewise} on a vector just loaded is unambiguous.
 */
public final class VectorColumns extends ColumnLanes {
  private static final VectorSpecies<Float> LANE = FloatVector.SPECIES_PREFERRED;
  private static final int WIDTH = LANE.length();

  /** Adding this number rounds a float of up to 2^22 of either sign to an integer. */
  private static final float LARGE = 1.5f * (1 << 23);

  private static final int LARGE_BITS = Float.floatToRawIntBits(LARGE);

  /** Adding this number rounds a float of 0 to 2^23 to an integer. */
  private static final float POSITIVE = 1 << 23;

  private static final int POSITIVE_BITS = Float.floatToRawIntBits(POSITIVE);

  /** A whole turn in the units of {@code Trig.roughTurn}. */
  private static final int TURN = 1 << 26;

  private static final float HALF_TURNS_PER_RADIAN = (float) (TURN / (4 * Math.PI));

  private static final int STEP_SHIFT = 16;
  private static final int STEP = 1 << STEP_SHIFT;

  private final int[] warmUpSteps = new int[WIDTH];

  /** Creates the kernels, which {@link ColumnLanes#FOUND} loads by name. */
  public VectorColumns() {
    if (FloatVector.SPECIES_PREFERRED.length() < WIDTH) {
      throw new UnsupportedOperationException("vectors have fewer than " + WIDTH + " lanes");
    }
  }

  @Override
  protected int warmUpSize() {
    return WIDTH;
  }

  @Override
  protected void warmUp(float[] numbers) {
    round(numbers, 0, 1, 1, warmUpSteps);
    turn(numbers, numbers, 0, 0, warmUpSteps);
  }

  @Override
  int width() {
    return WIDTH;
  }

  @Override
  boolean round(float[] from, int at, float scale, float max, int[] to) {
    FloatVector large = all(LARGE);
    FloatVector steps = FloatVector.fromArray(LANE, from, at).lanewise(MUL, all(scale));
    FloatVector moved = steps.lanewise(ADD, large);
    // This rounds halves to even. A remaining half was rounded down, and must be rounded up.
    FloatVector rest = steps.lanewise(SUB, moved.lanewise(SUB, large));
    FloatVector below = rest.lanewise(SUB, all(0.5f));
    IntVector down = below.reinterpretAsInts().lanewise(ASHR, 31);
    moved.reinterpretAsInts().sub(LARGE_BITS - 1).add(down).intoArray(to, at);
    // Magnitudes of floats sort like their bits, and NaN sorts after all numbers.
    IntVector length = steps.reinterpretAsInts().and(Integer.MAX_VALUE);
    IntVector room = length.neg().add(Float.floatToRawIntBits(max));
    return room.reduceLanes(OR) >= 0;
  }

  private static FloatVector all(float value) {
    return FloatVector.broadcast(LANE, value);
  }

  @Override
  void turn(float[] cos, float[] sin, int at, int error, int[] to) {
    ratio(cos, sin, at, to);
    fold(cos, sin, at, to);
    step(at, error, to);
  }

  /** Computes the angle to the nearer axis, 0 to an eighth of a turn, or 0 for NaN. */
  private static void ratio(float[] cos, float[] sin, int at, int[] to) {
    IntVector x = FloatVector.fromArray(LANE, cos, at).reinterpretAsInts().and(Integer.MAX_VALUE);
    IntVector y = FloatVector.fromArray(LANE, sin, at).reinterpretAsInts().and(Integer.MAX_VALUE);
    IntVector more = x.sub(y);
    IntVector shift = more.lanewise(ASHR, 31).and(more);
    FloatVector longer = x.sub(shift).reinterpretAsFloats();
    FloatVector t = y.add(shift).reinterpretAsFloats().lanewise(DIV, longer);
    FloatVector q = t.lanewise(MUL, t);
    FloatVector p = q.lanewise(MUL, all(0.0208351f)).lanewise(SUB, all(0.0851330f));
    p = p.lanewise(MUL, q).lanewise(ADD, all(0.1801410f));
    p = p.lanewise(MUL, q).lanewise(SUB, all(0.3302995f));
    p = p.lanewise(MUL, q).lanewise(ADD, all(0.9998660f));
    FloatVector halves =
        t.lanewise(MUL, p).lanewise(MUL, all(HALF_TURNS_PER_RADIAN)).lanewise(ADD, all(POSITIVE));
    // NaN has either sign, which abs() may leave as it is.
    IntVector turn = halves.reinterpretAsInts().and(Integer.MAX_VALUE).sub(POSITIVE_BITS);
    IntVector number = turn.sub(TURN / 8).lanewise(ASHR, 31);
    turn.add(turn).and(number).intoArray(to, at);
  }

  /** Turns the angle to the nearer axis into the angle of the direction. */
  private static void fold(float[] cos, float[] sin, int at, int[] to) {
    IntVector x = FloatVector.fromArray(LANE, cos, at).reinterpretAsInts();
    IntVector y = FloatVector.fromArray(LANE, sin, at).reinterpretAsInts();
    IntVector more = x.and(Integer.MAX_VALUE).sub(y.and(Integer.MAX_VALUE));
    IntVector steep = more.lanewise(ASHR, 31);
    IntVector left = x.lanewise(ASHR, 31);
    IntVector below = y.lanewise(ASHR, 31);
    IntVector turn = IntVector.fromArray(IntVector.SPECIES_PREFERRED, to, at);
    turn = turn.lanewise(XOR, steep).sub(steep).add(steep.and(TURN / 4));
    turn = turn.lanewise(XOR, left).sub(left).add(left.and(TURN / 2));
    turn.lanewise(XOR, below).sub(below).intoArray(to, at);
  }

  /** Rounds angles to steps, or to -1 where the error may decide the rounding. */
  private static void step(int at, int error, int[] to) {
    IntVector moved = IntVector.fromArray(IntVector.SPECIES_PREFERRED, to, at).add(STEP / 2);
    IntVector rest = moved.and(STEP - 1);
    IntVector early = rest.sub(error + 1);
    IntVector late = rest.neg().add(STEP - error - 1);
    IntVector uncertain = early.or(late).lanewise(ASHR, 31);
    moved.lanewise(ASHR, STEP_SHIFT).and(Quantizer.ANGLE_STEPS - 1).or(uncertain).intoArray(to, at);
  }
}
