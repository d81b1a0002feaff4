package carom.docs;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/**
 * Every class that docs/engine/LECTURE.md names in the last column of its tables exists in the
 * engine.
 */
final class LecturePageTest {
  private static final Path ROOT = Path.of("..");
  private static final Pattern CLASS = Pattern.compile("`([A-Z]\\w+)`");

  @Test
  void theClassesThatThePageNamesExist() throws IOException {
    TreeSet<String> classes;
    try (Stream<Path> files = Files.walk(ROOT.resolve("shared/src/main/java/carom/physics"))) {
      classes =
          files
              .map(f -> f.getFileName().toString().replace(".java", ""))
              .collect(Collectors.toCollection(TreeSet::new));
    }
    TreeSet<String> missing = new TreeSet<>();
    int named = 0;
    for (String line : Files.readAllLines(ROOT.resolve("docs/engine/LECTURE.md"))) {
      if (line.startsWith("|")) {
        Matcher found = CLASS.matcher(line.substring(line.lastIndexOf('|', line.length() - 2)));
        for (; found.find(); named++) {
          if (!classes.contains(found.group(1))) {
            missing.add(found.group(1));
          }
        }
      }
    }
    assertTrue(named > 25, "too few classes: " + named);
    assertTrue(missing.isEmpty(), () -> "no such classes: " + missing);
  }
}
