package carom.lab.bench;

import carom.lab.broadphase.BroadphaseScene;
import carom.lab.measure.BenchRow;
import carom.lab.measure.Entrant;
import carom.lab.measure.Measurement;
import carom.lab.measure.Scaling;
import carom.lab.measure.Stopwatch;
import carom.lab.measure.Times;
import carom.physics.Body;
import carom.physics.BodyType;
import carom.physics.World;
import carom.physics.profile.StepStage;
import carom.sim.scene.Scene;
import carom.sim.scene.SceneReport;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * Measures an engine on a scene, on the calling thread.
 *
 * <ol>
 *   <li>Warm-up: the scene runs in fresh worlds for at least {@link Measurement#warmUpSeconds} and
 *       {@value #LEAST_STEPS} steps, until a run is hardly faster than the one before.
 *   <li>Measurement: the scene runs once more, first untimed steps and then timed ones in slices,
 *       between which the other entrants have their turns. With several threads, a slice of the
 *       worlds of {@link ScalingMeter} follows each slice.
 *   <li>Stages: Carom runs the scene once more with a stage listener. It must end in the same bits.
 * </ol>
 */
final class SceneMeasurement {
  /** Fewest steps of a warm-up, so that the JIT compiler has seen enough on any machine. */
  private static final int LEAST_STEPS = 400;

  /** The warm-up ends when a run takes at least this part of the time of the run before. */
  private static final double STEADY = 0.95;

  private SceneMeasurement() {}

  /** Measures the engine and closes it. */
  static BenchRow run(
      BenchScene given, BenchEngine engine, Entrant entrant, Measurement measurement) {
    BenchScene how = measurement.quick() ? given.quick() : given;
    double capSeconds = measurement.capSeconds();
    Scene scene = how.scene();
    try {
      warmUp(how, scene, engine, measurement);
      boolean byClock = entrant.threads() > 1;
      engine.start(scene);
      Stopwatch untimed = new Stopwatch(how.warm(), byClock);
      while (!untimed.isFull() && (untimed.count() == 0 || untimed.spent() < capSeconds)) {
        step(engine, untimed);
      }
      Stopwatch timed;
      Times times;
      Scaling scaling = Scaling.NONE;
      if (byClock && how.isBusy()) {
        try (ScalingMeter meter = new ScalingMeter(scene, entrant.threads(), untimed.count())) {
          timed = new Stopwatch(how.measured(), true);
          measurement.time(timed, () -> {}, engine::step, meter::slice);
          times = timed.times();
          scaling = meter.result();
        }
      } else {
        timed = new Stopwatch(how.measured(), byClock);
        measurement.time(timed, () -> {}, engine::step);
        times = timed.times();
      }
      World<?> world = engine.world();
      SceneReport end = SceneReport.of(world);
      int bodies = dynamicBodies(world);
      long hash = hash(world);
      if (engine instanceof CaromEngine carom) {
        bodies += carom.particles();
        hash = carom.stateHash();
      }
      BenchRow row =
          BenchRow.of(how.name(), entrant, bodies, times)
              .withHash(hash)
              .withScaling(scaling)
              .withEnd(world.jointCount(), engine.awake(), end);
      String fault = how.gate().fault(end, engine.awake());
      boolean cut = untimed.count() < how.warm() || timed.count() < how.measured();
      if (engine instanceof CaromEngine carom && !cut) {
        row = row.withStages(stages(how, scene, carom));
        fault = carom.stateHash() == hash ? fault : "two runs of the same scene end differently";
      }
      return row.withFault(fault.isEmpty() && cut ? Measurement.CUT : fault);
    } finally {
      engine.close();
    }
  }

  private static void warmUp(
      BenchScene how, Scene scene, BenchEngine engine, Measurement measurement) {
    double spent = 0;
    int made = 0;
    double before = Double.POSITIVE_INFINITY;
    double last = 0;
    double begin = Stopwatch.cpuSeconds();
    while (Stopwatch.cpuSeconds() - begin
            < measurement.capSeconds() // building the worlds counts here
        && (spent < measurement.warmUpSeconds() || made < LEAST_STEPS || last < STEADY * before)) {
      before = last == 0 ? Double.POSITIVE_INFINITY : last;
      engine.start(scene);
      Stopwatch watch = new Stopwatch(how.warm() + how.measured(), false);
      while (!watch.isFull() && Stopwatch.cpuSeconds() - begin < measurement.capSeconds()) {
        step(engine, watch);
      }
      // The least time per step ends the loop even if the clock stands still.
      last = Math.max(watch.spent(), 1e-6 * watch.count());
      spent += last;
      made += watch.count();
    }
  }

  private static Map<String, Double> stages(BenchScene how, Scene scene, CaromEngine engine) {
    engine.start(scene);
    for (int i = 0; i < how.warm(); i++) {
      engine.step();
    }
    StageClock clock = new StageClock(how.measured());
    engine.world().stageListener(clock);
    for (int i = 0; i < how.measured(); i++) {
      engine.step();
    }
    Map<String, Double> named = new LinkedHashMap<>();
    for (Map.Entry<StepStage, Double> stage : clock.medianMs().entrySet()) {
      named.put(stage.getKey().toString(), stage.getValue());
    }
    return named;
  }

  private static void step(BenchEngine engine, Stopwatch watch) {
    watch.begin();
    engine.step();
    watch.end();
  }

  private static int dynamicBodies(World<?> world) {
    int[] count = {0};
    world.forEachBody(body -> count[0] += body.type() == BodyType.DYNAMIC ? 1 : 0);
    return count[0];
  }

  /** Returns a hash of the dynamic bodies' poses, for engines without a hash. */
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
