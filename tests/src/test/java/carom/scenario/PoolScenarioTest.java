package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.ClientConfig;
import carom.client.PredictionMode;
import carom.client.bots.Bot;
import carom.net.protocol.ClientMessage;
import carom.net.protocol.Protocol;
import carom.net.protocol.ServerMessage;
import carom.net.transport.Impairment;
import carom.net.transport.Link;
import carom.net.transport.LinkHandler;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.sim.level.Level;
import carom.sim.outbox.NextMatch;
import carom.sim.pool.Pools;
import carom.testkit.Scripts;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.junit.jupiter.api.Test;

/**
 * Goal: all clients have the particles of the server, and predict what these do to bodies. Method:
 * the level that ships with pools, real server and clients in virtual time.
 */
class PoolScenarioTest {
  private static final Impairment FAR =
      Impairment.NONE.withLatency(75, 0).withLoss(2).withSeed(Stepper.SEED);

  /** By tick: the hash of the particles, as the first of server and clients had them. */
  private final Map<Integer, Long> hashes = new HashMap<>();

  private int compared;
  private int different;

  private static Stepper sluice() throws Exception {
    return Stepper.of(Level.builtIn("sluice"), ServerConfig.defaults());
  }

  /** Lets time pass, and compares the particles of server and clients wherever both had a tick. */
  private void watch(Stepper stepper, double seconds, List<SimulatedClient> clients) {
    for (int i = 0; i < 60 * seconds; i++) {
      stepper.step();
      note(stepper.room().simulation().pools(), false);
      for (SimulatedClient client : clients) {
        Pools pools = client.view().pools();
        if (pools != null && pools.isKnown()) {
          note(pools, true);
        }
      }
    }
  }

  private void note(Pools pools, boolean counts) {
    long hash = 0;
    for (int i = 0; i < pools.count(); i++) {
      hash = 31 * hash + pools.get(i).particles().stateHash();
    }
    Long other = hashes.putIfAbsent(pools.tick(), hash);
    compared += counts && other != null ? 1 : 0;
    different += other != null && other != hash ? 1 : 0;
  }

  @Test
  void twoClientsHaveTheServersParticlesAndPredictWhatTheyDoToBodies() throws Exception {
    try (Stepper stepper = sluice()) {
      ClientConfig all = ClientConfig.of("p").with(ClientConfig.PREDICTION, PredictionMode.ALL);
      SimulatedClient p = stepper.add(all, FAR, Scripts.wander(Stepper.SEED));
      SimulatedClient q = stepper.add("q", FAR, new Bot(2));
      stepper.run(4);
      final long awake = p.stats().awakeBodies();
      final long exact = p.stats().exactBodies();
      final long bytes = p.stats().bytesIn();
      watch(stepper, 30, List.of(p, q));
      long awakeBodies = p.stats().awakeBodies() - awake;
      double right = 100.0 * (p.stats().exactBodies() - exact) / awakeBodies;
      String about =
          String.format(
              Locale.ROOT,
              "right=%.2f %% of %d, compared=%d different=%d late=%d kbit/s=%.1f",
              right,
              awakeBodies,
              compared,
              different,
              p.view().tick() - p.view().pools().tick(),
              (p.stats().bytesIn() - bytes) * 8 / 30e3);
      assertTrue(compared > 3_000, about);
      assertEquals(0, different, about);
      assertTrue(right >= 99, about);
      assertEquals(0, stepper.count(Counter.DIVERGENCES_UNEXPLAINED), about);
      assertEquals(0, stepper.count(Counter.UNPREDICTABLE), about);
    }
  }

  @Test
  void whoComesLateOrComesBackHasTheSameParticles() throws Exception {
    try (Stepper stepper = sluice()) {
      SimulatedClient p = stepper.join("p", FAR, new Bot(1));
      stepper.run(8);
      SimulatedClient q = stepper.join("q", FAR, new Bot(2));
      watch(stepper, 4, List.of(p, q));
      int before = compared;
      p.cut();
      watch(stepper, 6, List.of(q));
      stepper.awaitPlaying(p);
      stepper.run(2);
      watch(stepper, 4, List.of(p));
      assertTrue(before > 200 && compared > before + 400, "compared=" + compared);
      assertEquals(0, different);
    }
  }

  @Test
  void aClientThatHeardNothingForSecondsLoadsTheStateAnew() throws Exception {
    try (Stepper stepper = sluice()) {
      SimulatedClient p = stepper.join("p", FAR, new Bot(1));
      stepper.run(5);
      stepper.blackout(p, 3);
      stepper.run(8);
      int before = compared;
      watch(stepper, 3, List.of(p));
      assertTrue(compared > before + 150, "compared=" + compared);
      assertEquals(0, different);
      int late = p.view().tick() - p.view().pools().tick();
      assertTrue(late < 3, "late=" + late);
    }
  }

  @Test
  void theNextMatchHasParticlesOfItsOwn() throws Exception {
    try (Stepper stepper = sluice()) {
      SimulatedClient p = stepper.join("p", FAR, new Bot(1));
      stepper.run(3);
      stepper.room().simulation().playNext(NextMatch.level("lagoon"));
      stepper.run(4);
      assertEquals(0, p.view().pools().count());
      stepper.room().simulation().playNext(NextMatch.level("sluice"));
      stepper.run(5);
      assertEquals(2, p.view().pools().count());
      watch(stepper, 3, List.of(p));
      assertTrue(compared > 150, "compared=" + compared);
      assertEquals(0, different);
    }
  }

  /** A peer that asks for states without end. */
  private static final class Greedy implements LinkHandler {
    ServerMessage.Welcome welcome;
    int chunks;
    boolean closed;

    @Override
    public void message(Link from, Object message) {
      welcome = message instanceof ServerMessage.Welcome w ? w : welcome;
      closed |= message instanceof ServerMessage.Goodbye;
      chunks += message instanceof ServerMessage.PoolChunk ? 1 : 0;
    }

    @Override
    public void datagram(Link from, byte[] bytes, int length) {}

    @Override
    public void closed(Link from, String reason) {
      closed = true;
    }
  }

  @Test
  void whoAsksForStatesWithoutEndGetsOneASecondAndWhoAsksBeyondIsExpelled() throws Exception {
    try (Stepper stepper = sluice()) {
      stepper.expectExpulsions();
      Greedy greedy = new Greedy();
      Link link = stepper.transport().connect("localhost", 0, 0);
      link.send(new ClientMessage.Hello(Protocol.VERSION, Protocol.physicsDigest(), "evil", 0));
      for (int i = 0; i < 60; i++) {
        stepper.step();
        link.poll(greedy, 1_000);
      }
      long digest = greedy.welcome.declarationsDigest();
      link.send(new ClientMessage.Ready(greedy.welcome.epoch(), digest));
      for (int i = 0; i < 120; i++) {
        stepper.step();
        link.send(new ClientMessage.PoolRequest(0));
        link.send(new ClientMessage.PoolRequest(4096));
        link.poll(greedy, 1_000);
      }
      assertTrue(greedy.chunks >= 2 && greedy.chunks <= 6, "chunks=" + greedy.chunks);
      assertTrue(!greedy.closed);
      link.send(new ClientMessage.PoolRequest(260_000));
      for (int i = 0; i < 60; i++) {
        stepper.step();
        link.poll(greedy, 1_000);
      }
      assertTrue(greedy.closed);
    }
  }
}
