package carom.client.desktop.game;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.bots.BotBrain;
import carom.client.bots.BotBrains;
import carom.fixtures.Javac;
import carom.game.GameJars;
import carom.game.JarWatch;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.jar.JarOutputStream;
import java.util.zip.ZipEntry;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: with {@code --dev} a changed jar is seen at once: its view is drawn, its brain plays, and
 * one that fails leaves what was there. Method: jars that are built here.
 */
final class NewJarTest {
  @TempDir private static Path games;
  @TempDir private Path scratch;
  private final JarWatch watch = new JarWatch();
  private final List<String> told = new ArrayList<>();
  private final ShownLook look = new ShownLook(told::add);

  @AfterAll
  static void leaveNone() throws Exception {
    Path none = Files.createTempDirectory("carom-none"); // other tests of this process have it
    none.toFile().deleteOnExit();
    GameJars.open(none);
  }

  private static final String VIEW =
      """
      package dev;
      public final class View implements carom.client.look.GameView {
        @Override public String game() { return "devgame"; }
        @Override public void setUp(carom.client.look.ViewSetup v) {
          v.actions(carom.client.look.Action.button("NAME", 1).key("W"));
          THEN
        }
      }
      """;

  private static final String BRAIN =
      """
      package dev;
      public final class Brain implements carom.client.bots.BotBrain {
        @Override public String game() { return "devgame"; }
        @Override public void decide(carom.client.bots.Senses s, carom.sim.entity.Input out) {}
        @Override public String toString() { return "NAME"; }
      }
      """;

  /** Builds the jar, whose view and brain have a name. */
  private void jar(String name, String then) throws Exception {
    Path out = Files.createDirectories(scratch.resolve(name));
    Path view = out.resolve("View.java");
    Path brain = out.resolve("Brain.java");
    Files.writeString(view, VIEW.replace("NAME", name).replace("THEN", then));
    Files.writeString(brain, BRAIN.replace("NAME", name));
    Javac.compile(out, view, brain);
    try (JarOutputStream jar =
        new JarOutputStream(Files.newOutputStream(games.resolve("dev.jar")))) {
      for (String entry : List.of("dev/View.class", "dev/Brain.class")) {
        jar.putNextEntry(new ZipEntry(entry));
        jar.write(Files.readAllBytes(out.resolve(entry)));
      }
      for (String service : List.of("look.GameView dev.View", "bots.BotBrain dev.Brain")) {
        String[] words = service.split(" ", -1);
        jar.putNextEntry(new ZipEntry("META-INF/services/carom.client." + words[0]));
        jar.write(words[1].getBytes(StandardCharsets.UTF_8));
      }
    }
  }

  private boolean changes() throws IOException {
    watch.look();
    return watch.look();
  }

  private String action() {
    return look.setup().actions().isEmpty() ? "" : look.setup().actions().get(0).name();
  }

  @Test
  void viewAndBrainAreThoseOfTheNewestJarThatWorks() throws Exception {
    jar("first", "");
    GameJars.open(games);
    assertTrue(look.show("devgame"));
    assertEquals("first", action());
    BotBrain first = BotBrains.create("devgame");
    assertEquals("first", String.valueOf(first));
    assertFalse(changes());
    assertFalse(look.show("devgame"));
    jar("second one", "");
    assertFalse(watch.look(), "it may be half written");
    assertTrue(watch.look());
    assertTrue(look.show("devgame"), "the picture is renewed");
    assertEquals("second one", action());
    assertEquals("second one", String.valueOf(BotBrains.create("devgame")));
    assertEquals(List.of(), told);
    jar("third of them", "throw new IllegalStateException();");
    assertTrue(changes());
    assertFalse(look.show("devgame"));
    assertEquals("second one", action(), "the old look stays");
    String failed = "The game's own look failed, so it has the one before: ";
    assertEquals(1, told.size());
    assertTrue(
        told.get(0).startsWith(failed + "java.lang.IllegalStateException, at "), told.get(0));
    assertFalse(look.show("devgame"), "it is told once");
    assertEquals(1, told.size());
    Files.writeString(games.resolve("dev.jar"), "no jar at all");
    assertFalse(watch.look(), "it may be half written");
    IOException broken = assertThrows(IOException.class, watch::look);
    assertTrue(broken.getMessage().startsWith("dev.jar is no jar"), broken.getMessage());
    assertFalse(watch.look(), "it is told once");
    Files.delete(games.resolve("dev.jar"));
    assertTrue(changes());
    assertFalse(look.show("devgame"));
    assertEquals("second one", action());
    assertEquals(
        "The game's own look is gone or can't be loaded, so it has the one before", told.get(1));
    assertNull(BotBrains.create("devgame"));
    jar("fourth", "");
    assertTrue(changes());
    assertTrue(look.show("devgame"));
    assertEquals("fourth", action());
    assertNotNull(BotBrains.create("devgame"));
  }

  @Test
  void aFolderThatIsNoneIsRefused() {
    assertThrows(IOException.class, () -> GameJars.open(scratch.resolve("none")));
  }
}
