package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.bots.Bot;
import carom.fixtures.Crowd;
import carom.net.transport.Impairment;
import carom.suite.Optimized;
import carom.testkit.Stepper;
import java.lang.management.ManagementFactory;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Goal: the tick of a room full of players allocates next to nothing. Method: twenty bots in a game
 * that ships, two of which predict; the bytes the thread allocates in the server's part of each
 * slice, the smallest of several windows, since a goal or a roster in one of them may cost a few
 * objects.
 */
@Optimized("measures what is allocated")
class AllocationScenarioTest {
  private static final int PLAYERS = 20;
  private static final double MAX_BYTES_PER_TICK = 64;
  private static final int WINDOWS = 130;
  private static final double WINDOW_SECONDS = 0.1;

  @ParameterizedTest
  @ValueSource(strings = {"arena", "platformer"})
  void aRoomWithTwentyPlayersAllocatesNextToNothing(String game) {
    var threads = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
    try (Stepper stepper = Stepper.of(game)) {
      for (int i = 0; i < PLAYERS; i++) {
        Crowd.add(stepper, Impairment.NONE.withLatency(20, 0), new Bot(i));
      }
      stepper.run(4);
      double least = Double.MAX_VALUE;
      for (int window = 0; window < WINDOWS && least > MAX_BYTES_PER_TICK; window++) {
        long bytes = 0;
        int firstTick = stepper.frame().tick();
        long endNs = stepper.nowNs() + (long) (WINDOW_SECONDS * 1e9);
        while (stepper.nowNs() < endNs) {
          long before = threads.getCurrentThreadAllocatedBytes();
          stepper.stepTimeAndServer();
          bytes += threads.getCurrentThreadAllocatedBytes() - before;
          stepper.stepClients();
        }
        least = Math.min(least, (double) bytes / (stepper.frame().tick() - firstTick));
      }
      assertTrue(least <= MAX_BYTES_PER_TICK, game + " bytesPerTick=" + least);
    }
  }
}
