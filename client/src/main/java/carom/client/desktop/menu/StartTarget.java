package carom.client.desktop.menu;

import carom.client.app.LocalGames;
import carom.client.link.LanSearch;
import carom.client.link.RoomBrowser;
import carom.client.link.ServerAddress;
import carom.sim.scene.Scene;
import java.nio.file.Path;

/** Receives what the player chooses on the start screen. Render thread only. */
public interface StartTarget {
  /**
   * Sets the password that is shown to a server; before {@link #play} and {@link #watch}.
   *
   * @param text what the player has typed; empty for none, or what the flags say of that server
   */
  void password(ServerAddress server, String text);

  /**
   * Plays on a server.
   *
   * @param room name of the room; empty for any
   */
  void play(ServerAddress server, String room);

  /**
   * Starts a server on this machine and plays there.
   *
   * @throws IllegalStateException in words for the player, when it can't be started
   */
  void create(LocalGames.GameChoice choice);

  /** Watches a room of a server, by its number from 1 on. */
  void watch(ServerAddress server, int room);

  /** Shows a recording. Returns why it can't, in words for the player; empty if it can. */
  String replay(Path file);

  /** Edits a level file, or begins a new one. Returns why it can't, or an empty text. */
  String edit(Path file);

  /** Shows a scene. */
  void scene(Scene scene);

  /** Quits the program. */
  void quit();

  /** Begins to search the local network for servers; null if the system doesn't allow it. */
  LanSearch searchLan();

  /** Asks a server for its rooms. */
  RoomBrowser browse(ServerAddress server);
}
