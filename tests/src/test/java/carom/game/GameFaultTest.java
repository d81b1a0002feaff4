package carom.game;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
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

  /** As a game of an older Carom throws them, and what other mistakes look like. */
  @Test
  void codeOfAnotherCaromIsToldSo() {
    String advice = "compile it against this one";
    List<Throwable> old =
        List.of(
            new NoSuchMethodError("'void carom.sim.Match.shout(java.lang.String)'"),
            new NoClassDefFoundError("carom/sim/Shout"),
            new AbstractMethodError("no implementation of carom.sim.Game.shout"));
    for (Throwable failure : old) {
      String words = GameFault.describe(failure);
      assertTrue(words.contains(HERE) && words.endsWith(advice), words);
    }
    List<Throwable> others =
        List.of(
            new NoClassDefFoundError("org/json/JSONObject"),
            new ExceptionInInitializerError(),
            new IllegalStateException("carom.sim.Match"));
    for (Throwable failure : others) {
      assertFalse(GameFault.describe(failure).contains(advice), failure::toString);
    }
  }

  @Test
  void aLibraryThatIsntThereIsNamedByItsClass() {
    String kotlin = GameFault.remedy(new NoClassDefFoundError("kotlin/jvm/internal/Intrinsics"));
    assertTrue(kotlin.contains("class=kotlin.jvm.internal.Intrinsics is in no jar"), kotlin);
    assertTrue(kotlin.contains("(kotlin-stdlib) beside the game's"), kotlin);
    String json = GameFault.remedy(new NoClassDefFoundError("org/json/JSONObject"));
    assertTrue(json.startsWith("; class=org.json.JSONObject is in no jar"), json);
    for (Throwable other :
        List.of(
            new NoClassDefFoundError("Could not initialize class org.json.JSONObject"),
            new NoClassDefFoundError(),
            new VerifyError("Bad type on operand stack"))) {
      assertEquals("", GameFault.remedy(other), other::toString);
    }
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
