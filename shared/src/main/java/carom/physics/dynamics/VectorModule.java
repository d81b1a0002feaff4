package carom.physics.dynamics;

/**
 * Loads what is made with the Vector API, an incubating module that the JVM only has if it was
 * started with {@code --add-modules jdk.incubator.vector}.
 */
final class VectorModule {
  private VectorModule() {}

  /**
   * Makes an object of a class of this package.
   *
   * @return null if the JVM has no such module, or if its vectors are too short to be worth it
   */
  static <T> T find(String name, Class<T> type) {
    try {
      return Class.forName(VectorModule.class.getPackageName() + "." + name)
          .asSubclass(type)
          .getDeclaredConstructor()
          .newInstance();
    } catch (ReflectiveOperationException | LinkageError e) {
      return null;
    }
  }
}
