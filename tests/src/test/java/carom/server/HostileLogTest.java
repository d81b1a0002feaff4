package carom.server;

import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.fixtures.Jvm;
import carom.net.kryo.KryoClientTransport;
import carom.net.protocol.ClientMessage;
import carom.net.protocol.Protocol;
import carom.net.transport.Link;
import carom.net.transport.LinkHandler;
import carom.suite.Needs;
import java.io.IOException;
import java.io.InputStream;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.WebSocket;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.KeyPairGenerator;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.Random;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: whatever strangers do again and again, the log stays short. Method: a real process with all
 * its ports, the same offence many times, the lines and bytes of standard error. {@code
 * -Dcarom.log.offences=N} says how often.
 */
@Needs("sockets")
final class HostileLogTest {
  /** More than what a cause may write at once, or nothing would be held back. */
  private static final int OFFENCES = Integer.getInteger("carom.log.offences", 250);

  private static final int THREADS = 8;

  /** Lines about other things meanwhile: what the network refused, and what was held back. */
  private static final int OTHERS_PER_SECOND = 2;

  private static final int MOST_BYTES_OF_A_LINE = 300;

  @TempDir Path folder;
  private final ExecutorService threads = Executors.newFixedThreadPool(THREADS);
  private final KryoClientTransport transport = new KryoClientTransport();
  private final long seed = Long.getLong("carom.seed", System.nanoTime());
  private Process server;
  private int tcp;
  private int udp;
  private int web;
  private int side;

  /** Something that a stranger does. */
  private interface Offence {
    void commit(int number) throws Exception;
  }

  @BeforeEach
  void start() throws Exception {
    byte[] key = KeyPairGenerator.getInstance("Ed25519").generateKeyPair().getPublic().getEncoded();
    Path pem = folder.resolve("join.pem");
    Files.writeString(pem, Base64.getEncoder().encodeToString(key));
    tcp = freePort();
    udp = freePort();
    web = freePort();
    side = freePort();
    List<String> command = Jvm.command(ServerMain.class);
    command.addAll(List.of("--data=" + folder.resolve("data"), "--log-keep=0", "--no-console"));
    command.addAll(List.of("--bind=127.0.0.1", "--tcp-port=" + tcp, "--udp-port=" + udp));
    command.addAll(List.of("--web", "--web-port=" + web, "--join-key=" + pem));
    command.addAll(List.of("--query", "--query-port=" + side, "--rcon", "--rcon-port=" + side));
    server = new ProcessBuilder(command).redirectError(log().toFile()).start();
    byte[] ready = new byte[6];
    InputStream out = server.getInputStream();
    assertTrue(
        out.readNBytes(ready, 0, 6) == 6
            && new String(ready, StandardCharsets.US_ASCII).equals("ready "),
        this::text);
  }

  @AfterEach
  void end() {
    threads.shutdownNow();
    transport.close();
    server.destroyForcibly();
  }

  private static int freePort() throws IOException {
    try (ServerSocket probe = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      return probe.getLocalPort();
    }
  }

  private Path log() {
    return folder.resolve("err");
  }

  private String text() {
    try {
      return Files.readString(log());
    } catch (IOException e) {
      return e.toString();
    }
  }

  /** Commits an offence again and again, on several threads, and checks what the log says of it. */
  private void repeat(String what, Offence offence) throws Exception {
    String before = text();
    long beganNs = System.nanoTime();
    List<Future<?>> parts = new ArrayList<>();
    for (int i = 0; i < THREADS; i++) {
      int first = i;
      parts.add(
          threads.submit(
              () -> {
                for (int n = first; n < OFFENCES; n += THREADS) {
                  offence.commit(n);
                }
                return null;
              }));
    }
    for (Future<?> part : parts) {
      part.get();
    }
    TimeUnit.MILLISECONDS.sleep(500); // the log has a thread of its own
    double seconds = (System.nanoTime() - beganNs) * 1e-9;
    String written = text().substring(before.length());
    long lines = written.lines().count();
    System.out.printf(
        "log: %s: %d times in %.1f s, %d lines, %d bytes%n",
        what, OFFENCES, seconds, lines, written.length());
    double most = LogLimit.BURST + (LogLimit.PER_SECOND + OTHERS_PER_SECOND) * (seconds + 1);
    String shown = written.substring(0, Math.min(2_000, written.length()));
    assertTrue(lines <= most, () -> what + ": lines=" + lines + " most=" + most + "\n" + shown);
    assertTrue(
        written.length() <= most * MOST_BYTES_OF_A_LINE,
        () -> what + ": bytes=" + written.length() + "\n" + shown);
  }

  /** Says hello, waits until that is refused, and leaves. */
  private void hello(int version, String token) throws InterruptedException {
    Link link = transport.connect("127.0.0.1", tcp, udp);
    Answer answer = new Answer();
    boolean greeted = false;
    while (!answer.came && link.state() != Link.State.CLOSED) {
      if (!greeted && link.state() == Link.State.OPEN) {
        greeted = true;
        link.send(
            new ClientMessage.Hello(
                version, Protocol.physicsDigest(), "Ann", 0, "", "", "", token));
      }
      link.poll(answer, 100);
      Thread.sleep(1);
    }
    link.close("");
  }

  @Test
  void noOffenceFillsTheLog() throws Exception {
    System.out.println("seed=" + seed);
    repeat("another version", n -> hello(Protocol.VERSION + 1, ""));
    repeat("no token", n -> hello(Protocol.VERSION, ""));
    repeat("a bad token", n -> hello(Protocol.VERSION, "e30.e30." + n));
    repeat("malformed frames", n -> garbageByTcp(tcp, n));
    repeat("malformed HTTP", n -> garbageByTcp(web, n));
    repeat("strange requests", this::strangeRequest);
    repeat("wrong tokens of the page", this::loginToThePage);
    repeat("garbage to the remote console", n -> garbageByTcp(side, n));
    repeat("wrong passwords", this::loginToTheConsole);
    repeat("garbage datagrams to the game", n -> garbageByUdp(udp, n));
    repeat("garbage status queries", n -> garbageByUdp(side, n));
    assertTrue(server.isAlive(), this::text);
    assertTrue(text().contains("refused: "), "the log says nothing of what was refused");
  }

  private void garbageByTcp(int port, int number) throws IOException {
    byte[] bytes = new byte[200];
    new Random(seed + number).nextBytes(bytes);
    if (number % 2 == 0) {
      ByteBuffer.wrap(bytes).putInt(60); // the length of a frame that may come
    }
    try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), port)) {
      socket.setSoTimeout(100);
      socket.getOutputStream().write(bytes);
      socket.shutdownOutput();
      socket.getInputStream().readAllBytes();
    } catch (IOException closed) {
      // by the server, in the middle of it or too late
    }
  }

  private void strangeRequest(int number) throws IOException {
    String[] requests = {
      "GET /" + "a".repeat(20_000) + " HTTP/1.1\r\nHost: localhost\r\n\r\n",
      "GET /%ff%00%2e%2e/" + number + " HTTP/1.1\r\nHost: localhost\r\n\r\n",
      "BREW /" + number + " HTTP/9.7\r\nHost: " + number + ".example\r\n\r\n",
      "POST /live HTTP/1.1\r\nHost: localhost\r\nContent-Length: -" + number + "\r\n\r\n",
      "GET /live HTTP/1.1\r\nHost: localhost\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
          + ("Sec-WebSocket-Key: " + number + "\r\nSec-WebSocket-Version: 99\r\n\r\n"),
      "GET / HTTP/1.1\r\nHost: localhost\r\nTransfer-Encoding: chunked\r\n\r\nzz" + number + "\r\n",
    };
    try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), web)) {
      socket.setSoTimeout(100);
      String request = requests[number % requests.length];
      socket.getOutputStream().write(request.getBytes(StandardCharsets.ISO_8859_1));
      socket.getInputStream().readAllBytes();
    } catch (IOException closed) {
      // by the server, in the middle of it or too late
    }
  }

  private void loginToThePage(int number) throws InterruptedException {
    try {
      WebSocket socket =
          HttpClient.newHttpClient()
              .newWebSocketBuilder()
              .header("Origin", "http://127.0.0.1:" + web)
              .buildAsync(
                  URI.create("ws://127.0.0.1:" + web + "/live"), new WebSocket.Listener() {})
              .get(5, TimeUnit.SECONDS);
      String login = "{\"do\":\"login\",\"secret\":\"wrong" + number + "\"}";
      for (int i = 0; i < 4; i++) {
        socket.sendText(login, true).get(5, TimeUnit.SECONDS);
      }
      socket.abort();
    } catch (ExecutionException | TimeoutException e) {
      // too many at once
    }
  }

  private void loginToTheConsole(int number) throws IOException {
    byte[] password = ("wrong" + number).getBytes(StandardCharsets.UTF_8);
    ByteBuffer login = ByteBuffer.allocate(14 + password.length).order(ByteOrder.LITTLE_ENDIAN);
    login.putInt(10 + password.length).putInt(1).putInt(3).put(password);
    try (Socket socket = new Socket()) {
      socket.bind(new InetSocketAddress("127.0.9." + (1 + number % 200), 0)); // hosts of their own
      socket.connect(new InetSocketAddress(InetAddress.getLoopbackAddress(), side));
      socket.setSoTimeout(100);
      socket.getOutputStream().write(login.array());
      socket.getInputStream().readAllBytes();
    } catch (IOException closed) {
      // by the server, in the middle of it or too late
    }
  }

  private void garbageByUdp(int port, int number) throws IOException {
    Random random = new Random(seed + number);
    try (DatagramSocket socket = new DatagramSocket()) {
      for (int i = 0; i < 20; i++) {
        byte[] bytes = new byte[1 + random.nextInt(1_400)];
        random.nextBytes(bytes);
        if (i % 2 == 0 && bytes.length > 5) {
          ByteBuffer.wrap(bytes).putInt(-1).put("TUV".getBytes(StandardCharsets.US_ASCII)[i % 3]);
        }
        socket.send(
            new DatagramPacket(bytes, bytes.length, InetAddress.getLoopbackAddress(), port));
      }
    }
  }

  /** Hears whether the server answers. */
  private static final class Answer implements LinkHandler {
    private boolean came;

    @Override
    public void message(Link from, Object message) {
      came = true;
    }

    @Override
    public void datagram(Link from, byte[] bytes, int length) {
      // none comes
    }

    @Override
    public void closed(Link from, String reason) {
      // the loop sees it
    }
  }
}
