package carom.client.settings;

import java.util.List;
import java.util.Locale;

/** The actions for which a player can choose a key. */
public enum KeyAction {
  /** Moves left. */
  LEFT("move left", "A", "Left"),
  /** Moves right. */
  RIGHT("move right", "D", "Right"),
  /** Moves up. */
  UP("move up", "W", "Up"),
  /** Moves down. */
  DOWN("move down", "S", "Down"),
  /** Does what a game does most: jumps and dashes. */
  MAIN("jump, dash, fire", "Space"),
  /** Jumps only. */
  JUMP("jump only"),
  /** Dashes or fires only. */
  ACTION("dash, fire only", "L-Shift", "R-Shift"),
  /** Makes the second move. */
  SECOND("second move", "E"),
  /** Shows all players while it is held. */
  PLAYERS("players and teams", "Tab"),
  /** Begins a line to all. */
  CHAT("chat", "Enter"),
  /** Begins a line to the team. */
  TEAM_CHAT("chat to the team", "T"),
  /** Switches the sound off and on. */
  MUTE("sound off, on", "M");

  private final String label;
  private final List<String> defaults;

  KeyAction(String label, String... defaults) {
    this.label = label;
    this.defaults = List.of(defaults);
  }

  /** Returns what it does, for people. */
  public String label() {
    return label;
  }

  /** Returns the names of its keys unless the player chooses others. */
  public List<String> defaults() {
    return defaults;
  }

  /** Returns its name in the settings file, such as {@code key.left}. */
  String settingName() {
    return "key." + name().toLowerCase(Locale.ROOT).replace('_', '-');
  }
}
