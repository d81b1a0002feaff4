package carom.server;

import static carom.server.RoomTest.CONFIG;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.protocol.GoodbyeReason;
import carom.net.protocol.SessionState;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.sim.SimulationHost;
import java.lang.reflect.Field;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** A room under garbage, forgeries, games that throw and pauses: it goes on, or closes in order. */
class RoomFaultsTest {
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
      assertEquals(honest.own.x(), rig.room.simulation().player(0).entity().body().centerX());
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
    try (Rig rig = new Rig(CONFIG.with(ServerConfig.CATCH_UP_TICKS, 8), new TestGame(3))) {
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
  void roomClosesInGoodOrderBeforeItsTicksRunOut() throws Exception {
    try (Rig rig = new Rig()) {
      FakeClient client = rig.join("a");
      Field parts = SimulationHost.class.getDeclaredField("parts"); // nobody waits for 413 days
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
}
