package carom.docs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/**
 * Goal: a reader who follows a link arrives. Method: every relative link of every page, to a file
 * and to a section; every page that sources name; every page is in the index.
 */
final class LinksTest {
  private static final Path ROOT = Path.of("..").toAbsolutePath().normalize();
  private static final Pattern LINK =
      Pattern.compile("]\\((?!\\w+:)([^)#\\s]*)(?:#([^)\\s]+))?\\)");
  private static final Pattern NAMED_PAGE = Pattern.compile("(?<![\\w/])docs/[\\w/.-]+\\.md");
  private static final Set<String> NOT_OURS = Set.of("build", ".git", ".gradle", "target");

  private static List<Path> files(Path folder, String... endings) throws IOException {
    List<Path> found = new ArrayList<>();
    Files.walkFileTree(
        folder,
        new SimpleFileVisitor<>() {
          @Override
          public FileVisitResult preVisitDirectory(Path path, BasicFileAttributes attributes) {
            boolean isOurs = !NOT_OURS.contains(path.getFileName().toString());
            return isOurs ? FileVisitResult.CONTINUE : FileVisitResult.SKIP_SUBTREE;
          }

          @Override
          public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) {
            for (String ending : endings) {
              if (file.toString().endsWith(ending)) {
                found.add(file);
              }
            }
            return FileVisitResult.CONTINUE;
          }
        });
    return found;
  }

  @Test
  void everyLinkLeadsSomewhere() throws IOException {
    Set<String> broken = new TreeSet<>();
    int sections = 0;
    for (Path page : files(ROOT, ".md")) {
      Matcher link = LINK.matcher(Files.readString(page));
      while (link.find()) {
        Path target = link.group(1).isEmpty() ? page : page.resolveSibling(link.group(1));
        boolean leads = Files.exists(target);
        if (leads && link.group(2) != null && target.toString().endsWith(".md")) {
          sections++;
          leads = sections(target).contains(link.group(2));
        }
        if (!leads) {
          broken.add(ROOT.relativize(page) + " links to " + link.group());
        }
      }
    }
    assertEquals(Set.of(), broken);
    assertTrue(sections > 50, "sections=" + sections);
  }

  /** Returns the names by which the sections of a page are linked to, as GitHub makes them. */
  private static Set<String> sections(Path page) throws IOException {
    Set<String> names = new HashSet<>();
    boolean isCode = false;
    for (String line : Files.readAllLines(page)) {
      isCode ^= line.startsWith("```");
      if (!isCode && line.startsWith("#")) {
        String title = line.replaceFirst("#+ *", "").replaceAll("\\[([^]]*)]\\([^)]*\\)", "$1");
        names.add(
            title.toLowerCase(Locale.ROOT).replaceAll("[^\\p{L}\\p{N}_ -]", "").replace(' ', '-'));
      }
    }
    return names;
  }

  /** Comments, help texts, messages and the build name pages by their path. */
  @Test
  void everyPageThatSourcesNameIsThere() throws IOException {
    Set<String> broken = new TreeSet<>();
    int named = 0;
    for (Path file : files(ROOT, ".java", ".gradle", ".sh", ".js", ".html", ".md", ".service")) {
      Matcher name = NAMED_PAGE.matcher(Files.readString(file));
      while (name.find()) {
        named++;
        if (!Files.exists(ROOT.resolve(name.group()))) {
          broken.add(ROOT.relativize(file) + " names " + name.group());
        }
      }
    }
    assertEquals(Set.of(), broken);
    assertTrue(named > 50, "named=" + named);
  }

  @Test
  void theIndexesLeadToEveryPage() throws IOException {
    Set<Path> led = new HashSet<>();
    for (Path index : files(ROOT.resolve("docs"), "README.md")) {
      Matcher link = LINK.matcher(Files.readString(index));
      while (link.find()) {
        led.add(index.resolveSibling(link.group(1)).normalize());
      }
    }
    List<Path> lost = files(ROOT.resolve("docs"), ".md");
    lost.removeIf(page -> led.contains(page) || page.endsWith("docs/README.md"));
    assertEquals(List.of(), lost, "pages that no index names");
  }
}
