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
 * The installation that this program comes from. Its folder {@code lib} has the jars of all
 * programs, of which each has its own on the class path. Any thread may use this class.
 */
public final class Installation {
  private Installation() {}

  /** Returns the folder {@code lib} of an installation. */
  static Path lib() {
    try {
      URL ours = Installation.class.getProtectionDomain().getCodeSource().getLocation();
      return Path.of(ours.toURI()).toAbsolutePath().getParent();
    } catch (URISyntaxException e) {
      throw new IllegalStateException(e); // can't happen, the JVM made the location
    }
  }

  static List<Path> jarsOf(Path folder) {
    try (Stream<Path> files = Files.list(folder)) {
      return files.filter(file -> file.toString().endsWith(".jar")).sorted().toList();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Returns a loader of this program's classes and of those in jars. */
  static ClassLoader loader(List<Path> jars) {
    List<URL> urls = new ArrayList<>();
    try {
      for (Path jar : jars) {
        urls.add(jar.toUri().toURL());
      }
    } catch (MalformedURLException e) {
      throw new IllegalStateException(e); // can't happen for a file
    }
    ClassLoader ours = Installation.class.getClassLoader();
    return urls.isEmpty() ? ours : new URLClassLoader(urls.toArray(new URL[0]), ours);
  }

  /** Returns this process's class path with jars behind it. */
  static String classPath(List<Path> jars) {
    StringBuilder path = new StringBuilder(System.getProperty("java.class.path"));
    jars.forEach(jar -> path.append(File.pathSeparator).append(jar));
    return path.toString();
  }

  /** Returns the class path for processes that run another program of the installation. */
  public static String classPath() {
    return classPath(jarsOf(lib()));
  }

  /**
   * Returns whether the installation has a program.
   *
   * @param mainClass full name of its main class
   */
  public static boolean has(String mainClass) {
    try {
      loader(jarsOf(lib())).loadClass(mainClass);
      return true;
    } catch (ClassNotFoundException e) {
      return false;
    }
  }
}
