package carom.client.edit;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import carom.server.match.MatchLibrary;
import carom.sim.level.Level;
import carom.text.Json;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: who edits a level sees small differences in its file. Method: the shipped levels and texts
 * in several layouts are changed, and compared line by line.
 */
final class LevelSourceTest {
  private static final List<String> SHIPPED = MatchLibrary.builtInLevels();

  private static final List<String> ORDER = List.of("name", "at", "angle", "shape");

  @TempDir private Path folder;

  private static LevelSource source(String text) throws Exception {
    return LevelSource.of(text);
  }

  private static String text(LevelSource source) {
    return new String(source.bytes(), StandardCharsets.UTF_8);
  }

  @Test
  void aShippedLevelIsSavedAsItWasOpened() throws Exception {
    for (String name : SHIPPED) {
      Path file = folder.resolve(name + ".json");
      Files.write(file, Level.builtIn(name).source());
      EditFile opened = new EditFile(file);
      opened.save(new LevelEditor(opened.opened()).source());
      assertArrayEquals(Level.builtIn(name).source(), Files.readAllBytes(file), name);
    }
  }

  @Test
  void aMovedThingChangesOneLine() throws Exception {
    int moved = 0;
    for (String name : SHIPPED) {
      LevelSource opened = source(new String(Level.builtIn(name).source(), StandardCharsets.UTF_8));
      for (String list : List.of("statics", "bodies", "spawns")) {
        for (int i = 0; i < opened.list(list).size(); i++) {
          if (opened.list(list).get(i).fields.containsKey("motion")) {
            continue; // its way has a line of its own
          }
          LevelEditor editor = new LevelEditor(opened);
          editor.select(new Item(list, i));
          editor.move(0.5, -0.25);
          List<String> before = text(opened).lines().toList();
          List<String> after = text(editor.source()).lines().toList();
          assertEquals(before.size(), after.size(), name + " " + list + i);
          List<Integer> changed = new ArrayList<>();
          for (int line = 0; line < before.size(); line++) {
            if (!before.get(line).equals(after.get(line))) {
              changed.add(line);
            }
          }
          long joints = withItsJoints(opened, list, i);
          assertEquals(1 + joints, changed.size(), name + " " + list + i);
          moved++;
        }
      }
    }
    assertEquals(true, moved > 100, "moved=" + moved);
  }

  /** Returns the number of joints that move along with a thing. */
  private static long withItsJoints(LevelSource opened, String list, int index) {
    LevelEditor editor = new LevelEditor(opened);
    LevelSource moved = editor.moved(opened, Set.of(new Item(list, index)), 1, 1);
    long joints = 0;
    for (int i = 0; i < opened.list("joints").size(); i++) {
      String before = opened.text(opened.list("joints").get(i));
      joints += before.equals(moved.text(moved.list("joints").get(i))) ? 0 : 1;
    }
    return joints;
  }

  @Test
  void aValueIsReplacedInPlaceAndAFieldIsAddedInItsOrder() throws Exception {
    LevelSource source = source("{ \"a\": [ 1.50 , 2 ],\n  \"zz\": {\"at\":[0,1]} }");
    LevelSource changed = source.edit().set(source.at(List.of("a", 1)), 3).done();
    assertEquals("{ \"a\": [ 1.50 , 3 ],\n  \"zz\": {\"at\":[0,1]} }", text(changed));
    Json inner = changed.at(List.of("zz"));
    LevelSource named =
        changed.edit().put(inner, "name", "é", ORDER).put(inner, "angle", 30.0, ORDER).done();
    assertEquals(
        "{ \"a\": [ 1.50 , 3 ],\n  \"zz\": {\"name\": \"é\", \"at\":[0,1], \"angle\": 30} }",
        text(named));
  }

  @Test
  void itemsStandOnLinesOfTheirOwnAsTheOthersDo() throws Exception {
    LevelSource source = source("{\r\n\t\"bodies\": [\r\n\t\t{ \"at\": [0, 0] }\r\n\t]\r\n}\r\n");
    LevelSource added = source.edit().append("bodies", List.of("1", "2"), List.of()).done();
    assertEquals(
        "{\r\n\t\"bodies\": [\r\n\t\t{ \"at\": [0, 0] },\r\n\t\t1,\r\n\t\t2\r\n\t]\r\n}\r\n",
        text(added));
    LevelSource empty = source("{\n  \"name\": \"x\", \"game\": \"y\",\n  \"joints\": []\n}\n");
    List<String> order = List.of("name", "game", "bodies", "joints");
    assertEquals(
        "{\n"
            + "  \"name\": \"x\", \"game\": \"y\",\n"
            + "  \"bodies\": [\n"
            + "    1\n"
            + "  ],\n"
            + "  \"joints\": []\n"
            + "}\n",
        text(empty.edit().append("bodies", List.of("1"), order).done()));
    assertEquals(
        "{\n  \"name\": \"x\", \"game\": \"y\",\n  \"joints\": [\n    1\n  ]\n}\n",
        text(empty.edit().append("joints", List.of("1"), order).done()));
  }

  @Test
  void whatIsTakenAwayLeavesNoTrace() throws Exception {
    LevelSource source =
        source("{\n  \"l\": [\n    1,\n    2,\n    3\n  ], \"m\": { \"x\": 1 }\n}");
    Json list = source.at(List.of("l"));
    assertEquals(
        "{\n  \"l\": [\n    2,\n    3\n  ], \"m\": { \"x\": 1 }\n}",
        text(source.without(list, list.items.get(0))));
    assertEquals(
        "{\n  \"l\": [\n    1,\n    2\n  ], \"m\": { \"x\": 1 }\n}",
        text(source.without(list, list.items.get(2))));
    Json map = source.at(List.of("m"));
    assertEquals(
        "{\n  \"l\": [\n    1,\n    2,\n    3\n  ], \"m\": {}\n}",
        text(source.without(map, map.fields.get("x"))));
    assertEquals("{\n  \"m\": { \"x\": 1 }\n}", text(source.without(source.root(), list)));
  }
}
