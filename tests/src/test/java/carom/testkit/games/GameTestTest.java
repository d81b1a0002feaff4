package carom.testkit.games;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.bots.Bot;
import carom.client.bots.BotBrain;
import carom.client.bots.BotBrains;
import carom.client.bots.Senses;
import carom.client.view.ClientView;
import carom.fixtures.PlainGame;
import carom.game.arena.ArenaGame;
import carom.options.NetworkConditions.Preset;
import carom.physics.Material;
import carom.physics.geometry.Circle;
import carom.server.CaromMain;
import carom.sim.Game;
import carom.sim.Match;
import carom.sim.Rules;
import carom.sim.SetUp;
import carom.sim.Simulation;
import carom.sim.entity.Entity;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import carom.sim.event.Audience;
import carom.sim.field.Count;
import carom.sim.field.Field;
import carom.sim.field.Ratio;
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Level;
import carom.testkit.GameReport;
import carom.testkit.GameTest;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.function.Consumer;
import java.util.function.IntSupplier;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Goal: {@code carom test} finds each kind of broken rule, names it, and finds nothing in a good
 * game. Method: a small good game, and one that breaks one rule for each kind.
 */
class GameTestTest {
  private static final Ratio NITRO = Field.ratio("nitro").to(Audience.NEAR).startsAt(1);
  private static final Count LUCK = Field.count("luck", 0, 9).to(Audience.NOBODY);

  /** Breaks no rule: discs that run about. */
  public static class Good extends PlainGame {
    private Archetype disc;

    public Good() {
      super("trial");
    }

    @Override
    public List<Field<?>> fields() {
      return List.of(NITRO, LUCK);
    }

    @Override
    public void setUp(SetUp s) {
      disc = s.archetype(new ArchetypeDef("disc").shape(new Circle(0.5f), new Material(1, 0, 0)));
    }

    @Override
    public void join(Match s, Player p) {
      s.spawn(disc, 3 * p.id(), 0, 0, p);
    }

    @Override
    public void input(Simulation s, Player p, Input in) {
      float speed = speed(s, p, in);
      Entity body = p.entity();
      body.seekVelocity(in.moveX() * speed, in.moveY() * speed, 10);
    }

    float speed(Simulation s, Player p, Input in) {
      return 5;
    }
  }

  /** Breaks no rule: discs among bullets, which bodies stop that a client doesn't have. */
  public static final class Pucks extends PlainGame {
    private Archetype mallet;
    private Archetype puck;

    public Pucks() {
      super("trial");
    }

    @Override
    public void setUp(SetUp s) {
      mallet =
          s.archetype(
              new ArchetypeDef("mallet")
                  .shape(new Circle(0.8f), new Material(1, 0.1f, 0.9f))
                  .fixedRotation(true));
      puck =
          s.archetype(
              new ArchetypeDef("puck")
                  .shape(new Circle(0.5f), new Material(0.3f, 0.05f, 0.95f))
                  .bullet(true));
    }

    @Override
    public void begin(Match m) {
      for (int i = 0; i < 30; i++) {
        m.spawn(puck, -9 + 0.6f * i, 6);
      }
    }

    @Override
    public void join(Match m, Player p) {
      m.spawn(mallet, p.id() % 2 == 0 ? -8 : 8, 1.7f * (p.id() - 2), 0, p);
    }

    @Override
    public void input(Simulation s, Player p, Input in) {
      p.entity().seekVelocity(14 * in.moveX(), 14 * in.moveY(), 14);
    }
  }

  /** Goes to the nearest puck. */
  private static final class Chaser implements BotBrain {
    @Override
    public String game() {
      return "trial";
    }

    @Override
    public void decide(Senses s, Input out) {
      ClientView.Drawn puck = s.nearest("puck");
      if (puck != null) {
        float way = Math.max(0.01f, s.distance(puck));
        out.move((puck.x() - s.own().x()) / way, (puck.y() - s.own().y()) / way);
      }
    }
  }

  /** Writes a field in afterStep that input reads. */
  public static final class WritesLate extends Good {
    @Override
    float speed(Simulation s, Player p, Input in) {
      return 3 + 4 * p.get(NITRO);
    }

    @Override
    public void afterStep(Match s) {
      for (Player p : s.players()) {
        p.add(NITRO, s.tick() % 60 < 30 ? -0.02f : 0.02f);
      }
    }
  }

  /** Pushes bodies in beforeStep. */
  public static final class PushesEarly extends Good {
    @Override
    public void beforeStep(Match s) {
      for (Player p : s.players()) {
        p.entity().applyForce(3, 0);
      }
    }
  }

  /** Reads what only the server knows. */
  public static final class ReadsSecret extends Good {
    @Override
    float speed(Simulation s, Player p, Input in) {
      return 5 + p.get(LUCK);
    }
  }

  /** Writes in its rules what only the server knows. */
  public static final class RulesWriteSecret extends Good {
    @Override
    public Consumer<Rules> rules(Level level) {
      return r -> {
        for (Entity e : r.entities()) {
          e.owner().add(LUCK, 1);
        }
      };
    }
  }

  /** Reads in its rules what only the server knows. */
  public static final class RulesReadSecret extends Good {
    @Override
    public Consumer<Rules> rules(Level level) {
      return r -> {
        for (Entity e : r.entities()) {
          e.owner().add(NITRO, e.owner().get(LUCK) > 3 ? 0.1f : -0.1f);
        }
      };
    }
  }

  /** Throws now and then. */
  public static final class Throws extends Good {
    @Override
    public void afterStep(Match s) {
      if (s.tick() % 100 == 99) {
        throw new IllegalStateException("the flag is gone");
      }
    }
  }

  /** Remembers in a variable what it should keep in a field. */
  public static final class Remembers extends Good {
    private int calls;

    @Override
    float speed(Simulation s, Player p, Input in) {
      calls++;
      return 4 + calls % 300 / 100f;
    }
  }

  /** Pushes a player once in a while, in a method of its own. */
  public static final class HurtsSeldom extends Good {
    @Override
    public void afterStep(Match s) {
      if (s.tick() % 50 == 0) {
        hurt(s);
      }
    }

    private static void hurt(Match s) {
      for (Player p : s.players()) {
        p.entity().applyImpulse(0, 4 * p.entity().mass());
      }
    }
  }

  /** Pushes what belongs to nobody against a player now and then. */
  public static final class KicksSeldom extends Good {
    private Archetype crate;

    @Override
    public void setUp(SetUp s) {
      super.setUp(s);
      crate =
          s.archetype(
              new ArchetypeDef("crate")
                  .shape(new Circle(0.5f), new Material(1, 0, 0))
                  .linearDamping(3));
    }

    @Override
    public void begin(Match m) {
      for (int i = 0; i < 40; i++) {
        int row = i / 8;
        m.spawn(crate, i % 8 * 1.1f - 4, row * 1.1f - 2);
      }
    }

    @Override
    public void afterStep(Match m) {
      if (m.tick() % 50 == 0) {
        kick(m);
      }
    }

    private void kick(Match m) {
      for (Entity e : m.entities()) {
        if (e.archetype() == crate) {
          e.applyImpulse((m.tick() % 100 == 0 ? 4 : -4) * e.mass(), 0);
        }
      }
    }
  }

  /** Does in its input, by way of a lambda, what a game must not do. */
  public static final class Calls extends Good {
    private static int shared;
    private final Map<String, Integer> bag = new HashMap<>(Map.of("a", 1));

    @Override
    float speed(Simulation s, Player p, Input in) {
      IntSupplier none = () -> p.id() < 0 ? all() : 0; // never called
      return 5 + none.getAsInt();
    }

    private int all() {
      for (int value : bag.values()) {
        shared += value;
      }
      return (int) (System.nanoTime() + Math.pow(2, 3) + Math.random() + new Object().hashCode())
          + Path.of("x").getNameCount()
          + shared;
    }
  }

  /** Rolls dice that no seed repeats. */
  public static final class RollsDice extends Good {
    private final Random random = new Random();

    @Override
    float speed(Simulation s, Player p, Input in) {
      return 4 + random.nextFloat();
    }
  }

  /** Lays out what it has by dice that are the same each time, which breaks no rule. */
  public static final class LaysOut extends Good {
    private float speed;

    @Override
    public void setUp(SetUp s) {
      super.setUp(s);
      speed = 4 + new Random(7).nextFloat();
    }

    @Override
    float speed(Simulation s, Player p, Input in) {
      return speed;
    }
  }

  /** Does otherwise on clients. */
  public static final class KnowsItsRole extends Good {
    private boolean serves;

    @Override
    public void begin(Match m) {
      serves = true;
    }

    @Override
    float speed(Simulation s, Player p, Input in) {
      return serves ? 5 : 6;
    }
  }

  private static GameReport test(Supplier<Game> game) throws Exception {
    String json =
        "{\"name\": \"Trial\", \"game\": \"trial\", \"gravity\": [0, 0],"
            + " \"bounds\": {\"min\": [-50, -50], \"max\": [50, 50]}}";
    Level level = Level.parse("trial.json", json.getBytes(StandardCharsets.UTF_8));
    return GameTest.run(game, level, List.of(Preset.TRANSATLANTIC), 2, 6, 1);
  }

  private static void assertFinds(String text, Supplier<Game> game) throws Exception {
    GameReport report = test(game);
    assertTrue(report.broken().stream().anyMatch(rule -> rule.contains(text)), report.text());
  }

  @Test
  void aGoodGameBreaksNoRuleAndIsPredictedExactly() throws Exception {
    GameReport report = test(Good::new);
    assertEquals(List.of(), report.broken());
    assertEquals(0, report.correctionsPerMinute(), report.text());
  }

  /** With seed 1 a bullet that was stopped was taken for a broken rule. */
  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3})
  void aBulletThatIsStoppedByWhatAClientLacksBreaksNoRule(long seed) throws Exception {
    String json =
        """
        {"name": "Rink", "game": "trial", "gravity": [0, 0],
         "bounds": {"min": [-13, -8], "max": [13, 8]},
         "statics": [
          {"at": [0, -8], "shape": {"type": "box", "width": 24, "height": 1},
           "repeat": {"rows": 2, "step": [0, 16]}},
          {"at": [-11.5, 0], "shape": {"type": "box", "width": 1, "height": 16},
           "repeat": {"columns": 2, "step": [23, 0]}}]}
        """;
    BotBrains.add(Chaser::new);
    Level rink = Level.parse("rink.json", json.getBytes(StandardCharsets.UTF_8));
    try {
      GameReport report = GameTest.run(Pucks::new, rink, List.of(Preset.MOBILE), 4, 4, seed);
      assertEquals(List.of(), report.broken(), report.text());
    } finally {
      BotBrains.remove("trial");
    }
  }

  @Test
  void aFieldThatAfterStepWritesAndInputReadsIsNamed() throws Exception {
    assertFinds("afterStep writes player.nitro, which input reads", WritesLate::new);
  }

  @Test
  void aPushInBeforeStepIsNamed() throws Exception {
    assertFinds("beforeStep pushes entity", PushesEarly::new);
  }

  @Test
  void aFieldThatOnlyTheServerKnowsIsNamed() throws Exception {
    assertFinds("player.luck", ReadsSecret::new);
  }

  @Test
  void whatRulesMustNotDoIsNamed() throws Exception {
    assertFinds("player.luck can't be written in Game.rules", RulesWriteSecret::new);
    assertFinds("rules reads player.luck", RulesReadSecret::new);
  }

  @Test
  void anExceptionIsToldWithItsLine() throws Exception {
    assertFinds(
        "afterStep throws java.lang.IllegalStateException: the flag is gone at GameTestTest.java:",
        Throws::new);
  }

  @Test
  void aVariableThatRollbacksDontRestoreIsTold() throws Exception {
    GameReport report = test(Remembers::new);
    String rules = String.join("\n", report.broken());
    assertTrue(rules.contains("after a rollback to tick "), rules);
    assertTrue(rules.contains("goes on otherwise in another process"), rules);
    assertTrue(rules.contains("where entity 0 (disc) has x="), rules);
    assertTrue(
        rules.contains(
            "It writes GameTestTest.Remembers.calls at GameTestTest.Remembers.speed"
                + " (GameTestTest.java:"),
        rules);
  }

  @Test
  void diceThatNoSeedRepeatsAreTold() throws Exception {
    assertFinds("the same seed and the same inputs give another state", RollsDice::new);
    assertFinds(
        "the constructor calls new java.util.Random at GameTestTest.RollsDice", RollsDice::new);
    assertEquals(List.of(), test(LaysOut::new).broken());
    assertFinds("server and clients with the same seed end in another state", RollsDice::new);
  }

  @Test
  void anInputThatDoesOtherwiseOnClientsIsTold() throws Exception {
    assertFinds("otherwise than the server from the same inputs", KnowsItsRole::new);
    assertFinds(" client=", KnowsItsRole::new);
  }

  @Test
  void whatIsTooSeldomForAFindingIsInTheListOfCosts() throws Exception {
    GameReport report = test(HurtsSeldom::new);
    assertEquals(List.of(), report.broken());
    assertTrue(
        report.text().contains("GameTestTest.HurtsSeldom.hurt (GameTestTest.java:"), report.text());
    assertTrue(report.text().contains("), in afterStep"), report.text());
  }

  @Test
  void whatBringsBodiesNearIntoMotionIsInTheListOfCosts() throws Exception {
    String text = test(KicksSeldom::new).text();
    assertTrue(text.contains("others' bodies by GameTestTest.KicksSeldom.kick (Game"), text);
    assertTrue(text.contains("inputs of other players, told after they counted"), text);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "java.lang.System.nanoTime",
        "java.lang.Math.pow",
        "java.lang.Math.random",
        "java.lang.Object.hashCode",
        "java.nio.file.Path.of",
        "java.util.Map.values",
        "the static variable GameTestTest.Calls.shared",
      })
  void whatTheCodeCallsIsTold(String what) throws Exception {
    String rules = String.join("\n", test(Calls::new).broken());
    assertTrue(rules.contains(what + " at GameTestTest.Calls.all (GameTestTest.java:"), rules);
  }

  /** Runs to the right, and holds a button as long as nothing is in the way. */
  public static final class Runner implements BotBrain {
    private static int decisions;
    private static int walls;

    @Override
    public String game() {
      return "trial";
    }

    @Override
    public void decide(Senses senses, Input out) {
      decisions++;
      walls += senses.isWall(3, 0) ? 1 : 0;
      out.move(1, 0).hold(Input.SECOND, true);
    }
  }

  /** Falls over if the bot's keys don't arrive. */
  public static final class WantsSecond extends Good {
    private static final int[] PRESSED = new int[1];

    @Override
    float speed(Simulation s, Player p, Input in) {
      PRESSED[0] += in.held(Input.SECOND) && in.moveX() == 1 ? 1 : 0;
      return 5;
    }
  }

  @Test
  void botsPlayByTheBrainOfTheGame() throws Exception {
    BotBrains.add(Runner::new);
    try {
      GameReport report = test(WantsSecond::new);
      assertEquals(List.of(), report.broken());
      assertTrue(Runner.decisions > 600, "decisions: " + Runner.decisions);
      assertTrue(WantsSecond.PRESSED[0] > 600, "pressed: " + WantsSecond.PRESSED[0]);
      assertEquals(0, Runner.walls, "there are no walls");
    } finally {
      BotBrains.remove("trial");
    }
  }

  @Test
  void theCommandTestsAGameThatShips() {
    StringWriter out = new StringWriter();
    StringWriter err = new StringWriter();
    int code =
        CaromMain.run(
            new PrintWriter(out),
            new PrintWriter(err),
            "test",
            "platformer",
            "--network",
            "wifi",
            "--players",
            "2",
            "--seconds",
            "3",
            "--json");
    assertEquals(0, code, out + "" + err);
    assertTrue(out.toString().contains("\"game\":\"platformer\""), out.toString());
    assertTrue(out.toString().contains("\"broken\":[]"), out.toString());
  }

  @Test
  void theTestThatThePageShowsHolds() {
    try (Stepper world = Stepper.of(ArenaGame::new, "arena")) {
      SimulatedClient ann = world.join("Ann", Preset.MOBILE, new Bot(1));
      world.run(10);
      assertEquals(List.of(), world.findings());
      assertTrue(ann.rightPercent() > 95, world.describe());
    }
  }

  @Test
  void aWrongFlagSaysWhatIsAllowed() {
    for (String[] wrong :
        new String[][] {
          {"--players", "99", "--players=99 is outside 1..64"},
          {
            "--players", "2,3", "--players=2,3 is no whole number; Players who play together, 1..64"
          },
          {"--seconds", "ten", "--seconds=ten is no number; Length of each play"},
          {"--seed", "1.5", "--seed=1.5 is no whole number; Seed of"}
        }) {
      StringWriter err = new StringWriter();
      PrintWriter out = new PrintWriter(new StringWriter());
      int code = CaromMain.run(out, new PrintWriter(err), "test", "arena", wrong[0], wrong[1]);
      assertEquals(2, code);
      assertTrue(err.toString().contains(wrong[2]), err.toString());
    }
  }
}
