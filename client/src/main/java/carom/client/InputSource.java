package carom.client;

import carom.client.view.ClientView;
import carom.sim.Input;

/** Whoever plays: a person at a keyboard, a bot, a script. Called on the client's thread. */
@FunctionalInterface
public interface InputSource {
  /** Presses nothing. */
  InputSource IDLE = (view, tick, out) -> {};

  /**
   * Fills in the player's commands for one tick.
   *
   * @param view what the player sees; do not keep it
   * @param tick the tick the input is for; each tick is asked for once, ascending
   * @param out released and centred when handed in
   */
  void sample(ClientView view, int tick, Input out);
}
