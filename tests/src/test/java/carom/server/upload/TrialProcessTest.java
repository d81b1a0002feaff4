package carom.server.upload;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.sim.level.Level;
import carom.suite.Needs;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Goal: no level of a player harms the server. Method: the real process, hostile levels. */
@Needs("processes")
final class TrialProcessTest {
  private static final Duration BUDGET = Duration.ofSeconds(20);

  @TempDir private Path folder;

  private TrialProcess.Verdict judge(byte[] level, Duration budget) throws Exception {
    Path file = folder.resolve("level");
    Files.write(file, level);
    return new TrialProcess(budget).judge(file, folder.resolve("verdict"));
  }

  private String problem(String level) throws Exception {
    TrialProcess.Verdict v = judge(level.getBytes(StandardCharsets.UTF_8), BUDGET);
    assertEquals("", v.name());
    return String.join("\n", v.problems());
  }

  private static String arena(String extra) {
    return """
    {"game": "arena", "name": "Mine", "gravity": [0, 0], "bounds": {"min": [-20, -10], "max": [20, 10]},
     "spawns": [{"name": "player", "at": [-5, 0], "team": 0},
                {"name": "player", "at": [5, 0], "team": 1}, {"name": "ball", "at": [0, 0]}]%s}
    """
        .formatted(extra);
  }

  @Test
  void aGoodLevelIsGood() throws Exception {
    TrialProcess.Verdict v = judge(Level.builtIn("platformer").source(), BUDGET);
    assertEquals(List.of(), v.problems());
    assertEquals("platformer", v.game());
    assertEquals(Level.builtIn("platformer").name(), v.name());
  }

  @Test
  void garbageAndDepthAreNamed() throws Exception {
    byte[] garbage = new byte[5_000];
    long seed = System.nanoTime();
    System.out.println("garbage: seed=" + seed);
    new Random(seed).nextBytes(garbage);
    assertTrue(judge(garbage, BUDGET).problems().get(0).startsWith("level"));
    assertTrue(problem("[".repeat(100_000)).contains("level"));
    assertTrue(problem("{\"game\": \"/etc/passwd\", \"name\": \"x\"}").startsWith("level"));
  }

  @Test
  void limitsAreSaidWithWhatIsThere() throws Exception {
    StringBuilder bodies = new StringBuilder(", \"bodies\": [");
    for (int i = 0; i < LevelTrial.MAX_BODIES + 1; i++) {
      bodies
          .append(i == 0 ? "" : ",")
          .append("{\"name\": \"b\", \"shape\": {\"type\": \"circle\", \"radius\": 0.1}, \"at\": [")
          .append(i % 30 - 15)
          .append(',')
          .append(i / 30 - 8)
          .append("]}");
    }
    String said = problem(arena(bodies.append("]").toString()));
    assertTrue(said.contains("bodies=" + (LevelTrial.MAX_BODIES + 1)), said);
    said = problem(arena("").replace("Mine", "a/../b"));
    assertTrue(said.contains("\"name\""), said);
  }

  @Test
  void aTriggerLeadsToNoFileOfTheServer() throws Exception {
    String next =
        ", \"triggers\": [{\"when\": {\"timer\": 1}, \"do\": {\"next\": \"/etc/hostname\"}}]";
    String said = problem(arena(next));
    assertTrue(said.contains("\"next\": \"/etc/hostname\""), said);
  }

  @Test
  void whatTakesTooLongIsEnded() throws Exception {
    TrialProcess.Verdict v = judge(Level.builtIn("arena").source(), Duration.ofMillis(1));
    assertTrue(v.problems().get(0).contains("takes longer"), v.toString());
  }
}
