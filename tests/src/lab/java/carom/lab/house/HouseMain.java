package carom.lab.house;

import carom.lab.house.Sources.Source;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Stream;

/**
 * Prints how large the house is: lines of modules, packages and files, types that are public,
 * packages with one user, circles of imports, words of pages. Sizes are for a reader to judge;
 * nothing fails on them. Split where an idea ends.
 */
public final class HouseMain {
  /** Lines from which on a file is listed. */
  private static final int LONG_FILE = 500;

  /** Lines from which on a package is listed. */
  private static final int LARGE_PACKAGE = 2_000;

  private record Size(String name, long size, long files) {}

  private final PrintStream out;

  private HouseMain(PrintStream out) {
    this.out = out;
  }

  /**
   * Prints the report.
   *
   * @param args the project's folder; without one, the working folder
   */
  public static void main(String[] args) throws IOException {
    Path project = Path.of(args.length == 0 ? "." : args[0]);
    HouseMain house = new HouseMain(System.out);
    house.print(Sources.read(project));
    house.print("pages, words", pages(project));
  }

  private void print(Sources sources) {
    Map<String, Size> modules = new TreeMap<>();
    Map<String, Size> packages = new TreeMap<>();
    List<Size> longFiles = new ArrayList<>();
    int types = 0;
    int open = 0;
    for (Source file : sources.files()) {
      add(modules, file.module(), file.lines());
      add(packages, file.pack(), file.lines());
      if (file.lines() > LONG_FILE) {
        longFiles.add(new Size(file.pack() + "." + file.name(), file.lines(), 1));
      }
      types += file.name().equals("package-info.java") ? 0 : 1;
      open += file.isPublic() ? 1 : 0;
    }
    long lines = modules.values().stream().mapToLong(Size::size).sum();
    List<String> oneUser = oneUser(sources.uses());
    List<Set<String>> circles = sources.circles();
    out.printf(
        Locale.ROOT,
        "lines=%,d types=%,d public=%d%% packages=%,d with-one-user=%d circles=%d%n",
        lines,
        types,
        100 * open / types,
        packages.size(),
        oneUser.size(),
        circles.size());
    print("modules, lines (files)", modules.values());
    print(
        "packages of more than " + LARGE_PACKAGE + " lines (files)",
        packages.values().stream().filter(p -> p.size > LARGE_PACKAGE).toList());
    print("files of more than " + LONG_FILE + " lines", longFiles);
    printRows("packages with one user", oneUser);
    printRows(
        "circles of packages that import each other",
        circles.stream().map(circle -> String.join(", ", circle)).toList());
  }

  private static void add(Map<String, Size> sizes, String name, long lines) {
    sizes.merge(
        name,
        new Size(name, lines, 1),
        (a, b) -> new Size(name, a.size + b.size, a.files + b.files));
  }

  /** Returns the packages that exactly one other package imports, each with that one. */
  private static List<String> oneUser(Map<String, Set<String>> uses) {
    List<String> rows = new ArrayList<>();
    for (String name : uses.keySet()) {
      List<String> users = new ArrayList<>();
      uses.forEach(
          (user, used) -> {
            if (used.contains(name)) {
              users.add(user);
            }
          });
      if (users.size() == 1) {
        rows.add(name + " by " + users.get(0));
      }
    }
    return rows;
  }

  private static List<Size> pages(Path project) throws IOException {
    List<Path> files = new ArrayList<>();
    try (Stream<Path> top = Files.list(project);
        Stream<Path> docs = Files.walk(project.resolve("docs"))) {
      Stream.concat(top, docs)
          .filter(file -> file.toString().endsWith(".md"))
          .sorted()
          .forEach(files::add);
    }
    List<Size> pages = new ArrayList<>();
    for (Path page : files) {
      long words = Files.readString(page).strip().split("\\s+").length;
      pages.add(new Size(project.relativize(page).toString(), words, 1));
    }
    return pages;
  }

  private void print(String title, Iterable<Size> sizes) {
    List<Size> sorted = new ArrayList<>();
    sizes.forEach(sorted::add);
    sorted.sort(Comparator.comparingLong(Size::size).reversed());
    List<String> rows = new ArrayList<>();
    for (Size row : sorted) {
      String files = row.files > 1 ? " (" + row.files + ")" : "";
      rows.add(String.format(Locale.ROOT, "%,8d%s  %s", row.size, files, row.name));
    }
    printRows(title, rows);
  }

  private void printRows(String title, List<String> rows) {
    out.printf("%n%s%n", title);
    rows.forEach(out::println);
    if (rows.isEmpty()) {
      out.println("none");
    }
  }
}
