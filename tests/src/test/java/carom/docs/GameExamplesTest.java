package carom.docs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.game.Games;
import carom.sim.Role;
import carom.sim.SimulationHost;
import carom.sim.level.Level;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: the Java and the levels that the pages for game developers show work, with no imports but
 * those that the pages tell. Method: each Java example becomes a class that extends {@code Given},
 * which has the names that examples take for granted. Its parts, apart by a blank line or {@code
 * ...}, are members of the class, if they begin like one, and else statements of a method {@code
 * run}. Each piece of a level is put into a level.
 */
final class GameExamplesTest {
  private static final List<String> PAGES =
      List.of(
          "games/GAMES.md",
          "games/PLAYERS.md",
          "games/SHARED.md",
          "games/TESTING.md",
          "games/VIEW.md",
          "server/REPLAY.md");

  private static final String HEAD =
      """
      import static carom.sim.event.Audience.*;
      import static org.junit.jupiter.api.Assertions.*;
      import carom.game.arena.ArenaGame;
      import carom.game.tag.TagGame;
      import carom.options.NetworkConditions.Preset;
      import java.nio.file.*;
      import java.util.List;
      """;

  private static final String GIVEN =
      """
      class Given implements Game {
        enum Phase { WARM_UP, PLAYING, FINAL }
        static final Phase FINAL = Phase.FINAL;
        static final carom.sim.field.Scope MATCH = carom.sim.field.Scope.MATCH;
        static final Count HEALTH = Field.count("health", 0, 100);
        static final Countdown RELOAD = Field.countdown("reload");
        static final Real SPEED = Field.real("speed");
        static final Countdown FUEL = Field.countdown("fuel");
        static final Ratio NITRO = Field.ratio("nitro");
        static final Flag LEVER = Field.flag("lever");
        static final Flag SCOPE = Field.flag("scope");
        static final PlayerRef TURN = Field.player("turn");
        static final EntityRef BALL = Field.entity("ball");
        static final Choice<Phase> PHASE = Field.choice("phase", Phase.class);
        Simulation s;
        Match m;
        Player player, shooter, scorer;
        Entity ball, crate;
        Archetype coin, spikes, balloon, hovercraft, fan, rocketKind, crouched, standing, ice, crateKind;
        carom.sim.entity.Assembly car;
        Material rubber, metal;
        EventKind knock, boom, shot, goal;
        EntityHit hit;
        carom.physics.effects.Hover<?> hover;
        EntityFilter notMyself;
        Pool lake;
        Phase phase;
        World<String> world;
        ViewSetup v;
        Path path;
        float x, y, wayX, wayY, jx, jy;
        int goals, team;
        boolean touching;
        public String name() { return "given"; }
        public String defaultLevel() { return "arena"; }
        public void setUp(SetUp s) {}
        public void join(Match m, Player p) {}
        public void input(Simulation s, Player p, Input in) {}
        void giveBody(Match m, Player p) {}
        void beginRound(Match m) {}
        boolean canPay(Player p, int item) { return true; }
        String mild(String text) { return text; }
        boolean isFreezing(Match m) { return false; }
        Archetype weather(SetUp s, String name, float gravity) { return null; }
      }
      """;

  /** Finds statements that belong into {@code setUp}. */
  private static final Pattern SETS_UP =
      Pattern.compile("\\bs\\.(assembly|pool|event|material|mover)\\(|s\\.archetype\\(new|\\(s, ");

  private static final Pattern MEMBER =
      Pattern.compile("(@Override|static|private|public|protected)\\b.*", Pattern.DOTALL);

  private static List<String> blocks(String page, String language) throws IOException {
    List<String> found = new ArrayList<>();
    Matcher block =
        Pattern.compile("```" + language + "\n(.*?)```", Pattern.DOTALL)
            .matcher(Files.readString(Path.of("..", "docs", page)));
    while (block.find()) {
      found.add(block.group(1));
    }
    return found;
  }

  /** Returns an example as a class, and adds its imports to the others. */
  private static String exampleClass(String name, String example, StringBuilder imports) {
    StringBuilder code = new StringBuilder();
    for (String line : example.lines().toList()) {
      if (line.startsWith("import ")) {
        imports.append(line).append('\n');
      } else {
        String left =
            line.equals("...") ? "" : line.replaceFirst("^ +\\.\\.\\.$|(?<=\\{ )\\.\\.\\.", ";");
        code.append(left).append('\n');
      }
    }
    StringBuilder members = new StringBuilder();
    StringBuilder statements = new StringBuilder();
    boolean inMember = false;
    for (String part : code.toString().split("\n(?=\n)")) {
      String text = part.replaceFirst("^\n+", "");
      boolean goesOn = text.startsWith(" "); // a blank line within a method
      inMember = goesOn ? inMember : MEMBER.matcher(text).matches();
      (inMember ? members : statements).append(part).append('\n');
    }
    String given = SETS_UP.matcher(statements).find() ? "SetUp s = null;" : "";
    return "class %s extends Given {\n%s\n  public void run() throws Exception {\n%s\n%s\n  }\n}\n"
        .formatted(name, members, given, statements);
  }

  private static String compile(Path folder) throws IOException {
    StringBuilder imports = new StringBuilder(HEAD).append(listedImports());
    StringBuilder classes = new StringBuilder(GIVEN);
    int examples = 0;
    for (String page : PAGES) {
      int number = 0;
      for (String example : blocks(page, "java")) {
        if (!example.startsWith("package ")) { // the game of GAMES.md, see TutorialTest
          String name = page.replaceAll(".*/|[.]md", "") + ++number;
          classes.append(exampleClass(name, example, imports));
          examples++;
        }
      }
    }
    assertTrue(examples >= 20, "examples=" + examples);
    Path file = folder.resolve("Examples.java");
    Files.writeString(file, imports.append(classes));
    ByteArrayOutputStream errors = new ByteArrayOutputStream();
    String classPath = System.getProperty("java.class.path");
    ToolProvider.getSystemJavaCompiler()
        .run(null, null, errors, "-proc:none", "-cp", classPath, file.toString());
    return errors.toString(StandardCharsets.UTF_8);
  }

  /**
   * Returns the imports of the classes that the page lists by package: readers without an editor
   * that completes them have only the pages.
   */
  private static String listedImports() throws IOException {
    StringBuilder imports = new StringBuilder();
    Matcher row =
        Pattern.compile("\\| `(carom[a-z.]+)` \\| (.*) \\|")
            .matcher(Files.readString(Path.of("..", "docs", "games", "GAMES.md")));
    while (row.find()) {
      Matcher name = Pattern.compile("`(\\w+)`").matcher(row.group(2));
      while (name.find()) {
        imports.append("import %s.%s;\n".formatted(row.group(1), name.group(1)));
      }
    }
    return imports.toString();
  }

  @Test
  void everyExampleCompilesAndThatOfATestPasses(@TempDir Path folder) throws Exception {
    assertEquals("", compile(folder));
    URL[] urls = {folder.toUri().toURL()};
    try (URLClassLoader loader = new URLClassLoader(urls, getClass().getClassLoader())) {
      var maker = loader.loadClass("TESTING1").getDeclaredConstructor();
      maker.setAccessible(true);
      Object example = maker.newInstance();
      var run = example.getClass().getMethod("run");
      run.setAccessible(true);
      run.invoke(example);
    }
  }

  @Test
  void anExampleOfWhatIsNotThereDoesNotCompile(@TempDir Path folder) throws Exception {
    StringBuilder imports = new StringBuilder(HEAD).append(listedImports());
    String example =
        "@Override public void input(Simulation s, Player p, Input in) {\n\n  p.fly();\n}\n";
    String source = exampleClass("Wrong", example, imports);
    Path file = folder.resolve("Wrong.java");
    Files.writeString(file, imports + GIVEN + source);
    ByteArrayOutputStream errors = new ByteArrayOutputStream();
    String classPath = System.getProperty("java.class.path");
    ToolProvider.getSystemJavaCompiler()
        .run(null, null, errors, "-proc:none", "-cp", classPath, file.toString());
    String message = errors.toString(StandardCharsets.UTF_8);
    assertTrue(message.contains("1 error") && message.contains("fly()"), message);
  }

  @Test
  void everyPieceOfALevelLoads() throws Exception {
    int pieces = 0;
    for (String block : blocks("games/LEVELS.md", "json")) {
      if (block.startsWith("{ \"type\"")) { // shapes, one a line
        for (String shape : block.lines().toList()) {
          load("\"statics\": [{ \"at\": [0, 0], \"shape\": " + shape + " }]");
          pieces++;
        }
      } else {
        load(block.startsWith("{") ? null : block, block);
        pieces++;
      }
    }
    assertTrue(pieces >= 10, "pieces=" + pieces);
  }

  @Test
  void theLevelWithTriggersOpensItsDoor() throws Exception {
    for (String block : blocks("games/LEVELS.md", "json")) {
      if (block.contains("Gatehouse")) {
        Level level = Level.parse("LEVELS.md", block.getBytes(StandardCharsets.UTF_8));
        SimulationHost s =
            new SimulationHost(Games.create(level.gameName()), level, 1, 60, Role.AUTHORITY);
        s.join("Ann");
        for (int tick = 0; tick < 120; tick++) {
          s.step();
        }
        assertEquals(4.5f, s.entity(0).y(), 1e-4f);
        return;
      }
    }
    throw new AssertionError("LEVELS.md shows no level with triggers");
  }

  private static void load(String piece) throws Exception {
    load(piece, null);
  }

  private static void load(String piece, String whole) throws Exception {
    String level =
        piece == null
            ? whole
            : """
            { "name": "Piece", "game": "arena", "gravity": [0, -10],
              "bounds": { "min": [-40, -20], "max": [40, 20] },
              "materials": { "grass": {}, "ice": { "friction": 0 } },
              %s }
            """
                .formatted(piece);
    Level.parse("LEVELS.md", level.getBytes(StandardCharsets.UTF_8));
  }
}
