package carom.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.game.Games;
import carom.sim.Role;
import carom.sim.SimulationHost;
import carom.sim.entity.EntityHit;
import carom.sim.entity.HostPlayer;
import carom.sim.entity.Input;
import carom.sim.level.Level;
import carom.suite.Optimized;
import java.lang.management.ManagementFactory;
import java.util.Random;
import org.junit.jupiter.api.Test;

/**
 * Goal: recording a tick, and asking what a player saw, allocate nothing. Method: the thread's own
 * count of bytes, after warm-up, the smallest of several windows.
 */
@Optimized("measures what is allocated")
final class RecordingCostTest {
  private static final int WINDOWS = 6;
  private static final int WINDOW_TICKS = 120;

  private final com.sun.management.ThreadMXBean threads =
      (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();

  private interface Turn {
    void run(int tick);
  }

  private long leastBytes(Turn turn) {
    for (int i = 0; i < 1_000; i++) {
      turn.run(i);
    }
    long least = Long.MAX_VALUE;
    for (int window = 0; window < WINDOWS; window++) {
      long before = threads.getCurrentThreadAllocatedBytes();
      for (int i = 0; i < WINDOW_TICKS; i++) {
        turn.run(1_000 + window * WINDOW_TICKS + i);
      }
      least = Math.min(least, threads.getCurrentThreadAllocatedBytes() - before);
    }
    return least;
  }

  private static SimulationHost start() throws Exception {
    return new SimulationHost(Games.create("arena"), Level.builtIn("arena"), 7, 60, Role.AUTHORITY);
  }

  @Test
  void aRecordedTickAllocatesNothing() throws Exception {
    SimulationHost s = start();
    byte[] disk = new byte[Block.MAX_BYTES];
    long[] taken = {0};
    Recorder recorder =
        new Recorder(
            s,
            RecordingHeader.of(s, 7, 99),
            (type, bytes, length) -> {
              System.arraycopy(bytes, 0, disk, 0, length);
              taken[0] += length;
              return true;
            });
    s.addJournal(recorder);
    for (int i = 0; i < 12; i++) {
      s.join("p" + i);
    }
    long bytes =
        leastBytes(
            tick -> {
              for (int id = 0; id < 12; id++) {
                HostPlayer p = s.player(id);
                p.input().move((tick / 7 + id) % 3 - 1, (tick / 11 + id) % 3 - 1);
                p.viewDelay(100 + tick % 5);
              }
              recorder.stepping(s); // without the step itself, in which bodies come and go
              recorder.stepped(s);
            });
    assertTrue(taken[0] > 10_000);
    assertEquals(0, bytes);
  }

  @Test
  void lookingBackAllocatesNothing() throws Exception {
    SimulationHost s = start();
    for (int i = 0; i < 12; i++) {
      s.join("p" + i).input().hold(Input.ACTION, i % 2 == 0).move(1, i % 3 - 1);
    }
    for (int tick = 0; tick < 60; tick++) {
      s.step();
    }
    Random random = new Random(1);
    EntityHit hit = new EntityHit();
    int[] hits = {0};
    long bytes =
        leastBytes(
            tick -> {
              HostPlayer p = s.player(tick % 12);
              p.viewDelay(random.nextInt(240));
              float x = random.nextFloat() * 20 - 10;
              float y = random.nextFloat() * 10 - 5;
              if (s.asSeenBy(p).rayClosest(x, y, -2 * x, -2 * y, null, hit)) {
                hits[0]++;
              }
              s.asSeenBy(p).nearest(x, y, 2, null, hit);
            });
    assertTrue(hits[0] > 100);
    assertEquals(0, bytes);
  }
}
