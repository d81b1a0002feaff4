package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.ClientConfig;
import carom.client.GameClient;
import carom.client.InputSource;
import carom.client.PredictionMode;
import carom.client.bots.OrderedBots;
import carom.client.link.ConnectionPhase;
import carom.net.transport.Impairment;
import carom.replay.RecordingReader;
import carom.replay.Replay;
import carom.server.config.BotRule;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.server.room.BotCrew;
import carom.server.session.Session;
import carom.sim.entity.HostEntity;
import carom.sim.level.Level;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: bots fill a room in which people play, and take and give back the seats of people. Method:
 * a server, its bots and people's clients in virtual time; the server's simulation is the truth.
 */
class BotSeatScenarioTest {
  private final List<String> tokens = new ArrayList<>();
  private Stepper stepper;
  private OrderedBots bots;

  private void start(String rule, int places) throws Exception {
    ServerConfig config =
        ServerConfig.defaults()
            .with(ServerConfig.BOTS, List.of(BotRule.parse(rule)))
            .with(ServerConfig.MAX_PLAYERS, places);
    stepper = Stepper.of(Level.builtIn("arena"), config);
    ClientConfig of = ClientConfig.of("bot").with(ClientConfig.PREDICTION, PredictionMode.NONE);
    bots = new OrderedBots(of, stepper.transport(), Stepper.SEED);
    BotCrew crew =
        (token, strength) -> {
          tokens.add(token);
          bots.order((token + " " + strength).strip());
        };
    stepper.server().bots(crew);
  }

  @AfterEach
  void stop() {
    bots.close();
    stepper.close();
  }

  private void run(double seconds) {
    long endNs = stepper.nowNs() + (long) (seconds * 1e9);
    while (stepper.nowNs() - endNs < 0) {
      stepper.step();
      bots.update(stepper.nowNs());
    }
  }

  private void runUntil(String what, BooleanSupplier condition, double seconds) {
    for (int i = 0; i < seconds * 100 && !condition.getAsBoolean(); i++) {
      run(0.01);
    }
    assertTrue(condition.getAsBoolean(), what + "; " + stepper.describe());
  }

  private SimulatedClient join(String name) {
    SimulatedClient client =
        stepper.add(
            name, Impairment.NONE, (view, tick, out) -> out.move(tick % 120 < 60 ? 1 : -1, 0));
    runUntil(name + " plays", () -> client.view().phase() == ConnectionPhase.PLAYING, 10);
    return client;
  }

  private void leave(SimulatedClient client) {
    client.leave();
    stepper.remove(client);
  }

  private List<Session> sessions(boolean bot) {
    List<Session> found = new ArrayList<>();
    for (int id = 0; id < stepper.room().seats().count(); id++) {
      Session session = stepper.room().session(id);
      if (session != null && session.isBot() == bot) {
        found.add(session);
      }
    }
    return found;
  }

  private void awaitPlayers(int people, int ofBots) {
    runUntil(
        "people=" + people + " bots=" + ofBots,
        () -> sessions(false).size() == people && sessions(true).size() == ofBots,
        15);
  }

  @Test
  void botsFillTheRoomAndMakeRoomAndGoWithTheLast() throws Exception {
    start("4:strong", 8);
    run(3);
    assertEquals(0, bots.count(), "nobody is here to play with");
    SimulatedClient ann = join("Ann");
    awaitPlayers(1, 3);
    assertEquals(3, stepper.count(Counter.BOTS));
    SimulatedClient bob = join("Bob");
    awaitPlayers(2, 2);
    List<SimulatedClient> more = new ArrayList<>();
    for (String name : List.of("Cleo", "Dan", "Eve")) {
      more.add(join(name));
    }
    awaitPlayers(5, 0);
    more.forEach(this::leave);
    leave(ann);
    awaitPlayers(1, 3);
    run(2);
    leave(bob);
    awaitPlayers(0, 0);
    run(3);
    assertEquals(0, bots.count());
    assertEquals(0, stepper.room().seats().takenCount());
  }

  @Test
  void aBotTakesTheSeatOfWhoLeavesWithBodyTeamAndScore() throws Exception {
    start("2", 8);
    SimulatedClient ann = join("Ann");
    SimulatedClient bob = join("Bob");
    awaitPlayers(2, 0);
    Session seat = stepper.room().session(ann.view().playerId());
    HostEntity body = stepper.body(ann);
    seat.player().score(7);
    int team = seat.player().team();
    run(1);
    leave(ann);
    runUntil("a bot plays on", seat::isBot, 5);
    assertSame(seat, stepper.room().session(seat.seat().id()));
    assertSame(body, stepper.room().simulation().entity(body.id()));
    assertEquals(team, seat.player().team());
    assertTrue(seat.player().score() >= 7, "score=" + seat.player().score());
    float x = body.x();
    float y = body.y();
    run(3);
    assertTrue(Math.hypot(body.x() - x, body.y() - y) > 0.5, "the bot moves the body");
    assertEquals("Ann (bot)", bob.view().playerName(seat.seat().id()));
    assertEquals(2, stepper.room().seats().takenCount(), "no other bot came");
    SimulatedClient again = join("Ann");
    awaitPlayers(2, 0);
    assertNotEquals(seat, stepper.room().session(again.view().playerId()));
  }

  @Test
  void whoLosesTheConnectionGetsTheSeatBackFromTheBot() throws Exception {
    start("2", 8);
    SimulatedClient ann = join("Ann");
    SimulatedClient bob = join("Bob");
    Session seat = stepper.room().session(ann.view().playerId());
    HostEntity body = stepper.body(ann);
    stepper.blackout(ann, 14);
    runUntil("a bot stands in", seat::isStandIn, 14);
    run(1);
    assertEquals("Ann (bot)", bob.view().playerName(seat.seat().id()));
    assertFalse(seat.seat().isBots());
    runUntil(
        "Ann is back", () -> !seat.isBot() && ann.view().phase() == ConnectionPhase.PLAYING, 30);
    run(1);
    assertSame(body, stepper.body(ann));
    assertSame(seat, stepper.room().session(ann.view().playerId()));
    assertEquals("Ann", bob.view().playerName(seat.seat().id()));
    assertEquals(0, bots.count());
    assertEquals(1, stepper.count(Counter.RESUMES));
    assertEquals(2, stepper.count(Counter.JOINS) - stepper.count(Counter.RESUMES));
  }

  @Test
  void theBotKeepsTheSeatOfWhoStaysAway() throws Exception {
    start("2", 8);
    SimulatedClient ann = join("Ann");
    join("Bob");
    Session seat = stepper.room().session(ann.view().playerId());
    stepper.blackout(ann, 60);
    runUntil("a bot stands in", seat::isStandIn, 14);
    runUntil("the grace period is over", () -> seat.seat().isBots(), 40);
    assertTrue(seat.isBot());
    runUntil("Ann is back", () -> ann.view().phase() == ConnectionPhase.PLAYING, 60);
    assertNotEquals(
        seat, stepper.room().session(ann.view().playerId()), "the old seat is no longer hers");
    awaitPlayers(2, 0);
  }

  @Test
  void peopleGetTheSeatsOfBotsInAFullRoom() throws Exception {
    start("3:weak", 3);
    join("Ann");
    awaitPlayers(1, 2);
    join("Bob");
    awaitPlayers(2, 1);
    join("Cleo");
    awaitPlayers(3, 0);
    SimulatedClient dan = stepper.add("Dan", Impairment.NONE, InputSource.IDLE);
    runUntil("Dan is refused", () -> dan.view().phase() == ConnectionPhase.ENDED, 10);
    assertTrue(dan.view().message().contains("taken"), dan.view().message());
  }

  @Test
  void nobodyGetsASeatBySayingItIsABot() throws Exception {
    start("3", 8);
    SimulatedClient ann = join("Ann");
    awaitPlayers(1, 2);
    List<String> said = new ArrayList<>(List.of("bot:", "bot:0", "bot:1", "bot:null"));
    said.addAll(tokens); // spent
    said.add(
        "bot:"
            + Long.toHexString(
                stepper.room().session(ann.view().playerId()).seat().secret())); // none of bots
    for (String token : said) {
      ClientConfig config = ClientConfig.of("Eve").with(ClientConfig.TOKEN, token);
      try (GameClient eve = new GameClient(config, stepper.transport(), InputSource.IDLE)) {
        for (int i = 0; i < 100; i++) {
          run(0.01);
          eve.update(stepper.nowNs());
        }
        assertEquals(ConnectionPhase.ENDED, eve.view().phase(), token);
        assertTrue(eve.view().message().contains("No bot is wanted"), eve.view().message());
      }
    }
    assertEquals(1, sessions(false).size());
    assertEquals(2, sessions(true).size());
  }

  @Test
  void aRecordingOfSeatsThatGoToAndFroIsComputedAgain(@TempDir Path folder) throws Exception {
    start("3", 8);
    Path file = folder.resolve("bots.carom");
    stepper.server().record(file);
    SimulatedClient ann = join("Ann");
    join("Bob");
    Session seat = stepper.room().session(ann.view().playerId());
    stepper.blackout(ann, 10);
    runUntil("a bot stands in", seat::isStandIn, 14);
    runUntil(
        "Ann is back", () -> !seat.isBot() && ann.view().phase() == ConnectionPhase.PLAYING, 30);
    leave(ann);
    runUntil("a bot plays on", seat::isBot, 5);
    run(2);
    stepper.server().close();
    try (RecordingReader reader = RecordingReader.open(file)) {
      Replay replay = new Replay(reader);
      while (replay.step() == Replay.Progress.TICK) {
        assertNull(replay.divergence());
      }
      assertTrue(replay.equalTicks() > 600, "ticks=" + replay.equalTicks());
    }
  }
}
