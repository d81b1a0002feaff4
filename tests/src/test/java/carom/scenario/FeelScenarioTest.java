package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.ClientConfig;
import carom.client.InputSource;
import carom.client.PredictionMode;
import carom.client.bots.Bot;
import carom.client.stats.NetStats;
import carom.fixtures.Levels;
import carom.fixtures.Slice;
import carom.net.transport.Impairment;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.sim.entity.HostEntity;
import carom.testkit.Scripts;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Goal: predictions are right in every bit where the client knows all inputs. Method: the real
 * server and clients in virtual time on bad networks; what the clients count is asserted.
 */
class FeelScenarioTest {
  private static final Impairment FAR = Impairment.NONE.withLatency(75, 0).withLoss(2);

  static Stream<Arguments> lines() {
    return Stream.of(
        Arguments.of(PredictionMode.ISLAND, Stepper.SEED),
        Arguments.of(PredictionMode.ALL, Stepper.SEED),
        Arguments.of(PredictionMode.ALL, 2), // loses both copies of an update
        Arguments.of(PredictionMode.ALL, 3),
        Arguments.of(PredictionMode.ALL, 200),
        Arguments.of(PredictionMode.ALL, 10));
  }

  @ParameterizedTest
  @MethodSource("lines")
  void whoPushesCratesPredictsThemInEveryBit(PredictionMode mode, long seed) {
    // Goal: 99 % of the awake bodies at 150 ms and 2 % loss, without foreign contact, and whatever
    // the game does told before it shows as a difference.
    // Method: a bot alone among the platformer's crates for 15 s, once it has settled.
    try (Stepper stepper = Stepper.of("platformer")) {
      SimulatedClient client =
          stepper.add(
              ClientConfig.of("p").with(ClientConfig.PREDICTION, mode),
              FAR.withSeed(seed),
              new Bot(0));
      stepper.run(6);
      final long missing = stepper.count(Counter.INPUTS_MISSING);
      final long disagreements = stepper.count(Counter.NEAR_DISAGREEMENTS);
      long awake = client.stats().awakeBodies();
      long exact = client.stats().exactBodies();
      double seconds = Slice.of(15, 30);
      stepper.run(seconds);
      awake = client.stats().awakeBodies() - awake;
      exact = client.stats().exactBodies() - exact;
      String about = "seed=" + seed + " " + exact + " of " + awake + " " + stepper.describe();
      assertTrue(awake > 33 * seconds, about);
      assertTrue(exact >= 0.99 * awake, about);
      if (missing == stepper.count(Counter.INPUTS_MISSING)) {
        assertEquals(disagreements, stepper.count(Counter.NEAR_DISAGREEMENTS), about);
      }
    }
  }

  @Test
  void whoHitsAPileFromOutsideIsToldWithAllItMoved() {
    // Goal: a body that comes near by hitting the far end of what is near has moved all of it in
    // the same tick; the update tells them all, and nothing differs after it.
    // Method: a player beside a long row of crates; a crate that isn't listed is shot at its end.
    Impairment line = Impairment.NONE.withLatency(50, 0);
    try (Stepper stepper =
        Stepper.of(Levels.platformerWithRowOfCrates(), ServerConfig.defaults())) {
      SimulatedClient client = stepper.join("p", line, InputSource.IDLE);
      stepper.run(2);
      assertEquals(0, client.stats().disagreements(), stepper.describe());
      HostEntity last = stepper.room().simulation().entity(11);
      HostEntity shot = stepper.room().simulation().entity(12);
      float before = last.body().x();
      shot.body().setVelocity(-14, 0);
      stepper.run(2);
      String about = "x=" + last.body().x() + " before=" + before + " " + stepper.describe();
      assertTrue(last.body().x() < before - 0.005f, about);
      assertEquals(0, client.stats().disagreements(), about);
      assertEquals(0, stepper.count(Counter.NEAR_DISAGREEMENTS), about);
    }
  }

  @Test
  void aloneInAStaticLevelNothingIsCorrectedOnAnyNetwork() {
    // Goal: 0 corrections and equal hashes as long as inputs arrive at all.
    // Method: a wanderer in an empty arena; networks that lose no input for good.
    for (Impairment bad :
        new Impairment[] {
          Impairment.NONE,
          Impairment.NONE.withLatency(20, 5),
          Impairment.NONE.withLatency(150, 0),
          FAR.withLatency(100, 30)
        }) {
      try (Stepper stepper = Stepper.of(Levels.emptyArena(), ServerConfig.defaults())) {
        SimulatedClient client =
            stepper.join("a", bad.withSeed(Stepper.SEED), Scripts.wander(Stepper.SEED));
        stepper.run(6);
        NetStats stats = client.stats();
        long corrections = stats.corrections();
        long wrong = stats.awakeBodies() - stats.exactBodies();
        long missing = stepper.count(Counter.INPUTS_MISSING);
        final long disagreements = stepper.count(Counter.NEAR_DISAGREEMENTS);
        stepper.run(15);
        missing = stepper.count(Counter.INPUTS_MISSING) - missing;
        String about = bad + " missing=" + missing + " " + stepper.describe();
        assertTrue(missing <= 2, about);
        if (missing == 0) {
          assertEquals(corrections, stats.corrections(), about);
          assertEquals(wrong, stats.awakeBodies() - stats.exactBodies(), about);
          assertEquals(disagreements, stepper.count(Counter.NEAR_DISAGREEMENTS), about);
        }
      }
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"arena", "cars", "platformer", "playground", "rockets", "shooter"})
  void rollingBackInEachTickChangesNothing(String game) {
    // Goal: a restored state goes on as before. Method: synctest, 8 ticks in each tick; rockets
    // that these ticks spawn and despawn are other bodies after each of them.
    try (Stepper stepper = Stepper.of(game)) {
      SimulatedClient client =
          stepper.add(
              ClientConfig.of("p").with(ClientConfig.SYNC_TEST, true),
              FAR.withSeed(Stepper.SEED),
              new Bot(1));
      stepper.add("q", Impairment.NONE, new Bot(2));
      double seconds = Slice.of(7, 12);
      stepper.run(seconds);
      assertTrue(client.stats().compared() > 33 * seconds, stepper.describe());
      assertEquals(0, client.stats().syncErrors(), stepper.describe());
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"arena", "rockets"})
  void newsThatWaitsToBeReconciledIsNoFaultOfRollback(String game) {
    // Goal: rulings and spawns that came after a tick had been computed accuse nobody.
    // Method: without delay they come just before a step and are reconciled after it.
    try (Stepper stepper = Stepper.of(game)) {
      SimulatedClient client =
          stepper.add(
              ClientConfig.of("p").with(ClientConfig.SYNC_TEST, true), Impairment.NONE, new Bot(0));
      stepper.run(30);
      assertTrue(client.stats().compared() > 400, stepper.describe());
      assertEquals(0, client.stats().syncErrors(), stepper.describe());
    }
  }

  @Test
  void amongManyPlayersMuchIsPredicted() {
    // Goal: others' moves are the only surprises, from the kick-off on; what the game does to a
    // body is told before it shows as a difference. Method: twelve bots in the arena at 100 ms.
    try (Stepper stepper = Stepper.of("arena")) {
      for (int i = 0; i < 12; i++) {
        stepper.add("b" + i, Impairment.NONE.withLatency(50, 0), new Bot(i));
      }
      stepper.run(12);
      double perfect = 0;
      for (SimulatedClient client : stepper.clients()) {
        perfect += client.stats().perfectRate() / 12;
      }
      String about = "perfect=" + perfect + " " + stepper.describe();
      assertTrue(perfect > 0.97, about);
      long disagreements = stepper.count(Counter.NEAR_DISAGREEMENTS);
      assertTrue(disagreements <= 3 * 12, "disagreements=" + disagreements + " " + about);
    }
  }
}
