package carom.server.metrics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class LogIntervalTest {
  @Test
  void letsALineThroughEveryTenSeconds() {
    for (long start : new long[] {0, -5, Long.MAX_VALUE - 3}) {
      LogInterval interval = new LogInterval();
      assertTrue(interval.tryBegin(start));
      assertFalse(interval.tryBegin(start));
      assertFalse(interval.tryBegin(start + LogInterval.LENGTH_NS - 1));
      assertTrue(interval.tryBegin(start + LogInterval.LENGTH_NS));
      assertFalse(interval.tryBegin(start + LogInterval.LENGTH_NS + 1));
      assertTrue(interval.tryBegin(start + 10 * LogInterval.LENGTH_NS));
    }
  }

  @Test
  void whatLastsIsToldOnceAMinuteAtLastAndAtOnceAfterASilence() {
    LogInterval interval = new LogInterval();
    int lines = 0;
    long tickNs = LogInterval.LENGTH_NS / 100;
    long nowNs = 0;
    for (; nowNs < 10 * LogInterval.MAX_LENGTH_NS; nowNs += tickNs) {
      lines += interval.tryBegin(nowNs) ? 1 : 0;
    }
    // After 0, 10, 30, 70 s, and then each minute.
    assertEquals(3 + 9, lines);
    nowNs += LogInterval.LENGTH_NS;
    assertTrue(interval.tryBegin(nowNs), "a silence ends the long interval");
    assertFalse(interval.tryBegin(nowNs + LogInterval.LENGTH_NS / 2));
    assertTrue(interval.tryBegin(nowNs + LogInterval.LENGTH_NS));
  }
}
