package carom.net.kryo;

import static carom.net.kryo.Network.eventually;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.frame.Frame;
import carom.net.frame.Trust;
import carom.net.kryo.server.KryoLimits;
import carom.net.kryo.server.KryoServerCounters;
import carom.net.kryo.server.KryoServerTransport;
import carom.net.kryo.server.ServerIdentity;
import carom.net.protocol.ClientMessage;
import carom.net.protocol.ServerMessage;
import carom.net.seal.Encryption;
import carom.net.seal.ExchangeKey;
import carom.net.seal.KnownServers;
import carom.net.seal.ServerKey;
import carom.net.transport.Link;
import carom.suite.Needs;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * Goal: only the two ends of a link take part in it. Method: somebody between them, who sees all
 * and changes, repeats, forges and moves what he likes, over real sockets.
 */
@Needs("sockets")
@Timeout(40)
final class SealedLinkTest {

  private static Network.Pair pair(Network network, int udpPort) {
    Link client = network.clients.connect(Network.HOST, network.server.tcpPort(), udpPort);
    Link[] accepted = new Link[1];
    eventually(
        () -> {
          accepted[0] = accepted[0] == null ? network.server.accept() : accepted[0];
          return client.state() == Link.State.OPEN && accepted[0] != null;
        },
        () -> "client=" + client + " reason=" + client.closeReason());
    return new Network.Pair(client, accepted[0]);
  }

  private static byte[] numbered(int number) {
    return ByteBuffer.allocate(40).putInt(number).array();
  }

  private static Set<Integer> numbers(Network.Inbox inbox) {
    Set<Integer> numbers = new HashSet<>();
    inbox.datagrams.forEach(bytes -> numbers.add(ByteBuffer.wrap(bytes).getInt()));
    return numbers;
  }

  @Test
  void forgedAndRepeatedDatagramsCostTheVictimNothing() throws IOException {
    long seed = Long.getLong("carom.seed", System.nanoTime());
    SplittableRandom random = new SplittableRandom(seed);
    try (Network network = new Network();
        UdpProxy proxy = new UdpProxy(network.server.udpPort())) {
      Network.Pair pair = pair(network, proxy.port());
      int own = 0;
      int forged = 0;
      long start = System.nanoTime();
      for (int ms = 0; ms < 2_000; ms += 5) {
        if (ms % 15 == 0) {
          assertTrue(pair.client.sendDatagram(numbered(own++), 0, 40));
        }
        for (int i = 0; i < 16; i++, forged++) { // 3,200 a second
          byte[] bytes = proxy.sent.get(random.nextInt(proxy.sent.size())).clone();
          if (i % 4 == 1 && bytes[0] != Frame.REGISTER_UDP) {
            ByteBuffer.wrap(bytes).putInt(7, random.nextInt(1 << 30)); // a counter of his own
          } else if (i % 4 != 0) {
            bytes[random.nextInt(bytes.length)] ^= (byte) (1 << random.nextInt(8));
          }
          proxy.inject(bytes);
        }
        pair.poll();
        long left = start + (ms + 5) * 1_000_000L - System.nanoTime();
        TimeUnit.NANOSECONDS.sleep(Math.max(0, left));
      }
      int expected = own;
      eventually(
          () -> {
            pair.poll();
            return numbers(pair.atServer).size() == expected;
          },
          () -> "seed=" + seed + " got=" + numbers(pair.atServer).size() + " of " + expected);
      assertEquals(own, pair.atServer.datagrams.size(), "none counts twice, seed=" + seed);
      assertEquals(0, pair.server.counters().datagramsDropped.get());
      assertEquals(0, network.server.counters().excessDatagrams.get());
      KryoServerCounters counters = network.server.counters();
      assertTrue(counters.forgedDatagrams.get() > forged / 5, counters::troubles);
      assertTrue(counters.replayedDatagrams.get() > forged / 5, counters::troubles);
      assertEquals(Link.State.OPEN, pair.server.state());
    } catch (InterruptedException x) {
      throw new AssertionError(x);
    }
  }

  @Test
  void noSingleBitOfADatagramMayChangeOnItsWay() throws IOException {
    try (Network network = new Network();
        UdpProxy proxy = new UdpProxy(network.server.udpPort())) {
      Network.Pair pair = pair(network, proxy.port());
      proxy.deafen();
      proxy.rebind(); // what the client sends itself comes from there; the copies below, too
      assertTrue(pair.client.sendDatagram(numbered(7), 0, 40));
      eventually(
          () -> {
            pair.poll();
            return pair.atServer.datagrams.size() == 1;
          },
          pair.server::toString);
      byte[] good = proxy.sent.get(proxy.sent.size() - 1);
      for (int bit = 0; bit < 8 * good.length; bit++) {
        byte[] bad = good.clone();
        bad[bit / 8] ^= (byte) (1 << bit % 8);
        proxy.inject(bad);
      }
      proxy.inject(good);
      KryoServerCounters counters = network.server.counters();
      eventually(
          () ->
              counters.forgedDatagrams.get()
                      + counters.strangeDatagrams.get()
                      + counters.replayedDatagrams.get()
                  >= 8 * good.length + 1,
          counters::troubles);
      pair.poll();
      assertEquals(1, pair.atServer.datagrams.size());
    }
  }

  @Test
  void aClientWhoseAddressChangesGoesOnWithinASecond() throws IOException {
    try (Network network = new Network();
        UdpProxy proxy = new UdpProxy(network.server.udpPort())) {
      Network.Pair pair = pair(network, proxy.port());
      for (int move = 1; move <= 3; move++) {
        proxy.rebind();
        long moved = System.nanoTime();
        int before = pair.atClient.datagrams.size();
        while (pair.atClient.datagrams.size() == before) {
          pair.client.sendDatagram(numbered(1), 0, 40);
          pair.server.sendDatagram(numbered(2), 0, 40);
          pair.poll();
          Network.pause(16);
          long ms = (System.nanoTime() - moved) / 1_000_000;
          assertTrue(ms < 1_000, "frozen for ms=" + ms);
        }
        assertEquals(move, network.server.counters().movedLinks.get());
      }
      assertTrue(pair.server.send(new ServerMessage.Notice("still there?")));
      eventually(
          () -> {
            pair.poll();
            return pair.atClient.messages.size() == 1;
          },
          pair.client::toString);
    }
  }

  /** Sends 64 forged datagrams for a link, each from another address, and lets all arrive. */
  private static void forge(
      List<DatagramChannel> forgers, byte[] like, int round, Network network, Network.Pair... pairs)
      throws IOException {
    KryoServerCounters counters = network.server.counters();
    long before = counters.forgedDatagrams.get() + counters.strangeDatagrams.get();
    byte[] forged = like.clone();
    for (int i = 0; i < forgers.size(); i++) {
      ByteBuffer.wrap(forged).putInt(7, 1_000 + forgers.size() * round + i); // it may come
      forgers
          .get(i)
          .send(
              ByteBuffer.wrap(forged),
              new InetSocketAddress(Network.HOST, network.server.udpPort()));
    }
    eventually(
        () -> {
          for (Network.Pair pair : pairs) {
            pair.poll();
          }
          return counters.forgedDatagrams.get() + counters.strangeDatagrams.get()
              >= before + forgers.size();
        },
        counters::troubles);
  }

  private static List<DatagramChannel> forgers(int hosts) throws IOException {
    List<DatagramChannel> channels = new ArrayList<>();
    for (int i = 0; i < 64; i++) {
      DatagramChannel channel = DatagramChannel.open();
      channels.add(channel.bind(new InetSocketAddress("127.0.1." + (1 + i % hosts), 0)));
    }
    return channels;
  }

  /** Plays on until the server has seen the client move, and fails after a second. */
  private static void movesWithinASecond(
      Network network, List<DatagramChannel> forgers, byte[] forged, Network.Pair pair)
      throws IOException {
    KryoServerCounters counters = network.server.counters();
    long movesBefore = counters.movedLinks.get();
    long start = System.nanoTime();
    long sent = start;
    for (int round = 100; counters.movedLinks.get() == movesBefore; round++) {
      forge(forgers, forged, round, network, pair);
      long now = System.nanoTime();
      if (now - sent >= 16_000_000) { // far fewer than the forgers send
        pair.client.sendDatagram(numbered(round), 0, 40);
        sent = now;
      }
      assertTrue(now - start < 1_000_000_000L, "frozen for ns=" + (now - start));
    }
  }

  @Test
  void forgeriesFromElsewhereAreOpenedSparinglyAndAClientStillMoves() throws IOException {
    List<DatagramChannel> forgers = forgers(16);
    try (Network network = new Network();
        UdpProxy proxy = new UdpProxy(network.server.udpPort());
        UdpProxy other = new UdpProxy(network.server.udpPort())) {
      Network.Pair pair = pair(network, proxy.port());
      Network.Pair victim = pair(network, other.port());
      for (Network.Pair each : List.of(pair, victim)) {
        assertTrue(each.client.sendDatagram(numbered(0), 0, 40));
        eventually(
            () -> {
              each.poll();
              return each.atServer.datagrams.size() == 1;
            },
            each.server::toString);
      }
      byte[] forged = proxy.sent.get(proxy.sent.size() - 1).clone();
      byte[] forVictim = other.sent.get(other.sent.size() - 1).clone();
      KryoServerCounters counters = network.server.counters();
      long start = System.nanoTime();
      for (int round = 0; round < 60; round++) {
        forge(forgers, forged, round, network, pair, victim);
      }
      double seconds = (System.nanoTime() - start) * 1e-9;
      long opened = counters.forgedDatagrams.get();
      assertTrue(opened >= 20 && opened <= 22 + 20 * seconds, "opened=" + opened);
      proxy.rebind(); // most routers change the port alone
      movesWithinASecond(network, forgers, forged, pair);
      proxy.rebind("127.0.2.1");
      movesWithinASecond(network, forgers, forVictim, pair);
      assertEquals(1, victim.atServer.datagrams.size());
    } finally {
      for (DatagramChannel forger : forgers) {
        forger.close();
      }
    }
  }

  @Test
  void oneForgerIsHeardOnceASecond() throws IOException {
    try (Network network = new Network();
        UdpProxy proxy = new UdpProxy(network.server.udpPort());
        UdpProxy stranger = new UdpProxy(network.server.udpPort())) {
      Network.Pair pair = pair(network, proxy.port());
      byte[] forged = proxy.sent.get(proxy.sent.size() - 1).clone();
      KryoServerCounters counters = network.server.counters();
      long start = System.nanoTime();
      for (int i = 1; i <= 6_000; i++) {
        ByteBuffer.wrap(forged).putInt(7, i); // a counter that may come
        stranger.inject(forged);
        if (i % 100 == 0) { // so that no buffer overflows
          int sent = i;
          eventually(
              () -> {
                pair.poll();
                return counters.forgedDatagrams.get()
                        + counters.replayedDatagrams.get()
                        + counters.strangeDatagrams.get()
                    >= sent;
              },
              counters::troubles);
        }
      }
      double seconds = (System.nanoTime() - start) * 1e-9;
      long opened = counters.forgedDatagrams.get();
      assertTrue(opened >= 1 && opened <= 2 + seconds, "opened=" + opened);
    }
  }

  @Test
  void aStrangerWhoRepeatsDatagramsGetsNoAnswers() throws IOException {
    try (Network network = new Network();
        UdpProxy proxy = new UdpProxy(network.server.udpPort());
        UdpProxy thief = new UdpProxy(network.server.udpPort())) {
      Network.Pair pair = pair(network, proxy.port());
      proxy.rebind();
      proxy.deafen();
      // The thief is first: his copies arrive, and the client's own are the repeated ones.
      for (int i = 0; i < 30; i++) {
        int seen = proxy.sent.size();
        pair.client.sendDatagram(numbered(i), 0, 40);
        eventually(() -> proxy.sent.size() > seen, () -> "nothing sent");
        thief.inject(proxy.sent.get(proxy.sent.size() - 1));
        pair.server.sendDatagram(numbered(i), 0, 40);
        pair.poll();
        Network.pause(10);
      }
      assertEquals(0, network.server.counters().movedLinks.get());
    }
  }

  @Test
  void aFloodOfGenuineDatagramsEndsWithAReason() {
    try (Network network = new Network(KryoLimits.DEFAULT.withRates(2_000, 20))) {
      Network.Pair pair = network.pair();
      long start = System.nanoTime();
      while (pair.server.state() == Link.State.OPEN) {
        for (int i = 0; i < 20; i++) {
          pair.client.sendDatagram(new byte[1], 0, 1);
        }
        pair.poll();
        Network.pause(5);
        assertTrue(System.nanoTime() - start < 15_000_000_000L, "still open");
      }
      assertTrue(System.nanoTime() - start > 1_000_000_000L, "a burst is no flood");
      assertEquals("more than 200 datagrams per second", pair.server.closeReason());
      eventually(() -> pair.client.state() == Link.State.CLOSED, pair.client::toString);
      assertEquals(pair.server.closeReason(), pair.client.closeReason());
      Link again = network.connect();
      eventually(() -> again.state() == Link.State.CLOSED, again::toString);
      assertEquals(
          "your address sent far too many datagrams; try again in 30 seconds", again.closeReason());
    }
  }

  @Test
  void bothSidesMustWantTheSame() {
    for (Encryption encryption : Encryption.values()) {
      Encryption other = encryption == Encryption.ON ? Encryption.OFF : Encryption.ON;
      try (KryoServerTransport server =
              new KryoServerTransport(
                  null, 0, 0, KryoLimits.DEFAULT, ServerIdentity.temporary(encryption));
          KryoClientTransport same =
              new KryoClientTransport(new Trust(encryption, KnownServers.inMemory()));
          KryoClientTransport different =
              new KryoClientTransport(new Trust(other, KnownServers.inMemory()))) {
        Link good = same.connect(Network.HOST, server.tcpPort(), server.udpPort());
        Link bad = different.connect(Network.HOST, server.tcpPort(), server.udpPort());
        eventually(() -> bad.state() == Link.State.CLOSED, bad::toString);
        assertEquals(
            encryption == Encryption.ON
                ? "the server encrypts; connect without --encryption off"
                : "the server doesn't encrypt, or somebody in between pretends so; if you trust"
                    + " the network, connect with --encryption off",
            bad.closeReason());
        Link[] accepted = new Link[1];
        eventually(() -> (accepted[0] = server.accept()) != null, good::closeReason);
        eventually(() -> good.state() == Link.State.OPEN, good::closeReason);
        Network.Pair pair = new Network.Pair(good, accepted[0]);
        eventually(
            () -> {
              good.sendDatagram(numbered(1), 0, 40);
              accepted[0].sendDatagram(numbered(2), 0, 40);
              pair.poll();
              return !pair.atServer.datagrams.isEmpty() && !pair.atClient.datagrams.isEmpty();
            },
            good::toString);
      }
    }
  }

  @Test
  void aServerWithAnotherKeyIsRefusedWithBothFingerprints() {
    ServerIdentity identity = ServerIdentity.temporary(Encryption.ON);
    String known = ServerKey.fingerprint(ExchangeKey.random().publicKey());
    KnownServers servers = KnownServers.inMemory();
    try (KryoServerTransport server =
            new KryoServerTransport(null, 0, 0, KryoLimits.DEFAULT, identity);
        KryoClientTransport clients = new KryoClientTransport(new Trust(Encryption.ON, servers))) {
      servers.expect(Network.HOST + ":" + server.tcpPort(), known);
      Link link = clients.connect(Network.HOST, server.tcpPort(), server.udpPort());
      eventually(() -> link.state() == Link.State.CLOSED, link::toString);
      assertTrue(link.closeReason().contains(known), link::closeReason);
      assertTrue(link.closeReason().contains(identity.fingerprint()), link::closeReason);
      servers.expect(Network.HOST + ":" + server.tcpPort(), identity.fingerprint());
      Link second = clients.connect(Network.HOST, server.tcpPort(), server.udpPort());
      eventually(() -> second.state() == Link.State.OPEN, second::closeReason);
    }
  }

  /** Stands between a client and a server, and changes frames of the server. */
  private static final class TcpProxy implements AutoCloseable {
    private final ServerSocket listening = new ServerSocket(0);
    private final List<Socket> sockets = new CopyOnWriteArrayList<>();
    private final Thread thread;

    TcpProxy(int serverPort, UnaryOperator<byte[]> change) throws IOException {
      thread =
          new Thread(
              () -> {
                try (Socket client = listening.accept();
                    Socket server = new Socket(Network.HOST, serverPort)) {
                  sockets.addAll(List.of(client, server));
                  Thread back = new Thread(() -> copy(server, client, change), "proxy-back");
                  back.start();
                  copy(client, server, bytes -> bytes);
                  back.join();
                } catch (IOException x) {
                  // the test is over
                } catch (InterruptedException x) {
                  throw new AssertionError(x);
                }
              },
              "tcp-proxy");
      thread.start();
    }

    private static void copy(Socket from, Socket to, UnaryOperator<byte[]> change) {
      try {
        InputStream in = from.getInputStream();
        OutputStream out = to.getOutputStream();
        for (byte[] length; (length = in.readNBytes(4)).length == 4; ) {
          byte[] frame = change.apply(in.readNBytes(ByteBuffer.wrap(length).getInt()));
          out.write(ByteBuffer.allocate(4 + frame.length).putInt(frame.length).put(frame).array());
        }
        to.close();
      } catch (IOException x) {
        // one of them closed
      }
    }

    int port() {
      return listening.getLocalPort();
    }

    @Override
    public void close() throws IOException {
      listening.close();
      for (Socket socket : sockets) {
        socket.close();
      }
      try {
        thread.join(5_000);
      } catch (InterruptedException x) {
        throw new AssertionError(x);
      }
      assertFalse(thread.isAlive());
    }
  }

  private static byte[] flipped(byte[] frame, int at) {
    byte[] changed = frame.clone();
    changed[at] ^= 1;
    return changed;
  }

  @Test
  void aManInTheMiddleEndsTheLinkWithWhateverHeChanges() throws IOException {
    ExchangeKey his = ExchangeKey.random();
    record Attack(UnaryOperator<byte[]> change, String reason) {}
    List<Attack> attacks =
        List.of(
            new Attack(f -> f[0] == Frame.REGISTER_TCP ? flipped(f, 1 + 15) : f, "tampered with"),
            new Attack( // his own key
                f ->
                    f[0] == Frame.REGISTER_TCP
                        ? ByteBuffer.wrap(f).put(f.length - 32, his.publicKey()).array()
                        : f,
                "tampered with"),
            new Attack(f -> f[0] == Frame.REGISTER_TCP ? flipped(f, 1 + 14) : f, "encrypt"),
            new Attack(f -> f[0] == Frame.KEY_ANSWER ? flipped(f, 3) : f, "tampered with"),
            new Attack(f -> f[0] == Frame.KEY_ANSWER ? flipped(f, 40) : f, "tampered with"));
    for (Attack attack : attacks) {
      try (Network network = new Network();
          TcpProxy proxy = new TcpProxy(network.server.tcpPort(), attack.change())) {
        Link link = network.clients.connect(Network.HOST, proxy.port(), network.server.udpPort());
        eventually(() -> link.state() == Link.State.CLOSED, link::toString);
        assertTrue(link.closeReason().contains(attack.reason()), link::closeReason);
        assertEquals(null, network.server.accept());
      }
    }
  }

  @Test
  void aChangedMessageEndsTheLink() throws IOException {
    for (int at : new int[] {0, 5, -1}) {
      boolean[] armed = {false};
      try (Network network = new Network();
          TcpProxy proxy =
              new TcpProxy(
                  network.server.tcpPort(),
                  f -> armed[0] ? flipped(f, at < 0 ? f.length - 1 : at) : f)) {
        Link client = network.clients.connect(Network.HOST, proxy.port(), network.server.udpPort());
        Link[] server = new Link[1];
        eventually(() -> (server[0] = network.server.accept()) != null, client::closeReason);
        armed[0] = true;
        server[0].send(new ServerMessage.Notice("trust me"));
        eventually(() -> client.state() == Link.State.CLOSED, client::toString);
        assertEquals(
            "the connection was tampered with: a frame isn't genuine", client.closeReason());
        Network.Inbox inbox = new Network.Inbox();
        client.poll(inbox, 10);
        assertEquals(List.of(), inbox.messages);
      }
    }
  }

  @Test
  void nothingThatASpySeesIsReadable() throws IOException {
    byte[] secret = "a secret of the session".getBytes(StandardCharsets.US_ASCII);
    List<byte[]> seen = new CopyOnWriteArrayList<>();
    try (Network network = new Network();
        UdpProxy udp = new UdpProxy(network.server.udpPort());
        TcpProxy tcp =
            new TcpProxy(
                network.server.tcpPort(),
                f -> {
                  seen.add(f);
                  return f;
                })) {
      Link client = network.clients.connect(Network.HOST, tcp.port(), udp.port());
      Link[] server = new Link[1];
      eventually(() -> (server[0] = network.server.accept()) != null, client::closeReason);
      Network.Pair pair = new Network.Pair(client, server[0]);
      server[0].send(
          new ServerMessage.Notice(
              new String(secret, 0, secret.length, StandardCharsets.US_ASCII)));
      eventually(
          () -> {
            client.sendDatagram(secret, 0, secret.length);
            pair.poll();
            return pair.atServer.datagrams.size() > 3 && pair.atClient.messages.size() == 1;
          },
          client::toString);
      assertArrayEquals(secret, pair.atServer.datagrams.get(0));
      seen.addAll(udp.sent);
      assertTrue(seen.size() > 6, "seen=" + seen.size());
      for (byte[] bytes : seen) {
        for (int i = 0; i + secret.length <= bytes.length; i++) {
          assertNotEquals(0, Arrays.compare(bytes, i, i + 8, secret, 0, 8));
        }
      }
    }
  }

  @Test
  void aFrameOfOneLinkIsWorthlessOnAnother() throws IOException {
    try (Network network = new Network();
        UdpProxy first = new UdpProxy(network.server.udpPort());
        UdpProxy second = new UdpProxy(network.server.udpPort())) {
      Network.Pair victim = pair(network, first.port());
      Network.Pair thief = pair(network, second.port());
      thief.client.sendDatagram(numbered(1), 0, 40);
      eventually(() -> second.sent.get(second.sent.size() - 1)[0] == Frame.DATAGRAM, () -> "none");
      byte[] own = second.sent.get(second.sent.size() - 1).clone();
      byte[] victims = first.sent.get(first.sent.size() - 1);
      System.arraycopy(victims, 1, own, 1, 4); // the victim's number on the thief's datagram
      long before = network.server.counters().forgedDatagrams.get();
      second.inject(own);
      eventually(() -> network.server.counters().forgedDatagrams.get() > before, () -> "none");
      victim.poll();
      assertEquals(List.of(), victim.atServer.datagrams);
      assertTrue(victim.client.send(new ClientMessage.Leave()));
    }
  }
}
