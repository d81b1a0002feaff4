package carom.client.desktop.menu;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.settings.KeyAction;
import carom.client.settings.PlayerSettings;
import com.badlogic.gdx.Input.Keys;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** Goal: the keys that a player chose do what the player chose them for. */
class KeyMapTest {
  @Test
  void eachDefaultIsAKeyAndDoesOneThing() {
    PlayerSettings s = PlayerSettings.defaults();
    assertEquals(List.of(), new KeyMap(s.keys()).unknown());
    Set<String> seen = new HashSet<>();
    for (KeyAction action : KeyAction.values()) {
      action.defaults().forEach(key -> assertTrue(seen.add(key), key + " does two things"));
    }
  }

  @Test
  void aChosenKeyReplacesTheDefault() {
    KeyMap keys = new KeyMap(PlayerSettings.defaults().keys());
    assertTrue(keys.does(Keys.M, KeyAction.MUTE));
    keys.set(PlayerSettings.defaults().withKeys(KeyAction.MUTE, List.of("F7", "Blank")).keys());
    assertFalse(keys.does(Keys.M, KeyAction.MUTE));
    assertTrue(keys.does(Keys.F7, KeyAction.MUTE));
    assertEquals("F7", keys.first(KeyAction.MUTE));
    assertEquals("-", keys.first(KeyAction.JUMP));
    assertEquals(List.of("Blank"), keys.unknown());
  }
}
