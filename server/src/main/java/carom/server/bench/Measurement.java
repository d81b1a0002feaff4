package carom.server.bench;

import carom.physics.Body;
import carom.physics.BodyType;
import carom.physics.World;
import carom.physics.profile.StepStage;
import carom.sim.scene.Scene;
import carom.sim.scene.SceneReport;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.Consumer;

/**
 * How long to measure; and how an engine is measured on a scene, on the calling thread.
 *
 * <p>First the scene is repeated in fresh worlds until the compiler is done: for {@link
 * #warmUpSeconds} and {@value #LEAST_STEPS} steps at least, and until a repeat is hardly faster
 * than the one before. Then it runs once more, some steps untimed, then the timed ones in {@value
 * #SLICES} slices, between which the other entrants have their turns. With several threads each
 * slice is followed by one of the worlds that tell {@link Scaling}. Carom runs a further time with
 * its stages told, which must end in the same bits.
 *
 * @param warmUpSeconds of stepping before the run that counts
 * @param capSeconds after which the warm-up, the timed part, and likewise the untimed part end
 *     early
 * @param quick whether to time a quarter of the steps only
 * @param turns whose turn it is; this process has it
 */
record Measurement(double warmUpSeconds, double capSeconds, boolean quick, Turns turns) {
  /** What a row that was cut short by {@link #capSeconds} says. */
  static final String CUT = "cut short";

  /** Enough that a slow minute of the machine is everybody's, few enough that caches are warm. */
  private static final int SLICES = 12;

  /** What the compiler needs to have seen, whatever the clock says. */
  private static final int LEAST_STEPS = 400;

  /** A repeat that takes this part of the one before, or more, is no longer getting faster. */
  private static final double STEADY = 0.95;

  /**
   * Times repeated work in slices, until the watch is full or {@link #capSeconds} are spent; at
   * least once.
   *
   * @param watch takes the times
   * @param before done before each piece of work, untimed
   * @param work what is timed
   */
  void time(Stopwatch watch, Runnable before, Runnable work) {
    time(watch, before, work, slice -> {});
  }

  private void time(Stopwatch watch, Runnable before, Runnable work, Consumer<double[]> meter) {
    int slice = Math.max(1, (watch.most() + SLICES - 1) / SLICES);
    do {
      turns.pass();
      int begin = watch.count();
      do {
        before.run();
        watch.begin();
        work.run();
        watch.end();
      } while (!watch.isFull() && watch.count() < begin + slice && watch.spent() < capSeconds);
      watch.leaveOut(() -> meter.accept(watch.wallMs(begin)));
    } while (!watch.isFull() && watch.spent() < capSeconds);
  }

  /** Measures. */
  BenchRow run(BenchScene given, BenchEngine engine, Entrant entrant) {
    BenchScene how = quick ? given.quick() : given;
    Scene scene = how.scene();
    try {
      warmUp(how, scene, engine);
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
          time(timed, () -> {}, engine::step, meter::slice);
          times = timed.times();
          scaling = meter.result();
        }
      } else {
        timed = new Stopwatch(how.measured(), byClock);
        time(timed, () -> {}, engine::step);
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
      return row.withFault(fault.isEmpty() && cut ? CUT : fault);
    } finally {
      engine.close();
    }
  }

  private void warmUp(BenchScene how, Scene scene, BenchEngine engine) {
    double spent = 0;
    int made = 0;
    double before = Double.POSITIVE_INFINITY;
    double last = 0;
    double begin = Stopwatch.cpuSeconds();
    while (Stopwatch.cpuSeconds() - begin < capSeconds // the making of worlds counts here
        && (spent < warmUpSeconds || made < LEAST_STEPS || last < STEADY * before)) {
      before = last == 0 ? Double.POSITIVE_INFINITY : last;
      engine.start(scene);
      Stopwatch watch = new Stopwatch(how.warm() + how.measured(), false);
      while (!watch.isFull() && Stopwatch.cpuSeconds() - begin < capSeconds) {
        step(engine, watch);
      }
      // A clock that stands still must not hang us.
      last = Math.max(watch.spent(), 1e-6 * watch.count());
      spent += last;
      made += watch.count();
    }
  }

  private Map<String, Double> stages(BenchScene how, Scene scene, CaromEngine engine) {
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
