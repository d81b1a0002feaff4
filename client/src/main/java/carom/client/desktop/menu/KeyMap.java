package carom.client.desktop.menu;

import carom.client.settings.KeyAction;
import com.badlogic.gdx.Gdx;
import com.badlogic.gdx.Input.Keys;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;

/**
 * The action of each key, as the player has set it. One for the window; it changes with the
 * settings. Render thread only.
 */
public final class KeyMap {
  private final Map<KeyAction, int[]> codes = new EnumMap<>(KeyAction.class);
  private Map<KeyAction, List<String>> names = Map.of();

  /**
   * Creates a map.
   *
   * @param names names of the keys of each action, as the toolkit calls them
   */
  public KeyMap(Map<KeyAction, List<String>> names) {
    set(names);
  }

  /** Sets the keys of each action. A name that is no key's does nothing. */
  public void set(Map<KeyAction, List<String>> newNames) {
    names = newNames;
    names.forEach(
        (action, keys) ->
            codes.put(action, keys.stream().mapToInt(Keys::valueOf).filter(k -> k >= 0).toArray()));
  }

  /** Returns the names that are no key's, such as {@code "Blank"}. */
  public List<String> unknown() {
    List<String> unknown = new ArrayList<>();
    for (List<String> keys : names.values()) {
      keys.stream().filter(key -> Keys.valueOf(key) < 0).forEach(unknown::add);
    }
    return unknown;
  }

  /** Returns whether a key of an action is held. */
  public boolean isDown(KeyAction action) {
    for (int code : codes.get(action)) {
      if (Gdx.input.isKeyPressed(code)) {
        return true;
      }
    }
    return false;
  }

  /** Returns whether a key does an action. */
  public boolean does(int key, KeyAction action) {
    for (int code : codes.get(action)) {
      if (code == key) {
        return true;
      }
    }
    return false;
  }

  /** Returns the first key of an action, for people; a dash for none. */
  public String first(KeyAction action) {
    List<String> keys = names.get(action);
    return keys.isEmpty() ? "-" : keys.get(0);
  }

  /** Returns all keys of an action, for people; a dash for none. */
  public static String all(List<String> keys) {
    return keys.isEmpty() ? "-" : String.join(", ", keys);
  }
}
