package carom.client.edit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.sim.level.Level;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Goal: a level's file is never lost, neither by the editor nor by another program. */
final class EditFileTest {
  @TempDir private Path folder;

  @Test
  void aNewLevelCanBePlayedAtOnceAndIsWrittenWhenSaved() throws Exception {
    Path path = folder.resolve("levels").resolve("my first-level.json");
    EditFile file = new EditFile(path);
    LevelEditor editor = new LevelEditor(file.opened());
    assertEquals(List.of(), editor.problems());
    assertFalse(file.isUnsaved(editor.source()));
    assertFalse(Files.exists(path));
    editor.select(new Item("spawns", 0));
    editor.move(1, 0);
    assertTrue(file.isUnsaved(editor.source()));
    file.save(editor.source());
    assertFalse(file.isUnsaved(editor.source()));
    assertEquals("My first level", Level.load(path).name());
    assertEquals(-15, Level.load(path).spawns().get(0).x());
    try (var files = Files.list(path.getParent())) {
      assertEquals(List.of(path), files.toList(), "nothing else is left");
    }
  }

  @Test
  void aBrokenFileIsToldWithItsLineAndStaysAsItIs() throws Exception {
    Path path = folder.resolve("broken.json");
    Files.writeString(path, "{\n  \"name\": \"x\",\n  \"game\" \"arena\"\n}\n");
    IOException e = assertThrows(IOException.class, () -> new EditFile(path));
    assertTrue(e.getMessage().startsWith(path + ":3:"), e.getMessage());
    Files.writeString(path, "[1]");
    e = assertThrows(IOException.class, () -> new EditFile(path));
    assertTrue(e.getMessage().endsWith("the file holds a list, no level"), e.getMessage());
    assertEquals("[1]", Files.readString(path));
    Files.writeString(path, "{ \"tiledversion\": \"1.10\" }");
    e = assertThrows(IOException.class, () -> new EditFile(path));
    assertTrue(e.getMessage().contains("carom level convert"), e.getMessage());
  }

  @Test
  void aChangeByAnotherProgramIsSeenAndCanBeTakenOver() throws Exception {
    Path path = folder.resolve("shared.json");
    Files.write(path, Level.builtIn("arena").source());
    EditFile file = new EditFile(path);
    assertFalse(file.isChanged());
    String other = Files.readString(path).replace("Corner Pocket", "Other Pocket");
    Files.writeString(path, other);
    assertTrue(file.isChanged());
    assertEquals("Other Pocket", file.reload().root().fields.get("name").text);
    assertFalse(file.isChanged());
    Files.writeString(path, "half of a fi");
    assertTrue(file.isChanged());
    assertThrows(IOException.class, file::reload);
    Files.delete(path);
    assertFalse(file.isChanged(), "saving makes it anew");
  }

  @Test
  void whatIsNotSavedCanBeKeptAside() throws Exception {
    Path path = folder.resolve("a.json");
    EditFile file = new EditFile(path);
    LevelEditor editor = new LevelEditor(file.opened());
    assertEquals("", file.rescue(editor.source()));
    editor.select(new Item("spawns", 0));
    editor.delete();
    assertTrue(file.rescue(editor.source()).endsWith("a.json.unsaved"));
    assertFalse(Files.exists(path));
  }
}
