package carom.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.game.arena.ArenaGame;
import carom.net.kryo.KryoMessageCodec;
import carom.server.config.ServerConfig;
import carom.sim.level.Level;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class GameWarmupTest {
  @Test
  void everybodyJoinsPlaysAndLeaves() {
    TestGame game = new TestGame(3);
    GameWarmup.play(
        ServerConfig.defaults().with(ServerConfig.ROOMS, 3),
        () -> game,
        TestGame.shortLevel(),
        new KryoMessageCodec(),
        null,
        () -> {});
    assertEquals(4, game.joins);
    assertEquals(4, game.leaves);
    assertTrue(game.inputs > 20, "inputs=" + game.inputs);
  }

  @Test
  void aServerOfAFleetTakesARoomOverAndLeavesNoFiles(@TempDir Path folder) throws Exception {
    AtomicInteger games = new AtomicInteger();
    AtomicInteger steps = new AtomicInteger();
    GameWarmup.play(
        ServerConfig.defaults(),
        () -> {
          games.incrementAndGet();
          return new ArenaGame();
        },
        Level.builtIn("arena"),
        new KryoMessageCodec(),
        folder,
        steps::incrementAndGet);
    assertTrue(games.get() > 5, () -> "one of each room taken over, games=" + games);
    assertTrue(steps.get() > 60, () -> "the watch of a start sees each, steps=" + steps);
    try (Stream<Path> files = Files.list(folder)) {
      assertEquals(List.of("claim"), files.map(f -> f.getFileName().toString()).toList());
    }
  }
}
