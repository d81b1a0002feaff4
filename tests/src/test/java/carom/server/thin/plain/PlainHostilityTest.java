package carom.server.thin.plain;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.kryo.KryoClientTransport;
import carom.net.transport.Link;
import carom.server.access.AccessLists;
import carom.server.access.EntryRule;
import carom.server.config.DataFolder;
import carom.server.config.ServerConfig;
import carom.suite.Needs;
import java.io.IOException;
import java.net.BindException;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.SocketException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyPair;
import java.security.KeyPairGenerator;
import java.security.Signature;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: nothing that comes in at the door for stock KryoNet hurts anybody else, nor makes the
 * server send where nobody asked. Method: bytes by hand; after each attempt a canary, a player that
 * was there before, still hears what it says, and a newcomer gets in.
 */
@Needs("sockets")
@Timeout(120)
final class PlainHostilityTest {
  private static final PlainLimits LIMITS =
      PlainLimits.DEFAULT.withConnections(12, 12, 8).withTimes(1_500, 5_000, 1_500);

  @TempDir Path folder;

  private PlainRig rig;
  private PlainDoor door;
  private RawStock canary;
  private Thread breath; // keeps the canary alive, and reads what it is sent
  private int songs;

  @BeforeEach
  void openWithCanary() throws IOException {
    rig = new PlainRig(ServerConfig.defaults().with(ServerConfig.STATUS_INTERVAL, 0), LIMITS, true);
    door = rig.door;
    canary = RawStock.joined(door, "canary", true);
    breath = new Thread(this::breathe);
    breath.start();
  }

  private void breathe() {
    try {
      while (!Thread.interrupted()) {
        canary.send(RawStock.KEEP_ALIVE);
        canary.tcp.getInputStream().skip(canary.tcp.getInputStream().available());
        Thread.sleep(200);
      }
    } catch (IOException | InterruptedException e) {
      Thread.currentThread().interrupt(); // the test is over, or fails by the silence
    }
  }

  @AfterEach
  void canaryLivesAndNewcomersGetIn() throws Exception {
    try (PlainRig closing = rig;
        RawStock bird = canary) {
      assertCanarySings();
      RawStock.joined(door, "newcomer", true).close();
      assertEquals(0, closing.door.counters().errors.get(), () -> "" + closing.door.nextError());
      assertTrue(bird.id > 0);
      breath.interrupt();
      breath.join();
    }
  }

  /** Fails unless the canary's inputs are used and its snapshots arrive. */
  private void assertCanarySings() throws IOException {
    int song = ++songs;
    long until = System.nanoTime() + TimeUnit.SECONDS.toNanos(60);
    for (byte[] heard = null; heard == null || RawStock.inputOf(heard) != song; ) {
      assertTrue(System.nanoTime() - until < 0, "the canary is silent");
      canary.datagram(RawStock.input(song, 0));
      heard = RawStock.receive(canary.udp);
    }
  }

  private static String text(byte[] bytes) {
    return new String(bytes, StandardCharsets.ISO_8859_1);
  }

  private static void eventually(String what, BooleanSupplier condition) throws Exception {
    long until = System.nanoTime() + TimeUnit.SECONDS.toNanos(60);
    while (!condition.getAsBoolean()) {
      assertTrue(System.nanoTime() - until < 0, what);
      Thread.sleep(20);
    }
  }

  @Test
  void badLengthsAndMessagesCloseTheirSenderOnlyAndSayWhy() throws IOException {
    List<byte[]> raw = new ArrayList<>();
    for (int length : new int[] {-1, 0, Integer.MAX_VALUE, Integer.MIN_VALUE, 5_000}) {
      raw.add(ByteBuffer.allocate(8).putInt(length).putInt(0).array());
    }
    raw.add("GET / HTTP/1.1\r\nHost: x\r\n\r\n".getBytes(StandardCharsets.US_ASCII));
    List<byte[]> frames = new ArrayList<>();
    frames.add(new byte[] {0}); // null
    frames.add(new byte[] {1, 0, (byte) 0x82, 'x'}); // a class by its name
    frames.add(new byte[] {PlainIds.REGISTER_TCP, 0});
    frames.add(new byte[] {PlainIds.DISCOVER_HOST});
    frames.add(new byte[] {PlainIds.SNAPSHOT, 1, 1, 0, 0, 0, 0}); // a server's message
    frames.add(new byte[] {PlainIds.KEEP_ALIVE, 1}); // it has no fields
    frames.add(new byte[] {PlainIds.JOIN}); // and no end
    frames.add(new byte[] {PlainIds.CHAT, 0, 0, -1, -1, -1, -1, -1, 7}); // a text of 2 billion
    frames.add(new byte[] {PlainIds.INPUT, 0, -1, -1, -1, -1, 7}); // inputs, too
    frames.add(new byte[] {PlainIds.CUSTOM, (byte) 0x81, -1, -1, -1, -1, 7});
    frames.add(new byte[] {-1, -1, -1, -1, -1, -1});
    frames.add(RawStock.input(1, 0)); // before Join
    frames.add(new byte[PlainDecoder.MAX_BYTES]);
    int n = 0;
    for (boolean joins : new boolean[] {false, true}) {
      for (int i = 0; i < raw.size() + frames.size(); i++) {
        boolean isRaw = i < raw.size();
        byte[] attack = isRaw ? raw.get(i) : frames.get(i - raw.size());
        if (joins && attack[0] == PlainIds.INPUT && attack.length > 8) {
          continue;
        }
        try (RawStock stranger =
            joins ? RawStock.joined(door, "x" + n++, true) : new RawStock(door)) {
          if (isRaw) {
            stranger.raw(attack);
          } else {
            stranger.send(attack);
          }
          String words = stranger.lastWords();
          assertTrue(words.contains(joins ? "PROTOCOL_ERROR" : "BAD_REQUEST"), words);
        }
        assertCanarySings();
      }
    }
  }

  @Test
  void fuzzedMessagesHurtNobodyElse() throws Exception {
    long seed = Long.getLong("carom.seed", System.nanoTime());
    SplittableRandom random = new SplittableRandom(seed);
    byte[][] good = {
      RawStock.join("Eve"),
      RawStock.input(3, 2),
      RawStock.chat("x"),
      RawStock.LIST_ROOMS,
      RawStock.registration(7),
      RawStock.LEAVE,
    };
    for (int i = 0; i < 40; i++) {
      try (RawStock stranger =
          random.nextBoolean() ? RawStock.joined(door, "f" + i, true) : new RawStock(door)) {
        for (int n = 0; n < 20; n++) {
          byte[] message = good[random.nextInt(good.length)].clone();
          for (int k = random.nextInt(3); k >= 0; k--) {
            message[random.nextInt(message.length)] = (byte) random.nextInt();
          }
          message = Arrays.copyOf(message, random.nextInt(message.length + 3) + 1);
          stranger.datagram(message);
          canary.datagram(stranger.udp, message);
          stranger.send(message);
        }
      } catch (SocketException e) {
        // closed in the middle of it, as it should be
      }
      if (i % 10 == 0) {
        assertCanarySings();
      }
    }
    eventually("seed=" + seed, () -> door.connectionCount() == 1);
  }

  @Test
  void garbageDatagramsCloseNoConnection() throws Exception {
    SplittableRandom random = new SplittableRandom(4);
    try (RawStock player = RawStock.joined(door, "Ann", true)) {
      for (int i = 0; i < 300; i++) {
        byte[] bytes = new byte[random.nextInt(80)];
        random.nextBytes(bytes);
        player.datagram(bytes);
        player.datagram(RawStock.LEAVE);
        player.datagram(RawStock.chat("by UDP"));
        player.datagram(new byte[0]);
      }
      player.datagram(new byte[30_000]);
      player.datagram(RawStock.input(1, 0));
      player.send(RawStock.chat("still here"));
      while (!text(player.await(PlainIds.CHAT)).contains("still her")) {
        player.send(RawStock.KEEP_ALIVE);
      }
      assertTrue(door.counters().malformedDatagrams.get() > 0);
      assertTrue(door.counters().excessDatagrams.get() > 0);
    }
  }

  @Test
  void datagramsGoOnlyToTheAddressThatTcpHasShown() throws Exception {
    try (DatagramSocket elsewhere = other();
        DatagramSocket samePlace = new DatagramSocket(0, InetAddress.getLoopbackAddress());
        RawStock player = new RawStock(door)) {
      elsewhere.setSoTimeout(300);
      samePlace.setSoTimeout(300);
      player.datagram(elsewhere, RawStock.registration(player.id)); // another IP address
      player.datagram(samePlace, RawStock.registration(player.id + 1)); // another number
      assertNull(RawStock.receive(elsewhere));
      assertNull(RawStock.receive(samePlace));
      player.registerUdp();
      player.datagram(samePlace, RawStock.registration(player.id)); // it is bound once
      player.send(RawStock.join("Ann"));
      player.await(PlainIds.WELCOME);
      player.datagram(samePlace, RawStock.registration(player.id)); // and not after Join
      player.datagram(elsewhere, RawStock.registration(player.id));
      byte[] snapshot = null;
      for (int i = 0; snapshot == null && i < 100; i++) {
        snapshot = RawStock.receive(player.udp);
      }
      assertNotNull(snapshot);
      assertEquals(PlainIds.SNAPSHOT, snapshot[0]);
      assertNull(RawStock.receive(samePlace));
      assertNull(RawStock.receive(elsewhere));
      assertTrue(door.counters().strangeDatagrams.get() >= 4);
    }
  }

  private static DatagramSocket other() throws IOException {
    try {
      return new DatagramSocket(0, InetAddress.getByName("127.0.0.2"));
    } catch (BindException e) {
      Assumptions.abort("this system has one loopback address");
      throw e;
    }
  }

  @Test
  void nobodyUnknownIsAnswered() throws Exception {
    try (DatagramSocket stranger = new DatagramSocket(0, InetAddress.getLoopbackAddress())) {
      stranger.setSoTimeout(500);
      for (int i = 0; i < 50; i++) {
        canary.datagram(stranger, new byte[] {PlainIds.DISCOVER_HOST});
        canary.datagram(stranger, new byte[] {PlainIds.PING, 2, 0});
        canary.datagram(stranger, RawStock.registration(i));
        canary.datagram(stranger, RawStock.input(i, 0));
      }
      assertNull(RawStock.receive(stranger));
    }
  }

  @Test
  void connectionsThatSayNothingGoAndDisplaceNobodyWhoPlays() throws Exception {
    List<RawStock> silent = new ArrayList<>();
    try {
      for (int i = 0; i < 3 * LIMITS.maxWaiting(); i++) {
        silent.add(new RawStock(door));
      }
      try (RawStock player = RawStock.joined(door, "Ann", true)) {
        assertTrue(player.id > 0);
        assertTrue(door.counters().evicted.get() >= LIMITS.maxWaiting());
        assertCanarySings();
        player.send(RawStock.LEAVE);
        player.await(PlainIds.GOODBYE);
      }
      eventually("they are closed", () -> door.connectionCount() == 1);
      assertTrue(door.counters().expired.get() > 0);
      assertTrue(silent.get(0).lastWords().contains("TOO_MANY_CONNECTIONS"));
      assertTrue(silent.get(silent.size() - 1).lastWords().contains("TOO_SLOW"));
    } finally {
      for (RawStock each : silent) {
        each.close();
      }
    }
  }

  @Test
  void aHalfSentMessageDoesNotKeepAConnection() throws Exception {
    try (RawStock dribbler = new RawStock(door)) {
      dribbler.raw(new byte[] {0, 0});
      eventually("it is closed", () -> door.connectionCount() == 1);
    }
    try (RawStock player = RawStock.joined(door, "Ann", true)) {
      player.raw(new byte[] {0, 0, 1, 0, PlainIds.CHAT, 0});
      eventually("it is closed", () -> door.connectionCount() == 1);
    }
  }

  @Test
  void aClientThatNeverReadsIsClosed() throws Exception {
    try (RawStock deaf = RawStock.joined(door, "deaf", false)) {
      long until = System.nanoTime() + TimeUnit.SECONDS.toNanos(60);
      int n = 0;
      while (door.connectionCount() > 1) {
        assertTrue(System.nanoTime() - until < 0, "it stays");
        deaf.send(RawStock.KEEP_ALIVE);
        deaf.send(RawStock.LIST_ROOMS);
        deaf.send(new byte[] {PlainIds.PING, (byte) (n++ & 0x7f), 0});
        Thread.sleep(5);
      }
    } catch (SocketException e) {
      // closed, as it should be
    }
    eventually("it is forgotten", () -> door.connectionCount() == 1);
  }

  @Test
  void aFloodByTcpClosesItsConnection() throws Exception {
    try (RawStock flood = RawStock.joined(door, "flood", false)) {
      byte[] many = new byte[5 * 4_000];
      for (int i = 0; i < many.length; i += 5) {
        many[i + 3] = 1;
        many[i + 4] = PlainIds.KEEP_ALIVE;
      }
      assertThrows(
          IOException.class,
          () -> {
            for (int i = 0; i < 10_000; i++) {
              flood.raw(many);
            }
          });
    }
    eventually("it is forgotten", () -> door.connectionCount() == 1);
    assertTrue(door.counters().expelled.get() > 0);
  }

  @Test
  void whoLooksAtTheRoomsAndSaysNoMoreHasPlacesOfThisDoorOnly() throws Exception {
    List<RawStock> lookers = new ArrayList<>();
    try (PlainRig wide =
        new PlainRig(
            ServerConfig.defaults()
                .with(ServerConfig.STATUS_INTERVAL, 0)
                .with(ServerConfig.HANDSHAKE_TIMEOUT_MS, 60_000),
            PlainLimits.DEFAULT,
            true)) {
      Link own;
      try (KryoClientTransport transport = new KryoClientTransport()) {
        own = transport.connect("127.0.0.1", wide.server.tcpPort(), 0);
        for (int i = 0; i < 40; i++) {
          RawStock looker = new RawStock(wide.door);
          lookers.add(looker);
          looker.send(RawStock.LIST_ROOMS);
          looker.await(PlainIds.ROOMS);
        }
        for (int i = 0; i < 8; i++) { // there are 32 places
          assertTrue(lookers.get(i).lastWords().contains("Others wait to play"));
        }
        eventually("the own link came in before them", () -> own.state() != Link.State.CONNECTING);
        assertEquals(Link.State.OPEN, own.state(), own.closeReason());
      }
    } finally {
      for (RawStock each : lookers) {
        each.close();
      }
    }
  }

  @Test
  void aJoinTokenCountsOnceHere() throws Exception {
    KeyPair backend = KeyPairGenerator.getInstance("Ed25519").generateKeyPair();
    Path file = folder.resolve("join.pem");
    Files.writeString(
        file,
        "-----BEGIN PUBLIC KEY-----\n"
            + Base64.getEncoder().encodeToString(backend.getPublic().getEncoded())
            + "\n-----END PUBLIC KEY-----\n");
    AccessLists lists = new AccessLists(new DataFolder(folder), false, InstantSource.system());
    lists.demandTokens(file, "us", 0);
    rig.server.admit(lists);
    try {
      byte[] join = RawStock.join("Tom", token(backend));
      try (RawStock first = new RawStock(door)) {
        first.send(join);
        first.await(PlainIds.WELCOME);
        first.send(RawStock.LEAVE);
        first.await(PlainIds.GOODBYE);
      }
      try (RawStock second = new RawStock(door)) {
        second.send(join);
        String words = second.lastWords();
        assertTrue(words.contains("TOKEN_INVALID") && words.contains("has been used"), words);
      }
    } finally {
      rig.server.admit(EntryRule.OPEN);
    }
  }

  private static String token(KeyPair backend) throws GeneralSecurityException {
    Base64.Encoder base64 = Base64.getUrlEncoder().withoutPadding();
    long end = System.currentTimeMillis() / 1_000 + 3_600;
    String signed =
        base64.encodeToString("{\"alg\":\"EdDSA\"}".getBytes(StandardCharsets.UTF_8))
            + "."
            + base64.encodeToString(
                ("{\"sub\":\"42\",\"exp\":" + end + "}").getBytes(StandardCharsets.UTF_8));
    Signature signature = Signature.getInstance("Ed25519");
    signature.initSign(backend.getPrivate());
    signature.update(signed.getBytes(StandardCharsets.UTF_8));
    return signed + "." + base64.encodeToString(signature.sign());
  }

  @Test
  void beyondTheLimitOfConnectionsOneIsToldSo() throws Exception {
    List<RawStock> players = new ArrayList<>();
    try {
      for (int i = 1; i < LIMITS.maxConnections(); i++) {
        players.add(RawStock.joined(door, "p" + i, false));
      }
      try (RawStock late = new RawStock(door)) {
        late.send(RawStock.join("late"));
        assertTrue(late.lastWords().contains("(12)"), "refused");
      }
      door.limitLinks(1, 1); // lower for all
      assertEquals(1, door.counters().refused.get());
    } finally {
      door.limitLinks(Integer.MAX_VALUE, Integer.MAX_VALUE);
      for (RawStock player : players) {
        player.close();
      }
    }
    eventually("all are gone", () -> door.connectionCount() == 1);
  }
}
