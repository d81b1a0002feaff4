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
import carom.sim.SimulationHost;
import carom.sim.scene.BenchmarkScenes;
import carom.sim.scene.Scene;
import carom.sim.scene.SceneGame;
import carom.sim.scene.SceneRun;
import java.util.List;
import java.util.function.Supplier;

/**
 * A job that times work on the state of a pile of 10,000 bodies: saving, restoring, quantising or
 * building it. Only the call is timed, not the step before it.
 *
 * @param name name of the job, like {@code save_10k}
 * @param work creates the work to repeat
 */
record StateJob(String name, Supplier<Work> work) implements BenchJob {
  private static final int BODIES = 10_000;

  /** Number of steps after which the lower half of the pile lies still. */
  private static final int WARM = 120;

  private static final int TIMED = 200;

  /**
   * Number of repetitions after which every buffer was used (the ring of frames is the longest) and
   * all vector kernels are in use; those for angles need 267 frames.
   */
  private static final int LEAST_WARM_UP = FrameRing.SIZE + 240;

  private static final float DT = 1f / Scene.DEFAULT_TICK_RATE;

  /**
   * The work that a job repeats.
   *
   * @param before runs before each timed call, untimed
   * @param timed the timed call
   * @param world the world whose hash the row shows, or null for none
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

  /** Returns work that saves the state into a reused object. */
  private static Work save() {
    World<String> world = pile(WARM).world();
    WorldState reused = world.save(null);
    return new Work(() -> world.step(DT), () -> world.save(reused), world);
  }

  /** Returns work that restores the state of one step before. */
  private static Work restore() {
    World<String> world = pile(WARM).world();
    WorldState state = world.save(null);
    return new Work(() -> world.step(DT), () -> world.restore(state), world);
  }

  private static Work hash() {
    World<String> world = pile(WARM).world();
    return new Work(() -> world.step(DT), world::stateHash, world);
  }

  /**
   * Returns work that quantises the state for snapshots, as a room does once per tick for all its
   * players.
   */
  private static Work quantise() {
    Scene scene = pile();
    SimulationHost simulation =
        new SimulationHost(
            new SceneGame(scene), SceneGame.level(scene), 1, scene.tickRate(), Role.AUTHORITY);
    FrameCapture capture = new FrameCapture(simulation);
    for (int i = 0; i < WARM; i++) {
      simulation.step();
    }
    FrameState[] newest = {null};
    return new Work(simulation::step, () -> newest[0] = capture.capture(), simulation.world());
  }

  /** Returns work that builds a world and its bodies. */
  private static Work create() {
    SceneRun[] newest = {null};
    return new Work(() -> newest[0] = null, () -> newest[0] = pile(0), null);
  }

  /** Returns work that does a first step, which builds the trees and finds all pairs. */
  private static Work firstStep() {
    SceneRun[] newest = {null};
    return new Work(() -> newest[0] = pile(0), () -> newest[0].step(), null);
  }

  @Override
  public List<Entrant> entrants(Choice wanted) {
    return wanted.kernels().stream().map(k -> new Entrant(Entrant.CAROM, k, 1)).toList();
  }

  /** Returns false, because the number of warm-up steps, and so the state, depends on the clock. */
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
