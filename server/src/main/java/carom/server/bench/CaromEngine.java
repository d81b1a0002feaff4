package carom.server.bench;

import carom.physics.World;
import carom.sim.scene.Scene;
import carom.sim.scene.SceneRun;

/** The engine of this program. */
final class CaromEngine implements BenchEngine {
  static final String NAME = "carom";
  private SceneRun run;

  @Override
  public String name() {
    return NAME;
  }

  @Override
  public void start(Scene scene) {
    run = scene.start();
  }

  @Override
  public void step() {
    run.step();
  }

  @Override
  public World<?> world() {
    return run.world();
  }
}
