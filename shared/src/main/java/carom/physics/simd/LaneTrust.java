package carom.physics.simd;

/**
 * How much vector kernels are used: little at first. Until the JIT compiler has seen them often it
 * interprets them, hundreds of times slower, and what runs them boxes their vectors. Which blocks
 * are solved how never shows in the result, so one object serves all worlds of the JVM, and needn't
 * be exact.
 */
public final class LaneTrust {
  /** Blocks that must have been through the kernels before all may. */
  private static final int WARM_UP = 2_600;

  /** Blocks per step until then; of large worlds a share, as their steps take longer anyway. */
  private static final int FEW = 6;

  private static final int SHARE = 32;

  /** Rehearsals that must have been before all blocks may go through the kernels: */
  private static final int REHEARSALS = 40_000;

  /**
   * and that are made in all. They go on, and are quick once kernels are compiled: a kernel that is
   * no longer called often while it waits for the compiler loses its place there, and boxes vectors
   * until it has been called often again.
   */
  private static final int ALL_REHEARSALS = 200_000;

  /** the first ones, in which little of the API is compiled, take ten times as long; */
  private static final int FIRST_REHEARSALS = 1_000;

  /** in a step, of these and of the later ones; */
  private static final int FEW_FIRST = 8;

  private static final int FEW_LATER = 64;

  /** of the later ones, one for so many rows. */
  private static final int ROWS = 64;

  private int seen;
  private int rehearsed;

  /**
   * How many times the kernels are to be rehearsed in a step, which they then are.
   *
   * @param rows a measure of how long the world's steps are: its contacts or joints
   */
  int rehearsals(int rows) {
    if (rehearsed >= ALL_REHEARSALS) {
      return 0;
    }
    int times = Math.max(FEW_LATER, rows / ROWS);
    if (rehearsed < FIRST_REHEARSALS) {
      times = times * FEW_FIRST / FEW_LATER;
    }
    rehearsed += times;
    return times;
  }

  /** How many of a step's blocks may be given to the kernels. */
  int allowed(int blocks) {
    boolean all = seen >= WARM_UP && rehearsed >= REHEARSALS;
    return all ? blocks : Math.max(FEW, blocks / SHARE);
  }

  /** Must be called when blocks were given to the kernels. */
  void used(int blocks) {
    seen = Math.min(seen, WARM_UP) + blocks;
  }
}
