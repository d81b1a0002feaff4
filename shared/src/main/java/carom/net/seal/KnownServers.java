package carom.net.seal;

import carom.text.TextFile;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * The servers that a client knows, each by its address and the fingerprint of its key. The first
 * key that a server shows is remembered, and another one is refused from then on. Any thread may
 * use it.
 *
 * <p>The file has a line for each server: the address, a space and the fingerprint. Servers on this
 * machine aren't remembered, because no attacker can stand between, and developers start many.
 */
public final class KnownServers {
  private final Path file; // null for none
  private final Map<String, String> fingerprints = new HashMap<>();

  private KnownServers(Path file) {
    this.file = file;
  }

  /** Returns a list that is empty and forgotten at the end of the process. */
  public static KnownServers inMemory() {
    return new KnownServers(null);
  }

  /** Returns the list in a file, which need not exist yet. */
  public static KnownServers in(Path file) {
    return new KnownServers(file);
  }

  /**
   * Notes which key a server must have, as a trusted source told it. It counts for this process and
   * before what the file says.
   *
   * @param server address and TCP port
   */
  public synchronized void expect(String server, String fingerprint) {
    fingerprints.put(key(server), fingerprint);
  }

  /**
   * Notes which key a server must have, as another server said: it never displaces what is known.
   *
   * @param server address and TCP port
   */
  public synchronized void hear(String server, String fingerprint) {
    try {
      if (known(server) == null) {
        fingerprints.put(key(server), fingerprint);
      }
    } catch (IOException e) {
      fingerprints.putIfAbsent(key(server), fingerprint); // the problem is told when it connects
    }
  }

  /**
   * Returns why a client must not trust a server, in words for the player, or null if it may.
   *
   * @param server address and TCP port
   * @param fingerprint of the key that the server shows
   */
  public synchronized String problem(String server, String fingerprint) {
    String known;
    try {
      known = known(server);
    } catch (IOException e) {
      return "the list of known servers can't be read: " + e + "; mend it, or move it away";
    }
    if (known == null || known.equals(fingerprint)) {
      return null;
    }
    return "the server at "
        + server
        + " isn't the one you know: it shows the key "
        + fingerprint
        + " and the known one is "
        + known
        + "; somebody may read along. If the operator confirms the new key, "
        + (file == null ? "start the game again" : "delete the server's line in " + file);
  }

  /**
   * Remembers the key of a server that has proven it, unless one is known or the server runs on
   * this machine. If the file can't be written, it is remembered until the process ends.
   */
  public synchronized void remember(String server, String fingerprint) {
    try {
      if (isHere(server) || known(server) != null) {
        return;
      }
      fingerprints.put(key(server), fingerprint);
      if (file != null) {
        Files.createDirectories(file.toAbsolutePath().getParent());
        Files.write(
            file,
            List.of(key(server) + " " + fingerprint),
            StandardOpenOption.CREATE,
            StandardOpenOption.APPEND);
      }
    } catch (IOException e) {
      fingerprints.put(key(server), fingerprint);
    }
  }

  private String known(String server) throws IOException {
    String expected = fingerprints.get(key(server));
    if (expected != null || file == null) {
      return expected;
    }
    try {
      for (String line : TextFile.read(file, TextFile.MAX_BYTES).split("\\R")) {
        String[] words = line.strip().split("\\s+", 3);
        if (words.length >= 2 && words[0].equals(key(server))) {
          return words[1];
        }
      }
    } catch (NoSuchFileException e) {
      return null;
    }
    return null;
  }

  private static String key(String server) {
    return server.toLowerCase(Locale.ROOT);
  }

  private static boolean isHere(String server) {
    String host = server.substring(0, Math.max(0, server.lastIndexOf(':')));
    return host.equals("localhost")
        || host.startsWith("127.")
        || host.equals("::1")
        || host.equals("[::1]");
  }
}
