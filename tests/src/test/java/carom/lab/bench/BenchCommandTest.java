package carom.lab.bench;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.lab.measure.BenchRow;
import carom.lab.measure.Entrant;
import carom.lab.measure.Times;
import carom.sim.scene.SceneReport;
import carom.sim.scene.Scenes;
import carom.suite.Needs;
import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonToken;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;

/** The benchmark measures, writes what it promises, and refuses what makes no sense. */
@Needs("waits")
class BenchCommandTest {
  /** What programs that read the rows may rely on. */
  private static final List<String> PROMISED =
      List.of(
          "scene",
          "engine",
          "kernels",
          "threads",
          "bodies",
          "medianMs",
          "p99Ms",
          "allocatedBytesPerStep",
          "hash",
          "kineticEnergy",
          "maxPenetration",
          "deepPairs",
          "jointGap",
          "stages",
          "speedUp",
          "ceiling",
          "share",
          "ratios",
          "valid",
          "fault");

  @TempDir private Path directory;

  private final StringWriter out = new StringWriter();
  private final StringWriter err = new StringWriter();

  private int run(String... args) {
    CommandLine line = new CommandLine(new BenchCommand());
    line.setOut(new PrintWriter(out, true)).setErr(new PrintWriter(err, true));
    return line.execute(args);
  }

  /** The fields of an object, those of objects in it with a dotted name; fails on other text. */
  private static Map<String, String> parse(String json) throws IOException {
    Map<String, String> fields = new TreeMap<>();
    List<String> path = new ArrayList<>();
    try (JsonParser in = new JsonFactory().createParser(json)) {
      assertEquals(JsonToken.START_OBJECT, in.nextToken(), json);
      for (JsonToken t = in.nextToken(); t != null; t = in.nextToken()) {
        String name = (path.isEmpty() ? "" : path.get(0) + ".") + in.currentName();
        if (t == JsonToken.START_OBJECT) {
          path.add(in.currentName());
          fields.put(in.currentName(), "{}");
        } else if (t == JsonToken.END_OBJECT && !path.isEmpty()) {
          path.remove(0);
        } else if (t.isScalarValue()) {
          fields.put(name, in.getText());
        }
      }
    }
    return fields;
  }

  @Test
  void sceneGivesOneCompleteRowPerKernelAndNumberOfThreads() throws Exception {
    Path json = directory.resolve("rows.json");
    Path markdown = directory.resolve("rows.md");
    int status =
        run(
            "--quick",
            "--warm-up=0.2",
            "--cap=8",
            "--scenes=gas_1k",
            "--threads=2,1",
            "--json=" + json,
            "--markdown=" + markdown);
    assertEquals(0, status, err.toString());
    List<String> rows = Files.readAllLines(json);
    assertEquals(4, rows.size(), rows.toString());
    String hash = parse(rows.get(0)).get("hash");
    assertTrue(hash.matches("[0-9a-f]{16}"), hash);
    for (String text : rows) {
      Map<String, String> row = parse(text);
      assertTrue(row.keySet().containsAll(PROMISED), text);
      assertEquals("gas_1k", row.get("scene"));
      assertEquals("carom", row.get("engine"));
      assertEquals("1000", row.get("bodies"));
      assertEquals(hash, row.get("hash"), "kernels and threads change no bit");
      assertEquals("", row.get("fault"));
      assertEquals("true", row.get("valid"));
      assertTrue(Double.parseDouble(row.get("medianMs")) > 0, text);
      assertTrue(
          Double.parseDouble(row.get("p99Ms")) >= Double.parseDouble(row.get("medianMs")), text);
      assertTrue(Double.parseDouble(row.get("stages.pairs")) > 0, text);
    }
    assertEquals("1", parse(rows.get(0)).get("threads"));
    assertEquals("null", parse(rows.get(0)).get("share"), "one thread shares nothing");
    assertEquals("2", parse(rows.get(1)).get("threads"));
    assertTrue(Double.parseDouble(parse(rows.get(1)).get("speedUp")) > 0, rows.get(1));
    assertTrue(Double.parseDouble(parse(rows.get(1)).get("ceiling")) > 0, rows.get(1));
    assertTrue(Double.parseDouble(parse(rows.get(1)).get("share")) > 0, rows.get(1));
    assertTrue(out.toString().contains("carom vector x2"), out.toString());
    assertTrue(err.toString().contains("[1/1] gas_1k, carom scalar: "), "progress: " + err);
    assertTrue(Files.readString(markdown).startsWith("| scene"), "markdown");
  }

  /** The other groups of rows, one of each kind. */
  @Test
  void rowsGoToStandardOutputAloneWithoutAFile() throws Exception {
    int status =
        run(
            "--json",
            "--quick",
            "--warm-up=0.1",
            "--cap=2",
            "--scenes=bp_uniform_1k,rebuild_10k,create_10k,pairs_1k");
    assertEquals(0, status, err.toString());
    List<String> rows = out.toString().lines().toList();
    assertEquals(5 + 3 + 2 + 2, rows.size(), out.toString());
    assertEquals("vector", parse(rows.get(8)).get("kernels"));
    assertEquals("scalar", parse(rows.get(9)).get("kernels"));
    for (String text : rows) {
      Map<String, String> row = parse(text);
      assertTrue(row.keySet().containsAll(PROMISED), text);
      assertEquals("", row.get("fault"), text);
      boolean hasWorld = row.get("scene").equals("pairs_1k");
      assertEquals(hasWorld, !row.get("kineticEnergy").equals("null"), text);
      assertEquals(hasWorld, row.containsKey("stages.pairs"), text);
    }
    assertEquals("carom", parse(rows.get(0)).get("engine"));
    for (int i = 1; i < 5; i++) {
      assertEquals(parse(rows.get(0)).get("hash"), parse(rows.get(i)).get("hash"), "same pairs");
    }
    assertTrue(parse(rows.get(0)).containsKey("ratios.lab_pair_cache"), rows.get(0));
    assertTrue(parse(rows.get(0)).containsKey("ratios.brute_force"), rows.get(0));
    assertTrue(err.toString().contains("kd_two_sorts"), "the tables: " + err);
  }

  /**
   * A program that takes two turns, and says so in a row of its own. It reads the scene, and leaves
   * it as it was.
   */
  @Test
  @DisabledOnOs(OS.WINDOWS)
  void programOfAnotherEngineTakesItsTurns() throws Exception {
    Times times = new Times(12, 5, 6, 5, Double.NaN);
    String row = BenchRow.of("gas_1k", Entrant.of("toy"), 1000, times).toJson();
    Path program = directory.resolve("toy.sh");
    Files.writeString(
        program,
        """
        #!/bin/sh
        read turn && echo turn && read turn && test "$1" = gas_1k || exit 1
        awk '$1 == "run" && ($2 != 60 || $3 != 60 || $4 != 60) {exit 1}' "$2" || exit 1
        awk '$1 == "body" {print $3, $4, $5, $6, $7, $8, $9, $11}' "$2" > "$3"
        echo '%s'
        """
            .formatted(row));
    assertTrue(program.toFile().setExecutable(true));
    int status =
        run(
            "--json",
            "--quick",
            "--warm-up=0.1",
            "--cap=8",
            "--kernels=scalar",
            "--threads=1",
            "--peers=none",
            "--scenes=gas_1k",
            "--external=toy=" + program);
    assertEquals(0, status, err.toString());
    Map<String, String> carom = parse(out.toString().lines().findFirst().orElseThrow());
    assertEquals(
        5 / Double.parseDouble(carom.get("medianMs")),
        Double.parseDouble(carom.get("ratios.toy")),
        1e-6);
    assertEquals(2, out.toString().lines().count(), out.toString());
    Map<String, String> toy = parse(out.toString().lines().skip(1).findFirst().orElseThrow());
    assertEquals("1000", toy.get("awake"));
    double begin = SceneReport.of(Scenes.get("gas_1k").start().world()).kineticEnergy();
    assertEquals(begin, Double.parseDouble(toy.get("kineticEnergy")), 1e-6 * begin);
    assertEquals("", toy.get("fault"));
  }

  @Test
  void aSceneIsWrittenWithAllThatOtherEnginesNeed() throws Exception {
    Path folder;
    try (SceneFile file = SceneFile.of(BenchScene.of("joint_grid"))) {
      folder = file.scene().getParent();
      List<String> lines = Files.readAllLines(file.scene());
      assertEquals("run 60 240 60", lines.get(0));
      assertEquals("world 0.0 -10.0 0", lines.get(1));
      assertEquals("body static 47.0 0.0 1.0 0.0 0.0 0.0 0.0 1.0 0", lines.get(2 + 2 * 4700));
      assertEquals("shape 1.0 0.6 0.0 -1 0.4 1 0.0 0.0", lines.get(3 + 2 * 4700));
      assertEquals(19_800, lines.stream().filter(line -> line.startsWith("revolute ")).count());
      assertEquals("revolute 0 1 0.0 -0.5", lines.get(2 + 2 * 10_000));

      Files.writeString(file.poses(), "1 2 3\n");
      BenchRow row =
          BenchRow.of("joint_grid", Entrant.of("toy"), 9993, new Times(1, 1, 1, 1, Double.NaN));
      IOException e = assertThrows(IOException.class, () -> file.judged(row));
      assertTrue(e.getMessage().contains("poses=1, bodies=10000"), e.getMessage());
    }
    assertFalse(Files.exists(folder), "temporary files are deleted");
  }

  @Test
  void badExternalProgramsAreRefused() throws Exception {
    assertEquals(2, run("--external=toy=" + directory.resolve("nowhere")));
    assertTrue(err.toString().contains("can't be run"), err.toString());
    Path program = Files.createFile(directory.resolve("carom"));
    assertTrue(program.toFile().setExecutable(true));
    assertEquals(2, run("--external=carom=" + program));
    assertTrue(err.toString().contains("name=carom is taken"), err.toString());
  }

  @Test
  void badFlagsAreRefusedWithTheNearestName() {
    assertEquals(2, run("--scenes=gas_1q"));
    assertTrue(err.toString().contains("gas_1q") && err.toString().contains("gas_1k"), "" + err);
    assertEquals(2, run("--kernels=quantum"));
    assertEquals(2, run("--warm-up=-1"));
    assertEquals(2, run("--peers=box3d"));
    assertTrue(err.toString().contains("box3d"), err.toString());
    assertEquals(2, run("--threads=0"));
    assertEquals(2, run("--threads=65"));
    assertTrue(err.toString().contains("--threads=65 is outside 1..64"), err.toString());
    assertEquals(2, run("--threads=two"));
  }

  @Test
  void fileThatCannotBeWrittenIsToldBeforeTheWork() {
    assertEquals(1, run("--scenes=gas_1k", "--json=" + directory.resolve("no/such/rows.json")));
    assertFalse(err.toString().contains("[1/1]"), err.toString());
  }
}
