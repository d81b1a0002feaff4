package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.edit.EditFile;
import carom.client.edit.Form;
import carom.client.edit.Gestures;
import carom.client.edit.Item;
import carom.client.edit.LevelEditor;
import carom.client.edit.Tool;
import carom.client.view.ClientView;
import carom.options.NetworkConditions.Preset;
import carom.replay.RecordingReader;
import carom.replay.Replay;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.sim.entity.Input;
import carom.sim.level.Level;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: a door with its switch, a lift, a trap and a race need no code and no text editor, are
 * predicted, and replay. Method: the editor's mouse and forms make the level; one player runs the
 * race and one runs into the trap, on a mobile network.
 */
final class EditedLevelScenarioTest {
  @TempDir private Path folder;

  private LevelEditor editor;
  private Gestures mouse;

  private void drag(Tool tool, double fromX, double fromY, double toX, double toY) {
    mouse.take(tool);
    mouse.press((float) fromX, (float) fromY, false);
    mouse.release((float) toX, (float) toY, false);
  }

  private void fill(String path, String text) {
    row(path).fill(text);
  }

  private Form.Row row(String path) {
    return Form.of(editor, editor.selected()).stream()
        .filter(row -> row.path.equals(path))
        .findFirst()
        .orElseThrow(() -> new AssertionError("no row " + path));
  }

  /** Makes the level as a hand does; plate and door, lift, platform, trap, finish. */
  private Path made() throws Exception {
    EditFile file = new EditFile(folder.resolve("race.json"));
    editor = new LevelEditor(file.opened());
    mouse = new Gestures(editor);
    drag(Tool.SENSOR, -12, 0, -10, 0.5);
    mouse.sort(Gestures.Sort.MOVER);
    drag(Tool.BOX, -6.5, 0, -5.5, 3);
    editor.select(List.of(new Item("statics", 3), new Item("bodies", 0)));
    mouse.take(Tool.TRIGGER);
    row("triggers[0].else?").remove();
    fill("triggers[0].do+", "seconds");
    fill("triggers[0].do.seconds", "0.5");
    drag(Tool.BOX, 2, 0, 5, 0.5);
    fill("bodies[1]+", "motion");
    fill("bodies[1].motion.to", "3.5, 6");
    fill("bodies[1].motion.period", "5");
    mouse.sort(Gestures.Sort.STATIC);
    drag(Tool.BOX, 6, 5.5, 14, 6);
    drag(Tool.SENSOR, 8, 0, 14, 0.5);
    mouse.take(Tool.TRIGGER);
    fill("triggers[1].do?", "teleport");
    drag(Tool.SENSOR, 13, 6, 14, 8);
    mouse.take(Tool.TRIGGER);
    fill("triggers[2].do?", "list");
    fill("triggers[2].do+", "item");
    fill("triggers[2].do[1]?", "score");
    fill("triggers[2].do+", "item");
    fill("triggers[2].do[2]?", "teleport");
    assertEquals(List.of(), editor.problems());
    file.save(editor.source());
    return file.path();
  }

  /** Runs the race: through the door, onto the lift when it is down, and over when it is up. */
  private static void race(ClientView view, int tick, Input out) {
    if (view.own() == null) {
      return;
    }
    float x = view.own().x();
    float y = view.own().y();
    boolean isDown = tick % 300 > 280 || tick % 300 < 15;
    boolean isOnLift = x > 1.8f && x < 5 && y > 1.1f;
    if (isOnLift) {
      boolean isUp = y > 6.5f;
      out.move(isUp ? 1 : Math.max(-1, Math.min(1, 3.5f - x)), 0);
      out.hold(Input.JUMP, isUp && x > 4);
    } else if (y < 1.1f && x > 0 && x < 6) {
      out.move(isDown && x < 2 ? 1 : Math.max(-1, Math.min(1, 1 - x)), 0);
      out.hold(Input.JUMP, isDown);
    } else {
      out.move(1, 0);
    }
  }

  @Test
  void aRaceMadeByTheMouseIsPredictedAndReplays() throws Exception {
    Level level = Level.load(made());
    Path file = folder.resolve("race.carom");
    ServerConfig config = ServerConfig.defaults().with(ServerConfig.SEED, Stepper.SEED);
    float highest = 0;
    float lift = 0;
    boolean trapped = false;
    try (Stepper world = Stepper.of(level, config)) {
      world.server().record(file);
      SimulatedClient racer =
          world.add(
              "racer",
              Preset.MOBILE.impairment().withSeed(Stepper.SEED),
              EditedLevelScenarioTest::race);
      SimulatedClient other =
          world.add(
              "other",
              Preset.MOBILE.impairment().withSeed(Stepper.SEED + 1),
              (view, tick, out) -> {
                out.move(1, 0);
                out.hold(Input.JUMP, tick % 60 < 10);
              });
      world.awaitPlaying(racer);
      world.awaitPlaying(other);
      float before = world.body(other).x();
      for (int i = 0; i < 400 && !(trapped && world.player(racer).score() > 0); i++) {
        world.run(0.1);
        highest = Math.max(highest, world.room().simulation().entity(0).y());
        lift = Math.max(lift, world.room().simulation().entity(1).y());
        trapped |= before > 7 && world.body(other).x() < -10;
        before = world.body(other).x();
      }
      assertEquals(0, world.count(Counter.DIVERGENCES_UNEXPLAINED), world.describe());
      assertTrue(world.player(racer).score() > 0, "the racer has not finished " + world.describe());
      assertTrue(racer.stats().exactRate() > 0.9, "exact=" + racer.stats().exactRate());
    }
    assertEquals(4.5f, highest, 0.01f, "the door stood open");
    assertEquals(6, lift, 0.1f, "the lift went up");
    assertTrue(trapped, "nobody was trapped");
    try (RecordingReader reader = RecordingReader.open(file)) {
      Replay replay = new Replay(reader);
      Replay.Progress progress;
      do {
        progress = replay.step();
        assertNull(replay.divergence());
      } while (progress == Replay.Progress.TICK);
      assertEquals(Replay.Progress.END, progress);
    }
  }
}
