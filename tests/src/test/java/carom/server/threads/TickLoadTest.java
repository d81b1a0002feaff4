package carom.server.threads;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** Goal: time slows down as much as a slow machine needs, and no more. */
class TickLoadTest {
  private static final long MS = 1_000_000L;

  private final TickLoad load = new TickLoad(50); // 20 ms each

  private void ticks(int count, long tookNs) {
    for (int i = 0; i < count; i++) {
      load.tickTook(tookNs, false);
    }
  }

  @Test
  void theLoadIsThe95thPercentileOfTenSeconds() {
    assertEquals(500, TickLoad.ticksUntilKnown(50));
    assertEquals(0, load.percent(), "no tick yet");
    ticks(1, 20 * MS);
    assertEquals(100, load.percent(), "of the ticks that there are");
    ticks(18, 10 * MS);
    assertEquals(100, load.percent(), "1 of 19 is more than 5 of 100");
    ticks(1, 10 * MS);
    assertEquals(50, load.percent(), "1 of 20 isn't");
    ticks(480, 10 * MS);
    assertEquals(50, load.percent());
    ticks(24, 40 * MS);
    assertEquals(50, load.percent(), "24 of 500 ticks");
    ticks(10, 40 * MS);
    assertEquals(200, load.percent());
    ticks(500, MS);
    assertEquals(6, load.percent(), "in steps of two percent, rounded up");
    ticks(500, 1_000 * MS);
    assertEquals(300, load.percent());
  }

  @Test
  void aRoomThatRestsHasNoLoadUntilItIsBusyAgain() {
    ticks(1_000, 18 * MS);
    assertEquals(90, load.percent());
    load.rest();
    assertEquals(0, load.percent());
    ticks(25, 18 * MS);
    assertEquals(0, load.percent(), "25 of 500 ticks");
    ticks(1, 18 * MS);
    assertEquals(90, load.percent());
    ticks(2_000, 2 * MS);
    assertEquals(10, load.percent(), "nothing else is left of the rest");
  }

  @Test
  void ticksThatTakeLongerThanTheirPeriodSlowTimeDownUntilTheyFit() {
    ticks(25, 30 * MS);
    assertEquals(55, load.pacePercent(), "36.4 ms a tick, of which 30 are used");
    ticks(1_000, 30 * MS);
    assertEquals(55, load.pacePercent(), "it stays");
    ticks(25, 15 * MS);
    assertEquals(60, load.pacePercent(), "one step each half second");
    ticks(1_000, 5 * MS);
    assertEquals(100, load.pacePercent());
    ticks(25, 10_000 * MS);
    assertEquals(TickLoad.SLOWEST_PERCENT, load.pacePercent());
  }

  @Test
  void twoLongTicksInHalfASecondAreALoad() {
    ticks(23, 2 * MS);
    ticks(2, 1_000 * MS);
    assertTrue(load.pacePercent() < 50, "pace=" + load.pacePercent());
  }

  /** Runs half a second in which so many of the 25 ticks leave snapshots for the next one. */
  private void halfSecond(long tookNs, int late) {
    for (int i = 0; i < 25; i++) {
      load.tickTook(tookNs, i < late);
    }
  }

  @Test
  void viewsBecomeNarrowWhenSnapshotsWaitInHalfOfTheTicks() {
    for (int i = 0; i < 100; i++) {
      halfSecond(13 * MS, 12);
    }
    assertFalse(load.viewsAreNarrow());
    halfSecond(13 * MS, 13);
    assertTrue(load.viewsAreNarrow());
    assertEquals(100, load.pacePercent());
  }

  @Test
  void timeSlowsDownOnlyWhenNarrowViewsAreNotEnough() {
    halfSecond(30 * MS, 25);
    assertTrue(load.viewsAreNarrow());
    assertEquals(100, load.pacePercent());
    halfSecond(30 * MS, 25);
    assertEquals(55, load.pacePercent());
    for (int i = 0; i < 9; i++) {
      halfSecond(2 * MS, 0);
      assertEquals(60 + 5 * i, load.pacePercent());
    }
    for (int i = 0; i < 20; i++) {
      assertTrue(load.viewsAreNarrow(), "i=" + i);
      halfSecond(2 * MS, 0);
    }
    assertFalse(load.viewsAreNarrow(), "time at full pace first, then the views");
  }

  @Test
  void viewsWidenAfterTenCalmSecondsAndLaterWhereThatProvesTooEarly() {
    int calm = 20;
    for (int time = 0; time < 8; time++) {
      halfSecond(13 * MS, 25);
      assertTrue(load.viewsAreNarrow());
      for (int i = 1; i < calm; i++) {
        halfSecond(11 * MS, 2);
      }
      halfSecond(11 * MS, 3); // one in ten or more, which isn't calm
      for (int i = 1; i < calm; i++) {
        halfSecond(11 * MS, i % 3);
      }
      assertTrue(load.viewsAreNarrow(), "time=" + time);
      halfSecond(11 * MS, 0);
      assertFalse(load.viewsAreNarrow(), "time=" + time);
      calm = Math.min(640, 2 * calm); // five minutes and a third
    }
    halfSecond(13 * MS, 25);
    load.rest();
    assertFalse(load.viewsAreNarrow(), "nobody plays");
    halfSecond(13 * MS, 25);
    for (int i = 0; i < 20; i++) {
      halfSecond(11 * MS, 0);
    }
    assertFalse(load.viewsAreNarrow(), "as at the beginning");
  }

  @Test
  void aSlowLoopHandsOutFewerTicksAndNoBurst() {
    TickLoop loop = new TickLoop(50, 15);
    long start = 1_000 * MS;
    loop.due(start);
    loop.pace(60, start + 500 * MS);
    int ticks = 0;
    for (long now = 501; now <= 10_500; now++) {
      int due = loop.due(start + now * MS);
      assertTrue(due <= 1, "due=" + due);
      ticks += due;
    }
    assertEquals(300, ticks, 1, "30 a second");
    assertEquals(0, loop.droppedTicks());
  }
}
