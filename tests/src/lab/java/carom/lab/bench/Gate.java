package carom.lab.bench;

import carom.sim.scene.SceneReport;
import java.util.Locale;

/**
 * The conditions on the end state of a run. The times of a run that misses one don't count.
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

  /** The gate that only requires finite numbers. */
  static final Gate FINITE = new Gate(ANY, 0, ANY, ANY, ANY, Integer.MAX_VALUE);

  /** Returns the gate of bodies of about 0.5 m that come to rest, or nearly. */
  static Gate still(double maxEnergy, double maxCoordinate) {
    return new Gate(maxEnergy, 0, 0.1, ANY, maxCoordinate, Integer.MAX_VALUE);
  }

  /** Returns the gate of elastic discs: within 5 % of their initial energy. */
  static Gate elastic(double energy, double maxCoordinate) {
    return new Gate(1.05 * energy, 0.95 * energy, 0.25, ANY, maxCoordinate, Integer.MAX_VALUE);
  }

  /**
   * Returns a copy for compounds, which interlock while they fall: two parts of a body then hold it
   * from opposite sides, in every engine.
   *
   * @param maxDepth deepest overlap allowed, m
   */
  Gate deep(double maxDepth) {
    return new Gate(maxEnergy, minEnergy, maxDepth, maxJointGap, maxCoordinate, maxAwake);
  }

  /** Returns a copy that also requires the hinges to hold. */
  Gate joined(double gap) {
    return new Gate(maxEnergy, minEnergy, maxPenetration, gap, maxCoordinate, maxAwake);
  }

  /** Returns a copy that also requires most bodies to sleep. */
  Gate asleepBut(int awake) {
    return new Gate(maxEnergy, minEnergy, maxPenetration, maxJointGap, maxCoordinate, awake);
  }

  /**
   * Checks the end state of a run.
   *
   * @param end the last state
   * @param awake number of bodies awake in it
   * @return why the run doesn't count, or an empty text
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
