package carom.sim.field;

import carom.physics.math.Limits;

/**
 * A wait that clients show around the own body while it runs, such as the time until the next dash.
 *
 * @param label what the player waits for, in a word
 * @param countdown field of the player, told to its owner at least
 * @param seconds how long the wait is when it begins, above 0
 */
public record Cooldown(String label, Countdown countdown, float seconds) {
  /**
   * Checks the time.
   *
   * @throws IllegalArgumentException when it isn't above 0
   */
  public Cooldown {
    Limits.notNull("label", label);
    Limits.notNull("countdown", countdown);
    if (!(seconds > 0)) {
      throw new IllegalArgumentException("seconds=" + seconds + " of cooldown " + label + " <= 0");
    }
  }
}
