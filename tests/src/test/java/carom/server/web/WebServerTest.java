package carom.server.web;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.protocol.Protocol;
import carom.net.transport.NetworkCounter;
import carom.server.CaromMain;
import carom.server.access.Logins;
import carom.server.metrics.Counter;
import carom.server.metrics.TurnStage;
import carom.suite.Needs;
import carom.testkit.Stepper;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.concurrent.CountDownLatch;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Goal: programs learn how a server is. Method: HTTP requests beside a room stepped by hand. */
@Needs("sockets")
@Timeout(60)
final class WebServerTest {
  private static final InetAddress LOOPBACK = InetAddress.getLoopbackAddress();

  private final HttpClient client = HttpClient.newHttpClient();
  private final Logins logins = Logins.begin(System::nanoTime);
  private Stepper stepper;
  private WebServer web;

  @BeforeEach
  void start() throws IOException {
    stepper = Stepper.of("arena");
    List<NetworkCounter> network =
        List.of(
            new NetworkCounter("opened", "Links.", () -> 42),
            new NetworkCounter("errors", "Errors.", () -> 0));
    web = new WebServer(LOOPBACK, 0, subject(network), null);
  }

  private WebSubject subject(List<NetworkCounter> network) {
    return new WebSubject(
        "Carom", "1.2.3", stepper.server().rooms(), network, logins, null, List.of());
  }

  @AfterEach
  void stop() {
    web.close();
    stepper.close();
  }

  private HttpResponse<String> get(String path) throws Exception {
    HttpRequest request = HttpRequest.newBuilder(URI.create(web.url() + path)).build();
    return client.send(request, HttpResponse.BodyHandlers.ofString());
  }

  @Test
  void readyOnceTheFirstTickIsComputedAndUntilItStops() throws Exception {
    stepper.run(0.5);
    assertEquals("ok\n", get("/healthz").body());
    assertEquals(200, get("/readyz").statusCode());
    web.stopping();
    assertEquals(503, get("/readyz").statusCode());
    assertEquals("the server stops\n", get("/readyz").body());
    assertEquals(200, get("/healthz").statusCode());
    assertEquals(404, get("/").statusCode());
  }

  /** Goal: who is refused learns why, however much it sends that nobody reads. */
  @Test
  void aRequestWithABodyGetsItsAnswer() throws Exception {
    long seed = Long.getLong("carom.seed", System.nanoTime());
    Random dice = new Random(seed);
    for (int i = 0; i < 60; i++) {
      int bytes = 1 + dice.nextInt(dice.nextBoolean() ? 4 : 64_000);
      HttpRequest post =
          HttpRequest.newBuilder(URI.create(web.url() + "/healthz"))
              .POST(HttpRequest.BodyPublishers.ofByteArray(new byte[bytes]))
              .build();
      HttpResponse<String> answer = client.send(post, HttpResponse.BodyHandlers.ofString());
      String about = "seed=" + seed + " bytes=" + bytes;
      assertEquals(405, answer.statusCode(), about);
      assertEquals("only GET\n", answer.body(), about);
    }
  }

  @Test
  void aRequestThatHangsDoesNotHoldTheStop() throws Exception {
    CountDownLatch asked = new CountDownLatch(1);
    CountDownLatch answer = new CountDownLatch(1);
    NetworkCounter hangs =
        new NetworkCounter(
            "hangs",
            "Hangs.",
            () -> {
              asked.countDown();
              try {
                answer.await();
              } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
              }
              return 0;
            });
    WebServer other = new WebServer(LOOPBACK, 0, subject(List.of(hangs)), null);
    try {
      HttpRequest metrics = HttpRequest.newBuilder(URI.create(other.url() + "/metrics")).build();
      var unused = client.sendAsync(metrics, HttpResponse.BodyHandlers.ofString());
      asked.await();
      assertTimeoutPreemptively(Duration.ofSeconds(20), other::close);
    } finally {
      answer.countDown();
    }
  }

  private static int health(StringWriter said, String... args) {
    PrintWriter out = new PrintWriter(said);
    List<String> words = new ArrayList<>(List.of(args));
    words.add(0, "health");
    return CaromMain.run(out, out, words.toArray(String[]::new));
  }

  @Test
  void theHealthCommandSaysWhatTheServerAnswers() {
    String server = URI.create(web.url()).getAuthority();
    StringWriter early = new StringWriter();
    assertEquals(1, health(early, server, "--ready"));
    assertTrue(early.toString().startsWith("the first tick is not computed yet"), early.toString());
    stepper.run(0.5);
    StringWriter well = new StringWriter();
    assertEquals(0, health(well, server, "--ready"));
    assertEquals("ok", well.toString().strip());
    web.stopping();
    StringWriter stopping = new StringWriter();
    assertEquals(1, health(stopping, server, "--ready"));
    assertEquals("the server stops", stopping.toString().strip());
    assertEquals(0, health(new StringWriter(), server));
    web.close();
    StringWriter none = new StringWriter();
    assertEquals(1, health(none, server));
    assertTrue(none.toString().startsWith("No answer from http://" + server), none.toString());
  }

  @Test
  void theHealthCommandRefusesWhatIsNoServer() {
    for (String server :
        List.of("no host:1", "127.0.0.1:70000", "/x", "127.0.0.1:80/x", "a:80?b", "")) {
      StringWriter said = new StringWriter();
      assertEquals(2, health(said, server), server);
      assertTrue(said.toString().contains("must be HOST:PORT"), said.toString());
    }
    StringWriter said = new StringWriter();
    assertEquals(2, health(said, "--timeout", "0"));
    assertTrue(said.toString().contains("--timeout must be 1..60 seconds"), said.toString());
  }

  @Test
  void aRoomThatNoLongerTicksIsStuckAfterTenSeconds() {
    long[] now = {0};
    Health health = new Health(stepper.server().rooms(), () -> now[0]);
    stepper.run(0.1);
    assertEquals("", health.problem());
    now[0] += Health.STUCK_NS - 1;
    assertEquals("", health.problem());
    now[0]++;
    assertTrue(health.problem().startsWith("room 1 is stuck at tick "), health.problem());
    stepper.run(0.1);
    assertEquals("", health.problem());
    stepper.room().fail("of the test");
    assertEquals("all rooms have failed", health.problem());
  }

  @Test
  void everyCounterIsAMetricWithItsHelp() throws Exception {
    stepper.run(1);
    HttpResponse<String> response = get("/metrics");
    assertTrue(response.headers().firstValue("Content-Type").orElse("").startsWith("text/plain"));
    String text = response.body();
    for (Counter counter : Counter.values()) {
      String name = "carom_" + counter.name().toLowerCase(Locale.ROOT);
      String full = counter.isGauge() ? name : name + "_total";
      assertTrue(text.contains("# HELP " + full + " " + counter.help() + "\n"), full);
      assertTrue(text.contains("\n" + full + "{room=\"1\"} "), full);
    }
    long ticks = stepper.room().counters().get(Counter.TICKS);
    assertTrue(text.contains("carom_ticks_total{room=\"1\"} " + ticks + ".0\n"), text);
    for (TurnStage stage : TurnStage.values()) {
      String label = "stage=\"" + stage.name().toLowerCase(Locale.ROOT) + "\"";
      assertTrue(text.contains("carom_stage_seconds_total{room=\"1\"," + label + "} "), text);
    }
    assertTrue(text.contains("carom_network_opened_total 42.0\n"), text);
    assertTrue(
        text.contains("carom_tick_duration_seconds_bucket{room=\"1\",le=\"+Inf\"} " + ticks), text);
    assertTrue(text.contains("jvm_memory_used_bytes"), text);
    Matcher types = Pattern.compile("# TYPE (\\S+) ").matcher(text);
    while (types.find()) {
      assertTrue(text.matches("(?s).*# HELP " + types.group(1) + " \\S.*"), types.group(1));
    }
  }

  @Test
  void buildProcessAndFailedLoginsAreMetrics() throws Exception {
    for (int i = 0; i < 3; i++) {
      logins.rcon().wrong(LOOPBACK);
    }
    logins.page().wrong(LOOPBACK);
    String text = get("/metrics").body();
    String java = Runtime.version().toString();
    assertTrue(
        text.contains(
            String.format(
                Locale.ROOT,
                "carom_build_info{java=\"%s\",protocol=\"%d\",version=\"1.2.3\"} 1",
                java,
                Protocol.VERSION)),
        text);
    assertTrue(text.contains("carom_logins_failed_total{door=\"page\"} 1.0\n"), text);
    assertTrue(text.contains("carom_logins_failed_total{door=\"rcon\"} 3.0\n"), text);
    assertTrue(text.contains("# HELP carom_logins_failed_total Logins of operators"), text);
    Matcher resident = Pattern.compile("\nprocess_resident_memory_bytes (\\S+)\n").matcher(text);
    assertTrue(resident.find(), text);
    double bytes = Double.parseDouble(resident.group(1));
    boolean known = Files.exists(Path.of("/proc/self/status"));
    assertTrue(known ? bytes > 20e6 && bytes < 20e9 : Double.isNaN(bytes), resident.group());
  }

  /** Waits for a pause to be told, which a thread of the JVM does soon after it. */
  private String metricsAfterACollection() throws Exception {
    String text;
    do {
      System.gc();
      Thread.sleep(10);
      text = get("/metrics").body();
    } while (!text.contains("\njvm_gc_pause_seconds_sum{"));
    return text;
  }

  @Test
  void theDashboardAsksForMetricsThatAreThere() throws Exception {
    stepper.run(1);
    String metrics = metricsAfterACollection();
    String dashboard = Files.readString(Path.of("..", "docs", "grafana.json"));
    // those of a fleet are FleetPageTest's
    Matcher names =
        Pattern.compile("\\b(carom_(?!fleet)|jvm_|process_)[a-z_]+\\b").matcher(dashboard);
    int count = 0;
    while (names.find()) {
      assertTrue(metrics.matches("(?s).*\n" + names.group() + "[{ ].*"), names.group());
      count++;
    }
    assertTrue(count > 20, "names=" + count);
  }

  @Test
  void aBusyPortIsNamed() throws IOException {
    try (ServerSocket busy = new ServerSocket(0, 1, LOOPBACK)) {
      IOException e =
          assertThrows(
              IOException.class,
              () -> new WebServer(LOOPBACK, busy.getLocalPort(), subject(List.of()), null));
      assertTrue(e.getMessage().contains("it is busy"), e.getMessage());
      assertTrue(e.getMessage().contains("--web-port, or --no-web"), e.getMessage());
    }
  }
}
