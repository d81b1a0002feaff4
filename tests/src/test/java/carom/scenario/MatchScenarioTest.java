package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.link.ConnectionPhase;
import carom.net.transport.Impairment;
import carom.server.config.RoomConfig;
import carom.server.config.ServerConfig;
import carom.server.match.MatchLibrary;
import carom.server.metrics.Counter;
import carom.sim.NextMatch;
import carom.testkit.Scripts;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** Goal: matches follow each other in a running room, and players notice no new link. */
class MatchScenarioTest {
  private static final Impairment BAD = Impairment.NONE.withLatency(75, 0).withLoss(2);

  @Test
  void fourPlayersGoOnInAnotherLevelAndBackOverABadNetwork() {
    try (Stepper stepper = Stepper.of("arena")) {
      for (int i = 0; i < 4; i++) {
        stepper.join("p" + i, BAD.withSeed(i), Scripts.wander(i));
      }
      stepper.run(3);
      for (String level : new String[] {"commons", "arena"}) {
        long compared = stepper.compared();
        stepper.room().simulation().playNext(NextMatch.level(level));
        stepper.runUntil(
            "all play " + level,
            () ->
                stepper.clients().stream()
                    .allMatch(
                        client ->
                            client.view().phase() == ConnectionPhase.PLAYING
                                && client.view().own() != null
                                && client
                                    .view()
                                    .level()
                                    .name()
                                    .equals(stepper.room().match().level().level().name())),
            5);
        stepper.run(1);
        assertTrue(stepper.compared() > compared + 200, stepper.describe());
      }
      assertEquals(2, stepper.count(Counter.MATCHES));
      assertEquals(4, stepper.count(Counter.JOINS), "no link was opened anew");
      for (SimulatedClient client : stepper.clients()) {
        assertEquals(0, client.stats().reconnects(), client::toString);
        assertEquals(4, client.view().players().size(), client::toString);
      }
    }
  }

  @Test
  void aRoomGoesRoundThreeLevelsOfTwoGames() {
    RoomConfig room =
        new RoomConfig("cup", "", List.of("arena", "platformer", "commons"), 8, 1, Map.of());
    try (Stepper stepper = Stepper.ofRooms(ServerConfig.defaults(), MatchLibrary.INSTALLED, room)) {
      stepper.join("Ann", BAD, Scripts.wander(1));
      SimulatedClient client = stepper.clients().get(0);
      for (String level : List.of("Windmill Gap", "Commons", "Corner Pocket", "Windmill Gap")) {
        stepper.room().simulation().matchOver();
        stepper.runUntil(
            "plays " + level,
            () ->
                client.view().phase() == ConnectionPhase.PLAYING
                    && client.view().own() != null
                    && client.view().level().name().equals(level),
            5);
        long compared = stepper.compared();
        stepper.run(1);
        assertTrue(stepper.compared() > compared + 20, stepper.describe());
      }
      assertEquals("platformer", client.view().game());
      assertEquals(0, client.stats().reconnects());
    }
  }

  @Test
  void aMatchThatCanNotBePlayedChangesNothing() {
    try (Stepper stepper = Stepper.of("arena")) {
      stepper.join("Ann", Impairment.NONE, Scripts.wander(1));
      int tick = stepper.room().tick();
      stepper.room().simulation().playNext(NextMatch.level("nowhere"));
      stepper.run(1);
      assertEquals(0, stepper.count(Counter.MATCHES));
      assertTrue(stepper.room().tick() > tick + 50, stepper.describe());
      assertEquals(ConnectionPhase.PLAYING, stepper.clients().get(0).view().phase());
    }
  }
}
