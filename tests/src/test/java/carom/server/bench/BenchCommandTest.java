package carom.server.bench;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;

/** The benchmark measures, writes what it promises, and refuses what makes no sense. */
class BenchCommandTest {
  @TempDir private Path directory;

  private final StringWriter out = new StringWriter();
  private final StringWriter err = new StringWriter();

  private int run(String... args) {
    CommandLine line = new CommandLine(new BenchCommand());
    line.setOut(new PrintWriter(out, true)).setErr(new PrintWriter(err, true));
    return line.execute(args);
  }

  @Test
  void smallSceneGivesOneCompleteRowPerKernel() throws Exception {
    Path json = directory.resolve("rows.json");
    Path markdown = directory.resolve("rows.md");
    int status =
        run(
            "--quick",
            "--warm-up=0.2",
            "--cap=1",
            "--scenes=gas_1k",
            "--json=" + json,
            "--markdown=" + markdown);
    assertEquals(0, status, err.toString());
    List<String> rows = Files.readAllLines(json);
    assertEquals(2, rows.size(), rows.toString());
    for (String field :
        List.of(
            "scene",
            "engine",
            "bodies",
            "medianMs",
            "p99Ms",
            "allocatedBytesPerStep",
            "hash",
            "kineticEnergy",
            "maxPenetration",
            "deepPairs")) {
      for (String row : rows) {
        assertTrue(row.contains("\"" + field + "\":"), field + " in " + row);
      }
    }
    assertEquals(hash(rows.get(0)), hash(rows.get(1)), "vector and scalar");
    assertTrue(out.toString().contains("gas_1k"), out.toString());
    assertTrue(Files.readString(markdown).startsWith("| scene"), "markdown");
  }

  private static String hash(String row) {
    return row.replaceAll(".*\"hash\":\"([0-9a-f]+)\".*", "$1");
  }

  @Test
  void badFlagsAreRefusedWithTheNearestName() {
    assertEquals(2, run("--scenes=gas_1q"));
    assertTrue(err.toString().contains("gas_1q") && err.toString().contains("gas_1k"), "" + err);
    assertEquals(2, run("--kernels=quantum"));
    assertEquals(2, run("--warm-up=-1"));
    assertEquals(2, run("--peers=box3d"));
  }
}
