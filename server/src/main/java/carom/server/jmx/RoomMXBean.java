package carom.server.jmx;

/**
 * The operations of a running room that an operator can call with any JMX tool, such as {@code
 * jconsole}, under the name {@code carom:type=Room,number=1}. Public, because JMX requires it.
 */
public interface RoomMXBean {
  /** Returns the last tick that was computed. */
  int getTick();

  /**
   * Explains why the server did not send an entity to a player, or that it did: the reason, the
   * baseline, the priority collected and the priority needed.
   *
   * @param player a player's id, see the log's lines about joins
   * @param entity an entity's id
   */
  String why(int player, int entity);

  /**
   * Returns the names and values of fields, also of those that stay on the server.
   *
   * @param of {@code match}, {@code player N} or {@code entity N}
   */
  String fields(String of);

  /**
   * Removes a player. The player may join again.
   *
   * @param player a player's id, see the log's lines about joins
   * @param text a message to the player, may be empty
   */
  String kick(int player, String text);

  /**
   * Says a line to everybody in the room.
   *
   * @param text 1..120 characters
   */
  String say(String text);

  /**
   * Drops a player's chat and emotes for the rest of its stay.
   *
   * @param name the player's, in any case
   */
  String mute(String name);

  /** Lets a player who was muted chat again. */
  String unmute(String name);

  /** Makes a player a spectator, who may ask to play again. */
  String spectate(String name);

  /**
   * Goes on with another game or level. Players and their links stay.
   *
   * @param game name of the game; empty for the one that the level is made for
   * @param level level file, or the name of a level that comes with the program; empty for the
   *     default level of the game
   * @return what the room plays now, or why it goes on as it is
   */
  String change(String game, String level);

  /**
   * Begins to record the game.
   *
   * @param target a new file, or a folder in which the server creates one; relative to the server's
   *     working directory
   * @return the file, or why there is none: the room is being recorded already, the file exists or
   *     can't be created, or the game can be recorded from its start on only
   */
  String record(String target);

  /**
   * Ends the recording, also one begun by {@code --record} or {@code --record-rotate}, and waits
   * until the file is complete, for at most 5 s. A recording that spectators watch goes on.
   *
   * @return the file and its last tick, and whether the disk takes longer; or why no recording
   *     ended
   */
  String stopRecording();
}
