package carom.outside;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** The JVMs of this machine that are later than the one that runs the tests. */
public final class LaterJvms {
  private static final Path PLACE = Path.of("/usr/lib/jvm");
  private static final Pattern RELEASE = Pattern.compile("JAVA_VERSION=\"(\\d+)");

  private LaterJvms() {}

  /** Returns their homes, perhaps none. */
  public static List<Path> homes() throws IOException {
    List<Path> found = new ArrayList<>();
    if (!Files.isDirectory(PLACE)) {
      return found;
    }
    try (Stream<Path> homes = Files.list(PLACE)) {
      for (Path home : homes.filter(home -> !Files.isSymbolicLink(home)).toList()) {
        Path release = home.resolve("release");
        if (Files.exists(release)) {
          var version = RELEASE.matcher(Files.readString(release));
          if (version.find() && Integer.parseInt(version.group(1)) > Runtime.version().feature()) {
            found.add(home);
          }
        }
      }
    }
    return found;
  }
}
