package carom.physics.simd;

/**
 * Finds the classes that use the Vector API. That module incubates: a JVM has it only if it was
 * started with {@code --add-modules jdk.incubator.vector}.
 */
public final class VectorModule {
  /**
   * Number of constraints that are solved side by side: 16 if the processor's vectors hold that
   * many floats, else 8, also without vectors. All kernels use vectors of this one length, because
   * a JIT compiler that has seen several lengths boxes vectors, which costs ten times what they
   * gain. The number changes no bit of a result.
   */
  public static final int LANES = lanes();

  /** The length of this processor's vectors. Its implementation needs the Vector API. */
  interface Width {
    /** Returns how many floats a vector holds. */
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
   * @param name the full name of a public class with a public constructor without parameters
   * @param type what the object is used as
   * @return null if the JVM lacks the module, or if its vectors are too short to be worth it
   */
  public static <T> T find(String name, Class<T> type) {
    try {
      return Class.forName(name).asSubclass(type).getDeclaredConstructor().newInstance();
    } catch (ReflectiveOperationException | LinkageError e) {
      return null;
    }
  }
}
