package carom.server;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.fixtures.Javac;
import carom.fixtures.Jvm;
import carom.suite.Needs;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** A server with {@code --dev} plays anew what changes on the disk. */
@Needs("processes")
@Timeout(120)
final class DevTest {
  private static final String GAME =
      """
      package other;
      public final class Skaters implements carom.sim.Game {
        public String name() { return "skaters"; }
        public String defaultLevel() { return "skaters-rink"; }
        public void setUp(carom.sim.SetUp s) {}
        public void begin(carom.sim.Match m) { m.notice("BUILD"); }
        public void join(carom.sim.Match m, carom.sim.entity.Player p) {}
        public void input(
            carom.sim.Simulation s, carom.sim.entity.Player p, carom.sim.entity.Input in) {}
      }
      """;

  @TempDir private Path folder;
  private Process server;

  @AfterEach
  void end() {
    if (server != null) {
      server.destroyForcibly();
    }
  }

  private void start(String... args) throws Exception {
    List<String> command =
        Jvm.command(ServerMain.class, "--dev", "--tcp-port=0", "--udp-port=0", "--idle=run");
    command.addAll(List.of(args));
    ProcessBuilder builder = new ProcessBuilder(command);
    builder.environment().put("CAROM_DATA", folder.resolve("data").toString());
    builder.environment().put("CAROM_WEB_PORT", "0");
    builder.environment().put("CAROM_QUERY_PORT", "0");
    builder.redirectOutput(folder.resolve("out").toFile());
    server = builder.redirectError(folder.resolve("err").toFile()).start();
    awaitText("ready: tcp");
  }

  private void awaitText(String text) throws Exception {
    String err = "";
    for (int i = 0; i < 600 && !err.contains(text); i++) {
      Thread.sleep(100);
      err = Files.readString(folder.resolve("err"));
    }
    assertTrue(err.contains(text), text + " in " + err);
  }

  private static String level(String name, String game) {
    return "{\"name\": \"%s\", \"game\": \"%s\", \"gravity\": [0, -10], \"bounds\": {\"min\": [-9, -9], "
            .formatted(name, game)
        + "\"max\": [9, 9]}, \"spawns\": [{\"at\": [0, 0]}, {\"name\": \"flag\", \"at\": [1, 0]}]}";
  }

  @Test
  void aLevelIsPlayedAnewWhenItsFileChanges() throws Exception {
    Path file = folder.resolve("mine.json");
    Files.writeString(file, level("First", "platformer"));
    start("--level", file.toString());
    Files.writeString(file, level("Second one", "platformer"));
    awaitText("playing game=platformer level=Second one");
    Files.writeString(file, level("Third", "platformer").replace("[9, 9]", "[9]"));
    awaitText("can't be played: mine.json:1:");
    Files.writeString(file, level("The fourth", "platformer"));
    awaitText("playing game=platformer level=The fourth");
  }

  @Test
  void aGameIsPlayedAnewWhenItsJarChanges() throws Exception {
    Path games = Files.createDirectory(folder.resolve("games"));
    jar(games, "1");
    start("--games", games.toString(), "--game", "skaters");
    jar(games, "22");
    awaitText("playing game=skaters level=Rink 22");
  }

  /** Builds a game's jar, with a level that tells the build. */
  private void jar(Path games, String build) throws Exception {
    Path out = Files.createDirectories(folder.resolve("build" + build));
    Path source = Files.writeString(out.resolve("Skaters.java"), GAME.replace("BUILD", build));
    Javac.compile(out, source);
    try (JarOutputStream jar =
        new JarOutputStream(Files.newOutputStream(games.resolve("skaters.jar")))) {
      put(jar, "other/Skaters.class", Files.readAllBytes(out.resolve("other/Skaters.class")));
      put(jar, "META-INF/services/carom.sim.Game", "other.Skaters\n".getBytes(UTF_8));
      put(jar, "levels/skaters-rink.json", level("Rink " + build, "skaters").getBytes(UTF_8));
    }
  }

  private static void put(JarOutputStream jar, String name, byte[] bytes) throws Exception {
    jar.putNextEntry(new JarEntry(name));
    jar.write(bytes);
    jar.closeEntry();
  }
}
