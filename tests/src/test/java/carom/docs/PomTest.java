package carom.docs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.w3c.dom.Element;
import org.w3c.dom.Node;
import org.w3c.dom.NodeList;

/**
 * Goal: a central repository takes what Carom publishes, and builds get what they need and no more.
 * Method: the POMs and Gradle's module metadata that Gradle has laid out for the tests. Without
 * Gradle these tests are skipped.
 */
final class PomTest {
  private static final String GROUP = "io.github.carom-engine";
  private static final String BOM = "carom-bom";

  private Path artifacts;

  @BeforeEach
  void gradleLaidThemOut() {
    String repository = System.getProperty("carom.starter.repository");
    assumeTrue(repository != null, "carom.starter.repository isn't set: run by Gradle");
    artifacts = Path.of(repository, GROUP.split("[.]"));
  }

  private Set<String> names() throws IOException {
    Set<String> names = new TreeSet<>();
    try (Stream<Path> folders = Files.list(artifacts)) {
      folders.forEach(folder -> names.add(folder.getFileName().toString()));
    }
    return names;
  }

  private Path file(String artifact, String ending) throws IOException {
    try (Stream<Path> files = Files.walk(artifacts.resolve(artifact))) {
      return files.filter(file -> file.toString().endsWith(ending)).findFirst().orElseThrow();
    }
  }

  private Element pom(String artifact) throws Exception {
    return DocumentBuilderFactory.newInstance()
        .newDocumentBuilder()
        .parse(file(artifact, ".pom").toFile())
        .getDocumentElement();
  }

  /** Returns the text at a path of elements, each the first child of its name; empty if none. */
  private static String value(Element from, String path) {
    Element at = from;
    for (String name : path.split("/")) {
      Element found = null;
      for (Node child = at.getFirstChild(); child != null; child = child.getNextSibling()) {
        if (found == null && child instanceof Element element && name.equals(child.getNodeName())) {
          found = element;
        }
      }
      if (found == null) {
        return "";
      }
      at = found;
    }
    return at.getTextContent().trim();
  }

  private static List<String> dependencies(Element pom) {
    List<String> all = new ArrayList<>();
    NodeList nodes = pom.getElementsByTagName("dependency");
    for (int i = 0; i < nodes.getLength(); i++) {
      Element dependency = (Element) nodes.item(i);
      all.add(value(dependency, "groupId") + ":" + value(dependency, "artifactId"));
    }
    return all;
  }

  @Test
  void everyPomHasWhatCentralRepositoriesDemand() throws Exception {
    Set<String> names = names();
    assertEquals(9, names.size(), names::toString);
    for (String artifact : names) {
      Element pom = pom(artifact);
      assertEquals(GROUP, value(pom, "groupId"), artifact);
      assertEquals(artifact, value(pom, "artifactId"));
      for (String path :
          List.of(
              "name",
              "description",
              "url",
              "licenses/license/name",
              "licenses/license/url",
              "developers/developer/name",
              "scm/connection",
              "scm/developerConnection",
              "scm/url")) {
        assertFalse(value(pom, path).isEmpty(), artifact + " lacks " + path);
      }
    }
  }

  @Test
  void theBomHasEveryOtherArtifactAndTheirVersion() throws Exception {
    Element bom = pom(BOM);
    Set<String> all = new TreeSet<>();
    dependencies(bom).forEach(one -> all.add(one.replace(GROUP + ":", "")));
    Set<String> others = names();
    others.remove(BOM);
    assertEquals(others, all);
    assertEquals("pom", value(bom, "packaging"));
    String version = value(bom, "version");
    assertEquals(version, value(bom, "dependencyManagement/dependencies/dependency/version"));
    String starter = Files.readString(Path.of("..", "docs", "starter", "build.gradle"));
    assertTrue(starter.contains("carom = '" + version + "'"), "docs/starter has another version");
  }

  @Test
  void onlyTheWindowBringsAToolkit() throws Exception {
    for (String artifact : names()) {
      boolean brings = dependencies(pom(artifact)).stream().anyMatch(one -> one.contains("gdx"));
      assertEquals(artifact.equals("carom-client"), brings, artifact);
    }
    assertTrue(dependencies(pom("carom-client")).contains(GROUP + ":carom-client-headless"));
    assertTrue(dependencies(pom("carom-testkit")).contains(GROUP + ":carom-client-headless"));
    assertFalse(dependencies(pom("carom-testkit")).contains(GROUP + ":carom-client"));
  }

  @Test
  void moduleMetadataTellsTheSameDependencies() throws Exception {
    for (String artifact : names()) {
      if (artifact.equals(BOM)) {
        continue;
      }
      String pom = Files.readString(file(artifact, ".pom"));
      assertTrue(pom.contains("<!-- do_not_remove: published-with-gradle-metadata -->"), artifact);
      String module = Files.readString(file(artifact, ".module"));
      assertTrue(module.contains("\"formatVersion\": \"1.1\""), artifact);
      for (String dependency : dependencies(pom(artifact))) {
        String name = "\"module\": \"" + dependency.replaceFirst(".*:", "") + "\"";
        assertTrue(module.contains(name), artifact + ": " + dependency);
      }
    }
  }
}
