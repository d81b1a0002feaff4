package carom.net.kryo;

import static carom.net.kryo.Network.eventually;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.admission.WorkProof;
import carom.net.frame.Frame;
import carom.net.kryo.server.KryoLimits;
import carom.net.protocol.ClientMessage;
import carom.net.protocol.ClientMessageCodec;
import carom.net.protocol.ServerMessage;
import carom.net.seal.DatagramSealer;
import carom.net.transport.Link;
import carom.suite.Needs;
import java.io.IOException;
import java.io.OutputStream;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.SocketException;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * Goal: no attack on the open ports affects other clients. Method: after each attempt a canary, a
 * link that was there before, still exchanges messages and datagrams, and a newcomer gets in.
 */
@Needs("sockets")
@Timeout(30)
final class KryoHostilityTest {
  private static final KryoLimits LIMITS =
      KryoLimits.DEFAULT.withTimes(120, 3_500).withConnections(60, 50);

  private Network network;
  private Network.Pair canary;

  @BeforeEach
  void startWithCanary() {
    network = new Network(LIMITS);
    canary = network.pair();
  }

  @AfterEach
  void canaryLivesAndNewcomersGetIn() {
    try (Network closing = network) {
      assertCanarySings();
      Network.Pair newcomer = closing.pair();
      assertTrue(newcomer.client.sendDatagram(new byte[1], 0, 1));
      assertEquals(null, closing.server.counters().errors.last());
    }
  }

  private void assertCanarySings() {
    int messages = canary.atClient.messages.size();
    int datagrams = canary.atServer.datagrams.size();
    assertTrue(canary.server.send(new ServerMessage.Notice("sing")), canary.server::closeReason);
    eventually(
        () -> {
          canary.client.sendDatagram(new byte[] {1, 2, 3}, 0, 3);
          canary.poll();
          return canary.atClient.messages.size() > messages
              && canary.atServer.datagrams.size() > datagrams;
        },
        () -> canary.client + " " + canary.client.closeReason() + canary.server.closeReason());
    assertArrayEquals(
        new byte[] {1, 2, 3}, canary.atServer.datagrams.get(canary.atServer.datagrams.size() - 1));
  }

  @Test
  void zeroBytesAndGarbageDatagramsFromNobody() throws IOException {
    long seed = Long.getLong("carom.seed", System.nanoTime());
    SplittableRandom random = new SplittableRandom(seed);
    try (DatagramChannel udp = DatagramChannel.open()) {
      udp.connect(new InetSocketAddress(Network.HOST, network.server.udpPort()));
      udp.write(ByteBuffer.allocate(0));
      udp.write(ByteBuffer.allocate(1));
      for (int i = 0; i < 2_000; i++) {
        byte[] bytes = new byte[random.nextInt(i % 10 == 0 ? 9_000 : 40)];
        random.nextBytes(bytes);
        if (bytes.length > 0 && i % 2 == 0) {
          bytes[0] = (byte) random.nextInt(10);
        }
        udp.write(ByteBuffer.wrap(bytes));
      }
    }
    assertCanarySings();
    assertTrue(network.server.counters().strangeDatagrams.get() > 0, "seed=" + seed);
  }

  @Test
  void garbageDatagramsFromALinkAreDroppedAndTheLinkStays() throws IOException {
    long seed = Long.getLong("carom.seed", System.nanoTime());
    SplittableRandom random = new SplittableRandom(seed);
    try (RawPeer stranger = new RawPeer(network)) {
      Link link = stranger.join();
      stranger.raw();
      stranger.raw(0);
      stranger.raw(Frame.DATAGRAM);
      stranger.raw(Frame.DATAGRAM, 77); // not sealed
      stranger.datagram(0);
      stranger.datagram(Frame.DATAGRAM); // no payload
      stranger.datagram(Frame.KEEP_ALIVE, 1); // has no fields
      stranger.udp.write(ByteBuffer.wrap(stranger.sealed(Frame.DATAGRAM, new byte[1_201])));
      stranger.udp.write(ByteBuffer.wrap(stranger.sealed(Frame.DATAGRAM, new byte[20_000])));
      stranger.register(stranger.id, stranger.token); // again
      stranger.register(stranger.id + 1, 5);
      stranger.datagram(Frame.ANSWER, 0, 0, 0, 0, 0, 0, 0, 0);
      for (int i = 0; i < 100; i++) {
        byte[] bytes = new byte[random.nextInt(60)];
        random.nextBytes(bytes);
        stranger.udp.write(ByteBuffer.wrap(bytes)); // not sealed
        if (bytes.length > 0 && bytes[0] != Frame.DATAGRAM) {
          stranger.udp.write(
              ByteBuffer.wrap(
                  stranger.sealed(bytes[0], Arrays.copyOfRange(bytes, 1, bytes.length))));
        }
      }
      stranger.datagram(Frame.DATAGRAM, 77);
      Network.Inbox inbox = new Network.Inbox();
      eventually(
          () -> {
            link.poll(inbox, 100);
            return !inbox.datagrams.isEmpty();
          },
          () -> "seed=" + seed);
      assertEquals(1, inbox.datagrams.size());
      assertArrayEquals(new byte[] {77}, inbox.datagrams.get(0));
      assertEquals(Link.State.OPEN, link.state());
    }
  }

  @Test
  void badLengthsAndBadFramesCloseTheirSenderOnly() throws IOException {
    byte[] hello = ClientMessageCodec.encode(new ClientMessage.Hello(1, 2, "Eve", 0));
    byte[] message = new byte[1 + hello.length];
    message[0] = Frame.MESSAGE;
    System.arraycopy(hello, 0, message, 1, hello.length);
    List<byte[]> attacks = new ArrayList<>();
    for (int length : new int[] {-1, 0, Integer.MAX_VALUE, Integer.MIN_VALUE, 5_000}) {
      attacks.add(ByteBuffer.allocate(8).putInt(length).putInt(0).array());
    }
    attacks.add("GET / HTTP/1.1\r\nHost: x\r\n\r\n".getBytes(StandardCharsets.US_ASCII));
    attacks.add(new byte[] {0, 0, 0, 1, 5}); // a BYE that isn't sealed
    List<byte[]> sealed = new ArrayList<>();
    sealed.add(new byte[] {99}); // unknown tag
    sealed.add(new byte[] {Frame.KEEP_ALIVE, 1}); // it has no fields
    sealed.add(new byte[] {Frame.KEY_CONFIRM}); // again
    sealed.add(new byte[] {Frame.MESSAGE}); // no message
    sealed.add(new byte[] {Frame.MESSAGE, 0x43}); // a server's message
    sealed.add( // string with a huge length, in Kryo's own encoding
        new byte[] {Frame.MESSAGE, 3, -1, -1, -1, -1, 7});
    byte[] longName = message.clone();
    longName[1 + 1 + 4 + 8 + 8] = 127; // the name's length
    sealed.add(longName);
    int unsealed = attacks.size();
    attacks.addAll(sealed);
    for (int i = 0; i < attacks.size(); i++) {
      byte[] attack = attacks.get(i);
      try (RawPeer stranger = new RawPeer(network)) {
        Link link = stranger.join();
        if (i < unsealed) {
          stranger.write(attack);
        } else {
          stranger.frame(attack);
        }
        assertTrue(stranger.closedByServer(), Arrays.toString(attack));
        eventually(() -> link.state() == Link.State.CLOSED, link::toString);
      }
      assertCanarySings();
    }
  }

  @Test
  void fuzzedFramesNeverHurtAnybodyElse() throws IOException {
    long seed = Long.getLong("carom.seed", System.nanoTime());
    SplittableRandom random = new SplittableRandom(seed);
    for (int i = 0; i < 30; i++) {
      try (RawPeer stranger = new RawPeer(network)) {
        Link link = stranger.join();
        for (int n = 0; n < 20 && link.state() == Link.State.OPEN; n++) {
          byte[] content = new byte[1 + random.nextInt(300)];
          random.nextBytes(content);
          content[0] = (byte) random.nextInt(12);
          stranger.frame(content);
          stranger.udp.write(ByteBuffer.wrap(content));
          stranger.udp.write(
              ByteBuffer.wrap(
                  stranger.sealed(content[0], Arrays.copyOfRange(content, 1, content.length))));
        }
      } catch (SocketException x) {
        // closed in the middle of it, as it should be
      }
    }
    assertCanarySings();
    assertEquals(0, network.server.counters().errors.get(), "seed=" + seed);
  }

  @Test
  void talkingBeforeTheHandshakeClosesTheTalker() throws IOException {
    try (RawPeer stranger = new RawPeer(network)) {
      stranger.frame(new byte[] {Frame.KEEP_ALIVE});
      assertTrue(stranger.closedByServer());
    }
  }

  @Test
  void aSlowFrameIsNoLifeSign() throws IOException {
    try (Network patient = new Network(LIMITS.withTimes(500, 400))) {
      Network before = network;
      network = patient;
      try (RawPeer stranger = new RawPeer(network)) {
        Link link = stranger.join();
        OutputStream out = stranger.tcp.getOutputStream();
        out.write(new byte[] {0, 0, 4, 0});
        long start = System.nanoTime();
        eventually(
            () -> {
              try {
                out.write(0);
              } catch (IOException x) {
                assertTrue(System.nanoTime() - start > 300_000_000L);
              }
              return link.state() == Link.State.CLOSED;
            },
            link::toString);
        assertEquals("nothing heard for 400 ms", link.closeReason());
      } finally {
        network = before;
      }
    }
  }

  @Test
  void connectionsThatNeverRegisterUdpAreDroppedInTime() throws IOException {
    List<RawPeer> strangers = new ArrayList<>();
    for (int i = 0; i < 40; i++) {
      strangers.add(new RawPeer(network));
    }
    assertCanarySings();
    for (RawPeer stranger : strangers) {
      assertTrue(stranger.closedByServer());
      stranger.close();
    }
    assertEquals(40, network.server.counters().expired.get());
  }

  @Test
  void aCapOnConnectionsHoldsAgainstAFlood() throws IOException {
    KryoLimits few = LIMITS.withTimes(2_000, 2_500).withPending(10);
    try (Network strict = new Network(few)) {
      List<Socket> sockets = new ArrayList<>();
      for (int i = 0; i < 40; i++) {
        sockets.add(new Socket(Network.HOST, strict.server.tcpPort()));
      }
      eventually(
          () -> strict.server.counters().accepted.get() == 40,
          () -> "accepted=" + strict.server.counters().accepted.get());
      assertEquals(30, strict.server.counters().evicted.get());
      strict.pair(); // those that have waited longest give way
      for (Socket socket : sockets) {
        socket.close();
      }
      strict.pair();
    }
  }

  @Test
  void whoWasToldToGoAndStaysKeepsNobodyOut() throws IOException {
    try (Network strict = new Network(LIMITS.withConnections(8, 50))) {
      List<RawPeer> peers = new ArrayList<>();
      for (int i = 0; i < 40; i++) {
        RawPeer peer = new RawPeer(strict);
        peers.add(peer);
        peer.join().close("refused");
      }
      Network.Pair newcomer = strict.pair();
      assertEquals(Link.State.OPEN, newcomer.client.state());
      for (RawPeer peer : peers) {
        peer.close();
      }
    }
  }

  @Test
  void underPressureAPeerThatHasNotWorkedGetsNoFurther() throws IOException {
    KryoLimits few = LIMITS.withTimes(2_000, 2_500).withPending(10);
    try (Network strict = new Network(few)) {
      List<Socket> sockets = new ArrayList<>();
      for (int i = 0; i < 6; i++) {
        sockets.add(new Socket(Network.HOST, strict.server.tcpPort()));
      }
      eventually(
          () -> strict.server.counters().accepted.get() == 6,
          () -> "accepted=" + strict.server.counters().accepted.get());
      try (RawPeer peer = new RawPeer(strict)) {
        int bits = peer.greeting[4 + 8 + 2 + 1];
        assertTrue(bits >= 12, "bits=" + bits);
        WorkProof proof = new WorkProof();
        long wrong = 0;
        while (proof.isSolved(peer.id, peer.token, bits, wrong)) {
          wrong++;
        }
        peer.register(peer.id, peer.token, wrong);
        eventually(
            () -> strict.server.counters().strangeDatagrams.get() == 1,
            () -> "the registration counted");
        peer.register(peer.id, peer.token, proof.solve(peer.id, peer.token, bits));
        assertEquals(Frame.REGISTER_UDP, peer.readFrame()[0]);
      }
      for (Socket socket : sockets) {
        socket.close();
      }
    }
  }

  @Test
  void anAddressIsNotHijackedWithoutTheToken() throws IOException {
    try (RawPeer victim = new RawPeer(network);
        RawPeer thief = new RawPeer(network)) {
      for (int i = -2; i < 4; i++) {
        thief.register(victim.id + i, thief.token + 1);
        thief.register(victim.id, i);
      }
      Network.pause(50);
      Link link = victim.join();
      assertTrue(link.sendDatagram(new byte[] {42}, 0, 1));
      byte[] received;
      do {
        received = victim.receive();
      } while (received[0] != Frame.DATAGRAM);
      assertEquals(42, received[1]);
      thief.udp.configureBlocking(false);
      assertEquals(0, thief.udp.read(ByteBuffer.allocate(100)), "the thief received something");
    }
  }

  @Test
  void nobodyReceivesAStreamThatHeDidNotAskFor() throws IOException {
    try (RawPeer stranger = new RawPeer(network)) {
      stranger.exchangeKeys();
      stranger.frame(new byte[] {Frame.KEY_CONFIRM});
      assertTrue(stranger.closedByServer(), "no answer to the challenge");
      assertEquals(null, network.server.accept());
      stranger.udp.configureBlocking(false);
      int bytes = 0;
      for (ByteBuffer b = ByteBuffer.allocate(2_000); stranger.udp.read(b) > 0; b.clear()) {
        bytes += b.position();
      }
      int challenge = 1 + DatagramSealer.EXTRA_BYTES + Frame.NONCE_BYTES;
      assertTrue(bytes <= 10 * challenge, "bytes=" + bytes);
    }
  }

  @Test
  void aClientThatNeverReadsIsClosedAndSendingNeverThrows() throws IOException {
    try (RawPeer stranger = new RawPeer(network)) {
      Link link = stranger.join();
      Object chunk = new ServerMessage.LevelChunk(0, new byte[4_096]);
      int sent = 0;
      while (link.send(chunk)) {
        sent++;
        assertTrue(sent < 10_000, "sent=" + sent);
      }
      assertEquals(Link.State.CLOSED, link.state());
      assertEquals("the client doesn't read what it is sent", link.closeReason());
    }
  }

  @Test
  void aFloodOfMessagesClosesItsSender() throws IOException {
    try (Network strict = new Network(LIMITS.withRates(20, 100))) {
      Network before = network;
      network = strict;
      try (RawPeer stranger = new RawPeer(network)) {
        Link link = stranger.join();
        try {
          for (int i = 0; i < 100; i++) {
            stranger.frame(new byte[] {Frame.KEEP_ALIVE});
          }
        } catch (SocketException x) {
          assertTrue(stranger.closedByServer());
        }
        eventually(() -> link.state() == Link.State.CLOSED, link::toString);
        assertEquals("more than 20 messages per second", link.closeReason());
      } finally {
        network = before;
      }
    }
  }

  @Test
  void unreadMessagesHaveAnEnd() throws IOException {
    try (RawPeer stranger = new RawPeer(network)) {
      Link link = stranger.join();
      byte[] leave = {Frame.MESSAGE, ClientMessageCodec.encode(new ClientMessage.Leave())[0]};
      try {
        for (int i = 0; i < 1_500; i++) {
          stranger.frame(leave);
        }
      } catch (SocketException x) {
        assertTrue(stranger.closedByServer());
      }
      eventually(() -> link.state() == Link.State.CLOSED, link::toString);
      assertEquals("more than 256 unread messages", link.closeReason());
    }
  }

  @Test
  void aFloodOfDatagramsIsCutAndTheLinkStays() throws IOException {
    try (Network strict = new Network(LIMITS.withRates(2_000, 50))) {
      Network before = network;
      network = strict;
      try (RawPeer stranger = new RawPeer(network)) {
        Link link = stranger.join();
        Network.Inbox inbox = new Network.Inbox();
        for (int i = 0; i < 2_000; i++) {
          stranger.datagram(Frame.DATAGRAM, 1, 2, 3);
          link.poll(inbox, 100);
        }
        eventually(
            () -> {
              link.poll(inbox, 100);
              return strict.server.counters().excessDatagrams.get() > 100;
            },
            link::toString);
        assertTrue(inbox.datagrams.size() < 500, "datagrams=" + inbox.datagrams.size());
        assertEquals(Link.State.OPEN, link.state());
      } finally {
        network = before;
      }
    }
  }

  @Test
  void datagramsThatNobodyPollsAreDroppedAndTheNextOnesArrive() throws IOException {
    try (RawPeer stranger = new RawPeer(network)) {
      Link link = stranger.join();
      for (int i = 0; i < 200; i++) {
        stranger.datagram(Frame.DATAGRAM, i);
      }
      eventually(() -> link.counters().datagramsDropped.get() > 0, link::toString);
      Network.Inbox inbox = new Network.Inbox();
      int polled;
      do {
        polled = link.poll(inbox, 7);
      } while (polled > 0);
      assertTrue(inbox.datagrams.size() >= 128, "datagrams=" + inbox.datagrams.size());
      for (int i = 0; i < 128; i++) {
        assertEquals((byte) i, inbox.datagrams.get(i)[0]);
      }
      int before = inbox.datagrams.size();
      stranger.datagram(Frame.DATAGRAM, 99);
      eventually(
          () -> {
            link.poll(inbox, 1_000);
            return inbox.datagrams.size() > before;
          },
          link::toString);
    }
  }

  @Test
  void aHalfOpenConnectionEndsAndItsReplacementGetsTheSameAddress() throws IOException {
    try (RawPeer stranger = new RawPeer(network);
        RawPeer thief = new RawPeer(network, stranger.udp)) { // its client came back
      Link old = stranger.join();
      thief.register(thief.id, thief.token);
      assertEquals(Frame.REGISTER_UDP, thief.readFrame()[0]);
      Network.pause(50);
      assertEquals(Link.State.OPEN, old.state(), "anybody may forge an address");
    }
    try (RawPeer stranger = new RawPeer(network);
        RawPeer again = new RawPeer(network, stranger.udp)) {
      Link old = stranger.join();
      assertEquals(Link.State.OPEN, again.join().state());
      eventually(() -> old.state() == Link.State.CLOSED, old::toString);
      assertEquals("a new connection has the same address", old.closeReason());
    }
  }

  @Test
  void silenceEndsALink() throws IOException {
    try (RawPeer stranger = new RawPeer(network)) {
      Link link = stranger.join();
      eventually(() -> link.state() == Link.State.CLOSED, link::toString);
      assertEquals("nothing heard for 3500 ms", link.closeReason());
      assertFalse(link.send(new ServerMessage.Notice("anybody?")));
    }
    assertEquals(Link.State.OPEN, canary.server.state(), "keep-alives hold the others");
  }
}
