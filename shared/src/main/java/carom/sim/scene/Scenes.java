package carom.sim.scene;

import carom.text.Suggestion;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeMap;

/**
 * Finds all scenes by name. Making a scene is cheap: nothing is built before {@link Scene#start}.
 */
public final class Scenes {
  private static final TreeMap<String, Scene> ALL = new TreeMap<>();

  static {
    benchmark();
    StackScenes.all().forEach(Scenes::add);
    JointScenes.all().forEach(Scenes::add);
    SurfaceScenes.all().forEach(Scenes::add);
    MixedScenes.all().forEach(Scenes::add);
    CoupledScenes.all().forEach(Scenes::add);
    ParticleScenes.all().forEach(Scenes::add);
    TrafficScenes.all().forEach(Scenes::add);
    MoverScenes.all().forEach(Scenes::add);
    TruthScenes.all().forEach(Scenes::add);
  }

  private Scenes() {}

  private static void benchmark() {
    add(BenchmarkScenes.pyramid(100));
    add(BenchmarkScenes.manyPyramids(20, 20));
    add(BenchmarkScenes.tumbler(45));
    Scene pile = BenchmarkScenes.pile(2000, 50, 45);
    add(pile.named("pile_2k", pile.description()));
    pile = BenchmarkScenes.pile(10_000, 125, 110);
    add(pile.named("pile_10k", pile.description()));
    add(BenchmarkScenes.pileOfPolygons());
    add(BenchmarkScenes.pileOfCompounds());
    add(BenchmarkScenes.pileOfAll());
    add(BenchmarkScenes.jointGrid(100));
    add(BenchmarkScenes.smash(120, 80));
    for (int thousands : new int[] {1, 10, 50}) {
      Scene gas = BenchmarkScenes.gas(1000 * thousands);
      add(gas.named("gas_" + thousands + "k", gas.description()));
    }
  }

  private static void add(Scene scene) {
    if (ALL.put(scene.name(), scene) != null) {
      throw new IllegalStateException("name=" + scene.name() + " is used twice");
    }
  }

  /**
   * Returns the scene of a name.
   *
   * @param name see {@link Scene#name}
   * @return its recipe
   * @throws IllegalArgumentException if there is none, naming the nearest
   */
  public static Scene get(String name) {
    Scene scene = ALL.get(name);
    if (scene == null) {
      throw new IllegalArgumentException(
          "unknown scene=" + name + Suggestion.didYouMean(name, ALL.keySet()));
    }
    return scene;
  }

  /**
   * Returns all scenes.
   *
   * @return sorted by name
   */
  public static List<Scene> all() {
    return List.copyOf(ALL.values());
  }

  /**
   * Returns the names of all scenes.
   *
   * @return sorted
   */
  public static List<String> names() {
    return new ArrayList<>(ALL.keySet());
  }
}
