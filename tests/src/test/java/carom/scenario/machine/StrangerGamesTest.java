package carom.scenario.machine;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.InputSource;
import carom.fixtures.AnchorGaps;
import carom.game.Games;
import carom.net.transport.Impairment;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.sim.Game;
import carom.sim.entity.Input;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.nio.charset.StandardCharsets;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;

/**
 * Goal: games with joints that a stranger writes from GAMES.md and LEVELS.md, in about 150 lines
 * each, are predicted exactly. Method: each in virtual time at 150 ms and 2 % loss.
 */
final class StrangerGamesTest {
  private static final Impairment FAR =
      Impairment.NONE.withLatency(75, 5).withLoss(2).withSeed(Stepper.SEED);

  private static Stepper play(Supplier<Game> game, String level) {
    Games.add(game);
    try {
      byte[] file = level.getBytes(StandardCharsets.UTF_8);
      return Stepper.of(Level.parse("game.json", file), ServerConfig.defaults());
    } catch (LevelException e) {
      throw new IllegalStateException(e);
    }
  }

  /** Requires the figures of a client who has met nobody. */
  private static void assertPredicted(Stepper stepper, SimulatedClient client, double seconds) {
    stepper.run(3);
    final long awake = client.stats().awakeBodies();
    final long exact = client.stats().exactBodies();
    final long corrections = client.stats().corrections();
    AnchorGaps gaps = new AnchorGaps(stepper.room().simulation(), client);
    gaps.run(stepper, seconds);
    long bodies = client.stats().awakeBodies() - awake;
    double right = 100.0 * (client.stats().exactBodies() - exact) / bodies;
    long corrected = client.stats().corrections() - corrections;
    String about =
        "right="
            + right
            + " % of "
            + bodies
            + " corrections="
            + corrected
            + " "
            + gaps
            + " "
            + stepper.describe();
    assertTrue(bodies > 1_000, about);
    assertTrue(right >= 99, about);
    assertEquals(0, corrected, about);
    assertTrue(gaps.worst() < 0.02, about);
    assertEquals(0, stepper.count(Counter.DIVERGENCES_UNEXPLAINED), about);
  }

  @Test
  void carsRaceOverABridgeThatBreaks() {
    try (Stepper stepper = play(CarRace::new, CarRace.LEVEL)) {
      InputSource racer = (view, tick, in) -> in.move(1, 0).hold(Input.ACTION, tick % 400 < 60);
      SimulatedClient ann = stepper.join("ann", FAR, racer);
      assertPredicted(stepper, ann, 9);
    }
  }

  @Test
  void ragdollsBrawl() {
    try (Stepper stepper = play(RagdollBrawl::new, RagdollBrawl.LEVEL)) {
      InputSource fighter =
          (view, tick, in) ->
              in.move(tick / 90 % 2 == 0 ? 1 : -1, tick / 50 % 3 == 0 ? 0.5f : 0)
                  .hold(Input.ACTION, tick % 60 < 5);
      SimulatedClient ann = stepper.join("ann", FAR, fighter);
      assertPredicted(stepper, ann, 15);
    }
  }

  @Test
  void aTowTruckMakesAndDestroysJointsAtRunTime() {
    try (Stepper stepper = play(TowTruck::new, TowTruck.LEVEL)) {
      InputSource driver =
          (view, tick, in) ->
              in.move(tick / 200 % 2 == 0 ? 0.6f : -0.6f, tick / 70 % 2 == 0 ? 1 : -1)
                  .hold(Input.ACTION, tick % 240 < 3);
      SimulatedClient ann = stepper.join("ann", FAR, driver);
      assertPredicted(stepper, ann, 20);
    }
  }
}
