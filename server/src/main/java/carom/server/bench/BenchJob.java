package carom.server.bench;

import carom.sim.Suggestion;
import carom.sim.scene.Scenes;
import java.util.ArrayList;
import java.util.List;

/**
 * Something to measure: a scene, or the broadphase alone on so many boxes.
 *
 * @param name of the scene, or like {@code bp_uniform_10k}
 * @param scene null for the broadphase
 * @param boxes number of boxes; 0 for a scene
 * @param clustered whether the boxes cluster
 */
record BenchJob(String name, BenchScene scene, int boxes, boolean clustered) {
  /** All of the broadphase; every single name starts with it. */
  static final String BROADPHASE = "bp";

  private static final int[] THOUSANDS = {1, 10, 100, 1000};

  /** All jobs, in the order of the table. */
  static List<BenchJob> all() {
    List<BenchJob> jobs = new ArrayList<>();
    BenchScene.ALL.forEach(scene -> jobs.add(new BenchJob(scene.name(), scene, 0, false)));
    jobs.addAll(broadphase());
    return jobs;
  }

  private static List<BenchJob> broadphase() {
    List<BenchJob> jobs = new ArrayList<>();
    for (boolean clustered : new boolean[] {false, true}) {
      for (int k : THOUSANDS) {
        String size = k == 1000 ? "1m" : k + "k";
        String name = BROADPHASE + (clustered ? "_clustered_" : "_uniform_") + size;
        jobs.add(new BenchJob(name, null, 1000 * k, clustered));
      }
    }
    return jobs;
  }

  /**
   * The jobs of the names.
   *
   * @param names of scenes or broadphase rows, or {@link #BROADPHASE} for all of those
   * @throws IllegalArgumentException if there is none of a name, naming the nearest
   */
  static List<BenchJob> of(List<String> names) {
    List<BenchJob> jobs = new ArrayList<>();
    for (String name : names) {
      if (name.equals(BROADPHASE)) {
        jobs.addAll(broadphase());
      } else {
        jobs.add(of(name));
      }
    }
    return jobs;
  }

  /**
   * The job of a name.
   *
   * @throws IllegalArgumentException if there is none, naming the nearest
   */
  static BenchJob of(String name) {
    List<String> known = new ArrayList<>(Scenes.names());
    for (BenchJob job : broadphase()) {
      if (job.name.equals(name)) {
        return job;
      }
      known.add(job.name);
    }
    if (!known.contains(name)) {
      throw new IllegalArgumentException(
          "unknown scene=" + name + Suggestion.didYouMean(name, known));
    }
    return new BenchJob(name, BenchScene.of(name), 0, false);
  }

  boolean isBroadphase() {
    return scene == null;
  }

  /** The ways to do the broadphase, in the place of engines; the first is the engine's own. */
  static List<String> broadphases() {
    return List.of(
        CaromEngine.NAME,
        BroadphaseBench.Method.KD_REBUILD.toString(),
        BroadphaseBench.Method.QUAD_REBUILD.toString());
  }

  /** Measures it in this process. */
  BenchRow run(String engine, String kernels, Measurement measurement, boolean quick) {
    if (!isBroadphase()) {
      return measurement.run(quick ? scene.quick() : scene, BenchChild.engine(engine), kernels);
    }
    BroadphaseBench.Method method = BroadphaseBench.Method.KD_REFIT;
    for (BroadphaseBench.Method m : BroadphaseBench.Method.values()) {
      method = m.toString().equals(engine) ? m : method;
    }
    BroadphaseBench.Row row =
        BroadphaseBench.run(method, boxes, clustered, measurement.warmUpSeconds());
    double msPerNs = boxes * 1e-6;
    return new BenchRow(
        name,
        engine,
        kernels,
        boxes,
        0,
        row.ticks(),
        row.sumNs() * msPerNs,
        row.p99Ns() * msPerNs,
        row.allocatedBytes(),
        "%016x".formatted(row.hash()),
        Double.NaN,
        Double.NaN,
        0,
        Double.NaN,
        "");
  }
}
