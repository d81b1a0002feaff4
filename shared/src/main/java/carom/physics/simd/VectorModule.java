package carom.physics.simd;

/**
 * Loads what is made with the Vector API, an incubating module that the JVM only has if it was
 * started with {@code --add-modules jdk.incubator.vector}.
 */
public final class VectorModule {
  /**
   * Constraints that are solved side by side: 16 where vectors are that long, else 8, also without
   * vectors. All kernels use vectors of this one length: code that sees several makes the JIT
   * compiler box vectors, which costs ten times what they gain. It changes no bit of a result.
   */
  public static final int LANES = lanes();

  /** How many floats this processor's vectors have; made with the Vector API. */
  interface Width {
    int floats();
  }

  private VectorModule() {}

  private static int lanes() {
    Width width = find("carom.physics.simd.VectorWidth", Width.class);
    return width != null && width.floats() >= 16 ? 16 : 8;
  }

  /**
   * Makes an object of a class that is loaded by name.
   *
   * @param name full name
   * @return null if the JVM has no such module, or if its vectors are too short to be worth it
   */
  public static <T> T find(String name, Class<T> type) {
    try {
      return Class.forName(name).asSubclass(type).getDeclaredConstructor().newInstance();
    } catch (ReflectiveOperationException | LinkageError e) {
      return null;
    }
  }
}
