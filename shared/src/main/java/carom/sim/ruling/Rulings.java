package carom.sim.ruling;

import carom.sim.entity.HostPlayer;

/**
 * Tells a predicted simulation what the server computes and it can't: the effects of rules, which
 * it doesn't run, and of inputs that read what it isn't told. It is asked at the moments at which
 * the server calls {@code Game.beforeStep}, {@code input} and {@code afterStep}.
 */
public interface Rulings {
  /** Applies what the rules of the tick being computed did before the inputs. */
  void beforeStep();

  /**
   * Applies what a player's input of the tick being computed did, if the server has told it.
   *
   * @return whether it has; if so, {@code Game.input} isn't called
   */
  boolean input(HostPlayer player);

  /**
   * Notes that a player's input of the tick being computed has read a field that not all players
   * near are told. Its effect is a guess, unless the field's value is known here.
   *
   * @param untold whether it has read one that no player is told
   */
  void readHidden(HostPlayer player, boolean untold);

  /** Applies what the rules of the tick being computed did after the physics. */
  void afterStep();
}
