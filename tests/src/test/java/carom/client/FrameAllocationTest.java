package carom.client;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.bots.Bot;
import carom.net.kryo.KryoMessageCodec;
import carom.net.transport.InProcessNetwork;
import carom.sim.level.Level;
import carom.suite.Optimized;
import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * Goal: a fast screen makes no garbage between the server's ticks. Method: bytes that the thread
 * allocates in frames in which nothing arrives or is sent, while every entity is interpolated; the
 * smallest of several windows counts, since a class may be loaded in one.
 */
@Optimized("measures what is allocated")
final class FrameAllocationTest {
  private static final int WARM_UP_TICKS = 300;
  private static final int WINDOWS = 60;
  private static final int TICKS = 10;
  private static final int FRAMES_PER_TICK = 4;

  @ParameterizedTest
  @EnumSource(PredictionMode.class)
  void aFrameBetweenTicksAllocatesNothing(PredictionMode mode) throws Exception {
    InProcessNetwork network = new InProcessNetwork(new KryoMessageCodec());
    ScriptedServer server = new ScriptedServer(network.server(), Level.builtIn("arena"));
    GameClient client =
        new GameClient(
            ClientConfig.of("a").withServer("memory", 0, 0).with(ClientConfig.PREDICTION, mode),
            network.client(),
            new Bot(1));
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    long now = 1_000_000;
    for (int i = 0; i < WARM_UP_TICKS; i++) {
      now += ScriptedServer.TICK_NS;
      server.tick(now);
      client.update(now);
    }
    long least = Long.MAX_VALUE;
    for (int window = 0; window < WINDOWS && least > 0; window++) {
      long allocated = 0;
      int frames = 0;
      for (int i = 0; i < TICKS; i++) {
        now += ScriptedServer.TICK_NS;
        server.tick(now);
        client.update(now);
        for (int frame = 1; frame < FRAMES_PER_TICK; frame++) {
          int tick = client.view().tick();
          double drawnAt = client.view().renderTick();
          long before = threads.getCurrentThreadAllocatedBytes();
          client.update(now + frame * ScriptedServer.TICK_NS / FRAMES_PER_TICK);
          int drawn = client.view().entityCount();
          long bytes = threads.getCurrentThreadAllocatedBytes() - before;
          assertTrue(drawn > 20, "drawn=" + drawn);
          assertTrue(client.view().renderTick() > drawnAt, "the picture stands still");
          if (client.view().tick() == tick) {
            allocated += bytes;
            frames++;
          }
        }
      }
      assertTrue(frames >= TICKS, "frames without a tick of the client's=" + frames);
      least = Math.min(least, allocated);
    }
    assertEquals(0, least, "bytes in a window of frames, prediction=" + mode);
  }
}
