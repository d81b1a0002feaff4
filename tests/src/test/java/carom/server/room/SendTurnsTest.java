package carom.server.room;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import org.junit.jupiter.api.Test;

final class SendTurnsTest {
  private static final long MS = 1_000_000L;

  /** Each session wants a snapshot in each tick it is due, every {@code interval} ticks. */
  private static int[][] serve(
      SendTurns turns, int sessions, int ticks, int interval, long eachNs) {
    int[] servedAt = new int[sessions];
    Arrays.fill(servedAt, -interval);
    int[] count = new int[sessions];
    int[] perTick = new int[ticks];
    for (int tick = 0; tick < ticks; tick++) {
      turns.begin(sessions, 0);
      long nowNs = 0;
      for (int i = 0; i < sessions; i++) {
        int session = turns.index(i);
        if (tick - servedAt[session] >= interval && turns.take(i, nowNs)) {
          servedAt[session] = tick;
          count[session]++;
          perTick[tick]++;
          nowNs += eachNs;
        }
      }
    }
    return new int[][] {count, perTick};
  }

  @Test
  void halfTheSnapshotsOfAllSessionsLeaveInEachTick() {
    int[][] served = serve(new SendTurns(60, 30), 11, 60, 2, 0);
    for (int count : served[0]) {
      assertTrue(count >= 29, "count=" + count);
    }
    for (int tick = 0; tick < 60; tick++) {
      assertTrue(served[1][tick] <= 6, "tick=" + tick + " served=" + served[1][tick]);
    }
  }

  @Test
  void asManySnapshotsAsTicksServesEverybodyInEach() {
    for (int rate : new int[] {60, 240}) {
      int[][] served = serve(new SendTurns(60, rate), 7, 10, 1, 0);
      for (int count : served[0]) {
        assertEquals(10, count);
      }
    }
    serve(new SendTurns(60, 60), 0, 3, 1, 0);
  }

  @Test
  void aLateTickLeavesTheRestToTheNextOneAndNobodyStarves() {
    // 10.4 ms of 16.7 are for sending, 1 ms each: 11 of 40 per tick
    SendTurns turns = new SendTurns(60, 60);
    int[][] served = serve(turns, 40, 400, 1, MS);
    for (int tick = 0; tick < 400; tick++) {
      assertEquals(11, served[1][tick]);
    }
    for (int count : served[0]) {
      assertTrue(count >= 109 && count <= 111, "count=" + count);
    }
    assertTrue(turns.late() > 0);
  }

  @Test
  void aQuarterIsServedHoweverLateItIs() {
    int[][] served = serve(new SendTurns(60, 60), 40, 40, 1, 100 * MS);
    for (int tick = 0; tick < 40; tick++) {
      assertEquals(10, served[1][tick]);
    }
    for (int count : served[0]) {
      assertEquals(10, count);
    }
  }
}
