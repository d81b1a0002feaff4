package carom.lab.bench;

import carom.lab.measure.Entrant;
import carom.physics.World;
import carom.physics.threads.WorkerThreads;
import carom.sim.scene.Scene;
import carom.sim.scene.SceneRun;

/** Carom as an engine of the benchmark. */
final class CaromEngine implements BenchEngine {
  private final int threads;

  /**
   * Threads of the present world alone, so that the warm-up of other worlds doesn't decide whether
   * sharing pays.
   */
  private WorkerThreads workers;

  private SceneRun run;

  /**
   * Creates an engine without a world.
   *
   * @param threads number of threads that step a world together, 1..64
   */
  CaromEngine(int threads) {
    this.threads = threads;
  }

  @Override
  public String name() {
    return Entrant.CAROM;
  }

  @Override
  public void start(Scene scene) {
    dismiss();
    run = scene.start();
    workers = threads == 1 ? null : new WorkerThreads(threads, System::nanoTime);
    run.world().workers(workers);
  }

  @Override
  public void step() {
    run.step();
  }

  @Override
  public World<?> world() {
    return run.world();
  }

  /** Returns the hash of the world, and of particles if there are any. */
  long stateHash() {
    return run.particles().isEmpty() ? run.world().stateHash() : run.stateHash();
  }

  /** Returns the number of particles of all systems. */
  int particles() {
    return run.particles().stream().mapToInt(some -> some.particles().count()).sum();
  }

  @Override
  public int awake() {
    return run.world().profile().awake();
  }

  @Override
  public void close() {
    run = null;
    dismiss();
  }

  private void dismiss() {
    if (workers != null) {
      workers.close();
      workers = null;
    }
  }
}
