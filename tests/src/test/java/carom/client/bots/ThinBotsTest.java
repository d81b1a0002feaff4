package carom.client.bots;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.fixtures.OutsideRelay;
import carom.game.Games;
import carom.net.kryo.server.KryoServerTransport;
import carom.net.transport.Impairment;
import carom.net.transport.ServerTransports;
import carom.server.Server;
import carom.server.config.ServerConfig;
import carom.server.thin.plain.PlainFlags;
import carom.server.thin.web.PlayFlags;
import carom.server.thin.web.PlayPort;
import carom.sim.level.Level;
import carom.suite.Needs;
import carom.text.Json;
import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * Goal: bots come through the doors for thin clients. Method: the program against a server on real
 * ports; {@code plain} by the real KryoNet 2.22 and Kryo 2.24.
 */
@Needs("sockets")
@Timeout(120)
final class ThinBotsTest {
  private static final int WAY_MS = 60;

  private carom.server.thin.plain.PlainDoor plain;
  private PlayPort play;
  private Server server;

  @BeforeEach
  void open() throws Exception {
    ServerConfig config =
        ServerConfig.defaults()
            .with(ServerConfig.STATUS_INTERVAL, 0)
            .with(ServerConfig.PLAIN_PORT, "0:0")
            .with(ServerConfig.PLAY_PORT, 0);
    List<InetAddress> here = List.of(InetAddress.getLoopbackAddress());
    plain = PlainFlags.open(config, here);
    play = PlayFlags.open(config, here, 64, 64);
    server =
        new Server(
            config,
            Games.supplier("arena"),
            Level.builtIn("arena"),
            ServerTransports.of(new KryoServerTransport(0, 0), List.of(plain, play)),
            System::nanoTime);
    server.start();
  }

  @AfterEach
  void close() {
    server.close();
  }

  private static Json run(int status, String door, String host) throws Exception {
    PrintStream out = System.out;
    PrintStream err = System.err;
    ByteArrayOutputStream printed = new ByteArrayOutputStream();
    ByteArrayOutputStream complained = new ByteArrayOutputStream();
    try {
      System.setOut(new PrintStream(printed, true, StandardCharsets.UTF_8));
      System.setErr(new PrintStream(complained, true, StandardCharsets.UTF_8));
      int code = BotsMain.run("--door", door, "--host", host, "--count", "3", "--seconds", "2");
      assertEquals(status, code, complained.toString(StandardCharsets.UTF_8));
    } finally {
      System.setOut(out);
      System.setErr(err);
    }
    String[] lines = printed.toString(StandardCharsets.UTF_8).strip().split("\n");
    return Json.parse(lines[lines.length - 1].getBytes(StandardCharsets.UTF_8));
  }

  private static void assertPlayed(Json report) {
    assertEquals(3, number(report, "joined"));
    assertEquals(3, number(report, "playing"));
    assertEquals(0, number(report, "errors"));
    assertEquals(0, number(report, "disconnects"));
    assertTrue(number(report, "snapshotsPerSecond") > 1, report.shown());
    assertTrue(number(report, "kbitPerSecond") > 1, report.shown());
    assertTrue(number(report, "keyP50Ms") > 0, report.shown());
  }

  private static double number(Json report, String name) {
    return report.fields.get(name).number;
  }

  @Test
  void byWebSocketInBothForms() throws Exception {
    String host = "127.0.0.1:" + play.tcpPort();
    Json texts = run(0, "web", host);
    assertPlayed(texts);
    Json bytes = run(0, "binary", host);
    assertPlayed(bytes);
    assertTrue(number(bytes, "kbitPerSecond") < number(texts, "kbitPerSecond"));
  }

  @Test
  void byTheRealKryoNet() throws Exception {
    Assumptions.assumeTrue(System.getProperty("carom.plain.path") != null, "run by Gradle");
    assertPlayed(run(0, "plain", "127.0.0.1:" + plain.tcpPort() + "/" + plain.udpPort()));
    assertPlayed(run(0, "plain", "127.0.0.1:" + plain.tcpPort()));
  }

  @Test
  void aSimulatedNetworkDelaysBothWaysOfBothDoors() throws Exception {
    play.simulate(Impairment.NONE.withLatency(WAY_MS, 5));
    assertLate(run(0, "binary", "127.0.0.1:" + play.tcpPort()));
    Assumptions.assumeTrue(System.getProperty("carom.plain.path") != null, "run by Gradle");
    plain.simulate(Impairment.NONE.withLatency(WAY_MS, 5).withLoss(5));
    assertLate(run(0, "plain", "127.0.0.1:" + plain.tcpPort() + "/" + plain.udpPort()));
  }

  private static void assertLate(Json report) {
    assertPlayed(report);
    assertTrue(number(report, "keyP50Ms") > 2 * (WAY_MS - 5), report.shown());
  }

  @Test
  void twoPercentLossMakeNoPictureStall() throws Exception {
    Assumptions.assumeTrue(System.getProperty("carom.plain.path") != null, "run by Gradle");
    InetAddress here = InetAddress.getLoopbackAddress();
    try (OutsideRelay relay =
            new OutsideRelay(
                here,
                0,
                new InetSocketAddress(here, plain.tcpPort()),
                new InetSocketAddress(here, plain.udpPort()),
                10,
                2);
        ThinFarm farm =
            new ThinFarm(
                PlainDoor.opener("127.0.0.1", relay.tcpPort(), relay.udpPort()), "b", "", 4, 1)) {
      long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(8);
      while (System.nanoTime() - end < 0 || farm.playing() < 4) {
        farm.update(System.nanoTime());
        Thread.sleep(4);
        assertTrue(System.nanoTime() - end < TimeUnit.SECONDS.toNanos(40), farm.problem());
      }
      assertEquals(0, farm.report(System.nanoTime()).errors());
      for (ThinPicture picture : farm.pictures()) {
        // Two ticks from snapshot to snapshot; a picture that is two snapshots late bridges four.
        assertTrue(picture.gapP99Ticks() <= 4, "ticks=" + picture.gapP99Ticks());
      }
    }
  }

  @Test
  void whereNobodyListensTheySaySo() throws Exception {
    Json report = run(1, "web", "127.0.0.1:1");
    assertEquals(0, number(report, "joined"));
    assertEquals(3, number(report, "rejected"));
  }
}
