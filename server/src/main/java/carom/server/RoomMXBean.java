package carom.server;

/**
 * What an operator can ask a running room with any JMX tool, such as {@code jconsole}, under the
 * name {@code carom:type=Room,number=1}. Public, because JMX wants it so.
 */
public interface RoomMXBean {
  /** The last tick that was computed. */
  int getTick();

  /**
   * Why a player was not sent an entity, or that it was: reason, baseline, priority collected and
   * needed.
   *
   * @param player a player's id, see the log's lines about who joined
   * @param entity an entity's id
   */
  String why(int player, int entity);

  /**
   * Removes a player, who may join again.
   *
   * @param player a player's id, see the log's lines about who joined
   * @param text for the player, may be empty
   */
  String kick(int player, String text);
}
