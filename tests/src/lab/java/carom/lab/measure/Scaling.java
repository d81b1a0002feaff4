package carom.lab.measure;

/**
 * What several threads gain, and what they could gain at best on this machine now: processors may
 * be threads of one core, or be shared with others.
 *
 * @param speedUp how many times as fast several threads step one world as one thread does, by the
 *     clock
 * @param ceiling how many times as much several threads do when each steps a world of its own
 * @param share part of the ceiling that is reached
 */
public record Scaling(double speedUp, double ceiling, double share) {
  /** Not measured. */
  public static final Scaling NONE = new Scaling(Double.NaN, Double.NaN, Double.NaN);

  /** Returns whether it was measured. */
  public boolean isMeasured() {
    return !Double.isNaN(share);
  }
}
