package carom.physics.simd;

import java.util.function.BooleanSupplier;

/**
 * A set of kernels that do by vectors what scalar code does one by one, with the same bits. One
 * object per set serves all worlds and threads of the JVM; it is found by {@link VectorModule}.
 *
 * <p>A caller asks {@link #grant} once per step or column, before its loop, and gives the kernels
 * no more blocks than it was granted. That is all it has to know of {@link KernelWarmup}.
 */
public abstract class VectorKernels {
  /**
   * Unused floats at both ends of a worker's scratch array: two cache lines, because processors
   * fetch lines in pairs. Without them a worker would write to the line from which another worker
   * reads the length of its own array.
   */
  public static final int APART = 32;

  private final KernelWarmup warmup = new KernelWarmup();

  /** Makes a set whose kernels still have to be warmed up. */
  protected VectorKernels() {}

  /**
   * Returns how many numbers {@link #warmUp} works on.
   *
   * @return the length of its array
   */
  protected abstract int warmUpSize();

  /**
   * Calls each kernel of the set once, on numbers of no world.
   *
   * @param numbers all 1; may be overwritten
   */
  protected abstract void warmUp(float[] numbers);

  /**
   * Grants the kernels some of the blocks at hand: all of them once the JIT compiler has compiled
   * the kernels, few until then. Warms the kernels up meanwhile. Allocates only the first time.
   *
   * @param blocks how many the caller has
   * @param rows contacts, joints or numbers of which the blocks are; tells how long the step is
   * @return how many of the blocks may go through the kernels, 0..blocks
   */
  public final int grant(int blocks, int rows) {
    return warmup.grant(this, blocks, rows);
  }

  /** Grants work to rehearsals alone until {@link #trust}, and tells when others want some. */
  final void waitForTrust(BooleanSupplier isRehearsal, Runnable whenWanted) {
    warmup.waitForTrust(isRehearsal, whenWanted);
  }

  /**
   * Returns whether the kernels have been called often enough to be granted all of the work of a
   * world that warms them up.
   *
   * @return whether the JIT compiler should know them by now
   */
  public final boolean isTrusted() {
    return warmup.isTrusted();
  }

  /** Ends the warm-up: grants the kernels all of the work of all worlds from now on. */
  public final void trust() {
    warmup.trust();
  }
}
