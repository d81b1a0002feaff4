package carom.lab.bench;

import carom.lab.measure.BenchJob;
import carom.lab.measure.BenchRow;
import carom.lab.measure.Entrant;
import carom.lab.measure.Measurement;
import carom.lab.measure.Stopwatch;
import carom.net.snapshot.frame.FrameRing;
import carom.net.snapshot.frame.FrameState;
import carom.physics.World;
import carom.physics.WorldState;
import carom.server.replication.FrameCapture;
import carom.sim.Role;
import carom.sim.Simulation;
import carom.sim.scene.Scene;
import carom.sim.scene.SceneGame;
import carom.sim.scene.SceneRun;
import carom.sim.scene.catalog.BenchmarkScenes;
import java.util.List;
import java.util.function.Supplier;

/**
 * What can be done with a pile of 10,000 bodies between two steps, and making it. Only the call is
 * timed, not the step before it.
 *
 * @param name like {@code save_10k}
 * @param work makes what is repeated
 */
record StateJob(String name, Supplier<Work> work) implements BenchJob {
  private static final int BODIES = 10_000;

  /** By then the lower half of the pile lies. */
  private static final int WARM = 120;

  private static final int TIMED = 200;

  /**
   * By then every buffer was used (the ring of frames is the longest), and everything goes through
   * vector kernels where there are any: for angles that takes 267 frames.
   */
  private static final int LEAST_WARM_UP = FrameRing.SIZE + 240;

  private static final float DT = 1f / Scene.DEFAULT_TICK_RATE;

  /**
   * What is repeated.
   *
   * @param before done before each timed call, untimed
   * @param timed the call
   * @param world whose hash the row shows at the end, null for none
   */
  private record Work(Runnable before, Runnable timed, World<?> world) {}

  static List<BenchJob> all() {
    return List.of(
        new StateJob("save_10k", StateJob::save),
        new StateJob("restore_10k", StateJob::restore),
        new StateJob("hash_10k", StateJob::hash),
        new StateJob("quantise_10k", StateJob::quantise),
        new StateJob("create_10k", StateJob::create),
        new StateJob("first_step_10k", StateJob::firstStep));
  }

  private static Scene pile() {
    return BenchmarkScenes.pile(BODIES, 125, 110);
  }

  private static SceneRun pile(int steps) {
    SceneRun run = pile().start();
    run.steps(steps);
    return run;
  }

  /** Copies the state out, into an object that was used before. */
  private static Work save() {
    World<String> world = pile(WARM).world();
    WorldState reused = world.save(null);
    return new Work(() -> world.step(DT), () -> world.save(reused), world);
  }

  /** Goes back by one step. */
  private static Work restore() {
    World<String> world = pile(WARM).world();
    WorldState state = world.save(null);
    return new Work(() -> world.step(DT), () -> world.restore(state), world);
  }

  private static Work hash() {
    World<String> world = pile(WARM).world();
    return new Work(() -> world.step(DT), world::stateHash, world);
  }

  /** Quantises the state for the wire, as a room does once per tick for all its players. */
  private static Work quantise() {
    Scene scene = pile();
    Simulation simulation =
        new Simulation(
            new SceneGame(scene), SceneGame.level(scene), 1, scene.tickRate(), Role.AUTHORITY);
    FrameCapture capture = new FrameCapture(simulation);
    for (int i = 0; i < WARM; i++) {
      simulation.step();
    }
    FrameState[] newest = {null};
    return new Work(simulation::step, () -> newest[0] = capture.capture(), simulation.world());
  }

  /** Makes a world and its bodies. */
  private static Work create() {
    SceneRun[] newest = {null};
    return new Work(() -> newest[0] = null, () -> newest[0] = pile(0), null);
  }

  /** The step in which the trees are built and all pairs are found. */
  private static Work firstStep() {
    SceneRun[] newest = {null};
    return new Work(() -> newest[0] = pile(0), () -> newest[0].step(), null);
  }

  @Override
  public List<Entrant> entrants(Choice wanted) {
    return wanted.kernels().stream().map(k -> new Entrant(Entrant.CAROM, k, 1)).toList();
  }

  /** How many steps warm-up has depends on the clock, so each ends with another state. */
  @Override
  public boolean mustAgree(Entrant entrant) {
    return false;
  }

  @Override
  public BenchRow run(Entrant entrant, Measurement measurement) {
    Work repeated = work.get();
    double begin = Stopwatch.cpuSeconds();
    for (int i = 0;
        i < LEAST_WARM_UP || Stopwatch.cpuSeconds() - begin < measurement.warmUpSeconds();
        i++) {
      repeated.before.run();
      repeated.timed.run();
    }
    Stopwatch watch = new Stopwatch(measurement.quick() ? TIMED / 4 : TIMED, false);
    measurement.time(watch, repeated.before, repeated.timed);
    BenchRow row = BenchRow.of(name, entrant, BODIES, watch.times());
    return repeated.world == null ? row : row.withHash(repeated.world.stateHash());
  }
}
