package carom.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.server.room.Picture;
import java.nio.file.Path;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: an idle room costs next to nothing, and nobody can tell that it paused. Method: a server
 * and its clients in virtual time.
 */
class IdleTest {
  private static final ServerConfig PAUSES =
      ServerConfig.defaults()
          .with(ServerConfig.IDLE, ServerConfig.Idle.PAUSE)
          .with(ServerConfig.GRACE, 1);

  @Test
  void aRoomWithoutPlayersPausesAfterItsFirstTick() {
    try (Rig rig = new Rig(PAUSES, new TestGame(3))) {
      rig.seconds(10);
      assertEquals(1, rig.room.tick());
      assertTrue(rig.room.isPaused());
      assertFalse(rig.room.hasFailed());
    }
  }

  @Test
  void aJoinerWakesTheRoomWhichDoesNotCatchUp() {
    try (Rig rig = new Rig(PAUSES, new TestGame(3))) {
      rig.seconds(3_600);
      FakeClient client = rig.join("Ann");
      assertFalse(rig.room.isPaused());
      assertTrue(rig.room.tick() < 60, "tick " + rig.room.tick());
      assertEquals(0, rig.count(Counter.TICKS_DROPPED));
      assertEquals(0, rig.count(Counter.TICKS_LATE));
      int before = rig.room.tick();
      rig.seconds(1);
      assertEquals(before + 60, rig.room.tick(), 1);
      assertTrue(client.decoder.hasAck());
    }
  }

  @Test
  void aRoomPausesAgainWhenTheLastPlayerCanNoLongerComeBack() {
    try (Rig rig = new Rig(PAUSES, new TestGame(3))) {
      FakeClient client = rig.join("Ann");
      client.link.close("the test");
      rig.seconds(0.5);
      assertFalse(rig.room.isPaused(), "the body waits for its player");
      rig.seconds(2);
      assertTrue(rig.room.isPaused());
      int tick = rig.room.tick();
      rig.seconds(60);
      assertEquals(tick, rig.room.tick());
      rig.join("Bob");
      assertEquals(0, rig.count(Counter.TICKS_DROPPED));
    }
  }

  @Test
  void thePausedRoomsThreadNapsUntilSomebodyNeedsIt() throws Exception {
    try (Rig rig = new Rig(PAUSES, new TestGame(3))) {
      RoomDuty duty = new RoomDuty(rig.room);
      AtomicInteger calls = new AtomicInteger();
      rig.room.onNeeded(calls::incrementAndGet);
      rig.seconds(1);
      assertEquals(Long.MAX_VALUE, duty.napNs(rig.nowNs));
      assertFalse(duty.hasLinks(), "nothing can come");
      assertEquals(0, calls.get());

      rig.room.pictures().ask(new Picture.Request(false, false, false, Set.of()));
      assertEquals(1, calls.get(), "somebody wants to see it");
      Future<Integer> said = CompletableFuture.supplyAsync(() -> rig.room.operator().say("hello"));
      while (!said.isDone()) {
        rig.seconds(0.1);
      }
      assertEquals(2, calls.get(), "an operator asks");

      rig.join("Ann");
      assertEquals(3, calls.get(), "a player comes");
      assertTrue(duty.napNs(rig.nowNs) < 20_000_000, "ticks are due");
      assertTrue(duty.hasLinks(), "messages may come between them");
      rig.room.pictures().ask(new Picture.Request(false, false, false, Set.of()));
      assertEquals(3, calls.get(), "a room that ticks looks itself");
    }
  }

  @Test
  void aRecordedRoomRunsOn(@TempDir Path folder) throws Exception {
    try (Rig rig = new Rig(PAUSES, new TestGame(3))) {
      rig.server.record(folder.resolve("game.carom"));
      rig.seconds(1);
      assertFalse(rig.room.isPaused());
      assertEquals(60, rig.room.tick(), 1);
    }
  }

  @Test
  void aRoomThatMayBeWatchedPausesUntilSomebodyWatches() throws Exception {
    try (Rig rig = new Rig(PAUSES, new TestGame(3))) {
      rig.server.allowSpectators(1);
      rig.seconds(10);
      assertTrue(rig.room.isPaused());
      int tick = rig.room.tick();
      int[] woken = {0};
      rig.room.onNeeded(() -> woken[0]++);
      rig.room.watchedBy(1);
      assertEquals(1, woken[0], "its thread may sleep");
      rig.seconds(1);
      assertFalse(rig.room.isPaused());
      assertEquals(tick + 60, rig.room.tick(), 1);
      rig.room.watchedBy(0);
      rig.seconds(1);
      assertTrue(rig.room.isPaused());
    }
  }

  @Test
  void roomsRunOnUnlessToldToPause() {
    try (Rig rig =
        new Rig(PAUSES.with(ServerConfig.IDLE, ServerConfig.Idle.RUN), new TestGame(3))) {
      rig.seconds(1);
      assertEquals(60, rig.room.tick(), 1);
      assertFalse(rig.room.isPaused());
    }
  }
}
