package carom.options;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * Access to the laboratory: the code that measures Carom and is no part of any server or client. An
 * installation has its jars in the folder {@code lab} next to the products' jars, and no program
 * has them on its class path. The commands that need the laboratory load it by name. In the build,
 * it is on the class path of the tasks that use it. Any thread may use this class.
 */
public final class Lab {
  private static final String FOLDER = "lab";

  private Lab() {}

  /**
   * Creates an object of a laboratory class.
   *
   * @param type type that the object is used as
   * @param className full name of a class that has a public constructor without parameters
   * @throws IllegalStateException if this installation has no laboratory; the message says where it
   *     was looked for
   */
  public static <T> T create(Class<T> type, String className) {
    try {
      Class<?> found = Class.forName(className, true, Installation.loader(jars()));
      return type.cast(found.getConstructor().newInstance());
    } catch (ClassNotFoundException e) {
      throw new IllegalStateException(
          "folder="
              + Installation.lib().resolve(FOLDER)
              + " has no "
              + className
              + "; the laboratory comes with ./gradlew installDist",
          e);
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException(className + " can't be created", e);
    }
  }

  /**
   * Returns the class path for processes that run laboratory code: this process's own, and the
   * laboratory's jars.
   */
  public static String classPath() {
    return Installation.classPath(jars());
  }

  /**
   * Returns the jars of the laboratory and of all programs, because the laboratory runs server and
   * clients together.
   */
  private static List<Path> jars() {
    Path folder = Installation.lib().resolve(FOLDER);
    if (!Files.isDirectory(folder)) {
      return List.of();
    }
    List<Path> jars = new ArrayList<>(Installation.jarsOf(folder));
    jars.addAll(Installation.jarsOf(Installation.lib()));
    return jars;
  }
}
