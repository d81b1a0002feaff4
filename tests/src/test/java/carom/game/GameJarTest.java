package carom.game;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.fixtures.PlainGame;
import carom.game.arena.ArenaGame;
import carom.game.tag.TagGame;
import java.io.File;
import java.io.IOException;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.net.MalformedURLException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.jar.JarOutputStream;
import java.util.zip.ZipEntry;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Games that users bring, as jars on the class path do: whole ones, and broken ones. */
class GameJarTest {
  @TempDir Path folder;

  /** A game whose author forgot a file that it reads at once. */
  public static final class Forgetful extends PlainGame {
    public Forgetful() {
      super("forgetful", "arena");
      throw new IllegalStateException("no file of rules");
    }
  }

  /** The programs' class path, and behind it a folder that lists these games. */
  private URLClassLoader program(String... games) throws Exception {
    Path services = Files.createDirectories(folder.resolve("META-INF/services"));
    Files.write(services.resolve("carom.sim.Game"), List.of(games));
    List<URL> path = new ArrayList<>();
    for (String entry : System.getProperty("java.class.path").split(File.pathSeparator)) {
      path.add(url(Path.of(entry)));
    }
    path.add(url(folder));
    return new URLClassLoader(path.toArray(new URL[0]), ClassLoader.getPlatformClassLoader());
  }

  private static URL url(Path path) throws MalformedURLException {
    return path.toUri().toURL();
  }

  private static String create(ClassLoader program, String name) throws Throwable {
    Method create = program.loadClass(Games.class.getName()).getMethod("create", String.class);
    try {
      return create.invoke(null, name).getClass().getName();
    } catch (InvocationTargetException e) {
      throw e.getCause();
    }
  }

  @Test
  void isFoundByItsName() throws Throwable {
    try (URLClassLoader program = program(TagGame.class.getName())) {
      assertEquals(TagGame.class.getName(), create(program, "tag"));
      assertEquals(ArenaGame.class.getName(), create(program, "arena"));
    }
  }

  @Test
  void aBrokenGameIsReportedWhenAnUnknownOneIsAskedFor() throws Throwable {
    try (URLClassLoader program =
        program("missing.Game", Forgetful.class.getName(), TagGame.class.getName())) {
      assertEquals(ArenaGame.class.getName(), create(program, "arena"));
      assertEquals(TagGame.class.getName(), create(program, "tag"));
      Throwable e = assertThrows(IllegalArgumentException.class, () -> create(program, "chess"));
      String message = e.getMessage();
      assertTrue(
          message.contains(
              "\"chess\" is unknown, known are [arena, cars, platformer, playground, rockets,"
                  + " shooter, tag]"),
          message);
      assertTrue(message.contains("a game can't be loaded: "), message);
      assertTrue(message.contains("missing.Game not found"), message);
      assertTrue(message.contains("no file of rules"), message);
    }
  }

  @Test
  void aFolderThatLacksTheGameSaysWhy() throws Throwable {
    Path jars = Files.createDirectories(folder.resolve("jars"));
    try (URLClassLoader program = program()) {
      Method open = program.loadClass(GameJars.class.getName()).getMethod("open", Path.class);
      open.invoke(null, jars);
      Throwable e = assertThrows(IllegalArgumentException.class, () -> create(program, "chess"));
      assertTrue(e.getMessage().contains("; there is no jar in " + jars), e.getMessage());

      jar(jars.resolve("chess.jar"), "chess/Chess.class");
      jar(jars.resolve("other.jar"), "META-INF/services/carom.sim.Game");
      e = assertThrows(IllegalArgumentException.class, () -> create(program, "chess"));
      assertTrue(
          e.getMessage()
              .endsWith(
                  "; chess.jar has no file META-INF/services/carom.sim.Game that names the game's"
                      + " class"),
          e.getMessage());

      Files.delete(jars.resolve("chess.jar"));
      Files.delete(jars.resolve("other.jar"));
      Files.delete(jars);
      e = assertThrows(IllegalArgumentException.class, () -> create(program, "chess"));
      String gone = "; games=" + jars + " can't be read: there is no " + jars;
      assertTrue(e.getMessage().endsWith(gone), e.getMessage());
    }
  }

  @Test
  void aJarThatCannotBeReadIsNamed() throws Throwable {
    jar(folder.resolve("good.jar"), "META-INF/services/carom.sim.Game");
    byte[] whole = Files.readAllBytes(folder.resolve("good.jar"));
    Files.write(folder.resolve("broken.jar"), Arrays.copyOf(whole, whole.length / 2));
    try (URLClassLoader program = program()) {
      Method open = program.loadClass(GameJars.class.getName()).getMethod("open", Path.class);
      Throwable e = assertThrows(InvocationTargetException.class, () -> open.invoke(null, folder));
      assertEquals(
          "broken.jar is no jar that can be read; build it again or take it away",
          e.getCause().getMessage());
    }
  }

  private static void jar(Path file, String entry) throws IOException {
    try (JarOutputStream out = new JarOutputStream(Files.newOutputStream(file))) {
      out.putNextEntry(new ZipEntry(entry));
    }
  }
}
