package carom.server.threads;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.server.metrics.Counter;
import carom.server.metrics.Counters;
import org.junit.jupiter.api.Test;

/** Goal: what a room says of its load is true of now. */
final class TickPaceTest {
  private static final long MS = 1_000_000;
  private static final long PERIOD_NS = 20 * MS;

  private final Counters counters = new Counters();
  private final TickPace pace =
      new TickPace(50, 4, new LoadWarnings("room 1: ", counters, 50), counters);

  /**
   * Goal: one long tick slows nobody, however long it was and whenever it came. Method: a loop in
   * virtual time whose ticks take a fifth of their time but for one.
   */
  @Test
  void oneLongTickSlowsNobody() {
    for (int rate : new int[] {5, 10, 20, 30, 50, 60, 120, 240}) {
      for (long longMs : new long[] {100, 500, 1_500, 10_000, 60_000}) {
        for (int at = 3 * rate; at < 4 * rate + 2; at += Math.max(1, rate / 20)) {
          Counters own = new Counters();
          TickPace one = new TickPace(rate, 4, new LoadWarnings("", own, rate), own);
          String what = "rate=" + rate + " ms=" + longMs + " at=" + at;
          long nowNs = 0;
          for (int tick = 0; tick < 40 * rate; nowNs = Math.max(nowNs, one.nextDeadlineNs())) {
            for (int due = one.due(false, tick, nowNs); due > 0; due--, tick++) {
              long tookNs = tick == at ? longMs * MS : 200 * MS / rate;
              one.tickTook(tookNs, tick == at, nowNs);
              nowNs += tookNs;
              assertEquals(100, one.percent(), what);
              assertFalse(one.viewsAreNarrow(), what);
            }
          }
        }
      }
    }
  }

  /** Goal: the load of the last player's ticks doesn't keep the next one out. */
  @Test
  void aPausedRoomHasNoLoad() {
    long nowNs = 0;
    for (int tick = 0; tick < 1_000; tick++, nowNs += PERIOD_NS) {
      pace.due(false, tick, nowNs);
      pace.tickTook(18 * MS, true, nowNs);
    }
    assertEquals(90, counters.get(Counter.LOAD_PERCENT));
    assertTrue(pace.viewsAreNarrow());
    assertEquals(1_000 - 25, counters.get(Counter.TICKS_NARROW), "after half a second");
    pace.due(true, 1_000, nowNs);
    assertEquals(0, counters.get(Counter.LOAD_PERCENT));
    assertFalse(pace.viewsAreNarrow());
  }
}
