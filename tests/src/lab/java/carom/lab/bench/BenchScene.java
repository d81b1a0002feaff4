package carom.lab.bench;

import carom.sim.scene.BenchmarkScenes;
import carom.sim.scene.Scene;
import carom.sim.scene.Scenes;
import java.util.List;
import java.util.function.Supplier;

/**
 * A scene with the conditions of its measurement.
 *
 * @param name name of the scene
 * @param warm number of steps before the measured ones, in the same world
 * @param measured number of timed steps
 * @param gate conditions on the last state
 * @param peers whether other engines run the scene, too
 * @param scenes creates the scene
 */
record BenchScene(
    String name, int warm, int measured, Gate gate, boolean peers, Supplier<Scene> scenes) {
  /** The scenes that are measured by default. */
  static final List<BenchScene> ALL =
      List.of(
          of("large_pyramid", 60, 200, Gate.still(500, 105)),
          of("many_pyramids", 30, 120, Gate.still(1000, 225)),
          of("tumbler", 300, 300, Gate.still(5000, 25)),
          of("pile_2k", 240, 240, Gate.still(20_000, 60)),
          of("pile_10k", 240, 240, Gate.still(200_000, 90)),
          of("pile_polygons", 240, 240, Gate.still(20_000, 60)),
          of("pile_compounds", 240, 240, Gate.still(20_000, 60).deep(0.25)),
          of("pile_mixed", 240, 240, Gate.still(20_000, 60).deep(0.25)),
          of("joint_grid", 60, 240, Gate.FINITE.joined(1)),
          // The block has a mass of 512 kg and a speed of 40 m/s.
          of("smash", 60, 200, new Gate(415_000, 0, 0.2, 1, 1000, Integer.MAX_VALUE)),
          gas(1),
          gas(10),
          gas(50),
          // The first step of other engines wakes the sleeping bodies, which need this time to fall
          // asleep again.
          asleep("asleep_20k", 20_000, 50, 120, true),
          asleep("asleep_1m", 1_000_000, 1000, 30, false),
          new BenchScene(
              "water_10k", 120, 240, Gate.FINITE, false, () -> BenchmarkScenes.water(10_000)));

  private static final int OTHER_WARM = 60;
  private static final int OTHER_MEASURED = 240;

  private static BenchScene of(String name, int warm, int measured, Gate gate) {
    return new BenchScene(name, warm, measured, gate, true, () -> Scenes.get(name));
  }

  private static BenchScene gas(int thousands) {
    // pi/16 kg each, mean square of the speed 12.5 m^2/s^2
    double energy = 1000 * thousands * 0.5 * (Math.PI / 16) * 12.5;
    double half = 3.1333 * Math.sqrt(1000 * thousands) / 2;
    return of("gas_" + thousands + "k", 60, 240, Gate.elastic(energy, half + 0.5));
  }

  /** Returns a scene that is too large for the library, whose scenes people watch and tests run. */
  private static BenchScene asleep(
      String name, int asleep, int awake, int warm, boolean withPeers) {
    Gate gate = Gate.FINITE.asleepBut(awake);
    Supplier<Scene> scenes = () -> BenchmarkScenes.asleep(asleep, awake);
    return new BenchScene(name, warm, 240, gate, withPeers, scenes);
  }

  /**
   * Returns the measured scene of a name, which may be any scene of the library.
   *
   * @throws IllegalArgumentException if there is none, naming the nearest
   */
  static BenchScene of(String name) {
    for (BenchScene scene : ALL) {
      if (scene.name.equals(name)) {
        return scene;
      }
    }
    return of(Scenes.get(name).name(), OTHER_WARM, OTHER_MEASURED, Gate.FINITE);
  }

  Scene scene() {
    return scenes.get();
  }

  /**
   * Returns whether the whole scene is awake. Threads can hardly share a scene that mostly sleeps.
   */
  boolean isBusy() {
    return gate.maxAwake() == Integer.MAX_VALUE;
  }

  /** Returns a copy with a quarter of the timed steps. */
  BenchScene quick() {
    return new BenchScene(name, warm, Math.max(10, measured / 4), gate, peers, scenes);
  }
}
