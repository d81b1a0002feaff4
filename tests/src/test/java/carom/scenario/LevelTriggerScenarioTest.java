package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.bots.Bot;
import carom.options.NetworkConditions.Preset;
import carom.replay.RecordingReader;
import carom.replay.Replay;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.sim.level.Level;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: what a level's triggers do is computed again by a replay, and clients that predict agree
 * with the server about it. Method: the level of docs/games/LEVELS.md, whose door opens by a plate,
 * played by bots on a mobile network, recorded and replayed.
 */
final class LevelTriggerScenarioTest {
  @TempDir private Path folder;

  private static Level gatehouse() throws Exception {
    String page = Files.readString(Path.of("../docs/games/LEVELS.md"));
    int begin = page.lastIndexOf("```json", page.indexOf("\"Gatehouse\"")) + "```json".length();
    String json =
        page.substring(begin, page.indexOf("```", begin)).replace("\"timer\": 30", "\"timer\": 3");
    return Level.parse("LEVELS.md", json.getBytes(StandardCharsets.UTF_8));
  }

  @Test
  void playersAgreeAndAReplayDoesTheSame() throws Exception {
    Path file = folder.resolve("gatehouse.carom");
    ServerConfig config = ServerConfig.defaults().with(ServerConfig.SEED, Stepper.SEED);
    float highest = 0;
    int first;
    int most = 0;
    try (Stepper world = Stepper.of(gatehouse(), config)) {
      world.server().record(file);
      first = world.room().simulation().entityCount();
      List<SimulatedClient> clients = new ArrayList<>();
      for (int i = 0; i < 3; i++) {
        clients.add(
            world.add(
                "bot" + i,
                Preset.MOBILE.impairment().withSeed(Stepper.SEED + i),
                new Bot(Stepper.SEED + 20L * i)));
      }
      clients.forEach(world::awaitPlaying);
      for (int i = 0; i < 150; i++) {
        world.run(0.1);
        highest = Math.max(highest, world.room().simulation().entity(0).y());
        most = Math.max(most, world.room().simulation().entityCount());
      }
      assertEquals(0, world.count(Counter.DIVERGENCES_UNEXPLAINED), world.describe());
    }
    assertTrue(highest > 4, "the door stood at y=" + highest);
    assertEquals(first + 3 + 1, most, "what was there, players, and the weight of the timer");
    try (RecordingReader reader = RecordingReader.open(file)) {
      Replay replay = new Replay(reader);
      Replay.Progress progress;
      do {
        progress = replay.step();
        assertNull(replay.divergence());
      } while (progress == Replay.Progress.TICK);
      assertEquals(Replay.Progress.END, progress);
      assertTrue(replay.simulation().tick() > 900);
    }
  }
}
