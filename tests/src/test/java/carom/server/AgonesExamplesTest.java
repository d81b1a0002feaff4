package carom.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/**
 * Goal: the examples are what Agones takes. Method: each field of theirs stands in a table of those
 * that the custom resource definitions of Agones have, with its values; what is required is there.
 */
final class AgonesExamplesTest {
  private static final Path FOLDER = Path.of("..", "docs", "server", "agones");
  private static final String NUMBER = "\\d+";
  private static final String NAME = "[a-z0-9]([-a-z0-9]*[a-z0-9])?";
  private static final String TEXT = ".+";
  private static final Pattern LINE = Pattern.compile("( *)(- )?(?:([-\\w./]+):(?: (.*))?|(.*))");

  /** Parts of the schemas that the examples use; {@code *} stands for a name of one's own. */
  private static final Map<String, Map<String, String>> SCHEMAS =
      Map.of(
          "Fleet",
          fields(
              "apiVersion! agones\\.dev/v1",
              "kind! Fleet",
              "metadata.name! " + NAME,
              "spec.replicas " + NUMBER,
              "spec.scheduling Packed|Distributed",
              "spec.strategy.type Recreate|RollingUpdate",
              "spec.strategy.rollingUpdate.maxSurge \\d+%?",
              "spec.strategy.rollingUpdate.maxUnavailable \\d+%?",
              "spec.allocationOverflow.labels.* " + TEXT,
              "spec.template.metadata.labels.* " + TEXT,
              "spec.template.spec.container " + NAME,
              "spec.template.spec.ports[].name " + TEXT,
              "spec.template.spec.ports[].portPolicy Dynamic|Static|Passthrough|None",
              "spec.template.spec.ports[].protocol UDP|TCP|TCPUDP",
              "spec.template.spec.ports[].containerPort " + NUMBER,
              "spec.template.spec.ports[].hostPort " + NUMBER,
              "spec.template.spec.health.disabled true|false",
              "spec.template.spec.health.initialDelaySeconds " + NUMBER,
              "spec.template.spec.health.periodSeconds " + NUMBER,
              "spec.template.spec.health.failureThreshold [1-9]\\d*",
              "spec.template.spec.counters.*.count " + NUMBER,
              "spec.template.spec.counters.*.capacity " + NUMBER,
              "spec.template.spec.lists.*.capacity \\d{1,3}|1000",
              "spec.template.spec.lists.*.values \\[\\]",
              "spec.template.spec.template.spec.terminationGracePeriodSeconds " + NUMBER,
              "spec.template.spec.template.spec.containers[].name! " + NAME,
              "spec.template.spec.template.spec.containers[].image! " + TEXT,
              "spec.template.spec.template.spec.containers[].args[] " + TEXT,
              "spec.template.spec.template.spec.containers[].env[].name " + TEXT,
              "spec.template.spec.template.spec.containers[].env[].value " + TEXT,
              "spec.template.spec.template.spec.containers[].volumeMounts[].name " + NAME,
              "spec.template.spec.template.spec.containers[].volumeMounts[].mountPath /.*",
              "spec.template.spec.template.spec.containers[].volumeMounts[].readOnly true|false",
              "spec.template.spec.template.spec.volumes[].name " + NAME,
              "spec.template.spec.template.spec.volumes[].secret.secretName " + NAME,
              "spec.template.spec.template.spec.volumes[].emptyDir \\{\\}"),
          "FleetAutoscaler",
          fields(
              "apiVersion! autoscaling\\.agones\\.dev/v1",
              "kind! FleetAutoscaler",
              "metadata.name! " + NAME,
              "spec.fleetName! " + NAME,
              "spec.policy.type! Buffer|Webhook|Counter|List|Chain",
              "spec.policy.counter.key! " + TEXT,
              "spec.policy.counter.bufferSize! \\d+%?",
              "spec.policy.counter.minCapacity " + NUMBER,
              "spec.policy.counter.maxCapacity! [1-9]\\d*"),
          "GameServerAllocation",
          fields(
              "apiVersion! allocation\\.agones\\.dev/v1",
              "kind! GameServerAllocation",
              "spec.scheduling Packed|Distributed",
              "spec.priorities[].type Counter|List",
              "spec.priorities[].key " + TEXT,
              "spec.priorities[].order Ascending|Descending",
              "spec.selectors[].gameServerState Ready|Allocated",
              "spec.selectors[].matchLabels.* " + TEXT,
              "spec.selectors[].counters.*.minAvailable " + NUMBER,
              "spec.selectors[].counters.*.maxAvailable " + NUMBER));

  private static Map<String, String> fields(String... rows) {
    Map<String, String> fields = new TreeMap<>();
    for (String row : rows) {
      fields.put(row.substring(0, row.indexOf(' ')), row.substring(row.indexOf(' ') + 1));
    }
    return fields;
  }

  /** A level of a document: how far it is indented, and its path. */
  private record Level(int indent, String path) {}

  /**
   * Reads a document of block style and returns its leaves: paths and values. It refuses all of
   * YAML that the examples don't need.
   */
  private static List<String[]> leaves(String text) {
    List<String[]> leaves = new ArrayList<>();
    Deque<Level> levels = new ArrayDeque<>();
    levels.push(new Level(-1, ""));
    for (String line : text.split("\n")) {
      if (line.isBlank() || line.strip().startsWith("#")) {
        continue;
      }
      assertFalse(line.contains("\t") || line.contains(" #"), line);
      Matcher parts = LINE.matcher(line);
      assertTrue(parts.matches(), line);
      int indent = parts.group(1).length();
      boolean isItem = parts.group(2) != null;
      while (levels.peek().indent() >= indent) {
        levels.pop();
      }
      if (isItem) {
        levels.push(new Level(indent, levels.peek().path() + "[]"));
        indent += 2;
      }
      String path = levels.peek().path();
      String value = parts.group(4);
      if (parts.group(3) == null) {
        assertTrue(isItem, line);
        value = parts.group(5);
      } else {
        String key = parts.group(3).replace(".", "'"); // no path has a label's dot
        path = path.isEmpty() ? key : path + "." + key;
      }
      if (value == null) {
        levels.push(new Level(indent, path));
      } else {
        leaves.add(new String[] {path, value.replaceAll("^\"(.*)\"$", "$1"), line});
      }
    }
    return leaves;
  }

  private static Map<String, List<String>> check(String file) throws IOException {
    List<String[]> leaves = leaves(Files.readString(FOLDER.resolve(file)));
    String kind =
        leaves.stream().filter(leaf -> leaf[0].equals("kind")).findFirst().orElseThrow()[1];
    Map<String, String> schema = SCHEMAS.get(kind);
    Map<String, List<String>> values = new TreeMap<>();
    for (String[] leaf : leaves) {
      String row = null;
      for (String field : schema.keySet()) {
        String pattern =
            field
                .replace("!", "")
                .replace(".", "\\.")
                .replace("[]", "\\[\\]")
                .replace("*", "[^.\\[]+");
        row = leaf[0].matches(pattern) ? field : row;
      }
      assertTrue(row != null, () -> file + ": " + kind + " has no " + leaf[0]);
      assertTrue(leaf[1].matches(schema.get(row)), () -> file + ": " + leaf[2]);
      if (leaf[0].contains("abels.")) { // Kubernetes takes texts only, not true or 1
        assertTrue(!leaf[1].matches("true|false|\\d+") || leaf[2].endsWith("\""), leaf[2]);
      }
      values.computeIfAbsent(row, key -> new ArrayList<>()).add(leaf[1]);
    }
    for (String field : schema.keySet()) {
      assertTrue(!field.endsWith("!") || values.containsKey(field), () -> file + " lacks " + field);
    }
    return values;
  }

  @Test
  void theExamplesAreWhatAgonesTakes() throws Exception {
    Map<String, List<String>> fleet = check("fleet.yaml");
    Map<String, List<String>> scaler = check("fleetautoscaler.yaml");
    Map<String, List<String>> allocation = check("gameserverallocation.yaml");
    assertEquals(fleet.get("metadata.name!"), scaler.get("spec.fleetName!"));
    assertTrue(allocation.get("spec.selectors[].matchLabels.*").contains("carom"));
    assertEquals(
        List.of(GameServer.TCP, GameServer.UDP, GameServer.FLEET),
        fleet.get("spec.template.spec.ports[].name"),
        "the names that the server looks for");
    assertEquals(List.of("true"), fleet.get("spec.allocationOverflow.labels.*"));
    assertTrue(
        Files.readString(FOLDER.resolve("fleet.yaml"))
            .contains(AgonesService.SUPERSEDED + ": \"true\""));
    try (var files = Files.list(FOLDER)) {
      assertEquals(3, new TreeSet<>(files.toList()).size(), "each example is looked at");
    }
  }
}
