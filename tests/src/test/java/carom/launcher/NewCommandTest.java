package carom.launcher;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.server.CaromMain;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** {@code carom new}. That the project works, {@code StarterTest} shows with the original. */
final class NewCommandTest {
  private static final Path STARTER = Path.of("..", "docs", "starter");

  @TempDir Path folder;
  private final StringWriter out = new StringWriter();
  private final StringWriter err = new StringWriter();

  private int make(String... arguments) {
    String[] all = Stream.concat(Stream.of("new"), Stream.of(arguments)).toArray(String[]::new);
    return CaromMain.run(new PrintWriter(out), new PrintWriter(err), all);
  }

  private static List<Path> files(Path root) throws IOException {
    try (Stream<Path> files = Files.walk(root)) {
      return files.filter(Files::isRegularFile).map(root::relativize).sorted().toList();
    }
  }

  @Test
  void theProjectIsTheStarterUnderAnotherName() throws IOException {
    assertEquals(0, make("castle", "--in", folder.toString()), err::toString);
    Path project = folder.resolve("castle");
    for (Path file : files(STARTER)) {
      String named = file.toString().replace("hill", "castle").replace("Hill", "Castle");
      String text = Files.readString(STARTER.resolve(file));
      assertEquals(
          text.replace("hill", "castle").replace("Hill", "Castle"),
          Files.readString(project.resolve(named)),
          named);
    }
    assertTrue(Files.isExecutable(project.resolve("gradlew")));
    assertTrue(Files.exists(project.resolve("gradle/wrapper/gradle-wrapper.properties")));
    assertTrue(out.toString().contains("./gradlew run"), out::toString);
  }

  @Test
  void aBadNameIsRefusedBeforeAnythingIsWritten() throws IOException {
    List<String> bad =
        List.of("", "x", "Castle", "space-race", "9lives", "../up", "a/b", "new", "con", "arena");
    for (String name : bad) {
      assertEquals(2, make(name, "--in", folder.toString()), name);
      assertTrue(err.toString().contains("name=" + name), err::toString);
    }
    assertTrue(err.toString().contains("for example spacerace"), err::toString);
    assertEquals(List.of(), files(folder));
  }

  @Test
  void aFolderThatIsNotEmptyIsRefused() throws IOException {
    Path file = Files.createDirectory(folder.resolve("castle")).resolve("notes.txt");
    Files.writeString(file, "mine");
    assertEquals(2, make("castle", "--in", folder.toString()));
    assertTrue(err.toString().contains("isn't empty"), err::toString);
    assertEquals(List.of(Path.of("castle", "notes.txt")), files(folder));
    Files.delete(file);
    assertEquals(0, make("castle", "--in", folder.toString()), err::toString);
    assertFalse(files(folder).isEmpty());
  }
}
