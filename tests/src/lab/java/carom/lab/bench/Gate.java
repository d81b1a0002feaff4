package carom.lab.bench;

import carom.sim.scene.SceneReport;
import java.util.Locale;

/**
 * What the end state of a run must be like for its times to count.
 *
 * @param maxEnergy largest kinetic energy of all bodies together, J
 * @param minEnergy least kinetic energy, J
 * @param maxPenetration deepest overlap allowed, m
 * @param maxJointGap largest distance between the anchors of a hinge, m
 * @param maxCoordinate how far a body may get from an axis, m
 * @param maxAwake how many bodies may be awake
 */
record Gate(
    double maxEnergy,
    double minEnergy,
    double maxPenetration,
    double maxJointGap,
    double maxCoordinate,
    int maxAwake) {
  private static final double ANY = Double.POSITIVE_INFINITY;

  /** Only that every number is finite. */
  static final Gate FINITE = new Gate(ANY, 0, ANY, ANY, ANY, Integer.MAX_VALUE);

  /** Bodies of about half a metre that come to rest, or nearly. */
  static Gate still(double maxEnergy, double maxCoordinate) {
    return new Gate(maxEnergy, 0, 0.1, ANY, maxCoordinate, Integer.MAX_VALUE);
  }

  /** Elastic discs: within 5 percent of the energy they started with. */
  static Gate elastic(double energy, double maxCoordinate) {
    return new Gate(1.05 * energy, 0.95 * energy, 0.25, ANY, maxCoordinate, Integer.MAX_VALUE);
  }

  /** Returns the same with hinges that hold. */
  Gate joined(double gap) {
    return new Gate(maxEnergy, minEnergy, maxPenetration, gap, maxCoordinate, maxAwake);
  }

  /** Returns the same with most bodies asleep. */
  Gate asleepBut(int awake) {
    return new Gate(maxEnergy, minEnergy, maxPenetration, maxJointGap, maxCoordinate, awake);
  }

  /**
   * Returns whether a run counts.
   *
   * @param end its last state
   * @param awake how many bodies are awake in it
   * @return why not, or the empty string
   */
  String fault(SceneReport end, int awake) {
    if (end.nanCount() > 0) {
      return end.nanCount() + " bodies are not finite";
    }
    if (end.kineticEnergy() > maxEnergy) {
      return exceeds("kinetic energy J", end.kineticEnergy(), maxEnergy);
    }
    if (end.kineticEnergy() < minEnergy) {
      return String.format(
          Locale.ROOT, "kinetic energy J %.4g below %.4g", end.kineticEnergy(), minEnergy);
    }
    if (end.maxDepth() > maxPenetration) {
      return exceeds("penetration m", end.maxDepth(), maxPenetration);
    }
    if (end.worstJointGap() > maxJointGap) {
      return exceeds("joint gap m", end.worstJointGap(), maxJointGap);
    }
    if (awake > maxAwake) {
      return awake + " bodies are awake, above " + maxAwake;
    }
    return end.maxCoordinate() > maxCoordinate
        ? exceeds("distance m", end.maxCoordinate(), maxCoordinate)
        : "";
  }

  private static String exceeds(String what, double value, double limit) {
    return String.format(Locale.ROOT, "%s %.4g above %.4g", what, value, limit);
  }
}
