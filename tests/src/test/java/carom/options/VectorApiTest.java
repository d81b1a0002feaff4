package carom.options;

import static org.junit.jupiter.api.Assertions.assertEquals;

import carom.physics.simd.VectorModule;
import carom.suite.Needs;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Goal: programs have the Vector API without a warning. Method: processes of their own. */
@Needs("processes")
class VectorApiTest {
  /** Prints whether the module is loaded, and whether a class that needs it works. */
  static final class Program {
    private Program() {}

    public static void main(String[] args) {
      boolean loaded = VectorApi.load();
      loaded &= VectorApi.load(); // the second time is no error
      Object user = VectorModule.find("carom.physics.simd.VectorWidth", Object.class);
      System.out.println(loaded + " " + (user != null));
    }
  }

  private static String run(String... jvmFlags) throws Exception {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(List.of(jvmFlags));
    command.addAll(List.of("-cp", System.getProperty("java.class.path"), Program.class.getName()));
    Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
    String text = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(0, process.waitFor(), text);
    return text.strip();
  }

  @Test
  void theModuleIsLoadedWithoutAWarning() throws Exception {
    assertEquals("true true", run("--add-exports", "java.base/jdk.internal.module=ALL-UNNAMED"));
  }

  @Test
  void withoutTheFlagTheProgramRunsOnScalarKernels() throws Exception {
    assertEquals("false false", run());
  }
}
