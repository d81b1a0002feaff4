package carom.lab.house;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;

/**
 * Prints how large the house is: the longest packages, classes and pages. Sizes are for a reader to
 * judge; nothing fails on them. Split where an idea ends.
 */
public final class HouseMain {
  private static final String[] ROOTS = {
    "shared/src/main/java",
    "shared/src/vector/java",
    "server/src/main/java",
    "client/src/main/java",
    "launcher/src/main/java",
    "testkit/src/main/java"
  };

  private static final int ROWS = 15;

  private record Size(String name, long size, long files) {}

  private HouseMain() {}

  /**
   * Prints the report.
   *
   * @param args the project's folder; without one, the working folder
   */
  public static void main(String[] args) throws IOException {
    Path project = Path.of(args.length == 0 ? "." : args[0]);
    List<Size> classes = new ArrayList<>();
    Map<String, Size> packages = new TreeMap<>();
    for (String root : ROOTS) {
      for (Path file : files(project.resolve(root), ".java")) {
        long lines = Files.readString(file).lines().count();
        String name = project.resolve(root).relativize(file.getParent()).toString();
        classes.add(new Size(name + "/" + file.getFileName(), lines, 1));
        packages.merge(
            name,
            new Size(name, lines, 1),
            (a, b) -> new Size(name, a.size + b.size, a.files + b.files));
      }
    }
    List<Size> pages = new ArrayList<>();
    for (Path page : files(project.resolve("docs"), ".md")) {
      long words = Files.readString(page).strip().split("\\s+").length;
      pages.add(new Size(project.relativize(page).toString(), words, 1));
    }
    long lines = classes.stream().mapToLong(Size::size).sum();
    System.out.printf(
        "lines=%,d classes=%,d packages=%,d%n", lines, classes.size(), packages.size());
    print("packages, lines (files)", packages.values());
    print("files, lines", classes);
    print("pages, words", pages);
  }

  private static List<Path> files(Path folder, String ending) throws IOException {
    try (Stream<Path> files = Files.walk(folder)) {
      return files.filter(file -> file.toString().endsWith(ending)).sorted().toList();
    }
  }

  private static void print(String title, Iterable<Size> sizes) {
    List<Size> sorted = new ArrayList<>();
    sizes.forEach(sorted::add);
    sorted.sort(Comparator.comparingLong(Size::size).reversed());
    System.out.printf("%n%s%n", title);
    for (Size row : sorted.subList(0, Math.min(ROWS, sorted.size()))) {
      String files = row.files > 1 ? " (" + row.files + ")" : "";
      System.out.printf("%,8d%s  %s%n", row.size, files, row.name);
    }
  }
}
