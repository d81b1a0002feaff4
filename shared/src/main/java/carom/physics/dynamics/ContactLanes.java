package carom.physics.dynamics;

/**
 * Kernels that solve the {@value ContactSolver#LANES} contacts of a block side by side, bit for bit
 * as {@link ContactSolver} does one after the other.
 */
abstract class ContactLanes {
  /**
   * Blocks that must have been through the kernels before all may: the JIT compiler interprets them
   * until it has seen them that often, hundreds of times slower.
   */
  private static final int WARM_UP = 1800;

  /** Blocks per step until then; of large worlds a share, as their steps take longer anyway. */
  private static final int FEW = 4;

  private static final int SHARE = 64;

  /** Blocks so far, in all worlds of the JVM; needn't be exact. */
  private static int seen;

  /**
   * How many of a step's blocks may be given to the kernels; asked once per step. Which blocks are
   * solved how never shows in the result.
   */
  int trusted(int blocks) {
    if (seen >= WARM_UP) {
      return blocks;
    }
    int few = Math.max(FEW, blocks / SHARE);
    seen += few;
    return few;
  }

  /** How long the scratch array of each worker must be. */
  abstract int scratchSize();

  abstract void push(ContactSolver solver, float[] v, float[] scratch, int block);

  abstract void relax(ContactSolver solver, float[] v, float[] scratch, int block);

  /**
   * The kernels made with the Vector API, an incubating module that the JVM only has if it was
   * started with {@code --add-modules jdk.incubator.vector}.
   *
   * @return null if it wasn't, or if its vectors are too short to be worth it
   */
  static ContactLanes find() {
    try {
      return Class.forName("carom.physics.dynamics.VectorLanes")
          .asSubclass(ContactLanes.class)
          .getDeclaredConstructor()
          .newInstance();
    } catch (ReflectiveOperationException | LinkageError e) {
      return null;
    }
  }
}
