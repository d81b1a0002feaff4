package carom.server.thin.plain;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.server.config.ServerConfig;
import carom.server.thin.plain.PlainRig.Stock;
import carom.server.thin.plain.PlainRig.Where;
import carom.suite.Needs;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: an unmodified KryoNet 2.22.0-RC1 with its Kryo 2.24.0 plays. Method: programs with nothing
 * else of Carom than carom-plain, each in a process of its own, against a server on real ports.
 */
@Needs("processes")
@Timeout(180)
final class PlainClientTest {
  private static final Path HOME = Path.of(System.getProperty("java.home"));
  private static final Path FIRST =
      Path.of("..", "docs", "plain", "src", "main", "java", "FirstClient.java");
  private static final Pattern PLACE = Pattern.compile("I am at (\\S+), (\\S+)");

  @TempDir Path folder;

  private PlainRig rig;
  private StockJvm stock;

  @BeforeEach
  void open() throws Exception {
    stock = new StockJvm(folder, StockJvm.resource("StockClient.java"), FIRST);
    rig = PlainRig.open();
  }

  @AfterEach
  void close() {
    if (rig != null) {
      rig.close();
      assertEquals(0, rig.door.counters().errors.get(), () -> "" + rig.door.nextError());
    }
  }

  private Stock connect(boolean udp) throws Exception {
    Stock client = new Stock(stock, HOME);
    client.type("connect " + rig.door.tcpPort() + (udp ? " " + rig.door.udpPort() : ""));
    client.await("^connected");
    return client;
  }

  private Stock join(String name, boolean udp) throws Exception {
    Stock client = connect(udp);
    client.type("join " + name);
    client.await("^match");
    return client;
  }

  @Test
  void theClientOfThePagePlaysOnThisJvmAndOnLaterOnes() throws Exception {
    for (Path home : StockJvm.homes()) {
      Path output = folder.resolve("output.txt");
      Process program =
          stock
              .program(
                  home,
                  "FirstClient",
                  "localhost",
                  String.valueOf(rig.door.tcpPort()),
                  String.valueOf(rig.door.udpPort()))
              .redirectErrorStream(true)
              .redirectOutput(output.toFile())
              .start();
      try {
        assertTrue(program.waitFor(PlainRig.MOST_SECONDS, TimeUnit.SECONDS));
        String said = new String(Files.readAllBytes(output), StandardCharsets.UTF_8);
        assertEquals(0, program.exitValue(), said);
        assertTrue(said.contains("\nhello\n"), said);
        assertTrue(said.contains("You left the game."), said);
        List<String> places =
            PLACE.matcher(said).results().map(place -> place.group(1)).distinct().toList();
        assertTrue(places.size() >= 3, said); // it walks
      } finally {
        program.destroyForcibly();
      }
    }
  }

  @Test
  void aPlayerMovesItsBodyChatsAndLeaves() throws Exception {
    try (Stock ann = join("Ann", true);
        Stock bob = join("Bob", false)) {
      ann.await("^player \\d+ Bob");
      Where before = ann.awaitBody();
      assertTrue(before.bodies() >= 2, before.toString());
      ann.type("hold 0 " + (before.x() > 0 ? -1 : 1) + " 0");
      Where after = ann.where();
      for (int i = 0; Math.abs(after.x() - before.x()) < 1 && i < 600; i++) {
        Thread.sleep(20);
        after = ann.where();
      }
      assertTrue(Math.abs(after.x() - before.x()) >= 1, before + " " + after);
      assertTrue(after.used() > 0, "the server says which input it used: " + after);
      ann.type("chat hello");
      assertEquals("hello", bob.await("^chat \\d+ (\\S+)").group(1));
      ann.type("emote HELLO");
      bob.await("^emote \\d+ HELLO");
      bob.type("rooms");
      bob.await("^room 1 arena 2/64");
      ann.type("ping");
      Matcher ping = ann.await("^ping (\\S+) (\\d+)");
      assertTrue(Integer.parseInt(ping.group(1)) >= 0, ping.group());
      ann.type("alive");
      ann.type("leave");
      ann.await("^goodbye LEFT");
      ann.await("^disconnected");
      bob.await("^gone");
      assertTrue(!bob.said().contains("nameless"), bob.said());
    }
  }

  @Test
  void withoutUdpSnapshotsComeByTcp() throws Exception {
    try (PlainRig streams =
            new PlainRig(
                ServerConfig.defaults().with(ServerConfig.STATUS_INTERVAL, 0),
                PlainLimits.DEFAULT,
                false);
        Stock ann = new Stock(stock, HOME)) {
      assertEquals(0, streams.door.udpPort());
      ann.type("connect " + streams.door.tcpPort());
      ann.await("^connected");
      ann.type("join Ann");
      ann.await("^match");
      Where before = ann.awaitBody();
      ann.type("hold 0 " + (before.x() > 0 ? -1 : 1) + " 0");
      Where after = ann.where();
      for (int i = 0; Math.abs(after.x() - before.x()) < 1 && i < 600; i++) {
        Thread.sleep(20);
        after = ann.where();
      }
      assertTrue(Math.abs(after.x() - before.x()) >= 1, before + " " + after);
      ann.type("rate 5");
      ann.type("leave");
      ann.await("^goodbye LEFT");
    }
  }

  @Test
  void aLostPlayerTakesTheSeatAgainByItsSecret() throws Exception {
    String secret;
    int player;
    int body;
    try (Stock ann = connect(true)) {
      ann.type("join Ann");
      secret = ann.await("^welcome secret=(\\S+) version=1 tickRate=60").group(1);
      player = Integer.parseInt(ann.await("^match player=(\\d+)").group(1));
      body = ann.awaitBody().own();
      ann.type("break");
    }
    try (Stock other = join("Bob", true);
        Stock again = connect(true)) {
      assertNotEquals(body, other.awaitBody().own());
      again.type("join Ann " + secret);
      assertEquals(player, Integer.parseInt(again.await("^match player=(\\d+)").group(1)));
      assertEquals(body, again.awaitBody().own(), "the body waited");
      again.type("leave");
      again.await("^goodbye LEFT");
    }
  }

  @Test
  void anotherVersionIsRefusedByItsNumber() throws Exception {
    try (Stock old = connect(true)) {
      old.type("version 7");
      assertTrue(
          old.await("^refused PROTOCOL_VERSION (.*)").group(1).contains("yours 7"), old.said());
      old.await("^disconnected");
    }
  }

  @Test
  void whenTheServerStopsAProgramIsToldSo() throws Exception {
    try (Stock ann = join("Ann", true)) {
      rig.close();
      ann.await("^goodbye SERVER_STOPPING");
      ann.await("^disconnected");
    }
  }

  @Test
  void programsThatComeAndGoLeaveNothingBehind() throws Exception {
    try (Stock ann = connect(true)) {
      for (int i = 0; i < 5; i++) {
        if (i > 0) {
          ann.type("connect " + rig.door.tcpPort() + " " + rig.door.udpPort());
          ann.await("^connected");
        }
        ann.type("join Ann");
        ann.await("^match");
        ann.awaitBody();
        ann.type(i % 2 == 0 ? "leave" : "break");
        ann.await("^disconnected");
      }
    }
    long until = System.nanoTime() + TimeUnit.SECONDS.toNanos(PlainRig.MOST_SECONDS);
    while (rig.door.connectionCount() > 0) {
      assertTrue(System.nanoTime() - until < 0, "connections=" + rig.door.connectionCount());
      Thread.sleep(20);
    }
  }
}
