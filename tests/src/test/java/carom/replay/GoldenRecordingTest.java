package carom.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.ClientConfig;
import carom.client.bots.Bot;
import carom.game.Games;
import carom.net.transport.Impairment;
import carom.server.config.ServerConfig;
import carom.sim.level.Level;
import carom.sim.scene.SceneGame;
import carom.sim.scene.Scenes;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Goal: a game recorded in the past is computed today as it was then, to the last bit. Method: the
 * files in {@code resources/recordings}, a few seconds of each kind of game on a bad network, tick
 * by tick.
 *
 * <p>If this fails, the simulation, a game or the format has changed. If that was intended, and the
 * commit says why, {@code ./gradlew test --tests GoldenRecordingTest -Dcarom.renew=true} writes the
 * files anew; a change of the format or of the arithmetic raises {@code Block.VERSION} or {@code
 * PhysicsVersion.NUMBER}, too.
 */
final class GoldenRecordingTest {
  private static final String FOLDER = "tests/src/test/resources/recordings";
  private static final double SECONDS = 4;

  @TempDir private Path folder;

  @ParameterizedTest
  @ValueSource(strings = {"arena", "platformer", "car"})
  void aRecordingOfThePastIsComputedExactly(String name) throws Exception {
    if (Boolean.getBoolean("carom.renew")) {
      record(name);
      return;
    }
    Path file = folder.resolve(name + ".carom");
    try (InputStream in = getClass().getResourceAsStream("/recordings/" + name + ".carom")) {
      assertNotNull(in, name + ".carom is missing; write it with -Dcarom.renew=true");
      Files.copy(in, file);
    }
    try (RecordingReader reader = RecordingReader.open(file)) {
      Replay replay = new Replay(reader);
      Replay.Progress progress;
      do {
        progress = replay.step();
      } while (progress == Replay.Progress.TICK && !replay.isDecided());
      assertNull(
          replay.divergence(),
          () ->
              "renew it only with a reason in the commit (see this class): " + replay.divergence());
      assertEquals(Replay.Progress.END, progress);
      assertTrue(replay.simulation().tick() >= 60 * SECONDS);
    }
  }

  private static void record(String name) throws Exception {
    Level level =
        Games.names().contains(name)
            ? Level.builtIn(Games.create(name).defaultLevel())
            : SceneGame.level(Scenes.get(name));
    Impairment bad = Impairment.NONE.withLatency(60, 20).withLoss(5).withSeed(Stepper.SEED);
    Blocks blocks = new Blocks();
    try (Stepper stepper = Stepper.of(level, ServerConfig.defaults())) {
      stepper.room().record(blocks);
      for (int i = 0; i < 3; i++) {
        stepper.add(ClientConfig.of("bot" + i).withServer("localhost", 0, 0), bad, new Bot(i));
      }
      stepper.run(SECONDS / 2);
      stepper.clients().stream().findFirst().ifPresent(SimulatedClient::leave);
      stepper.run(SECONDS / 2 + 0.2);
    }
    Path root = Path.of("").toAbsolutePath();
    while (root != null && !Files.isDirectory(root.resolve(FOLDER).getParent())) {
      root = root.getParent();
    }
    assertNotNull(root, FOLDER + " not found above the working directory");
    Files.createDirectories(root.resolve(FOLDER));
    blocks.write(root.resolve(FOLDER).resolve(name + ".carom"));
  }
}
