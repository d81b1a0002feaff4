package carom.server.session;

/** Takes lines of chat that are commands. */
@FunctionalInterface
public interface ChatCommands {
  /** Prefix of a line of chat that is a command. */
  String BEGIN = "/";

  /** Takes none: all lines are chat. */
  ChatCommands NONE = (player, line) -> false;

  /**
   * Takes a line that begins with {@link #BEGIN}. The room's thread calls it, so it must not wait.
   *
   * @return false when the player may give no commands; the line is chat then
   */
  boolean take(PlayerInfo player, String line);
}
