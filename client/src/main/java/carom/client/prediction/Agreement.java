package carom.client.prediction;

import carom.sim.near.Neighbourhood;

/**
 * Tells how well client and server agree: the last ticks at which their states were equal or
 * differed, and the state of an unexplained difference. One prediction's. Read-only for users.
 */
public final class Agreement {
  private int agreedTick = -1;
  private int equalTick = -1;
  private int disagreedTick = -1;
  private int firstDisagreedTick = -1;
  private long disagreements;
  private boolean diverged;
  private final Neighbourhood divergedState = new Neighbourhood();

  Agreement() {}

  /** Starts a comparison: nothing has diverged yet. */
  void begin() {
    diverged = false;
  }

  /** Forgets the last comparisons because the own body has changed. */
  void reset() {
    disagreedTick = -1;
    equalTick = -1;
  }

  /**
   * Notes that all of a tick is equal.
   *
   * @param hashed whether the hash of the predicted set was compared, too
   */
  void agree(int tick, boolean hashed) {
    agreedTick = tick;
    equalTick = hashed ? tick : -1;
    disagreedTick = -1;
  }

  /**
   * Notes that a tick differs.
   *
   * @return whether it is the first difference after having been equal
   */
  boolean disagree(int tick) {
    boolean first = disagreedTick < 0;
    if (first) {
      firstDisagreedTick = tick;
      disagreements++;
    }
    disagreedTick = tick;
    return first;
  }

  /** Notes that nothing explains the first difference. */
  void diverge() {
    diverged = true;
  }

  /** Returns the newest tick whose state is known to be the server's in every bit, or -1. */
  public int agreedTick() {
    return agreedTick;
  }

  /** Returns the newest tick at which the hash of the predicted set was the server's, or -1. */
  public int equalTick() {
    return equalTick;
  }

  /**
   * Returns the newest tick at which the server had another state, or -1 if all was equal since:
   * the server should send all of it.
   */
  public int disagreedTick() {
    return disagreedTick;
  }

  /** Returns the first tick at which the server had another state, or -1 if all was equal since. */
  public int firstDisagreedTick() {
    return disagreedTick < 0 ? -1 : firstDisagreedTick;
  }

  /** Returns how often the server had another state after the states had been equal. */
  public long disagreements() {
    return disagreements;
  }

  /**
   * Returns whether the tick compared last differs from the server's without an explanation: at
   * {@link #equalTick} the states were equal, and since then all inputs were known and nothing was
   * corrected.
   */
  public boolean hasDiverged() {
    return diverged;
  }

  /** Returns the predicted state of that tick, while {@link #hasDiverged}. Do not change it. */
  public Neighbourhood divergedState() {
    return divergedState;
  }
}
