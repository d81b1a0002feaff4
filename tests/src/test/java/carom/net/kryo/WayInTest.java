package carom.net.kryo;

import static carom.net.kryo.Network.eventually;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.fixtures.OutsideRelay;
import carom.net.admission.WorkProof;
import carom.net.frame.Frame;
import carom.net.frame.Trust;
import carom.net.kryo.server.KryoLimits;
import carom.net.protocol.ClientMessage;
import carom.net.transport.Link;
import carom.suite.Needs;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * Goal: a player gets in over a slow line, to a name of which some addresses are dead, and where
 * UDP is blocked. Method: real sockets, with relays in between that share no code with the product.
 */
@Needs("sockets")
@Timeout(120)
final class WayInTest {
  private static final InetSocketAddress NOBODY = new InetSocketAddress(Network.HOST, 9);

  private static InetSocketAddress at(int port) {
    return new InetSocketAddress(Network.HOST, port);
  }

  private static OutsideRelay relay(Network network, int oneWayMs, double loss) throws Exception {
    return new OutsideRelay(
        InetAddress.getByName(Network.HOST),
        0,
        at(network.server.tcpPort()),
        at(network.server.udpPort()),
        oneWayMs,
        loss);
  }

  private static Network patient() {
    return new Network(KryoLimits.DEFAULT, new KryoClientTransport());
  }

  private static Network.Pair pair(Network network, OutsideRelay relay) {
    Link client = network.clients.connect(Network.HOST, relay.tcpPort(), relay.udpPort());
    waitFor(60, () -> client.state() != Link.State.CONNECTING);
    assertEquals(Link.State.OPEN, client.state(), client::closeReason);
    Link[] accepted = new Link[1];
    eventually(() -> (accepted[0] = network.server.accept()) != null, () -> "not accepted");
    return new Network.Pair(client, accepted[0]);
  }

  private static void waitFor(int seconds, BooleanSupplier condition) {
    long end = System.nanoTime() + seconds * 1_000_000_000L;
    while (!condition.getAsBoolean() && System.nanoTime() < end) {
      Network.pause(5);
    }
  }

  /** Sends numbered datagrams both ways until one has come through each way. */
  private static void assertDatagramsPass(Network.Pair pair) {
    int up = pair.atServer.datagrams.size();
    int down = pair.atClient.datagrams.size();
    eventually(
        () -> {
          pair.client.sendDatagram(new byte[] {1, 2, 3}, 0, 3);
          pair.server.sendDatagram(new byte[] {4, 5}, 0, 2);
          Network.pause(5);
          pair.poll();
          return pair.atServer.datagrams.size() > up && pair.atClient.datagrams.size() > down;
        },
        () -> pair.client + " " + pair.server);
    assertArrayEquals(new byte[] {4, 5}, pair.atClient.datagrams.get(down));
  }

  @Test
  void aRoundTripOfThreeSecondsWithLossGetsIn() throws Exception {
    try (Network network = patient();
        OutsideRelay relay = relay(network, 1_500, 5)) {
      Network.Pair pair = pair(network, relay);
      assertFalse(pair.client.isOverTcp());
      pair.client.send(new ClientMessage.Leave());
      eventually(
          () -> {
            pair.poll();
            return pair.atServer.messages.size() == 1;
          },
          pair.server::toString);
    }
  }

  @Test
  void whereUdpIsBlockedTcpCarriesDatagrams() throws Exception {
    try (Network network = patient();
        OutsideRelay relay = relay(network, 0, 0)) {
      relay.blockUdp(true);
      Network.Pair pair = pair(network, relay);
      assertTrue(pair.client.isOverTcp());
      assertTrue(pair.server.isOverTcp());
      assertDatagramsPass(pair);
      pair.client.send(new ClientMessage.Leave());
      relay.blockUdp(false);
      eventually(() -> !pair.client.isOverTcp() && !pair.server.isOverTcp(), pair::toString);
      assertDatagramsPass(pair);
      assertEquals(1, network.server.counters().movedLinks.get(), "UDP has proven its address");
      assertEquals(List.of(new ClientMessage.Leave()), pair.atServer.messages);
    }
  }

  @Test
  void udpThatDiesInMidGameEndsNothing() throws Exception {
    try (Network network = patient();
        OutsideRelay relay = relay(network, 0, 0)) {
      Network.Pair pair = pair(network, relay);
      assertFalse(pair.client.isOverTcp());
      assertDatagramsPass(pair);
      relay.blockUdp(true);
      waitFor(10, () -> pair.client.isOverTcp() && pair.server.isOverTcp());
      assertDatagramsPass(pair);
      relay.blockUdp(false);
      waitFor(10, () -> !pair.client.isOverTcp() && !pair.server.isOverTcp());
      assertFalse(pair.client.isOverTcp() || pair.server.isOverTcp());
      assertDatagramsPass(pair);
    }
  }

  @Test
  void aSlowReaderMakesTheServerQueueNothing() throws Exception {
    try (Network network = patient();
        OutsideRelay relay = relay(network, 0, 0)) {
      relay.blockUdp(true);
      Network.Pair pair = pair(network, relay);
      assertDatagramsPass(pair);
      relay.freeze(true);
      int taken = 0;
      int offered = 0;
      for (int i = 0; i < 200; i++, offered++) {
        taken += pair.server.sendDatagram(new byte[1_200], 0, 1_200) ? 1 : 0;
        Network.pause(10);
      }
      assertTrue(taken < offered / 2, "taken=" + taken + " of " + offered);
      assertEquals(Link.State.OPEN, pair.server.state(), pair.server::closeReason);
      int before = pair.atClient.datagrams.size();
      relay.freeze(false);
      eventually(
          () -> {
            pair.server.sendDatagram(new byte[] {7}, 0, 1);
            Network.pause(5);
            pair.poll();
            List<byte[]> datagrams = pair.atClient.datagrams;
            return datagrams.size() > before && datagrams.get(datagrams.size() - 1).length == 1;
          },
          pair.client::toString);
    }
  }

  @Test
  void aLinkOverTcpThatHasNotWorkedGetsNoFurther() throws Exception {
    try (Network network = new Network();
        RawPeer idler = new RawPeer(network)) {
      WorkProof work = new WorkProof();
      long wrong = 0;
      while (work.isSolved(idler.id, idler.token, Frame.STREAM_WORK_BITS, wrong)) {
        wrong++;
      }
      idler.frame(ByteBuffer.allocate(9).put(Frame.STREAM).putLong(wrong).array());
      assertTrue(idler.closedByServer());
      network.pair();
    }
  }

  private static KryoClientTransport named(InetAddress... addresses) {
    return new KryoClientTransport(Trust.firstUse(), 10_000, name -> addresses);
  }

  private static InetAddress loopback(int last) throws Exception {
    return InetAddress.getByAddress(new byte[] {127, 0, 0, (byte) last});
  }

  private static Link open(KryoClientTransport clients, int port) {
    Link link = clients.connect("a-name", port, port);
    eventually(() -> link.state() != Link.State.CONNECTING, link::toString);
    assertEquals(Link.State.OPEN, link.state(), link::closeReason);
    return link;
  }

  @Test
  void aSilentAddressKeepsNobodyOut() throws Exception {
    List<Socket> fill = new ArrayList<>();
    try (Network network = patient();
        OutsideRelay alive = relay(network, 0, 0);
        ServerSocket silent = new ServerSocket(alive.tcpPort(), 1, loopback(2));
        KryoClientTransport clients = named(loopback(2), loopback(1))) {
      for (int i = 0; i < 4; i++) { // a full backlog answers no SYN
        Socket socket = new Socket();
        fill.add(socket);
        try {
          socket.connect(silent.getLocalSocketAddress(), 50);
        } catch (SocketTimeoutException full) {
          // as it should be
        }
      }
      long start = System.nanoTime();
      Link link = clients.connect("a-name", alive.tcpPort(), alive.udpPort());
      eventually(() -> link.state() == Link.State.OPEN, link::toString);
      assertFalse(link.isOverTcp());
      assertTrue(System.nanoTime() - start < 4_500_000_000L, "it waited for the silent address");
    } finally {
      for (Socket socket : fill) {
        socket.close();
      }
    }
  }

  @Test
  void anAddressWithoutUdpLosesToOneWithAndWinsAlone() throws Exception {
    try (Network network = patient();
        OutsideRelay dead =
            new OutsideRelay(loopback(2), 0, at(network.server.tcpPort()), NOBODY, 0, 0);
        OutsideRelay alive =
            new OutsideRelay(
                loopback(3),
                dead.tcpPort(),
                at(network.server.tcpPort()),
                at(network.server.udpPort()),
                0,
                0);
        KryoClientTransport both = named(loopback(2), loopback(3));
        KryoClientTransport one = named(loopback(2), loopback(4))) {
      assertFalse(open(both, alive.tcpPort()).isOverTcp());
      assertTrue(open(one, dead.tcpPort()).isOverTcp());
    }
  }

  @Test
  void bothKindsOfAddressesTakeTurns() throws Exception {
    InetAddress six = InetAddress.getByName("2001:db8::1");
    InetAddress six2 = InetAddress.getByName("2001:db8::2");
    InetAddress four = loopback(1);
    assertEquals(
        List.of(six, four, six2), AddressRace.interleaved(six, six2, four), "RFC 8305, section 4");
    assertEquals(List.of(four, six, six2), AddressRace.interleaved(four, six, six2));
  }
}
