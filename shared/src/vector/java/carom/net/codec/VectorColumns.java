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
 * The numbers of a column by vectors, with the Vector API. Small methods that pass each other
 * arrays, never vectors: these would be boxed. Floats become integers by adding a number so large
 * that no fraction is left, as this API converts slowly on some JVMs.
 *
 * <p>Vectors as long as the engine's, as a process should use one length only: methods of vectors
 * that call others by themselves, like {@code FloatVector.mul}, remember for all callers which
 * lengths they saw. Large kernels ask them, so kernels of four lanes here had those of the engine
 * box vectors. For the same reason these have neither such calls on floats nor masks; {@code
 * lanewise} on a vector that was just loaded leaves no doubt.
 */
public final class VectorColumns extends ColumnLanes {
  private static final VectorSpecies<Float> LANE = FloatVector.SPECIES_PREFERRED;
  private static final int WIDTH = LANE.length();

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

  private final int[] warmUpSteps = new int[WIDTH];

  /** Loaded by name, see {@link ColumnLanes#FOUND}. */
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
    // Nearest, halves to even; a half is left where that was down, and here it must be up.
    FloatVector rest = steps.lanewise(SUB, moved.lanewise(SUB, large));
    FloatVector below = rest.lanewise(SUB, all(0.5f));
    IntVector down = below.reinterpretAsInts().lanewise(ASHR, 31);
    moved.reinterpretAsInts().sub(LARGE_BITS - 1).add(down).intoArray(to, at);
    // Lengths of floats sort like their bits; what isn't a number comes behind all.
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

  /** The angle to the nearer axis, 0 to an eighth of a turn; 0 if it isn't a number. */
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
    // What isn't a number has either sign, and abs() may leave it.
    IntVector turn = halves.reinterpretAsInts().and(Integer.MAX_VALUE).sub(POSITIVE_BITS);
    IntVector number = turn.sub(TURN / 8).lanewise(ASHR, 31);
    turn.add(turn).and(number).intoArray(to, at);
  }

  /** From that angle to the one of the whole turn. */
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

  /** Rounds to steps; -1 where the error may decide. */
  private static void step(int at, int error, int[] to) {
    IntVector moved = IntVector.fromArray(IntVector.SPECIES_PREFERRED, to, at).add(STEP / 2);
    IntVector rest = moved.and(STEP - 1);
    IntVector early = rest.sub(error + 1);
    IntVector late = rest.neg().add(STEP - error - 1);
    IntVector unsure = early.or(late).lanewise(ASHR, 31);
    moved.lanewise(ASHR, STEP_SHIFT).and(Quantizer.ANGLE_STEPS - 1).or(unsure).intoArray(to, at);
  }
}
