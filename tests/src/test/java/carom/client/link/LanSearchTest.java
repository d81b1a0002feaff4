package carom.client.link;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.bots.Bot;
import carom.net.protocol.Protocol;
import carom.net.transport.Impairment;
import carom.server.query.StatusFacts;
import carom.server.query.StatusQuery;
import carom.suite.Needs;
import carom.testkit.Stepper;
import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Random;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * Goal: a player sees the servers of the network as they are, and no answer can harm or swamp the
 * list. Method: a server's real answers, a hostile machine's, and random bytes.
 */
@Needs("sockets")
@Timeout(60)
final class LanSearchTest {
  private static final InetAddress LOOPBACK = InetAddress.getLoopbackAddress();

  private static void eventually(BooleanSupplier condition) throws InterruptedException {
    while (!condition.getAsBoolean()) {
      Thread.sleep(5); // the test's time limit ends it
    }
  }

  @Test
  void aServerIsFoundWithWhatItPlaysAndIsForgottenWhenItStops() throws Exception {
    try (Stepper stepper = Stepper.of("arena")) {
      stepper.join("Ann", Impairment.NONE, new Bot(Stepper.SEED));
      stepper.run(2);
      StatusFacts facts =
          new StatusFacts("My server", "1.2", 4_001, 4_002, stepper.server().rooms());
      StatusQuery server = new StatusQuery(LOOPBACK, 0, facts);
      try (LanSearch search = new LanSearch(server.port())) {
        eventually(() -> !search.servers().isEmpty());
        LanServer found = search.servers().get(0);
        assertEquals(new ServerAddress("localhost", 4_001, 0), found.address());
        assertEquals(
            new StatusAnswer("My server", "Corner Pocket", "arena", 1, 64, 4_001, Protocol.VERSION),
            found.status());
        assertTrue(found.pingMs() >= 0 && found.pingMs() < 10_000, found::toString);
        server.close();
        eventually(() -> search.servers().isEmpty());
      }
    }
  }

  /** A machine that answers every question with many servers, and to nobody's question. */
  private static void flood(DatagramSocket socket) {
    try {
      while (true) {
        DatagramPacket question = new DatagramPacket(new byte[100], 100);
        socket.receive(question);
        boolean challenged = question.getLength() > 25;
        for (int i = 0; i < 40; i++) {
          byte[] answer =
              challenged
                  ? info("evil \u202e\n" + "x".repeat(500), "tcp=" + (100 + i) + ",protocol=9")
                  : new byte[] {-1, -1, -1, -1, 'A', 1, 2, 3, 4};
          socket.send(new DatagramPacket(answer, answer.length, question.getSocketAddress()));
        }
      }
    } catch (IOException closed) {
      // the test is over
    }
  }

  private static byte[] info(String name, String keywords) {
    ByteBuffer out = ByteBuffer.allocate(1_400).order(ByteOrder.LITTLE_ENDIAN);
    out.putInt(-1).put((byte) 'I').put((byte) 17);
    for (String text : new String[] {name, "level", "carom", "arena"}) {
      out.put(text.getBytes(StandardCharsets.UTF_8)).put((byte) 0);
    }
    out.putShort((short) 0)
        .put(new byte[] {3, 64, 0, 'd', 'l', 0, 0})
        .put("1\0".getBytes(StandardCharsets.UTF_8));
    out.put((byte) 0xa0).putShort((short) 1);
    out.put(keywords.getBytes(StandardCharsets.UTF_8)).put((byte) 0);
    byte[] bytes = new byte[out.position()];
    out.flip().get(bytes);
    return bytes;
  }

  @Test
  void aHostileMachineFillsNoListAndItsTextsAreCutAndClean() throws Exception {
    DatagramSocket socket = new DatagramSocket(0, LOOPBACK);
    Thread hostile = new Thread(() -> flood(socket));
    hostile.start();
    try (LanSearch search = new LanSearch(socket.getLocalPort())) {
      eventually(() -> search.servers().size() == LanSearch.MAX_PER_HOST);
      Thread.sleep(3_000); // another round
      List<LanServer> found = search.servers();
      assertEquals(LanSearch.MAX_PER_HOST, found.size());
      for (LanServer server : found) {
        String name = server.status().name();
        assertEquals(StatusAnswer.MAX_TEXT, name.length());
        assertTrue(name.startsWith("evil  xxx"), name);
      }
    } finally {
      socket.close();
      hostile.join();
    }
  }

  @Test
  void anAnswerThatNobodyAskedForIsIgnored() throws Exception {
    try (DatagramSocket stranger = new DatagramSocket(0, LOOPBACK);
        DatagramSocket asked = new DatagramSocket(0, LOOPBACK);
        LanSearch search = new LanSearch(asked.getLocalPort())) {
      DatagramPacket question = new DatagramPacket(new byte[100], 100);
      asked.receive(question);
      byte[] answer = info("stranger", "tcp=1,protocol=9");
      stranger.send(new DatagramPacket(answer, answer.length, question.getSocketAddress()));
      asked.receive(question); // the next round, after the answer was looked at
      assertEquals(List.of(), search.servers());
    }
  }

  @Test
  void noBytesDoHarm() {
    long seed = System.nanoTime();
    Random random = new Random(seed);
    byte[] right = info("name", "carom,tcp=54555,udp=54777,protocol=9");
    assertEquals(54_555, StatusAnswer.parse(ByteBuffer.wrap(right)).tcpPort());
    for (int i = 0; i < 50_000; i++) {
      byte[] bytes = right.clone();
      for (int flips = random.nextInt(4); flips >= 0; flips--) {
        bytes[random.nextInt(bytes.length)] = (byte) random.nextInt();
      }
      StatusAnswer answer =
          StatusAnswer.parse(ByteBuffer.wrap(bytes, 0, random.nextInt(bytes.length + 1)));
      if (answer != null) {
        assertTrue(answer.name().length() <= StatusAnswer.MAX_TEXT, "seed=" + seed);
        assertTrue(answer.tcpPort() >= 1 && answer.tcpPort() <= 65_535, "seed=" + seed);
        assertTrue(answer.name().chars().noneMatch(Character::isISOControl), "seed=" + seed);
      }
    }
    assertNull(StatusAnswer.parse(ByteBuffer.wrap(info("n", "tcp=70000,protocol=9"))));
    assertNull(StatusAnswer.parse(ByteBuffer.wrap(info("n", "udp=1"))));
  }
}
