package carom.server.config;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * The folder in which a server keeps its files. It creates what it writes to, when it writes.
 *
 * @param root the folder
 */
public record DataFolder(Path root) {
  /** Name of the file of settings. */
  public static final String CONFIG = "carom.conf";

  /** Returns the folder of the log, which is rotated. */
  public Path logs() {
    return root.resolve("logs");
  }

  /** Returns the folder in which recordings begin that are given no other place. */
  public Path recordings() {
    return root.resolve("recordings");
  }

  /** Returns the folder in which levels are found by their name. */
  public Path levels() {
    return root.resolve("levels");
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
          "data=" + root + " can't be created (" + e + "); name another folder with --data", e);
    }
    if (!Files.isWritable(root)) {
      throw new IOException(
          "data=%s can't be written by the user %s; make the folder its own, or name another with %s"
              .formatted(root, System.getProperty("user.name"), "--data"));
    }
  }
}
