package carom.client;

import carom.client.view.ClientView;
import carom.sim.entity.Input;

/** Source of a player's input: devices, a bot or a script. Called on the client's thread. */
@FunctionalInterface
public interface InputSource {
  /** Never presses anything. */
  InputSource IDLE = (view, tick, out) -> {};

  /**
   * Samples the player's input for one tick.
   *
   * @param view what the player sees; don't keep it
   * @param tick the tick the input is for; ticks ascend, each comes once
   * @param out receives the input; everything is released and centred before
   */
  void sample(ClientView view, int tick, Input out);
}
