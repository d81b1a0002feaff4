package carom.client.desktop.game;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.look.Action;
import carom.client.look.GameView;
import carom.client.look.GameViews;
import carom.client.look.ViewSetup;
import carom.game.Games;
import carom.server.match.MatchLibrary;
import carom.sim.Role;
import carom.sim.SimulationHost;
import carom.sim.entity.Input;
import carom.sim.level.Level;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
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
    assertTrue(look.show("look-none"));
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
      String reason = game.equals("look-throws") ? "IllegalStateException: not today" : "lib/Gone";
      assertEquals(1, told.size());
      assertTrue(
          told.get(0).startsWith("The game's own look failed, so it has the usual one: java.lang."),
          told.get(0));
      assertTrue(told.get(0).contains(reason + ", at carom.client.desktop.game."), told.get(0));
    }
  }

  @Test
  void shippedGamesAreFoundByTheirNames() {
    look.show("rockets");
    assertEquals(6, look.setup().actions().size());
    look.show("platformer");
    assertEquals(3, look.setup().actions().size());
    look.show("look-none");
    assertEquals(0, look.setup().actions().size());
  }

  @Test
  void noShippedLevelOfAGameWithAViewWarns() throws Exception {
    List<String> looked = new ArrayList<>();
    for (String name : MatchLibrary.builtInLevels()) {
      Level level = Level.builtIn(name);
      look.show(level.gameName());
      SimulationHost s =
          new SimulationHost(Games.create(level.gameName()), level, 0, 60, Role.PREDICTION);
      Set<String> things = new HashSet<>();
      s.world().forEachBody(body -> things.add(body.user().archetype().name()));
      for (int i = 0; i < s.archetypes().size(); i++) {
        things.add(s.archetypes().get(i).name());
      }
      Set<String> events = new HashSet<>();
      for (int i = 0; i < s.eventKinds().size(); i++) {
        events.add(s.eventKinds().get(i).name());
      }
      assertEquals(0, look.check(things, events, List.of()), name);
      looked.add(name);
    }
    assertTrue(looked.containsAll(List.of("arena", "rink", "cars", "quarry")), looked.toString());
  }

  @Test
  void namesThatNothingHasAreFound() {
    look.show("rockets");
    List<String> things =
        new ArrayList<>(List.of("player", "rocket", "wall", "side wall", "pillar"));
    things.addAll(List.of("crate", "planet", "rock.large", "rock.medium", "rock.small"));
    things.addAll(List.of("bolt", "torpedo", "mine", "repair", "scatter", "torpedoes", "mines"));
    List<String> events = List.of("shot", "boom", "spark", "blocked", "crack", "taken", "wreck");
    assertEquals(0, look.check(things, events, List.of()));
    things.remove("crate"); // it may be of another level
    things.set(0, "plyer");
    assertEquals(1, look.check(things, events, List.of()));
    things.set(0, "player");
    assertEquals(1, look.check(things, events.subList(1, events.size()), List.of()));
  }
}
