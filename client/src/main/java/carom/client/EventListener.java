package carom.client;

import carom.sim.outbox.Event;

/** Receives the events of a game, each one once. Called on the client's thread. */
public interface EventListener {
  /** Ignores all events. */
  EventListener NONE = (event, predicted) -> {};

  /**
   * Receives an event that happens now.
   *
   * @param event valid during the call only
   * @param predicted whether the event is the own player's and the server has not confirmed it yet
   */
  void happened(Event event, boolean predicted);

  /**
   * Receives a predicted event that did not happen: the server has sent all events up to its tick
   * and a little beyond, and it was not among them.
   *
   * @param event as it was predicted; valid during the call only
   */
  default void retracted(Event event) {}
}
