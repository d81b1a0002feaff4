package carom.client.desktop.menu;

import carom.client.settings.PlayerSettings;

/** Holds the settings that menus show, and applies what the player changes. Render thread only. */
public interface SettingsHost {
  /** Returns width and height of the screen, px: the largest that a window can be. */
  int[] largestWindow();

  /** Returns the present settings. */
  PlayerSettings settings();

  /** Applies changed settings at once and keeps them. */
  void change(PlayerSettings changed);

  /** Returns the keys of the window and of the game that is shown. */
  KeyMap keys();

  /** Returns the name to play under: that of the command line until the player types another. */
  String playerName();

  /** Sets the name to play under, and keeps it among the settings if it is another one. */
  void playerName(String name);

  /** Returns the player's party: that of the command line until the player types another. */
  String party();

  /** Sets the player's party, empty for none, and keeps it as {@link #playerName(String)} does. */
  void party(String party);

  /** Returns what couldn't be read or kept, in words for the player; empty if nothing. */
  String problem();
}
