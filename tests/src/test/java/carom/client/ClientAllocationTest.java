package carom.client;

import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.bots.Bot;
import carom.net.kryo.KryoMessageCodec;
import carom.net.transport.InProcessNetwork;
import carom.sim.level.Level;
import carom.suite.Optimized;
import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import org.junit.jupiter.api.Test;

/**
 * Goal: a frame of a client allocates next to nothing, so that a hundred bots in a process are
 * cheap.
 */
@Optimized("measures what is allocated")
final class ClientAllocationTest {
  private static final int WARM_UP_FRAMES = 3_000; // up to 9,000 where compiler threads starve
  private static final int FRAMES = 3_000;

  @Test
  void aSteadyFrameAllocatesNextToNothing() throws Exception {
    for (PredictionMode mode : PredictionMode.values()) {
      InProcessNetwork network = new InProcessNetwork(new KryoMessageCodec());
      ScriptedServer server = new ScriptedServer(network.server(), Level.builtIn("arena"));
      GameClient client =
          new GameClient(
              ClientConfig.of("a").withServer("memory", 0, 0).with(ClientConfig.PREDICTION, mode),
              network.client(),
              new Bot(1));
      ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
      long now = 1_000_000;
      // Notices and rosters are objects. A body that comes near gets a mirror with a history of its
      // own, about 4 KiB, now and then.
      final long limit = mode == PredictionMode.NONE ? 256 : 1_024;
      long allocated = 0;
      int counted = 0;
      for (int frame = 0; counted < FRAMES; frame++) {
        now += ScriptedServer.TICK_NS;
        server.tick(now);
        long before = threads.getCurrentThreadAllocatedBytes();
        client.update(now);
        int drawn = client.view().entityCount();
        if (frame >= WARM_UP_FRAMES) {
          allocated += threads.getCurrentThreadAllocatedBytes() - before;
          assertTrue(drawn > 20, "drawn=" + drawn);
          counted++;
          if (allocated > limit * FRAMES && frame < 3 * WARM_UP_FRAMES) {
            allocated = 0; // its code isn't compiled yet: counts anew
            counted = 0;
          }
        }
      }
      assertTrue(
          allocated / FRAMES <= limit,
          "bytes per frame=" + allocated / FRAMES + " limit=" + limit + " prediction=" + mode);
    }
  }
}
