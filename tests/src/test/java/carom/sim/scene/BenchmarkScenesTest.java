package carom.sim.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.Body;
import carom.physics.BodyType;
import carom.physics.World;
import carom.suite.Optimized;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;

/** The scenes that all engines are measured on have the bodies that their specification says. */
@Optimized("computes for long")
final class BenchmarkScenesTest {
  /** Dynamic bodies and joints. */
  private static final Map<String, int[]> SIZES = new TreeMap<>();

  static {
    SIZES.put("large_pyramid", new int[] {5050, 0});
    SIZES.put("many_pyramids", new int[] {22_000, 0});
    SIZES.put("tumbler", new int[] {2025, 0});
    SIZES.put("pile_2k", new int[] {2000, 0});
    SIZES.put("pile_10k", new int[] {10_000, 0});
    SIZES.put("pile_polygons", new int[] {2000, 0});
    SIZES.put("pile_compounds", new int[] {1500, 0});
    SIZES.put("pile_mixed", new int[] {2000, 0});
    SIZES.put("joint_grid", new int[] {9993, 19_800});
    SIZES.put("smash", new int[] {9601, 0});
    SIZES.put("gas_1k", new int[] {1000, 0});
    SIZES.put("gas_10k", new int[] {10_000, 0});
    SIZES.put("gas_50k", new int[] {50_000, 0});
  }

  @Test
  void theyHaveTheirSizes() {
    SIZES.forEach(
        (name, size) -> {
          SceneRun run = Scenes.get(name).start();
          int[] dynamic = new int[1];
          run.world().forEachBody(b -> dynamic[0] += b.type() == BodyType.DYNAMIC ? 1 : 0);
          assertEquals(size[0], dynamic[0], name);
          assertEquals(size[1], run.world().jointCount(), name);
          assertFalse(run.world().def().sleeping(), name);
          assertFalse(run.world().def().continuous(), name);
        });
  }

  @Test
  void theirNumbersAreThoseOfTheSpecification() {
    World<String> pyramid = Scenes.get("large_pyramid").start().world();
    assertEquals(-49.5f, pyramid.body(1).x());
    assertEquals(0.5f, pyramid.body(1).y());
    Body<String> top = pyramid.body(5050);
    assertEquals(0, top.x());
    assertEquals(99.5f, top.y());

    World<String> smash = Scenes.get("smash").start().world();
    assertEquals(512, smash.body(0).mass());
    assertEquals((float) (0.4 * 119 + 30), smash.body(9600).x());
    assertEquals((float) (0.4 * 39), smash.body(9600).y());

    World<String> net = Scenes.get("joint_grid").start().world();
    int held = 0;
    for (int k = 0; k < 100; k++) {
      boolean fixed = net.body(k * 100).type() == BodyType.STATIC;
      assertEquals(k >= 47 && k <= 53, fixed, "k=" + k);
      held += fixed ? 1 : 0;
    }
    assertEquals(7, held);

    World<String> tumbler = Scenes.get("tumbler").start().world();
    assertEquals(0.43633231f, tumbler.body(0).angularVelocity());
    assertEquals((float) (-9 + 0.4 * 44), tumbler.body(45).x());
  }

  @Test
  void theGasHasTheEnergyThatOtherEnginesStartWith() {
    SceneReport report = SceneReport.of(Scenes.get("gas_10k").start().world());
    assertEquals(12_250, report.kineticEnergy(), 250, report::toString);
    assertEquals(0, report.overlaps(), report::toString);
    assertTrue(report.topSpeed() <= 5.0001f, report::toString);
  }

  @Test
  void littleOverlapsAtTheStart() {
    SIZES.forEach(
        (name, size) -> {
          SceneReport r = SceneReport.of(Scenes.get(name).start().world());
          assertEquals(0, r.nanCount(), name);
          // Two planks of a pile may be drawn next to each other and end to end.
          float allowed = name.startsWith("pile") ? 0.07f : 1e-4f;
          assertTrue(r.maxDepth() < allowed, () -> name + " " + r);
          assertEquals(0, r.worstJointGap(), name);
        });
  }

  @Test
  void aReportFindsWhatIsWrong() {
    SceneRun run = BenchmarkScenes.pyramid(3).start();
    assertEquals(0, SceneReport.of(run.world()).deepOverlaps());
    Body<String> top = run.world().body(6);
    top.setPose(top.x(), top.y() - 0.25f, 0);
    top.setVelocity(3, 4);
    SceneReport report = SceneReport.of(run.world());
    assertEquals(2, report.deepOverlaps(), report::toString);
    assertEquals(0.25f, report.maxDepth(), 1e-5f);
    assertEquals(5, report.topSpeed());
    assertEquals(12.5, report.kineticEnergy(), 1e-4);
    assertEquals(0.5f, report.lowestY());
  }

  @Test
  void aPileIsSoundWhenItHasFallen() {
    SceneRun run = BenchmarkScenes.pile(200, 20, 18).start();
    run.steps(300);
    SceneReport report = SceneReport.of(run.world());
    assertEquals(0, report.nanCount());
    assertTrue(report.lowestY() > 0, report::toString);
    assertTrue(report.maxDepth() < 0.05f, report::toString);
  }
}
