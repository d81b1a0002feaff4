package carom.docs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/**
 * Goal: jars don't depend on the machine that builds them. Method: the entries of those that Gradle
 * has made for the tests. {@code ./gradlew checkReproducible} compares whole builds. Without Gradle
 * these tests are skipped.
 */
final class ArchivesTest {
  private static List<Path> jars() throws IOException {
    String repository = System.getProperty("carom.starter.repository");
    assumeTrue(repository != null, "carom.starter.repository isn't set: run by Gradle");
    try (Stream<Path> files = Files.walk(Path.of(repository))) {
      List<Path> jars = files.filter(file -> file.toString().endsWith(".jar")).toList();
      assertTrue(jars.size() >= 5, () -> "jars=" + jars);
      return jars;
    }
  }

  /** Something that is checked of each entry. */
  private interface Check {
    void check(Path entry, String what) throws IOException;
  }

  private static void each(Check check) throws IOException {
    for (Path jar : jars()) {
      try (FileSystem zip =
              FileSystems.newFileSystem(jar, Map.of("enablePosixFileAttributes", true));
          Stream<Path> entries = Files.walk(zip.getPath("/"))) {
        for (Path entry : entries.filter(path -> path.getNameCount() > 0).toList()) {
          check.check(entry, jar.getFileName() + ": " + entry);
        }
      }
    }
  }

  @Test
  void allEntriesHaveOneTime() throws IOException {
    Set<FileTime> times = new HashSet<>();
    each((entry, what) -> times.add(Files.getLastModifiedTime(entry)));
    assertEquals(1, times.size(), times::toString);
  }

  @Test
  void modesAreThoseOfNoUmask() throws IOException {
    each(
        (entry, what) ->
            assertEquals(
                Files.isDirectory(entry) ? "rwxr-xr-x" : "rw-r--r--",
                PosixFilePermissions.toString(Files.getPosixFilePermissions(entry)),
                what));
  }

  @Test
  void nothingTellsWhereItWasBuilt() throws IOException {
    String folder = Path.of("..").toRealPath().toString();
    each(
        (entry, what) -> {
          if (Files.isRegularFile(entry)) {
            String bytes = new String(Files.readAllBytes(entry), StandardCharsets.ISO_8859_1);
            assertFalse(bytes.contains(folder), what);
          }
        });
  }
}
