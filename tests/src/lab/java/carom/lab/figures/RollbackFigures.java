package carom.lab.figures;

import carom.lab.measure.Figure;
import carom.physics.WorldState;
import carom.sim.scene.BenchmarkScenes;
import carom.sim.scene.Scene;
import carom.sim.scene.SceneRun;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.Arrays;
import java.util.List;

/**
 * Measures a rollback of the engine: a world of 200 bodies or more, all awake, is restored to 24
 * ticks before and resimulated, with each tick saved on the way. CPU time of one thread.
 */
final class RollbackFigures {
  private static final int BODIES = 200;

  /** Bodies along a side of the grid that joints hold together: 225 in all. */
  private static final int PER_SIDE = 15;

  private static final int TICKS = 24;
  private static final int SETTLE = 240;

  private RollbackFigures() {}

  static List<Figure> measure(boolean quick) {
    return List.of(
        measure(8, "a pile of 200 bodies", BenchmarkScenes.pile(BODIES, 14, 10), quick),
        measure(10, "225 jointed bodies", BenchmarkScenes.jointGrid(PER_SIDE), quick));
  }

  private static Figure measure(double reach, String what, Scene scene, boolean quick) {
    SceneRun run = scene.start();
    run.steps(SETTLE);
    WorldState[] states = new WorldState[TICKS + 1];
    int rounds = quick ? 60 : 400;
    double[] millis = new double[rounds];
    ThreadMXBean clock = ManagementFactory.getThreadMXBean();
    for (int round = -rounds; round < rounds; round++) {
      long begin = clock.getCurrentThreadCpuTime();
      if (states[0] == null) {
        states[0] = run.world().save(null);
      } else {
        run.world().restore(states[0]);
      }
      for (int i = 1; i <= TICKS; i++) {
        run.world().step(run.tickSeconds());
        states[i] = run.world().save(states[i]);
      }
      if (round >= 0) {
        millis[round] = (clock.getCurrentThreadCpuTime() - begin) / 1e6;
      }
    }
    Arrays.sort(millis);
    return Figure.atMost(
            reach,
            "rollback of 24 ticks of " + what + ", restored and saved",
            millis[rounds / 2],
            "ms")
        .withNote(
            "%d contacts, %d joints; 99 %% within %s ms",
            run.world().profile().contacts(),
            run.world().jointCount(),
            Figure.number(millis[rounds * 99 / 100]));
  }
}
