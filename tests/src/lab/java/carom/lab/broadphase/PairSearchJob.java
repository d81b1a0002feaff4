package carom.lab.broadphase;

import carom.lab.measure.BenchJob;
import carom.lab.measure.BenchRow;
import carom.lab.measure.Entrant;
import carom.lab.measure.Measurement;
import carom.lab.measure.Stopwatch;
import carom.lab.measure.Times;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.Material;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.geometry.Box;
import carom.physics.geometry.Shape;
import carom.physics.math.SimRandom;
import carom.physics.profile.StageListener;
import carom.physics.profile.StepStage;
import carom.sim.scene.SceneReport;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * The job that measures the engine's own pair search within whole steps of a world, as a server
 * does them. Only the stages {@link StepStage#BOXES} and {@link StepStage#PAIRS} are timed.
 *
 * <p>The world is a closed square without gravity, a quarter of which boxes of 0.5 to 1 m cover.
 * They start with up to 3 m/s in each direction and bounce. Most steps are cheap and a few
 * expensive, when boxes leave their fat boxes, so the time of a row is the mean, not the median.
 *
 * @param name like {@code pairs_10k}
 * @param boxes how many
 * @param timed steps
 */
public record PairSearchJob(String name, int boxes, int timed) implements BenchJob {
  private static final double PITCH = 1.5;
  private static final double SPEED = 3;
  private static final int SIZES = 16;
  private static final float DT = 1 / 60f;
  private static final Material IDEAL = new Material(1, 0, 1);

  /** Number of steps after which nothing is left of the initial lattice. */
  private static final int WARM = 60;

  /** Fewest steps of a warm-up, so that the JIT compiler has seen enough on any machine. */
  private static final int LEAST_STEPS = 400;

  /** Returns all jobs of this kind in the order of the table. */
  public static List<BenchJob> all() {
    return List.of(
        new PairSearchJob("pairs_1k", 1_000, 240),
        new PairSearchJob("pairs_10k", 10_000, 240),
        new PairSearchJob("pairs_100k", 100_000, 240),
        new PairSearchJob("pairs_1m", 1_000_000, 60));
  }

  @Override
  public List<Entrant> entrants(Choice wanted) {
    return wanted.kernels().stream().map(k -> new Entrant(Entrant.CAROM, k, 1)).toList();
  }

  @Override
  public BenchRow run(Entrant entrant, Measurement measurement) {
    int wanted = measurement.quick() ? timed / 4 : timed;
    warmUp(WARM + wanted, measurement);
    World<Void> world = world(boxes);
    step(world, WARM);
    Stopwatch steps = new Stopwatch(wanted, false);
    SearchClock clock = new SearchClock(wanted);
    world.stageListener(clock);
    measurement.time(steps, () -> {}, () -> world.step(DT));
    return BenchRow.of(name, entrant, boxes, clock.times(steps.times().allocatedBytes()))
        .withHash(world.stateHash())
        .withEnd(0, world.profile().awake(), SceneReport.of(world))
        .withStages(clock.meanMs())
        .withFault(steps.isFull() ? "" : Measurement.CUT);
  }

  /** Repeats the measured work at least once, until the JIT compiler is done. */
  private void warmUp(int steps, Measurement measurement) {
    double begin = Stopwatch.cpuSeconds();
    double spent = 0;
    for (int made = 0;
        spent < measurement.warmUpSeconds()
            || made < LEAST_STEPS && spent < measurement.capSeconds();
        made += steps) {
      step(world(boxes), steps);
      spent = Stopwatch.cpuSeconds() - begin;
    }
  }

  private static void step(World<Void> world, int steps) {
    for (int i = 0; i < steps; i++) {
      world.step(DT);
    }
  }

  /** Returns a square full of moving boxes. */
  static World<Void> world(int boxes) {
    World<Void> world = new World<>(new WorldDef().withGravity(0, 0));
    int columns = (int) Math.ceil(Math.sqrt(boxes));
    float half = (float) (columns * PITCH / 2);
    for (int side = -1; side <= 1; side += 2) {
      Shape upright = new Box(5, half + 10);
      Shape lying = new Box(half + 10, 5);
      world.createBody(new BodyDef().shape(upright, IDEAL).position(side * (half + 5), 0), null);
      world.createBody(new BodyDef().shape(lying, IDEAL).position(0, side * (half + 5)), null);
    }
    SimRandom random = new SimRandom(5);
    Shape[] shapes = new Shape[SIZES];
    Arrays.setAll(shapes, i -> new Box(in(random, 0.25, 0.5), in(random, 0.25, 0.5)));
    for (int i = 0; i < boxes; i++) {
      int row = i / columns;
      int column = i % columns;
      world.createBody(
          new BodyDef(BodyType.DYNAMIC)
              .shape(shapes[i % SIZES], IDEAL)
              .position(
                  (float) ((column + 0.5) * PITCH) - half, (float) ((row + 0.5) * PITCH) - half)
              .angle(in(random, -Math.PI, Math.PI))
              .velocity(in(random, -SPEED, SPEED), in(random, -SPEED, SPEED)),
          null);
    }
    return world;
  }

  private static float in(SimRandom random, double low, double high) {
    return (float) (low + (high - low) * random.nextFloat());
  }

  /** Adds up the CPU time of the two stages, step by step, without allocating. */
  private static final class SearchClock implements StageListener {
    private final double[] boxesSeconds;
    private final double[] pairsSeconds;
    private int step;
    private StepStage current = StepStage.BEGIN;
    private double since;

    SearchClock(int steps) {
      boxesSeconds = new double[steps];
      pairsSeconds = new double[steps];
    }

    @Override
    public void begins(StepStage stage) {
      boolean searched = isSearch(current);
      if (searched || isSearch(stage)) { // reading the clock costs, so not for the other stages
        double now = Stopwatch.cpuSeconds();
        if (searched) {
          (current == StepStage.BOXES ? boxesSeconds : pairsSeconds)[step] += now - since;
        }
        since = now;
      }
      current = stage;
    }

    private static boolean isSearch(StepStage stage) {
      return stage == StepStage.BOXES || stage == StepStage.PAIRS;
    }

    @Override
    public void done() {
      step++;
    }

    /** Returns the times of both stages together, with the mean in place of the median. */
    Times times(double allocatedBytes) {
      double[] seconds = new double[step];
      Arrays.setAll(seconds, i -> boxesSeconds[i] + pairsSeconds[i]);
      double mean = 1e3 * Arrays.stream(seconds).average().orElse(0);
      Arrays.sort(seconds);
      double p99 = 1e3 * seconds[(int) Math.ceil(0.99 * step) - 1];
      return new Times(step, mean, p99, Double.NaN, allocatedBytes);
    }

    /** Returns the mean of each stage, ms per step. */
    Map<String, Double> meanMs() {
      Map<String, Double> means = new LinkedHashMap<>();
      means.put(StepStage.BOXES.toString(), mean(boxesSeconds));
      means.put(StepStage.PAIRS.toString(), mean(pairsSeconds));
      return means;
    }

    private double mean(double[] seconds) {
      return 1e3 * Arrays.stream(seconds, 0, step).average().orElse(0);
    }
  }
}
