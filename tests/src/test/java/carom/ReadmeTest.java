package carom;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.PrintStream;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.Locale;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: what README shows works, and pages link to what is there. Method: its example is compiled
 * and run, links are followed.
 */
final class ReadmeTest {
  private static final Path README = root().resolve("README.md");

  @Test
  void theExampleRunsAndTheBallComesToRestOnTheGround(@TempDir Path folder) throws Exception {
    Matcher block =
        Pattern.compile("```java\n(.*?)```", Pattern.DOTALL).matcher(Files.readString(README));
    assertTrue(block.find(), "README has a Java example");
    Path source = folder.resolve("Example.java");
    Files.writeString(
        source,
        "import carom.physics.*;\nimport carom.physics.geometry.*;\n"
            + "public class Example {\n  public static void run() {\n"
            + block.group(1)
            + "  }\n}\n");
    ByteArrayOutputStream errors = new ByteArrayOutputStream();
    int status =
        ToolProvider.getSystemJavaCompiler()
            .run(
                null,
                null,
                errors,
                "-cp",
                System.getProperty("java.class.path"),
                source.toString());
    assertEquals(0, status, () -> errors.toString(StandardCharsets.UTF_8));

    PrintStream before = System.out;
    ByteArrayOutputStream printed = new ByteArrayOutputStream();
    try (URLClassLoader loader = new URLClassLoader(new URL[] {folder.toUri().toURL()})) {
      System.setOut(new PrintStream(printed, true, StandardCharsets.UTF_8));
      loader.loadClass("Example").getMethod("run").invoke(null);
    } finally {
      System.setOut(before);
    }
    String line = printed.toString(StandardCharsets.UTF_8);
    assertTrue(line.matches("0[.,](49|50)\\d m, state [0-9a-f]{16}\\s+"), line);
  }

  @Test
  void everyLinkInTheDocumentsLeadsSomewhere() throws Exception {
    Pattern link = Pattern.compile("]\\((?!https?:|#)([^)#]+)");
    try (Stream<Path> docs = Files.walk(root(), 2)) {
      for (Path doc : docs.filter(p -> p.toString().endsWith(".md")).toList()) {
        Matcher m = link.matcher(Files.readString(doc));
        while (m.find()) {
          Path target = doc.resolveSibling(m.group(1));
          assertTrue(Files.exists(target), doc.getFileName() + " links to " + m.group(1));
        }
      }
    }
  }

  @Test
  void everyLinkToASectionLeadsToOne() throws Exception {
    Pattern link = Pattern.compile("]\\((?!https?:)([^)#\\s]*)#([^)]+)\\)");
    int links = 0;
    try (Stream<Path> docs = Files.walk(root(), 2)) {
      for (Path doc : docs.filter(p -> p.toString().endsWith(".md")).toList()) {
        Matcher m = link.matcher(Files.readString(doc));
        while (m.find()) {
          Path target = m.group(1).isEmpty() ? doc : doc.resolveSibling(m.group(1));
          if (target.toString().endsWith(".md")) {
            assertTrue(
                sections(target).contains(m.group(2)),
                doc.getFileName() + " links to " + m.group(1) + "#" + m.group(2));
            links++;
          }
        }
      }
    }
    assertTrue(links > 50, "links=" + links);
  }

  /** Returns the names by which the sections of a page are linked to, as GitHub makes them. */
  private static Set<String> sections(Path page) throws Exception {
    Set<String> names = new HashSet<>();
    boolean code = false;
    for (String line : Files.readAllLines(page)) {
      code ^= line.startsWith("```");
      if (!code && line.startsWith("#")) {
        String title = line.replaceFirst("#+ *", "").replaceAll("\\[([^]]*)]\\([^)]*\\)", "$1");
        names.add(
            title.toLowerCase(Locale.ROOT).replaceAll("[^\\p{L}\\p{N}_ -]", "").replace(' ', '-'));
      }
    }
    return names;
  }

  /** The folder with README.md, from wherever the tests are started. */
  private static Path root() {
    File folder = new File("").getAbsoluteFile();
    while (!new File(folder, "README.md").exists()) {
      folder = folder.getParentFile();
    }
    return folder.toPath();
  }
}
