package carom.client.bots;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.game.Games;
import carom.net.kryo.server.KryoServerTransport;
import carom.net.transport.ServerTransports;
import carom.server.Server;
import carom.server.config.ServerConfig;
import carom.server.thin.plain.PlainDoor;
import carom.server.thin.plain.PlainFlags;
import carom.server.thin.web.PlayFlags;
import carom.server.thin.web.PlayPort;
import carom.sim.level.Level;
import carom.suite.Needs;
import carom.text.Json;
import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.net.InetAddress;
import java.nio.charset.StandardCharsets;
import java.util.List;
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
  private PlainDoor plain;
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
  void whereNobodyListensTheySaySo() throws Exception {
    Json report = run(1, "web", "127.0.0.1:1");
    assertEquals(0, number(report, "joined"));
    assertEquals(3, number(report, "rejected"));
  }
}
