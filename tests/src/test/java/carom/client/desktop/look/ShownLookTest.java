package carom.client.desktop.look;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.look.Action;
import carom.client.look.GameView;
import carom.client.look.GameViews;
import carom.client.look.ViewSetup;
import carom.sim.entity.Input;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Goal: a game has the look of its view, and the usual one when the view fails. */
final class ShownLookTest {
  private final List<String> told = new ArrayList<>();
  private final ShownLook look = new ShownLook(told::add);

  /** A view that declares an action and then does what a test says. */
  private record Declares(String game, Runnable then) implements GameView {
    @Override
    public void setUp(ViewSetup v) {
      v.actions(Action.button("jump", Input.JUMP).key("W"));
      then.run();
    }
  }

  @Test
  void aGameHasTheLookOfItsView() {
    GameViews.add(() -> new Declares("look-fine", () -> {}));
    assertTrue(look.show("look-fine"));
    assertEquals("jump", look.setup().actions().get(0).name());
    assertFalse(look.show("look-fine"), "it is looked for once");
    assertTrue(look.show("arena"));
    assertEquals(List.of(), look.setup().actions(), "another game has its own");
    assertEquals(List.of(), told);
  }

  @Test
  void aViewThatFailsCostsOneMessageAndNothingOfItStays() {
    GameViews.add(
        () ->
            new Declares(
                "look-throws",
                () -> {
                  throw new IllegalStateException("not today");
                }));
    GameViews.add(
        () ->
            new Declares(
                "look-lacks",
                () -> {
                  throw new NoClassDefFoundError("lib/Gone");
                }));
    for (String game : List.of("look-throws", "look-lacks")) {
      told.clear();
      look.show(game);
      look.show(game);
      assertEquals(List.of(), look.setup().actions());
      assertEquals(List.of("The game's own look failed, so it has the usual one"), told);
    }
  }

  @Test
  void shippedGamesAreFoundByTheirNames() {
    look.show("rockets");
    assertEquals(6, look.setup().actions().size());
    look.show("platformer");
    assertEquals(0, look.setup().actions().size());
  }

  @Test
  void namesThatNothingHasAreFound() {
    look.show("rockets");
    List<String> things =
        new ArrayList<>(List.of("player", "rocket", "wall", "side wall", "pillar"));
    things.addAll(List.of("crate", "planet", "rock.large", "rock.medium", "rock.small"));
    things.addAll(List.of("bolt", "torpedo", "mine", "repair", "scatter", "torpedoes", "mines"));
    List<String> events = List.of("shot", "boom", "spark", "blocked", "crack", "taken", "wreck");
    assertEquals(0, look.check(things, events));
    things.remove("crate");
    things.set(0, "plyer");
    assertEquals(2, look.check(things, events));
    things.set(0, "player");
    things.add("crate");
    assertEquals(1, look.check(things, events.subList(1, events.size())));
  }
}
