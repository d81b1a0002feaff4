package carom.client.message;

import carom.sim.message.Emote;
import carom.sim.message.Message;

/** Hears what the game at the server and other players say. All methods do nothing by default. */
public interface MessageListener {
  /** Hears nothing. */
  MessageListener NONE = new MessageListener() {};

  /** A message of the game has arrived: each reliable one once, in the order it was sent. */
  default void heard(Message message) {}

  /**
   * Somebody said a line.
   *
   * @param player who, or {@link carom.sim.message.BuiltInKinds#SERVER}
   * @param team whether only the team hears it
   */
  default void said(int player, boolean team, String text) {}

  /** A player shows an emote. */
  default void emoted(int player, Emote emote) {}

  /**
   * Reliable messages of the server are lost: the link was broken for so long that it no longer
   * keeps them.
   */
  default void missed(int count) {}

  /** A reliable message never reached the server: the session it was meant for is over. */
  default void unsent(Message message) {}
}
