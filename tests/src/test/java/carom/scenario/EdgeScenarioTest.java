package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.InputSource;
import carom.client.bots.Bot;
import carom.client.link.ConnectionPhase;
import carom.fixtures.Crowd;
import carom.fixtures.Levels;
import carom.game.Games;
import carom.net.transport.Impairment;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.sim.entity.HostEntity;
import carom.sim.level.Level;
import carom.testkit.Condition;
import carom.testkit.Scripts;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Goal: the game survives settings at their limits, numbers that wrap, machines that stall, and
 * crowds that join at once. Method: real clients and server in virtual time, every decoded state
 * compared.
 */
class EdgeScenarioTest {
  private static final Impairment FAR = Impairment.NONE.withLatency(40, 5);

  private static Level arena() throws Exception {
    return Level.builtIn(Games.create("arena").defaultLevel());
  }

  private static void requirePlaying(Stepper stepper) {
    for (SimulatedClient client : stepper.clients()) {
      assertEquals(ConnectionPhase.PLAYING, client.view().phase(), stepper::describe);
      assertEquals(0, client.stats().malformed(), stepper::describe);
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {10, 20, 30, 128, 240})
  void everyTickRatePlays(int tickRateHz) throws Exception {
    // Goal: the rate is a setting, not an assumption. Method: agreement at rates from end to end;
    // a player alone is predicted exactly at each.
    ServerConfig config = ServerConfig.defaults().with(ServerConfig.TICK_RATE, tickRateHz);
    try (Stepper stepper = Stepper.of(arena(), config)) {
      stepper.add("a", FAR, new Bot(1));
      stepper.add("b", Condition.LOSS_10_PERCENT.impairment(Stepper.SEED), new Bot(2));
      stepper.run(6);
      requirePlaying(stepper);
      assertTrue(stepper.compared() > 200, stepper.describe());
    }
    try (Stepper stepper = Stepper.of(Levels.emptyArena(), config)) {
      SimulatedClient alone =
          stepper.join("a", Impairment.NONE.withLatency(40, 0), Scripts.wander(Stepper.SEED));
      stepper.run(5);
      long corrections = alone.stats().corrections();
      long missing = stepper.count(Counter.INPUTS_MISSING);
      stepper.run(10);
      assertEquals(missing, stepper.count(Counter.INPUTS_MISSING), stepper.describe());
      assertEquals(corrections, alone.stats().corrections(), stepper.describe());
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {5, 10, 20, 45})
  void everySnapshotRatePlays(int snapshotRateHz) throws Exception {
    // Goal: fewer snapshots than ticks cost smoothness, nothing else. Method: agreement, rate and
    // exactness of a player alone.
    ServerConfig config = ServerConfig.defaults().with(ServerConfig.SNAPSHOT_RATE, snapshotRateHz);
    try (Stepper stepper = Stepper.of(arena(), config)) {
      SimulatedClient a = stepper.join("a", FAR, new Bot(1));
      stepper.join("b", Condition.MIXED.impairment(Stepper.SEED), new Bot(2));
      stepper.run(1);
      long before = a.stats().snapshots();
      stepper.run(10);
      requirePlaying(stepper);
      assertEquals(10 * snapshotRateHz, a.stats().snapshots() - before, 3 + snapshotRateHz / 5.0);
    }
    try (Stepper stepper = Stepper.of(Levels.emptyPlatformer(), config)) {
      SimulatedClient alone =
          stepper.join("a", Impairment.NONE.withLatency(40, 0), Scripts.wander(Stepper.SEED));
      stepper.run(5);
      long corrections = alone.stats().corrections();
      stepper.run(10);
      assertEquals(corrections, alone.stats().corrections(), stepper.describe());
    }
  }

  @Test
  void theSmallestBudgetStillTellsEverything() throws Exception {
    // Goal: too few bytes make things late, never wrong or forgotten. Method: 2,000 bytes a second
    // for a full arena; then one idle player at a level that comes to rest.
    ServerConfig config = ServerConfig.defaults().with(ServerConfig.BUDGET, 16);
    try (Stepper stepper = Stepper.of(arena(), config)) {
      for (int i = 0; i < 6; i++) {
        stepper.add("bot" + i, FAR, new Bot(i));
      }
      stepper.run(10);
      requirePlaying(stepper);
      double kbit = stepper.clients().get(0).stats().kbitInPerSecond();
      assertTrue(kbit < 40, "kbit=" + kbit);
    }
    try (Stepper stepper = Stepper.of(Levels.platformerWithCrates(), config)) {
      stepper.join(2);
      stepper.run(12);
      stepper.requireAllSame();
    }
  }

  @Test
  void sequenceAndTickNumbersWrapUnnoticed() {
    // Goal: 16 bits of sequence and tick last 4.5 minutes at 240 Hz; the game goes on behind them.
    // Method: five minutes of a match of ten; rate, exactness and agreement before and after.
    ServerConfig config =
        ServerConfig.defaults()
            .with(ServerConfig.TICK_RATE, 240)
            .with(ServerConfig.SNAPSHOT_RATE, 240);
    try (Stepper stepper = Stepper.of(Levels.emptyPlatformer(), config)) {
      SimulatedClient alone =
          stepper.join("a", Impairment.NONE.withLatency(20, 0), Scripts.wander(Stepper.SEED));
      stepper.run(5);
      long corrections = alone.stats().corrections();
      for (int minute = 0; minute < 5; minute++) {
        long snapshots = alone.stats().snapshots();
        stepper.run(60);
        String about = "minute=" + minute + " " + stepper.describe();
        assertTrue(alone.stats().snapshots() - snapshots > 10_000, about);
        assertEquals(corrections, alone.stats().corrections(), about);
        assertEquals(0, alone.stats().malformed(), about);
      }
      assertTrue(stepper.frame().tick() > 1 << 16);
      assertEquals(0, alone.stats().reconnects());
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.1, 0.5, 2, 4})
  void afterAStallOfTheServerTheGameGoesOn(double seconds) {
    // Goal: a pause of the server's machine is a pause, not a crash. Method: the server stands
    // still; soon afterwards clocks and predictions are as before, and nobody reconnected.
    try (Stepper stepper = Stepper.of(Levels.emptyArena(), ServerConfig.defaults())) {
      SimulatedClient client =
          stepper.join("a", Impairment.NONE.withLatency(40, 0), Scripts.wander(Stepper.SEED));
      stepper.run(4);
      stepper.stallServer(seconds);
      stepper.run(4); // the client has waited for the server instead of running ahead
      assertPlaysOn(stepper, client);
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.1, 0.5, 2, 4})
  void afterAStallOfAClientTheGameGoesOn(double seconds) {
    // Goal: a pause of a player's machine is a pause, too. Method: as above, the client stands.
    try (Stepper stepper = Stepper.of(Levels.emptyArena(), ServerConfig.defaults())) {
      SimulatedClient client =
          stepper.join("a", Impairment.NONE.withLatency(40, 0), Scripts.wander(Stepper.SEED));
      stepper.run(4);
      client.freeze(true);
      stepper.run(seconds);
      client.freeze(false);
      stepper.run(4);
      assertPlaysOn(stepper, client);
    }
  }

  private static void assertPlaysOn(Stepper stepper, SimulatedClient client) {
    long corrections = client.stats().corrections();
    long missing = stepper.count(Counter.INPUTS_MISSING);
    stepper.run(5);
    String about = stepper.describe();
    assertEquals(0, client.stats().reconnects(), about);
    assertEquals(missing, stepper.count(Counter.INPUTS_MISSING), about);
    assertEquals(corrections, client.stats().corrections(), about);
    assertEquals(client.stats().targetMargin(), client.stats().inputMargin(), 2, about);
  }

  @Test
  void aCrowdComesAndGoesAtOnce() {
    // Goal: all seats in one moment, and all empty in one moment. Method: 64 clients connect in the
    // same slice, play a second, leave in the same slice; then one more finds a quiet server.
    try (Stepper stepper = Stepper.of("platformer")) {
      for (int i = 0; i < 64; i++) {
        Crowd.add(stepper, Impairment.NONE.withLatency(20, 0), Scripts.wander(i));
      }
      stepper.run(2);
      requirePlaying(stepper);
      assertEquals(64, stepper.count(Counter.PLAYERS));
      stepper.clients().forEach(SimulatedClient::leave);
      stepper.run(1);
      assertEquals(0, stepper.count(Counter.PLAYERS));
      assertEquals(64, stepper.count(Counter.LEAVES));
      SimulatedClient last = stepper.join("last", FAR, InputSource.IDLE);
      assertEquals(1, last.view().players().size());
      assertEquals(0, last.view().playerId());
    }
  }

  @Test
  void aLineThatBreaksAgainAndAgainAlwaysLeadsBackToTheSameBody() {
    // Goal: flapping lines lose nothing. Method: ten cuts at odd moments, in the middle of coming
    // back, too.
    try (Stepper stepper = Stepper.of("arena")) {
      SimulatedClient client = stepper.join("p", FAR, Scripts.wander(Stepper.SEED));
      final HostEntity body = stepper.body(client);
      for (int i = 0; i < 10; i++) {
        stepper.run(0.05 + 0.13 * i);
        client.cut();
      }
      stepper.run(0.1);
      stepper.awaitPlaying(client);
      stepper.run(1);
      assertSame(body, stepper.body(client));
      assertEquals(1, stepper.count(Counter.PLAYERS));
      assertEquals(1, client.view().players().size());
    }
  }

  @Test
  void aServerThatRestartsAgainAndAgainGetsItsPlayersBack() {
    // Goal: restarts at any moment of joining. Method: eight servers that live from 0.02 to 1.5 s.
    try (Stepper stepper = Stepper.of("arena")) {
      for (int i = 0; i < 3; i++) {
        stepper.join("p" + i, FAR, new Bot(i));
      }
      for (double life : new double[] {0.02, 0.05, 0.1, 0.2, 0.4, 0.8, 1.5, 0.3}) {
        stepper.stopServer();
        stepper.run(0.3);
        stepper.startServer();
        stepper.run(life);
      }
      for (SimulatedClient client : stepper.clients()) {
        stepper.awaitPlaying(client);
      }
      stepper.run(1);
      requirePlaying(stepper);
      assertEquals(3, stepper.count(Counter.PLAYERS));
    }
  }
}
