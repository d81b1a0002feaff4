import java.io.IOException;
import java.io.InputStream;
import java.net.URI;
import java.net.URL;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HexFormat;
import java.util.List;
import java.util.Properties;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipInputStream;

/**
 * Runs the Gradle release that {@code gradle-wrapper.properties} names; the first run downloads and
 * checks it. It does for {@code gradlew.bat} what {@code gradlew} does by itself: {@code java
 * Wrapper.java ARGUMENTS}, from JDK 17 on.
 */
final class Wrapper {
  private static final int TIMEOUT_MS = 10_000;

  private Wrapper() {}

  public static void main(String[] args) throws Exception {
    Path properties = Path.of("gradle", "wrapper", "gradle-wrapper.properties");
    Path root = Path.of(System.getProperty("carom.root", "")).toAbsolutePath();
    Properties pinned = new Properties();
    try (InputStream in = Files.newInputStream(root.resolve(properties))) {
      pinned.load(in);
    }
    URL url = URI.create(pinned.getProperty("distributionUrl")).toURL();
    String archive = url.getPath().substring(url.getPath().lastIndexOf('/') + 1);
    String release = archive.substring(0, archive.lastIndexOf('-'));
    Path dists =
        home().resolve("wrapper").resolve("dists").resolve(archive.replaceFirst("[.]zip$", ""));
    boolean windows = System.getProperty("os.name").startsWith("Windows");
    Path bin = dists.resolve("checked").resolve(release).resolve("bin");
    Path gradle = bin.resolve(windows ? "gradle.bat" : "gradle");
    try {
      if (!Files.exists(gradle)) {
        install(url, pinned.getProperty("distributionSha256Sum"), dists);
      }
    } catch (Failure told) {
      System.exit(1);
    }
    List<String> command = new ArrayList<>();
    if (windows) {
      command.addAll(List.of("cmd", "/c"));
    }
    command.add(gradle.toString());
    if (System.console() != null) {
      command.add("-Pterminal"); // the server greets a newcomer on a terminal
    }
    command.addAll(List.of(args));
    System.exit(new ProcessBuilder(command).inheritIO().start().waitFor());
  }

  private static Path home() {
    String home = System.getenv("GRADLE_USER_HOME");
    return home == null ? Path.of(System.getProperty("user.home"), ".gradle") : Path.of(home);
  }

  /** Installs a release in a folder of its own, so that an interrupted run leaves nothing half. */
  private static void install(URL url, String sum, Path dists) throws IOException {
    System.err.println("gradlew: downloading " + url);
    Files.createDirectories(dists);
    Path folder = Files.createTempDirectory(dists, "new.");
    try {
      Path zip = folder.resolve("gradle.zip");
      var connection = url.openConnection();
      connection.setConnectTimeout(TIMEOUT_MS);
      connection.setReadTimeout(TIMEOUT_MS);
      try (InputStream in = connection.getInputStream()) {
        Files.copy(in, zip);
      } catch (IOException e) {
        throw failure("can't download " + url + " (" + e + "). Is this machine offline?");
      }
      String given = sha256(zip);
      if (!given.equals(sum)) {
        throw failure(
            ("wrong checksum: what %s gave has the SHA-256 sum%n%s, and gradle-wrapper.properties"
                    + " asks for%n%s. It was thrown away. A proxy may have answered instead; try"
                    + " again.")
                .formatted(url, given, sum));
      }
      unzip(zip, folder);
      Files.delete(zip);
      if (!Files.exists(dists.resolve("checked"))) {
        Files.move(folder, dists.resolve("checked"), StandardCopyOption.ATOMIC_MOVE);
      }
    } finally {
      delete(folder);
    }
  }

  private static RuntimeException failure(String text) {
    text.lines().forEach(line -> System.err.println("gradlew: " + line));
    return new Failure();
  }

  /** Ends the program after its message, without a stack trace. */
  private static final class Failure extends RuntimeException {
    private static final long serialVersionUID = 1;

    Failure() {
      super("see above", null, false, false);
    }
  }

  private static String sha256(Path file) throws IOException {
    try (InputStream in = Files.newInputStream(file)) {
      MessageDigest digest = MessageDigest.getInstance("SHA-256");
      byte[] buffer = new byte[1 << 16];
      for (int n; (n = in.read(buffer)) > 0; ) {
        digest.update(buffer, 0, n);
      }
      return HexFormat.of().formatHex(digest.digest());
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException(e);
    }
  }

  private static void unzip(Path zip, Path folder) throws IOException {
    try (ZipInputStream in = new ZipInputStream(Files.newInputStream(zip))) {
      for (ZipEntry entry; (entry = in.getNextEntry()) != null; ) {
        Path file = folder.resolve(entry.getName()).normalize();
        if (!file.startsWith(folder)) {
          throw new IOException("the archive has a file outside of it: " + entry.getName());
        }
        if (entry.isDirectory()) {
          Files.createDirectories(file);
        } else {
          Files.createDirectories(file.getParent());
          Files.copy(in, file);
          if (file.endsWith(Path.of("bin", "gradle"))) {
            file.toFile().setExecutable(true, false);
          }
        }
      }
    }
  }

  private static void delete(Path folder) throws IOException {
    if (Files.exists(folder)) {
      try (Stream<Path> files = Files.walk(folder)) {
        for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
          Files.delete(file);
        }
      }
    }
  }
}
