package carom.client.desktop;

import carom.client.link.ServerAddress;
import java.util.function.UnaryOperator;

/** Tells a player who is alone in a game how bots come into it. */
final class AloneAdvice {
  /** Set where gradlew starts the programs for a person at a terminal. */
  private static final boolean FROM_SOURCES = Boolean.getBoolean("carom.terminal");

  private static final String BEGIN = "You are alone here. For bots: ";

  private AloneAdvice() {}

  /**
   * Returns the advice in a room, by its name.
   *
   * @param here whether the player started the game on this machine from the start screen
   * @param server address of the server otherwise
   */
  static UnaryOperator<String> of(boolean here, ServerAddress server) {
    return room ->
        BEGIN
            + (here
                ? "Esc, Leave the game, Play here"
                : command(FROM_SOURCES, server.toText(), room));
  }

  /**
   * Returns the command that brings bots.
   *
   * @param sources whether it is Gradle's, else that of an installation
   * @param server address of the server
   * @param room its room; a server's only one without a name is called 1
   */
  static String command(boolean sources, String server, String room) {
    String where = "--host " + server + (room.equals("1") ? "" : " --room " + room);
    if (!sources) {
      return "carom-bots " + where;
    }
    return "./gradlew bots" + (where.equals("--host localhost") ? "" : " -Pargs='" + where + "'");
  }
}
