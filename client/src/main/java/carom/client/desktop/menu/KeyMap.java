package carom.client.desktop.menu;

import carom.client.look.Action;
import carom.client.settings.KeyAction;
import carom.client.settings.PlayerSettings;
import com.badlogic.gdx.Gdx;
import com.badlogic.gdx.Input.Keys;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * The action of each key, as the player has set it: those of the window, and those of the game that
 * is shown, which come first. One for the window; it changes with the settings and with the game.
 * Render thread only.
 */
public final class KeyMap {
  private static final int[] NONE = {};

  private final Map<KeyAction, int[]> codes = new EnumMap<>(KeyAction.class);
  private final Map<String, int[]> gameCodes = new HashMap<>();
  private PlayerSettings settings;
  private String game = "";
  private List<Action> actions = List.of();

  /** Creates a map for the keys of a player's settings, without a game. */
  public KeyMap(PlayerSettings settings) {
    set(settings);
  }

  /** Sets the keys that the player has chosen. A name that is no key's does nothing. */
  public void set(PlayerSettings changed) {
    settings = changed;
    settings.keys().forEach((action, keys) -> codes.put(action, codes(keys)));
    gameCodes.clear();
    for (Action action : actions) {
      action.bindings().forEach(b -> gameCodes.put(b.name(), codes(names(b))));
    }
  }

  /** Sets the game that is shown, and its own actions. */
  public void game(String name, List<Action> own) {
    if (!name.equals(game) || own != actions) {
      game = name;
      actions = own;
      set(settings);
    }
  }

  private static int[] codes(List<String> names) {
    return names.stream().mapToInt(Keys::valueOf).filter(code -> code >= 0).toArray();
  }

  /** Returns the names that are no key's, such as {@code "Blank"}. */
  public List<String> unknown() {
    List<String> unknown = new ArrayList<>();
    settings.keys().values().forEach(unknown::addAll);
    actions.forEach(action -> action.bindings().forEach(b -> unknown.addAll(names(b))));
    unknown.removeIf(key -> Keys.valueOf(key) >= 0);
    return unknown;
  }

  /** Returns the actions of the game that is shown; empty for the usual ones. */
  public List<Action> actions() {
    return actions;
  }

  /** Returns whether a key of an action is held. */
  public boolean isDown(KeyAction action) {
    return isDown(codes.get(action));
  }

  /** Returns whether a key of an action of the game is held. */
  public boolean isDown(Action.Binding binding) {
    return isDown(gameCodes.getOrDefault(binding.name(), NONE));
  }

  /**
   * Returns whether a key of an action went down since the last picture, even if it is up again.
   */
  public boolean isTapped(KeyAction action) {
    return isTapped(codes.get(action));
  }

  /** Returns whether a key of an action of the game went down since the last picture. */
  public boolean isTapped(Action.Binding binding) {
    return isTapped(gameCodes.getOrDefault(binding.name(), NONE));
  }

  private static boolean isDown(int[] keys) {
    for (int code : keys) {
      if (Gdx.input.isKeyPressed(code)) {
        return true;
      }
    }
    return false;
  }

  private static boolean isTapped(int[] keys) {
    for (int code : keys) {
      if (Gdx.input.isKeyJustPressed(code)) {
        return true;
      }
    }
    return false;
  }

  /** Returns whether a key does an action, and none of the game. */
  public boolean does(int key, KeyAction action) {
    return !isOfGame(key) && has(codes.get(action), key);
  }

  /** Returns whether a key does something that the game itself has named. */
  public boolean isOfGame(int key) {
    for (int[] keys : gameCodes.values()) {
      if (has(keys, key)) {
        return true;
      }
    }
    return false;
  }

  private static boolean has(int[] keys, int key) {
    for (int code : keys) {
      if (code == key) {
        return true;
      }
    }
    return false;
  }

  /** Returns the first key of an action, for people; a dash for none. */
  public String first(KeyAction action) {
    return first(settings.keys().get(action));
  }

  /** Returns the first key of an action of the game, for people; a dash for none. */
  public String first(Action.Binding binding) {
    return first(names(binding));
  }

  private static String first(List<String> keys) {
    return keys.isEmpty() ? "-" : keys.get(0);
  }

  /** Returns the names of the keys of an action of the game: the player's, or else the game's. */
  public List<String> names(Action.Binding binding) {
    List<String> chosen = settings.gameKeys(game, binding.name());
    return chosen == null ? binding.keys() : chosen;
  }

  /** Returns the settings with other keys for an action of the game; its others lose these. */
  public PlayerSettings withKeys(Action.Binding chosen, List<String> names) {
    PlayerSettings changed = settings;
    for (Action action : actions) {
      for (Action.Binding other : action.bindings()) {
        List<String> left = new ArrayList<>(names(other));
        if (!other.name().equals(chosen.name()) && left.removeAll(names)) {
          changed = changed.withGameKeys(game, other.name(), left);
        }
      }
    }
    return changed.withGameKeys(game, chosen.name(), names);
  }

  /** Returns all keys of an action, for people; a dash for none. */
  public static String all(List<String> keys) {
    return keys.isEmpty() ? "-" : String.join(", ", keys);
  }
}
