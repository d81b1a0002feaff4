package carom.physics.simd;

import java.util.Arrays;

/**
 * Vector kernels that are <i>rehearsed</i> on numbers of no world, all of them equally often in
 * every step that could use them, whatever there is in the world. So the JIT compiler is soon done
 * with them, and those that a world hardly needs don't box their vectors for minutes. Their callers
 * are compiled by the few blocks that go through them meanwhile; see {@link LaneTrust}.
 */
public abstract class RehearsedLanes {
  /**
   * Floats at both ends of a scratch array that nobody uses: two cache lines, as they come in
   * pairs. Without them each worker wrote to the line from which another one reads the length of
   * its own array, or the array of all of them, block by block.
   */
  public static final int APART = 32;

  private final LaneTrust trust;

  /** What is rehearsed on. */
  private float[] numbers = new float[0];

  /**
   * Makes those of a world.
   *
   * @param trust that of all worlds
   */
  public RehearsedLanes(LaneTrust trust) {
    this.trust = trust;
  }

  /** How long the scratch array of each worker must be, {@link #APART} at both ends included. */
  public abstract int scratchSize();

  /** How many numbers a rehearsal takes. */
  public abstract int rehearsalSize();

  /** Runs each kernel once on these numbers. */
  public abstract void rehearse(float[] numbers);

  /**
   * How many of a step's blocks may be given to the kernels; {@link #used} must be told. To be
   * asked once per step.
   *
   * @param rows contacts or joints of the world, which tell how long its steps are
   */
  public final int trusted(int blocks, int rows) {
    int times = trust.rehearsals(rows);
    if (times > 0 && numbers.length == 0) {
      numbers = new float[rehearsalSize()];
    }
    for (int i = 0; i < times; i++) {
      Arrays.fill(numbers, 1);
      rehearse(numbers);
    }
    return trust.allowed(blocks);
  }

  /** Must be called when so many blocks were given to the kernels. */
  public final void used(int blocks) {
    trust.used(blocks);
  }
}
