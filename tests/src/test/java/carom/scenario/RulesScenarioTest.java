package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.InputSource;
import carom.fixtures.DrawnTriggers;
import carom.fixtures.PlainGame;
import carom.game.Games;
import carom.net.transport.Impairment;
import carom.physics.Material;
import carom.physics.geometry.Circle;
import carom.physics.math.SimRandom;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.sim.Match;
import carom.sim.Rules;
import carom.sim.SetUp;
import carom.sim.Simulation;
import carom.sim.SimulationHost;
import carom.sim.entity.Entity;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import carom.sim.event.Audience;
import carom.sim.field.Count;
import carom.sim.field.Field;
import carom.sim.field.Flag;
import carom.sim.field.Scope;
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.function.IntFunction;
import org.junit.jupiter.api.Test;

/**
 * Goal: what a player sets off happens on that player's screen in the very tick, by a level's
 * triggers and by a game's rules alike, and where a client can't know, the server's word follows.
 * Method: real server and clients in virtual time; of each tick, what a client predicted first is
 * compared with what the server computed.
 */
final class RulesScenarioTest {
  private static final Flag OPEN = Field.flag("open").of(Scope.MATCH).to(Audience.ALL);
  private static final Count COINS = Field.count("coins", 0, 99);

  private static final Impairment FAR = Impairment.NONE.withLatency(50, 0);

  private static final String LEVEL =
      """
      {"name": "GAME", "game": "GAME", "gravity": [0, 0],
       "bounds": {"min": [-40, -12], "max": [40, 12]},
       "statics": [
         {"name": "plate", "sensor": true, "at": [0, 0],
          "shape": {"type": "box", "width": 30, "height": 4}},
         {"name": "gate", "sensor": true, "at": [0, 8],
          "shape": {"type": "box", "width": 4, "height": 4}}],
       "bodies": [
         {"name": "door", "type": "kinematic", "at": [0, -9],
          "shape": {"type": "box", "width": 3, "height": 1}},
         {"name": "coin", "type": "kinematic", "sensor": true, "at": [-3, 0],
          "shape": {"type": "circle", "radius": 0.4}, "repeat": {"columns": 3, "step": [3, 0]}},
         {"name": "gem", "type": "kinematic", "sensor": true, "at": [-12, 5],
          "shape": {"type": "circle", "radius": 0.4}}],
       "triggers": [TRIGGERS]}
      """;

  private static final String DOOR =
      """
      {"when": {"inside": "plate", "who": "player"},
       "do": [{"move": "door", "to": [5, -9], "seconds": 0.5}, {"set": "match.open", "to": true}],
       "else": [{"move": "door", "to": [0, -9], "seconds": 0.5}, {"set": "match.open", "to": false}]},
      {"when": {"enter": "gate", "who": "player"},
       "do": [{"impulse": [0, -6]}, {"add": "player.coins", "by": 10}]},
      {"when": {"enter": "gem", "who": "player"},
       "do": [{"remove": "gem"}, {"add": "player.coins", "by": 1}]}
      """;

  /** Discs that fly as their players say. */
  private static class Yard extends PlainGame {
    private Archetype disc;

    Yard(String name) {
      super(name);
    }

    @Override
    public List<Field<?>> fields() {
      return List.of(OPEN, COINS);
    }

    @Override
    public void setUp(SetUp s) {
      disc =
          s.archetype(new ArchetypeDef("disc").shape(new Circle(0.5f), new Material(1, 0, 0.5f)));
    }

    @Override
    public void join(Match m, Player p) {
      m.spawn(disc, p.id() == 0 ? -12 : 12, 5 + p.id(), 0, p);
    }

    @Override
    public void input(Simulation s, Player p, Input in) {
      p.entity().seekVelocity(in.moveX() * 6, in.moveY() * 6, 8);
    }
  }

  /** Does in code what {@link #DOOR} does by triggers, but for the gate. */
  private static final class Coded extends Yard {
    Coded() {
      super("coded");
    }

    @Override
    public Consumer<Rules> rules(Level level) {
      return Coded::open;
    }

    private static void open(Rules r) {
      boolean pressed = r.playersInside("plate") > 0;
      if (pressed != r.get(OPEN)) {
        r.set(OPEN, pressed);
        r.move("door", pressed ? 5 : 0, -9, 0.5f);
      }
      for (Entity e : r.entities()) {
        if (e.archetype().name().equals("coin")) {
          take(e);
        }
      }
    }

    private static void take(Entity coin) {
      Player[] by = new Player[1];
      coin.forEachOverlap(
          visitor -> {
            by[0] = visitor.owner();
            return by[0] == null;
          });
      if (by[0] != null) {
        by[0].add(COINS, 1);
        coin.despawn();
      }
    }
  }

  private static Level level(String game, String triggers) throws LevelException {
    String json = LEVEL.replace("GAME", game).replace("TRIGGERS", triggers);
    return Level.parse("t.json", json.getBytes(StandardCharsets.UTF_8));
  }

  private static Stepper triggers() throws LevelException {
    Games.add(() -> new Yard("yard"));
    return Stepper.of(level("yard", DOOR), ServerConfig.defaults());
  }

  private static Stepper code() throws LevelException {
    Games.add(Coded::new);
    return Stepper.of(level("coded", ""), ServerConfig.defaults());
  }

  /** Steers by the tick. */
  private static InputSource by(IntFunction<float[]> way) {
    return (view, tick, out) -> {
      float[] move = way.apply(tick);
      out.move(move[0], move[1]);
    };
  }

  /** What one side had after each tick. */
  private static final class History {
    final Map<Integer, String> states = new TreeMap<>();
    final Map<Integer, Float> doors = new TreeMap<>();

    /** Notes the present tick, if it is a new one. */
    void note(SimulationHost s, SimulationHost schema) {
      HostDoor door = HostDoor.of(s);
      if (s.tick() > 0 && !doors.containsKey(s.tick()) && door != null) {
        doors.put(s.tick(), door.x);
        StringBuilder words = new StringBuilder();
        for (int i = 0; i < schema.schema().toldWords(Scope.MATCH); i++) {
          words.append(' ').append(s.fieldValues().word(i));
        }
        states.put(s.tick(), door.x + words.toString());
      }
    }

    /** Returns the first tick in which the door was elsewhere. */
    int firstMotion() {
      float before = Float.NaN;
      for (Map.Entry<Integer, Float> e : doors.entrySet()) {
        if (!Float.isNaN(before) && e.getValue() != before) {
          return e.getKey();
        }
        before = e.getValue();
      }
      return -1;
    }

    /** Returns how many different states there were from a tick on. */
    long statesFrom(int tick) {
      return states.entrySet().stream()
          .filter(e -> e.getKey() >= tick)
          .map(Map.Entry::getValue)
          .distinct()
          .count();
    }

    int different(History other, int from) {
      int n = 0;
      for (Map.Entry<Integer, String> e : states.entrySet()) {
        String theirs = other.states.get(e.getKey());
        n += e.getKey() >= from && theirs != null && !theirs.equals(e.getValue()) ? 1 : 0;
      }
      return n;
    }
  }

  private record HostDoor(float x) {
    static HostDoor of(SimulationHost s) {
      return s == null || s.entity(0) == null ? null : new HostDoor(s.entity(0).x());
    }
  }

  /** A match with records of all sides. */
  private static final class Play {
    final Stepper world;
    final History server = new History();
    final Map<SimulatedClient, History> clients = new LinkedHashMap<>();

    Play(Stepper world) {
      this.world = world;
    }

    SimulatedClient join(String name, Impairment network, InputSource way) {
      SimulatedClient client = world.add(name, network.withSeed(Stepper.SEED), way);
      world.awaitPlaying(client);
      clients.put(client, new History());
      return client;
    }

    void run(double seconds) {
      long endNs = world.nowNs() + (long) (seconds * 1e9);
      while (world.nowNs() - endNs < 0) {
        world.step();
        SimulationHost truth = world.room().simulation();
        server.note(truth, truth);
        clients.forEach((client, record) -> note(client, record, truth));
      }
    }

    private static void note(SimulatedClient client, History record, SimulationHost truth) {
      SimulationHost predicted = client.view().predictedWorld();
      if (predicted != null) {
        record.note(predicted, truth);
      }
    }

    History of(SimulatedClient client) {
      return clients.get(client);
    }
  }

  /** Waits, goes down onto the plate, stays, and goes back. */
  private static InputSource visit(int begin, int back) {
    return by(
        tick -> {
          int t = tick - begin;
          return new float[] {0, t < 0 ? 0 : t < 70 ? -1 : t < back ? 0 : t < back + 70 ? 1 : 0};
        });
  }

  private static void playAlone(Stepper stepper, String what) {
    try (Stepper world = stepper) {
      Play play = new Play(world);
      SimulatedClient ann = play.join("Ann", FAR, InputSource.IDLE);
      play.run(2);
      final long corrections = ann.corrections();
      final int now = world.room().simulation().tick();
      ann.play(visit(now + 30, 160));
      play.run(6);
      int served = play.server.firstMotion();
      assertTrue(served > now, what + ": the server's door never moved");
      assertEquals(served, play.of(ann).firstMotion(), what + ": first motion");
      assertEquals(0, play.of(ann).different(play.server, now), what + ": ticks predicted wrongly");
      assertEquals(corrections, ann.corrections(), what + ": corrections");
      assertEquals(0, world.room().simulation().entity(0).x(), 1e-4f, what + ": closed again");
      assertEquals(0, world.count(Counter.DIVERGENCES_UNEXPLAINED), world.describe());
    }
  }

  @Test
  void theDoorMovesInTheTickInWhichThePlayerStepsOnThePlate() throws Exception {
    playAlone(triggers(), "triggers");
    playAlone(code(), "code");
  }

  /** Goes to the left end of the plate, then along it over the coins. */
  private static InputSource collect(int begin) {
    return by(
        tick -> {
          int t = tick - begin;
          return new float[] {t < 60 || t > 260 ? 0 : 1, t < 0 || t >= 50 ? 0 : -1};
        });
  }

  private static void collectAlone(Stepper stepper, String name, int most) {
    try (Stepper world = stepper) {
      Play play = new Play(world);
      SimulatedClient ann = play.join("Ann", FAR, InputSource.IDLE);
      play.run(2);
      int now = world.room().simulation().tick();
      ann.play(collect(now + 30));
      Map<Integer, Integer> served = new TreeMap<>();
      Map<Integer, Integer> predicted = new TreeMap<>();
      while (world.room().simulation().tick() < now + 360) {
        world.step();
        note(served, world.room().simulation());
        note(predicted, ann.view().predictedWorld());
      }
      int different = 0;
      for (Map.Entry<Integer, Integer> e : served.entrySet()) {
        Integer theirs = predicted.get(e.getKey());
        different += e.getKey() > now && theirs != null && !theirs.equals(e.getValue()) ? 1 : 0;
      }
      assertEquals(0, different, name + ": ticks with other coins");
      assertEquals(most, served.get(world.room().simulation().tick()), name);
      for (int id = 1; id <= 3; id++) {
        assertNull(world.room().simulation().entity(id), name);
        assertNull(ann.view().find(id), name + ": drawn although it is gone");
      }
      assertEquals(0, world.count(Counter.DIVERGENCES_UNEXPLAINED), world.describe());
    }
  }

  /** Notes the coins of player 0 after the present tick, if that is a new one. */
  private static void note(Map<Integer, Integer> coins, SimulationHost s) {
    if (s != null && s.player(0) != null) {
      coins.putIfAbsent(s.tick(), s.player(0).get(COINS));
    }
  }

  @Test
  void aPickUpIsGoneInTheTickInWhichItIsTouched() throws Exception {
    collectAlone(code(), "code", 3);
    String coins =
        """
        {"when": {"enter": "coin", "who": "player"}, "do": {"add": "player.coins", "by": 1}}
        """;
    Games.add(() -> new Yard("yard"));
    try (Stepper world = Stepper.of(level("yard", coins), ServerConfig.defaults())) {
      Play play = new Play(world);
      SimulatedClient ann = play.join("Ann", FAR, InputSource.IDLE);
      play.run(2);
      int now = world.room().simulation().tick();
      ann.play(collect(now + 30));
      play.run(5);
      assertEquals(3, world.player(ann).get(COINS), "each time a coin is entered");
      assertEquals(3, ann.view().predictedWorld().player(0).get(COINS));
      assertEquals(0, play.of(ann).different(play.server, now));
    }
  }

  private static void playTogether(Stepper stepper, String what) {
    try (Stepper world = stepper) {
      Play play = new Play(world);
      SimulatedClient ann = play.join("Ann", FAR, InputSource.IDLE);
      SimulatedClient bob = play.join("Bob", FAR, InputSource.IDLE);
      play.run(2);
      final int now = world.room().simulation().tick();
      ann.play(visit(now + 30, 160)); // leaves while Bob, who is far away, stays
      bob.play(visit(now + 80, 300));
      play.run(10);
      int served = play.server.firstMotion();
      assertEquals(served, play.of(ann).firstMotion(), what);
      assertEquals(0, play.of(ann).different(play.server, now) / 20, what + ": Ann's are few");
      assertTrue(play.of(bob).firstMotion() > served, what + ": Bob can't know");
      assertTrue(play.of(bob).different(play.server, now) < 40, what + ": Bob learns it");
      int end = world.room().simulation().tick();
      assertEquals(0, play.of(ann).different(play.server, end - 60), what);
      assertEquals(0, play.of(bob).different(play.server, end - 60), what);
      assertEquals(0, world.count(Counter.DIVERGENCES_UNEXPLAINED), world.describe());
    }
  }

  @Test
  void twoOnOnePlateFarFromEachOtherAgree() throws Exception {
    playTogether(triggers(), "triggers");
    playTogether(code(), "code");
  }

  /** Comes and goes, a little above the edge of the plate. */
  private static InputSource dither(long seed) {
    SimRandom random = new SimRandom(seed);
    float[] way = new float[2];
    return (view, tick, out) -> {
      if (random.nextInt(12) == 0) {
        float y = view.own() == null ? 4 : view.own().y();
        way[1] = y > 4 ? -1 : y < 2.2f ? 1 : random.nextInt(3) - 1;
      }
      out.move(0, way[1]);
    };
  }

  private static void playBeside(Stepper stepper, Impairment network, String what) {
    try (Stepper world = stepper) {
      Play play = new Play(world);
      SimulatedClient ann = play.join("Ann", network, InputSource.IDLE);
      SimulatedClient bob = play.join("Bob", network, InputSource.IDLE);
      world.body(ann).teleport(-12, 6, 0);
      world.body(bob).teleport(-10, 4, 0);
      play.run(2);
      final int now = world.room().simulation().tick();
      bob.play(dither(Stepper.SEED));
      play.run(15);
      bob.play(InputSource.IDLE);
      play.run(3);
      int end = world.room().simulation().tick();
      assertTrue(play.of(ann).different(play.server, now) > 0, what + ": never wrong, a poor test");
      assertEquals(0, play.of(ann).different(play.server, end - 60), what + ": Ann");
      assertEquals(0, play.of(bob).different(play.server, end - 60), what + ": Bob");
      assertEquals(0, world.count(Counter.DIVERGENCES_UNEXPLAINED), world.describe());
    }
  }

  @Test
  void whereAnInputLackedTheServersWordIsTheLast() throws Exception {
    playBeside(triggers(), FAR, "triggers");
    playBeside(code(), FAR, "code");
  }

  @Test
  void lossOfDatagramsCostsAgreementForAMomentOnly() throws Exception {
    Impairment bad = Impairment.NONE.withLatency(50, 10).withLoss(10);
    playBeside(triggers(), bad, "triggers");
    playBeside(code(), bad, "code");
  }

  // ---- levels that are drawn

  private static final Count LAMPS = Field.count("lamps", 0, 9).of(Scope.MATCH);

  /** Has what drawn triggers name. */
  private static final class Drawn extends Yard {
    Drawn() {
      super("drawn");
    }

    @Override
    public List<Field<?>> fields() {
      return List.of(OPEN, COINS, LAMPS);
    }

    @Override
    public void setUp(SetUp s) {
      super.setUp(s);
      s.event("bell", 0xffffff, 1, "");
    }
  }

  private static final String DRAWN =
      """
      {"name": "drawn", "game": "drawn", "gravity": [0, 0],
       "bounds": {"min": [-40, -12], "max": [40, 12]},
       "statics": [
         {"name": "plate", "sensor": true, "at": [0, 4],
          "shape": {"type": "box", "width": 16, "height": 4}},
         {"name": "wall", "at": [0, -3], "shape": {"type": "box", "width": 9, "height": 1}}],
       "bodies": [
         {"name": "ball", "at": [-9, 4], "linearDamping": 3,
          "shape": {"type": "circle", "radius": 0.5}},
         {"name": "door", "type": "kinematic", "at": [3, 0],
          "shape": {"type": "box", "width": 1, "height": 2}},
         {"name": "crate", "at": [6, 5], "linearDamping": 3, "angularDamping": 3,
          "shape": {"type": "box", "width": 1, "height": 1}}],
       "triggers": [TRIGGERS]}
      """;

  private static final int MOST_ENTITIES = 60;

  /** Counts the drawn levels that came to rest, so that there was something to compare. */
  private static int judged;

  /** Moves about, and comes back to the middle. */
  private static InputSource roam(long seed) {
    SimRandom random = new SimRandom(seed);
    float[] way = new float[2];
    return (view, tick, out) -> {
      if (random.nextInt(25) == 0 && view.own() != null) {
        float x = view.own().x();
        float y = view.own().y();
        way[0] = Math.abs(x) > 10 ? -Math.signum(x) : random.nextInt(3) - 1;
        way[1] = Math.abs(y - 4) > 4 ? Math.signum(4 - y) : random.nextInt(3) - 1;
      }
      out.move(way[0], way[1]);
    };
  }

  /** Plays a level, and returns what is wrong at the end, when all has come to rest, or null. */
  private static String play(List<String> triggers, long seed) throws LevelException {
    Games.add(Drawn::new);
    String json = DRAWN.replace("TRIGGERS", String.join(", ", triggers));
    Level level = Level.parse("drawn.json", json.getBytes(StandardCharsets.UTF_8));
    try (Stepper world = Stepper.of(level, ServerConfig.defaults())) {
      Play play = new Play(world);
      Impairment network = Impairment.NONE.withLatency(50, 5).withLoss(3);
      SimulatedClient ann = play.join("Ann", network, roam(seed));
      SimulatedClient bob = play.join("Bob", network, roam(seed + 1));
      for (int i = 0; i < 20; i++) {
        if (i == 12) {
          ann.play(InputSource.IDLE);
          bob.play(InputSource.IDLE);
        }
        play.run(0.5);
        if (world.room().simulation().entityCount() > MOST_ENTITIES) {
          return null; // a trigger that spawns sets itself off: nothing comes to rest
        }
      }
      int end = world.room().simulation().tick();
      if (play.server.statesFrom(end - 60) > 1) {
        return null; // something goes on, and who is far away hears of it later
      }
      judged++;
      int wrong = play.of(ann).different(play.server, end - 20);
      wrong += play.of(bob).different(play.server, end - 20);
      long unexplained = world.count(Counter.DIVERGENCES_UNEXPLAINED);
      boolean isRight = wrong == 0 && unexplained == 0;
      return isRight ? null : wrong + " ticks are wrong, unexplained=" + unexplained;
    }
  }

  /** Leaves out triggers as long as something is wrong. */
  private static String shrunk(List<String> triggers, long seed) throws LevelException {
    for (int i = 0; i < triggers.size() && triggers.size() > 1; i++) {
      List<String> fewer = new ArrayList<>(triggers);
      fewer.remove(i);
      if (play(fewer, seed) != null) {
        return shrunk(fewer, seed);
      }
    }
    return String.join(",\n", triggers);
  }

  @Test
  void serverAndClientsAgreeOnDrawnLevels() throws Exception {
    int levels = Integer.getInteger("carom.rules.levels", 8);
    judged = 0;
    for (int i = 0; i < levels; i++) {
      long seed = Stepper.SEED + i;
      List<String> triggers = new DrawnTriggers(seed).each();
      String wrong = play(triggers, seed);
      if (wrong != null) {
        throw new AssertionError("seed=" + seed + ": " + wrong + "\n" + shrunk(triggers, seed));
      }
    }
    assertTrue(judged > levels / 4, "judged=" + judged + " of " + levels);
  }
}
