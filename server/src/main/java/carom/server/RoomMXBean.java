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

  /**
   * Begins to record the game, from now on.
   *
   * @param target a file that is not there yet, or a folder, which then gets a file with a name of
   *     its own; relative to the folder the server was started in
   * @return which file, or why there is none: recorded already, the file exists or can't be
   *     created, a game that can be recorded from its start on only
   */
  String record(String target);

  /**
   * Ends the recording, also one by {@code --record} or {@code --record-rotate}, and waits until
   * the file is whole, for at most 5 s. One that spectators watch goes on.
   *
   * @return which file and up to which tick, and whether the disk takes longer; or why there is
   *     none
   */
  String stopRecording();
}
