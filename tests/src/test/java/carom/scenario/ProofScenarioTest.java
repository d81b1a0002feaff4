package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.InputSource;
import carom.fixtures.Levels;
import carom.net.transport.Impairment;
import carom.physics.Body;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.entity.Input;
import carom.sim.level.Level;
import carom.sim.near.Neighbourhood;
import carom.testkit.Condition;
import carom.testkit.Scripts;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Goal: the server never mistakes a bad network for a divergence, and it detects real divergences.
 * Method: the server's counters while clients play in virtual time.
 */
final class ProofScenarioTest {
  static Stream<Arguments> levelsAndConditions() {
    return Stream.of(Levels.emptyArena(), Levels.emptyPlatformer())
        .flatMap(
            level ->
                Stream.of(Condition.MIXED, Condition.BURSTS_30_PERCENT, Condition.BLACKOUT_1_S)
                    .map(c -> Arguments.of(level, c)));
  }

  @ParameterizedTest
  @MethodSource("levelsAndConditions")
  void aloneEverythingIsExplained(Level level, Condition condition) {
    try (Stepper stepper = Stepper.of(level, ServerConfig.defaults())) {
      SimulatedClient client =
          stepper.join("p", condition.impairment(Stepper.SEED), Scripts.wander(Stepper.SEED));
      stepper.run(5);
      if (condition.hasBlackout()) {
        stepper.blackout(client, 1);
      }
      stepper.run(8);
      assertEquals(0, stepper.count(Counter.DIVERGENCES_UNEXPLAINED), stepper::describe);
    }
  }

  @Test
  void aBodyThatObeysOtherLawsIsNoticedOnceWithBothStates() {
    try (Stepper stepper = Stepper.of(Levels.emptyArena(), ServerConfig.defaults())) {
      SimulatedClient client =
          stepper.join("p", Impairment.NONE.withLatency(40, 5), InputSource.IDLE);
      stepper.run(3);
      assertEquals(0, stepper.count(Counter.DIVERGENCES_REPORTED));
      // As if the server computed something else: it changes the last bit of the velocity.
      float vx = stepper.body(client).body().velocityX();
      stepper.body(client).body().setVelocity(Math.nextUp(vx + 0.5f), 0);
      assertFoundOutOnce(stepper);
    }
  }

  @Test
  void aClientThatComputesWronglyIsFoundOut() {
    // Goal: the fault is the client's this time. Method: one bit of its predicted body is flipped
    // behind its back, once.
    try (Stepper stepper = Stepper.of(Levels.emptyArena(), ServerConfig.defaults())) {
      SimulatedClient client =
          stepper.join("p", Impairment.NONE.withLatency(40, 5), Scripts.wander(Stepper.SEED));
      stepper.run(3);
      assertEquals(0, stepper.count(Counter.DIVERGENCES_REPORTED));
      SimulationHost predicted = client.view().predictedWorld();
      Body<HostEntity> body = predicted.player(client.view().playerId()).entity().body();
      body.setVelocity(Math.nextUp(body.velocityX() + 0.25f), body.velocityY());
      assertFoundOutOnce(stepper);
    }
  }

  private static void assertFoundOutOnce(Stepper stepper) {
    stepper.run(1);
    assertEquals(1, stepper.count(Counter.DIVERGENCES_REPORTED));
    assertEquals(1, stepper.count(Counter.DIVERGENCES_UNEXPLAINED));
    stepper.run(5);
    assertEquals(1, stepper.count(Counter.DIVERGENCES_REPORTED), "corrected, and in step again");
  }

  @Test
  void aClientThatComputesABodyNearWronglyIsFoundOut() {
    // Goal: told once, and nothing while all is right. Method: a player stands beside crates; the
    // velocity of one of them is changed behind the client's back.
    try (Stepper stepper = Stepper.of(Levels.platformerWithCrates(), ServerConfig.defaults())) {
      SimulatedClient client =
          stepper.join("p", Impairment.NONE.withLatency(40, 5), InputSource.IDLE);
      SimulationHost predicted = client.view().predictedWorld();
      Body<HostEntity> crate = crate(stepper.room().simulation());
      Body<HostEntity> own = stepper.body(client).body();
      own.setPose(crate.x() - 2, own.y(), 1, 0);
      stepper.run(6);
      assertEquals(0, stepper.count(Counter.DIVERGENCES_UNEXPLAINED));
      long before = stepper.count(Counter.DIVERGENCES_REPORTED);
      Body<HostEntity> same = crate(predicted);
      same.setVelocity(same.velocityX() + 0.25f, same.velocityY());
      stepper.run(1);
      assertEquals(before + 1, stepper.count(Counter.DIVERGENCES_REPORTED), stepper::describe);
      assertEquals(1, stepper.count(Counter.DIVERGENCES_UNEXPLAINED), stepper::describe);
      stepper.run(5);
      assertEquals(before + 1, stepper.count(Counter.DIVERGENCES_REPORTED), stepper::describe);
    }
  }

  /** The first that nobody owns. */
  private static Body<HostEntity> crate(SimulationHost simulation) {
    for (int id = 0; id < simulation.entityCapacity(); id++) {
      HostEntity e = simulation.entity(id);
      if (e != null
          && e.owner() == null
          && Neighbourhood.affectsOthers(simulation, e.archetype())) {
        return e.body();
      }
    }
    throw new AssertionError("no crate is near");
  }

  @ParameterizedTest
  @MethodSource("gamesAndConditions")
  void amongOthersEverythingIsExplained(String game, Condition condition) {
    try (Stepper stepper = Stepper.of(game)) {
      for (int i = 0; i < 6; i++) {
        stepper.add("b" + i, condition.impairment(Stepper.SEED + i), Scripts.wander(i));
      }
      stepper.run(8);
      assertEquals(0, stepper.count(Counter.DIVERGENCES_UNEXPLAINED), stepper::describe);
    }
  }

  static Stream<Arguments> gamesAndConditions() {
    return Stream.of("arena", "platformer")
        .flatMap(
            game ->
                Stream.of(Condition.MIXED, Condition.BURSTS_30_PERCENT)
                    .map(c -> Arguments.of(game, c)));
  }

  @Test
  void whatTheGamesRulesDoToABodyIsExplained() {
    // Goal: a jolt with nobody near is no fault. Method: two discs, far apart in an empty arena;
    // one
    // jolts the other along the line of sight.
    try (Stepper stepper = Stepper.of(Levels.emptyArena(), ServerConfig.defaults())) {
      SimulatedClient target =
          stepper.join("target", Impairment.NONE.withLatency(40, 5), InputSource.IDLE);
      SimulatedClient jolter = stepper.join("jolter", Impairment.NONE, InputSource.IDLE);
      Body<HostEntity> there = stepper.body(target).body();
      Body<HostEntity> here = stepper.body(jolter).body();
      there.setPose(here.x() - 9, here.y(), 1, 0);
      stepper.run(4);
      long before = stepper.count(Counter.DIVERGENCES_UNEXPLAINED);
      jolter.play((view, tick, out) -> out.aim((float) Math.PI).hold(Input.SECOND, true));
      stepper.runUntil("the jolt hits", () -> there.velocityX() < -1, 1);
      stepper.run(2);
      assertTrue(stepper.count(Counter.DIVERGENCES_REPORTED) > 0, stepper::describe);
      assertEquals(before, stepper.count(Counter.DIVERGENCES_UNEXPLAINED), stepper::describe);
    }
  }
}
