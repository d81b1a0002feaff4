package carom.docs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import carom.client.bots.Bot;
import carom.client.look.ViewSetup;
import carom.client.view.ClientView;
import carom.game.arena.ArenaGame;
import carom.net.kryo.server.KryoServerTransport;
import carom.net.transport.Impairment;
import carom.server.CaromMain;
import carom.server.Server;
import carom.server.config.ServerConfig;
import carom.sim.level.Level;
import carom.suite.Needs;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: a stranger who reads MAKE-A-GAME.md alone gets the game, and the clients, that it shows.
 * Method: {@code carom new} lays out the project, each block goes into the file that the page names
 * before it, and the project's own test is run; the clients are compiled, join a server and paint.
 */
@Needs("processes")
final class MakeAGameTest {
  private static final Path PAGE = Path.of("..", "docs", "games", "MAKE-A-GAME.md");
  private static final int MOST_SECONDS = 900; // takes 5 to 10 on a machine that does nothing else
  private static final int MOST_LINES_OF_PAINTER = 70;
  private static final int MOST_LINES_OF_CLIENT = 40;

  @TempDir Path folder;

  private static String block(String marker) throws IOException {
    Matcher block =
        Pattern.compile("```java\n(.*?)```", Pattern.DOTALL).matcher(Files.readString(PAGE));
    while (block.find()) {
      if (block.group(1).contains(marker)) {
        return block.group(1);
      }
    }
    throw new AssertionError("the page shows no " + marker);
  }

  private static void compile(Path into, String classPath, List<Path> sources) {
    List<String> arguments = new ArrayList<>(List.of("-proc:none", "-Xlint:all,-path", "-Werror"));
    arguments.addAll(List.of("-d", into.toString(), "-cp", classPath));
    sources.forEach(source -> arguments.add(source.toString()));
    ByteArrayOutputStream errors = new ByteArrayOutputStream();
    int status =
        ToolProvider.getSystemJavaCompiler()
            .run(null, null, errors, arguments.toArray(new String[0]));
    assertEquals(0, status, () -> errors.toString(StandardCharsets.UTF_8));
  }

  private String run(String classPath, String... arguments) throws Exception {
    Path output = folder.resolve("output.txt");
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(List.of("-Dkryo.unsafe=false", "-Djava.awt.headless=true", "-cp", classPath));
    command.addAll(List.of(arguments));
    Process jvm =
        new ProcessBuilder(command)
            .directory(folder.toFile())
            .redirectErrorStream(true)
            .redirectOutput(output.toFile())
            .start();
    try {
      assertTrue(jvm.waitFor(MOST_SECONDS, TimeUnit.SECONDS), "it still runs");
      assertEquals(0, jvm.exitValue(), Files.readString(output));
      return Files.readString(output);
    } finally {
      jvm.destroyForcibly();
    }
  }

  /** Puts the blocks of the page into the files of a project; returns how many. */
  private static int overlay(Path project) throws IOException {
    Matcher named =
        Pattern.compile("`(src/[^`]+)`:\n\n```\\w+\n(.*?)```", Pattern.DOTALL)
            .matcher(Files.readString(PAGE));
    int files = 0;
    while (named.find()) {
      Path file = project.resolve(named.group(1));
      Files.createDirectories(file.getParent());
      Files.writeString(file, named.group(2));
      files++;
    }
    return files;
  }

  @Test
  void theGameOfThePageIsBuiltAndPlayed() throws Exception {
    String path = System.getProperty("carom.starter.path");
    assumeTrue(path != null, "carom.starter.path isn't set: run by Gradle");
    StringWriter err = new StringWriter();
    int made =
        CaromMain.run(
            new PrintWriter(new StringWriter()),
            new PrintWriter(err),
            "new",
            "castle",
            "--in",
            folder.toString());
    assertEquals(0, made, err::toString);
    Path project = folder.resolve("castle");
    assertEquals(5, overlay(project));
    List<Path> sources;
    try (Stream<Path> files = Files.walk(project.resolve("src"))) {
      sources = files.filter(file -> file.toString().endsWith(".java")).toList();
    }
    Path classes = project.resolve("classes");
    compile(classes, path, sources);
    Path resources = project.resolve("src/main/resources");
    String all = String.join(File.pathSeparator, path, classes.toString(), resources.toString());
    String tests =
        run(
            all,
            "org.junit.platform.console.ConsoleLauncher",
            "execute",
            "--disable-ansi-colors",
            "--scan-classpath",
            classes.toString());
    assertTrue(tests.contains("1 tests successful"), tests);
    try (URLClassLoader loader = new URLClassLoader(new URL[] {classes.toUri().toURL()})) {
      Object view = loader.loadClass("castle.CastleView").getConstructor().newInstance();
      view.getClass().getMethod("setUp", ViewSetup.class).invoke(view, new ViewSetup());
    }
  }

  @Test
  void thePictureOfThePageIsDrawn() throws Exception {
    Path source = Files.writeString(folder.resolve("Draw.java"), block("class Draw"));
    compile(folder, "", List.of(source));
    run(folder.toString(), "Draw");
    assertTrue(Files.size(folder.resolve("src/main/resources/castle/knight.png")) > 100);
  }

  @Test
  void theHeadlessClientPlays() throws Exception {
    String code = block("class HeadlessClient");
    assertTrue(code.lines().count() <= MOST_LINES_OF_CLIENT);
    Path source = Files.writeString(folder.resolve("HeadlessClient.java"), code);
    String path = System.getProperty("java.class.path");
    compile(folder, path, List.of(source));
    KryoServerTransport transport = new KryoServerTransport(0, 0);
    try (Server server =
        new Server(
            ServerConfig.defaults().with(ServerConfig.STATUS_INTERVAL, 0),
            ArenaGame::new,
            Level.builtIn("arena"),
            transport,
            System::nanoTime)) {
      server.start();
      String output =
          run(
              folder + File.pathSeparator + path,
              "HeadlessClient",
              "localhost",
              Integer.toString(transport.tcpPort()),
              Integer.toString(transport.udpPort()));
      assertEquals(3, output.lines().filter(line -> line.contains("players=1")).count(), output);
    }
  }

  @Test
  void theRendererPaintsWhatIsThere() throws Exception {
    String code = block("class Painter");
    assertTrue(code.lines().count() <= MOST_LINES_OF_PAINTER);
    Path source = Files.writeString(folder.resolve("Painter.java"), code);
    compile(folder, System.getProperty("java.class.path"), List.of(source));
    BufferedImage picture = new BufferedImage(640, 360, BufferedImage.TYPE_INT_RGB);
    Graphics2D graphics = picture.createGraphics();
    int wall;
    int disc;
    try (Stepper world = Stepper.of(ArenaGame::new, "arena");
        URLClassLoader loader = new URLClassLoader(new URL[] {folder.toUri().toURL()})) {
      SimulatedClient ann = world.join("Ann", Impairment.NONE, new Bot(1));
      world.run(1);
      Level level = ann.view().level();
      wall = level.archetypes().get(level.statics().get(0).archetype()).appearance().rgb();
      disc = ann.view().own().archetype().appearance().rgb();
      Object painter = loader.loadClass("Painter").getConstructor().newInstance();
      painter
          .getClass()
          .getMethod("paint", Graphics2D.class, ClientView.class, int.class, int.class)
          .invoke(painter, graphics, ann.view(), 640, 360);
    } finally {
      graphics.dispose();
    }
    Set<Integer> colours = new HashSet<>();
    for (int y = 0; y < 360; y++) {
      for (int x = 0; x < 640; x++) {
        colours.add(picture.getRGB(x, y) & 0xffffff);
      }
    }
    assertTrue(colours.containsAll(List.of(wall, disc)), () -> "colours=" + colours);
    assertTrue(colours.size() >= 4, () -> "colours=" + colours);
  }
}
