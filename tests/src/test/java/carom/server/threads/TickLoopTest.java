package carom.server.threads;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Random;
import org.junit.jupiter.api.Test;

class TickLoopTest {
  private static final long SECOND = 1_000_000_000L;

  @Test
  void firstTickIsDueOnePeriodAfterTheFirstCall() {
    TickLoop loop = new TickLoop(60, 8);
    long start = 12_345;
    assertEquals(0, loop.due(start));
    assertEquals(0, loop.due(start + SECOND / 60));
    assertEquals(start + SECOND / 60 + 1, loop.nextDeadlineNs());
    assertEquals(1, loop.due(start + SECOND / 60 + 1));
    assertEquals(0, loop.due(start + SECOND / 60 + 1));
  }

  @Test
  void waitingForEachDeadlineGivesOneTickEachAndNoDrift() {
    for (int rate : new int[] {10, 59, 60, 61, 144, 240}) {
      TickLoop loop = new TickLoop(rate, 8);
      long start = -5 * SECOND;
      loop.due(start);
      for (int i = 0; i < rate * 3_600; i++) {
        assertEquals(1, loop.due(loop.nextDeadlineNs()), "rate=" + rate + " tick=" + i);
      }
      assertEquals(start + 3_600 * SECOND + SECOND / rate, loop.nextDeadlineNs(), 1.0);
      assertEquals(0, loop.lateTicks());
      assertEquals(0, loop.droppedTicks());
    }
  }

  @Test
  void shortPauseIsMadeGoodInOneBurst() {
    TickLoop loop = new TickLoop(60, 8);
    loop.due(0);
    assertEquals(5, loop.due(SECOND / 12 + 1));
    assertEquals(4, loop.lateTicks());
    assertEquals(0, loop.droppedTicks());
  }

  @Test
  void afterAPauseOnPurposeNothingIsMadeGoodOrDropped() {
    TickLoop loop = new TickLoop(60, 8);
    loop.due(0);
    assertEquals(1, loop.due(SECOND / 60 + 1));
    loop.pause();
    assertEquals(0, loop.due(3_600 * SECOND));
    assertEquals(1, loop.due(3_600 * SECOND + SECOND / 60 + 1));
    assertEquals(0, loop.lateTicks());
    assertEquals(0, loop.droppedTicks());
  }

  @Test
  void longPauseIsCutAndCounted() {
    TickLoop loop = new TickLoop(60, 8);
    loop.due(0);
    assertEquals(8, loop.due(SECOND));
    assertEquals(52, loop.droppedNow());
    assertEquals(52, loop.droppedTicks());
    assertEquals(1, loop.due(SECOND + SECOND / 60 + 1));
    assertEquals(0, loop.droppedNow());
  }

  @Test
  void neverLosesOrInventsATickWhateverTheSteps() {
    long seed = Long.getLong("carom.seed", 42);
    Random random = new Random(seed);
    TickLoop loop = new TickLoop(60, 5);
    long now = 987;
    loop.due(now);
    long start = now;
    long run = 0;
    for (int i = 0; i < 20_000; i++) {
      now += random.nextInt(40_000_000);
      run += loop.due(now);
      long elapsed = now - start;
      assertEquals(elapsed * 60 / SECOND, run + loop.droppedTicks(), "seed=" + seed + " i=" + i);
    }
  }

  @Test
  void survivesYearsOfUptimeAndAClockThatStandsStill() {
    TickLoop loop = new TickLoop(240, 8);
    loop.due(0);
    long twentyYears = 20L * 365 * 86_400 * SECOND;
    assertEquals(8, loop.due(twentyYears));
    assertEquals(0, loop.due(twentyYears));
    assertEquals(0, loop.due(twentyYears - SECOND));
    assertEquals(1, loop.due(twentyYears + SECOND / 240 + 1));
  }

  @Test
  void refusesRatesBelowOne() {
    assertThrows(IllegalArgumentException.class, () -> new TickLoop(0, 8));
    assertThrows(IllegalArgumentException.class, () -> new TickLoop(60, 0));
  }
}
