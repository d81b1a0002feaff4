package carom.server.thin.web;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.server.access.AddressRange;
import carom.server.thin.ThinNews;
import carom.server.thin.ThinServerMessage;
import carom.suite.Needs;
import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * Goal: whatever comes to the play port, others play on. Method: raw sockets that send garbage and
 * floods, stop half way or don't read, and a player that joins after each.
 */
@Timeout(180)
@Needs("sockets")
final class PlaySiegeTest {
  private static final InetAddress LOOPBACK = InetAddress.getLoopbackAddress();
  private static final String UPGRADE =
      "GET /thin HTTP/1.1\r\nHost: %s\r\nConnection: Upgrade\r\nUpgrade: websocket\r\n"
          + "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n%s\r\n";

  private final List<Socket> sockets = new ArrayList<>();
  private PlayServer server;

  @BeforeEach
  void start() throws IOException {
    server =
        new PlayServer(
            "arena",
            new PlayPort.Settings(
                List.of(LOOPBACK),
                0,
                Set.of("game.example"),
                List.of(AddressRange.parse("127.0.0.9").orElseThrow()),
                40,
                20,
                null));
  }

  @AfterEach
  void stop() throws IOException {
    for (Socket socket : sockets) {
      socket.close();
    }
    server.close();
  }

  private Socket connect() throws IOException {
    Socket socket = new Socket(LOOPBACK, server.port.tcpPort());
    socket.setSoTimeout(30_000);
    sockets.add(socket);
    return socket;
  }

  private static String head(Socket socket) throws IOException {
    StringBuilder text = new StringBuilder();
    InputStream in = socket.getInputStream();
    for (int next; text.indexOf("\r\n\r\n") < 0 && (next = in.read()) >= 0; ) {
      text.append((char) next);
    }
    return text.toString();
  }

  private String status(String host, String more) throws IOException {
    Socket socket = connect();
    String request = String.format(UPGRADE, host, more);
    socket.getOutputStream().write(request.getBytes(StandardCharsets.US_ASCII));
    String head = head(socket);
    return head.substring(9, 12);
  }

  private Socket upgraded() throws IOException {
    Socket socket = connect();
    String request = String.format(UPGRADE, "localhost", "");
    socket.getOutputStream().write(request.getBytes(StandardCharsets.US_ASCII));
    assertTrue(head(socket).startsWith("HTTP/1.1 101 "));
    return socket;
  }

  private static byte[] frame(int first, byte[] payload) {
    ByteBuffer frame = ByteBuffer.allocate(14 + payload.length);
    frame.put((byte) first);
    if (payload.length < 126) {
      frame.put((byte) (0x80 | payload.length));
    } else {
      frame.put((byte) (0x80 | 126)).putShort((short) payload.length);
    }
    frame.putInt(0).put(payload).flip(); // a mask of zeros
    byte[] bytes = new byte[frame.remaining()];
    frame.get(bytes);
    return bytes;
  }

  private static byte[] text(String json) {
    return frame(0x81, json.getBytes(StandardCharsets.UTF_8));
  }

  /** Waits until the server has closed a connection; returns what it had sent. */
  private static String untilClosed(Socket socket) throws IOException {
    byte[] all = new byte[0];
    try {
      all = socket.getInputStream().readAllBytes();
    } catch (SocketTimeoutException e) {
      throw new AssertionError("the server doesn't hang up", e);
    } catch (IOException reset) {
      return "";
    }
    return new String(all, StandardCharsets.UTF_8);
  }

  private void assertPlayable() throws Exception {
    try (WebPlayer player = server.player()) {
      player.say("{\"join\": {\"name\": \"Ann\"}}");
      player.await("snapshot");
      player.say("{\"leave\": {}}");
      player.await("goodbye");
    }
    assertFalse(server.server.hasFailed());
    assertNull(server.port.nextError());
  }

  @Test
  void garbageEndsItsOwnLinkOnly() throws Exception {
    Random random = new Random(3);
    for (int i = 0; i < 60; i++) {
      byte[] noise = new byte[1 + random.nextInt(400)];
      random.nextBytes(noise);
      Socket socket = i % 2 == 0 ? upgraded() : connect();
      try {
        socket.getOutputStream().write(noise);
        socket.shutdownOutput();
      } catch (IOException closed) {
        continue; // it was hung up on meanwhile
      }
      untilClosed(socket);
    }
    for (byte[] bad :
        new byte[][] {
          {(byte) 0x81, 5, 'h', 'e', 'l', 'l', 'o'}, // without a mask
          {(byte) 0x81, (byte) 0xff, 127, -1, -1, -1, -1, -1, -1, -1, 0, 0, 0, 0}, // 2^63 bytes
          {(byte) 0xf1, (byte) 0x80, 0, 0, 0, 0}, // reserved bits
          {(byte) 0x83, (byte) 0x80, 0, 0, 0, 0}, // an unknown kind
          frame(0x81, new byte[] {(byte) 0xc3, 0x28}), // no UTF-8
          frame(0x81, new byte[WebLink.MAX_MESSAGE_BYTES + 1]),
          text("{}"),
          text("{\"join\": {\"name\": \"a\", \"name\": \"b\"}}"),
          text("[".repeat(4_000)),
          frame(0x82, new byte[] {2, 1, 1}),
          frame(0x82, new byte[0])
        }) {
      Socket socket = upgraded();
      socket.getOutputStream().write(bad);
      socket.shutdownOutput();
      untilClosed(socket);
    }
    assertPlayable();
  }

  @Test
  void floodsEndWithAReason() throws Exception {
    Socket many = upgraded();
    byte[] alive = text("{\"alive\": {}}");
    ByteBuffer burst = ByteBuffer.allocate(alive.length * 700);
    for (int i = 0; i < 700; i++) {
      burst.put(alive);
    }
    many.getOutputStream().write(burst.array());
    String why = untilClosed(many);
    assertTrue(why.contains("more than 300 messages a second"), why);
    byte[][] floods = {
      frame(0x89, new byte[100]), // pings
      frame(0x8a, new byte[100]), // answers that nobody asked for
      frame(0x01, new byte[0]), // parts of a text that never ends
      text("{\"chat\": {\"text\": \"" + "x".repeat(1_000) + "\"}}")
    };
    for (byte[] flood : floods) {
      Socket socket = upgraded();
      boolean closed = false;
      for (int i = 0; i < 100_000 && !closed; i++) {
        try {
          socket.getOutputStream().write(flood);
        } catch (IOException e) {
          closed = true;
        }
      }
      assertTrue(closed, "the flood goes on");
    }
    assertPlayable();
  }

  @Test
  void halfOpenConnectionsTakeNoPlaceFromPlayers() throws Exception {
    for (int i = 0; i < 300; i++) {
      Socket socket = connect();
      if (i % 2 == 0) {
        socket
            .getOutputStream()
            .write("GET /thin HTTP/1.1\r\nHost: a".getBytes(StandardCharsets.US_ASCII));
      }
    }
    assertPlayable();
    List<Socket> waiting = new ArrayList<>();
    for (int i = 0; i < 15; i++) {
      waiting.add(upgraded()); // and never say what they want
    }
    assertPlayable();
    for (Socket socket : waiting) {
      assertTrue(untilClosed(socket).contains("refused"), "the lobby's deadline");
    }
  }

  @Test
  void linksAreCappedInAllAndForEachAddress() throws Exception {
    int open = 0;
    String last = "";
    for (int i = 0; i < 60 && !last.equals("429"); i++) {
      last = status("localhost", "");
      open += last.equals("101") ? 1 : 0;
    }
    assertEquals("429", last);
    assertEquals(20, open);
    assertTrue(
        server.port.troubles().contains("1 links refused as too many"), server.port.troubles());
  }

  @Test
  void foreignPagesAreRefusedAndProgramsAreNot() throws Exception {
    assertEquals("101", status("anything.example", ""));
    assertEquals("101", status("localhost:1", "Origin: http://localhost:1\r\n"));
    assertEquals("101", status("game.example", "Origin: https://game.example\r\n"));
    assertEquals("101", status("localhost", "Origin: https://game.example\r\n"));
    assertEquals("403", status("localhost", "Origin: https://evil.example\r\n"));
    assertEquals("403", status("evil.example", "Origin: http://evil.example\r\n"));
    assertEquals("403", status("localhost", "Origin: null\r\n"));
    assertEquals("403", status("localhost:1", "Origin: http://localhost:2\r\n"));
  }

  @Test
  void aClientThatDoesNotReadIsCutOff() throws Exception {
    try (PlayPort alone = new PlayPort(PlayPort.Settings.plain(List.of(LOOPBACK), 0, 8))) {
      try (Socket socket = new Socket(LOOPBACK, alone.tcpPort())) {
        String request = String.format(UPGRADE, "localhost", "");
        socket.getOutputStream().write(request.getBytes(StandardCharsets.US_ASCII));
        WebLink link = null;
        while (link == null) {
          link = (WebLink) alone.accept();
        }
        String line = "x".repeat(100_000);
        int told = 0;
        long endNs = System.nanoTime() + TimeUnit.SECONDS.toNanos(60);
        while (link.news(List.of(new ThinNews(new ThinServerMessage.Chat(1, line, false))))) {
          told++;
          assertTrue(System.nanoTime() < endNs, "told=" + told);
        }
        assertTrue(told <= 60, "told=" + told);
        assertEquals("unsentBytes=4194304 wait, the limit", link.closeReason());
      }
    }
  }
}
