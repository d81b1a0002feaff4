package carom.server;

import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.server.config.ServerConfig;
import carom.suite.Optimized;
import java.lang.management.ManagementFactory;
import org.junit.jupiter.api.Test;

/**
 * Goal: the server's tick with active players allocates next to nothing. Method: the bytes that the
 * thread allocates, without the clients' part; warm-up first, then the smallest of several windows,
 * so that a roster or a growing array in one of them doesn't count.
 */
@Optimized("measures what is allocated")
class AllocationTest {
  private static final int PLAYERS = 20;
  private static final int WINDOW_TICKS = 120;
  private static final long MAX_BYTES_PER_TICK = 64;

  @Test
  void steadyTickAllocatesNextToNothing() {
    com.sun.management.ThreadMXBean threads =
        (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
    try (Rig rig = new Rig(ServerConfig.defaults(), new TestGame(60))) {
      for (int i = 0; i < PLAYERS; i++) {
        rig.join("p" + i).input.move(i % 2, 1 - i % 2);
      }
      rig.seconds(20);
      long least = Long.MAX_VALUE;
      for (int window = 0; window < 5; window++) {
        long bytes = 0;
        for (int i = 0; i < WINDOW_TICKS; i++) {
          rig.nowNs += Rig.TICK_NS;
          for (FakeClient client : rig.clients) {
            client.step(rig.room.tick());
          }
          long before = threads.getCurrentThreadAllocatedBytes();
          rig.server.tick(rig.nowNs);
          bytes += threads.getCurrentThreadAllocatedBytes() - before;
        }
        least = Math.min(least, bytes);
      }
      long perTick = least / WINDOW_TICKS;
      assertTrue(perTick <= MAX_BYTES_PER_TICK, "bytesPerTick=" + perTick + " players=" + PLAYERS);
    }
  }
}
