import java.io.File;
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
import java.util.Set;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipInputStream;

/**
 * Runs the Gradle release that {@code gradle-wrapper.properties} names; the first run downloads and
 * checks it. Where it can't be downloaded, the gradle on the PATH runs. It does for {@code
 * gradlew.bat} what {@code gradlew} does by itself: {@code java Wrapper.java ARGUMENTS}, from JDK
 * 17 on.
 */
final class Wrapper {
  private static final int CONNECT_TIMEOUT_MS = 5_000;
  private static final int READ_TIMEOUT_MS = 10_000;
  private static final boolean WINDOWS = System.getProperty("os.name").startsWith("Windows");

  /** Tasks that only start a program. Warnings of an old Gradle would hide what it says. */
  private static final Set<String> PROGRAMS =
      Set.of("run", "play", "bots", "replay", "render", "bench", "figures");

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
    Path bin = dists.resolve("checked").resolve(release).resolve("bin");
    Path gradle = bin.resolve(WINDOWS ? "gradle.bat" : "gradle");
    List<String> flags = new ArrayList<>();
    try {
      if (!Files.exists(gradle)) {
        install(url, pinned.getProperty("distributionSha256Sum"), dists);
      }
    } catch (Failure told) {
      System.exit(1);
    } catch (IOException e) {
      gradle = onPath(release, url, e);
      flags.add("--no-daemon"); // an old one gives programs the environment it was started in
      if (Stream.of(args).anyMatch(PROGRAMS::contains)) {
        flags.add("-q");
      }
    }
    List<String> command = new ArrayList<>();
    if (WINDOWS) {
      // Without "call", cmd drops the first and the last quote of a line that begins with one.
      command.addAll(List.of("cmd", "/c", "call"));
    }
    command.add(gradle.toString());
    command.addAll(flags);
    if (System.console() != null) {
      command.add("-Pterminal"); // the server greets a newcomer on a terminal
    }
    command.addAll(List.of(args));
    System.exit(new ProcessBuilder(command).inheritIO().start().waitFor());
  }

  /** Returns the gradle on the PATH, and says so in one line; ends the program if none is there. */
  private static Path onPath(String release, URL url, IOException cause) {
    List<String> names =
        WINDOWS ? List.of("gradle.exe", "gradle.bat", "gradle.cmd") : List.of("gradle");
    String folders = System.getenv().getOrDefault("PATH", "");
    for (String folder : folders.replace("\"", "").split(File.pathSeparator)) {
      for (String name : names) {
        File file = new File(folder, name);
        if (!folder.isEmpty() && file.isFile() && file.canExecute()) {
          System.err.printf(
              "gradlew: can't download %s, so this runs the gradle on the PATH; its first run takes"
                  + " a minute or two%n",
              release);
          return file.toPath();
        }
      }
    }
    System.err.printf("gradlew: can't download %s (%s),%n", url, cause);
    System.err.println("gradlew: and there is no gradle on the PATH. Let this machine reach that");
    System.err.println(
        "gradlew: address, or install Gradle 4.4 to 9 and put its folder bin on the");
    System.err.println("gradlew: PATH, and run the same command again.");
    System.exit(1);
    throw new AssertionError();
  }

  private static Path home() {
    String home = System.getenv("GRADLE_USER_HOME");
    return home == null ? Path.of(System.getProperty("user.home"), ".gradle") : Path.of(home);
  }

  /** Installs a release in a folder of its own, so that an interrupted run leaves nothing half. */
  private static void install(URL url, String sum, Path dists) throws IOException {
    Files.createDirectories(dists);
    Path folder = Files.createTempDirectory(dists, "new.");
    try {
      Path zip = folder.resolve("gradle.zip");
      var connection = url.openConnection();
      connection.setConnectTimeout(CONNECT_TIMEOUT_MS);
      connection.setReadTimeout(READ_TIMEOUT_MS);
      try (InputStream in = connection.getInputStream()) {
        System.err.println("gradlew: downloading " + url);
        Files.copy(in, zip);
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
