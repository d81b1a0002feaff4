package carom.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.tree.LineMap;
import com.sun.source.tree.MethodTree;
import com.sun.source.util.DocTrees;
import com.sun.source.util.JavacTask;
import com.sun.source.util.SourcePositions;
import com.sun.source.util.TreePathScanner;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;

/**
 * Keeps the rooms of the house small enough to live in: files and lines of a package, lines of a
 * class. Reads the sources of the product; the laboratory and the tests may grow.
 */
final class HouseTest {
  private static final int MOST_FILES = 20;
  private static final int MOST_LINES = 2_600;
  private static final int MOST_LINES_OF_A_CLASS = 500;

  /**
   * How a longer class begins the paragraph of its doc comment that says which one idea it holds,
   * and why that can't be split.
   */
  private static final String REASON = "<b>Length.</b>";

  private static final int MOST_LINES_OF_A_METHOD = 60;

  /** How the doc comment of a longer method says why it isn't split. */
  private static final Pattern REASON_OF_A_METHOD =
      Pattern.compile("It\\s+stays\\s+whole,\\s+because(\\s+\\S+){6,}");

  /** The face that users import: its names stay, whatever their number. */
  private static final String FACE = "carom/physics";

  /** The one package of the product that has a class of the laboratory, which reads its heads. */
  private static final String LOOKED_INTO_BY_THE_LABORATORY = "carom/net/snapshot";

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
    return sources(ROOTS);
  }

  private static Map<String, List<Path>> sources(List<String> roots) {
    Map<String, List<Path>> packages = new TreeMap<>();
    for (String root : roots) {
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
    List<String> found = new ArrayList<>();
    int longClasses = 0;
    for (List<Path> files : sources().values()) {
      for (Path file : files) {
        boolean isLong = lines(file) > MOST_LINES_OF_A_CLASS;
        longClasses += isLong ? 1 : 0;
        String reason = reason(text(file));
        if (isLong ? isThin(reason) : reason != null) {
          found.add(file.getFileName() + ": lines=" + lines(file) + " reason=" + reason);
        }
      }
    }
    assertEquals(
        List.of(),
        found,
        "a class of more than "
            + MOST_LINES_OF_A_CLASS
            + " lines, and no other, has a paragraph '"
            + REASON
            + " One idea: what the class holds. It stays whole, because ...'");
    assertTrue(longClasses > 10, "longClasses=" + longClasses);
  }

  /** Returns the paragraph that says why a class is long, on one line, or null if there is none. */
  private static String reason(String source) {
    int begin = source.indexOf(REASON);
    if (begin < 0) {
      return null;
    }
    String paragraph = source.substring(begin + REASON.length()).split("\n \\*(\n|/)", 2)[0];
    return paragraph.replaceAll("\n \\* ?", " ").strip();
  }

  /** Returns whether a reason doesn't name one idea, or not why it can't be split. */
  private static boolean isThin(String reason) {
    return reason == null
        || !reason.matches("One idea: \\w[^.]{8,}\\. .*\\bbecause\\b( \\S+){8,}")
        || reason.matches("(?i).*(just above|more than [\\d,]+ lines|doc comments).*");
  }

  @Test
  void longMethodsSayWhy() throws IOException {
    List<Path> files = sources().values().stream().flatMap(List::stream).toList();
    JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
    List<String> found = new ArrayList<>();
    int[] methods = {0, 0};
    try (StandardJavaFileManager manager = compiler.getStandardFileManager(null, null, null)) {
      JavacTask task =
          (JavacTask)
              compiler.getTask(
                  null, manager, null, null, null, manager.getJavaFileObjectsFromPaths(files));
      DocTrees trees = DocTrees.instance(task);
      for (CompilationUnitTree unit : task.parse()) {
        new TreePathScanner<Void, Void>() {
          @Override
          public Void visitMethod(MethodTree method, Void unused) {
            methods[0]++;
            SourcePositions at = trees.getSourcePositions();
            LineMap lines = unit.getLineMap();
            long length =
                lines.getLineNumber(at.getEndPosition(unit, method))
                    - lines.getLineNumber(at.getStartPosition(unit, method))
                    + 1;
            if (length > MOST_LINES_OF_A_METHOD) {
              methods[1]++;
              String doc = trees.getDocComment(getCurrentPath());
              if (doc == null || !REASON_OF_A_METHOD.matcher(doc).find()) {
                String file = Path.of(unit.getSourceFile().toUri()).getFileName().toString();
                found.add(file + " " + method.getName() + ": lines=" + length);
              }
            }
            return super.visitMethod(method, null);
          }
        }.scan(unit, null);
      }
    }
    assertEquals(
        List.of(),
        found,
        "a method of more than "
            + MOST_LINES_OF_A_METHOD
            + " lines says in its doc comment: 'It stays whole, because ...'");
    assertTrue(methods[0] > 9_000, "methods=" + methods[0]);
    assertTrue(methods[1] > 4, "long methods=" + methods[1]);
  }

  @Test
  void thinReasonsAreRefused() {
    String whole =
        " * <p><b>Length.</b> One idea: a tree in arrays. It stays whole, because each method"
            + " keeps\n"
            + " * all of these arrays consistent.\n";
    assertEquals(
        "One idea: a tree in arrays. It stays whole, because each method keeps"
            + " all of these arrays consistent.",
        reason("/**\n * A tree.\n *\n" + whole + " *\n * <p>One thread.\n */\nclass A {}"));
    assertFalse(isThin(reason("/**\n" + whole + " */\nclass A {}")));
    assertNull(reason("/** A tree. */\nclass A {}"));
    for (String thin :
        List.of(
            "Just above 500 lines: what a room does in a turn is told in one place.",
            "More than 500 lines, because it has 46 columns, each declared, grown and copied.",
            "One option after the other, each with its text for people.",
            "One idea: a tree in arrays. Its methods are short.",
            "One idea: a tree in arrays. It stays whole, because it is.",
            "It stays whole, because each method keeps all of these arrays consistent.",
            "One idea: a tree in arrays. It is just above 500 lines, because each method keeps all"
                + " of these arrays consistent.")) {
      assertTrue(isThin(thin), thin);
    }
    assertTrue(isThin(null));
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

  /**
   * A package in two modules can't be told from its name, and doesn't load on a module path. The
   * vector kernels ship in the same jar as the rest of {@code shared/}.
   */
  @Test
  void packagesAreInOneModule() {
    Map<String, String> owners = new TreeMap<>();
    Set<String> split = new TreeSet<>();
    List<String> roots = new ArrayList<>(ROOTS);
    roots.addAll(List.of("tests/src/main/java", "tests/src/lab/java", "tests/src/peers/java"));
    for (String root : roots) {
      String module = root.replace("/vector/", "/main/");
      for (String name : sources(List.of(root)).keySet()) {
        String owner = owners.putIfAbsent(name, module);
        if (owner != null && !owner.equals(module)) {
          split.add(name);
        }
      }
    }
    assertEquals(Set.of(LOOKED_INTO_BY_THE_LABORATORY), split);
    assertTrue(owners.containsValue("tests/src/main/java"));
  }

  @Test
  void theRulesSeeTheSources() {
    Map<String, List<Path>> packages = sources();
    assertTrue(packages.size() > 40, "packages=" + packages.size());
    assertTrue(packages.containsKey(FACE));
  }
}
