package carom.server;

import static carom.server.RoomTest.CONFIG;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.protocol.ClientMessage;
import carom.net.protocol.GoodbyeReason;
import carom.net.protocol.ServerMessage;
import carom.net.protocol.SessionState;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.sim.entity.HostEntity;
import carom.sim.outbox.NextMatch;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Players who fall silent, come back, leave or are new, and the seats they have meanwhile. */
class RoomSeatsTest {
  @Test
  void silentPlayerKeepsTheBodyForTheGracePeriodAndThenIsGone() {
    try (Rig rig = new Rig()) {
      FakeClient other = rig.join("other");
      FakeClient client = rig.join("Ann");
      HostEntity body = rig.room.simulation().player(1).entity();
      client.sends = false;
      rig.seconds(5.8);
      assertEquals(SessionState.PLAYING, rig.room.session(1).state());
      rig.seconds(0.4);
      assertEquals(SessionState.GRACE, rig.room.session(1).state());
      assertEquals(GoodbyeReason.TIMEOUT, client.goodbye.reason());
      assertTrue(other.notices().contains("Ann lost the connection"), "" + other.notices());
      assertSame(body, rig.room.simulation().player(1).entity());
      rig.seconds(29);
      assertSame(body, rig.room.simulation().player(1).entity());
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
      HostEntity body = rig.room.simulation().player(0).entity();
      float y = before.own.y();
      before.link.close("cable pulled");
      rig.steps(2);
      assertEquals(SessionState.GRACE, rig.room.session(0).state());
      rig.seconds(10);
      assertEquals(0, body.body().velocityY(), "neutral while away");
      FakeClient after = rig.join("somebody else", before.welcome.sessionSecret());
      assertSame(body, rig.room.simulation().player(0).entity());
      assertEquals(before.welcome.sessionSecret(), after.welcome.sessionSecret());
      assertEquals(0, after.welcome.epoch(), "a new link");
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
    try (Rig rig = new Rig(CONFIG.with(ServerConfig.GRACE, 2), new TestGame(1))) {
      FakeClient before = rig.join("Ann");
      HostEntity body = rig.room.simulation().player(0).entity();
      before.link.close("cable pulled");
      rig.seconds(1);
      FakeClient after = rig.connect().hello("Ann", before.welcome.sessionSecret());
      after.loads = false;
      rig.seconds(5);
      after.link.send(
          new ClientMessage.Ready(after.welcome.epoch(), after.welcome.declarationsDigest()));
      rig.steps(3);
      assertSame(body, rig.room.simulation().player(0).entity());
      assertEquals(SessionState.PLAYING, rig.room.session(0).state());
    }
  }

  @Test
  void aClientWhoseFieldsDifferFromThoseOfTheNextMatchIsRemoved() {
    try (Rig rig = new Rig()) {
      FakeClient client = rig.join("Ann");
      client.loads = false;
      assertEquals(0, client.welcome.epoch());
      rig.room.simulation().playNext(NextMatch.level(rig.room.match().level().level().name()));
      rig.seconds(5);
      assertEquals(1, client.welcome.epoch(), "the next match");
      assertNull(client.goodbye);
      client.link.send(
          new ClientMessage.Ready(client.welcome.epoch(), client.welcome.declarationsDigest() + 1));
      rig.seconds(1);
      assertEquals(GoodbyeReason.PROTOCOL_ERROR, client.goodbye.reason());
      assertTrue(client.goodbye.text().contains("The fields of your game"));
      assertNull(rig.room.simulation().player(0));
    }
  }

  @Test
  void withoutGraceALostPlayerIsGoneAtOnce() {
    try (Rig rig = new Rig(CONFIG.with(ServerConfig.GRACE, 0), new TestGame(1))) {
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
  void whoIsNewIsToldOfEverybodyAndTheOthersOnlyOfHim() {
    try (Rig rig =
        new Rig(
            CONFIG.with(ServerConfig.MAX_PLAYERS, 4).with(ServerConfig.ROSTER_INTERVAL_MS, 500),
            new TestGame(1))) {
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
}
