package carom.launcher;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.ClientConfig;
import carom.client.GameClient;
import carom.client.InputSource;
import carom.client.app.LocalGames;
import carom.client.app.LocalGames.GameChoice;
import carom.client.link.ConnectionPhase;
import carom.net.kryo.KryoClientTransport;
import carom.net.transport.ClientTransport;
import carom.sim.level.Level;
import carom.suite.Needs;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Goal: a player needs no server to play. Method: real games in this process, with bots. */
@Needs("sockets")
@Timeout(60)
final class LocalServersTest {
  private static GameClient client(ClientTransport transport, int tcpPort, int udpPort) {
    ClientConfig config = ClientConfig.of("me").withServer("localhost", tcpPort, udpPort);
    return new GameClient(config, transport, InputSource.IDLE);
  }

  /** The levels that ship: other tests add games to this process, whose levels aren't files. */
  private static List<String> levelsWithFiles() {
    return LocalGames.find().levels().stream()
        .filter(name -> Level.class.getResource("/levels/" + name + ".json") != null)
        .toList();
  }

  private static void await(GameClient client, BooleanSupplier condition)
      throws InterruptedException {
    long deadline = System.nanoTime() + TimeUnit.SECONDS.toNanos(30);
    while (!condition.getAsBoolean()) {
      assertTrue(System.nanoTime() < deadline, () -> client.view().message());
      client.update(System.nanoTime());
      Thread.sleep(4);
    }
  }

  @Test
  void theClientFindsThem() {
    assertNotNull(LocalGames.find());
    assertEquals("arena", levelsWithFiles().get(0));
  }

  @Test
  void oneCanPlayEveryLevelWithBotsAndNoNetwork() throws Exception {
    List<String> levels = levelsWithFiles();
    assertTrue(
        levels.containsAll(
            List.of(
                "arena",
                "cars",
                "harbour",
                "orbit",
                "platformer",
                "quarry",
                "rink",
                "rockets",
                "ruins",
                "sandbox",
                "shooter",
                "towers")),
        "levels=" + levels);
    for (String level : levels) {
      try (LocalServer game = LocalServers.start(new GameChoice(level, 3, false), 0, 0);
          GameClient me = client(game.transport(), 0, 0)) {
        assertEquals("", game.invitation());
        await(me, () -> me.view().phase() == ConnectionPhase.PLAYING);
        await(me, () -> me.view().players().size() == 4);
        await(me, () -> me.stats().snapshots() > 10);
      }
    }
  }

  @Test
  void aLevelThatIsInNoFileIsPlayedAndWhatIsSurelyNotMeantIsTold() throws Exception {
    String text = new String(Level.builtIn("arena").source(), StandardCharsets.UTF_8);
    Level level =
        Level.parse(
            "edited",
            text.replace("Corner Pocket", "Edited")
                .replace("\"ball\", \"at\": [0, 2]", "\"ball\", \"at\": [-19, 7]")
                .getBytes(StandardCharsets.UTF_8));
    LocalServers servers = new LocalServers();
    try (LocalGames.LocalGame game = servers.start(level, 1);
        GameClient me = client(game.transport(), 0, 0)) {
      await(me, () -> me.view().phase() == ConnectionPhase.PLAYING);
      await(me, () -> me.view().players().size() == 2);
      assertEquals("Edited", me.view().level().name());
    }
    List<String> warnings = servers.warnings(level);
    assertEquals(1, warnings.size(), warnings.toString());
    assertTrue(warnings.get(0).contains("is inside statics"), warnings.get(0));
  }

  @Test
  void othersJoinByTheNetworkIfTheyMay() throws Exception {
    try (LocalServer game = LocalServers.start(new GameChoice("arena", 0, true), 0, 0);
        KryoClientTransport sockets = new KryoClientTransport();
        GameClient me = client(game.transport(), 0, 0);
        GameClient other = client(sockets, game.server().tcpPort(), 0)) { // it learns the UDP port
      assertTrue(game.invitation().endsWith(":" + game.server().tcpPort()), game.invitation());
      await(me, () -> me.view().phase() == ConnectionPhase.PLAYING);
      await(other, () -> other.view().phase() == ConnectionPhase.PLAYING);
      await(me, () -> me.view().players().size() == 2);
    }
  }

  @Test
  void whatCannotBeStartedIsExplained() {
    String said =
        assertThrows(
                IllegalStateException.class,
                () -> LocalServers.start(new GameChoice("nowhere", 0, false), 0, 0))
            .getMessage();
    assertTrue(said.contains("The level nowhere can't be played"), said);
    try (LocalServer first = LocalServers.start(new GameChoice("arena", 0, true), 0, 0)) {
      int tcp = first.server().tcpPort();
      said =
          assertThrows(
                  IllegalStateException.class,
                  () -> LocalServers.start(new GameChoice("arena", 0, true), tcp, 0))
              .getMessage();
      assertTrue(said.contains("Is another server running here?"), said);
    }
  }
}
