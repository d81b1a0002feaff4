package carom.client.edit;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.sim.level.Level;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/**
 * Goal: a mouse alone makes levels. Method: presses, drags and releases at places of a new level,
 * and what its text says then.
 */
final class GesturesTest {
  private LevelEditor editor;
  private Gestures mouse;

  @BeforeEach
  void begin() throws Exception {
    editor = new LevelEditor(new EditFile(Path.of("nowhere.json")).opened());
    mouse = new Gestures(editor);
  }

  private void drag(double fromX, double fromY, double toX, double toY) {
    mouse.press((float) fromX, (float) fromY, false);
    mouse.drag((float) (fromX + toX) / 2, (float) (fromY + toY) / 2);
    mouse.release((float) toX, (float) toY, false);
  }

  private void click(double x, double y) {
    mouse.press((float) x, (float) y, false);
    mouse.release((float) x, (float) y, false);
  }

  private String last(String list) {
    return editor
        .source()
        .text(editor.source().list(list).get(editor.source().list(list).size() - 1));
  }

  private void assertPlayable() {
    assertEquals(List.of(), editor.problems());
  }

  @Test
  void shapesArePlacedAsWhatIsChosen() {
    mouse.take(Tool.BOX);
    drag(-2.1, 2.1, 0.9, 3.4);
    assertEquals(
        "{ \"at\": [-0.5, 2.75], \"shape\": { \"type\": \"box\", \"width\": 3, \"height\": 1.5 } }",
        last("statics"));
    assertEquals(Set.of(new Item("statics", 3)), editor.selection());
    mouse.sort(Gestures.Sort.BODY);
    mouse.take(Tool.CIRCLE);
    drag(4, 4, 5, 4);
    assertEquals(
        "{ \"at\": [4, 4], \"shape\": { \"type\": \"circle\", \"radius\": 1 } }", last("bodies"));
    mouse.sort(Gestures.Sort.MOVER);
    mouse.take(Tool.CAPSULE);
    drag(6, 4, 8, 4);
    assertEquals(
        "{ \"name\": \"mover-1\", \"at\": [7, 4], \"shape\": { \"type\": \"capsule\", \"from\":"
            + " [-1, 0], \"to\": [1, 0], \"radius\": 0.3 }, \"type\": \"kinematic\" }",
        last("bodies"));
    assertPlayable();
  }

  @Test
  void polygonsAndChainsAreClickedPointByPoint() {
    mouse.take(Tool.POLYGON);
    click(0, 4);
    click(2, 4);
    click(9, 9);
    assertTrue(mouse.backPoint());
    click(1, 6);
    mouse.finish();
    assertEquals(
        "{ \"at\": [1, 4.5], \"shape\": { \"type\": \"polygon\", \"points\": [[-1, -0.5], [1,"
            + " -0.5], [0, 1.5]] } }",
        last("statics"));
    mouse.take(Tool.CHAIN);
    mouse.sort(Gestures.Sort.BODY);
    click(-8, 6);
    click(-4, 6);
    click(-4, 9);
    click(-8, 6);
    assertTrue(last("statics").contains("\"loop\": true"), last("statics"));
    assertPlayable();
  }

  @Test
  void aPolygonGetsACornerAndLosesIt() {
    mouse.take(Tool.POLYGON);
    click(0, 4);
    click(2, 4);
    click(2, 6);
    click(0, 6);
    mouse.finish();
    mouse.take(Tool.SELECT);
    String before = last("statics");
    mouse.addPoint(2, 5.1f);
    assertTrue(last("statics").contains("[1, -1], [1, 0.1], [1, 1]"), last("statics"));
    drag(2, 5.1, 4, 5);
    assertTrue(last("statics").contains("[1, -1], [3, 0], [1, 1]"), last("statics"));
    mouse.hover(4, 5);
    assertTrue(mouse.removePoint());
    assertEquals(before, last("statics"));
    mouse.hover(9, 9);
    assertEquals(false, mouse.removePoint());
    assertPlayable();
  }

  @Test
  void aThingIsDraggedOnTheGridAndUndoLeadsBackToTheByte() {
    byte[] before = editor.source().bytes();
    click(3, -0.5);
    assertEquals(Set.of(new Item("statics", 0)), editor.selection());
    drag(3, -0.5, 4.13, 1.38);
    assertTrue(
        editor.source().text(editor.json(new Item("statics", 0))).contains("\"at\": [1, 1.5]"));
    assertTrue(editor.undo());
    assertArrayEquals(before, editor.source().bytes());
    assertTrue(editor.redo());
    assertTrue(editor.undo());
    assertArrayEquals(before, editor.source().bytes());
  }

  @Test
  void handlesFormAndTurn() {
    mouse.take(Tool.BOX);
    drag(0, 4, 2, 6);
    mouse.take(Tool.SELECT);
    mouse.unit(0.02f);
    drag(2, 6, 4, 7);
    assertEquals(
        "{ \"at\": [2, 5.5], \"shape\": { \"type\": \"box\", \"width\": 4, \"height\": 3 } }",
        last("statics"));
    Handle turn =
        mouse.handles().stream()
            .filter(h -> h.kind() == Handle.Kind.TURN)
            .findFirst()
            .orElseThrow();
    drag(turn.x(), turn.y(), turn.x() - 5, turn.y() - 2);
    assertTrue(last("statics").contains("\"angle\": "), last("statics"));
    assertPlayable();
  }

  @Test
  void aFrameSelectsAndSeveralMoveTogether() {
    drag(-17, 0.5, 17, 3);
    assertEquals(Set.of(new Item("spawns", 0), new Item("spawns", 1)), editor.selection());
    editor.move(0, 2);
    assertEquals("{ \"name\": \"flag\", \"at\": [16, 3] }", last("spawns"));
    editor.copy();
    editor.pasteAt(0, 8);
    assertEquals(4, editor.source().list("spawns").size());
    editor.delete();
    assertEquals(2, editor.source().list("spawns").size());
  }

  @Test
  void aJointHoldsTwoBodiesThatGetNamesAndMovesWithThem() {
    mouse.take(Tool.BOX);
    drag(0, 4, 1, 8);
    mouse.sort(Gestures.Sort.BODY);
    drag(0, 4, 5, 5);
    mouse.take(Tool.JOINT);
    click(0.5, 4.5);
    assertEquals(
        "{ \"type\": \"revolute\", \"a\": \"wall-1\", \"b\": \"body-1\", \"at\": [0.5, 4.5] }",
        last("joints"));
    mouse.take(Tool.JOINT);
    assertEquals("distance", mouse.kind(Tool.JOINT));
    drag(4.5, 4.5, 4.5, 9);
    assertEquals(
        "{ \"type\": \"distance\", \"b\": \"body-1\", \"from\": [4.5, 4.5], \"to\": [4.5, 9] }",
        last("joints"));
    assertPlayable();
    editor.select(new Item("bodies", 0));
    editor.move(1, 0);
    assertTrue(last("joints").contains("\"to\": [5.5, 9]"), last("joints"));
    editor.delete();
    assertEquals(List.of(), editor.source().list("joints"));
  }

  @Test
  void aDoorWithItsPlateIsFourGestures() throws Exception {
    mouse.take(Tool.SENSOR);
    drag(-12, 0, -10, 0.5);
    mouse.take(Tool.BOX);
    mouse.sort(Gestures.Sort.MOVER);
    drag(-6, 0, -5, 3);
    editor.select(List.of(new Item("statics", 3), new Item("bodies", 0)));
    mouse.take(Tool.TRIGGER);
    assertEquals(
        "{ \"when\": { \"inside\": \"sensor-1\", \"who\": \"player\" }, \"do\": { \"move\":"
            + " \"mover-1\", \"to\": [-5.5, 4.5] }, \"else\": { \"move\": \"mover-1\", \"to\":"
            + " [-5.5, 1.5] } }",
        last("triggers"));
    Handle open = mouse.handles().get(0);
    drag(open.x(), open.y(), open.x(), open.y() + 1);
    assertTrue(last("triggers").contains("\"to\": [-5.5, 5.5]"), last("triggers"));
    Level level = Level.parse("level", editor.source().bytes());
    assertEquals(1, level.triggers().size());
  }

  @Test
  void areasComeInKindsThatTheReaderTakes() {
    for (int i = 0; i < 7; i++) {
      mouse.take(Tool.AREA);
      drag(-10, 4, -6, 8);
      assertEquals(List.of(), editor.problems(), mouse.kind(Tool.AREA));
    }
    String text = new String(editor.source().bytes(), StandardCharsets.UTF_8);
    for (String kind : List.of("water", "wind", "gravity", "drag", "sand", "zone")) {
      assertTrue(text.contains('"' + kind + '"'), kind);
    }
  }
}
