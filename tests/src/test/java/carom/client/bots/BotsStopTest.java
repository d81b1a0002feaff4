package carom.client.bots;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.fixtures.Jvm;
import carom.game.Games;
import carom.net.kryo.server.KryoServerTransport;
import carom.server.Server;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.sim.level.Level;
import carom.suite.Needs;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: after a bot farm has stopped, another one can start at once. Method: a farm in its own
 * process is told to end; the server must see its players leave, not wait for them to come back.
 */
@Needs("sockets")
final class BotsStopTest {
  @Test
  void botsThatAreAskedToStopLeaveTheirPlaces(@TempDir Path folder) throws Exception {
    try (Server server =
        new Server(
            ServerConfig.defaults(),
            () -> Games.create("arena"),
            Level.builtIn("arena"),
            new KryoServerTransport(0, 0),
            System::nanoTime)) {
      server.start();
      Process farm =
          new ProcessBuilder(
                  Jvm.command(
                      BotsMain.class,
                      "--host=localhost:" + server.tcpPort(),
                      "--count=5",
                      "--seconds=60"))
              .redirectErrorStream(true)
              .redirectOutput(folder.resolve("bots.txt").toFile())
              .start();
      try {
        assertTrue(within(30, () -> players(server) == 5), "players=" + players(server));
        farm.destroy(); // SIGTERM
        assertTrue(farm.waitFor(10, TimeUnit.SECONDS), "the farm did not end");
        assertTrue(within(5, () -> players(server) == 0), "players=" + players(server));
        assertEquals(0, server.rooms().get(0).seats().takenCount(), "nobody is waited for");
      } finally {
        farm.destroyForcibly();
      }
    }
  }

  private static long players(Server server) {
    return server.rooms().get(0).counters().get(Counter.PLAYERS);
  }

  private static boolean within(int seconds, BooleanSupplier condition)
      throws InterruptedException {
    long deadline = System.nanoTime() + TimeUnit.SECONDS.toNanos(seconds);
    while (!condition.getAsBoolean()) {
      if (System.nanoTime() > deadline) {
        return false;
      }
      Thread.sleep(20);
    }
    return true;
  }
}
