package carom.physics.threads;

/**
 * Decides which steps of one caller are shared with other threads, by how long they take.
 *
 * <p>Where more threads want a processor than there are, a helper loses its one in the midst of a
 * task and its caller waits for milliseconds, or the caller loses its own to a helper: a shared
 * step takes up to twice as long as one alone. That shows only in the time of whole steps. So when
 * a caller had to wait for long, half of the next steps are shared, and what was faster is kept for
 * a while. As long as no caller waits, every step is shared. A caller that steps alone tries again
 * soon, then ever more rarely. Which half is told by the parity of the bits of the step's number
 * (the sequence of Thue and Morse): worlds that one caller steps by turns, and work that grows,
 * weigh on both sides alike.
 *
 * <p>Times come from the caller, in ns of any clock. One thread at a time.
 */
final class Sharing {
  /** Wait at the end of a run, ns, beyond which the other thread seems not to be running. */
  static final long LONG_WAIT_NS = 300_000;

  /** Steps of a trial, half of them shared. */
  static final int TRIAL_STEPS = 16;

  /** Steps until the next trial, if there is reason for one. */
  static final int STEPS_BETWEEN = 240;

  /** Steps until the next trial after the first one that told against sharing, by chance maybe. */
  private static final int STEPS_AT_FIRST = TRIAL_STEPS;

  /** Steps that are left of the trial at hand. */
  private int trial;

  /** Steps that are left until the next trial. */
  private int left;

  /** Tells whether steps are shared between trials. */
  private boolean pays = true;

  /** Tells whether the step at hand is shared. */
  private boolean shared;

  /** Steps alone before the next trial. */
  private int rest = STEPS_AT_FIRST;

  /** Tells whether a step is on. */
  private boolean on;

  /** Tells whether a caller waited for long since the last trial. */
  private boolean waited;

  private long begin;
  private long sharedNs;
  private long aloneNs;

  /**
   * Begins a step.
   *
   * @param now ns
   * @return whether it should be shared
   */
  boolean begins(long now) {
    if (trial == 0 && left == 0 && (waited || !pays)) {
      trial = TRIAL_STEPS;
      sharedNs = 0;
      aloneNs = 0;
    }
    shared = trial > 0 ? (Integer.bitCount(trial - 1) & 1) == 0 : pays;
    begin = now;
    on = true;
    return shared;
  }

  /** Returns whether a step is on that isn't shared. */
  boolean isAlone() {
    return on && !shared;
  }

  /**
   * Notes that a run of the step ended.
   *
   * @param ns for which its caller waited for others
   */
  void waited(long ns) {
    waited |= ns > LONG_WAIT_NS;
  }

  /**
   * Ends the step. Does nothing when none is on.
   *
   * @param now ns
   */
  void ends(long now) {
    if (!on) {
      return;
    }
    on = false;
    if (trial == 0) {
      left = Math.max(left - 1, 0);
      return;
    }
    if (shared) {
      sharedNs += now - begin;
    } else {
      aloneNs += now - begin;
    }
    trial--;
    if (trial == 0) {
      pays = sharedNs <= aloneNs;
      waited = false;
      left = pays ? STEPS_BETWEEN : rest;
      rest = pays ? STEPS_AT_FIRST : Math.min(2 * rest, STEPS_BETWEEN);
    }
  }
}
