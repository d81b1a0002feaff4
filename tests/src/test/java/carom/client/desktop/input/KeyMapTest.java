package carom.client.desktop.input;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.look.Action;
import carom.client.settings.KeyAction;
import carom.client.settings.PlayerSettings;
import carom.sim.entity.Input;
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
    assertEquals(List.of(), new KeyMap(s).unknown());
    Set<String> seen = new HashSet<>();
    for (KeyAction action : KeyAction.values()) {
      action.defaults().forEach(key -> assertTrue(seen.add(key), key + " does two things"));
    }
  }

  @Test
  void aChosenKeyReplacesTheDefault() {
    KeyMap keys = new KeyMap(PlayerSettings.defaults());
    assertTrue(keys.does(Keys.M, KeyAction.MUTE));
    keys.set(PlayerSettings.defaults().withKeys(KeyAction.MUTE, List.of("F7", "Blank")));
    assertFalse(keys.does(Keys.M, KeyAction.MUTE));
    assertTrue(keys.does(Keys.F7, KeyAction.MUTE));
    assertEquals("F7", keys.first(KeyAction.MUTE));
    assertEquals("-", keys.first(KeyAction.JUMP));
    assertEquals(List.of("Blank"), keys.unknown());
  }

  @Test
  void aKeyOfTheGameDoesNothingElseThere() {
    PlayerSettings s = PlayerSettings.defaults();
    KeyMap keys = new KeyMap(s);
    Action shout = Action.button("shout", Input.SECOND).key("T", "Num 5");
    Action jump = Action.button("jump", Input.JUMP).key("W");
    keys.game("tag", List.of(shout, jump));
    assertTrue(keys.isOfGame(Keys.T));
    assertFalse(keys.does(Keys.T, KeyAction.TEAM_CHAT));
    assertEquals(List.of("Num 5"), keys.unknown());

    PlayerSettings chosen = keys.withKeys(shout.bindings().get(0), List.of("W"));
    keys.set(chosen);
    assertEquals("W", keys.first(shout.bindings().get(0)));
    assertEquals("-", keys.first(jump.bindings().get(0)), "a key does one thing");
    assertTrue(keys.does(Keys.T, KeyAction.TEAM_CHAT));

    keys.game("other", List.of(shout));
    assertEquals("T", keys.first(shout.bindings().get(0)), "another game has its own keys");
    keys.game("", List.of());
    assertFalse(keys.isOfGame(Keys.T));
    assertEquals(s, chosen.withDefaultKeys());
  }
}
