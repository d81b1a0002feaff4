package carom.sim.scene;

import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.sim.scene.catalog.BenchmarkScenes;
import java.lang.management.ManagementFactory;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Once its arrays have grown, a step of any of the scenes that are measured allocates nothing. */
class SteadyStepTest {
  private static final int WINDOW = 20;

  /** Arrays that double, and vector kernels until they are compiled, end well before. */
  private static final int MOST_WINDOWS = 150;

  /** From this window on each waits a little, as a busy machine may compile nothing meanwhile. */
  private static final int PATIENT = 50;

  private static final long WAIT_MS = 50;

  static Stream<Scene> scenes() {
    return Stream.of(
        BenchmarkScenes.pyramid(12),
        BenchmarkScenes.manyPyramids(1, 2),
        BenchmarkScenes.tumbler(9),
        BenchmarkScenes.pile(200, 12, 14),
        BenchmarkScenes.jointGrid(12),
        BenchmarkScenes.smash(12, 8),
        BenchmarkScenes.gas(150),
        BenchmarkScenes.asleep(300, 10),
        BenchmarkScenes.water(100));
  }

  @ParameterizedTest
  @MethodSource("scenes")
  void allocatesNothing(Scene scene) throws InterruptedException {
    var threads = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
    SceneRun run = scene.start();
    long bytes = Long.MAX_VALUE;
    for (int window = 0; window < MOST_WINDOWS && bytes != 0; window++) {
      if (window > PATIENT) {
        Thread.sleep(WAIT_MS);
      }
      long before = threads.getCurrentThreadAllocatedBytes();
      for (int i = 0; i < WINDOW; i++) {
        run.step();
      }
      bytes = threads.getCurrentThreadAllocatedBytes() - before;
    }
    assertTrue(bytes == 0, "bytes in the last " + WINDOW + " steps: " + bytes);
  }
}
