package carom.client.bots;

import carom.sim.entity.Input;

/**
 * The play of a game's bots. A game's jar brings one as a service: a class with a public
 * constructor without parameters whose name is listed in {@code
 * META-INF/services/carom.client.bots.BotBrain}. {@code carom-bots}, the bots of a game that the
 * client starts, and {@code carom test} use it; without one, bots try all keys.
 *
 * <p>Each bot has an instance of its own, called on one thread, so it may remember things. It knows
 * what a player's screen shows, and commands what a player's hands can. Servers never load it.
 */
public interface BotBrain {
  /** Returns the name of the game that it plays, as {@link carom.sim.Game#name}. */
  String game();

  /**
   * Sets how well it plays, before it decides for the first time; it may ignore that. Bots that a
   * server orders with a strength are told it; all others choose for themselves.
   */
  default void strength(Strength strength) {}

  /**
   * Decides the input of one tick. Called only while the bot has a body.
   *
   * @param senses what the bot sees; the same object at every call
   * @param out receives the input; everything is released and centred before
   */
  void decide(Senses senses, Input out);
}
