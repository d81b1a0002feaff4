package carom.docs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: the Java that the engine's pages show compiles. Method: each example becomes a method of
 * one class, whose fields are the names that examples take for granted.
 */
final class EngineExamplesTest {
  private static final List<String> PAGES =
      List.of("ALONE.md", "PHYSICS.md", "SHAPES.md", "JOINTS.md", "EVENTS.md", "MOVER.md");

  private static final Pattern EXAMPLE = Pattern.compile("```java\n(.*?)```", Pattern.DOTALL);

  private static final String HEAD =
      """
      import carom.physics.*;
      import carom.physics.archive.*;
      import carom.physics.effects.*;
      import carom.physics.geometry.*;
      import carom.physics.math.*;
      import carom.physics.mover.*;
      import carom.physics.settings.*;
      import carom.physics.threads.*;
      import carom.sim.*;
      import carom.sim.entity.*;
      import java.util.List;
      abstract class Examples {
        World<String> world;
        Body<String> ball, car, crate, ground, lift, own, rock, wheel;
        EventLists<String> events;
        Mover<String> mover;
        Material grass, ice;
        SetUp setUp;
        Simulation s;
        EntityMover walker;
        Player p;
        Input in;
        int tick;
        float dt, walk;
        boolean jumps;
        static final int PLATFORM = 1;
        abstract void play(String sound, float loudness);
        abstract boolean areAllies(String a, String b);
        abstract boolean isWet(float x, float y);
      """;

  @Test
  void everyExampleCompiles(@TempDir Path folder) throws IOException {
    StringBuilder source = new StringBuilder(HEAD);
    int examples = 0;
    for (String page : PAGES) {
      Matcher example = EXAMPLE.matcher(Files.readString(Path.of("..", "docs", "engine", page)));
      while (example.find()) {
        String name = page.replace(".md", "") + examples++;
        source.append("  void ").append(name).append("() {\n").append(example.group(1));
        source.append("  }\n");
      }
    }
    source.append("}\n");
    Path file = folder.resolve("Examples.java");
    Files.writeString(file, source);
    ByteArrayOutputStream errors = new ByteArrayOutputStream();
    int status =
        ToolProvider.getSystemJavaCompiler()
            .run(
                null,
                null,
                errors,
                "-proc:none",
                "-cp",
                System.getProperty("java.class.path"),
                file.toString());
    assertEquals(0, status, () -> errors.toString(StandardCharsets.UTF_8));
    assertTrue(examples >= 20, "examples=" + examples);
  }
}
