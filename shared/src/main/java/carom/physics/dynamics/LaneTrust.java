package carom.physics.dynamics;

/**
 * How many blocks of a step may be given to vector kernels: few at first, as the JIT compiler
 * interprets these until it has seen them often, hundreds of times slower. Which blocks are solved
 * how never shows in the result, so one object serves all worlds of the JVM, and needn't be exact.
 */
final class LaneTrust {
  /** Blocks that must have been through the kernels before all may. */
  private static final int WARM_UP = 2600;

  /** Blocks per step until then; of large worlds a share, as their steps take longer anyway. */
  private static final int FEW = 6;

  private static final int SHARE = 32;

  private int seen;

  /** How many of a step's blocks may be given to the kernels; asked once per step. */
  int blocks(int blocks) {
    if (seen >= WARM_UP) {
      return blocks;
    }
    int few = Math.max(FEW, blocks / SHARE);
    seen += few;
    return few;
  }
}
