package carom.physics;

import static java.util.stream.Collectors.toSet;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import carom.suite.Needs;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.lang.module.ModuleDescriptor;
import java.lang.module.ModuleFinder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.spi.ToolProvider;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * The engine's jar as a module, used by a consumer that is a module, too. Gradle makes the jar and
 * says where it is; without Gradle these tests are skipped.
 */
@Needs("processes")
class ModulePathTest {
  private static final String CONSUMER =
      """
      package consumer;

      import carom.physics.BodyDef;
      import carom.physics.BodyType;
      import carom.physics.World;
      import carom.physics.WorldDef;
      import carom.physics.geometry.Box;
      import carom.physics.mover.Mover;
      import carom.physics.mover.MoverDef;

      public final class Main {
        public static void main(String[] args) {
          WorldDef constants = new WorldDef().withSleeping(false);
          if (constants.gravityY() != -10) { // declared by a class that WorldDef extends
            throw new AssertionError(constants.gravityY());
          }
          World<String> world = new World<>(constants);
          world.createBody(new BodyDef().position(0, -1).shape(new Box(50, 1)), "ground");
          for (int i = 0; i < 600; i++) {
            BodyDef def = new BodyDef(BodyType.DYNAMIC).position(i % 40 - 20, .6f + i / 40);
            world.createBody(def.shape(new Box(.45f, .45f)), "box");
          }
          for (int tick = 0; tick < 60; tick++) {
            world.step(1 / 60f);
          }
          Mover<String> mover = new Mover<>(world, new MoverDef<String>(1.8f, .3f));
          mover.setPosition(-30, 1);
          mover.move(3, -10, 1 / 60f);
          if (!mover.isOnGround()) {
            throw new AssertionError(mover.y());
          }
          System.out.println(World.class.getModule().getName());
          System.out.println(kernels());
          System.out.println(Long.toHexString(world.stateHash()));
        }

        private static String kernels() {
          try {
            Class.forName("carom.physics.dynamics.simd.VectorColumnHash");
            return "vectors";
          } catch (ClassNotFoundException | LinkageError e) {
            return "scalar";
          }
        }
      }
      """;

  @TempDir Path folder;

  private String jar;

  @BeforeEach
  void findTheJar() {
    jar = System.getProperty("carom.physicsJar");
    assumeTrue(jar != null, "run by Gradle, which makes the jar");
    assertTrue(Files.exists(Path.of(jar)), jar);
  }

  /** Compiles a consumer, and returns what the compiler says, "" if all is well. */
  private String compile(String source) throws IOException {
    Path module = folder.resolve("module-info.java");
    Path main = folder.resolve("Main.java");
    Files.writeString(module, "module consumer {\n  requires carom.physics;\n}\n");
    Files.writeString(main, source);
    StringWriter said = new StringWriter();
    PrintWriter to = new PrintWriter(said);
    int status =
        ToolProvider.findFirst("javac")
            .orElseThrow()
            .run(
                to,
                to,
                "-p",
                jar,
                "-d",
                folder.resolve("out").toString(),
                module.toString(),
                main.toString());
    return status == 0 ? "" : said.toString();
  }

  /** Runs a JVM, and returns its lines. */
  private List<String> run(String... arguments) throws Exception {
    Path java = Path.of(System.getProperty("java.home"), "bin", "java");
    List<String> command = new ArrayList<>(List.of(java.toString()));
    command.addAll(List.of(arguments));
    Path errors = folder.resolve("errors.txt");
    Process child = new ProcessBuilder(command).redirectError(errors.toFile()).start();
    String said = new String(child.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(0, child.waitFor(), () -> said + errors);
    return said.lines().toList();
  }

  @Test
  void aModuleStepsAWorldWithTheHashOfTheClassPath() throws Exception {
    assertEquals("", compile(CONSUMER));
    String out = folder.resolve("out").toString();
    String path = jar + System.getProperty("path.separator") + out;
    List<String> plain = run("-p", path, "-m", "consumer/consumer.Main");
    assertEquals(List.of("carom.physics", "scalar"), plain.subList(0, 2));
    List<String> vectors =
        run("--add-modules", "jdk.incubator.vector", "-p", path, "-m", "consumer/consumer.Main");
    assertEquals("carom.physics", vectors.get(0));
    assertEquals(kernelsHere(), vectors.get(1));
    List<String> classPath = run("-cp", path, "consumer.Main");
    assertEquals("null", classPath.get(0));
    assertEquals(plain.get(2), vectors.get(2));
    assertEquals(plain.get(2), classPath.get(2));
  }

  /** What this processor's vectors are good for: tests run with the vector module, too. */
  private static String kernelsHere() {
    try {
      Class.forName("carom.physics.dynamics.simd.VectorColumnHash");
      return "vectors";
    } catch (ClassNotFoundException | LinkageError e) {
      return "scalar";
    }
  }

  /** All packages are for users, but the step, its kernels and how outlines are cut. */
  @Test
  void modulesSeeEveryPackageThatIsForUsers() {
    ModuleDescriptor module =
        ModuleFinder.of(Path.of(jar)).find("carom.physics").orElseThrow().descriptor();
    Set<String> exported =
        module.exports().stream().map(ModuleDescriptor.Exports::source).collect(toSet());
    Set<String> forUsers = new TreeSet<>(module.packages());
    forUsers.removeIf(
        name -> name.matches("carom\\.physics\\.(dynamics|simd|geometry\\.outline)(\\..*)?"));
    assertEquals(forUsers, new TreeSet<>(exported));
    assertTrue(exported.contains("carom.physics.mover"), exported.toString());
  }

  @Test
  void whatTheEngineIsMadeOfIsHiddenFromModules() throws Exception {
    String world = "import carom.physics.World;";
    String inside = CONSUMER.replace(world, world + "\nimport carom.physics.dynamics.Dynamics;");
    assertNotEquals(CONSUMER, inside);
    String said = compile(inside);
    assertTrue(said.contains("carom.physics.dynamics"), said);
    assertTrue(said.contains("export"), said);
  }
}
