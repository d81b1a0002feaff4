package carom.server.metrics;

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
}
