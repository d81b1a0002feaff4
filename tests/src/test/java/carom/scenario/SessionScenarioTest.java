package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.ClientConfig;
import carom.client.InputSource;
import carom.client.bots.Bot;
import carom.client.link.ConnectionPhase;
import carom.fixtures.Levels;
import carom.net.transport.Impairment;
import carom.net.transport.Link;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.sim.entity.HostEntity;
import carom.testkit.Condition;
import carom.testkit.Scripts;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Goal: players join, leave, lose the connection and return, and the others see them correctly.
 * Method: real clients in virtual time; the server's simulation is the truth.
 */
class SessionScenarioTest {
  private static final Impairment FAR = Impairment.NONE.withLatency(30, 0);

  /** Drawn bodies that a player owns. */
  private static int bodiesOf(SimulatedClient viewer, int playerId) {
    int bodies = 0;
    for (int i = 0; i < viewer.view().entityCount(); i++) {
      bodies += viewer.view().entity(i).ownerId() == playerId ? 1 : 0;
    }
    return bodies;
  }

  @ParameterizedTest
  @ValueSource(strings = {"arena", "platformer"})
  void whoJoinsGetsABodyThatEverybodySees(String game) {
    // Goal: one body per player, on all screens, and a roster with all names.
    // Method: three join one after the other.
    try (Stepper stepper = Stepper.of(game)) {
      List<SimulatedClient> clients = new ArrayList<>();
      for (String name : List.of("Ann", "Bob", "Zoë")) {
        clients.add(stepper.join(name, FAR, InputSource.IDLE));
      }
      stepper.run(1);
      for (SimulatedClient viewer : clients) {
        for (SimulatedClient shown : clients) {
          assertEquals(1, bodiesOf(viewer, shown.view().playerId()), viewer + " sees " + shown);
          assertEquals(shown.name(), viewer.view().playerName(shown.view().playerId()));
        }
        assertEquals(viewer.view().own().id(), stepper.body(viewer).id());
      }
    }
  }

  @ParameterizedTest
  @EnumSource(
      value = Condition.class,
      names = {"CLEAN", "LOSS_10_PERCENT", "LATENCY_300"})
  void whoLeavesDisappearsForTheOthers(Condition condition) {
    // Goal: no ghost stays on any screen. Method: one of three leaves; two seconds later it is
    // gone.
    try (Stepper stepper = Stepper.of("arena")) {
      List<SimulatedClient> clients = new ArrayList<>();
      for (int i = 0; i < 3; i++) {
        clients.add(stepper.join("p" + i, condition.impairment(Stepper.SEED), new Bot(i)));
      }
      SimulatedClient leaver = clients.remove(1);
      int id = leaver.view().playerId();
      leaver.leave();
      stepper.run(2);
      assertEquals(ConnectionPhase.ENDED, leaver.view().phase());
      assertNull(stepper.room().simulation().player(id));
      assertEquals(1, stepper.count(Counter.LEAVES));
      for (SimulatedClient viewer : clients) {
        assertEquals(0, bodiesOf(viewer, id), viewer::toString);
        assertEquals(2, viewer.view().players().size(), viewer::toString);
      }
    }
  }

  @Test
  void aSecondPlayerOfTheSameNameGetsANumber() {
    // Goal: names tell players apart. Method: three of a name, one leaves, one comes.
    try (Stepper stepper = Stepper.of("arena")) {
      SimulatedClient first = stepper.join("Ann", FAR, InputSource.IDLE);
      SimulatedClient second = stepper.join("Ann", FAR, InputSource.IDLE);
      SimulatedClient third = stepper.join("ann", FAR, InputSource.IDLE);
      stepper.run(0.5);
      assertEquals("Ann", nameOf(first, first));
      assertEquals("Ann (2)", nameOf(first, second));
      assertEquals("ann (3)", nameOf(first, third));
      second.leave();
      stepper.run(0.5);
      SimulatedClient fourth = stepper.join("ANN", FAR, InputSource.IDLE);
      stepper.run(0.5);
      assertEquals("ANN (2)", nameOf(first, fourth));
    }
  }

  private static String nameOf(SimulatedClient viewer, SimulatedClient shown) {
    return viewer.view().playerName(shown.view().playerId());
  }

  @ParameterizedTest
  @ValueSource(strings = {"arena", "platformer"})
  void whoseLineBreaksComesBackToTheSameBody(String game) {
    // Goal: a broken line costs seconds, not the body or the score, and the others see no gap.
    // Method: cut the line in the middle of play; the client comes back by itself.
    try (Stepper stepper = Stepper.of(game)) {
      SimulatedClient other = stepper.join("other", FAR, Scripts.wander(1));
      SimulatedClient client = stepper.join("client", FAR, InputSource.IDLE);
      stepper.run(2);
      final int id = client.view().playerId();
      final HostEntity body = stepper.body(client);
      stepper.player(client).score(7);
      client.cut();
      stepper.run(0.1);
      assertEquals(ConnectionPhase.RECONNECTING, client.view().phase());
      assertTrue(client.view().message().contains("Reconnecting"), client.view().message());
      assertEquals(1, stepper.count(Counter.PLAYERS_IN_GRACE));
      stepper.awaitPlaying(client);
      stepper.run(0.5);
      assertEquals(id, client.view().playerId());
      assertSame(body, stepper.body(client));
      assertEquals(7, stepper.player(client).score());
      assertEquals(body.id(), client.view().own().id());
      assertEquals(2, other.view().players().size());
      assertEquals(1, client.stats().reconnects());
      assertEquals(1, stepper.count(Counter.RESUMES));
      assertEquals(0, stepper.count(Counter.PLAYERS_IN_GRACE));
    }
  }

  @Test
  void afterTheServerStoodStillForTenSecondsAllComeBackToTheirBodies() {
    // Goal: SIGSTOP, a suspended machine or a moved virtual one costs nobody a body. Method: eight
    // clients; nothing of the server runs for 10 s, in which they give their links up after 6 s.
    try (Stepper stepper = Stepper.of("arena")) {
      List<SimulatedClient> clients = stepper.join(8);
      stepper.run(2);
      List<HostEntity> bodies = clients.stream().map(stepper::body).toList();
      stepper.stallServer(10);
      stepper.run(3);
      for (int i = 0; i < clients.size(); i++) {
        assertEquals(ConnectionPhase.PLAYING, clients.get(i).view().phase(), stepper.describe());
        assertSame(bodies.get(i), stepper.body(clients.get(i)));
      }
      assertEquals(0, stepper.count(Counter.PLAYERS_IN_GRACE));
    }
  }

  @Test
  void fifteenSecondsOfSilenceCostTheLinkButNotTheBody() {
    try (Stepper stepper = Stepper.of("arena")) {
      SimulatedClient client = stepper.join("client", FAR, Scripts.wander(1));
      SimulatedClient other = stepper.join("other", FAR, Scripts.wander(2));
      stepper.run(2);
      HostEntity body = stepper.body(client);
      stepper.player(client).score(7);
      stepper.blackout(client, 15);
      stepper.run(15);
      assertEquals(ConnectionPhase.RECONNECTING, client.view().phase(), client::toString);
      stepper.run(5);
      assertTrue(client.stats().reconnects() > 0, client::toString);
      assertEquals(ConnectionPhase.PLAYING, client.view().phase(), client::toString);
      assertSame(body, stepper.body(client));
      assertEquals(7, stepper.player(client).score());
      assertEquals(0, other.stats().reconnects(), "nobody else notices");
      assertEquals(0, stepper.count(Counter.PLAYERS_IN_GRACE));
    }
  }

  @Test
  void aProcessThatStoodStillForTenSecondsComesBackToTheSameBody() {
    // Goal: a suspended laptop is a broken line. Method: nothing of the client runs for 10 s; the
    // server gives the link up after 6 s and keeps the body for 30.
    try (Stepper stepper = Stepper.of("arena")) {
      SimulatedClient client = stepper.join("client", FAR, InputSource.IDLE);
      final HostEntity body = stepper.body(client);
      client.freeze(true);
      stepper.run(10);
      assertEquals(1, stepper.count(Counter.PLAYERS_IN_GRACE));
      client.freeze(false);
      stepper.run(3);
      assertEquals(ConnectionPhase.PLAYING, client.view().phase(), client::toString);
      assertSame(body, stepper.body(client));
      assertEquals(1, stepper.count(Counter.RESUMES));
    }
  }

  @Test
  void aKilledPlayersBodyStaysForTheGracePeriodAndNotLonger() {
    // Goal: nobody holds a seat for ever. Method: the process dies; the others look before and
    // after the grace period of three seconds.
    ServerConfig config = ServerConfig.defaults().with(ServerConfig.GRACE, 3);
    try (Stepper stepper = Stepper.of(Levels.emptyArena(), config)) {
      SimulatedClient other = stepper.join("other", FAR, InputSource.IDLE);
      SimulatedClient victim = stepper.join("victim", FAR, InputSource.IDLE);
      int id = victim.view().playerId();
      victim.kill();
      stepper.run(2);
      assertEquals(1, bodiesOf(other, id));
      stepper.run(2);
      assertEquals(0, bodiesOf(other, id));
      assertEquals(1, other.view().players().size());
      SimulatedClient next = stepper.join("next", FAR, InputSource.IDLE);
      assertEquals(id, next.view().playerId(), "the seat is free again");
      assertEquals(0, other.stats().corrections());
    }
  }

  @Test
  void whoComesBackTooLateIsTreatedAsANewPlayer() {
    // Goal: after the grace period the way back still leads into the game, with another body.
    // Method: a client that stood still for longer than silence and grace together.
    ServerConfig config =
        ServerConfig.defaults()
            .with(ServerConfig.GRACE, 1)
            .with(ServerConfig.SILENCE_TIMEOUT_MS, 1_000);
    try (Stepper stepper = Stepper.of(Levels.emptyArena(), config)) {
      SimulatedClient client = stepper.join("client", FAR, InputSource.IDLE);
      final HostEntity body = stepper.body(client);
      client.freeze(true);
      stepper.run(4);
      assertEquals(0, stepper.count(Counter.PLAYERS));
      client.freeze(false);
      stepper.run(4);
      assertEquals(ConnectionPhase.PLAYING, client.view().phase(), client::toString);
      assertNotNull(client.view().own());
      assertFalse(body == stepper.body(client));
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"arena", "platformer"})
  void afterARestartOfTheServerEverybodyPlaysAgain(String game) {
    // Goal: an operator restarts the server, players need do nothing.
    // Method: stop, two seconds of nothing, a fresh server at the same address.
    try (Stepper stepper = Stepper.of(game)) {
      for (int i = 0; i < 4; i++) {
        stepper.join("p" + i, FAR, new Bot(i));
      }
      stepper.run(2);
      stepper.stopServer();
      stepper.run(2);
      for (SimulatedClient client : stepper.clients()) {
        assertEquals(ConnectionPhase.RECONNECTING, client.view().phase(), client::toString);
        assertFalse(client.view().message().isBlank());
        assertTrue(client.view().entityCount() > 10, "the last picture stays");
      }
      stepper.startServer();
      stepper.clients().forEach(stepper::awaitPlaying);
      long before = stepper.compared();
      stepper.run(2);
      assertTrue(stepper.compared() > before + 1_000, stepper.describe());
      assertEquals(4, stepper.count(Counter.PLAYERS));
      for (SimulatedClient client : stepper.clients()) {
        assertEquals(1, client.stats().reconnects(), client::toString);
        assertEquals(4, client.view().players().size(), client::toString);
      }
    }
  }

  @Test
  void whoDoesNotWantToComeBackEndsWithAClearMessage() {
    // Goal: no client ends without a word. Method: no reconnecting, and the server stops.
    try (Stepper stepper = Stepper.of("arena")) {
      ClientConfig settings =
          ClientConfig.of("once").withServer("localhost", 0, 0).with(ClientConfig.RECONNECT, false);
      SimulatedClient client = stepper.add(settings, FAR, InputSource.IDLE);
      stepper.awaitPlaying(client);
      stepper.stopServer();
      stepper.run(1);
      assertEquals(ConnectionPhase.ENDED, client.view().phase());
      assertTrue(client.view().message().length() > 10, client.view().message());
    }
  }

  @Test
  void aServerThatNeverComesBackIsGivenUpWithAClearMessage() {
    // Goal: nobody waits for ever. Method: the server stops for good; two minutes pass.
    try (Stepper stepper = Stepper.of("arena")) {
      SimulatedClient client = stepper.join("client", FAR, InputSource.IDLE);
      stepper.stopServer();
      stepper.run(120);
      assertEquals(ConnectionPhase.ENDED, client.view().phase());
      assertTrue(client.view().message().contains("did not come back"), client.view().message());
    }
  }

  @Test
  void halfOpenLinksCostNobodyAnything() {
    // Goal: links that never say a word are closed in time, and a player's game doesn't change.
    // Method: the same game with and without forty silent links; equal frames, equal numbers.
    long[] hashes = new long[2];
    long[] snapshots = new long[2];
    double[] gaps = new double[2];
    for (int round = 0; round < 2; round++) {
      try (Stepper stepper = Stepper.of("arena")) {
        SimulatedClient player = stepper.join("player", FAR, Scripts.wander(3));
        List<Link> silent = new ArrayList<>();
        for (int i = 0; i < round * 40; i++) {
          silent.add(stepper.transport().connect("localhost", 0, 0));
        }
        stepper.run(8);
        for (Link link : silent) {
          assertEquals(Link.State.CLOSED, link.state());
          assertFalse(link.closeReason().isBlank());
        }
        hashes[round] = stepper.hash();
        snapshots[round] = player.stats().snapshots();
        gaps[round] = player.stats().gapP99Ms();
      }
    }
    assertEquals(hashes[0], hashes[1]);
    assertEquals(snapshots[0], snapshots[1]);
    assertEquals(gaps[0], gaps[1]);
    assertNotEquals(0, hashes[0]);
  }

  @Test
  void aFullServerRefusesPolitelyAndTakesTheNextWhenOneLeaves() {
    // Goal: the limit of players is a message, not a failure. Method: two seats, three players.
    try (Stepper stepper =
        Stepper.of(
            Levels.emptyArena(), ServerConfig.defaults().with(ServerConfig.MAX_PLAYERS, 2))) {
      SimulatedClient first = stepper.join("first", FAR, InputSource.IDLE);
      stepper.join("second", FAR, InputSource.IDLE);
      SimulatedClient third = stepper.add("third", FAR, InputSource.IDLE);
      stepper.run(1);
      assertEquals(ConnectionPhase.ENDED, third.view().phase());
      assertTrue(third.view().message().contains("full"), third.view().message());
      first.leave();
      stepper.run(0.5);
      stepper.join("fourth", FAR, InputSource.IDLE);
      assertEquals(2, stepper.count(Counter.PLAYERS));
    }
  }
}
