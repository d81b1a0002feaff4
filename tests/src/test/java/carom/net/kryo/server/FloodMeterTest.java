package carom.net.kryo.server;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** Goal: floods end and bursts don't count. Method: a clock of numbers. */
final class FloodMeterTest {
  private static final long MS = 1_000_000;

  /** Sends at a rate for a while from a time on, and returns whether that is a flood. */
  private static boolean floods(FloodMeter meter, long startMs, int perSecond, int seconds) {
    boolean flood = false;
    for (int i = 0; i < perSecond * seconds; i++) {
      flood |= meter.count(startMs * MS + i * 1_000L * MS / perSecond);
    }
    return flood;
  }

  @Test
  void tenTimesTheBudgetForTwoSecondsIsAFlood() {
    assertFalse(floods(new FloodMeter(480), 5, 4_800, 60));
    assertTrue(floods(new FloodMeter(480), 5, 5_000, 3));
    assertFalse(floods(new FloodMeter(480), 5, 5_000, 1));
  }

  @Test
  void burstsWithPausesAreNone() {
    FloodMeter meter = new FloodMeter(480);
    for (int i = 0; i < 20; i++) {
      assertFalse(floods(meter, 3_000L * i, 20_000, 1), "burst=" + i);
    }
    assertTrue(floods(meter, 100_000, 20_000, 3));
  }
}
