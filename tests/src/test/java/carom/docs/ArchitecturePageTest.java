package carom.docs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/**
 * Goal: docs/ARCHITECTURE.md is true. Method: its list of packages and its table of threads are
 * compared with the sources of the product.
 */
final class ArchitecturePageTest {
  private static final Path ROOT = Path.of("..");
  private static final Pattern THREAD =
      Pattern.compile(
          "(?:new Thread\\(|new Worker\\(|start\\(|daemon\\(|thread\\(|String name =)[^;]*?"
              + "\"(carom-[a-z-]+)\"");

  private static List<Path> sources() throws IOException {
    List<Path> found = new ArrayList<>();
    for (String part :
        List.of(
            "shared/src/main",
            "shared/src/vector",
            "server/src/main",
            "client/src/main",
            "launcher/src/main",
            "testkit/src/main",
            "plain/src/main")) {
      try (Stream<Path> files = Files.walk(ROOT.resolve(part + "/java"))) {
        files.filter(f -> f.toString().endsWith(".java")).forEach(found::add);
      }
    }
    return found;
  }

  private static String page() throws IOException {
    return Files.readString(ROOT.resolve("docs/ARCHITECTURE.md"));
  }

  @Test
  void thePageNamesEveryPackageAndNoOther() throws IOException {
    String page = page();
    int begin = page.indexOf("```\nshared/");
    String house = page.substring(begin, page.indexOf("\n```", begin));
    Set<String> named = new TreeSet<>();
    String whole = "";
    for (String line : house.substring(0, house.indexOf("tests/ ")).split("\n")) {
      for (String word : line.replaceFirst("^\\w+/", "").strip().split(" +")) {
        if (word.matches("carom(\\.\\w+)+")) {
          whole = word;
          named.add(whole);
        } else if (word.matches("(\\.\\w+)+")) {
          named.add(whole + word);
        } else {
          break; // what the packages are for
        }
      }
    }
    Set<String> packages = new TreeSet<>();
    for (Path source : sources()) {
      String path = source.getParent().toString().replace('\\', '/');
      packages.add(path.substring(path.indexOf("/java/") + 6).replace('/', '.'));
    }
    assertTrue(packages.size() > 100, "packages=" + packages.size());
    assertEquals(packages, named);
  }

  @Test
  void theTableNamesEveryThread() throws IOException {
    String page = page();
    String table = page.substring(page.indexOf("\n## Threads"), page.indexOf("\n## Trust"));
    Set<String> missing = new TreeSet<>();
    int threads = 0;
    for (Path source : sources()) {
      Matcher made = THREAD.matcher(Files.readString(source));
      while (made.find()) {
        threads++;
        if (!table.contains("`" + made.group(1))) {
          missing.add(made.group(1) + " of " + source.getFileName());
        }
      }
    }
    assertTrue(threads > 20, "threads=" + threads);
    assertEquals(Set.of(), missing);
  }
}
