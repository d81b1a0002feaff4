package carom.docs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;

/**
 * Goal: the figures of the engine's pages are those that {@link PhysicsDrawings} draws. With {@code
 * -Dcarom.renew=true} the test writes them.
 */
final class PhysicsDrawingsTest {
  private static final int MAX_BYTES = 20_000;

  private static Path docs() {
    Path directory = Path.of("").toAbsolutePath();
    while (!Files.exists(directory.resolve("docs/engine/PHYSICS.md"))) {
      directory = directory.getParent();
    }
    return directory.resolve("docs");
  }

  @Test
  void thePagesShowEveryFigureAsItIsDrawn() throws IOException {
    String pages = "";
    for (String page : new String[] {"PHYSICS.md", "SHAPES.md", "JOINTS.md", "MOVER.md"}) {
      pages += Files.readString(docs().resolve("engine").resolve(page));
    }
    for (Map.Entry<String, String> figure : PhysicsDrawings.all().entrySet()) {
      Path file = docs().resolve("images").resolve(figure.getKey());
      if (Boolean.getBoolean("carom.renew")) {
        Files.writeString(file, figure.getValue());
      }
      assertEquals(Files.readString(file), figure.getValue(), figure.getKey());
      assertTrue(figure.getValue().length() < MAX_BYTES, figure.getKey());
      assertTrue(pages.contains("images/" + figure.getKey()), figure.getKey());
    }
  }
}
