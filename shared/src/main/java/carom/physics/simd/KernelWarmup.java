package carom.physics.simd;

import java.util.Arrays;
import java.util.function.BooleanSupplier;

/**
 * Warms up one set of vector kernels: calls them on made-up numbers until the JIT compiler is done
 * with them, and grants them only a little of the real work until then.
 *
 * <p>A kernel that isn't compiled is interpreted, hundreds of times slower, and allocates an object
 * for every vector. How often a world would call a kernel depends on what happens in that world, so
 * its calls alone may warm a kernel up in a second or never. Warm-up calls reach all kernels of a
 * set equally often, independent of the world's contents. The real work that is granted meanwhile
 * warms up the callers of the kernels.
 *
 * <pre>
 *   warm-up calls   0       1,000                      40,000                   200,000
 *                   |         |                           |                        |
 *   per grant       |    8    |            64, or one per 64 rows                  |  none
 *   granted blocks  |       6, or a 32nd of them          |          all of them
 * </pre>
 *
 * <p>Calls go on after the kernels are trusted, because a kernel that is no longer called often
 * while it waits for the compiler loses its place in the queue. By then they are quick. {@code
 * docs/lab/kernels.md} has the measurements.
 *
 * <p>A program may {@linkplain VectorModule#leaveWarmUpTo warm kernels up on a thread of its own}.
 * Then only the worlds that this thread steps are granted work, as above, until the program trusts
 * the kernels. It is told when a step of another world is large enough for kernels to be worth it.
 *
 * <p>How much the kernels do shows in no result. One object serves all worlds and threads of the
 * JVM. It allocates its numbers once.
 */
final class KernelWarmup {
  /** Warm-up calls after which the kernels are granted all of the work. */
  private static final int TRUSTED_AFTER = 40_000;

  /** Warm-up calls that are made in all. */
  private static final int ALL_CALLS = 200_000;

  /**
   * Number of warm-up calls during which little of the Vector API is compiled. Each takes about ten
   * times as long as a later one.
   */
  private static final int FIRST_CALLS = 1_000;

  /** Warm-up calls per grant among the first ones. */
  private static final int CALLS_AT_FIRST = 8;

  /** Warm-up calls per grant later on, at least. */
  private static final int CALLS_LATER = 64;

  /** Rows of work that add one warm-up call to a grant: large steps take longer anyway. */
  private static final int ROWS_PER_CALL = 64;

  /** Blocks that are granted before the kernels are trusted, at least. */
  private static final int FEW_BLOCKS = 6;

  /** One block in so many is granted before the kernels are trusted. */
  private static final int BLOCK_SHARE = 32;

  /**
   * Rows of a step from which on kernels are worth their warm-up, which takes seconds of a
   * processor and several GB of garbage. Chosen, not measured: rooms of a few dozen bodies have
   * less.
   */
  private static final int WORTH_ROWS = 128;

  /** Warm-up calls so far. */
  private volatile int calls;

  /**
   * Returns whether the calling thread is the one that warms the kernels up, while a program does
   * so on a thread of its own; else null.
   */
  private volatile BooleanSupplier rehearsal;

  /** Tells that program that a world wants kernels; set before {@link #rehearsal}. */
  private Runnable wanted;

  /** Scratch numbers on which the kernels are called; null until the first grant. */
  private float[] numbers;

  /** Grants kernels some of the work; see {@link VectorKernels#grant}. */
  int grant(VectorKernels kernels, int blocks, int rows) {
    BooleanSupplier isRehearsal = rehearsal;
    if (isRehearsal != null && !isRehearsal.getAsBoolean()) {
      if (rows >= WORTH_ROWS) {
        wanted.run();
      }
      return 0;
    }
    if (calls < ALL_CALLS) {
      warmUp(kernels, rows);
    }
    return isTrusted() ? blocks : Math.min(blocks, Math.max(FEW_BLOCKS, blocks / BLOCK_SHARE));
  }

  /** Makes the warm-up calls of one grant. Threads of several worlds may ask at once. */
  private synchronized void warmUp(VectorKernels kernels, int rows) {
    if (numbers == null) {
      numbers = new float[kernels.warmUpSize()];
    }
    int times = Math.max(CALLS_LATER, rows / ROWS_PER_CALL);
    if (calls < FIRST_CALLS) {
      times = times * CALLS_AT_FIRST / CALLS_LATER;
    }
    for (int i = 0; i < times; i++) {
      Arrays.fill(numbers, 1);
      kernels.warmUp(numbers);
    }
    calls += times;
  }

  /** Returns whether the kernels are granted all of the work. */
  boolean isTrusted() {
    return calls >= TRUSTED_AFTER;
  }

  /**
   * Grants work to rehearsals alone until {@link #trust}, unless the warm-up is over.
   *
   * @param whenWanted runs whenever a step is refused kernels that are worth it, or now if nothing
   *     is left to warm up
   */
  void waitForTrust(BooleanSupplier isRehearsal, Runnable whenWanted) {
    wanted = whenWanted;
    if (calls < ALL_CALLS) {
      rehearsal = isRehearsal;
    } else {
      rehearsal = null;
      whenWanted.run();
    }
  }

  /** Ends the warm-up. */
  synchronized void trust() {
    calls = ALL_CALLS;
    rehearsal = null;
  }
}
