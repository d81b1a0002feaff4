package carom.game;

import carom.sim.Game;
import carom.sim.level.Level;
import carom.text.FileErrors;
import java.io.IOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.jar.JarFile;
import java.util.zip.ZipException;

/**
 * The jars of a folder of games, {@code --games FOLDER}, which a program has beside those on its
 * class path. There is one such folder in a process, or none. Any thread.
 *
 * <p>The jars are copied first, so that a build may write them anew while games of the old ones are
 * played. {@link #refresh} takes new ones: games that are made afterwards are of new classes, and
 * those that run go on with theirs.
 */
public final class GameJars {
  /** Folder of a jar in which games' looks are as data, by the games' names. */
  public static final String LOOKS = "carom/looks/";

  /** Largest file of a look, bytes. */
  public static final int MAX_LOOK_BYTES = 24 << 20;

  private static final String SERVICE = "META-INF/services/" + Game.class.getName();

  private static volatile ClassLoader loader = GameJars.class.getClassLoader();
  private static Path folder;
  private static String taken = "";

  private GameJars() {}

  /**
   * Lets the process have the games of a folder.
   *
   * @throws IOException if it is no folder, or a jar can't be read
   */
  public static synchronized void open(Path newFolder) throws IOException {
    if (!Files.isDirectory(newFolder)) {
      throw new IOException(newFolder.toAbsolutePath().normalize() + " is no folder");
    }
    folder = newFolder;
    take(state());
  }

  /** Returns the folder, or null if none was opened. */
  public static synchronized Path folder() {
    return folder;
  }

  /** Returns what loads the games, and levels that come with them. */
  public static ClassLoader loader() {
    return loader;
  }

  /**
   * Takes the folder's jars anew if they have changed.
   *
   * @return whether they have
   * @throws IOException if one can't be read; the games stay as they are
   */
  public static synchronized boolean refresh() throws IOException {
    String now = state();
    if (now.equals(taken)) {
      return false;
    }
    take(now);
    return true;
  }

  /** Returns names, sizes and times of the jars in the folder; empty if there is none. */
  public static synchronized String state() throws IOException {
    if (folder == null) {
      return "";
    }
    StringBuilder state = new StringBuilder();
    for (Path jar : jars()) {
      state.append(jar).append(' ').append(Files.size(jar)).append(' ');
      state.append(Files.getLastModifiedTime(jar)).append('\n');
    }
    return state.toString();
  }

  /**
   * Returns why the folder may lack a game: it has no jar, or jars that list none. Each reason
   * begins with a semicolon; empty if each jar lists a game or there is no folder.
   */
  static synchronized String complaint() {
    if (folder == null) {
      return "";
    }
    StringBuilder reasons = new StringBuilder();
    try {
      List<Path> jars = jars();
      if (jars.isEmpty()) {
        reasons.append("; there is no jar in ").append(folder.toAbsolutePath().normalize());
      }
      for (Path jar : jars) {
        try (JarFile file = new JarFile(jar.toFile())) {
          if (file.getEntry(SERVICE) == null) {
            reasons.append("; ").append(jar.getFileName()).append(" has no file ").append(SERVICE);
            reasons.append(" that names the game's class");
          }
        }
      }
    } catch (IOException e) {
      reasons.append("; games=").append(folder).append(" can't be read: ");
      reasons.append(FileErrors.reason(e));
    }
    return reasons.toString();
  }

  private static List<Path> jars() throws IOException {
    List<Path> jars = new ArrayList<>();
    try (DirectoryStream<Path> files = Files.newDirectoryStream(folder, "*.jar")) {
      files.forEach(jars::add);
    }
    Collections.sort(jars);
    return jars;
  }

  /** Throws, by the file's name, for a jar of which no class loader would find anything. */
  private static void requireReadable(Path jar) throws IOException {
    try {
      new JarFile(jar.toFile()).close();
    } catch (ZipException e) {
      throw new IOException(
          jar.getFileName() + " is no jar that can be read; build it again or take it away", e);
    }
  }

  private static void take(String state) throws IOException {
    Path copies = Files.createTempDirectory("carom-games");
    copies.toFile().deleteOnExit();
    List<URL> urls = new ArrayList<>();
    for (Path jar : jars()) {
      Path copy = copies.resolve(jar.getFileName());
      Files.copy(jar, copy, StandardCopyOption.REPLACE_EXISTING);
      copy.toFile().deleteOnExit();
      requireReadable(copy);
      urls.add(copy.toUri().toURL());
    }
    // Not closed: games of it may run until the program ends.
    loader = new URLClassLoader(urls.toArray(new URL[0]), GameJars.class.getClassLoader());
    Level.builtInsOf(loader);
    taken = state;
  }
}
