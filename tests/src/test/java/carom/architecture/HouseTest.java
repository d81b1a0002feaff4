package carom.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/**
 * Keeps the rooms of the house small enough to live in: files and lines of a package, lines of a
 * class. Reads the sources of the product; the laboratory and the tests may grow.
 */
final class HouseTest {
  private static final int MOST_FILES = 20;
  private static final int MOST_LINES = 2_600;
  private static final int MOST_LINES_OF_A_CLASS = 500;

  /** How a longer class begins the paragraph of its doc comment that says why it is long. */
  private static final String REASON = "<b>Length.</b>";

  /** The face that users import: its names stay, whatever their number. */
  private static final String FACE = "carom/physics";

  private static final List<String> ROOTS =
      List.of(
          "shared/src/main/java",
          "shared/src/vector/java",
          "server/src/main/java",
          "client/src/main/java",
          "launcher/src/main/java",
          "testkit/src/main/java");

  /** Returns the sources of the product by package, as a path. */
  private static Map<String, List<Path>> sources() {
    Map<String, List<Path>> packages = new TreeMap<>();
    for (String root : ROOTS) {
      Path base = Path.of("..").resolve(root);
      try (Stream<Path> files = Files.walk(base)) {
        files
            .filter(file -> file.toString().endsWith(".java"))
            .forEach(
                file -> {
                  String name = base.relativize(file.getParent()).toString().replace('\\', '/');
                  packages.computeIfAbsent(name, n -> new ArrayList<>()).add(file);
                });
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
    }
    return packages;
  }

  private static String text(Path file) {
    try {
      return Files.readString(file);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static long lines(Path file) {
    return text(file).lines().count();
  }

  @Test
  void packagesStaySmall() {
    List<String> tooLarge = new ArrayList<>();
    sources()
        .forEach(
            (name, files) -> {
              long lines = files.stream().mapToLong(HouseTest::lines).sum();
              if (!name.equals(FACE) && (files.size() > MOST_FILES || lines > MOST_LINES)) {
                tooLarge.add(name + ": files=" + files.size() + " lines=" + lines);
              }
            });
    assertEquals(
        List.of(), tooLarge, "at most " + MOST_FILES + " files and " + MOST_LINES + " lines");
  }

  @Test
  void longClassesSayWhy() {
    List<String> unexplained = new ArrayList<>();
    sources()
        .values()
        .forEach(
            files ->
                files.stream()
                    .filter(f -> lines(f) > MOST_LINES_OF_A_CLASS && !text(f).contains(REASON))
                    .forEach(f -> unexplained.add(f.getFileName() + ": lines=" + lines(f))));
    assertEquals(
        List.of(),
        unexplained,
        "longer than " + MOST_LINES_OF_A_CLASS + " lines without a paragraph " + REASON);
  }

  @Test
  void packagesSayWhatTheyAreFor() {
    List<String> silent = new ArrayList<>();
    sources()
        .forEach(
            (name, files) -> {
              boolean said = files.stream().anyMatch(f -> f.endsWith("package-info.java"));
              boolean elsewhere =
                  ROOTS.stream()
                      .anyMatch(
                          root ->
                              Files.exists(
                                  Path.of("..")
                                      .resolve(root)
                                      .resolve(name + "/package-info.java")));
              if (!said && !elsewhere) {
                silent.add(name);
              }
            });
    assertEquals(List.of(), silent);
  }

  @Test
  void theRulesSeeTheSources() {
    Map<String, List<Path>> packages = sources();
    assertTrue(packages.size() > 40, "packages=" + packages.size());
    assertTrue(packages.containsKey(FACE));
  }
}
