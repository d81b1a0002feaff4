package carom.client.events;

import carom.sim.Event;

/** Hears what happens in the game, each thing once, on the client's thread. */
public interface EventListener {
  /** Hears nothing. */
  EventListener NONE = (event, foreseen) -> {};

  /**
   * Something happens now.
   *
   * @param event valid during the call only
   * @param foreseen whether it is the own player's, predicted, and not confirmed by the server yet
   */
  void happened(Event event, boolean foreseen);

  /**
   * Something foreseen did not happen: the server has told everything up to then and a little
   * beyond, and it wasn't among it.
   *
   * @param event as it was foreseen; valid during the call only
   */
  default void retracted(Event event) {}
}
