package carom.docs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import carom.suite.Needs;
import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import javax.tools.ToolProvider;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;

/**
 * Goal: strangers test a game of their own with what Carom publishes. Method: Gradle lays out the
 * published jars and POMs and resolves {@code carom-testkit} by them alone; {@code docs/starter} is
 * compiled by the POMs' compile scope and its tests run in a JVM of their own. Without Gradle these
 * tests are skipped.
 */
@Needs("processes")
class StarterTest {
  private static final Path STARTER = Path.of("..", "docs", "starter");
  private static final String GROUP = "io.github.carom-engine";
  private static final int MOST_SECONDS = 900; // takes 5 to 10 on a machine that does nothing else

  private List<String> path; // as Gradle resolved it: jars of Carom, of its libraries and of JUnit
  private Path repository;

  @TempDir Path folder;

  @BeforeEach
  void gradleResolvedIt() {
    String resolved = System.getProperty("carom.starter.path");
    assumeTrue(resolved != null, "carom.starter.path isn't set: run by Gradle");
    path = List.of(resolved.split(File.pathSeparator));
    repository = Path.of(System.getProperty("carom.starter.repository"));
  }

  @Test
  void theStartersTestsPass() throws Exception {
    Path main = compile("src/main/java", compilePath("carom-client-headless"));
    Set<String> testPath = compilePath("carom-testkit");
    path.stream().filter(jar -> jar.matches(".*(junit|apiguardian).*")).forEach(testPath::add);
    testPath.add(main.toString());
    Path test = compile("src/test/java", testPath);

    List<String> run = new ArrayList<>(path);
    run.addAll(List.of(main.toString(), test.toString()));
    run.add(STARTER.resolve("src/main/resources").toString());
    Path output = folder.resolve("output.txt");
    Process jvm =
        new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-Dkryo.unsafe=false",
                "-cp",
                String.join(File.pathSeparator, run),
                "org.junit.platform.console.ConsoleLauncher",
                "execute",
                "--disable-ansi-colors",
                "--scan-classpath",
                test.toString())
            .redirectErrorStream(true)
            .redirectOutput(output.toFile())
            .start();
    try {
      assertTrue(jvm.waitFor(MOST_SECONDS, TimeUnit.SECONDS), () -> text(output));
      assertEquals(0, jvm.exitValue(), () -> text(output));
      assertTrue(text(output).contains("2 tests successful"), text(output));
    } finally {
      jvm.destroyForcibly();
    }
  }

  @Test
  void testsBringNoWindow() {
    List<String> toolkit = path.stream().filter(jar -> jar.matches(".*(gdx|lwjgl).*")).toList();
    assertEquals(List.of(), toolkit);
  }

  @Test
  void whatRunsItIsThatOfTheInstallation() {
    String programs = System.getProperty("carom.starter.programs");
    List<String> names =
        Stream.of(programs.split(File.pathSeparator))
            .map(jar -> Path.of(jar).getFileName().toString())
            .toList();
    assertTrue(
        names.stream().anyMatch(name -> name.matches("gdx-platform-.*-natives-desktop.jar")));
    assertTrue(names.stream().anyMatch(name -> name.startsWith("carom-launcher")), names::toString);
    assertEquals(
        1, names.stream().filter(name -> name.matches("kryo-[0-9].*")).count(), names::toString);
    assertFalse(names.stream().anyMatch(name -> name.contains("jsonbeans")), names::toString);
  }

  /** Compiles one of the starter's folders and returns where the classes are. */
  private Path compile(String sources, Set<String> classPath) throws Exception {
    Path classes = folder.resolve(sources);
    List<String> arguments = new ArrayList<>();
    arguments.addAll(List.of("-proc:none", "-Xlint:all", "-Werror", "-d", classes.toString()));
    arguments.addAll(List.of("-cp", String.join(File.pathSeparator, classPath)));
    try (Stream<Path> files = Files.walk(STARTER.resolve(sources))) {
      files.map(Path::toString).filter(file -> file.endsWith(".java")).forEach(arguments::add);
    }
    ByteArrayOutputStream errors = new ByteArrayOutputStream();
    int status =
        ToolProvider.getSystemJavaCompiler()
            .run(null, null, errors, arguments.toArray(new String[0]));
    assertEquals(0, status, () -> errors.toString(StandardCharsets.UTF_8));
    return classes;
  }

  /** Returns the jars that a dependency on one of Carom's artifacts has the compiler see. */
  private Set<String> compilePath(String artifact) throws Exception {
    Set<String> jars = new LinkedHashSet<>();
    addCompilePath(artifact, jars);
    return jars;
  }

  private void addCompilePath(String artifact, Set<String> jars) throws Exception {
    Path pom;
    try (Stream<Path> files =
        Files.walk(repository.resolve(GROUP.replace('.', '/')).resolve(artifact))) {
      pom = files.filter(file -> file.toString().endsWith(".pom")).findFirst().orElseThrow();
    }
    jars.add(pom.toString().replaceFirst("pom$", "jar"));
    NodeList dependencies =
        DocumentBuilderFactory.newInstance()
            .newDocumentBuilder()
            .parse(pom.toFile())
            .getElementsByTagName("dependency");
    for (int i = 0; i < dependencies.getLength(); i++) {
      Element dependency = (Element) dependencies.item(i);
      if (!value(dependency, "scope").equals("compile")) {
        continue;
      }
      if (value(dependency, "groupId").equals(GROUP)) {
        addCompilePath(value(dependency, "artifactId"), jars);
      } else {
        String name = value(dependency, "artifactId") + "-" + value(dependency, "version") + ".jar";
        jars.add(path.stream().filter(jar -> jar.endsWith(name)).findFirst().orElseThrow());
      }
    }
  }

  private static String value(Element element, String tag) {
    return element.getElementsByTagName(tag).item(0).getTextContent();
  }

  private static String text(Path file) {
    try {
      return Files.readString(file);
    } catch (IOException e) {
      return e.toString();
    }
  }
}
