package carom.server.config;

import carom.net.kryo.server.ServerIdentity;
import carom.net.seal.Encryption;
import carom.net.seal.ServerKey;
import carom.text.FileErrors;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * The folder in which a server keeps its files. It creates what it writes to, when it writes.
 *
 * @param root the folder
 */
public record DataFolder(Path root) {
  /** Name of the file of settings. */
  public static final String CONFIG = "carom.conf";

  private static final String LEVEL = ".json";
  private static final String SAVED = ".carom-save";
  private static final Pattern SAVE_NAME = Pattern.compile("[-\\w]{1,64}");
  private static final String RECORDING = ".carom";

  /** Returns the folder of the log, which is rotated. */
  public Path logs() {
    return root.resolve("logs");
  }

  /**
   * Returns the identity by which players know the server, which {@code server.key} keeps. It is
   * made if it isn't there, and a temporary one if the folder can't be written.
   *
   * @throws IOException if the file can't be used; the message says what to do
   */
  public ServerIdentity identity(Encryption encryption) throws IOException {
    return Files.isDirectory(root) && Files.isWritable(root)
        ? new ServerIdentity(encryption, ServerKey.load(serverKey()))
        : ServerIdentity.temporary(encryption);
  }

  /** Returns the file of the key by which players know the server. */
  public Path serverKey() {
    return root.resolve("server.key");
  }

  /** Returns the folder in which recordings begin that are given no other place. */
  public Path recordings() {
    return root.resolve("recordings");
  }

  /** Returns the file of the page's token. */
  public Path adminToken() {
    return root.resolve("admin.token");
  }

  /** Returns the file of the remote console's password. */
  public Path rconPassword() {
    return root.resolve("rcon.password");
  }

  /** Returns the folder in which levels are found by their name. */
  public Path levels() {
    return root.resolve("levels");
  }

  /** Returns the folder of checkpoints, which has a folder for each room. */
  public Path checkpoints() {
    return root.resolve("checkpoints");
  }

  /** Returns the file of what accounts keep, without the ending that the database gives it. */
  public Path accounts() {
    return root.resolve("accounts");
  }

  /** Returns the folder of levels that players have sent. */
  public Path uploads() {
    return root.resolve("uploads");
  }

  /** Returns the folder of the journals of rooms that this server follows in its fleet. */
  public Path followed() {
    return root.resolve("followed");
  }

  /** Returns the folder of the lists on which this server and its fleet agreed last. */
  public Path agreed() {
    return root.resolve("fleet");
  }

  /** Returns whether a text can be the name of a saved match: no path leads out of the folder. */
  public static boolean isSaveName(String name) {
    return SAVE_NAME.matcher(name).matches();
  }

  /** Returns the file of a saved match. */
  public Path saved(String name) {
    return root.resolve("saves").resolve(name + SAVED);
  }

  /** Returns the names of the saved matches, sorted. */
  public List<String> savedNames() {
    return names(root.resolve("saves"), SAVED);
  }

  /** Returns the recordings in some folders, those of each folder sorted. */
  public static List<String> recordingFiles(List<Path> folders) {
    return folders.stream()
        .flatMap(
            folder ->
                names(folder, RECORDING).stream()
                    .map(name -> folder.resolve(name + RECORDING).toString()))
        .toList();
  }

  /** Returns the names of the levels in the folder, sorted. */
  public List<String> levelNames() {
    return names(levels(), LEVEL);
  }

  /** Returns the names of a folder's files that have an ending, without it, sorted. */
  private static List<String> names(Path folder, String ending) {
    if (!Files.isDirectory(folder)) {
      return List.of();
    }
    try (Stream<Path> files = Files.list(folder)) {
      return files
          .map(file -> file.getFileName().toString())
          .filter(name -> name.endsWith(ending))
          .map(name -> name.substring(0, name.length() - ending.length()))
          .sorted()
          .toList();
    } catch (IOException e) {
      return List.of();
    }
  }

  /** Returns the file of a level of the folder, or the name itself if there is none. */
  public String level(String name) {
    return levelNames().contains(name) ? levels().resolve(name + LEVEL).toString() : name;
  }

  /**
   * Writes a file in the place of one that is there, in one step: after a crash it is the old one
   * or the new one. When the disk is full, the old one stays, and nothing of the new one.
   *
   * @throws IOException if it can't be written
   */
  public static void replace(Path file, byte[] bytes) throws IOException {
    Path fresh = file.resolveSibling(file.getFileName() + ".new");
    Files.createDirectories(file.toAbsolutePath().getParent());
    try {
      Files.write(fresh, bytes);
      Files.move(fresh, file, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
    } catch (IOException e) {
      Files.deleteIfExists(fresh);
      throw e;
    }
  }

  /**
   * Creates the folder for recordings, and returns it.
   *
   * @throws IOException if it can't be created; the message says what to do
   */
  public Path newRecordings() throws IOException {
    try {
      return Files.createDirectories(recordings());
    } catch (IOException e) {
      throw new IOException(
          recordings() + " can't be created (" + FileErrors.reason(e) + "); name a file", e);
    }
  }

  /**
   * Creates the folder if it isn't there, and checks that files can be written to it.
   *
   * @throws IOException if not; the message says what to do
   */
  public void create() throws IOException {
    try {
      Files.createDirectories(root);
    } catch (IOException e) {
      throw new IOException(
          "data="
              + root
              + " can't be created ("
              + FileErrors.reason(e)
              + "); name another folder with --data",
          e);
    }
    if (!Files.isWritable(root)) {
      throw new IOException(
          "data=%s can't be written by the user %s; make the folder its own, or name another with %s"
              .formatted(root, System.getProperty("user.name"), "--data"));
    }
  }
}
