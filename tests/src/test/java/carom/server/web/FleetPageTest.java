package carom.server.web;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import carom.server.access.Logins;
import carom.server.access.Secret;
import carom.server.command.CommandRegistry;
import carom.server.config.DataFolder;
import carom.server.fleet.FleetConsole;
import carom.server.fleet.FleetRig;
import carom.suite.Needs;
import ch.qos.logback.classic.LoggerContext;
import java.io.IOException;
import java.net.InetAddress;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: an operator sees the fleet at the page of one server, moves a room and drains another
 * server; Prometheus reads it, too. Method: three servers with a directory in memory, whose time
 * goes on by itself, and headless Chromium.
 */
@Needs("waits")
@Timeout(240)
final class FleetPageTest {
  private static final String TOKEN = "a token of the test";
  private static final int ENTER = 13;

  @TempDir private Path folder;
  private final Object time = new Object();
  private FleetRig rig; // guarded by time, once it goes on
  private WebServer web;
  private Thread player;
  private volatile boolean ended;

  @BeforeEach
  void start() throws IOException {
    rig = new FleetRig(folder, 4);
    for (String name : List.of("a.example", "b.example", "c.example")) {
      rig.node(name, 2);
    }
    rig.run(1);
    for (int i = 0; i < 5; i++) {
      rig.client("bot" + i, "a.example");
    }
    rig.run(4);
    FleetRig.Node node = rig.nodes.get("a.example");
    DataFolder data = new DataFolder(folder.resolve("data"));
    Files.createDirectories(data.root());
    Files.writeString(data.adminToken(), TOKEN + "\n");
    CommandRegistry commands = new CommandRegistry();
    FleetConsole.add(commands, node.member);
    Logins logins = Logins.begin(System::nanoTime);
    PageConfig config =
        new PageConfig(
            "Carom test",
            commands,
            Secret.of(data.adminToken()),
            logins.page(),
            LogTail.begin(new LoggerContext()),
            List.of(data.recordings()),
            true,
            List.of(),
            Set.of());
    WebSubject subject =
        new WebSubject(
            "Carom",
            "test",
            node.server.rooms(),
            List.of(),
            logins,
            node.member.figures(),
            List.of());
    InetAddress here = InetAddress.getLoopbackAddress();
    web = new WebServer(here, 0, subject, new LivePage(config, subject));
    player = new Thread(this::play, "fleet-page");
    player.start();
  }

  private void play() {
    while (!ended) {
      synchronized (time) {
        rig.run(0.02);
      }
      try {
        Thread.sleep(20);
      } catch (InterruptedException e) {
        return;
      }
    }
  }

  @AfterEach
  void end() throws InterruptedException {
    ended = true;
    if (player != null) {
      player.join();
    }
    if (web != null) {
      web.close();
    }
    rig.close();
  }

  private String metrics() throws Exception {
    HttpRequest request = HttpRequest.newBuilder(URI.create(web.url() + "/metrics")).build();
    return HttpClient.newHttpClient().send(request, HttpResponse.BodyHandlers.ofString()).body();
  }

  private double metric(String name) throws Exception {
    String text = metrics();
    int at = text.indexOf("\n" + name + " ");
    assertTrue(at >= 0, () -> name + " isn't in " + text);
    String line = text.substring(at + 1, text.indexOf('\n', at + 1));
    return Double.parseDouble(line.substring(name.length() + 1));
  }

  private void kill(String name) {
    synchronized (time) {
      rig.nodes.get(name).kill();
    }
  }

  @Test
  void theMetricsTellOfServersRoomsClaimsDeathsAndTakeovers() throws Exception {
    assertEquals(3, metric("carom_fleet_servers"));
    assertEquals(2, metric("carom_fleet_rooms_owned"));
    assertEquals(2, metric("carom_fleet_rooms_followed"));
    assertEquals(2, metric("carom_fleet_claims_won_total"));
    assertEquals(1, metric("carom_fleet_directory_up"));
    assertEquals(0, metric("carom_fleet_directory_requests_failed_total"));
    assertTrue(metric("carom_fleet_directory_requests_total") > 2);
    double left = metric("carom_fleet_lease_left_seconds");
    assertTrue(left > 0 && left <= 1.6, "lease=" + left);
    double lag = metric("carom_fleet_follower_lag_ticks{room=\"1\"}");
    assertTrue(lag >= 0 && lag < 10, "lag=" + lag);
    String metrics = metrics();
    String dashboard = Files.readString(Path.of("..", "docs", "grafana.json"));
    Matcher names = Pattern.compile("\\bcarom_fleet_[a-z_]+\\b").matcher(dashboard);
    while (names.find()) {
      assertTrue(metrics.matches("(?s).*\n" + names.group() + "[{ ].*"), names.group());
    }
    kill("b.example");
    kill("c.example");
    while (metric("carom_fleet_rooms_owned") < 6) {
      Thread.sleep(50);
    }
    assertEquals(1, metric("carom_fleet_servers"));
    assertEquals(2, metric("carom_fleet_deaths_total"));
    double took = metric("carom_fleet_takeover_duration_seconds_count");
    assertEquals(4, took);
    assertEquals(4, metric("carom_fleet_takeover_duration_seconds_bucket{le=\"+Inf\"}"));
    assertEquals(0, metric("carom_fleet_rooms_followed"), "nobody is left to follow");
  }

  @Test
  void anOperatorSeesTheFleetMovesARoomAndDrainsAServer() throws Exception {
    Path program = Chromium.find();
    if (program == null) {
      assertFalse(System.getenv("CI") != null, "CI has no Chromium: .ci/run installs it");
    }
    assumeTrue(program != null, "no Chromium");
    try (Chromium browser = Chromium.start(program, folder.resolve("profile"))) {
      browser.look(1280, 720, false);
      browser.open(web.url());
      browser.await("!document.getElementById('fleet').hidden");
      String rows = "[...document.querySelectorAll('#%s tbody tr')]";
      String servers = String.format(rows, "fleet-servers");
      String rooms = String.format(rows, "fleet-rooms");
      browser.await(servers + ".length === 3 && " + rooms + ".length === 6");
      assertEquals("0", browser.evaluate("document.querySelectorAll('#fleet .danger').length"));
      browser.click("document.getElementById('secret')");
      browser.type(TOKEN);
      browser.press("Enter", ENTER);
      browser.await("document.querySelectorAll('#fleet .danger').length === 9");
      browser.await(rooms + ".every(r => !r.cells[6].textContent.includes('none'))");
      browser.await(rooms + ".slice(0, 2).every(r => parseInt(r.cells[7].textContent) < 10)");
      shoot(browser, "fleet-page.png");

      // A room of another server, which this page's server tells to move it.
      String owner = browser.evaluate(rooms + "[3].cells[4].textContent");
      assertEquals("b.example", owner);
      browser.click(rooms + "[3].querySelector('.danger')");
      browser.await("document.getElementById('sure').open");
      assertEquals(
          "Move room 4?", browser.evaluate("$('sure-title').textContent".replace("$", DOM)));
      shoot(browser, "fleet-move.png");
      browser.evaluate(
          "$('sure-to').querySelector('select').value = 'c.example'".replace("$", DOM));
      browser.click("document.getElementById('sure-ok')");
      browser.await(rooms + "[3].cells[4].textContent === 'c.example'");

      browser.click(servers + "[2].querySelector('.danger')");
      browser.await("document.getElementById('sure').open");
      browser.click("document.getElementById('sure-ok')");
      browser.await(servers + "[2].cells[1].textContent === 'draining'");
      browser.await(rooms + ".every(r => r.cells[4].textContent !== 'c.example')");
      browser.await(servers + "[2].cells[3].textContent === '0'");
      browser.await(
          "/room [56] moved here/.test(document.getElementById('fleet-news').textContent)");
      kill("b.example");
      browser.await("document.getElementById('fleet-news').textContent.includes('took over room')");
      browser.await(
          "document.getElementById('fleet-news').textContent.includes('server b.example is lost')");
      browser.evaluate("document.getElementById('fleet').scrollIntoView()");
      shoot(browser, "fleet-news.png");
      String drained = servers + "[1]";
      browser.await(drained + ".querySelector('.danger').hidden");
      browser.click(drained + ".querySelector('button:not([hidden])')");
      browser.await(drained + ".cells[1].textContent === 'up'");
      browser.look(400, 800, true);
      assertEquals("true", browser.evaluate("document.documentElement.scrollWidth <= innerWidth"));
      shoot(browser, "fleet-narrow.png");
      assertEquals(List.of(), browser.errors());
    }
  }

  private static final String DOM = "document.getElementById";

  private static void shoot(Chromium browser, String name) throws Exception {
    String shots = System.getProperty("carom.shots");
    if (shots != null) {
      browser.evaluate("document.getElementById('fleet').scrollIntoView()");
      Files.write(Path.of(shots, name), browser.screenshot());
    }
  }
}
