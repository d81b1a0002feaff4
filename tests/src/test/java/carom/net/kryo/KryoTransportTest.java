package carom.net.kryo;

import static carom.net.kryo.Network.eventually;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.frame.Frame;
import carom.net.frame.Trust;
import carom.net.kryo.server.KryoLimits;
import carom.net.kryo.server.KryoServerTransport;
import carom.net.kryo.server.ServerIdentity;
import carom.net.protocol.ClientMessage;
import carom.net.protocol.ServerMessage;
import carom.net.seal.Encryption;
import carom.net.seal.ExchangeKey;
import carom.net.transport.ClientTransport;
import carom.net.transport.Link;
import carom.net.transport.LinkHandler;
import carom.net.transport.PortUnavailableException;
import carom.suite.Needs;
import java.io.IOException;
import java.net.BindException;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * Tests the contract of a client's and a server's transport. {@code CrowdTransportTest} runs the
 * same tests on a crowd.
 */
@Needs("sockets")
@Timeout(30)
public class KryoTransportTest {

  /** The clients under test, patient for so long. */
  protected ClientTransport clients(int connectMillis) {
    return new KryoClientTransport(Trust.firstUse(), connectMillis);
  }

  private Network network() {
    return network(KryoLimits.DEFAULT);
  }

  private Network network(KryoLimits limits) {
    return new Network(limits, clients(1_500));
  }

  @Test
  void everyMessageAndDatagramCrossesTheRealNetwork() {
    try (Network network = network()) {
      Network.Pair pair = network.pair();
      List<Object> fromServer = new ArrayList<>();
      List<Object> fromClient = new ArrayList<>();
      for (Object message : KryoMessageCodecTest.everyMessage()) {
        if (message instanceof ServerMessage) {
          fromServer.add(message);
          assertTrue(pair.server.send(message));
        } else {
          fromClient.add(message);
          assertTrue(pair.client.send(message));
        }
      }
      byte[] largest = new byte[1_202];
      largest[1] = 1;
      largest[1_200] = 2;
      assertTrue(pair.server.sendDatagram(largest, 1, 1_200));
      assertTrue(pair.client.sendDatagram(new byte[] {9, 8, 7}, 1, 1));
      eventually(
          () -> {
            pair.poll();
            return pair.atClient.messages.size() == fromServer.size()
                && pair.atServer.messages.size() == fromClient.size()
                && pair.atClient.datagrams.size() == 1
                && pair.atServer.datagrams.size() == 1;
          },
          () -> pair.client + " " + pair.atClient.messages.size() + pair.client.closeReason());
      assertEquals(fromServer, pair.atClient.messages);
      assertEquals(fromClient, pair.atServer.messages);
      assertEquals(1_200, pair.atClient.datagrams.get(0).length);
      assertEquals(2, pair.atClient.datagrams.get(0)[1_199]);
      assertArrayEquals(new byte[] {8}, pair.atServer.datagrams.get(0));
      assertEquals(1, pair.server.counters().datagramsOut.get());
      assertEquals(1_200, pair.client.counters().datagramBytesIn.get());
      assertEquals(fromClient.size(), pair.server.counters().messagesIn.get());
      assertTrue(pair.server.remote().startsWith(Network.HOST + ":"), pair.server.remote());
      assertEquals(0, network.server.counters().errors.get());
    }
  }

  @Test
  void theServerIsToldOfALinkOnceItCanBeAccepted() {
    try (Network network = network()) {
      AtomicReference<Link> accepted = new AtomicReference<>();
      assertTrue(network.server.onOpened(() -> accepted.set(network.server.accept())));
      Link client = network.connect();
      eventually(() -> accepted.get() != null, client::closeReason);
    }
  }

  @Test
  void datagramsOutsideTheirLengthAreTheCallersMistake() {
    try (Network network = network()) {
      Link client = network.pair().client;
      assertThrows(IllegalArgumentException.class, () -> client.sendDatagram(new byte[1], 0, 0));
      assertThrows(
          IllegalArgumentException.class, () -> client.sendDatagram(new byte[2_000], 0, 1_201));
    }
  }

  @Test
  void aDatagramKnowsHowLongItWaited() throws Exception {
    try (Network network = network()) {
      Network.Pair pair = network.pair();
      long sentNs = System.nanoTime();
      assertTrue(pair.client.sendDatagram(new byte[1], 0, 1));
      Thread.sleep(300);
      long[] waitedNs = {-1};
      LinkHandler handler =
          new LinkHandler() {
            @Override
            public void message(Link link, Object message) {}

            @Override
            public void datagram(Link link, byte[] bytes, int length) {
              waitedNs[0] = link.waitedNs();
            }

            @Override
            public void closed(Link link, String reason) {}
          };
      eventually(() -> pair.server.poll(handler, 1) == 1, () -> pair.server.toString());
      assertTrue(
          waitedNs[0] > 0 && waitedNs[0] < System.nanoTime() - sentNs, "waitedNs=" + waitedNs[0]);
    }
  }

  @Test
  void aLastMessageArrivesBeforeTheEndAndTheReasonWithIt() {
    try (Network network = network()) {
      Network.Pair pair = network.pair();
      ServerMessage notice = new ServerMessage.Notice("that was it");
      pair.server.send(notice);
      pair.server.close("kicked by the operator");
      pair.server.close("again");
      assertEquals(Link.State.CLOSED, pair.server.state());
      assertFalse(pair.server.send(notice));
      assertFalse(pair.server.sendDatagram(new byte[1], 0, 1));
      eventually(
          () -> {
            pair.poll();
            return pair.atClient.closed == 1 && pair.atServer.closed == 1;
          },
          () -> pair.client.toString());
      assertEquals(List.of(notice), pair.atClient.messages);
      assertEquals("kicked by the operator", pair.atClient.reason);
      assertEquals("kicked by the operator", pair.atServer.reason);
      pair.poll();
      assertEquals(1, pair.atClient.closed, "closed is told once");
    }
  }

  @Test
  void aClientThatLeavesIsSeenAtOnce() {
    try (Network network = network()) {
      Network.Pair pair = network.pair();
      pair.client.send(new ClientMessage.Leave());
      pair.client.close("bye");
      eventually(
          () -> {
            pair.poll();
            return pair.atServer.closed == 1;
          },
          () -> pair.server.toString());
      assertEquals(List.of(new ClientMessage.Leave()), pair.atServer.messages);
      assertEquals("the client left", pair.atServer.reason);
    }
  }

  @Test
  void manyJoinPlayAndLeave() {
    try (Network network = network()) {
      for (int round = 0; round < 3; round++) {
        List<Link> links = new ArrayList<>();
        for (int i = 0; i < 40; i++) {
          links.add(network.connect());
        }
        List<Link> accepted = new ArrayList<>();
        eventually(
            () -> {
              for (Link link = network.server.accept();
                  link != null;
                  link = network.server.accept()) {
                accepted.add(link);
              }
              return accepted.size() == links.size()
                  && links.stream().allMatch(link -> link.state() == Link.State.OPEN);
            },
            () ->
                "accepted="
                    + accepted.size()
                    + links.stream().map(link -> link.state() + link.closeReason()).toList());
        for (Link link : accepted) {
          assertTrue(link.sendDatagram(new byte[600], 0, 600));
        }
        for (int i = 0; i < links.size(); i++) {
          (i % 2 == 0 ? links : accepted).get(i).close("done");
        }
        links.forEach(link -> link.close("done"));
        eventually(
            () -> accepted.stream().allMatch(link -> link.state() == Link.State.CLOSED),
            () -> "some stay open");
      }
      assertEquals(120, network.server.counters().opened.get());
      assertEquals(0, network.server.counters().errors.get());
      assertEquals(null, network.server.counters().errors.last());
    }
  }

  @Test
  void linksCloseFromAnyThreadWhileTrafficFlows() throws Exception {
    try (Network network = network()) {
      for (int round = 0; round < 10; round++) {
        Network.Pair pair = network.pair();
        AtomicBoolean stop = new AtomicBoolean();
        AtomicReference<Throwable> failure = new AtomicReference<>();
        List<Thread> threads = new ArrayList<>();
        for (int i = 0; i < 4; i++) {
          Link link = i % 2 == 0 ? pair.client : pair.server;
          Object message =
              i % 2 == 0 ? new ClientMessage.LevelRequest(7, 1) : new ServerMessage.Notice("hello");
          threads.add(
              new Thread(
                  () -> {
                    try {
                      for (int n = 0; !stop.get() && n < 300; n++) {
                        link.sendDatagram(new byte[100], 0, 100);
                        link.send(message);
                      }
                    } catch (Throwable x) {
                      failure.set(x);
                    }
                  }));
        }
        threads.forEach(Thread::start);
        for (int i = 0; i < 5; i++) {
          pair.poll();
        }
        (round % 2 == 0 ? pair.client : pair.server).close("now");
        stop.set(true);
        for (Thread thread : threads) {
          thread.join(5_000);
          assertFalse(thread.isAlive());
        }
        assertEquals(null, failure.get());
        eventually(
            () -> {
              pair.poll();
              return pair.atClient.closed + pair.atServer.closed == 2;
            },
            () -> pair.client + " " + pair.server);
      }
      network.pair();
    }
  }

  @Test
  void anInterruptedThreadMaySend() {
    try (Network network = network()) {
      Network.Pair pair = network.pair();
      Network.Pair other = network.pair();
      Thread.currentThread().interrupt();
      assertTrue(pair.server.sendDatagram(new byte[1], 0, 1));
      assertTrue(pair.server.send(new ServerMessage.Notice("hi")));
      assertTrue(pair.client.sendDatagram(new byte[1], 0, 1));
      assertTrue(Thread.interrupted());
      assertTrue(other.server.sendDatagram(new byte[1], 0, 1));
      eventually(
          () -> {
            pair.poll();
            other.poll();
            return pair.atClient.datagrams.size() == 1
                && pair.atClient.messages.size() == 1
                && pair.atServer.datagrams.size() == 1
                && other.atClient.datagrams.size() == 1;
          },
          () -> pair.client + " " + pair.server + " " + other.client);
    }
  }

  @Test
  void busyPortsAreNamedAndNothingStaysOpen() throws IOException {
    try (ServerSocket busy = new ServerSocket(0)) {
      PortUnavailableException x =
          assertThrows(
              PortUnavailableException.class,
              () -> new KryoServerTransport(busy.getLocalPort(), 0));
      assertEquals("TCP", x.protocol());
      assertEquals(busy.getLocalPort(), x.port());
      assertTrue(
          x.getMessage().contains("TCP port " + busy.getLocalPort() + " is busy"), x::getMessage);
      assertTrue(x.getMessage().contains("--tcp-port"), x::getMessage);
    }
    try (DatagramSocket busy = new DatagramSocket(0)) {
      int free;
      try (ServerSocket probe = new ServerSocket(0)) {
        free = probe.getLocalPort();
      }
      PortUnavailableException x =
          assertThrows(
              PortUnavailableException.class,
              () -> new KryoServerTransport(free, busy.getLocalPort()));
      assertEquals("UDP", x.protocol());
      assertTrue(x.getMessage().contains("--udp-port"), x::getMessage);
      new ServerSocket(free).close(); // TCP was let go again
    }
    assertThrows(IllegalArgumentException.class, () -> new KryoServerTransport(65_536, 0));
  }

  @Test
  void listensOnTheChosenAddressOnly() throws IOException {
    InetAddress chosen = InetAddress.getByName("127.0.0.2");
    KryoServerTransport bound =
        new KryoServerTransport(
            chosen, 0, 0, KryoLimits.DEFAULT, ServerIdentity.temporary(Encryption.ON));
    try {
      InetAddress other = InetAddress.getByName("127.0.0.1");
      new ServerSocket(bound.tcpPort(), 1, other).close();
      new DatagramSocket(bound.udpPort(), other).close();
      assertThrows(BindException.class, () -> new ServerSocket(bound.tcpPort(), 1, chosen));
      assertThrows(BindException.class, () -> new DatagramSocket(bound.udpPort(), chosen));
    } finally {
      bound.close();
    }
    InetAddress foreign = InetAddress.getByName("203.0.113.7");
    PortUnavailableException x =
        assertThrows(
            PortUnavailableException.class,
            () ->
                new KryoServerTransport(
                    foreign, 0, 0, KryoLimits.DEFAULT, ServerIdentity.temporary(Encryption.ON)));
    assertTrue(x.getMessage().contains("203.0.113.7 is no address of this machine"), x::getMessage);
  }

  @Test
  void startingAndClosingLeavesNothingBehind() {
    for (int i = 0; i < 20; i++) {
      try (Network network = network()) {
        Network.Pair pair = network.pair();
        Link late = network.connect();
        network.server.close();
        network.server.close();
        eventually(() -> pair.client.state() == Link.State.CLOSED, pair.client::toString);
        assertEquals("the server is shutting down", pair.client.closeReason());
        assertEquals("the server is shutting down", pair.server.closeReason());
        assertNotEquals(null, late.state());
      }
    }
    eventually(() -> caromThreads().isEmpty(), () -> "threads=" + caromThreads());
  }

  private static List<String> caromThreads() {
    return Thread.getAllStackTraces().keySet().stream()
        .map(Thread::getName)
        .filter(name -> name.startsWith("carom-"))
        .toList();
  }

  @Test
  void aPlayerIsToldWhyThereIsNoConnection() throws IOException {
    int free;
    try (ServerSocket probe = new ServerSocket(0)) {
      free = probe.getLocalPort();
    }
    try (ClientTransport clients = clients(5_000);
        ClientTransport impatient = clients(500);
        Network network = network();
        ServerSocket mute = new ServerSocket(0);
        DatagramSocket swallows = new DatagramSocket(0)) {
      int tcp = network.server.tcpPort();
      Link nobody = clients.connect(Network.HOST, free, 1);
      Link unknown = clients.connect("no-such-host.invalid", 1, 1);
      Link closedUdp = clients.connect(Network.HOST, tcp, free);
      Link blockedUdp = clients.connect(Network.HOST, tcp, swallows.getLocalPort());
      Link blockedSoon = impatient.connect(Network.HOST, tcp, swallows.getLocalPort());
      Link other = impatient.connect(Network.HOST, mute.getLocalPort(), 1);
      assertTells(nobody, "no server answers at 127.0.0.1:" + free);
      assertTells(unknown, "unknown host no-such-host.invalid");
      for (Link blocked : List.of(closedUdp, blockedUdp, blockedSoon)) {
        eventually(blocked::isOverTcp, () -> blocked + " " + blocked.closeReason());
      }
      assertTells(other, "isn't a Carom server");
      assertThrows(IllegalArgumentException.class, () -> clients.connect(Network.HOST, 0, 1));
    }
  }

  private static void assertTells(Link link, String text) {
    eventually(() -> link.state() == Link.State.CLOSED, link::toString);
    assertTrue(link.closeReason().contains(text), link.closeReason());
    Network.Inbox inbox = new Network.Inbox();
    link.poll(inbox, 10);
    assertEquals(1, inbox.closed);
    assertEquals(link.closeReason(), inbox.reason);
  }

  @Test
  void aServerThatIsNoneOrGoesMadOnlyEndsTheLink() throws IOException {
    byte[] fields =
        Frame.greeting(
            1, 0x0101010101010101L, 1, Encryption.ON, 0, ExchangeKey.random().publicKey());
    byte[] registration =
        join(new byte[] {0, 0, 0, 1 + Frame.GREETING_BYTES, Frame.REGISTER_TCP}, fields);
    List<byte[]> greetings =
        List.of(
            "SSH-2.0-x\r\n".getBytes(StandardCharsets.UTF_8),
            new byte[16],
            new byte[] {0, 0, 0, 1, 99},
            new byte[] {0, 0, 0, 2, Frame.REGISTER_TCP, 0},
            join(registration, new byte[] {-1, -1, -1, -1}),
            join(registration, new byte[] {0, 0, 0, 2, Frame.MESSAGE, 0x43}),
            join(registration, new byte[] {0, 0, 0, 3, Frame.BYE, 'n', 'o'}));
    for (byte[] greeting : greetings) {
      try (ServerSocket server = new ServerSocket(0);
          ClientTransport clients = clients(1_000)) {
        Link link = clients.connect(Network.HOST, server.getLocalPort(), 9);
        try (Socket socket = server.accept()) {
          socket.getOutputStream().write(greeting);
          eventually(() -> link.state() == Link.State.CLOSED, link::toString);
        }
        assertFalse(link.closeReason().isBlank());
      }
    }
    eventually(() -> caromThreads().isEmpty(), () -> "threads=" + caromThreads());
  }

  private static byte[] join(byte[] a, byte[] b) {
    return ByteBuffer.allocate(a.length + b.length).put(a).put(b).array();
  }

  @Test
  void aSteadyStreamOfDatagramsReusesItsBuffers() {
    try (Network network = network()) {
      Network.Pair pair = network.pair();
      Set<byte[]> buffers = Collections.newSetFromMap(new IdentityHashMap<>());
      int[] arrived = new int[1];
      LinkHandler handler =
          new LinkHandler() {
            @Override
            public void message(Link link, Object message) {
              throw new AssertionError(message);
            }

            @Override
            public void datagram(Link link, byte[] bytes, int length) {
              buffers.add(bytes);
              arrived[0]++;
            }

            @Override
            public void closed(Link link, String reason) {
              throw new AssertionError(reason);
            }
          };
      byte[] payload = new byte[100];
      for (int i = 0; i < 200; i++) {
        int before = arrived[0];
        pair.client.sendDatagram(payload, 0, 100);
        eventually(
            () -> pair.server.poll(handler, 10) > 0 || arrived[0] > before, pair.server::toString);
      }
      assertEquals(200, arrived[0]);
      assertTrue(buffers.size() <= 2, "buffers=" + buffers.size());
    }
  }

  @Test
  void aFullServerSaysSo() {
    try (Network network = network(KryoLimits.DEFAULT.withConnections(3, 2))) {
      network.pair();
      Network.Pair second = network.pair();
      Link third = network.connect();
      assertTells(third, "too many connections from your address (2)");
      second.client.close("makes room");
      eventually(() -> second.server.state() == Link.State.CLOSED, second.server::toString);
      network.pair();
    }
    try (Network network = network(KryoLimits.DEFAULT.withConnections(1, 9))) {
      network.pair();
      assertTells(network.connect(), "the server is full (1 connections)");
      assertEquals(1, network.server.counters().refused.get());
    }
  }

  @Test
  void closingWhileConnectingEndsBothThreads() {
    try (Network network = network()) {
      for (int i = 0; i < 20; i++) {
        network.connect().close("changed my mind");
      }
      network.pair();
    }
    eventually(() -> caromThreads().isEmpty(), () -> "threads=" + caromThreads());
  }
}
