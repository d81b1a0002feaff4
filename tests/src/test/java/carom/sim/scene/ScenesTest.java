package carom.sim.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.suite.Optimized;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Every scene of the library runs, and runs the same way again. */
@Optimized("computes for long")
public final class ScenesTest {
  private static final int TICKS = 60;

  /** Larger ones are covered by their small variants. */
  public static Stream<Scene> scenes() {
    List<Scene> small =
        List.of(
            BenchmarkScenes.pyramid(12),
            BenchmarkScenes.manyPyramids(2, 3),
            BenchmarkScenes.tumbler(12),
            BenchmarkScenes.pile(200, 20, 18),
            BenchmarkScenes.jointGrid(16),
            BenchmarkScenes.smash(12, 10),
            BenchmarkScenes.gas(200));
    List<String> benchmark =
        List.of(
            "large_pyramid",
            "many_pyramids",
            "tumbler",
            "pile_2k",
            "pile_10k",
            "joint_grid",
            "smash",
            "gas_1k",
            "gas_10k",
            "gas_50k");
    return Stream.concat(
        small.stream(), Scenes.all().stream().filter(s -> !benchmark.contains(s.name())));
  }

  @ParameterizedTest
  @MethodSource("scenes")
  void aSceneRunsTwiceTheSameWayAndFromASavedState(Scene scene) {
    SceneRun one = scene.start();
    SceneRun two = scene.start();
    assertEquals(one.stateHash(), two.stateHash(), scene.name());
    one.steps(TICKS / 2);
    two.steps(TICKS / 2);
    SceneState middle = one.save(null);
    one.steps(TICKS / 2);
    two.steps(TICKS / 2);
    long end = one.stateHash();
    assertEquals(end, two.stateHash(), scene.name());
    one.restore(middle);
    one.steps(TICKS / 2);
    assertEquals(end, one.stateHash(), scene.name() + " after it was restored");
    assertEquals(TICKS, one.tick());

    SceneReport report = SceneReport.of(one.world());
    assertEquals(0, report.nanCount(), scene.name());
    assertTrue(report.maxCoordinate() < 500, () -> scene.name() + " " + report);
    assertTrue(report.worstJointGap() < 0.25f, () -> scene.name() + " " + report);
  }

  @Test
  void scenesAreSortedAndFoundByName() {
    List<String> names = Scenes.names();
    assertEquals(names.stream().sorted().toList(), names);
    assertEquals(names, Scenes.all().stream().map(Scene::name).toList());
    assertSame(Scenes.get("bridge"), Scenes.get("bridge"));
    for (Scene scene : Scenes.all()) {
      assertTrue(
          scene.description().length() < 90 && !scene.description().contains("\n"), scene.name());
    }
  }

  @Test
  void anUnknownNameIsAnsweredWithTheNearest() {
    String message =
        assertThrows(IllegalArgumentException.class, () -> Scenes.get("brigde")).getMessage();
    assertEquals("unknown scene=brigde; did you mean \"bridge\"?", message);
  }
}
