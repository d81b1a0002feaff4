package carom.server.thin.plain;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.game.Games;
import carom.server.CaromMain;
import carom.server.config.ServerConfig;
import carom.server.thin.GameClasses;
import carom.sim.Game;
import carom.sim.level.Level;
import carom.sim.message.MessageKind;
import carom.suite.Needs;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Random;
import java.util.ServiceLoader;
import java.util.concurrent.TimeUnit;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import java.util.stream.Stream;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: a game's own messages are classes for stock KryoNet clients. Method: a jar of a game that
 * nothing else knows; the classes that {@code carom plain} writes for it, compiled as Java 8; a
 * program with them and the real KryoNet in a process of its own.
 */
@Needs("processes")
@Timeout(180)
final class GameMessagesTest {
  private static final String GAME =
      """
      package other;
      import carom.sim.message.*;
      public final class Barter implements carom.sim.Game {
        public enum Mood { SWEET, SOUR }
        public record Offer(
            @IdOfPlayer int to, @IdOfEntity int ball, @Bounds(min = 2, max = 9) int count,
            @Bounds(min = -1, max = 9) float price, boolean rush, Mood mood,
            @Longest(40) String note) {}
        public record Deal(
            @IdOfPlayer int to, @IdOfEntity int ball, @Bounds(min = 2, max = 9) int count,
            @Bounds(min = -1, max = 9) float price, boolean rush, Mood mood,
            @Longest(40) String note) {}
        static final MessageKind OFFER = MessageKind.of(Offer.class).fromClient();
        static final MessageKind DEAL = MessageKind.of(Deal.class).fromServer();
        static final MessageKind ODD = MessageKind.named("odd name!").count("class", 5, 9)
            .flag("it em").text("it/em", 9).choice("string", Mood.class);
        public String name() { return "barter"; }
        public String defaultLevel() { return "market"; }
        public void setUp(carom.sim.SetUp s) {
          s.message(ODD);
          s.message(OFFER);
          s.message(DEAL);
        }
        public void join(carom.sim.Match m, carom.sim.entity.Player p) {}
        public void input(
            carom.sim.Simulation s, carom.sim.entity.Player p, carom.sim.entity.Input in) {}
        public void message(carom.sim.Match m, carom.sim.entity.Player p, Message said) {
          if (said.is(OFFER)) {
            Offer o = said.as(Offer.class);
            m.send(DEAL.of(new Deal(
                o.to() + 1, o.ball() + 1, o.count() + 1, o.price() + 1, !o.rush(),
                Mood.values()[1 - o.mood().ordinal()], o.note()))).to(p);
          } else {
            m.send(ODD.of(said.count("class") + 1, true, "x", Mood.SOUR)).to(p);
          }
        }
      }
      """;

  private static final String LEVEL =
      """
      {"name": "market", "game": "barter", "gravity": [0, 0],
       "bounds": {"min": [-9, -9], "max": [9, 9]}}
      """;

  @TempDir Path folder;

  private Path jar;

  @BeforeEach
  void build() throws IOException {
    Path source = Files.writeString(folder.resolve("Barter.java"), GAME);
    Path out = Files.createDirectories(folder.resolve("game"));
    String path = System.getProperty("java.class.path");
    String[] arguments = {"-proc:none", "-cp", path, "-d", out.toString(), source.toString()};
    assertEquals(0, ToolProvider.getSystemJavaCompiler().run(null, null, null, arguments));
    Files.createDirectories(out.resolve("levels"));
    Files.writeString(out.resolve("levels/market.json"), LEVEL);
    Files.createDirectories(out.resolve("META-INF/services"));
    Files.writeString(out.resolve("META-INF/services/carom.sim.Game"), "other.Barter\n");
    jar = folder.resolve("barter.jar");
    try (OutputStream file = Files.newOutputStream(jar);
        JarOutputStream to = new JarOutputStream(file);
        Stream<Path> files = Files.walk(out)) {
      for (Path one : files.filter(Files::isRegularFile).toList()) {
        to.putNextEntry(new JarEntry(out.relativize(one).toString().replace('\\', '/')));
        Files.copy(one, to);
      }
    }
  }

  private String write(int status, String... more) {
    StringWriter said = new StringWriter();
    List<String> arguments = new ArrayList<>(List.of("plain", jar.toString()));
    arguments.addAll(List.of(more));
    PrintWriter to = new PrintWriter(said);
    assertEquals(status, CaromMain.run(to, to, arguments.toArray(new String[0])), said.toString());
    return said.toString();
  }

  @SuppressWarnings("try") // the loan ends with it
  @Test
  void messagesGoInBothDirectionsAsClasses() throws Exception {
    Path classes = folder.resolve("classes of barter");
    String said = write(0, "--out", classes.toString());
    assertTrue(said.contains("Deal Messages Odd_name_ Offer, classes=4 digest="), said);
    try (Stream<Path> files = Files.walk(classes);
        URLClassLoader loader = new URLClassLoader(new URL[] {jar.toUri().toURL()})) {
      List<Path> sources = new ArrayList<>(files.filter(Files::isRegularFile).toList());
      sources.add(StockJvm.resource("Barterer.java"));
      StockJvm stock = new StockJvm(folder, sources.toArray(new Path[0]));
      Game game =
          ServiceLoader.load(Game.class, loader).stream()
              .filter(one -> one.type().getClassLoader() == loader)
              .findFirst()
              .orElseThrow()
              .get();
      try (Games.Loan loan = Games.lend(() -> game);
          PlainRig rig =
              new PlainRig(
                  ServerConfig.defaults().with(ServerConfig.STATUS_INTERVAL, 0),
                  PlainLimits.DEFAULT,
                  true,
                  Level.parse("market", LEVEL.getBytes(StandardCharsets.UTF_8)))) {
        for (Path home : StockJvm.homes()) {
          assertEquals(
              List.of(
                  "welcome",
                  "deal to=4 ball=71 count=8 price=3.5 rush=false mood=SWEET note=228",
                  "odd class=6 item=true x SOUR",
                  "goodbye LEFT"),
              run(stock, rig, home, "own"));
        }
        List<String> refused = run(stock, rig, StockJvm.homes().get(0), "0123456789abcdef");
        assertEquals(1, refused.size(), refused::toString);
        String own = said.substring(said.indexOf("digest=") + 7).strip();
        assertTrue(refused.get(0).startsWith("refused GAME_VERSION "), refused::toString);
        assertTrue(refused.get(0).contains("barter"), refused::toString);
        assertTrue(refused.get(0).contains("digest=0123456789abcdef"), refused::toString);
        assertTrue(refused.get(0).contains(own), refused + " " + own);
        assertEquals(0, rig.door.counters().errors.get(), () -> "" + rig.door.nextError());
      }
    }
  }

  private List<String> run(StockJvm stock, PlainRig rig, Path home, String digest)
      throws Exception {
    Path output = folder.resolve("output.txt");
    Process program =
        stock
            .program(
                home,
                "Barterer",
                String.valueOf(rig.door.tcpPort()),
                String.valueOf(rig.door.udpPort()),
                digest)
            .redirectErrorStream(true)
            .redirectOutput(output.toFile())
            .start();
    try {
      boolean ended = program.waitFor(PlainRig.MOST_SECONDS, TimeUnit.SECONDS);
      List<String> lines = new ArrayList<>(Files.readAllLines(output));
      lines.removeIf(line -> line.startsWith("WARNING: ")); // a later JVM's, about Kryo 2.24
      assertTrue(ended && program.exitValue() == 0, lines::toString);
      return lines;
    } finally {
      program.destroyForcibly();
    }
  }

  @Test
  void whatCantBeWrittenIsRefusedByName() {
    String out = folder.resolve("out").toString();
    assertTrue(write(2, "--out", out, "--package", "a b").contains("--package=a b"));
    jar = folder.resolve("none.jar");
    assertTrue(write(2, "--out", out).contains("none.jar is no file"));
    jar = Path.of("arena");
    assertTrue(write(2, "--out", out).contains("arena has no messages"));
    jar = Path.of("arema");
    assertTrue(write(2, "--out", out).contains("arena"));
  }

  @Test
  void noBytesMakeTheDoorReadMoreThanTheClassesHave() {
    GameClasses classes =
        new GameClasses(
            List.of(
                MessageKind.named("a").text("text", 9).choice("mood", MessageKind.Direction.class),
                MessageKind.named("b").count("n", 0, 9)));
    PlainDecoder decoder = new PlainDecoder();
    String right = "54" + "04"; // 82 + 2: one class and its enum come before
    byte[] bytes = HexFormat.of().parseHex(right);
    assertEquals(
        "Custom[kind=b, values={n=2}]", "" + decoder.decode(bytes, 0, bytes.length, classes));
    assertNull(decoder.decode(bytes, 0, bytes.length, null), "a client without classes");
    for (String wrong : List.of("53", "5500", "54", "540400", "520480", "520580", "52ffffffff7f")) {
      byte[] one = HexFormat.of().parseHex(wrong);
      assertNull(decoder.decode(one, 0, one.length, classes), wrong);
      assertTrue(decoder.problem() != null, wrong);
    }
    long seed = System.nanoTime();
    Random random = new Random(seed);
    for (int i = 0; i < 20_000; i++) {
      byte[] any = new byte[1 + random.nextInt(40)];
      random.nextBytes(any);
      any[0] = (byte) (PlainIds.FIRST_OF_GAME + random.nextInt(4));
      Object read = decoder.decode(any, 0, any.length, classes);
      assertEquals(read == null, decoder.problem() != null, "seed=" + seed);
    }
  }
}
