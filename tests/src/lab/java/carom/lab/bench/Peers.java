package carom.lab.bench;

import carom.options.Lab;
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
import java.util.ServiceLoader;
import java.util.stream.Stream;

/**
 * Finds the other engines: those on the class path, as in {@code ./gradlew bench}, and those whose
 * jars are in the folder {@code peers} next to the jar of this class, as in an installation. Only
 * measuring processes have them on their class path.
 */
final class Peers {
  private static final String FOLDER = "peers";

  private Peers() {}

  /** Returns the names of the other engines, sorted. */
  static List<String> names() {
    List<String> names = new ArrayList<>();
    List<URL> urls = new ArrayList<>();
    try {
      for (Path jar : jars()) {
        urls.add(jar.toUri().toURL());
      }
    } catch (MalformedURLException e) {
      throw new IllegalStateException(e); // of a file
    }
    ClassLoader mine = Peers.class.getClassLoader();
    try (URLClassLoader loader = new URLClassLoader(urls.toArray(new URL[0]), mine)) {
      ServiceLoader.load(BenchEngine.class, loader).forEach(peer -> names.add(peer.name()));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    names.sort(null);
    return names;
  }

  /** Returns the class path of a measuring process. */
  static String classPath() {
    StringBuilder path = new StringBuilder(Lab.classPath());
    jars().forEach(jar -> path.append(File.pathSeparator).append(jar));
    return path.toString();
  }

  /**
   * Returns the engine of a name. For measuring processes only.
   *
   * @throws IllegalArgumentException if it isn't on the class path
   */
  static BenchEngine engine(String name) {
    for (BenchEngine peer : ServiceLoader.load(BenchEngine.class)) {
      if (peer.name().equals(name)) {
        return peer;
      }
    }
    throw new IllegalArgumentException("unknown engine=" + name);
  }

  private static List<Path> jars() {
    try {
      URL mine = Peers.class.getProtectionDomain().getCodeSource().getLocation();
      Path folder = Path.of(mine.toURI()).resolveSibling(FOLDER);
      if (!Files.isDirectory(folder)) {
        return List.of();
      }
      try (Stream<Path> files = Files.list(folder)) {
        return files.filter(file -> file.toString().endsWith(".jar")).sorted().toList();
      }
    } catch (URISyntaxException e) {
      throw new IllegalStateException(e); // the JVM made it
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
