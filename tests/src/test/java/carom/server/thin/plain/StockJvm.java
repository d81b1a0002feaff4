package carom.server.thin.plain;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import carom.outside.LaterJvms;
import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.tools.ToolProvider;

/**
 * Programs with the real KryoNet 2.22.0-RC1, its Kryo 2.24.0 and carom-plain, and nothing else of
 * Carom: compiled as Java 8, each in a process of its own. Without Gradle, which resolves these
 * jars, tests are skipped.
 */
final class StockJvm {
  private static final Path RESOURCES = Path.of("src", "test", "resources", "carom", "stock");

  private final Path classes;
  private final String classPath;

  /** Compiles programs of the tests' resources, or files. */
  StockJvm(Path folder, Path... sources) throws IOException {
    String stock = System.getProperty("carom.plain.path");
    assumeTrue(stock != null, "carom.plain.path isn't set: run by Gradle");
    classes = Files.createDirectories(folder.resolve("classes"));
    classPath = stock + File.pathSeparator + classes;
    List<String> arguments =
        new ArrayList<>(List.of("--release", "8", "-Xlint:all,-options", "-Werror", "-proc:none"));
    arguments.addAll(List.of("-cp", stock, "-d", classes.toString()));
    for (Path source : sources) {
      arguments.add(source.toString());
    }
    ByteArrayOutputStream said = new ByteArrayOutputStream();
    int status =
        ToolProvider.getSystemJavaCompiler()
            .run(null, null, said, arguments.toArray(new String[0]));
    assertEquals(0, status, () -> said.toString(StandardCharsets.UTF_8));
  }

  /** Returns a program of the tests' resources. */
  static Path resource(String name) {
    return RESOURCES.resolve(name);
  }

  /** Returns the JVM of the tests, and a later one if this machine has any. */
  static List<Path> homes() throws IOException {
    List<Path> homes = new ArrayList<>();
    homes.add(Path.of(System.getProperty("java.home")));
    homes.addAll(LaterJvms.homes());
    return homes;
  }

  /** Prepares to start a program. */
  ProcessBuilder program(Path home, String main, String... arguments) {
    List<String> command = new ArrayList<>();
    command.add(home.resolve("bin").resolve("java").toString());
    command.addAll(List.of("-Xmx64m", "-XX:+UseSerialGC", "-cp", classPath, main));
    command.addAll(List.of(arguments));
    return new ProcessBuilder(command);
  }
}
