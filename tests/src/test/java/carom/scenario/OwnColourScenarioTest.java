package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;

import carom.client.InputSource;
import carom.client.replay.ReplayClient;
import carom.fixtures.DuelGame;
import carom.net.transport.Impairment;
import carom.server.config.ServerConfig;
import carom.sim.message.PlayerColour;
import carom.sim.outbox.NextMatch;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: a player's body has the colour that the player chose, for all who see it, if the game lets
 * players choose. Method: clients in virtual time, with latency and loss; their rosters and that of
 * a replay.
 */
class OwnColourScenarioTest {
  private static final Impairment BAD =
      Impairment.NONE.withLatency(75, 5).withLoss(2).withSeed(Stepper.SEED);

  @TempDir Path folder;

  private static PlayerColour colour(SimulatedClient of, SimulatedClient at) {
    return PlayerColour.of(at.view().participant(of.view().playerId()).colour());
  }

  @Test
  void allSeeTheColourThatAPlayerChoseAlsoInTheNextMatchAndAReplay() throws Exception {
    Path file = folder.resolve("colours.carom");
    try (Stepper stepper = Stepper.of("platformer")) {
      stepper.server().record(file);
      SimulatedClient ann = stepper.join("Ann", BAD, InputSource.IDLE);
      ann.game().colour(PlayerColour.VIOLET);
      SimulatedClient bob = stepper.join("Bob", BAD, InputSource.IDLE);
      stepper.run(3);
      assertEquals(PlayerColour.VIOLET, colour(ann, ann));
      assertEquals(PlayerColour.VIOLET, colour(ann, bob));
      assertEquals(PlayerColour.OF_THE_GAME, colour(bob, ann));
      ann.game().colour(PlayerColour.GREEN);
      stepper.run(2);
      assertEquals(PlayerColour.GREEN, colour(ann, bob));
      stepper.room().simulation().playNext(NextMatch.level("platformer"));
      stepper.run(5);
      assertEquals(2, bob.view().matchNumber());
      assertEquals(PlayerColour.GREEN, colour(ann, bob));
      ann.game().colour(PlayerColour.OF_THE_GAME);
      stepper.run(2);
      assertEquals(PlayerColour.OF_THE_GAME, colour(ann, bob));
    }
    try (ReplayClient replay = new ReplayClient(file)) {
      replay.seek(2 * 60);
      while (replay.seeking()) {
        replay.update(0);
      }
      assertEquals(PlayerColour.VIOLET.number(), replay.view().participant(0).colour());
    }
  }

  @Test
  void aGameWhoseColoursHaveAMeaningKeepsThem() {
    try (Stepper stepper = Stepper.of(DuelGame.level(), ServerConfig.defaults())) {
      SimulatedClient ann = stepper.join("Ann", BAD, InputSource.IDLE);
      ann.game().colour(PlayerColour.VIOLET);
      stepper.run(3);
      assertEquals(PlayerColour.OF_THE_GAME, colour(ann, ann));
    }
  }
}
