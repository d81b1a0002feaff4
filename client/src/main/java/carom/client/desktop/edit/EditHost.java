package carom.client.desktop.edit;

import carom.sim.level.Level;

/** Receives what the player of an editor asks of the window. Render thread only. */
public interface EditHost {
  /**
   * Plays a level on this machine. The editor stays as it is meanwhile.
   *
   * @param bots players that the machine plays
   * @throws IllegalStateException in words for the player, when it can't be played
   */
  void play(Level level, int bots);

  /** Returns what is legal in a level and surely not meant, in a line; empty for nothing. */
  String warning(Level level);

  /** Leaves the editor. */
  void leave();
}
