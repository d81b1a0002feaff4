package carom.client.desktop;

import static org.junit.jupiter.api.Assertions.assertEquals;

import carom.client.desktop.menu.KeyMap;
import carom.client.look.Action;
import carom.client.settings.PlayerSettings;
import carom.sim.entity.Input;
import java.util.List;
import org.junit.jupiter.api.Test;

class ActionHintsTest {
  private final KeyMap keys = new KeyMap(PlayerSettings.defaults());

  private List<String> shown() {
    return ActionHints.all(keys).stream().map(hint -> hint.key() + ": " + hint.does()).toList();
  }

  @Test
  void aGameWithoutActionsHasTheUsualMovements() {
    assertEquals(List.of("W A S D, pad: move"), shown());
  }

  @Test
  void aGameThatPointsAtPlacesHasNoMovementsAndTheMouse() {
    keys.game(
        "golf",
        List.of(
            Action.point("putt to", 12).mouse("pointer").stick("left"),
            Action.button("putt", Input.ACTION).key("Space").mouse("left").pad("A"),
            Action.button("again", 1 << 5).mouse("right"),
            Action.button("only by pad", 1 << 6).pad("B")));
    assertEquals(
        List.of("mouse: putt to", "Space, left click: putt", "right click: again"), shown());
  }

  @Test
  void movementsOfTheGameTakeThePlaceOfTheUsual() {
    keys.game("car", List.of(Action.moveX("back", "drive").keys("A", "D")));
    assertEquals(List.of("A: back", "D: drive"), shown());
  }
}
