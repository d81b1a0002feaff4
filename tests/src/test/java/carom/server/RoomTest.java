package carom.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.protocol.GoodbyeReason;
import carom.net.protocol.SessionState;
import carom.net.snapshot.EntityHistory;
import carom.net.snapshot.frame.FrameState;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.server.room.Room;
import carom.sim.entity.HostEntity;
import carom.sim.entity.Input;
import carom.sim.outbox.Outbox;
import java.util.concurrent.CompletableFuture;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;

class RoomTest {
  static final ServerConfig CONFIG = ServerConfig.defaults();

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
      HostEntity body = rig.room.simulation().player(0).entity();
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

  @Test
  void scoresReachEverybodyButNotMoreOftenThanTheInterval() {
    try (Rig rig = new Rig(CONFIG.with(ServerConfig.ROSTER_INTERVAL_MS, 500), new TestGame(1))) {
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
  void worldAtRestCostsOnlyKeepAlives() {
    try (Rig rig = new Rig()) {
      rig.game.ballsMove = false;
      FakeClient client = rig.join("Ann");
      rig.seconds(2);
      long before = client.datagrams;
      rig.seconds(10);
      assertEquals(10 * CONFIG.get(ServerConfig.KEEP_ALIVE_RATE), client.datagrams - before, 2);
      client.input.move(1, 0);
      rig.steps(6);
      before = client.datagrams;
      rig.seconds(1);
      assertEquals(60, client.datagrams - before, 1);
    }
  }

  @Test
  void snapshotRateBelowTheTickRateIsKept() {
    try (Rig rig = new Rig(CONFIG.with(ServerConfig.SNAPSHOT_RATE, 20), new TestGame(5))) {
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
    try (Rig rig = new Rig(CONFIG.with(ServerConfig.BUDGET, 40), new TestGame(400))) {
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
    return ask(rig, () -> rig.room.operator().why(player, entity, Object::toString));
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
