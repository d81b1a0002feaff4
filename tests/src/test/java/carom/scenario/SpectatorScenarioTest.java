package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.ClientConfig;
import carom.client.GameClient;
import carom.client.bots.Bot;
import carom.client.replay.RecordingDownload;
import carom.client.replay.ReplayClient;
import carom.client.replay.SpectatorThread;
import carom.fixtures.CrouchGame;
import carom.fixtures.CrouchGame.Rule;
import carom.game.arena.ArenaGame;
import carom.net.kryo.KryoClientTransport;
import carom.net.kryo.KryoMessageCodec;
import carom.net.kryo.server.KryoServerTransport;
import carom.net.protocol.ServerMessage;
import carom.net.transport.ClientTransport;
import carom.net.transport.InProcessNetwork;
import carom.net.transport.ServerTransport;
import carom.replay.RecordingReader;
import carom.replay.Replay;
import carom.server.Server;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.sim.SimulationHost;
import carom.sim.level.Level;
import carom.suite.Needs;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: spectators see the game as it was, exactly, and never what is younger than the delay.
 * Method: they compute the bytes they were sent while the game goes on, tick by tick.
 */
@Needs("sockets")
@Timeout(60)
class SpectatorScenarioTest {
  private static final int DELAY_S = 2;
  private static final int DELAY_TICKS = DELAY_S * 60;
  private static final long SLICE_NS = 5_000_000;

  @TempDir private Path folder;
  private long nowNs = 1_000_000_000L;

  private Server server(ServerTransport transport) throws Exception {
    return new Server(
        ServerConfig.defaults().with(ServerConfig.STATUS_INTERVAL, 0),
        ArenaGame::new,
        Level.builtIn("arena"),
        transport,
        () -> nowNs);
  }

  /** How many ticks of a growing file can be computed; all of them must be equal. */
  private static int ticks(Path file) throws IOException {
    if (Files.size(file) < 100) {
      return -1;
    }
    try (RecordingReader reader = RecordingReader.open(file)) {
      Replay replay = new Replay(reader);
      while (replay.step() == Replay.Progress.TICK) {}
      assertNull(replay.divergence());
      return replay.simulation().tick();
    }
  }

  private void run(
      Server server, List<GameClient> players, List<RecordingDownload> spectators, double s) {
    for (long endNs = nowNs + (long) (s * 1e9); nowNs < endNs; nowNs += SLICE_NS) {
      server.tick(nowNs);
      for (GameClient player : players) {
        player.update(nowNs);
      }
      for (RecordingDownload spectator : spectators) {
        spectator.update(nowNs);
      }
    }
  }

  @Test
  void manyWatchTheSameBytesAndNobodyThePresent() throws Exception {
    InProcessNetwork network = new InProcessNetwork(new KryoMessageCodec());
    ClientTransport transport = network.client();
    List<GameClient> players = new ArrayList<>();
    List<RecordingDownload> spectators = new ArrayList<>();
    try (Server server = server(network.server())) {
      server.allowSpectators(DELAY_S);
      for (int i = 0; i < 2; i++) {
        players.add(new GameClient(ClientConfig.of("bot" + i), transport, new Bot(i), () -> 0));
      }
      run(server, players, spectators, 4);
      for (int i = 0; i < 3; i++) { // they come late
        spectators.add(
            new RecordingDownload(ClientConfig.of("s" + i), 1, transport, folder.resolve("s" + i)));
      }
      for (int i = 0; i < 12; i++) {
        run(server, players, spectators, 0.5);
        Thread.sleep(20); // the file is written by a thread of its own, in real time
        int seen = ticks(folder.resolve("s0"));
        int present = server.rooms().get(0).tick();
        assertTrue(seen <= present - DELAY_TICKS, "seen=" + seen + " present=" + present);
      }
      assertEquals(DELAY_S, spectators.get(0).delaySeconds());
      int least = server.rooms().get(0).tick() - DELAY_TICKS - 120;
      for (int i = 0; i < 3; i++) {
        for (int wait = 0; wait < 200 && ticks(folder.resolve("s" + i)) < least; wait++) {
          Thread.sleep(10);
          run(server, players, spectators, 0.25);
        }
      }
      for (int i = 0; i < 3; i++) {
        assertTrue(ticks(folder.resolve("s" + i)) >= least, spectators.get(i).message());
      }
      byte[] one = Files.readAllBytes(folder.resolve("s0"));
      byte[] other = Files.readAllBytes(folder.resolve("s2"));
      int common = Math.min(one.length, other.length);
      assertTrue(common > 4_096);
      assertEquals(-1, Arrays.mismatch(one, 0, common, other, 0, common));
      try (ReplayClient film = new ReplayClient(folder.resolve("s1"))) {
        film.seek(least);
        for (int i = 0; i < 1_000 && film.seeking(); i++) {
          film.update(nowNs);
        }
        assertEquals(least, film.tick());
        film.seek(60);
        for (int i = 0; i < 1_000 && film.seeking(); i++) {
          film.update(nowNs);
        }
        assertEquals(60, film.tick());
        assertNull(film.divergence());
      }
    } finally {
      spectators.forEach(RecordingDownload::close);
      players.forEach(GameClient::close);
    }
    assertTrue(spectators.get(0).ended());
  }

  @Test
  void whatBecameAnotherIsSoForSpectatorsWhenItWas() throws Exception {
    // Goal: crates are ice, ghosts and rock in a spectator's picture at the ticks at which the
    // server had them so. Method: what the server had, tick by tick; jumps in the spectator's film.
    InProcessNetwork network = new InProcessNetwork(new KryoMessageCodec());
    ClientTransport transport = network.client();
    Level level = CrouchGame.level(Rule.CRATES_CHANGE);
    ServerConfig config =
        ServerConfig.defaults()
            .with(ServerConfig.STATUS_INTERVAL, 0)
            .with(ServerConfig.GAME, "become");
    Map<Integer, String> had = new HashMap<>();
    List<GameClient> players = new ArrayList<>();
    Path seen = folder.resolve("become");
    try (Server server =
            new Server(
                config,
                () -> new CrouchGame(Rule.CRATES_CHANGE),
                level,
                network.server(),
                () -> nowNs);
        RecordingDownload spectator =
            new RecordingDownload(ClientConfig.of("s"), 1, transport, seen)) {
      server.allowSpectators(DELAY_S);
      players.add(new GameClient(ClientConfig.of("bot"), transport, new Bot(1), () -> 0));
      SimulationHost s = server.rooms().get(0).simulation();
      for (int wait = 0; wait < 2_000 && (s.tick() < 600 || ticks(seen) < 400); wait++) {
        for (int i = 0; i < 20; i++) {
          run(server, players, List.of(spectator), 0.005);
          had.put(s.tick(), kinds(s));
        }
        Thread.sleep(2);
      }
      assertTrue(ticks(seen) >= 400, spectator.message());
      try (ReplayClient film = new ReplayClient(seen)) {
        film.pause(true);
        int compared = 0;
        for (int tick : new int[] {90, 170, 250, 390, 330, 10, 389, 240}) {
          film.seek(tick);
          do {
            film.update(nowNs += SLICE_NS);
          } while (film.seeking());
          StringBuilder drawn = new StringBuilder();
          for (int i = 0; i < film.view().entityCount(); i++) {
            drawn.append(film.view().entity(i).archetype().name()).append(' ');
          }
          if (had.containsKey(tick)) {
            assertEquals(had.get(tick), drawn.toString(), "tick=" + tick);
            compared++;
          }
        }
        assertTrue(compared >= 4, "compared=" + compared);
        assertNull(film.divergence());
      }
    } finally {
      players.forEach(GameClient::close);
    }
  }

  private static String kinds(SimulationHost s) {
    StringBuilder kinds = new StringBuilder();
    for (int id = 0; id < s.entityCapacity(); id++) {
      if (s.entity(id) != null) {
        kinds.append(s.entity(id).archetype().name()).append(' ');
      }
    }
    return kinds.toString();
  }

  @Test
  void aSpectatorThatIsSentAwayWatchesTheOtherServer() throws Exception {
    ServerConfig config = ServerConfig.defaults().with(ServerConfig.STATUS_INTERVAL, 0);
    Level level = Level.builtIn("arena");
    try (Server first =
            new Server(
                config, ArenaGame::new, level, new KryoServerTransport(0, 0), System::nanoTime);
        Server second =
            new Server(
                config, ArenaGame::new, level, new KryoServerTransport(0, 0), System::nanoTime);
        KryoClientTransport transport = new KryoClientTransport()) {
      for (Server server : List.of(first, second)) {
        server.allowSpectators(1);
        server.start();
      }
      ClientConfig address =
          ClientConfig.of("s").withServer("localhost", first.tcpPort(), first.udpPort());
      try (SpectatorThread watched = new SpectatorThread(address, 1, transport)) {
        assertNotNull(watched.await(), watched::message);
        assertNull(watched.follow(), "nothing to follow yet");
        String to = "localhost:" + second.tcpPort();
        first.redirectVisitors(new ServerMessage.Redirect(to, "", "", ""));
        SpectatorThread next = null;
        for (int i = 0; i < 2_000 && next == null; i++) {
          Thread.sleep(5);
          next = watched.follow();
        }
        assertNotNull(next, watched::message);
        assertTrue(watched.end().endsWith(" sends you to " + to + "."), watched.end());
        try (SpectatorThread there = next) {
          assertNotNull(there.await(), there::message);
          assertEquals(1, second.rooms().get(0).counters().get(Counter.SPECTATORS));
          second.redirectVisitors(new ServerMessage.Redirect(to, "", "", ""));
          for (int i = 0; i < 2_000 && there.end().isEmpty(); i++) {
            Thread.sleep(5);
          }
          assertNull(there.follow(), "not in circles");
          assertTrue(there.message().endsWith("sent you to itself."), there.message());
        }
      }
      assertEquals(0, first.rooms().get(0).counters().get(Counter.SPECTATORS));
    }
  }

  @Test
  void whoShowsNothingSaysSo() throws Exception {
    InProcessNetwork network = new InProcessNetwork(new KryoMessageCodec());
    try (Server server = server(network.server());
        RecordingDownload spectator =
            new RecordingDownload(ClientConfig.of("s"), 1, network.client(), folder.resolve("s"))) {
      run(server, List.of(), List.of(spectator), 1);
      assertTrue(spectator.ended());
      assertTrue(spectator.message().contains("--spectator-delay"), spectator.message());
    }
  }

  @Test
  void overSocketsARoomIsWatched() throws Exception {
    KryoServerTransport sockets = new KryoServerTransport(0, 0);
    ServerConfig config = ServerConfig.defaults().with(ServerConfig.STATUS_INTERVAL, 0);
    try (Server server =
            new Server(config, ArenaGame::new, Level.builtIn("arena"), sockets, System::nanoTime);
        KryoClientTransport transport = new KryoClientTransport()) {
      server.allowSpectators(1);
      server.start();
      ClientConfig address =
          ClientConfig.of("s").withServer("localhost", server.tcpPort(), server.udpPort());
      Path file = folder.resolve("socket");
      try (RecordingDownload spectator = new RecordingDownload(address, 1, transport, file);
          GameClient player =
              new GameClient(address.with(ClientConfig.NAME, "bot"), transport, new Bot(1))) {
        int seen = -1;
        for (int i = 0; i < 4_000 && seen < 90; i++) {
          spectator.update(System.nanoTime());
          player.update(System.nanoTime());
          seen = i % 50 == 0 ? ticks(file) : seen;
          Thread.sleep(5);
        }
        assertTrue(seen >= 90, "seen=" + seen + " " + spectator.message());
        assertTrue(seen <= server.rooms().get(0).tick() - 60);
      }
    }
  }
}
