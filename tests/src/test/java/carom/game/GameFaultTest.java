package carom.game;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.look.Action;
import carom.client.look.HudItem;
import carom.client.look.ViewSetup;
import carom.physics.Material;
import carom.physics.geometry.Circle;
import carom.sim.event.Audience;
import carom.sim.event.Sound;
import carom.sim.field.Field;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;

/** What people read about a game's or view's code that was refused: it names the line. */
class GameFaultTest {
  private static final String HERE = ", at " + GameFaultTest.class.getName() + ".";

  @Test
  void whatTheEngineRefusesNamesTheLineThatCalledIt() {
    List<Executable> mistakes =
        List.of(
            () -> new Circle(-1),
            () -> new Material(-1, 0, 0),
            () -> Field.count("Health", 0, 9),
            () -> Integer.parseInt("nine"));
    for (Executable mistake : mistakes) {
      var refused = assertThrows(IllegalArgumentException.class, mistake);
      String words = GameFault.refusal(GameFaultTest.class, refused);
      assertTrue(words.startsWith(refused.getMessage() + HERE), words);
      assertTrue(words.matches(".*:\\d+"), words);
    }
  }

  @Test
  void whatTheGameItselfRefusesStaysAsItSaysIt() {
    var refused = new IllegalArgumentException("the level needs a zone named \"ring\"");
    assertEquals(refused.getMessage(), GameFault.refusal(GameFaultTest.class, refused));
    assertEquals(refused.getMessage(), GameFault.refusal(Sound.class, refused), "not of the game");
  }

  @Test
  void whatViewsDeclareWronglyNamesTheLineOfTheView() {
    ViewSetup v = new ViewSetup();
    List<Executable> mistakes =
        List.of(
            () -> Action.button("shoot", 1).pad("R2"),
            () -> v.hud(HudItem.number("n", Field.count("n").to(Audience.NOBODY))),
            () -> v.sprite("ball", null),
            () -> v.camera().height(-1));
    for (Executable mistake : mistakes) {
      String words = GameFault.describe(assertThrows(RuntimeException.class, mistake));
      assertTrue(words.contains(HERE), words);
    }
  }
}
