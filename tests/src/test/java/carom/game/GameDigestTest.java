package carom.game;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.ClientConfig;
import carom.client.bots.Bot;
import carom.client.link.ConnectionPhase;
import carom.client.view.ClientView;
import carom.net.transport.Impairment;
import carom.server.config.ServerConfig;
import carom.sim.Game;
import carom.sim.level.Level;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.io.IOException;
import java.io.OutputStream;
import java.lang.reflect.Proxy;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.ServiceLoader;
import java.util.function.Supplier;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import java.util.stream.Stream;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: nobody plays with another build of the server's game without knowing it. Method: builds of
 * a game of three classes, compiled here, of which one number differs.
 */
final class GameDigestTest {
  private static final String GAME =
      """
      package other;
      public final class Skaters implements carom.sim.Game {
        private final Rules[] rules = {new Rules()};
        private carom.sim.level.Archetype disc;
        public String name() { return "skaters"; }
        public String defaultLevel() { return "arena"; }
        public void setUp(carom.sim.SetUp s) {
          disc = s.archetype(new carom.sim.level.ArchetypeDef("skater")
              .shape(new carom.physics.geometry.Circle(0.5f), new carom.physics.Material(1, 0, 0)));
        }
        public void join(carom.sim.Match m, carom.sim.entity.Player p) {
          m.spawn(disc, 2 * p.id(), 0, 0, p);
        }
        public void input(
            carom.sim.Simulation s, carom.sim.entity.Player p, carom.sim.entity.Input in) {
          p.entity().seekVelocity(rules[0].speed() * in.moveX(), 0, 10);
        }
      }
      """;

  private static final String RULES =
      "package other; final class Rules { float speed() { return new Numbers().speed(); } }";

  private static final String NUMBERS =
      "package other; final class Numbers { float speed() { return SPEEDf; } }";

  @TempDir private Path folder;
  private final List<AutoCloseable> open = new ArrayList<>();
  private int builds;

  @AfterEach
  void close() throws Exception {
    for (AutoCloseable one : open) {
      one.close();
    }
  }

  @Test
  void aChangeInAnyClassThatTheGameReachesChangesIt() throws Exception {
    long digest = GameDigest.of(build("5", "").get());
    assertEquals(digest, GameDigest.of(build("5", "").get()), "another folder");
    assertEquals(digest, GameDigest.of(build("5", "class Tool {}").get()), "a class nobody names");
    assertNotEquals(digest, GameDigest.of(build("6", "").get()), "a number two classes away");
  }

  @Test
  void aJarHasTheDigestOfTheFolderFromWhichItWasMade() throws Exception {
    long digest = GameDigest.of(build("5", "").get());
    Path jar = folder.resolve("skaters.jar");
    jar(folder.resolve("build" + builds), jar);
    assertEquals(digest, GameDigest.of(load(jar).get()));
  }

  @Test
  void gamesThatShipHaveOneEachAndGamesMadeAtRunTimeHaveNone() {
    // Asked of the jar, since tests that ran before may have lent games with one class, many names.
    List<Long> digests =
        ServiceLoader.load(Game.class).stream().map(game -> GameDigest.of(game.get())).toList();
    assertTrue(digests.size() >= 3, digests::toString);
    assertEquals(digests.size(), digests.stream().distinct().count());
    assertTrue(digests.stream().noneMatch(d -> d == GameDigest.UNKNOWN));
    Game made =
        (Game)
            Proxy.newProxyInstance(
                Game.class.getClassLoader(), new Class<?>[] {Game.class}, (p, m, a) -> null);
    assertEquals(GameDigest.UNKNOWN, GameDigest.of(made));
  }

  @Test
  void aClientWithAnotherBuildIsToldBothDigests() throws Exception {
    try (Stepper stepper = server(false)) {
      open.add(Games.lend(build("6", "")));
      ClientView view = stepper.add("Ann", Impairment.NONE, new Bot(Stepper.SEED)).view();
      stepper.runUntil("it ended", () -> view.phase() == ConnectionPhase.ENDED, 10);
      String text = view.message();
      assertTrue(text.contains("skaters") && text.contains("--dev"), text);
      assertTrue(text.contains(digest("5")) && text.contains(digest("6")), text);
    }
  }

  @Test
  void theSameBuildAndDevelopersPlay() throws Exception {
    try (Stepper stepper = server(false)) {
      open.add(Games.lend(build("5", "")));
      SimulatedClient same = stepper.join("Ann", Impairment.NONE, new Bot(Stepper.SEED));
      assertEquals(List.of(), same.view().notices());
      open.add(Games.lend(build("6", "")));
      SimulatedClient developer =
          stepper.add(
              ClientConfig.of("Bob").withServer("", 0, 0).with(ClientConfig.DEV, true),
              Impairment.NONE,
              new Bot(Stepper.SEED));
      stepper.awaitPlaying(developer);
      warns(developer);
    }
  }

  @Test
  void aServerForDevelopersWarns() throws Exception {
    try (Stepper stepper = server(true)) {
      open.add(Games.lend(build("6", "")));
      warns(stepper.join("Ann", Impairment.NONE, new Bot(Stepper.SEED)));
    }
  }

  private void warns(SimulatedClient client) throws Exception {
    String text = client.view().notices().get(0).text();
    assertTrue(text.contains(digest("5")) && text.contains(digest("6")), text);
  }

  private String digest(String speed) throws Exception {
    return HexFormat.of().toHexDigits(GameDigest.of(build(speed, "").get()));
  }

  private Stepper server(boolean dev) throws Exception {
    open.add(Games.lend(build("5", "")));
    Level level =
        Level.parse(
            "skaters",
            """
            {"name": "Skaters", "game": "skaters", "gravity": [0, 0],
             "bounds": {"min": [-50, -50], "max": [50, 50]}}
            """
                .getBytes(StandardCharsets.UTF_8));
    return Stepper.of(level, ServerConfig.defaults().with(ServerConfig.DEV, dev));
  }

  /** Compiles a build, whose skaters have a speed, m/s. */
  private Supplier<Game> build(String speed, String more) throws Exception {
    builds++;
    Path sources = Files.createDirectories(folder.resolve("sources" + builds));
    Path classes = Files.createDirectories(folder.resolve("build" + builds));
    List<String> args = new ArrayList<>(List.of("-d", classes.toString(), "--release", "17"));
    args.addAll(List.of("-cp", System.getProperty("java.class.path")));
    List<String> texts = List.of(GAME, RULES, NUMBERS.replace("SPEED", speed), more);
    List<String> names = List.of("Skaters", "Rules", "Numbers", "Tool");
    for (int i = 0; i < texts.size(); i++) {
      Path file = sources.resolve(names.get(i) + ".java");
      Files.writeString(file, texts.get(i));
      args.add(file.toString());
    }
    assertEquals(
        0, ToolProvider.getSystemJavaCompiler().run(null, null, null, args.toArray(new String[0])));
    return load(classes);
  }

  private Supplier<Game> load(Path place) throws Exception {
    URLClassLoader loader =
        new URLClassLoader(new URL[] {place.toUri().toURL()}, Game.class.getClassLoader());
    open.add(loader);
    Class<?> type = loader.loadClass("other.Skaters");
    return () -> {
      try {
        return (Game) type.getConstructor().newInstance();
      } catch (ReflectiveOperationException e) {
        throw new LinkageError(e.getMessage(), e);
      }
    };
  }

  private static void jar(Path classes, Path jar) throws IOException {
    try (OutputStream file = Files.newOutputStream(jar);
        JarOutputStream out = new JarOutputStream(file);
        Stream<Path> found = Files.walk(classes)) {
      for (Path path : found.filter(Files::isRegularFile).toList()) {
        out.putNextEntry(new JarEntry(classes.relativize(path).toString().replace('\\', '/')));
        Files.copy(path, out);
      }
    }
  }
}
