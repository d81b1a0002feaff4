package carom.lab.house;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * The Java sources of the product, and what a reader who draws them sees: packages and their
 * imports. The class files don't tell imports, because one that only Javadoc needs leaves no trace
 * there.
 */
public final class Sources {
  /** Folders of the product's Java sources, seen from the project's. */
  public static final List<String> ROOTS =
      List.of(
          "shared/src/main/java",
          "shared/src/vector/java",
          "server/src/main/java",
          "client/src/main/java",
          "launcher/src/main/java",
          "testkit/src/main/java",
          "plain/src/main/java");

  private static final Pattern PACKAGE = Pattern.compile("(?m)^package ([\\w.]+);");
  private static final Pattern IMPORT =
      Pattern.compile("(?m)^import (?:static )?(carom\\.[\\w.]+)");
  private static final Pattern PUBLIC =
      Pattern.compile("(?m)^public [a-z\\- ]*(class|interface|enum|record|@interface) ");

  /**
   * One file.
   *
   * @param module the folder of its module, such as {@code shared}
   * @param pack the name of its package
   * @param name the file's name
   * @param lines number of lines
   * @param isPublic whether its type is public
   * @param imports the names that it imports from Carom
   */
  public record Source(
      String module, String pack, String name, int lines, boolean isPublic, Set<String> imports) {}

  private final List<Source> files;
  private final Map<String, Set<String>> uses = new TreeMap<>();

  private Sources(List<Source> files) {
    this.files = List.copyOf(files);
    for (Source file : files) {
      uses.computeIfAbsent(file.pack, name -> new TreeSet<>());
    }
    for (Source file : files) {
      for (String name : file.imports) {
        String used = packageOf(name);
        if (!used.equals(file.pack)) {
          uses.get(file.pack).add(used);
        }
      }
    }
  }

  /**
   * Reads all sources.
   *
   * @param project the project's folder
   */
  public static Sources read(Path project) throws IOException {
    List<Source> files = new ArrayList<>();
    for (String root : ROOTS) {
      try (Stream<Path> found = Files.walk(project.resolve(root))) {
        for (Path file : found.filter(f -> f.toString().endsWith(".java")).sorted().toList()) {
          files.add(source(root.substring(0, root.indexOf('/')), file));
        }
      }
    }
    return new Sources(files);
  }

  private static Source source(String module, Path file) throws IOException {
    String text = Files.readString(file);
    Matcher pack = PACKAGE.matcher(text);
    if (!pack.find()) {
      throw new IOException("a file without a package: " + file);
    }
    Set<String> imports = new TreeSet<>();
    Matcher matcher = IMPORT.matcher(text);
    while (matcher.find()) {
      imports.add(matcher.group(1));
    }
    return new Source(
        module,
        pack.group(1),
        file.getFileName().toString(),
        (int) text.lines().count(),
        PUBLIC.matcher(text).find(),
        imports);
  }

  /** Returns the package of a name that is imported: that of a type, or of a member of one. */
  private String packageOf(String imported) {
    String name = imported;
    while (!uses.containsKey(name)) {
      int dot = name.lastIndexOf('.');
      if (dot < 0) {
        throw new IllegalStateException("an import of no package of the product: " + imported);
      }
      name = name.substring(0, dot);
    }
    return name;
  }

  /** Returns the files, ordered by module, then by path. */
  public List<Source> files() {
    return files;
  }

  /** Returns the names of the packages that each package imports something from, without itself. */
  public Map<String, Set<String>> uses() {
    return uses;
  }

  /**
   * Returns the circles: the largest sets of packages each of which leads to every other one by
   * imports. In a house without circles there is none.
   */
  public List<Set<String>> circles() {
    return circles(uses);
  }

  /**
   * Returns the circles of any graph.
   *
   * @param uses the names that each name leads to, with a row for each name
   */
  public static List<Set<String>> circles(Map<String, Set<String>> uses) {
    Map<String, Set<String>> reached = new TreeMap<>();
    uses.keySet().forEach(name -> reached.put(name, reachedFrom(name, uses)));
    Set<Set<String>> circles = new LinkedHashSet<>();
    reached.forEach(
        (name, others) -> {
          if (others.contains(name)) {
            Set<String> circle = new TreeSet<>(others);
            circle.removeIf(other -> !reached.get(other).contains(name));
            circles.add(circle);
          }
        });
    return List.copyOf(circles);
  }

  private static Set<String> reachedFrom(String name, Map<String, Set<String>> uses) {
    Set<String> reached = new TreeSet<>();
    List<String> open = new ArrayList<>(uses.get(name));
    while (!open.isEmpty()) {
      String next = open.remove(open.size() - 1);
      if (reached.add(next)) {
        open.addAll(uses.get(next));
      }
    }
    return reached;
  }
}
