package carom.client;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.link.ConnectionPhase;
import carom.client.view.ClientView;
import carom.net.kryo.KryoMessageCodec;
import carom.net.transport.ClientTransport;
import carom.net.transport.ImpairedClientTransport;
import carom.net.transport.Impairment;
import carom.net.transport.InProcessNetwork;
import carom.physics.Body;
import carom.sim.entity.HostEntity;
import carom.sim.level.Level;
import carom.testkit.Scripts;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;

/**
 * Goal: a client predicts its own body to the bit when it is alone, and corrections are smooth when
 * it is not. Method: a client and a scripted authority in virtual time, with and without a bad
 * network.
 */
final class PredictionScenarioTest {
  private static final long MS = 1_000_000L;
  private static final String ARENA =
      """
      {"name": "empty", "game": "arena", "gravity": [0, 0],
       "bounds": {"min": [-20, -12], "max": [20, 12]},
       "materials": {"wall": {"friction": 0.2, "restitution": 0.5}},
       "spawns": [{"name": "ball", "at": [19, 11]}],
       "zones": [
         {"name": "goal", "team": 1, "min": [-19.5, -1], "max": [-19, 1]},
         {"name": "goal", "team": 2, "min": [19, -1], "max": [19.5, 1]},
         {"name": "home", "team": 1, "min": [-6, -2], "max": [-4, 2]},
         {"name": "home", "team": 2, "min": [4, -2], "max": [6, 2]}],
       "statics": [
         {"name": "wall", "at": [-9, 0], "material": "wall",
          "shape": {"type": "box", "width": 1, "height": 12}},
         {"name": "wall", "at": [9, 0], "material": "wall",
          "shape": {"type": "box", "width": 1, "height": 12}},
         {"name": "wall", "at": [0, 6], "material": "wall",
          "shape": {"type": "box", "width": 18, "height": 1}},
         {"name": "wall", "at": [0, -6], "material": "wall",
          "shape": {"type": "box", "width": 18, "height": 1}},
         {"name": "post", "at": [0, 2], "material": "wall",
          "shape": {"type": "polygon", "points": [[-1, -1], [1, -1], [0, 1]]}}]}
      """;

  private static final String STAIRS =
      """
      {"name": "stairs", "game": "platformer", "gravity": [0, -26],
       "bounds": {"min": [-20, -6], "max": [20, 14]},
       "materials": {"ground": {"friction": 0.7}},
       "spawns": [{"name": "player", "at": [0, 1.5]}, {"name": "flag", "at": [-19, 13]}],
       "zones": [],
       "statics": [
         {"name": "ground", "at": [0, -0.5], "material": "ground",
          "shape": {"type": "box", "width": 30, "height": 1}},
         {"name": "wall", "at": [-14, 4], "material": "ground",
          "shape": {"type": "box", "width": 1, "height": 10}},
         {"name": "wall", "at": [14, 4], "material": "ground",
          "shape": {"type": "box", "width": 1, "height": 10}},
         {"name": "step", "at": [5, 0.4], "material": "ground",
          "shape": {"type": "box", "width": 4, "height": 0.8}},
         {"name": "shelf", "at": [-5, 2.5], "material": "ground", "oneWay": true,
          "shape": {"type": "box", "width": 5, "height": 0.3}},
         {"name": "ramp", "at": [9, 0], "material": "ground",
          "shape": {"type": "polygon", "points": [[-1, 0], [3, 0], [3, 1.5]]}}]}
      """;

  private final InProcessNetwork network = new InProcessNetwork(new KryoMessageCodec());
  private long now = MS;
  private ScriptedServer server;
  private GameClient client;

  private void start(Level level, Impairment impairment, InputSource input) {
    server = new ScriptedServer(network.server(), level);
    ClientTransport transport =
        new ImpairedClientTransport(
            network.client(), impairment, new KryoMessageCodec(), () -> now);
    client = new GameClient(config(), transport, input, () -> 0);
  }

  private static ClientConfig config() {
    return ClientConfig.of("tester").withServer("memory", 0, 0);
  }

  private void run(double seconds) {
    long end = now + (long) (seconds * 1e9);
    while (now < end) {
      now += ScriptedServer.TICK_NS / 2;
      client.update(now);
      now += ScriptedServer.TICK_NS / 2;
      server.tick(now);
    }
  }

  @Test
  void aloneAmongWallsNothingIsEverCorrected() throws Exception {
    for (Impairment bad :
        new Impairment[] {
          Impairment.NONE.withLatency(75, 0),
          Impairment.NONE.withSeed(5).withLatency(50, 10).withLoss(2)
        }) {
      start(arena(), bad, Scripts.wander(3));
      run(3);
      long before = client.stats().corrections();
      long compared = client.stats().compared();
      int missing = server.guests.get(server.guests.size() - 1).missing;
      run(20);
      assertTrue(client.stats().compared() - compared > 800, "compared " + bad);
      missing = server.guests.get(server.guests.size() - 1).missing - missing;
      assertTrue(
          client.stats().corrections() - before <= missing,
          "corrections=" + (client.stats().corrections() - before) + " missing=" + missing);
      assertTrue(missing < 20, "inputs that came too late: " + missing + " with " + bad);
      client.close();
    }
  }

  @Test
  void runningAndJumpingOnStaticGroundIsExactToTheBit() throws Exception {
    Level stairs = Level.parse("stairs.json", STAIRS.getBytes(StandardCharsets.UTF_8));
    for (int seed = 0; seed < 4; seed++) {
      Impairment bad = Impairment.NONE.withSeed(seed).withLatency(60, 8).withLoss(seed);
      start(stairs, bad, Scripts.wander(seed));
      double highest = 0;
      for (int i = 0; i < 200; i++) {
        run(0.1);
        highest = Math.max(highest, client.view().own() == null ? 0 : client.view().own().y());
      }
      String what = "seed " + seed;
      assertTrue(highest > 2, what + ": it jumped, highest=" + highest);
      assertTrue(client.stats().compared() > 800, what);
      assertTrue(server.guests.get(server.guests.size() - 1).missing <= 10, what);
      assertEquals(0, client.stats().corrections(), what);
      assertEquals(1, client.stats().exactRate(), what);
      client.close();
    }
  }

  @Test
  void amongCratesCorrectionsAreTooSmallToSee() throws Exception {
    start(Level.builtIn("platformer"), Impairment.NONE.withLatency(60, 0), Scripts.wander(11));
    run(25);
    assertTrue(client.stats().compared() > 1_000);
    double exact = client.stats().exactRate();
    assertTrue(exact > 0.5, "exact rate " + exact);
    double mean = client.stats().correctionMeanMetres();
    assertTrue(mean < 0.02, "mean correction " + mean + " m");
  }

  @Test
  void aPushIsShownSoftlyAndGoneAfterAQuarterOfASecond() throws Exception {
    start(arena(), Impairment.NONE.withLatency(60, 0), InputSource.IDLE);
    run(2);
    HostEntity body = server.simulation.player(0).entity();
    Body<HostEntity> b = body.body();
    b.setVelocity(6, 1);
    double largestStep = 0;
    ClientView.Drawn own = client.view().own();
    assertNotNull(own);
    float x = own.x();
    float y = own.y();
    for (int i = 0; i < 15 + 8; i++) {
      run(1 / 60.0);
      own = client.view().own();
      largestStep = Math.max(largestStep, Math.hypot(own.x() - x, own.y() - y));
      x = own.x();
      y = own.y();
    }
    assertTrue(client.stats().corrections() > 0, "it was a surprise");
    assertTrue(client.stats().correctionMaxMetres() > 0.1, "and a big one");
    assertTrue(largestStep < 0.35, "largest step in a frame: " + largestStep + " m");
    run(0.25);
    assertEquals(0, client.visualErrorMetres(), 0.01);
  }

  @Test
  void aDeadlineMissedByASlowFrameIsMadeUp() throws Exception {
    start(arena(), Impairment.NONE.withLatency(40, 0), Scripts.wander(9));
    run(3);
    for (int i = 0; i < 60; i++) { // one second without a frame
      now += ScriptedServer.TICK_NS;
      server.tick(now);
    }
    run(2);
    long corrections = client.stats().corrections();
    run(5);
    assertEquals(corrections, client.stats().corrections());
    assertEquals(ConnectionPhase.PLAYING, client.view().phase());
  }

  static Level arena() throws Exception {
    return Level.parse("empty.json", ARENA.getBytes(StandardCharsets.UTF_8));
  }
}
