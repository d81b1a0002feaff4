package carom.lab.measure;

import carom.sim.scene.SceneReport;
import java.io.IOException;
import java.util.Locale;
import java.util.Map;

/**
 * A row of results.
 *
 * @param scene name of the job
 * @param entrant the entrant that did the job
 * @param bodies dynamic bodies and particles, or boxes
 * @param joints number of joints
 * @param awake bodies that are awake at the end
 * @param times times of a step
 * @param hash of the last state, 16 hexadecimal digits; equal hashes mean equal bits
 * @param kineticEnergy of the last state, J; this and what follows is NaN where it has no meaning
 * @param maxPenetration deepest overlap in the last state, m
 * @param deepPairs overlaps deeper than 2 cm
 * @param jointGap worst distance between the anchors of a hinge, m
 * @param stages time of each stage by name, ms per step; empty if not measured
 * @param scaling gain of several threads; only in Carom's rows with several threads
 * @param ratios other engines' times divided by this one, by engine; above 1 this one is faster.
 *     Only in Carom's rows
 * @param fault why the run doesn't count, or empty
 */
public record BenchRow(
    String scene,
    Entrant entrant,
    int bodies,
    int joints,
    int awake,
    Times times,
    String hash,
    double kineticEnergy,
    double maxPenetration,
    double deepPairs,
    double jointGap,
    Map<String, Double> stages,
    Scaling scaling,
    Map<String, Double> ratios,
    String fault) {
  /** Returns a row about a number of bodies, without figures of a world. */
  public static BenchRow of(String scene, Entrant entrant, int bodies, Times times) {
    return new BenchRow(
        scene,
        entrant,
        bodies,
        0,
        0,
        times,
        "",
        Double.NaN,
        Double.NaN,
        Double.NaN,
        Double.NaN,
        Map.of(),
        Scaling.NONE,
        Map.of(),
        "");
  }

  /** Returns the row of a run that gave no figures. */
  public static BenchRow failed(String scene, Entrant entrant, String fault) {
    return of(scene, entrant, 0, Times.NONE).withFault(fault);
  }

  /** Returns a copy with the figures of the end state. */
  public BenchRow withEnd(int jointCount, int awakeCount, SceneReport end) {
    return new BenchRow(
        scene,
        entrant,
        bodies,
        jointCount,
        awakeCount,
        times,
        hash,
        end.kineticEnergy(),
        end.maxDepth(),
        end.deepOverlaps(),
        end.worstJointGap(),
        stages,
        scaling,
        ratios,
        fault);
  }

  /** Returns a copy with the hash of the last state. */
  public BenchRow withHash(long newHash) {
    return with(String.format(Locale.ROOT, "%016x", newHash), stages, scaling, ratios, fault);
  }

  /** Returns a copy with the time of each stage by name, ms per step. */
  public BenchRow withStages(Map<String, Double> newStages) {
    return with(hash, newStages, scaling, ratios, fault);
  }

  /** Returns a copy with the gain of several threads. */
  public BenchRow withScaling(Scaling newScaling) {
    return with(hash, stages, newScaling, ratios, fault);
  }

  /** Returns a copy with other entrants' times as multiples of this row's. */
  public BenchRow withRatios(Map<String, Double> newRatios) {
    return with(hash, stages, scaling, newRatios, fault);
  }

  /** Returns a copy with the reason why the run doesn't count. */
  public BenchRow withFault(String newFault) {
    return with(hash, stages, scaling, ratios, newFault);
  }

  private BenchRow with(
      String newHash,
      Map<String, Double> newStages,
      Scaling newScaling,
      Map<String, Double> newRatios,
      String newFault) {
    return new BenchRow(
        scene,
        entrant,
        bodies,
        joints,
        awake,
        times,
        newHash,
        kineticEnergy,
        maxPenetration,
        deepPairs,
        jointGap,
        newStages,
        newScaling,
        newRatios,
        newFault);
  }

  /** Returns whether the row has figures, valid or not. */
  public boolean isMeasured() {
    return times.steps() > 0;
  }

  /** Returns whether the row's figures are valid results. */
  public boolean counts() {
    return isMeasured() && fault.isEmpty();
  }

  /** Returns the median time of a step, ms. */
  public double medianMs() {
    return times.medianMs();
  }

  /** Returns the row as one JSON object in one line. Values not measured are null. */
  public String toJson() {
    return new JsonLine.Writer()
        .text("scene", scene)
        .text("engine", entrant.engine())
        .text("kernels", entrant.kernels())
        .whole("threads", entrant.threads())
        .whole("bodies", bodies)
        .whole("joints", joints)
        .whole("awake", awake)
        .whole("steps", times.steps())
        .number("medianMs", times.medianMs())
        .number("p99Ms", times.p99Ms())
        .number("wallMs", times.wallMs())
        .number("allocatedBytesPerStep", times.allocatedBytes())
        .text("hash", hash)
        .number("kineticEnergy", kineticEnergy)
        .number("maxPenetration", maxPenetration)
        .number("deepPairs", deepPairs)
        .number("jointGap", jointGap)
        .numbers("stages", stages)
        .number("speedUp", scaling.speedUp())
        .number("ceiling", scaling.ceiling())
        .number("share", scaling.share())
        .numbers("ratios", ratios)
        .truth("valid", counts())
        .text("fault", fault)
        .end();
  }

  /**
   * Returns the row that {@link #toJson} wrote.
   *
   * @throws IOException if it is something else
   */
  public static BenchRow ofJson(String json) throws IOException {
    JsonLine line = JsonLine.read(json);
    return new BenchRow(
        line.text("scene"),
        new Entrant(line.text("engine"), line.text("kernels"), line.whole("threads")),
        line.whole("bodies"),
        line.whole("joints"),
        line.whole("awake"),
        new Times(
            line.whole("steps"),
            line.number("medianMs"),
            line.number("p99Ms"),
            line.number("wallMs"),
            line.number("allocatedBytesPerStep")),
        line.text("hash"),
        line.number("kineticEnergy"),
        line.number("maxPenetration"),
        line.number("deepPairs"),
        line.number("jointGap"),
        line.numbers("stages"),
        new Scaling(line.optional("speedUp"), line.optional("ceiling"), line.optional("share")),
        line.numbers("ratios"),
        line.text("fault"));
  }
}
