package carom.server.query;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.bots.Bot;
import carom.net.transport.Impairment;
import carom.suite.Needs;
import carom.testkit.Stepper;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * Goal: every byte of an answer is as specified, and nobody can use answers against others. Method:
 * the bytes of python-a2s 1.4.2, which {@link StockClientsTest} runs itself, and forged ones.
 */
@Needs("sockets")
@Timeout(60)
final class StatusQueryTest {
  private static final InetAddress LOOPBACK = InetAddress.getLoopbackAddress();
  private static final byte[] INFO =
      query('T', "Source Engine Query\0".getBytes(StandardCharsets.US_ASCII));

  private Stepper stepper;
  private StatusQuery server;
  private Thread play;

  private static byte[] query(char kind, byte... rest) {
    return ByteBuffer.allocate(5 + rest.length).putInt(-1).put((byte) kind).put(rest).array();
  }

  @BeforeEach
  void start() throws IOException {
    stepper = Stepper.of("arena");
    stepper.join("Ann", Impairment.NONE, new Bot(Stepper.SEED));
    stepper.join("Zoë", Impairment.NONE, new Bot(Stepper.SEED));
    stepper.run(2);
    StatusFacts facts =
        new StatusFacts("My server", "1.2", 54_555, 54_777, stepper.server().rooms());
    server = new StatusQuery(LOOPBACK, 0, facts);
    play =
        new Thread(
            () -> {
              while (!Thread.interrupted()) {
                stepper.run(0.01);
              }
            });
    play.start();
  }

  @AfterEach
  void stop() throws InterruptedException {
    play.interrupt();
    play.join();
    server.close();
    stepper.close();
  }

  private ByteBuffer ask(DatagramSocket socket, byte[] query) throws IOException {
    socket.setSoTimeout(10_000);
    socket.send(new DatagramPacket(query, query.length, LOOPBACK, server.port()));
    DatagramPacket answer = new DatagramPacket(new byte[2_000], 2_000);
    socket.receive(answer);
    return ByteBuffer.wrap(answer.getData(), 0, answer.getLength()).order(ByteOrder.LITTLE_ENDIAN);
  }

  /** Asks without a challenge and then with the one that was given. */
  private ByteBuffer askTwice(char kind, byte[] begin) throws IOException {
    try (DatagramSocket socket = new DatagramSocket()) {
      byte[] first = kind == 'T' ? begin : query(kind, (byte) -1, (byte) -1, (byte) -1, (byte) -1);
      ByteBuffer challenge = ask(socket, first);
      assertEquals(9, challenge.remaining());
      assertEquals(-1, challenge.getInt());
      assertEquals('A', challenge.get());
      assertTrue(9 <= first.length, "the answer is larger than the question");
      byte[] second = Arrays.copyOf(begin, begin.length + 4);
      challenge.get(second, begin.length, 4);
      ByteBuffer answer = ask(socket, second);
      assertEquals(-1, answer.getInt());
      return answer;
    }
  }

  private static String text(ByteBuffer from) {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    for (byte next = from.get(); next != 0; next = from.get()) {
      bytes.write(next);
    }
    return bytes.toString(StandardCharsets.UTF_8);
  }

  @Test
  void infoTellsNameLevelPlayersAndPorts() throws IOException {
    ByteBuffer in = askTwice('T', INFO);
    assertEquals('I', in.get());
    assertEquals(17, in.get());
    assertEquals("My server", text(in));
    assertEquals("Corner Pocket", text(in));
    assertEquals("carom", text(in));
    assertEquals("arena", text(in));
    assertEquals(0, in.getShort());
    assertEquals(2, in.get());
    assertEquals(64, in.get());
    assertEquals(0, in.get());
    assertEquals('d', in.get());
    assertTrue("lwm".indexOf(in.get()) >= 0);
    assertEquals(0, in.getShort());
    assertEquals("1.2", text(in));
    assertEquals(0xa0, in.get() & 0xff);
    assertEquals(54_555, in.getShort() & 0xffff);
    assertTrue(text(in).startsWith("carom,tcp=54555,udp=54777,protocol="));
    assertEquals(0, in.remaining());
  }

  @Test
  void playersAndRulesAreListed() throws IOException {
    ByteBuffer in = askTwice('U', query('U'));
    assertEquals('D', in.get());
    assertEquals(2, in.get());
    for (String name : new String[] {"Ann", "Zoë"}) {
      in.get();
      assertEquals(name, text(in));
      assertEquals(0, in.getInt());
      float seconds = in.getFloat();
      assertTrue(seconds > 1 && seconds < 1_000, "seconds=" + seconds);
    }
    assertEquals(0, in.remaining());
    in = askTwice('V', query('V'));
    assertEquals('E', in.get());
    int count = in.getShort();
    String last = "";
    for (int i = 0; i < count; i++) {
      last = text(in) + "=" + text(in);
    }
    assertEquals("room_1=arena, Corner Pocket, 2/64", last);
    assertEquals(0, in.remaining());
  }

  @Test
  void aServerOfAFleetWithoutRoomsAnswers() throws IOException {
    server.close();
    server = new StatusQuery(LOOPBACK, 0, new StatusFacts("My server", "1.2", 1, 2, List.of()));
    ByteBuffer in = askTwice('T', INFO);
    assertEquals('I', in.get());
    assertEquals(17, in.get());
    assertEquals("My server", text(in));
    assertEquals("", text(in));
    assertEquals('E', askTwice('V', query('V')).get());
    assertEquals('D', askTwice('U', query('U')).get());
  }

  @Test
  void aChallengeIsGoodForOneAddressAlone() {
    InetSocketAddress ann = new InetSocketAddress(LOOPBACK, 1_000);
    InetSocketAddress bob = new InetSocketAddress(LOOPBACK, 1_001);
    byte[] given = Arrays.copyOfRange(server.answer(INFO, ann), 5, 9);
    byte[] stolen = Arrays.copyOf(INFO, INFO.length + 4);
    System.arraycopy(given, 0, stolen, INFO.length, 4);
    assertEquals(9, server.answer(stolen, bob).length);
    assertNotEquals(9, server.answer(stolen, ann).length);
    assertArrayEquals(server.answer(INFO, bob), server.answer(stolen, bob));
  }

  @Test
  void whatIsNoQueryGetsNoAnswerAndNothingGetsMoreThanItSent() {
    InetSocketAddress from = new InetSocketAddress(LOOPBACK, 1_000);
    assertNull(server.answer(new byte[0], from));
    assertNull(server.answer(query('T'), from));
    assertNull(server.answer(query('U'), from));
    assertNull(server.answer(query('Z', new byte[20]), from));
    assertNull(server.answer(INFO, new InetSocketAddress(LOOPBACK, 0)));
    Random random = new Random(Stepper.SEED);
    for (int i = 0; i < 1_000; i++) {
      byte[] bytes = new byte[random.nextInt(64)];
      random.nextBytes(bytes);
      if (bytes.length > 4 && random.nextBoolean()) {
        Arrays.fill(bytes, 0, 4, (byte) -1);
        bytes[4] = (byte) "TUVI".charAt(random.nextInt(4));
      }
      byte[] answer = server.answer(bytes, from);
      assertTrue(answer == null || answer.length <= bytes.length, Arrays.toString(bytes));
    }
  }

  @Test
  void aFloodUsesUpNothingOfOthers() throws IOException {
    long second = 1_000_000_000L;
    QueryBudgets budgets = new QueryBudgets(new Random().nextInt());
    InetAddress hostile = InetAddress.getByName("192.0.2.1");
    for (int i = 0; i < 10_000; i++) { // one socket
      boolean allowed = budgets.allow(new InetSocketAddress(hostile, 1_000), 0);
      assertEquals(i < QueryBudgets.MOST_OF_SOCKET, allowed, "i=" + i);
    }
    for (int i = 0; i < 50; i++) { // honest ones, also behind the same address
      InetAddress honest = InetAddress.getByName("198.51.100." + i);
      assertTrue(budgets.allow(new InetSocketAddress(honest, 2_000), 0), "i=" + i);
    }
    assertTrue(budgets.allow(new InetSocketAddress(hostile, 1_001), 0));
    int ofHost = 0;
    for (int i = 0; i < 10_000; i++) { // all sockets of a host
      ofHost += budgets.allow(new InetSocketAddress(hostile, 1_100 + i), second) ? 1 : 0;
    }
    assertEquals(QueryBudgets.MOST_OF_HOST, ofHost);
    assertTrue(
        budgets.allow(new InetSocketAddress(InetAddress.getByName("198.51.100.9"), 7), second));
    int ofAll = 0;
    for (int i = 0; i < 40_000; i++) { // a host each
      InetAddress any =
          InetAddress.getByAddress(new byte[] {10, (byte) (i >> 16), (byte) (i >> 8), (byte) i});
      ofAll += budgets.allow(new InetSocketAddress(any, 9), 2 * second) ? 1 : 0;
    }
    assertEquals(QueryBudgets.MOST_OF_ALL, ofAll);
  }

  @Test
  void honestQueriesAreAnsweredBesideAFlood() throws Exception {
    Thread flood =
        new Thread(
            () -> {
              try (DatagramSocket socket = new DatagramSocket()) {
                while (!Thread.interrupted()) {
                  for (int i = 0; i < 100; i++) {
                    socket.send(new DatagramPacket(INFO, INFO.length, LOOPBACK, server.port()));
                  }
                  Thread.sleep(10);
                }
              } catch (IOException | InterruptedException e) {
                Thread.currentThread().interrupt();
              }
            });
    flood.start();
    try {
      for (int i = 0; i < 25; i++) {
        try (DatagramSocket socket = new DatagramSocket()) {
          byte[] challenge = new byte[4];
          ask(socket, INFO).position(5).get(challenge);
          byte[] again = Arrays.copyOf(INFO, INFO.length + challenge.length);
          System.arraycopy(challenge, 0, again, INFO.length, challenge.length);
          assertEquals('I', ask(socket, again).get(4), "i=" + i);
        }
        Thread.sleep(20);
      }
    } finally {
      flood.interrupt();
      flood.join();
    }
  }
}
