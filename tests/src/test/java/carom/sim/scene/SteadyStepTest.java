package carom.sim.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import carom.fixtures.Allocations;
import carom.physics.Body;
import carom.suite.Optimized;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * In the steady state a step of any scene allocates nothing, also with vector kernels once these
 * are compiled. {@link SteadySceneTest} counts each step of the same scenes without them.
 */
@Optimized("needs compiled vector kernels")
class SteadyStepTest {
  private static final int WINDOW = 60;

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

  static boolean makesBodies(Scene scene) {
    return MAKE_BODIES.containsKey(scene.name());
  }

  @ParameterizedTest
  @MethodSource("scenes")
  void allocatesNothing(Scene scene) throws InterruptedException {
    SceneRun run = scene.start();
    long least = Allocations.leastOnceCompiled(1, () -> run.steps(WINDOW));
    assertEquals(0, least, "fewest bytes in " + WINDOW + " steps of " + scene.name());
  }

  @ParameterizedTest
  @MethodSource("scenesThatMakeBodies")
  void onlyScenesThatMakeBodiesAreLeftOut(Scene scene) {
    SceneRun run = scene.start();
    run.steps(600);
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
