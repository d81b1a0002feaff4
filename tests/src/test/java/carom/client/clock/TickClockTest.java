package carom.client.clock;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayDeque;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

final class TickClockTest {
  private static final long MS = 1_000_000L;
  private static final int RATE = 60;

  /** A server and a path between, in virtual time: inputs go up, margins come down. */
  private static final class Path {
    final TickClock clock = new TickClock(RATE);
    final SplittableRandom random;
    final ArrayDeque<long[]> up = new ArrayDeque<>(); // arrival, tick
    final ArrayDeque<long[]> down = new ArrayDeque<>(); // arrival, server tick, margin
    double latencyMs;
    double jitterMs;
    double serverRate = RATE;
    double frameMs = 1000.0 / 60;
    long now;
    double serverPosition = 1000;
    int serverTick = 1000;
    int newestInput = -1;
    int late;
    int consumed;
    int lastHandedOut = -1;
    double marginSum;

    Path(long seed, double latencyMs, double jitterMs) {
      random = new SplittableRandom(seed);
      this.latencyMs = latencyMs;
      this.jitterMs = jitterMs;
    }

    long delay() {
      return (long) ((latencyMs + (random.nextDouble() * 2 - 1) * jitterMs) * MS);
    }

    void run(double seconds) {
      long end = now + (long) (seconds * 1e9);
      double nextFrame = now;
      while (now < end) {
        now += MS;
        serverPosition += serverRate * 1e-3;
        up.removeIf(
            m -> {
              if (m[0] <= now) {
                newestInput = Math.max(newestInput, (int) m[1]);
              }
              return m[0] <= now;
            });
        while (serverTick < (int) serverPosition) {
          serverTick++;
          if (newestInput >= 0) {
            consumed++;
            late += newestInput < serverTick ? 1 : 0;
            marginSum += newestInput - serverTick;
          }
          down.add(new long[] {now + delay(), serverTick, newestInput});
        }
        if (now >= nextFrame) {
          nextFrame += frameMs * MS;
          frame();
        }
      }
    }

    void frame() {
      down.removeIf(
          m -> {
            if (m[0] <= now) {
              if (!clock.started()) {
                clock.start(now, (int) m[1], (long) (2 * latencyMs * MS));
              } else if (m[2] >= 0) {
                clock.report((int) m[1], (int) (m[2] - m[1]));
              }
            }
            return m[0] <= now;
          });
      clock.advance(now);
      while (clock.due() > 0) {
        int tick = clock.next();
        assertTrue(tick > lastHandedOut, tick + " was handed out before " + lastHandedOut);
        lastHandedOut = tick;
        up.add(new long[] {now + delay(), tick});
      }
    }

    void forget() {
      late = 0;
      consumed = 0;
      marginSum = 0;
    }
  }

  @Test
  void keepsTheMarginOnACleanPath() {
    for (double latency : new double[] {0, 20, 75, 150}) {
      Path path = new Path(1, latency, 0);
      path.run(5);
      path.forget();
      path.run(10);
      double mean = path.marginSum / path.consumed;
      assertEquals(0, path.late, "late inputs at latency " + latency);
      assertEquals(2.3, mean, 0.9, "mean margin at latency " + latency);
      assertEquals(0, path.clock.jumps(), "jumps at latency " + latency);
    }
  }

  @Test
  void keepsMoreMarginUnderJitter() {
    Path path = new Path(2, 60, 30);
    path.run(6);
    path.forget();
    path.run(20);
    double lateShare = path.late / (double) path.consumed;
    assertTrue(lateShare < 0.01, "late share " + lateShare);
    assertTrue(path.marginSum / path.consumed < 7, "mean margin " + path.marginSum / path.consumed);
  }

  @Test
  void followsAServerThatRunsFasterOrSlower() {
    for (double rate : new double[] {60.3, 59.7}) {
      Path path = new Path(3, 50, 2);
      path.serverRate = rate;
      path.run(8);
      path.forget();
      path.run(20);
      assertTrue(path.late <= path.consumed / 200, "late=" + path.late + " at rate " + rate);
      assertTrue(Math.abs(path.clock.speed() - 1) < 0.02, "speed=" + path.clock.speed());
      assertEquals(0, path.clock.jumps());
    }
  }

  @Test
  void recoversWhenTheRouteBecomesLonger() {
    Path path = new Path(4, 30, 2);
    path.run(5);
    path.latencyMs = 180;
    path.run(2);
    path.forget();
    path.run(5);
    assertTrue(path.late <= 3, "late=" + path.late);
  }

  @Test
  void comesBackWhenTheRouteBecomesShorter() {
    Path path = new Path(5, 200, 2);
    path.run(5);
    path.latencyMs = 20;
    path.run(8);
    path.forget();
    path.run(4);
    assertEquals(2, path.marginSum / path.consumed, 1.5, "mean margin");
  }

  @Test
  void survivesASuspendedMachine() {
    Path path = new Path(6, 40, 1);
    path.run(4);
    path.frameMs = 3_000; // one very long frame
    path.run(3.1);
    path.frameMs = 16;
    path.run(2);
    path.forget();
    path.run(3);
    assertTrue(path.late <= 2, "late=" + path.late);
    assertTrue(path.clock.dropped() > 100, "dropped=" + path.clock.dropped());
  }

  @Test
  void slowMachineGetsABoundedNumberOfTicksPerFrame() {
    TickClock clock = new TickClock(RATE);
    clock.start(0, 100, 0);
    for (int frame = 1; frame < 50; frame++) {
      assertTrue(clock.advance(frame * 400L * MS) <= TickClock.MAX_CATCH_UP);
      while (clock.due() > 0) {
        clock.next();
      }
    }
    assertTrue(clock.dropped() > 500);
  }

  @Test
  void neverHandsOutATickTwiceWhenTheServerStartsAgain() {
    TickClock clock = new TickClock(RATE);
    assertFalse(clock.started());
    assertEquals(0, clock.advance(0));
    clock.start(0, 5_000, 0);
    clock.advance(100 * MS);
    int last = -1;
    while (clock.due() > 0) {
      last = clock.next();
    }
    clock.start(200 * MS, 10, 0);
    assertTrue(clock.tick() < last, "another session, another count");
    assertEquals(1, clock.speed());
  }
}
