package carom.server.replication;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.codec.Quantizer;
import carom.net.snapshot.frame.FrameRing;
import carom.net.snapshot.frame.FrameState;
import carom.physics.Body;
import carom.sim.Role;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.scene.BenchmarkScenes;
import carom.sim.scene.Scene;
import carom.sim.scene.SceneGame;
import carom.suite.Optimized;
import java.lang.management.ManagementFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

@Optimized("measures what is allocated")
class FrameCaptureTest {
  private static SimulationHost pile(int bodies) {
    Scene scene = BenchmarkScenes.pile(bodies, 20, 30);
    return new SimulationHost(
        new SceneGame(scene), SceneGame.level(scene), 1, scene.tickRate(), Role.AUTHORITY);
  }

  /** In one piece, and in pieces that are long enough for vectors. */
  @ParameterizedTest
  @CsvSource({"220, 150", "3500, 20"})
  void everyNumberIsThatOfItsBodyQuantised(int bodies, int ticks) {
    SimulationHost simulation = pile(bodies);
    FrameCapture capture = new FrameCapture(simulation);
    for (int tick = 0; tick < ticks; tick++) {
      simulation.step();
      FrameState frame = capture.capture();
      int seen = 0;
      for (int id = 0; id < simulation.entityCapacity(); id++) {
        HostEntity entity = simulation.entity(id);
        if (entity != null) {
          Body<HostEntity> body = entity.body();
          assertEquals(Quantizer.position(body.x()), frame.x(id));
          assertEquals(Quantizer.position(body.y()), frame.y(id));
          assertEquals(Quantizer.angle(body.angle()), frame.angle(id));
          assertEquals(
              Quantizer.isStill(body.velocityX(), body.velocityY(), body.angularVelocity()),
              frame.still(id));
          seen++;
        }
      }
      assertEquals(seen, frame.count());
    }
  }

  @Test
  void allocatesNothingOnceEveryFrameHasGrown() {
    SimulationHost simulation = pile(220);
    FrameCapture capture = new FrameCapture(simulation);
    for (int tick = 0; tick < FrameRing.SIZE + 10; tick++) {
      simulation.step();
      capture.capture();
    }
    var threads = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
    long least = Long.MAX_VALUE;
    for (int attempt = 0; attempt < 5; attempt++) {
      long bytes = 0;
      for (int tick = 0; tick < FrameRing.SIZE; tick++) {
        simulation.step();
        long before = threads.getCurrentThreadAllocatedBytes();
        capture.capture();
        bytes += threads.getCurrentThreadAllocatedBytes() - before;
      }
      least = Math.min(least, bytes);
    }
    assertTrue(least < 200, "bytes while the ring goes round once: " + least);
  }
}
