package carom.client.desktop;

import carom.client.LevelSender;
import carom.sim.level.Level;
import java.util.List;

/** Receives what the player of an editor asks of the window. Render thread only. */
interface EditHost {
  /**
   * Plays a level on this machine. The editor stays as it is meanwhile.
   *
   * @param bots players that the machine plays
   * @throws IllegalStateException in words for the player, when it can't be played
   */
  void play(Level level, int bots);

  /** Returns the addresses of servers to which a level may be sent, the likeliest first. */
  List<String> servers();

  /**
   * Begins to send a level to a server.
   *
   * @param server one of {@link #servers}
   * @param level bytes of the file
   */
  LevelSender send(String server, byte[] level);

  /** Returns what is legal in a level and surely not meant, in a line; empty for nothing. */
  String warning(Level level);

  /** Leaves the editor. */
  void leave();
}
