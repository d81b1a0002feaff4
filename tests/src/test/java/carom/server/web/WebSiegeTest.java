package carom.server.web;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.transport.NetworkCounter;
import carom.server.access.Logins;
import carom.server.http.HttpPort;
import carom.suite.Needs;
import carom.testkit.Stepper;
import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * Goal: visitors who hold connections hold up nobody, and hold none for long. Method: raw sockets
 * that begin requests and stop, trickle, or don't read, beside others that ask for health.
 */
@Needs("sockets")
@Timeout(120)
final class WebSiegeTest {
  private static final InetAddress LOOPBACK = InetAddress.getLoopbackAddress();
  private static final String HALF = "GET /healthz HTTP/1.1\r\nHost: 127.0.0.1\r\nX-Slow: ";
  private static final String HEALTH = "GET /healthz HTTP/1.1\r\nHost: 127.0.0.1\r\n";

  private final List<Socket> sockets = new ArrayList<>();
  private final CountDownLatch metrics = new CountDownLatch(1);
  private volatile boolean metricsHang;
  private Stepper stepper;
  private WebServer web;

  @BeforeEach
  void start() throws IOException {
    stepper = Stepper.of("arena");
    stepper.run(0.5);
    NetworkCounter counter = new NetworkCounter("slow", "May hang.", this::count);
    WebSubject subject =
        new WebSubject(
            "Carom",
            "1",
            stepper.server().rooms(),
            List.of(counter),
            Logins.begin(System::nanoTime),
            null,
            List.of());
    web = new WebServer(LOOPBACK, 0, subject, null);
  }

  private long count() {
    if (metricsHang) {
      try {
        metrics.await();
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
    }
    return 0;
  }

  @AfterEach
  void stop() throws IOException {
    metrics.countDown();
    for (Socket socket : sockets) {
      socket.close();
    }
    web.close();
    stepper.close();
  }

  private Socket connect() throws IOException {
    Socket socket = new Socket(LOOPBACK, URI.create(web.url()).getPort());
    socket.setSoTimeout(60_000);
    sockets.add(socket);
    return socket;
  }

  private Socket send(String text) throws IOException {
    Socket socket = connect();
    socket.getOutputStream().write(text.getBytes(StandardCharsets.US_ASCII));
    return socket;
  }

  private String answer(String request) throws IOException {
    try (Socket socket = send(request)) {
      return new String(socket.getInputStream().readAllBytes(), StandardCharsets.US_ASCII);
    }
  }

  private void assertHealthy() throws IOException {
    String answer = answer(HEALTH + "Connection: close\r\n\r\n");
    assertTrue(answer.startsWith("HTTP/1.1 200 ") && answer.endsWith("ok\n"), answer);
  }

  /** Returns how many of the sockets the server has not closed yet. */
  private int held() {
    return (int) sockets.stream().filter(socket -> !socket.isClosed() && isHeld(socket)).count();
  }

  private static boolean isHeld(Socket socket) {
    try {
      socket.setSoTimeout(1);
      return socket.getInputStream().read() >= 0;
    } catch (SocketTimeoutException e) {
      return true;
    } catch (IOException reset) {
      return false;
    }
  }

  @Test
  void unfinishedRequestsHoldUpNobodyAndEndSoon() throws Exception {
    for (String begun :
        List.of("", "G", HALF, HEALTH, "GET /live HTTP/1.1\r\nUpgrade: websocket\r\n")) {
      for (int i = 0; i < 2 * HttpPort.MOST_CONNECTIONS; i++) {
        send(begun);
        if (i % 100 == 99) {
          assertHealthy();
        }
      }
      int most = HttpPort.affordableConnections() / 2;
      long soonNs = System.nanoTime() + 10_000_000_000L; // closing takes a moment to arrive
      while (held() > most && System.nanoTime() - soonNs < 0) {
        Thread.sleep(20);
      }
      assertTrue(held() <= most, "held=" + held());
    }
    long endNs = System.nanoTime() + 90_000_000_000L;
    while (held() > 0 && System.nanoTime() - endNs < 0) {
      Thread.sleep(100);
    }
    assertEquals(0, held(), "none is held for ever");
  }

  @Test
  void aHeadThatTricklesEndsLikeOneThatStops() throws Exception {
    Socket socket = send(HALF);
    long endNs = System.nanoTime() + 60_000_000_000L;
    boolean closed = false;
    while (!closed && System.nanoTime() - endNs < 0) {
      Thread.sleep(200);
      try {
        socket.getOutputStream().write('x');
        closed = held() == 0;
      } catch (IOException e) {
        closed = true;
      }
    }
    assertTrue(closed);
  }

  @Test
  void noRequestHasABody() throws Exception {
    String post = "POST /healthz HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Length: 1000\r\n\r\n";
    assertTrue(answer(post).startsWith("HTTP/1.1 405 "), "and the connection ends at once");
    assertTrue(answer(post.replace("POST", "GET")).startsWith("HTTP/1.1 413 "));
    String chunked = HEALTH + "Transfer-Encoding: chunked\r\n\r\n";
    assertTrue(answer(chunked).startsWith("HTTP/1.1 413 "));
    assertHealthy();
  }

  @Test
  void healthIsToldWhileMetricsHangAndAnswersAreNotRead() throws Exception {
    String scrape = "GET /metrics HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n";
    for (int i = 0; i < 100; i++) {
      Socket socket = connect();
      socket.getOutputStream().write(scrape.repeat(40).getBytes(StandardCharsets.US_ASCII));
    }
    assertHealthy();
    metricsHang = true;
    for (int i = 0; i < 10; i++) {
      send(scrape);
      assertHealthy();
    }
  }

  @Test
  void headsAreSmall() throws Exception {
    for (String large :
        List.of(
            HALF + "x".repeat(200_000) + "\r\n\r\n", HEALTH + "A: b\r\n".repeat(1_000) + "\r\n")) {
      try {
        String answer = answer(large);
        assertTrue(!answer.startsWith("HTTP/1.1 200"), answer);
      } catch (IOException reset) {
        assertHealthy(); // that is an answer, too
      }
    }
    assertHealthy();
  }
}
