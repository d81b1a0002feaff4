package carom.options;

import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.MalformedURLException;
import java.net.URISyntaxException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

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
      Class<?> found = Class.forName(className, true, loader());
      return type.cast(found.getConstructor().newInstance());
    } catch (ClassNotFoundException e) {
      throw new IllegalStateException(
          "folder="
              + home().resolve(FOLDER)
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
    StringBuilder path = new StringBuilder(System.getProperty("java.class.path"));
    jars().forEach(jar -> path.append(File.pathSeparator).append(jar));
    return path.toString();
  }

  private static ClassLoader loader() {
    List<URL> urls = new ArrayList<>();
    try {
      for (Path jar : jars()) {
        urls.add(jar.toUri().toURL());
      }
    } catch (MalformedURLException e) {
      throw new IllegalStateException(e); // can't happen for a file
    }
    ClassLoader ours = Lab.class.getClassLoader();
    return urls.isEmpty() ? ours : new URLClassLoader(urls.toArray(new URL[0]), ours);
  }

  /**
   * Returns the jars of the laboratory and of all programs, because the laboratory runs server and
   * clients together.
   */
  private static List<Path> jars() {
    Path folder = home().resolve(FOLDER);
    if (!Files.isDirectory(folder)) {
      return List.of();
    }
    List<Path> jars = new ArrayList<>(jarsOf(folder));
    jars.addAll(jarsOf(home()));
    return jars;
  }

  private static List<Path> jarsOf(Path folder) {
    try (Stream<Path> files = Files.list(folder)) {
      return files.filter(file -> file.toString().endsWith(".jar")).sorted().toList();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Returns the folder {@code lib} of an installation. */
  private static Path home() {
    try {
      URL ours = Lab.class.getProtectionDomain().getCodeSource().getLocation();
      return Path.of(ours.toURI()).toAbsolutePath().getParent();
    } catch (URISyntaxException e) {
      throw new IllegalStateException(e); // can't happen, the JVM made the location
    }
  }
}
