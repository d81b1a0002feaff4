package carom.server.prediction;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.game.Games;
import carom.game.playground.PlaygroundFields;
import carom.sim.Role;
import carom.sim.SimulationHost;
import carom.sim.entity.HostPlayer;
import carom.sim.level.Level;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;

/**
 * Goal: a client isn't told a part of a heap that would fall because the rest is missing. Method: a
 * player on a row of boxes that touch each other, below a row of as many; both together are longer
 * than the list.
 */
final class PredictedSetChooserTest {
  private static final int ROW = 40;
  private static final int MOST = 64;

  private final SimulationHost simulation;
  private final HostPlayer player;
  private final PredictedSetChooser chooser;

  PredictedSetChooserTest() throws Exception {
    String row =
        """
        {"name": "crate", "at": [-19.5, %s], "material": "crate",
         "shape": {"type": "box", "width": 1, "height": 1},
         "repeat": {"columns": 40, "step": [1, 0]}}\
        """;
    String json =
        """
        {"name": "rows", "game": "platformer", "gravity": [0, -26],
         "bounds": {"min": [-40, -6], "max": [40, 60]},
         "materials": {"crate": {"density": 0.4, "friction": 0.6}},
         "spawns": [{"name": "player", "at": [0, 2]}, {"name": "flag", "at": [0, 55]}],
         "statics": [{"name": "floor", "at": [0, -1], "material": "crate",
           "shape": {"type": "box", "width": 60, "height": 2}},
          {"name": "floor", "at": [0, 7], "material": "crate",
           "shape": {"type": "box", "width": 60, "height": 1}}],
         "bodies": [%s, %s]}
        """
            .formatted(row.formatted("0.5"), row.formatted("8"));
    Level level = Level.parse("rows.json", json.getBytes(StandardCharsets.UTF_8));
    simulation = new SimulationHost(Games.create("platformer"), level, 1, 60, Role.AUTHORITY);
    player = simulation.join("p");
    chooser = new PredictedSetChooser(simulation, new EntityMarks(), e -> true);
  }

  private void step(int ticks) {
    for (int i = 0; i < ticks; i++) {
      simulation.step();
    }
  }

  private long chosenAbove(float y) {
    long count = 0;
    for (int i = 0; i < chooser.chosen().count(); i++) {
      count += chooser.chosen().get(i).y() > y ? 1 : 0;
    }
    return count;
  }

  @Test
  void anAwakeHeapIsChosenAsAWholeOrNotAtAll() {
    step(10);
    assertTrue(simulation.entity(ROW).body().awake());
    chooser.choose(player, true, new KeyList(), MOST);
    assertEquals(ROW + 1, chooser.chosen().count(), "the row that carries the player");
    assertEquals(0, chosenAbove(5));
  }

  @Test
  void asMuchOfASleepingHeapIsChosenAsThereIsRoomFor() {
    step(200);
    chooser.choose(player, true, new KeyList(), MOST);
    assertEquals(MOST - 1, chooser.chosen().count());
    assertEquals(MOST - 1 - ROW - 1, chosenAbove(5));
  }

  /** A client that has the own body alone can't compute an input that looks at another one. */
  @Test
  void aPlayerLooksAtWhatItsFieldMeans() throws Exception {
    SimulationHost s =
        new SimulationHost(
            Games.create("playground"), Level.builtIn("harbour"), 1, 60, Role.AUTHORITY);
    HostPlayer p = s.join("p");
    PredictedSetChooser looks = new PredictedSetChooser(s, new EntityMarks(), e -> true);
    assertFalse(looks.means(p));
    p.set(PlaygroundFields.HELD, s.entity(0));
    assertTrue(looks.means(p));
    p.set(PlaygroundFields.HELD, null);
    assertFalse(looks.means(p));
  }
}
