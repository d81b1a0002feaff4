package carom.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.protocol.ClientMessage;
import carom.net.protocol.GoodbyeReason;
import carom.net.protocol.ServerMessage;
import carom.net.protocol.SessionState;
import carom.net.snapshot.EntityHistory;
import carom.net.snapshot.frame.FrameState;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.server.room.Room;
import carom.sim.Simulation;
import carom.sim.entity.Entity;
import carom.sim.entity.Input;
import carom.sim.match.NextMatch;
import carom.sim.outbox.Outbox;
import java.lang.reflect.Field;
import java.util.List;
import java.util.Random;
import java.util.concurrent.CompletableFuture;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;

class RoomTest {
  private static final ServerConfig CONFIG = ServerConfig.defaults();

  @Test
  void clientsSeeExactlyTheFrameStateOfTheServer() {
    try (Rig rig = new Rig(CONFIG, new TestGame(20))) {
      FakeClient a = rig.join("a");
      rig.steps(7);
      FakeClient b = rig.join("b");
      a.input.move(1, 0);
      for (int i = 0; i < 300; i++) {
        rig.step();
        if (i > 30) {
          assertSees(rig.room, a, 22, "step=" + i);
          assertSees(rig.room, b, 22, "step=" + i);
        }
      }
      assertEquals(0, a.undecodable + b.undecodable);
    }
  }

  /** The client has polled all but the newest tick's datagrams. */
  static void assertSees(Room room, FakeClient client, int slots, String about) {
    int tick = room.tick() - 1;
    FrameState frame = room.frames().at(tick);
    for (int slot = 0; slot < slots; slot++) {
      String where = about + " slot=" + slot;
      EntityHistory history = client.decoder.history(slot);
      assertNotNull(history, where);
      int at = history.indexAt(tick);
      assertTrue(at >= 0, where);
      assertEquals(frame.alive(slot), history.alive(at), where);
      assertEquals(frame.x(slot), history.x(at), where);
      assertEquals(frame.y(slot), history.y(at), where);
      assertEquals(frame.angle(slot), history.angle(at), where);
      assertEquals(frame.ownership(slot), history.ownership(at), where);
      assertEquals(frame.still(slot), history.still(at), where);
      assertEquals(frame.archetype(slot), history.archetype(at), where);
      assertEquals(frame.generation(slot), history.generation(at), where);
    }
  }

  @Test
  void inputMovesTheBodyOfItsPlayerAndNoOther() {
    try (Rig rig = new Rig()) {
      FakeClient a = rig.join("a");
      FakeClient b = rig.join("b");
      float ay = a.own.y();
      float bx = b.own.x();
      a.input.move(0, 1);
      rig.seconds(1);
      a.input.move(0, 0);
      rig.steps(10);
      assertEquals(ay + TestGame.SPEED, a.own.y(), 0.3f);
      assertEquals(bx, b.own.x());
      assertEquals(77, a.own.word(0));
      Entity body = rig.room.simulation().player(0).body();
      assertEquals(body.body().centerX(), a.own.x());
      assertEquals(body.id(), a.own.slot());
    }
  }

  @Test
  void clientLearnsHowEarlyItsInputsCome() {
    try (Rig rig = new Rig()) {
      FakeClient client = rig.join("a");
      for (int lead : new int[] {1, 2, 9, 20}) {
        client.leadTicks = lead;
        rig.steps(90);
        assertTrue(client.decoder.feedback().present);
        // The input for tick + lead arrives before tick + 1 is consumed.
        assertEquals(lead - 1, client.decoder.feedback().margin, "lead=" + lead);
      }
      client.leadTicks = -5;
      rig.steps(90);
      assertTrue(client.decoder.feedback().margin < 0);
      assertTrue(rig.count(Counter.INPUTS_LATE) > 50);
      client.leadTicks = 200;
      rig.steps(90);
      assertTrue(client.decoder.feedback().margin > 20);
      assertTrue(rig.count(Counter.INPUTS_EARLY) > 50);
      assertEquals(client.sequence, client.decoder.feedback().sequence, 3);
    }
  }

  @Test
  void lostInputsAreRepeatedThenNeutral() {
    try (Rig rig = new Rig()) {
      FakeClient client = rig.join("a");
      client.input.move(1, 0);
      rig.steps(30);
      client.sends = false;
      rig.steps(25);
      assertTrue(client.own.vx() > 0);
      rig.steps(20);
      assertEquals(0, client.own.vx());
      assertTrue(rig.count(Counter.INPUTS_MISSING) > 20);
    }
  }

  /** A collection, a suspended machine, a busy one: what clients sent meanwhile wasn't read. */
  @Test
  void aServerThatStoodStillBlamesNobody() {
    try (Rig rig = new Rig()) {
      FakeClient client = rig.join("Ann");
      for (int pause = 0; pause < 3; pause++) {
        rig.nowNs += 20_000_000_000L;
        rig.server.tick(rig.nowNs);
        assertEquals(SessionState.PLAYING, rig.room.session(0).state());
        rig.seconds(1);
      }
      assertEquals(0, rig.count(Counter.LINKS_LOST));
      assertTrue(rig.count(Counter.TICKS_DROPPED) > 3_000);
      client.sends = false;
      rig.seconds(5.8);
      assertEquals(0, rig.count(Counter.LINKS_LOST), "it heard of the client until then");
      rig.seconds(0.4);
      assertEquals(1, rig.count(Counter.LINKS_LOST));
    }
  }

  @Test
  void silentPlayerKeepsTheBodyForTheGracePeriodAndThenIsGone() {
    try (Rig rig = new Rig()) {
      FakeClient other = rig.join("other");
      FakeClient client = rig.join("Ann");
      Entity body = rig.room.simulation().player(1).body();
      client.sends = false;
      rig.seconds(5.8);
      assertEquals(SessionState.PLAYING, rig.room.session(1).state());
      rig.seconds(0.4);
      assertEquals(SessionState.GRACE, rig.room.session(1).state());
      assertEquals(GoodbyeReason.TIMEOUT, client.goodbye.reason());
      assertTrue(other.notices().contains("Ann lost the connection"), "" + other.notices());
      assertSame(body, rig.room.simulation().player(1).body());
      rig.seconds(29);
      assertSame(body, rig.room.simulation().player(1).body());
      assertEquals(1, rig.count(Counter.PLAYERS_IN_GRACE));
      rig.seconds(2);
      assertNull(rig.room.simulation().player(1));
      assertNull(rig.room.session(1));
      assertEquals(1, rig.room.seats().takenCount());
      assertTrue(other.notices().contains("Ann is gone"), "" + other.notices());
      assertEquals(1, other.roster.entries().size());
      assertEquals(0, rig.count(Counter.PLAYERS_IN_GRACE));
    }
  }

  @Test
  void returningPlayerGetsTheSameBody() {
    try (Rig rig = new Rig()) {
      FakeClient before = rig.join("Ann");
      before.input.move(0, 1);
      rig.seconds(1);
      Entity body = rig.room.simulation().player(0).body();
      float y = before.own.y();
      before.link.close("cable pulled");
      rig.steps(2);
      assertEquals(SessionState.GRACE, rig.room.session(0).state());
      rig.seconds(10);
      assertEquals(0, body.body().velocityY(), "neutral while away");
      FakeClient after = rig.join("somebody else", before.welcome.sessionSecret());
      assertSame(body, rig.room.simulation().player(0).body());
      assertEquals(before.welcome.sessionSecret(), after.welcome.sessionSecret());
      assertTrue(before.welcome.datagramKey() != after.welcome.datagramKey());
      assertEquals(0, after.welcome.playerId());
      assertEquals(y, after.own.y(), 1);
      after.input.move(1, 0);
      rig.seconds(1);
      assertTrue(after.own.vx() > 0);
      assertEquals("Ann", after.roster.entries().get(0).name());
      assertEquals(1, rig.game.joins);
      assertEquals(1, rig.count(Counter.RESUMES));
    }
  }

  @Test
  void returningPlayerReplacesAnOldLinkThatStillLooksAlive() {
    try (Rig rig = new Rig()) {
      FakeClient before = rig.join("Ann");
      FakeClient after = rig.join("Ann", before.welcome.sessionSecret());
      rig.seconds(2);
      assertEquals(GoodbyeReason.RESUMED_ELSEWHERE, before.goodbye.reason());
      assertTrue(before.closed);
      assertNull(after.goodbye);
      assertEquals(1, rig.room.simulation().playerCapacity());
      assertEquals(1, rig.count(Counter.PLAYERS));
    }
  }

  @Test
  void bodyWaitsWhileItsOwnerIsLoading() {
    try (Rig rig = new Rig(CONFIG.withGraceMs(2_000), new TestGame(1))) {
      FakeClient before = rig.join("Ann");
      Entity body = rig.room.simulation().player(0).body();
      before.link.close("cable pulled");
      rig.seconds(1);
      FakeClient after = rig.connect().hello("Ann", before.welcome.sessionSecret());
      after.loads = false;
      rig.seconds(5);
      after.link.send(
          new ClientMessage.Ready(after.welcome.datagramKey(), after.welcome.declarationsDigest()));
      rig.steps(3);
      assertSame(body, rig.room.simulation().player(0).body());
      assertEquals(SessionState.PLAYING, rig.room.session(0).state());
    }
  }

  @Test
  void aClientWhoseFieldsDifferFromThoseOfTheNextMatchIsRemoved() {
    try (Rig rig = new Rig()) {
      FakeClient client = rig.join("Ann");
      client.loads = false;
      int key = client.welcome.datagramKey();
      rig.room.simulation().playNext(NextMatch.level(rig.room.match().level().level().name()));
      rig.seconds(5);
      assertNotEquals(key, client.welcome.datagramKey(), "the next match");
      assertNull(client.goodbye);
      client.link.send(
          new ClientMessage.Ready(
              client.welcome.datagramKey(), client.welcome.declarationsDigest() + 1));
      rig.seconds(1);
      assertEquals(GoodbyeReason.PROTOCOL_ERROR, client.goodbye.reason());
      assertTrue(client.goodbye.text().contains("Ready with fields that differ"));
      assertNull(rig.room.simulation().player(0));
    }
  }

  @Test
  void withoutGraceALostPlayerIsGoneAtOnce() {
    try (Rig rig = new Rig(CONFIG.withGraceMs(0), new TestGame(1))) {
      FakeClient client = rig.join("Ann");
      client.link.close("cable pulled");
      rig.steps(2);
      assertNull(rig.room.simulation().player(0));
      assertEquals(0, rig.room.seats().takenCount());
    }
  }

  @Test
  void leavingRemovesTheBodyAtOnceAndTellsTheOthers() {
    try (Rig rig = new Rig()) {
      FakeClient other = rig.join("other");
      FakeClient client = rig.join("Ann");
      int slot = client.own.slot();
      client.link.send(new ClientMessage.Leave());
      rig.steps(3);
      assertNull(rig.room.simulation().player(1));
      assertNull(rig.room.simulation().entity(slot));
      assertEquals(GoodbyeReason.LEFT, client.goodbye.reason());
      rig.seconds(1.2);
      assertTrue(client.closed);
      assertTrue(other.notices().contains("Ann left"));
      assertFalse(other.decoder.history(slot).alive());
      assertEquals(1, rig.count(Counter.LEAVES));
      assertEquals(1, rig.game.leaves);
      // The old secret is worth nothing now.
      assertTrue(
          rig.join("Ann", client.welcome.sessionSecret()).welcome.sessionSecret()
              != client.welcome.sessionSecret());
    }
  }

  @Test
  void scoresReachEverybodyButNotMoreOftenThanTheInterval() {
    try (Rig rig = new Rig(CONFIG.withRosterIntervalMs(500), new TestGame(1))) {
      FakeClient client = rig.join("Ann");
      rig.seconds(1);
      long before = client.messages.size();
      client.input.hold(Input.ACTION, true); // scores at each tick
      rig.seconds(3);
      client.input.hold(Input.ACTION, false);
      rig.seconds(1);
      long rosters = client.messages.size() - before;
      assertTrue(rosters >= 5 && rosters <= 9, "rosters=" + rosters);
      assertEquals(rig.room.simulation().player(0).score(), client.roster.entries().get(0).score());
    }
  }

  @Test
  void whoIsNewIsToldOfEverybodyAndTheOthersOnlyOfHim() {
    try (Rig rig = new Rig(CONFIG.withMaxPlayers(4).withRosterIntervalMs(500), new TestGame(1))) {
      FakeClient first = rig.join("Ann");
      FakeClient second = rig.join("Bob");
      rig.seconds(1);
      FakeClient third = rig.join("Cat");
      rig.seconds(1);
      assertEquals(List.of("Ann", "Bob", "Cat"), names(third.roster));
      assertEquals(List.of("Ann", "Bob", "Cat"), names(first.roster));
      assertEquals(List.of("Cat"), names(first.lastRoster));
      second.link.send(new ClientMessage.Leave());
      rig.seconds(1);
      assertEquals(List.of(""), names(first.lastRoster));
      assertEquals(List.of("Ann", "Cat"), names(first.roster));
      first.link.close("cable pulled");
      rig.seconds(1);
      FakeClient back = rig.join("Ann", first.welcome.sessionSecret());
      rig.seconds(1);
      assertEquals(List.of("Ann", "Cat"), names(back.roster));
    }
  }

  private static List<String> names(ServerMessage.Roster roster) {
    return roster.entries().stream().map(ServerMessage.RosterEntry::name).toList();
  }

  @Test
  void garbageHurtsNobody() {
    long seed = Long.getLong("carom.seed", 3);
    Random random = new Random(seed);
    try (Rig rig = new Rig()) {
      FakeClient honest = rig.join("honest");
      FakeClient hostile = rig.join("hostile");
      byte[] bytes = new byte[1_200];
      for (int i = 0; i < 300; i++) {
        for (int n = 0; n < 20; n++) {
          random.nextBytes(bytes);
          hostile.link.sendDatagram(bytes, 0, 1 + random.nextInt(1_200));
        }
        rig.step();
      }
      assertTrue(rig.count(Counter.DATAGRAMS_REFUSED) > 1_000, "seed=" + seed);
      assertNull(hostile.goodbye, "forged datagrams never close a session; seed=" + seed);
      assertNull(honest.goodbye);
      assertEquals(0, honest.undecodable);
      assertEquals(2, rig.count(Counter.PLAYERS));
    }
  }

  @Test
  void aCrowdThatComesAtOnceTakesAPartOfEachTick() {
    for (boolean slow : new boolean[] {false, true}) {
      try (Rig rig = new Rig()) {
        rig.game.whileJoining = () -> rig.nowNs += slow ? 3 * Rig.TICK_NS / 16 : 0;
        for (int i = 0; i < 12; i++) {
          rig.connect().hello("crowd" + i, 0);
        }
        int most = 0;
        for (int i = 0; i < 60; i++) {
          int joins = rig.game.joins;
          int tick = rig.room.tick();
          rig.step(); // two ticks when joins have made the time pass
          int ticks = Math.max(1, rig.room.tick() - tick);
          most = Math.max(most, (rig.game.joins - joins + ticks - 1) / ticks);
        }
        assertEquals(12, rig.game.joins);
        assertEquals(slow ? 1 : 8, most, "slow=" + slow);
      }
    }
  }

  @Test
  void forgedInputsWithARightKeyChangeOnlyThatPlayer() {
    long seed = Long.getLong("carom.seed", 4);
    Random random = new Random(seed);
    try (Rig rig = new Rig()) {
      FakeClient honest = rig.join("honest");
      FakeClient hostile = rig.join("hostile");
      hostile.sends = false;
      for (int i = 0; i < 600; i++) {
        hostile.input.unpack(random.nextLong());
        hostile.sequence = random.nextInt();
        hostile.sendInput(random.nextInt());
        rig.step();
      }
      rig.step();
      assertEquals(0, honest.undecodable, "seed=" + seed);
      assertEquals(honest.own.x(), rig.room.simulation().player(0).body().body().centerX());
      assertEquals(SessionState.PLAYING, rig.room.session(1).state());
    }
  }

  @Test
  void wrongMessageWhilePlayingExpelsTheSenderAlone() {
    try (Rig rig = new Rig()) {
      FakeClient honest = rig.join("honest");
      FakeClient hostile = rig.join("hostile");
      hostile.hello("again");
      rig.steps(3);
      assertEquals(GoodbyeReason.PROTOCOL_ERROR, hostile.goodbye.reason());
      assertTrue(hostile.goodbye.text().contains("Hello"), hostile.goodbye.text());
      assertNull(honest.goodbye);
      assertEquals(1, rig.count(Counter.SESSIONS_EXPELLED));
      assertEquals(1, rig.count(Counter.PLAYERS));
    }
  }

  @Test
  void gameThatThrowsNowAndThenKeepsRunning() {
    try (Rig rig = new Rig()) {
      FakeClient client = rig.join("Ann");
      rig.game.failEvery = 10;
      rig.seconds(3);
      assertEquals(18, rig.count(Counter.GAME_FAILURES), 1);
      assertNull(client.goodbye);
      assertFalse(rig.server.hasFailed());
      assertEquals(rig.room.tick(), client.decoder.newestTick(), 1);
    }
  }

  @Test
  void gameThatThrowsAtEachTickClosesTheRoom() {
    try (Rig rig = new Rig()) {
      FakeClient client = rig.join("Ann");
      rig.game.failEvery = 1;
      rig.seconds(2);
      assertEquals(GoodbyeReason.SERVER_ERROR, client.goodbye.reason());
      assertTrue(rig.server.hasFailed());
      assertEquals(60, rig.count(Counter.GAME_FAILURES));
    }
  }

  @Test
  void gameThatThrowsInJoinLeavesAPlayerWithoutBody() {
    try (Rig rig = new Rig()) {
      rig.game.failInJoin = true;
      FakeClient client = rig.join("Ann");
      rig.seconds(1);
      assertEquals(-1, client.own.slot());
      assertTrue(client.decoder.hasOwn());
      assertEquals(1, rig.count(Counter.GAME_FAILURES));
    }
  }

  @Test
  void longPauseDropsTicksOnceAndTheGameGoesOn() {
    try (Rig rig = new Rig(CONFIG.withCatchUpTicks(8), new TestGame(3))) {
      FakeClient client = rig.join("Ann");
      int before = rig.room.tick();
      rig.nowNs += 1_000_000_000L;
      rig.step();
      assertEquals(before + 8, rig.room.tick());
      assertEquals(53, rig.count(Counter.TICKS_DROPPED), 1);
      assertEquals(7, rig.count(Counter.TICKS_LATE));
      rig.seconds(1);
      assertEquals(rig.room.tick(), client.decoder.newestTick(), 1);
      assertEquals(0, client.undecodable);
      assertEquals(SessionState.PLAYING, rig.room.session(0).state());
    }
  }

  @Test
  void worldAtRestCostsOnlyKeepAlives() {
    try (Rig rig = new Rig()) {
      rig.game.ballsMove = false;
      FakeClient client = rig.join("Ann");
      rig.seconds(2);
      long before = client.datagrams;
      rig.seconds(10);
      assertEquals(60, client.datagrams - before, 2);
      client.input.move(1, 0);
      rig.steps(6);
      before = client.datagrams;
      rig.seconds(1);
      assertEquals(60, client.datagrams - before, 1);
    }
  }

  @Test
  void snapshotRateBelowTheTickRateIsKept() {
    try (Rig rig = new Rig(CONFIG.withSnapshotRateHz(20), new TestGame(5))) {
      FakeClient client = rig.join("Ann");
      rig.seconds(1);
      long before = client.datagrams;
      rig.seconds(10);
      assertEquals(200, client.datagrams - before, 2);
      assertEquals(0, client.undecodable);
    }
  }

  @Test
  void budgetIsKeptAndEveryEntityArrivesAllTheSame() {
    try (Rig rig = new Rig(CONFIG.withSnapshotBitsPerSecond(40_000), new TestGame(400))) {
      FakeClient client = rig.join("Ann");
      rig.seconds(2);
      long before = client.bytes;
      rig.seconds(10);
      long perSecond = (client.bytes - before) / 10;
      assertTrue(perSecond < 5_250, "bytesPerSecond=" + perSecond);
      assertTrue(perSecond > 3_750, "bytesPerSecond=" + perSecond);
      for (int slot = 0; slot < 400; slot++) {
        assertTrue(client.decoder.history(slot).alive(), "slot=" + slot);
        int age = rig.room.tick() - client.decoder.history(slot).tick(0);
        assertTrue(age < 120, "slot=" + slot + " age=" + age);
      }
    }
  }

  @Test
  void stoppingTellsEverybody() {
    Rig rig = new Rig();
    FakeClient a = rig.join("a");
    FakeClient b = rig.join("b");
    rig.server.close();
    a.step(0);
    b.step(0);
    assertEquals(GoodbyeReason.SERVER_STOPPING, a.goodbye.reason());
    assertEquals(GoodbyeReason.SERVER_STOPPING, b.goodbye.reason());
    assertTrue(a.closed && b.closed);
    rig.server.close();
  }

  @Test
  void statusLineSaysWhatAnOperatorWantsToKnow() {
    try (Rig rig = new Rig()) {
      rig.join("Ann");
      rig.seconds(5);
      assertEquals(1, rig.server.status().size());
      String status = rig.server.status().get(0);
      assertTrue(status.startsWith("1 of 64 players, tick "), status);
      assertTrue(status.contains("60.0 Hz"), status);
      assertTrue(status.contains("dropped 0"), status);
      assertTrue(status.contains("inputs missing 0.00 %"), status);
    }
  }

  @Test
  void roomClosesInGoodOrderBeforeItsTicksRunOut() throws Exception {
    try (Rig rig = new Rig()) {
      FakeClient client = rig.join("a");
      Field parts = Simulation.class.getDeclaredField("parts"); // nobody waits for 413 days
      parts.setAccessible(true);
      Field tick = parts.getType().getDeclaredField("tick");
      tick.setAccessible(true);
      tick.setInt(parts.get(rig.room.simulation()), Integer.MAX_VALUE - (1 << 20) - 30);
      rig.seconds(3);
      assertTrue(rig.room.hasFailed());
      assertTrue(client.closed, "players are told");
      assertTrue(rig.room.tick() < Integer.MAX_VALUE - (1 << 20) + 2, "tick=" + rig.room.tick());
    }
  }

  @Test
  void anOperatorCanAskWhyAnEntityWasNotSent() {
    try (Rig rig = new Rig()) {
      rig.game.ballsMove = false;
      FakeClient ann = rig.join("Ann");
      rig.seconds(1);
      assertTrue(ask(rig, 0, 1).contains("reason=UP_TO_DATE"), ask(rig, 0, 1));
      assertTrue(ask(rig, 0, 500).contains("reason=FREE"), ask(rig, 0, 500));
      assertTrue(ask(rig, 9, 1).contains("player=9 doesn't play here"), ask(rig, 9, 1));
      assertTrue(ask(rig, 0, -1).contains("entity=-1 is outside"), ask(rig, 0, -1));
      ann.link.close("cable pulled");
      rig.steps(2);
      assertEquals(SessionState.GRACE, rig.room.session(0).state());
      assertEquals("player=0 is away: nothing is sent to it", ask(rig, 0, 1));
    }
  }

  @Test
  void anOperatorCanRemoveAPlayer() {
    try (Rig rig = new Rig()) {
      FakeClient ann = rig.join("Ann");
      FakeClient bob = rig.join("Bob");
      rig.seconds(1);
      assertEquals(
          "removed player=0 name=Ann", ask(rig, () -> rig.room.operator().kick(0, "be nice")));
      rig.seconds(1);
      assertEquals(GoodbyeReason.KICKED, ann.goodbye.reason());
      assertEquals("be nice", ann.goodbye.text());
      assertNull(rig.room.session(0), "the body goes with the player");
      assertNull(bob.goodbye);
      String nobody = ask(rig, () -> rig.room.operator().kick(0, ""));
      assertTrue(nobody.contains("player=0 doesn't play here"), nobody);
    }
  }

  @Test
  void anOperatorSeesFieldsAndIsToldWhatIsWrongWithAQuestion() {
    try (Rig rig = new Rig()) {
      rig.join("Ann");
      assertEquals("", ask(rig, () -> rig.room.operator().fields("match")), "it has none");
      assertEquals(
          "player.mark=77 player.actions=0",
          ask(rig, () -> rig.room.operator().fields("player 0")));
      assertEquals(
          "of=player 7 isn't there", ask(rig, () -> rig.room.operator().fields("player 7")));
      String wrong = ask(rig, () -> rig.room.operator().fields("player x"));
      assertEquals("of=player x must be match, player N or entity N", wrong);
    }
  }

  static String ask(Rig rig, int player, int entity) {
    return ask(rig, () -> rig.room.operator().why(player, entity));
  }

  private static String ask(Rig rig, Supplier<String> question) {
    CompletableFuture<String> answer = CompletableFuture.supplyAsync(question);
    while (!answer.isDone()) {
      rig.step();
      Thread.onSpinWait();
    }
    return answer.join();
  }

  @Test
  void eventsBeyondTheMostOfATickAreCountedAsLost() {
    try (Rig rig = new Rig()) {
      for (int i = 0; i < Outbox.MAX_EVENTS + 6; i++) {
        rig.room.simulation().emit(rig.game.shout);
      }
      rig.step();
      assertEquals(6, rig.count(Counter.EVENTS_LOST));
      rig.step();
      assertEquals(6, rig.count(Counter.EVENTS_LOST));
    }
  }
}
