package carom.net.kryo;

import static carom.net.kryo.Network.eventually;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.frame.Frame;
import carom.net.kryo.server.KryoLimits;
import carom.net.kryo.server.KryoServerTransport;
import carom.net.kryo.server.ProxyRule;
import carom.net.kryo.server.ServerIdentity;
import carom.net.seal.Encryption;
import carom.net.transport.Impairment;
import carom.net.transport.Link;
import carom.suite.Needs;
import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.SocketException;
import java.net.SocketTimeoutException;
import java.util.Arrays;
import java.util.List;
import java.util.Queue;
import java.util.Random;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * Goal: players behind a proxy have their own addresses, and nobody else can claim one. Method: a
 * proxy of a few lines that writes the header byte by byte, and headers that are cut or wrong.
 */
@Needs("sockets")
@Timeout(60)
final class ProxyGateTest {
  private final Queue<String> log = new ConcurrentLinkedQueue<>();

  private KryoServerTransport server(String proxy) throws IOException {
    InetAddress from = InetAddress.getByName(proxy);
    return new KryoServerTransport(
        List.of(),
        0,
        0,
        KryoLimits.DEFAULT,
        ServerIdentity.temporary(Encryption.ON),
        Impairment.NONE,
        new ProxyRule(from::equals, log::add));
  }

  /** A header as haproxy writes it, for a client and a server of one family. */
  private static byte[] header(String client, int port, int moreBytes) throws IOException {
    byte[] address = InetAddress.getByName(client).getAddress();
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    DataOutputStream out = new DataOutputStream(bytes);
    out.write(new byte[] {13, 10, 13, 10, 0, 13, 10, 'Q', 'U', 'I', 'T', 10, 0x21});
    out.writeByte(address.length == 4 ? 0x11 : 0x21);
    out.writeShort(2 * address.length + 4 + moreBytes);
    out.write(address);
    out.write(new byte[address.length]);
    out.writeShort(port);
    out.writeShort(54_555);
    out.write(new byte[moreBytes]);
    return bytes.toByteArray();
  }

  /** Hands one connection on behind a header, piece by piece. */
  private static ServerSocket proxy(int to, byte[] header, int piece) throws IOException {
    ServerSocket listener = new ServerSocket(0, 5, InetAddress.getLoopbackAddress());
    Thread thread =
        new Thread(
            () -> {
              try (Socket client = listener.accept();
                  Socket server = new Socket(Network.HOST, to)) {
                server.setTcpNoDelay(true);
                for (int i = 0; i < header.length; i += piece) {
                  server.getOutputStream().write(header, i, Math.min(piece, header.length - i));
                  server.getOutputStream().flush();
                }
                Thread back = new Thread(() -> pump(server, client));
                back.setDaemon(true);
                back.start();
                pump(client, server);
              } catch (IOException closed) {
                // the test is over
              }
            });
    thread.setDaemon(true);
    thread.start();
    return listener;
  }

  private static void pump(Socket from, Socket to) {
    try (InputStream in = from.getInputStream();
        OutputStream out = to.getOutputStream()) {
      in.transferTo(out);
    } catch (IOException closed) {
      // either side has ended it
    }
  }

  private static Link joined(KryoServerTransport server, byte[] header, int udpPort)
      throws Exception {
    try (ServerSocket proxy = proxy(server.tcpPort(), header, 1 + new Random().nextInt(9));
        KryoClientTransport clients = new KryoClientTransport()) {
      Link client = clients.connect(Network.HOST, proxy.getLocalPort(), udpPort);
      Link[] accepted = new Link[1];
      eventually(
          () -> {
            client.poll(new Network.Inbox(), 9);
            accepted[0] = accepted[0] == null ? server.accept() : accepted[0];
            return accepted[0] != null;
          },
          client::toString);
      return accepted[0];
    }
  }

  @Test
  void playersBehindAProxyHaveTheirOwnAddresses() throws Exception {
    try (KryoServerTransport server = server(Network.HOST)) {
      Link four = joined(server, header("203.0.113.7", 4_001, 0), server.udpPort());
      assertEquals("203.0.113.7:4001", four.remote());
      Link six = joined(server, header("2001:db8::7", 4_002, 99), server.udpPort());
      assertEquals("[2001:db8:0:0:0:0:0:7]:4002", six.remote());
      assertEquals(List.of(), List.copyOf(log));
    }
  }

  @Test
  void whereTheProxyHandsOnTcpAloneDatagramsGoOverIt() throws Exception {
    try (KryoServerTransport server = server(Network.HOST);
        ServerSocket unused = new ServerSocket(0)) {
      Link link = joined(server, header("203.0.113.8", 4_003, 0), unused.getLocalPort());
      assertEquals("203.0.113.8:4003", link.remote());
    }
  }

  @Test
  void aStrangerCanNotClaimAnAddress() throws Exception {
    try (KryoServerTransport server = server("192.0.2.9")) {
      assertGreeted(server, new byte[0], true);
      try (Socket socket = new Socket(Network.HOST, server.tcpPort())) {
        socket.setSoTimeout(5_000);
        socket.getOutputStream().write(header("203.0.113.7", 4_001, 0));
        assertTrue(endsSoon(socket), "the header is no frame");
      }
      assertEquals(null, server.accept());
    }
  }

  @Test
  void aProxyAsksForItselfWhetherTheServerIsThere() throws Exception {
    byte[] local = Arrays.copyOf(header("203.0.113.7", 4_001, 0), 16);
    local[12] = 0x20;
    local[15] = 0;
    try (KryoServerTransport server = server(Network.HOST)) {
      assertGreeted(server, local, true);
    }
  }

  /** The kind: anything but a whole header, drawn at random. */
  @Test
  void everythingElseIsClosedWithOneLine() throws Exception {
    long seed = System.nanoTime();
    Random random = new Random(seed);
    try (KryoServerTransport server = server(Network.HOST)) {
      for (int i = 0; i < 60; i++) {
        byte[] bytes = header(random.nextBoolean() ? "203.0.113.7" : "2001:db8::7", 9, 0);
        switch (random.nextInt(5)) {
          case 0 -> bytes[random.nextInt(12)] ^= (byte) (1 + random.nextInt(255));
          case 1 -> bytes[12] = (byte) (0x22 + random.nextInt(200));
          case 2 -> bytes[13] = (byte) (random.nextBoolean() ? 0x12 : 0x31);
          case 3 -> {
            bytes[14] = (byte) (0x03 + random.nextInt(250));
          }
          default -> random.nextBytes(bytes);
        }
        assertGreeted(server, bytes, false);
      }
      try (Socket socket = new Socket(Network.HOST, server.tcpPort())) {
        byte[] whole = header("203.0.113.7", 9, 0);
        socket.getOutputStream().write(whole, 0, random.nextInt(whole.length));
        socket.shutdownOutput();
        socket.setSoTimeout(5_000);
        assertTrue(endsSoon(socket), "a cut header, seed=" + seed);
      }
      try (Socket silent = new Socket(Network.HOST, server.tcpPort())) {
        silent.setSoTimeout(10_000);
        assertTrue(endsSoon(silent), "a deadline");
      }
      assertEquals(1, log.size(), log.toString());
      assertNotNull(log.peek());
      assertTrue(log.peek().startsWith("1 so far, the last from 127.0.0.1:"), log.peek());
      assertGreeted(server, header("203.0.113.7", 9, 0), true);
    }
  }

  private static void assertGreeted(KryoServerTransport server, byte[] first, boolean greeted)
      throws IOException {
    try (Socket socket = new Socket(Network.HOST, server.tcpPort())) {
      socket.setSoTimeout(5_000);
      socket.getOutputStream().write(first);
      byte[] frame = new byte[0];
      try {
        frame = socket.getInputStream().readNBytes(5);
      } catch (SocketException reset) {
        // the server closed it with bytes unread
      }
      assertEquals(
          greeted,
          frame.length == 5 && frame[4] == Frame.REGISTER_TCP,
          "first=" + Arrays.toString(first));
    }
  }

  private static boolean endsSoon(Socket socket) throws IOException {
    try {
      socket.getInputStream().transferTo(OutputStream.nullOutputStream());
      return true;
    } catch (SocketTimeoutException e) {
      return false;
    } catch (SocketException reset) {
      return true;
    }
  }
}
