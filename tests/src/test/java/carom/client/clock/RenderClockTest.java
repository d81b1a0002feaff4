package carom.client.clock;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

final class RenderClockTest {
  private static final long MS = 1_000_000L;

  @Test
  void staysTwoIntervalsBehindOnACleanLine() {
    RenderClock clock = new RenderClock(60);
    for (int tick = 0; tick < 600; tick++) {
      long now = (long) (tick * 1e9 / 60);
      clock.snapshot(tick, now, false);
      clock.advance(now);
    }
    assertEquals(2, clock.delayTicks(), 0.05);
    assertEquals(599 - 2, clock.tick(), 0.1);
  }

  @Test
  void learnsTheSendInterval() {
    RenderClock clock = new RenderClock(60);
    for (int tick = 0; tick < 600; tick += 3) {
      clock.snapshot(tick, (long) (tick * 1e9 / 60), false);
    }
    assertEquals(3, clock.intervalTicks());
    assertEquals(6, clock.delayTicks(), 0.1);
  }

  @Test
  void aQuietServerIsNotASlowOne() {
    RenderClock clock = new RenderClock(60);
    for (int tick = 0; tick < 1_200; tick += 12) {
      clock.snapshot(tick, (long) (tick * 1e9 / 60), true);
    }
    assertEquals(1, clock.intervalTicks());
    assertEquals(2, clock.delayTicks(), 0.1);
  }

  @Test
  void waitsLongerUnderJitterAndLossAndNeverGoesBack() {
    SplittableRandom random = new SplittableRandom(7);
    RenderClock clock = new RenderClock(60);
    clock.loss(0.02);
    double last = -1e9;
    int starved = 0;
    int frames = 0;
    long[] arrival = new long[1_200];
    for (int tick = 0; tick < arrival.length; tick++) {
      arrival[tick] = (long) (tick * 1e9 / 60 + (50 + 20 * (2 * random.nextDouble() - 1)) * MS);
    }
    boolean[] taken = new boolean[arrival.length];
    int newest = -1;
    for (long now = 0; now < 19_000L * MS; now += 8 * MS) {
      for (int tick = 0; tick < arrival.length; tick++) {
        if (!taken[tick] && arrival[tick] <= now) {
          taken[tick] = true;
          if (tick > newest) {
            newest = tick;
            clock.snapshot(tick, now, false);
          }
        }
      }
      clock.advance(now);
      if (now > 3_000L * MS) {
        assertTrue(clock.tick() >= last, clock.tick() + " after " + last);
        frames++;
        starved += clock.tick() > newest ? 1 : 0;
      }
      last = clock.tick();
    }
    assertTrue(clock.delayTicks() > 3, "delay=" + clock.delayTicks());
    assertTrue(starved < frames / 100, "starved in " + starved + " of " + frames + " frames");
  }

  @Test
  void waitsAsLongAsBurstsOfLossesAre() {
    // Goal: most frames lie between two snapshots also where three in ten get lost, ten in a row.
    SplittableRandom random = new SplittableRandom(11);
    RenderClock clock = new RenderClock(60);
    int newest = 0;
    int starved = 0;
    boolean burst = false;
    for (int tick = 0; tick < 3_600; tick++) {
      burst = burst ? random.nextInt(10) > 0 : random.nextInt(70) < 3;
      long now = (long) (tick * 1e9 / 60);
      if (!burst) {
        newest = tick;
        clock.loss(0.3);
        clock.snapshot(tick, now, false);
      }
      clock.advance(now);
      starved += tick > 1_200 && clock.tick() > newest ? 1 : 0;
    }
    assertTrue(clock.delayTicks() > 12, "delay=" + clock.delayTicks());
    assertTrue(starved < 2_400 / 10, "starved in " + starved + " of 2400 frames");
  }

  @Test
  void startsAnewAfterABlackout() {
    RenderClock clock = new RenderClock(60);
    for (int tick = 0; tick < 120; tick++) {
      clock.snapshot(tick, (long) (tick * 1e9 / 60), false);
      clock.advance((long) (tick * 1e9 / 60));
    }
    long gap = 30_000L * MS; // the server stood still meanwhile
    for (int tick = 120; tick < 240; tick++) {
      long now = gap + (long) (tick * 1e9 / 60);
      clock.snapshot(tick, now, false);
      clock.advance(now);
    }
    assertEquals(239 - clock.delayTicks(), clock.tick(), 1);
  }
}
