package carom.client.prediction;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.interpolation.Pose;
import carom.fixtures.IslandRig;
import carom.suite.Optimized;
import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import org.junit.jupiter.api.Test;

/**
 * Goal: prediction allocates nothing. Method: bytes that the thread allocates while an island of
 * two hundred crates is predicted, confirmed by the server and drawn; no other body comes near. The
 * smallest of many windows counts: until the JIT compiles them, vectors are objects.
 */
@Optimized("measures what is allocated")
class PredictionAllocationTest {
  private static final int WINDOWS = 150;
  private static final int TICKS = 30;

  @Test
  void aSteadyTickAllocatesNothing() {
    IslandRig rig = new IslandRig(200, 1L << 40, () -> 0);
    rig.tellAll();
    rig.server().step();
    rig.client().step(rig.server().tick(), 0);
    assertTrue(rig.tellAll());
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    Pose pose = new Pose();
    long least = Long.MAX_VALUE;
    for (int window = 0; window < WINDOWS && least > 0; window++) {
      long allocated = 0;
      int drawn = 0;
      for (int i = 0; i < TICKS; i++) {
        rig.server().step();
        long before = threads.getCurrentThreadAllocatedBytes();
        rig.client().step(rig.server().tick(), 0);
        boolean agreed = rig.tellOwn();
        rig.client().advance(1 / 60f);
        for (int slot = 0; slot < 200; slot++) {
          drawn += rig.client().readPose(slot, 0, 0.5f, pose) > 0 ? 1 : 0;
        }
        allocated += threads.getCurrentThreadAllocatedBytes() - before;
        assertTrue(agreed, "tick " + rig.server().tick());
      }
      assertTrue(drawn > 190 * TICKS, "drawn=" + drawn);
      least = Math.min(least, allocated);
    }
    assertEquals(0, least, "bytes in " + TICKS + " ticks");
  }
}
