package carom.server.bench;

import carom.sim.scene.Scene;
import carom.sim.scene.Scenes;
import java.util.List;

/**
 * How a scene is measured.
 *
 * @param name of the scene
 * @param warm steps before the measured ones, in the same world
 * @param measured steps that are timed
 * @param gate what the last state must be like
 */
record BenchScene(String name, int warm, int measured, Gate gate) {
  /** Those that are measured unless flags say otherwise. */
  static final List<BenchScene> ALL =
      List.of(
          new BenchScene("large_pyramid", 60, 200, Gate.still(500, 105)),
          new BenchScene("many_pyramids", 30, 120, Gate.still(1000, 225)),
          new BenchScene("tumbler", 300, 300, Gate.still(5000, 25)),
          new BenchScene("pile_2k", 240, 240, Gate.still(20_000, 60)),
          new BenchScene("pile_10k", 240, 240, Gate.still(200_000, 90)),
          new BenchScene(
              "joint_grid",
              60,
              240,
              new Gate(
                  Double.POSITIVE_INFINITY,
                  0,
                  Double.POSITIVE_INFINITY,
                  1,
                  Double.POSITIVE_INFINITY)),
          // The block has 512 kg and 40 m/s.
          new BenchScene("smash", 60, 200, new Gate(415_000, 0, 0.2, 1, 1000)),
          gas(1),
          gas(10),
          gas(50));

  private static final int OTHER_WARM = 60;
  private static final int OTHER_MEASURED = 240;

  private static BenchScene gas(int thousands) {
    // pi/16 kg each, mean square of the speed 12.5 m^2/s^2
    double energy = 1000 * thousands * 0.5 * (Math.PI / 16) * 12.5;
    double half = 3.1333 * Math.sqrt(1000 * thousands) / 2;
    return new BenchScene("gas_" + thousands + "k", 60, 240, Gate.elastic(energy, half + 0.5));
  }

  /**
   * How the scene of a name is measured; any scene of the library will do.
   *
   * @throws IllegalArgumentException if there is none, naming the nearest
   */
  static BenchScene of(String name) {
    for (BenchScene scene : ALL) {
      if (scene.name.equals(name)) {
        return scene;
      }
    }
    return new BenchScene(Scenes.get(name).name(), OTHER_WARM, OTHER_MEASURED, Gate.FINITE);
  }

  Scene scene() {
    return Scenes.get(name);
  }

  /** The same with a quarter of the timed steps. */
  BenchScene quick() {
    return new BenchScene(name, warm, Math.max(10, measured / 4), gate);
  }
}
