package carom.server.bench;

import carom.physics.Body;
import carom.physics.BodyType;
import carom.physics.World;
import carom.sim.scene.SceneReport;
import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.Arrays;

/**
 * Measures one engine on one scene, on the calling thread.
 *
 * <p>First the scene is repeated in fresh worlds until the compiler has seen enough, then it runs
 * once more, some steps untimed, then the timed ones.
 *
 * @param warmUpSeconds CPU time of stepping before the run that counts
 * @param capSeconds CPU time after which the timed part ends early, and likewise the untimed part
 */
record Measurement(double warmUpSeconds, double capSeconds) {
  /** What a row that was cut short by {@link #capSeconds} says. */
  static final String CUT = "cut short";

  private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

  /**
   * Measures.
   *
   * @param kernels what the row says of them
   */
  BenchRow run(BenchScene scene, BenchEngine engine, String kernels) {
    double[] times = new double[Math.max(scene.warm(), scene.measured())];
    double spent = 0;
    while (spent < warmUpSeconds) {
      engine.start(scene.scene());
      for (int i = 0; i < scene.warm() + scene.measured() && spent < capSeconds; i++) {
        spent += timedStep(engine);
      }
      spent = Math.max(spent, Double.MIN_NORMAL); // a clock that stands still must not hang us
      if (spent >= capSeconds) {
        break;
      }
    }
    engine.start(scene.scene());
    int warm = steps(engine, scene.warm(), times);
    long me = Thread.currentThread().getId();
    long before = THREADS.getThreadAllocatedBytes(me);
    int measured = steps(engine, scene.measured(), times);
    long allocated = THREADS.getThreadAllocatedBytes(me) - before;
    World<?> world = engine.world();
    SceneReport end = SceneReport.of(world);
    String fault = scene.gate().fault(end);
    if (fault.isEmpty() && (warm < scene.warm() || measured < scene.measured())) {
      fault = CUT;
    }
    Arrays.sort(times, 0, measured);
    int[] dynamic = {0};
    world.forEachBody(body -> dynamic[0] += body.type() == BodyType.DYNAMIC ? 1 : 0);
    return new BenchRow(
        scene.name(),
        engine.name(),
        kernels,
        dynamic[0],
        world.jointCount(),
        measured,
        times[measured / 2] * 1e3,
        times[(int) Math.ceil(0.99 * measured) - 1] * 1e3,
        (double) allocated / measured,
        "%016x".formatted(engine instanceof CaromEngine ? world.stateHash() : hash(world)),
        end.kineticEnergy(),
        end.maxDepth(),
        end.deepOverlaps(),
        end.worstJointGap(),
        fault);
  }

  private int steps(BenchEngine engine, int wanted, double[] times) {
    double spent = 0;
    int made = 0;
    while (made < wanted && (made == 0 || spent < capSeconds)) {
      times[made] = timedStep(engine);
      spent += times[made++];
    }
    return made;
  }

  private static double timedStep(BenchEngine engine) {
    long begin = THREADS.getCurrentThreadCpuTime();
    engine.step();
    return (THREADS.getCurrentThreadCpuTime() - begin) * 1e-9;
  }

  /** Of the dynamic bodies' poses, for engines that have no hash of their own. */
  private static long hash(World<?> world) {
    long[] hash = {0};
    world.forEachBody(
        body -> {
          if (body.type() == BodyType.DYNAMIC) {
            hash[0] = BroadphaseScene.mix(hash[0] + bits(body));
          }
        });
    return hash[0];
  }

  private static long bits(Body<?> body) {
    return ((long) Float.floatToIntBits(body.x()) << 32)
        ^ Float.floatToIntBits(body.y())
        ^ ((long) Float.floatToIntBits(body.sin()) << 16);
  }
}
