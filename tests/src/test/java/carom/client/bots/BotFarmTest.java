package carom.client.bots;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.ClientConfig;
import carom.client.PredictionMode;
import carom.game.Games;
import carom.lab.crowd.CrowdTransport;
import carom.net.kryo.KryoMessageCodec;
import carom.net.kryo.server.KryoLimits;
import carom.net.kryo.server.KryoServerTransport;
import carom.net.protocol.RefusalReason;
import carom.net.protocol.ServerMessage;
import carom.net.transport.ClientTransport;
import carom.net.transport.InProcessNetwork;
import carom.net.transport.Link;
import carom.net.transport.ServerTransport;
import carom.physics.threads.WorkerThreads;
import carom.server.Server;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.sim.level.Level;
import carom.suite.Needs;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Goal: a crowd of bots gets in and stays in. */
@Needs("sockets")
final class BotFarmTest {
  private static final long SECOND = 1_000_000_000L;
  private static final int CROWD = 40;

  private static ClientConfig config() {
    return ClientConfig.of("bot")
        .with(ClientConfig.PREDICTION, PredictionMode.NONE)
        .with(ClientConfig.TICKS_PER_INPUT_DATAGRAM, 2);
  }

  /** An arena in virtual time. */
  private static Server server(int seats, InProcessNetwork network, long[] now) throws Exception {
    return server(seats, network.server(), now);
  }

  private static Server server(int seats, ServerTransport transport, long[] now) throws Exception {
    return new Server(
        ServerConfig.defaults()
            .with(ServerConfig.MAX_PLAYERS, seats)
            .with(ServerConfig.STATUS_INTERVAL, 0),
        () -> Games.create("arena"),
        Level.builtIn("arena"),
        transport,
        () -> now[0]);
  }

  private static BotFarm farm(int count, int churn, InProcessNetwork network) {
    return farm(count, churn, network.client());
  }

  private static BotFarm farm(int count, int churn, ClientTransport transport) {
    return new BotFarm(
        config().withServer("server", 0, 0),
        transport,
        count,
        1,
        false,
        churn,
        new WorkerThreads(1));
  }

  @Test
  void oneProcessorIsLeftToTheServer() {
    assertEquals(1, BotsMain.threadsFor(1, 8));
    assertEquals(1, BotsMain.threadsFor(500, 1));
    assertEquals(1, BotsMain.threadsFor(500, 2));
    assertEquals(3, BotsMain.threadsFor(500, 4));
    assertEquals(5, BotsMain.threadsFor(500, 16));
    assertEquals(WorkerThreads.MAX_COUNT, BotsMain.threadsFor(100_000, 1_000));
  }

  @Test
  @Timeout(120)
  void aCrowdPlaysOverRealSocketsAndNobodyIsLost() throws Exception {
    KryoServerTransport sockets =
        new KryoServerTransport(0, 0, KryoLimits.DEFAULT.withConnections(200, 100));
    ServerConfig settings =
        ServerConfig.defaults()
            .with(ServerConfig.ROOMS, 2)
            .with(ServerConfig.MAX_PLAYERS, CROWD / 2)
            .with(ServerConfig.SNAPSHOT_RATE, 30)
            .with(ServerConfig.STATUS_INTERVAL, 0);
    try (Server server =
            new Server(
                settings,
                () -> Games.create("arena"),
                Level.builtIn("arena"),
                sockets,
                System::nanoTime);
        ClientTransport clients = new CrowdTransport();
        WorkerThreads threads = new WorkerThreads(2);
        BotFarm farm =
            new BotFarm(
                config().withServer("127.0.0.1", server.tcpPort(), server.udpPort()),
                clients,
                CROWD,
                1,
                false,
                0,
                threads)) {
      server.start();
      // However slow the machine is: until each bot has seen a hundred ticks.
      while (!farm.over() && farm.fewestSnapshots() < 100) {
        farm.update(System.nanoTime());
        Thread.sleep(4);
      }
      BotReport report = farm.report(System.nanoTime());
      assertEquals(CROWD, report.joined(), farm::problem);
      assertEquals(CROWD, report.playing(), farm::problem);
      assertEquals(0, report.disconnects());
      assertEquals(0, report.errors());
      assertEquals(0, report.rejected());
      assertEquals(CROWD, server.count(Counter.PLAYERS));
      assertEquals(0, server.count(Counter.LINKS_LOST));
      assertEquals(0, server.count(Counter.SESSIONS_FAILED));
      assertTrue(server.count(Counter.DATAGRAMS_IN) > CROWD * 10L);
      assertEquals(0, sockets.counters().errors.get());
      assertEquals(0, sockets.counters().excessDatagrams.get());
      assertEquals(CROWD, sockets.counters().opened.get());
    }
  }

  @Test
  void aSlowFrameMakesJoinsGoodAndItsInputsCountAsLate() throws Exception {
    InProcessNetwork network = new InProcessNetwork(new KryoMessageCodec());
    long[] now = {SECOND};
    try (Server server = server(CROWD, network, now);
        BotFarm farm = farm(CROWD, 0, network)) {
      // The bots' machine manages ten frames a second; one bot per frame would take four.
      for (int tick = 0; tick < 120; tick++) {
        now[0] += SECOND / 60;
        server.tick(now[0]);
        if (tick % 6 == 0) {
          farm.update(now[0]);
        }
      }
      BotReport report = farm.report(now[0]);
      assertEquals(CROWD, report.joined(), farm::problem);
      assertEquals(100.0 * 5 / 6, report.lateInputPercent(), 0.1);
    }
  }

  /** A network whose client side counts the links that it opens. */
  private static ClientTransport counting(InProcessNetwork network, int[] opened) {
    ClientTransport inner = network.client();
    return new ClientTransport() {
      @Override
      public Link connect(String host, int tcpPort, int udpPort) {
        opened[0]++;
        return inner.connect(host, tcpPort, udpPort);
      }

      @Override
      public void close() {
        inner.close();
      }
    };
  }

  /** Lets eight bots join a server that sleeps at first; returns for how long one was alone. */
  private static long aloneNs(long asleepNs) throws Exception {
    InProcessNetwork network = new InProcessNetwork(new KryoMessageCodec());
    long[] now = {SECOND};
    int[] opened = {0};
    try (Server server = server(8, network, now);
        BotFarm farm = farm(8, 0, counting(network, opened))) {
      long aloneNs = 0;
      for (int tick = 0; tick < asleepNs / SECOND * 60 + 90; tick++) {
        now[0] += SECOND / 60;
        if (now[0] - SECOND > asleepNs) {
          server.tick(now[0]);
        }
        farm.update(now[0]);
        aloneNs = opened[0] == 1 ? now[0] - SECOND : aloneNs;
      }
      assertEquals(8, farm.playing(), farm::problem);
      assertEquals(8, opened[0]);
      return aloneNs;
    }
  }

  @Test
  void theFirstBotGoesAheadUntilItHasSeenSomethingOrThreeSecondsHavePassed() throws Exception {
    assertEquals(2.2, aloneNs(2 * SECOND) / 1e9, 0.2);
    assertEquals(3, aloneNs(5 * SECOND) / 1e9, 0.04);
  }

  @Test
  void whoHasPlayedLongEnoughLeavesAndComesBack() throws Exception {
    InProcessNetwork network = new InProcessNetwork(new KryoMessageCodec());
    long[] now = {SECOND};
    try (Server server = server(8, network, now);
        BotFarm farm = farm(8, 2, network)) {
      for (int tick = 0; tick < 1_200; tick++) {
        now[0] += SECOND / 60;
        server.tick(now[0]);
        farm.update(now[0]);
      }
      // Eight bots that stay for two seconds on average: some 75 stays in 20 s.
      long joins = server.count(Counter.JOINS);
      assertTrue(joins > 40 && joins < 150, "joins=" + joins);
      assertTrue(server.count(Counter.LEAVES) >= joins - 8);
      assertEquals(0, server.count(Counter.LINKS_LOST));
      assertEquals(0, farm.report(now[0]).disconnects());
    }
  }

  @Test
  void theNextMatchIsNoDisconnect() throws Exception {
    InProcessNetwork network = new InProcessNetwork(new KryoMessageCodec());
    long[] now = {SECOND};
    try (Server server = server(4, network, now);
        BotFarm farm = farm(4, 0, network)) {
      CompletableFuture<String> changed = null;
      int loading = 0;
      for (int tick = 0; tick < 300 || farm.playing() < 4; tick++) {
        now[0] += SECOND / 60;
        server.tick(now[0]);
        farm.update(now[0]);
        if (tick == 120) {
          assertEquals(4, farm.playing(), farm::problem);
          changed =
              CompletableFuture.supplyAsync(
                  () -> server.rooms().get(0).operator().change("", "commons"));
        }
        while (changed != null && !changed.isDone()) {
          server.tick(now[0]);
        }
        loading += changed != null && farm.playing() < 4 ? 1 : 0;
        assertTrue(tick < 3_000, farm::problem);
      }
      assertEquals("playing game=arena level=Commons", changed.join());
      assertTrue(loading > 0, "the bots load the level");
      assertEquals(0, farm.report(now[0]).disconnects());
    }
  }

  /** Returns a network's end that notes the links it accepts. */
  private static ServerTransport noting(InProcessNetwork network, List<Link> links) {
    return new ServerTransport() {
      @Override
      public Link accept() {
        Link link = network.server().accept();
        if (link != null) {
          links.add(link);
        }
        return link;
      }

      @Override
      public int tcpPort() {
        return 0;
      }

      @Override
      public int udpPort() {
        return 0;
      }

      @Override
      public void close() {
        network.server().close();
      }
    };
  }

  /** Breaks the links of four bots, has them come back, and reports. */
  private static BotReport breakLinks(boolean toTheirServer) throws Exception {
    InProcessNetwork network = new InProcessNetwork(new KryoMessageCodec());
    InProcessNetwork other = new InProcessNetwork(new KryoMessageCodec());
    boolean[] broken = {false};
    ClientTransport roads =
        new ClientTransport() {
          @Override
          public Link connect(String host, int tcpPort, int udpPort) {
            InProcessNetwork to = broken[0] && !toTheirServer ? other : network;
            return to.client().connect(host, tcpPort, udpPort);
          }

          @Override
          public void close() {}
        };
    List<Link> links = new ArrayList<>();
    long[] now = {SECOND};
    try (Server server = server(4, noting(network, links), now);
        Server stranger = server(4, other, now);
        BotFarm farm = farm(4, 0, roads)) {
      int away = 0;
      for (int tick = 0; tick < 300 || farm.playing() < 4; tick++) {
        now[0] += SECOND / 60;
        server.tick(now[0]);
        stranger.tick(now[0]);
        farm.update(now[0]);
        if (tick == 120) {
          assertEquals(4, farm.playing(), farm::problem);
          broken[0] = true;
          links.forEach(link -> link.close("a test"));
        }
        away = Math.max(away, broken[0] ? 4 - farm.playing() : 0);
        assertTrue(tick < 3_000, farm::problem);
      }
      assertEquals(4, away);
      return farm.report(now[0]);
    }
  }

  @Test
  void aBotThatComesBackToItsSeatIsNoDisconnect() throws Exception {
    BotReport report = breakLinks(true);
    assertEquals(4, report.reconnects());
    assertEquals(0, report.disconnects());
  }

  @Test
  void aBotThatBeginsAnewElsewhereHasLostItsSeat() throws Exception {
    BotReport report = breakLinks(false);
    assertEquals(4, report.reconnects());
    assertEquals(4, report.disconnects());
  }

  @Test
  void theReportTellsOfAllStaysNotOfTheLast() throws Exception {
    InProcessNetwork network = new InProcessNetwork(new KryoMessageCodec());
    List<Link> links = new ArrayList<>();
    ServerTransport transport = noting(network, links);
    long[] now = {SECOND};
    int garbage = 0;
    try (Server server = server(8, transport, now);
        BotFarm farm = farm(4, 2, network)) {
      for (int tick = 0; tick < 1_200; tick++) {
        now[0] += SECOND / 60;
        server.tick(now[0]);
        if (garbage == 0 && farm.playing() == 4) {
          for (Link link : links) {
            garbage += link.sendDatagram(new byte[3], 0, 3) ? 1 : 0;
          }
        }
        farm.update(now[0]);
      }
      assertTrue(server.count(Counter.JOINS) > 20);
      assertEquals(4, garbage);
      BotReport report = farm.report(now[0]);
      assertEquals(garbage, report.errors());
      // A stay is 4 s at most, of 20.
      int most = 1_200 / 60 * server.config().snapshotRateHz();
      long fewest = farm.fewestSnapshots();
      assertTrue(fewest > most / 2 && fewest <= most, fewest + " snapshots of " + most);
      assertTrue(report.snapshotsPerSecond() <= server.config().snapshotRateHz() * 1.05);
      assertTrue(report.snapshotsPerSecond() >= server.config().snapshotRateHz() * 0.9);
    }
  }

  /** Every newcomer is told the same and let go. */
  private static int refuseAll(InProcessNetwork network, RefusalReason reason) {
    int refused = 0;
    for (Link link; (link = network.server().accept()) != null; ) {
      link.send(new ServerMessage.Refused(reason, ""));
      refused++;
    }
    return refused;
  }

  private static int attempts(RefusalReason reason, BotReport[] report) {
    InProcessNetwork network = new InProcessNetwork(new KryoMessageCodec());
    int refused = 0;
    try (BotFarm farm = farm(3, 0, network)) {
      for (long nowNs = SECOND; nowNs < 200 * SECOND && !farm.over(); nowNs += SECOND / 60) {
        farm.update(nowNs);
        refused += refuseAll(network, reason);
      }
      report[0] = farm.report(200 * SECOND);
      assertTrue(farm.over());
    }
    return refused;
  }

  @Test
  void whoFindsTheServerFullTriesAgainAndGivesUpInTheEnd() {
    BotReport[] report = new BotReport[1];
    assertEquals(18, attempts(RefusalReason.SERVER_FULL, report));
    assertEquals(3, report[0].rejected());
    assertEquals(15, report[0].retries());
    assertEquals(0, report[0].joined());
  }

  @Test
  void whoComesBackToAFullServerTriesAgainEachTimeAndGivesUpInTheEnd() throws Exception {
    InProcessNetwork open = new InProcessNetwork(new KryoMessageCodec());
    InProcessNetwork full = new InProcessNetwork(new KryoMessageCodec());
    boolean[] isFull = {false};
    ClientTransport door =
        new ClientTransport() {
          @Override
          public Link connect(String host, int tcpPort, int udpPort) {
            return (isFull[0] ? full : open).client().connect(host, tcpPort, udpPort);
          }

          @Override
          public void close() {}
        };
    long[] now = {SECOND};
    int refused = 0;
    int refusedBefore = 0;
    try (Server server = server(8, open, now);
        BotFarm farm = farm(3, 1, door)) {
      // Full for a while, open until all are back, then full for ever.
      int closings = 0;
      while (now[0] < 400 * SECOND && !farm.over()) {
        now[0] += SECOND / 60;
        server.tick(now[0]);
        farm.update(now[0]);
        refused += refuseAll(full, RefusalReason.SERVER_FULL);
        if (!isFull[0] && farm.playing() == 3) {
          isFull[0] = true;
          closings++;
          refusedBefore = refused;
        } else if (closings == 1 && refused >= 3) {
          isFull[0] = false;
        }
      }
      BotReport report = farm.report(now[0]);
      assertTrue(farm.over());
      assertEquals(2, closings);
      assertEquals(18, refused - refusedBefore, "six attempts each, whatever went before");
      assertEquals(refused - 3, report.retries());
      assertEquals(3, report.rejected());
      assertEquals(3, report.joined());
      assertEquals(0, report.disconnects());
    }
  }

  @Test
  void whoIsNotWantedGoesAtOnce() {
    BotReport[] report = new BotReport[1];
    assertEquals(3, attempts(RefusalReason.PROTOCOL_VERSION, report));
    assertEquals(3, report[0].rejected());
    assertEquals(0, report[0].retries());
  }
}
