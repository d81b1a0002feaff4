package carom.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.simd.VectorModule;
import carom.sim.scene.SceneRun;
import carom.sim.scene.Scenes;
import carom.suite.Optimized;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;

/** Worlds step with the same bits before, while and after kernels are warmed up elsewhere. */
@Optimized("warms vector kernels up")
class KernelWarmupThreadTest {
  private static final boolean HAS_VECTORS = VectorModule.describe().startsWith("vector");
  private static final int STEPS = 40;
  private static final long MOST_MS = 120_000;

  @Test
  void worldsGoOnWithTheSameBitsWhileAThreadWarmsKernelsUp() throws InterruptedException {
    long before = hash();
    KernelWarmupThread warmup = KernelWarmupThread.prepare();
    assertEquals(before, hash(), "without vectors");
    assertEquals(HAS_VECTORS, warmup.isWanted(), "by a world of 2,000 bodies");
    Assumptions.assumeTrue(HAS_VECTORS, VectorModule.describe());
    warmup.begin();
    long begin = System.nanoTime();
    int runs = 0;
    while (!warmup.await(1)) {
      assertEquals(before, hash(), "run " + runs);
      runs++;
      assertTrue(System.nanoTime() - begin < MOST_MS * 1_000_000, "the warm-up ends");
    }
    assertTrue(runs > 0, "a warm-up takes longer than this");
    assertEquals(before, hash(), "with vectors, if there are any");
  }

  @Test
  void aRehearsalBeginsAgainWhenItsPileSleeps() {
    Rehearsal rehearsal = new Rehearsal();
    int steps = 0;
    while (!rehearsal.isAtEnd()) {
      rehearsal.step();
      steps++;
    }
    assertTrue(steps > 100, "steps=" + steps);
    rehearsal.step();
    assertTrue(!rehearsal.isAtEnd());
  }

  /** Returns the state of a pile in which all kernels have work. */
  private static long hash() {
    SceneRun run = Scenes.get("pile_2k").start();
    for (int i = 0; i < STEPS; i++) {
      run.step();
    }
    return run.world().stateHash();
  }
}
