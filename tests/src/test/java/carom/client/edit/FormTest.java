package carom.client.edit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** Goal: all of a level can be filled in by forms, and nothing typed breaks it. */
final class FormTest {
  private static final String LEVEL =
      """
      {
        "name": "t", "game": "platformer", "gravity": [0, -20],
        "bounds": { "min": [-20, -4], "max": [20, 14] },
        "spawns": [{ "name": "player", "at": [-6, 1.2] }, { "name": "flag", "at": [14, 1] }],
        "statics": [
          { "name": "plate", "sensor": true, "at": [-6, 0.1], "shape": { "type": "circle", "radius": 1 } }
        ],
        "bodies": [
          { "name": "door", "type": "kinematic", "at": [2, 1.50], "shape": { "type": "box", "width": 1, "height": 3 } }
        ],
        "triggers": [
          { "when": { "timer": 30 }, "do": { "notice": "half a minute" } }
        ]
      }
      """;

  private final LevelEditor editor;

  FormTest() throws Exception {
    editor = new LevelEditor(LevelSource.of(LEVEL));
  }

  private Form.Row row(Item item, String path) {
    return Form.of(editor, item).stream()
        .filter(row -> row.path.equals(path))
        .findFirst()
        .orElseThrow(() -> new AssertionError("no row " + path));
  }

  private String text(Item item) {
    return editor.source().text(editor.json(item));
  }

  @Test
  void aTriggerIsMadeOfChoices() {
    Item trigger = new Item("triggers", 0);
    editor.select(trigger);
    row(trigger, "triggers[0].when?").fill("inside");
    Form.Row sensor = row(trigger, "triggers[0].when.inside");
    assertEquals("plate", sensor.value);
    assertEquals(List.of("plate"), sensor.choices);
    row(trigger, "triggers[0].when+").fill("who");
    row(trigger, "triggers[0].when.who").fill("player");
    row(trigger, "triggers[0].do?").fill("list");
    row(trigger, "triggers[0].do+").fill("item");
    row(trigger, "triggers[0].do[1]?").fill("score");
    row(trigger, "triggers[0].do[1].score").fill("3");
    row(trigger, "triggers[0].do[0]?").remove();
    row(trigger, "triggers[0]+").fill("once");
    assertEquals(
        "{ \"when\": { \"inside\": \"plate\", \"who\": \"player\" }, \"do\": [{ \"score\": 3 }],"
            + " \"once\": true }",
        text(trigger));
    assertEquals(List.of(), editor.problems());
  }

  @Test
  void aNewFieldComesInItsOrderAndWithAUsefulValue() {
    Item door = new Item("bodies", 0);
    editor.select(door);
    row(door, "bodies[0]+").fill("motion");
    assertTrue(text(door).contains("\"motion\": { \"to\": [2, 4.5], \"period\": 1 }"), text(door));
    assertTrue(text(door).contains("\"at\": [2, 1.50]"), "what isn't changed stays as written");
    row(door, "bodies[0].motion+").fill("eased");
    row(door, "bodies[0].shape?").fill("circle");
    assertTrue(text(door).contains("\"eased\": false"), text(door));
    assertTrue(
        text(door).contains("\"shape\": { \"type\": \"circle\", \"radius\": 1 }"), text(door));
    row(door, "bodies[0].at").fill("3 4");
    assertTrue(text(door).contains("\"at\": [3, 4]"), text(door));
    row(door, "bodies[0].motion").remove();
    assertFalse(text(door).contains("motion"), text(door));
    assertEquals(List.of(), editor.problems());
  }

  @Test
  void theLevelItselfHasAFormWithMaterialsOfItsOwnNames() {
    row(null, "+").fill("materials");
    row(null, "materials+").fill("ice");
    row(null, "materials.ice+").fill("friction");
    row(null, "materials.ice.friction").fill("0.02");
    row(null, "gravity").fill("0, -12.5");
    assertEquals(
        "0.02",
        editor
            .source()
            .root()
            .fields
            .get("materials")
            .fields
            .get("ice")
            .fields
            .get("friction")
            .text);
    assertEquals(-12.5f, editor.checked().level().gravityY());
    assertTrue(row(null, "game").choices.contains("arena"));
    Set<String> shown = Set.copyOf(Form.of(editor, null).stream().map(r -> r.path).toList());
    assertFalse(shown.contains("statics"), "lists are in the picture");
  }

  @Test
  void whatDoesNotFitIsToldAndMarked() {
    Item door = new Item("bodies", 0);
    row(door, "bodies[0].shape.width").fill("wide");
    assertEquals("width=wide must be a number", editor.message());
    row(door, "bodies[0].at").fill("1");
    assertEquals("at needs two numbers, such as 1.5, 2", editor.message());
    assertEquals(LEVEL, new String(editor.source().bytes(), StandardCharsets.UTF_8));
    row(door, "bodies[0].shape.width").fill("-1");
    assertEquals(
        List.of(new LevelEditor.Problem(door, "bodies[0].shape.width=-1 must be in 0.05..2000")),
        editor.problems());
    assertTrue(editor.undo());
    assertEquals(List.of(), editor.problems());
  }

  @Test
  void aFormOfAnOlderStateChangesNothing() {
    Item door = new Item("bodies", 0);
    Form.Row old = row(door, "bodies[0].shape.width");
    editor.select(door);
    editor.move(1, 0);
    byte[] before = editor.source().bytes();
    old.fill("7");
    assertEquals(before, editor.source().bytes());
  }
}
