package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.link.ConnectionPhase;
import carom.game.arena.ArenaGame;
import carom.net.transport.Impairment;
import carom.server.config.RoomConfig;
import carom.server.config.ServerConfig;
import carom.server.match.MatchLibrary;
import carom.server.metrics.Counter;
import carom.server.session.LoadedLevel;
import carom.sim.Game;
import carom.sim.MatchClock;
import carom.sim.MatchPhase;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.level.LevelException;
import carom.sim.outbox.NextMatch;
import carom.suite.Needs;
import carom.testkit.Scripts;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.lang.reflect.Proxy;
import java.util.ArrayList;
import java.util.Arrays;
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

  @Needs("sockets")
  @Test
  void aRoomGoesRoundItsLevelsOverRealSocketsToo() {
    // Goal: the next match reaches players over KryoNet. Method: two players, three levels of two
    // games, each ended by its rules; positions are compared with the server's.
    RoomConfig room =
        new RoomConfig("cup", "", List.of("arena", "platformer", "commons"), 8, 1, Map.of());
    try (Stepper stepper =
        Stepper.ofRoomsOverSockets(ServerConfig.defaults(), MatchLibrary.INSTALLED, room)) {
      SimulatedClient ann = stepper.join("Ann", BAD, Scripts.wander(1));
      SimulatedClient bob = stepper.join("Bob", BAD.withSeed(2), Scripts.wander(2));
      for (String level : List.of("Windmill Gap", "Commons", "Corner Pocket")) {
        final long compared = stepper.compared();
        stepper.room().simulation().matchOver();
        for (SimulatedClient client : List.of(ann, bob)) {
          stepper.runUntil(
              "plays " + level,
              () ->
                  client.view().phase() == ConnectionPhase.PLAYING
                      && client.view().own() != null
                      && client.view().level().name().equals(level),
              10);
        }
        stepper.runUntil("both are shown it", () -> stepper.compared() > compared + 200, 10);
      }
      assertEquals(3, stepper.count(Counter.MATCHES));
      assertEquals(0, ann.stats().reconnects() + bob.stats().reconnects());
      stepper.runUntil("the roster is told", () -> ann.view().players().size() == 2, 10);
    }
  }

  @Test
  void aMatchThatIsOverIsFollowedByTheNextLevelByItself() {
    RoomConfig room = new RoomConfig("cup", "", List.of("arena", "commons"), 8, 1, Map.of());
    try (Stepper stepper = Stepper.ofRooms(ServerConfig.defaults(), MatchLibrary.INSTALLED, room)) {
      SimulatedClient ann = stepper.join("Ann", BAD, Scripts.wander(1));
      SimulatedClient bob = stepper.join("Bob", BAD, Scripts.wander(2));
      assertEquals(MatchPhase.PLAYING, MatchClock.phase(ann.view().match()));
      SimulationHost match = stepper.room().simulation();
      match.game().clock().finish(match);
      stepper.runUntil(
          "sees the result", () -> MatchClock.phase(ann.view().match()) == MatchPhase.OVER, 2);
      stepper.runUntil(
          "is told the result",
          () ->
              bob.view().notices().stream()
                  .anyMatch(notice -> notice.text().equals("A draw, 0 : 0!")),
          2);
      int[] sooner = {0};
      stepper.runUntil(
          "plays the next level",
          () -> {
            boolean playing = ann.view().phase() == ConnectionPhase.PLAYING;
            sooner[0] += playing && ann.view().level().name().equals("Corner Pocket") ? 1 : 0;
            return playing && ann.view().level().name().equals("Commons");
          },
          10);
      assertTrue(sooner[0] > 4 * 60, "the result shows for seconds");
      assertEquals(1, stepper.count(Counter.MATCHES));
      assertEquals(MatchPhase.PLAYING, MatchClock.phase(stepper.room().simulation()));
    }
  }

  @Test
  void afterFiveGoalsANewMatchOfTheArenaBeginsFromNothing() {
    try (Stepper stepper = Stepper.of("arena")) {
      SimulatedClient ann = stepper.join("Ann", BAD, Scripts.hold(0, 0));
      stepper.join("Bob", BAD, Scripts.hold(0, 0)); // alone, goals are practice
      SimulationHost match = stepper.room().simulation();
      for (int goal = 0; goal < ArenaGame.GOALS_TO_WIN; goal++) {
        assertEquals(goal, named(match, "lamp.Red").size());
        stepper.run(2.2);
        named(match, "ball").get(0).teleport(18.8f, 0, 0);
        stepper.run(0.1);
      }
      assertEquals(ArenaGame.GOALS_TO_WIN, named(match, "lamp.Red").size());
      stepper.runUntil("a new match", () -> stepper.room().simulation() != match, 8);
      SimulationHost next = stepper.room().simulation();
      stepper.runUntil("Ann has a body", () -> stepper.body(ann) != null, 3);
      stepper.runUntil("the kickoff", () -> !named(next, "ball").isEmpty(), 3);
      assertEquals(0, named(next, "lamp.Red").size());
      assertEquals(0, stepper.player(ann).score());
    }
  }

  private static List<HostEntity> named(SimulationHost s, String archetype) {
    List<HostEntity> found = new ArrayList<>();
    for (int id = 0; id < s.entityCapacity(); id++) {
      HostEntity e = s.entity(id);
      if (e != null && e.archetype().name().equals(archetype)) {
        found.add(e);
      }
    }
    return found;
  }

  @Test
  void anotherGameBeginsWithScoresThatAreKeptAndTeamsThatAreNot() {
    try (Stepper stepper = Stepper.of("arena")) {
      SimulatedClient ann = stepper.join("Ann", BAD, Scripts.wander(1));
      SimulationHost arena = stepper.room().simulation();
      arena.player(0).score(7);
      assertEquals(1, arena.player(0).team());
      int[] kept = arena.player(0).fieldValues().lasting();
      Arrays.fill(kept, 5);
      arena.player(0).fieldValues().begin(kept);
      arena.playNext(NextMatch.game("platformer").keepingScores());
      stepper.runUntil(
          "plays the other game",
          () ->
              ann.view().phase() == ConnectionPhase.PLAYING
                  && ann.view().game().equals("platformer")
                  && ann.view().own() != null,
          5);
      assertEquals(7, stepper.room().simulation().player(0).score());
      assertEquals(0, stepper.room().simulation().player(0).team());
      int[] begun = stepper.room().simulation().player(0).fieldValues().lasting();
      assertArrayEquals(new int[begun.length], begun, "what lasts of another game");
      stepper.runUntil(
          "is told",
          () -> ann.view().players().size() == 1 && ann.view().players().get(0).score() == 7,
          2);
    }
  }

  @Test
  void aLinkThatIsLostDuringTheChangeIsResumedInTheNextMatch() {
    try (Stepper stepper = Stepper.of("arena")) {
      SimulatedClient ann = stepper.join("Ann", BAD, Scripts.wander(1));
      SimulatedClient bob = stepper.join("Bob", BAD, Scripts.wander(2));
      stepper.run(1);
      stepper.room().simulation().playNext(NextMatch.level("commons"));
      stepper.runUntil("the match changes", () -> stepper.count(Counter.MATCHES) == 1, 2);
      ann.cut(); // it has not even heard the Welcome
      stepper.runUntil("Bob loads", () -> bob.view().phase() == ConnectionPhase.LOADING, 2);
      bob.cut(); // in the middle of the level
      for (SimulatedClient client : stepper.clients()) {
        stepper.runUntil(
            client.name() + " is back in the next match",
            () ->
                client.view().phase() == ConnectionPhase.PLAYING
                    && client.view().level().name().equals("Commons")
                    && client.view().own() != null,
            10);
      }
      long compared = stepper.compared();
      stepper.run(1);
      assertTrue(stepper.compared() > compared + 50, stepper.describe());
      assertEquals(2, stepper.room().simulation().playerCount());
    }
  }

  @Test
  void aSetUpThatThrowsLeavesTheRoomWithTheMatchItHasAndThePlayersAreTold() {
    MatchLibrary broken =
        new MatchLibrary() {
          @Override
          public Game game(String name) {
            Game game = INSTALLED.game(name);
            return name.equals("platformer") ? throwingInSetUp(game) : game;
          }

          @Override
          public LoadedLevel level(String name) throws LevelException {
            return INSTALLED.level(name);
          }
        };
    RoomConfig room = new RoomConfig("cup", "", List.of("arena", "platformer"), 8, 1, Map.of());
    try (Stepper stepper = Stepper.ofRooms(ServerConfig.defaults(), broken, room)) {
      SimulatedClient ann = stepper.join("Ann", Impairment.NONE, Scripts.wander(1));
      int tick = stepper.room().tick();
      stepper.room().simulation().matchOver();
      stepper.runUntil(
          "is told",
          () ->
              ann.view().notices().stream()
                  .anyMatch(notice -> notice.text().startsWith("The next match can't be played.")),
          2);
      stepper.run(1);
      assertTrue(stepper.room().tick() > tick + 50, stepper.describe());
      assertEquals(0, stepper.count(Counter.MATCHES));
      assertEquals("arena", ann.view().game());
      assertEquals(ConnectionPhase.PLAYING, ann.view().phase());
      String answer = stepper.room().operator().change("platformer", "");
      assertTrue(answer.contains("not changed: the set-up failed"), answer);
    }
  }

  private static Game throwingInSetUp(Game game) {
    return (Game)
        Proxy.newProxyInstance(
            Game.class.getClassLoader(),
            new Class<?>[] {Game.class},
            (self, method, arguments) -> {
              if (method.getName().equals("setUp")) {
                throw new IllegalStateException("on purpose");
              }
              return method.invoke(game, arguments);
            });
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
