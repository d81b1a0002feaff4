package carom.sim.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import carom.physics.Body;
import carom.sim.scene.catalog.BenchmarkScenes;
import carom.sim.scene.catalog.Scenes;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * In the steady state, once its arrays have grown, a step of any scene allocates nothing.
 *
 * <p>What counts is the best of many windows, as two things allocate now and then that aren't the
 * scene's: arrays that double, and vector kernels until they are compiled. How long the compiler
 * takes depends on the machine, so a window that isn't clean only means that another follows.
 */
class SteadyStepTest {
  private static final int WINDOW = 60;

  /** A tumbler boxed vectors for 14,000 steps while its kernels waited for the compiler. */
  private static final int MOST_WINDOWS = 600;

  /** From this window on each waits a little, as a busy machine may compile nothing meanwhile. */
  private static final int PATIENT = 20;

  private static final long WAIT_MS = 50;

  /** Scenes that make bodies for as long as they run, with what they make. */
  private static final Map<String, String> MAKE_BODIES =
      Map.of("conveyor", "a shape falls onto the belts every 40 ticks");

  /** Scenes that are here in a smaller size. */
  private static final Set<String> LARGE =
      Set.of(
          "large_pyramid",
          "many_pyramids",
          "tumbler",
          "pile_2k",
          "pile_10k",
          "joint_grid",
          "smash",
          "gas_10k",
          "gas_50k");

  static Stream<Scene> scenes() {
    Stream<Scene> sizes =
        Stream.of(
            BenchmarkScenes.pyramid(12),
            BenchmarkScenes.manyPyramids(1, 2),
            BenchmarkScenes.tumbler(9),
            BenchmarkScenes.pile(200, 12, 14),
            BenchmarkScenes.jointGrid(12),
            BenchmarkScenes.smash(12, 8),
            BenchmarkScenes.gas(150),
            BenchmarkScenes.asleep(20_000, 50),
            BenchmarkScenes.water(100));
    Stream<Scene> all = Scenes.all().stream();
    return Stream.concat(sizes, all.filter(scene -> !LARGE.contains(scene.name())))
        .filter(scene -> !MAKE_BODIES.containsKey(scene.name()));
  }

  static Stream<Scene> scenesThatMakeBodies() {
    return MAKE_BODIES.keySet().stream().map(Scenes::get);
  }

  @ParameterizedTest
  @MethodSource("scenes")
  void allocatesNothing(Scene scene) throws InterruptedException {
    var threads = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
    SceneRun run = scene.start();
    long least = Long.MAX_VALUE;
    for (int window = 0; window < MOST_WINDOWS && least != 0; window++) {
      if (window > PATIENT) {
        Thread.sleep(WAIT_MS);
      }
      long before = threads.getCurrentThreadAllocatedBytes();
      run.steps(WINDOW);
      least = Math.min(least, threads.getCurrentThreadAllocatedBytes() - before);
    }
    assertEquals(0, least, "fewest bytes in " + WINDOW + " steps of " + scene.name());
  }

  @ParameterizedTest
  @MethodSource("scenesThatMakeBodies")
  void onlyScenesThatMakeBodiesAreLeftOut(Scene scene) {
    SceneRun run = scene.start();
    run.steps(MOST_WINDOWS);
    List<Body<String>> before = bodies(run);
    run.steps(WINDOW);
    assertNotEquals(before, bodies(run), MAKE_BODIES.get(scene.name()));
  }

  private static List<Body<String>> bodies(SceneRun run) {
    List<Body<String>> all = new ArrayList<>();
    run.world().forEachBody(all::add);
    return all;
  }
}
