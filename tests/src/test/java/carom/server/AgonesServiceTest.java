package carom.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.server.config.ServerConfig;
import carom.suite.Needs;
import java.io.IOException;
import java.net.ServerSocket;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * Goal: Agones knows how a server is, whatever its sidecar does. Method: a sidecar as its REST is
 * documented, which comes late, fails, hangs, and breaks its watches; time goes thirty times as
 * fast.
 */
@Needs("sockets")
@Timeout(60)
final class AgonesServiceTest {
  private static final AgonesService.Pace FAST = new AgonesService.Pace(5, 60, 400, 20, 300, 200);
  private static final String PORTS =
      "{\"name\":\"game-tcp\",\"port\":7001},{\"name\":\"game-udp\",\"port\":7002},"
          + "{\"name\":\"fleet\",\"port\":7003}";

  private FakeSidecar sidecar;
  private AgonesService service;
  private final Subject subject = new Subject();

  /** A server of the test. */
  private static final class Subject implements AgonesSubject {
    private volatile String problem = "";
    private volatile Set<String> players = Set.of();
    private volatile boolean draining;
    private volatile boolean drained;

    @Override
    public String problem() {
      return problem;
    }

    @Override
    public Set<String> players() {
      return players;
    }

    @Override
    public int roomsInUse() {
      return players.size();
    }

    @Override
    public void drain() {
      draining = true;
    }

    @Override
    public boolean isDraining() {
      return draining;
    }

    @Override
    public boolean isDrained() {
      return drained;
    }
  }

  private void start() throws IOException {
    sidecar = new FakeSidecar(PORTS);
    service = new AgonesService(sidecar.port(), FAST);
    service.start();
  }

  @AfterEach
  void end() {
    if (service != null) {
      service.close();
    }
    if (sidecar != null) {
      sidecar.close();
    }
  }

  private void await(String what, BooleanSupplier condition) throws InterruptedException {
    long endNs = System.nanoTime() + TimeUnit.SECONDS.toNanos(30);
    while (!condition.getAsBoolean()) {
      assertTrue(System.nanoTime() < endNs, () -> what + "; " + sidecar.calls);
      Thread.sleep(2);
    }
  }

  private void awaitStates(String... states) throws InterruptedException {
    await("states " + List.of(states), () -> sidecar.states().equals(List.of(states)));
  }

  @Test
  void aServerIsReadyAllocatedWhilePlayedAndReadyAgain() throws Exception {
    start();
    await("health before the server is ready", () -> sidecar.healths.get() > 2);
    assertEquals(List.of(), sidecar.calls, "it isn't ready yet");
    service.serve(subject);
    awaitStates("POST /ready");
    await("rooms", () -> sidecar.calls.toString().contains("{\"count\":\"0\"}"));
    subject.players = Set.of("Ann", "Bob");
    awaitStates("POST /ready", "POST /allocate");
    await("players", () -> sidecar.playersNow().equals("Ann,Bob"));
    await("rooms in use", () -> sidecar.roomsNow().equals("2/2"));
    subject.players = Set.of("Ann", "Bob", "Cid");
    await("one more", () -> sidecar.playersNow().equals("Ann,Bob,Cid"));
    assertEquals("2/2", sidecar.roomsNow(), "more than it was meant to carry");
    subject.players = Set.of("Bob");
    await("rooms that are empty", () -> sidecar.roomsNow().equals("1/2"));
    await("a player who left", () -> sidecar.playersNow().equals("Bob"));
    subject.players = Set.of();
    awaitStates("POST /ready", "POST /allocate", "POST /ready");
    assertTrue(
        sidecar.calls.contains(
            "PUT /metadata/label {\"key\":\"carom-draining\",\"value\":\"false\"}"),
        () -> sidecar.calls.toString());
    service.close();
    awaitStates("POST /ready", "POST /allocate", "POST /ready", "POST /shutdown");
  }

  @Test
  void aServerThatAMatchmakerAllocatedWaitsForItsPlayers() throws Exception {
    start();
    service.serve(subject);
    awaitStates("POST /ready");
    await("it is ready", () -> sidecar.state.equals("Ready"));
    sidecar.say("Allocated");
    long allocatedNs = System.nanoTime();
    awaitStates("POST /ready", "POST /ready");
    long ms = TimeUnit.NANOSECONDS.toMillis(System.nanoTime() - allocatedNs);
    assertTrue(ms >= FAST.empty(), "nobody came within " + ms + " ms");
  }

  @Test
  void theLabelDrainsTheServerAndEndsIt() throws Exception {
    start();
    service.serve(subject);
    subject.players = Set.of("Ann");
    awaitStates("POST /ready", "POST /allocate");
    sidecar.label(AgonesService.SUPERSEDED, "false");
    sidecar.label(AgonesService.SUPERSEDED, "true");
    await("drains", () -> subject.draining);
    await(
        "the label that allocations look at",
        () -> sidecar.calls.toString().contains("\"carom-draining\",\"value\":\"true\""));
    subject.drained = true;
    Thread.sleep(FAST.empty() / 2);
    assertEquals(2, sidecar.states().size(), "somebody still plays");
    subject.players = Set.of();
    awaitStates("POST /ready", "POST /allocate", "POST /shutdown");
    int healths = sidecar.healths.get();
    await("health until the signal", () -> sidecar.healths.get() > healths + 2);
    service.close();
    assertEquals(3, sidecar.states().size(), "it is told once");
  }

  @Test
  void aWatchThatBreaksBeginsAgain() throws Exception {
    start();
    service.serve(subject);
    awaitStates("POST /ready");
    for (int i = 1; i < 4; i++) {
      int before = sidecar.watches.get();
      sidecar.breakWatches();
      await("another watch", () -> sidecar.watches.get() > before);
    }
    sidecar.label(AgonesService.SUPERSEDED, "true");
    await("drains", () -> subject.draining);
  }

  @Test
  void anUnhealthyServerIsSilentUntilItIsWell() throws Exception {
    start();
    service.serve(subject);
    awaitStates("POST /ready");
    subject.problem = "room 1 is stuck";
    Thread.sleep(2L * FAST.health());
    int healths = sidecar.healths.get();
    Thread.sleep(5L * FAST.health());
    assertEquals(healths, sidecar.healths.get());
    subject.problem = "";
    await("health again", () -> sidecar.healths.get() > healths);
  }

  @Test
  void aSidecarThatFailsOrHangsIsAskedAgain() throws Exception {
    start();
    sidecar.failing = true;
    service.serve(subject);
    Thread.sleep(10L * FAST.retry());
    assertEquals(List.of(), sidecar.calls);
    sidecar.failing = false;
    awaitStates("POST /ready");
    sidecar.hanging = true;
    Thread.sleep(2L * FAST.deadline());
    subject.players = Set.of("Ann");
    int healths = sidecar.healths.get();
    sidecar.hanging = false;
    awaitStates("POST /ready", "POST /allocate");
    await("health again", () -> sidecar.healths.get() > healths);
    sidecar.hanging = true;
    long beginNs = System.nanoTime();
    service.close();
    long ms = TimeUnit.NANOSECONDS.toMillis(System.nanoTime() - beginNs);
    assertTrue(ms < 4L * FAST.deadline(), "the stop waits for " + ms + " ms");
  }

  @Test
  void aSidecarMayComeLate() throws Exception {
    int port;
    try (ServerSocket free = new ServerSocket(0)) {
      port = free.getLocalPort();
    }
    service = new AgonesService(port, FAST);
    service.start();
    service.serve(subject);
    IOException none = assertThrows(IOException.class, () -> service.awaitAddress(100));
    assertEquals(
        "the sidecar doesn't answer after 100 ms; name this server's ports and address"
            + " (--advertise HOST), or --agones off",
        none.getMessage());
    sidecar = new FakeSidecar(port, PORTS);
    assertEquals("127.0.0.1:7001:7002", service.awaitAddress(30_000).advertise());
    assertEquals("127.0.0.1:7003", service.awaitAddress(30_000).peer());
    awaitStates("POST /ready");
    await("a watch", () -> sidecar.watches.get() > 0);
  }

  @Test
  void aGameServerWithoutCountersAndAFullListCostNothing() throws Exception {
    start();
    sidecar.capacity = 1;
    service.serve(subject);
    subject.players = Set.of("Ann", "Bob");
    await("one fits", () -> sidecar.playersNow().length() == 3);
    subject.players = sidecar.playersNow().equals("Ann") ? Set.of("Bob") : Set.of("Ann");
    String other = subject.players.iterator().next();
    await("then the other one", () -> sidecar.playersNow().equals(other));
    service.close();
    sidecar.close();
    start();
    sidecar.lists = false;
    service.serve(subject);
    awaitStates("POST /ready", "POST /allocate");
    Thread.sleep(10L * FAST.nap());
    assertEquals(
        2,
        sidecar.calls.stream().filter(call -> call.startsWith("POST")).count(),
        () -> sidecar.calls.toString());
  }

  @Test
  void whatAgonesSaysIsRead() throws Exception {
    String text =
        "{\"result\":{\"objectMeta\":{\"labels\":{\"a\":\"b\"}},\"spec\":{\"health\":"
            + "{\"periodSeconds\":7}},\"status\":{\"state\":\"Ready\",\"address\":\"2001:db8::1\","
            + "\"ports\":[{\"name\":\"tcp\",\"port\":1},{\"name\":\"udp\",\"port\":2}]}}}";
    GameServer server = GameServer.parse(text.getBytes(StandardCharsets.UTF_8));
    assertEquals("[2001:db8::1]:1:2", server.advertise());
    assertEquals(7, server.healthPeriodS());
    assertEquals(Map.of("a", "b"), server.labels());
    IOException lacks = assertThrows(IOException.class, server::peer);
    assertTrue(lacks.getMessage().startsWith("the GameServer has no port named \"fleet\""));
    for (String bad : List.of("", "[]", "{}", "{\"error\":{\"message\":\"x\"}}", "{\"status\":")) {
      byte[] bytes = bad.getBytes(StandardCharsets.UTF_8);
      assertThrows(IOException.class, () -> GameServer.parse(bytes), bad);
    }
  }

  @Test
  void theEnvironmentSaysWhetherThereIsASidecar() {
    ServerConfig auto = ServerConfig.defaults();
    Map<String, String> pod = Map.of(AgonesFlags.PORT, "9400");
    assertTrue(AgonesFlags.isOn(auto, pod));
    assertFalse(AgonesFlags.isOn(auto, Map.of()));
    assertFalse(AgonesFlags.isOn(auto.with(ServerConfig.AGONES, ServerConfig.Agones.OFF), pod));
    ServerConfig on = auto.with(ServerConfig.AGONES, ServerConfig.Agones.ON);
    assertTrue(AgonesFlags.isOn(on, Map.of()));
    assertEquals(9358, AgonesFlags.port(Map.of()));
    assertEquals(9400, AgonesFlags.port(pod));
    assertNull(AgonesFlags.problem(on, pod));
    assertEquals(
        "AGONES_SDK_HTTP_PORT=x must be a port; or don't use it: --agones off",
        AgonesFlags.problem(auto, Map.of(AgonesFlags.PORT, "x")));
  }
}
