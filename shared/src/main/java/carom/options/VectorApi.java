package carom.options;

/**
 * Loads the JDK's Vector API, with which the engine and the codec are faster and compute the same
 * bits. The module incubates, and a JVM that is started with {@code --add-modules
 * jdk.incubator.vector} begins its output with a warning that a user can do nothing about. So the
 * programs load it themselves.
 *
 * <p>This needs {@code --add-exports java.base/jdk.internal.module=ALL-UNNAMED}, which the start
 * scripts pass. Without the flag, or without the module, the program runs on scalar kernels.
 */
public final class VectorApi {
  private static final String MODULE = "jdk.incubator.vector";

  private VectorApi() {}

  /**
   * Loads the module if the JVM doesn't have it yet. Call it before any class of the engine.
   *
   * @return whether the Vector API is there
   */
  public static boolean load() {
    if (ModuleLayer.boot().findModule(MODULE).isPresent()) {
      return true;
    }
    try {
      Class.forName("jdk.internal.module.Modules")
          .getMethod("loadModule", String.class)
          .invoke(null, MODULE);
      return true;
    } catch (ReflectiveOperationException | LinkageError e) {
      return false;
    }
  }
}
