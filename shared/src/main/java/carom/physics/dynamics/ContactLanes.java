package carom.physics.dynamics;

/**
 * Kernels that solve the {@value ContactSolver#LANES} contacts of a block side by side, bit for bit
 * as {@link ContactSolver} does one after the other.
 */
abstract class ContactLanes {
  private static final int WARM_UP_STEPS = 300;

  /** Steps that used kernels, in all worlds of the JVM; needn't be exact. */
  private static int steps;

  /**
   * Asked once per step. Until the JIT compiler has seen the kernels often enough it interprets
   * them, hundreds of times slower.
   *
   * @return whether all blocks may be given to the kernels, or just a few
   */
  boolean ready() {
    if (steps < WARM_UP_STEPS) {
      steps++;
      return false;
    }
    return true;
  }

  /** How long the scratch array of each worker must be. */
  abstract int scratchSize();

  abstract void warmStart(ContactSolver solver, float[] v, float[] scratch, int block);

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
