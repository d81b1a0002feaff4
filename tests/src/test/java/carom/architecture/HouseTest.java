package carom.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.lab.house.Sources;
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
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/**
 * Goal: a reader finds what each room of the house is for. Method: the sources of the product.
 * Sizes are a report ({@code ./gradlew house}), not a test.
 */
final class HouseTest {
  /** The face that users import. */
  private static final String FACE = "carom/physics";

  /** The one package of the product that has a class of the laboratory, which reads its heads. */
  private static final String LOOKED_INTO_BY_THE_LABORATORY = "carom/net/snapshot";

  /** Returns the sources of the product by package, as a path. */
  private static Map<String, List<Path>> sources() {
    return sources(Sources.ROOTS);
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

  @Test
  void packagesSayWhatTheyAreFor() {
    List<String> silent = new ArrayList<>();
    sources()
        .forEach(
            (name, files) -> {
              boolean said = files.stream().anyMatch(f -> f.endsWith("package-info.java"));
              boolean elsewhere =
                  Sources.ROOTS.stream()
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
    List<String> roots = new ArrayList<>(Sources.ROOTS);
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
