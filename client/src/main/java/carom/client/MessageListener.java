package carom.client;

import carom.sim.message.Emote;
import carom.sim.message.Message;

/** Hears what the game at the server and other players say. All methods do nothing by default. */
public interface MessageListener {
  /** Hears nothing. */
  MessageListener NONE = new MessageListener() {};

  /** Receives a message of the game: each reliable one once, in the order it was sent. */
  default void heard(Message message) {}

  /**
   * Receives a line of chat.
   *
   * @param player who, or {@link carom.sim.message.BuiltInKinds#SERVER}
   * @param team whether only the team hears it
   */
  default void said(int player, boolean team, String text) {}

  /** Receives an emote of a player. */
  default void emoted(int player, Emote emote) {}

  /**
   * Counts reliable messages of the server that are lost: the link was broken for so long that it
   * no longer keeps them.
   */
  default void missed(int count) {}

  /**
   * Receives a reliable message that never reached the server: the session it was meant for is
   * over.
   */
  default void unsent(Message message) {}
}
