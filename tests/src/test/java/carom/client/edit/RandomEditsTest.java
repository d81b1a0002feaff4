package carom.client.edit;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.sim.level.Level;
import carom.sim.level.LevelException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/**
 * Goal: nothing that a hand can do breaks a level or its history. Method: random gestures, commands
 * and entries of forms; after each, the level can be read or the editor says why not, and undo
 * leads back byte for byte.
 */
final class RandomEditsTest {
  private static final long SEED = Long.getLong("carom.seed", System.nanoTime());
  private static final int EDITS = 120;
  private static final List<String> BEGINNINGS = List.of("", "platformer", "lagoon", "arena");

  private final Random random = new Random(SEED);

  @Test
  void eachStateIsReadOrToldAndUndoLeadsBackToTheByte() throws Exception {
    System.out.println("carom.seed=" + SEED);
    int read = 0;
    int told = 0;
    int filled = 0;
    for (String name : BEGINNINGS) {
      LevelSource opened =
          name.isEmpty()
              ? new EditFile(Path.of("nowhere.json")).opened()
              : LevelSource.of(new String(Level.builtIn(name).source(), StandardCharsets.UTF_8));
      LevelEditor editor = new LevelEditor(opened);
      Gestures mouse = new Gestures(editor);
      List<byte[]> states = new ArrayList<>(List.of(opened.bytes()));
      for (int i = 0; i < EDITS; i++) {
        filled += edit(editor, mouse) ? 1 : 0;
        byte[] now = editor.source().bytes();
        if (!Arrays.equals(now, states.get(states.size() - 1))) {
          states.add(now);
        }
        String where = "seed=" + SEED + " " + name + " edit " + i;
        if (isRead(now)) {
          read++;
        } else {
          told++;
          assertFalse(editor.problems().isEmpty(), where);
          editor.undo(); // as a hand would do
          states.remove(states.size() - 1);
          assertArrayEquals(states.get(states.size() - 1), editor.source().bytes(), where);
        }
      }
      mouse.cancel();
      for (int i = states.size() - 2; i >= 0; i--) {
        assertTrue(editor.undo(), name);
        assertArrayEquals(states.get(i), editor.source().bytes(), "seed=" + SEED + " " + name);
      }
      assertFalse(editor.undo());
    }
    assertEquals(BEGINNINGS.size() * EDITS, read + told);
    assertTrue(read > told && filled > 20, "read=" + read + " told=" + told + " filled=" + filled);
  }

  private static boolean isRead(byte[] text) {
    try {
      Level.parse("level", text);
      return true;
    } catch (LevelException e) {
      return false;
    }
  }

  /** Does something. Returns whether it filled in a form. */
  private boolean edit(LevelEditor editor, Gestures mouse) {
    switch (random.nextInt(10)) {
      case 0, 1, 2 -> {
        mouse.take(Tool.values()[random.nextInt(Tool.TRIGGER.ordinal())]);
        mouse.sort(Gestures.Sort.values()[random.nextInt(3)]);
        drag(mouse);
      }
      case 3 -> {
        mouse.take(random.nextBoolean() ? Tool.POLYGON : Tool.CHAIN);
        for (int i = 0; i < 2 + random.nextInt(4); i++) {
          click(mouse);
        }
        mouse.finish();
        mouse.cancel();
      }
      case 4 -> {
        mouse.take(Tool.SELECT);
        click(mouse);
        drag(mouse);
      }
      case 5 -> selectAny(editor);
      case 6 -> command(editor);
      case 7 -> {
        List<Handle> handles = mouse.handles();
        if (!handles.isEmpty()) {
          Handle handle = handles.get(random.nextInt(handles.size()));
          mouse.press(handle.x(), handle.y(), false);
          mouse.drag(place(), place());
          mouse.release(place(), place(), false);
        }
      }
      default -> {
        return fill(editor);
      }
    }
    return false;
  }

  private float place() {
    return random.nextInt(400) / 10f - 20;
  }

  private void drag(Gestures mouse) {
    mouse.press(place(), place(), random.nextInt(4) == 0);
    mouse.drag(place(), place());
    if (random.nextInt(5) == 0) {
      mouse.cancel();
    }
    mouse.release(place(), place(), false);
  }

  private void click(Gestures mouse) {
    float x = place();
    float y = place();
    mouse.press(x, y, false);
    mouse.release(x, y, false);
  }

  private void selectAny(LevelEditor editor) {
    List<Sketch.Thing> things = editor.sketch().things();
    for (int i = 0; i < random.nextInt(3) && !things.isEmpty(); i++) {
      editor.toggle(things.get(random.nextInt(things.size())).item());
    }
    if (random.nextBoolean() && !editor.source().list("triggers").isEmpty()) {
      editor.select(new Item("triggers", 0));
    }
  }

  private void command(LevelEditor editor) {
    switch (random.nextInt(7)) {
      case 0 -> editor.move(random.nextInt(5) - 2, 1);
      case 1 -> editor.turn(15);
      case 2 -> editor.duplicate();
      case 3 -> editor.copy();
      case 4 -> editor.pasteAt(place(), place());
      case 5 -> editor.addTrigger();
      default -> {
        if (editor.selection().size() < 4) {
          editor.delete();
        }
      }
    }
  }

  private boolean fill(LevelEditor editor) {
    List<Form.Row> rows = Form.of(editor, random.nextInt(8) == 0 ? null : editor.selected());
    if (rows.isEmpty()) {
      return false;
    }
    Form.Row row = rows.get(random.nextInt(rows.size()));
    if (row.isRemovable() && random.nextInt(6) == 0) {
      row.remove();
      return true;
    }
    switch (row.kind) {
      case CHOICE, FLAG, ADD -> row.fill(row.choices.get(random.nextInt(row.choices.size())));
      case TEXT -> row.fill(row.choices.isEmpty() ? "a \"name\" \u202e" : row.choices.get(0));
      case NUMBERS -> row.fill(random.nextBoolean() ? "1.5, 2" : "3");
      default -> {
        return false;
      }
    }
    return true;
  }
}
