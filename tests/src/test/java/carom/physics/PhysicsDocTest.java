package carom.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.settings.Constant;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/** {@code docs/engine/PHYSICS.md} names every constant of a world with its default. */
class PhysicsDocTest {
  @Test
  void constantsAreThoseOfTheCode() throws Exception {
    List<String> expected = new ArrayList<>();
    WorldDef def = new WorldDef();
    for (Constant constant : Constant.values()) {
      String name = constant.label();
      String value = String.valueOf(WorldDef.class.getMethod(name).invoke(def));
      expected.add(name + " = " + (value.endsWith(".0") ? value.replace(".0", "") : value));
    }
    List<String> actual = new ArrayList<>();
    boolean inTable = false;
    for (String line : Files.readAllLines(page())) {
      inTable = line.startsWith("| constant |") || (inTable && line.startsWith("|"));
      String[] cells = line.split("\\|");
      if (inTable && line.startsWith("| `")) {
        actual.add(cells[1].replace("`", "").trim() + " = " + cells[2].trim());
      }
    }
    assertEquals(expected, actual);
  }

  /** Goal: who reads a method of {@code WorldDef} sees the range that the row has. */
  @Test
  void methodsSayTheRangesOfTheRows() throws Exception {
    String source =
        Files.readString(
            page()
                .resolve("../../../shared/src/main/java/carom/physics/WorldDef.java")
                .normalize());
    int ranges = 0;
    for (Constant constant : Constant.values()) {
      Class<?> type = WorldDef.class.getMethod(constant.label()).getReturnType();
      if (type == boolean.class || type.isEnum()) {
        continue; // has no range
      }
      Matcher said =
          Pattern.compile(
                  "#" + constant.name() + "}[^.]*?(-?[\\d.e-]+?)\\.\\.([\\de]+)", Pattern.DOTALL)
              .matcher(source);
      assertTrue(said.find(), constant.name());
      assertEquals(constant.min(), Float.parseFloat(said.group(1)), constant.name());
      assertEquals(constant.max(), Float.parseFloat(said.group(2)), constant.name());
      ranges++;
    }
    assertTrue(ranges > 15, "ranges=" + ranges);
  }

  private static Path page() {
    Path directory = Path.of("").toAbsolutePath();
    while (!Files.exists(directory.resolve("docs/engine/PHYSICS.md"))) {
      directory = directory.getParent();
    }
    return directory.resolve("docs/engine/PHYSICS.md");
  }
}
