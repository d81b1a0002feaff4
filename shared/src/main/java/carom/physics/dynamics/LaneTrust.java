package carom.physics.dynamics;

/**
 * How many blocks of a step may be given to vector kernels: few at first, as the JIT compiler
 * interprets these until it has seen them often, hundreds of times slower. Which blocks are solved
 * how never shows in the result, so one object serves all worlds of the JVM, and needn't be exact.
 */
final class LaneTrust {
  /** Blocks per step until then; of large worlds a share, as their steps take longer anyway. */
  private static final int FEW = 6;

  private final int warmUp;
  private final int share;
  private int seen;

  /**
   * Trusts nobody yet.
   *
   * @param warmUp blocks that must have been through the kernels before all may
   * @param share of how many blocks one may be, until then
   */
  LaneTrust(int warmUp, int share) {
    this.warmUp = warmUp;
    this.share = share;
  }

  /** How many of a step's blocks may be given to the kernels, which they then are. */
  int blocks(int blocks) {
    int allowed = allowed(blocks);
    used(allowed);
    return allowed;
  }

  /** How many of a step's blocks may be given to the kernels. */
  int allowed(int blocks) {
    return seen >= warmUp ? blocks : Math.max(FEW, blocks / share);
  }

  /** Must be called when blocks were given to the kernels. */
  void used(int blocks) {
    seen = Math.min(seen, warmUp) + blocks;
  }
}
