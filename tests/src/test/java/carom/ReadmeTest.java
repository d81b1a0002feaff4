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
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Goal: what README shows works. Method: its example is compiled and run. */
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

  /** The folder with README.md, from wherever the tests are started. */
  private static Path root() {
    File folder = new File("").getAbsoluteFile();
    while (!new File(folder, "README.md").exists()) {
      folder = folder.getParentFile();
    }
    return folder.toPath();
  }
}
