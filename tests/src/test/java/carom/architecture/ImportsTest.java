package carom.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.lab.house.Sources;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;

/**
 * Holds the imports to the plan of {@link ArchitectureTest}, which reads class files: an import
 * that only Javadoc needs shows in a picture drawn from the sources, and in no class file.
 */
final class ImportsTest {
  private static Sources read() throws IOException {
    return Sources.read(Path.of(".."));
  }

  @Test
  void importsFormNoCircles() throws IOException {
    assertEquals(List.of(), read().circles(), "write {@code Name} or {@link its.package.Name}");
  }

  @Test
  void importsKeepToThePlan() throws IOException {
    List<String> found = new ArrayList<>();
    int arrows = 0;
    for (Map.Entry<String, Set<String>> entry : read().uses().entrySet()) {
      String from = entry.getKey();
      for (String to : entry.getValue()) {
        arrows++;
        if (!ArchitectureTest.isAllowed(from, to)) {
          found.add(from + " -> " + to);
        }
      }
    }
    assertEquals(List.of(), found);
    assertTrue(arrows > 500, "arrows=" + arrows);
  }

  @Test
  void aCircleIsFound() {
    Map<String, Set<String>> uses = new TreeMap<>();
    uses.put("a", Set.of("b"));
    uses.put("b", Set.of("c", "d"));
    uses.put("c", Set.of("a"));
    uses.put("d", Set.of());
    assertEquals(List.of(Set.of("a", "b", "c")), Sources.circles(uses));
  }
}
