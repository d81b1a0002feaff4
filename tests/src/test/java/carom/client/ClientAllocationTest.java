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
  private static final int WARM_UP_FRAMES = 3_000;
  private static final int FRAMES = 1_000;
  private static final int WINDOWS = 3;

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
      long allocated = 0;
      long least = Long.MAX_VALUE; // what the JIT compiler isn't done with yet doesn't count
      for (int frame = 0; frame < WARM_UP_FRAMES + WINDOWS * FRAMES; frame++) {
        now += ScriptedServer.TICK_NS;
        server.tick(now);
        long before = threads.getCurrentThreadAllocatedBytes();
        client.update(now);
        int drawn = client.view().entityCount();
        if (frame >= WARM_UP_FRAMES) {
          allocated += threads.getCurrentThreadAllocatedBytes() - before;
          assertTrue(drawn > 20, "drawn=" + drawn);
        }
        if (frame >= WARM_UP_FRAMES && (frame + 1 - WARM_UP_FRAMES) % FRAMES == 0) {
          least = Math.min(least, allocated / FRAMES);
          allocated = 0;
        }
      }
      // Notices and rosters are objects. A body that comes near gets a mirror with a history of its
      // own, about 4 KiB, now and then.
      long limit = mode == PredictionMode.NONE ? 256 : 1_024;
      assertTrue(
          least <= limit, "bytes per frame=" + least + " limit=" + limit + " prediction=" + mode);
    }
  }
}
