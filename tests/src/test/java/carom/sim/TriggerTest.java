package carom.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.fixtures.PlainGame;
import carom.physics.Body;
import carom.physics.BodyType;
import carom.physics.Material;
import carom.physics.archive.ArchiveReader;
import carom.physics.archive.ArchiveWriter;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.sim.entity.Entity;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Level;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;

/**
 * Goal: a game hears once of each entity that enters or leaves a sensor, in every run alike.
 * Method: discs that glide through sensors of a level without gravity; what the game hears, as
 * texts.
 */
class TriggerTest {
  /** Writes down what it hears, and despawns on demand. */
  private static final class Gates extends PlainGame {
    final List<String> log = new ArrayList<>();
    Archetype disc;
    Archetype dumbbell;
    Archetype square;
    Archetype coin;
    boolean takesCoins;
    Entity goes;
    String goesIn = "";
    boolean readsOverlaps;

    Gates() {
      super("gates");
    }

    @Override
    public void setUp(SetUp s) {
      Material skin = new Material(1, 0, 0);
      disc = s.archetype(new ArchetypeDef("disc").shape(new Circle(0.5f), skin));
      square = s.archetype(new ArchetypeDef("square").shape(new Box(0.5f, 0.5f), skin));
      dumbbell =
          s.archetype(
              new ArchetypeDef("dumbbell")
                  .shape(new Circle(0.3f, -0.6f, 0), skin)
                  .shape(new Circle(0.3f, 0.6f, 0), skin));
      coin =
          s.archetype(
              new ArchetypeDef("coin")
                  .type(BodyType.STATIC)
                  .sensor(true)
                  .shape(new Circle(0.3f), skin));
    }

    @Override
    public void join(Match s, Player p) {
      s.spawn(disc, -4, 3, 0, p);
    }

    @Override
    public void entered(Match s, Entity sensor, Entity visitor) {
      note(s, "enters", sensor, visitor);
      if (takesCoins && sensor.archetype() == coin) {
        sensor.despawn();
      }
    }

    @Override
    public void left(Match s, Entity sensor, Entity visitor) {
      note(s, "leaves", sensor, visitor);
    }

    private void note(Match s, String does, Entity sensor, Entity visitor) {
      log.add(s.tick() + " " + visitor.id() + " " + does + " " + sensor.archetype().name());
    }

    @Override
    public void beforeStep(Match s) {
      go("beforeStep");
    }

    @Override
    public void input(Simulation s, Player p, Input in) {
      go("input");
      if (readsOverlaps) {
        p.entity().forEachOverlap(other -> true);
      }
    }

    @Override
    public void afterStep(Match s) {
      go("afterStep");
    }

    private void go(String callback) {
      if (goes != null && callback.equals(goesIn)) {
        goes.despawn();
        goes = null;
      }
    }

    /** What was heard since, without ticks. */
    List<String> heard() {
      List<String> texts = new ArrayList<>();
      log.forEach(line -> texts.add(line.substring(line.indexOf(' ') + 1)));
      log.clear();
      return texts;
    }
  }

  private final Gates game = new Gates();

  /** A gate from 0 to 2, two metres high; beside it a wall that isn't one. */
  private static Level level() throws Exception {
    String json =
        """
        {"name": "Gates", "game": "gates", "gravity": [0, 0],
         "bounds": {"min": [-30, -20], "max": [30, 20]},
         "statics": [
          {"name": "gate", "at": [1, 0], "sensor": true,
           "shape": {"type": "box", "width": 2, "height": 2}},
          {"name": "wall", "at": [9, 0], "shape": {"type": "box", "width": 1, "height": 9}}]}
        """;
    return Level.parse("gates.json", json.getBytes(StandardCharsets.UTF_8));
  }

  private SimulationHost start(Gates of) throws Exception {
    return new SimulationHost(of, level(), 1, 60, Role.AUTHORITY);
  }

  private static HostEntity glide(SimulationHost s, Archetype kind, float x, float speed) {
    HostEntity e = s.spawn(kind, x, 0, 0, null);
    e.body().setVelocity(speed, 0);
    return e;
  }

  private static void run(SimulationHost s, int ticks) {
    for (int i = 0; i < ticks; i++) {
      s.step();
    }
  }

  @Test
  void anEntityThatGlidesThroughEntersAndLeavesOnce() throws Exception {
    SimulationHost s = start(game);
    glide(s, game.disc, -3, 6);
    run(s, 90);
    assertEquals(List.of("0 enters gate", "0 leaves gate"), game.heard());
  }

  @Test
  void aVisitOfSeveralShapesIsOne() throws Exception {
    SimulationHost s = start(game);
    HostEntity e = glide(s, game.dumbbell, -3, 4);
    e.body().setAngularVelocity(3);
    run(s, 120);
    assertEquals(List.of("0 enters gate", "0 leaves gate"), game.heard());
  }

  @Test
  void aBulletThatCrossesAThinSensorInATickIsHeard() throws Exception {
    SimulationHost s = start(game);
    HostEntity coin = s.spawn(game.coin, -6, 0, 0, null);
    HostEntity e = glide(s, game.disc, -9.9f, 300);
    run(s, 6);
    assertTrue(coin.body().isValid());
    assertTrue(e.body().x() > 3, "x=" + e.body().x());
    assertEquals(
        Set.of("1 enters coin", "1 leaves coin", "1 enters gate", "1 leaves gate"),
        new TreeSet<>(game.log.stream().map(line -> line.substring(2)).toList()));
    assertEquals(4, game.log.size());
  }

  @Test
  void whatGoesInAVisitLeavesOnceInTheSameTick() throws Exception {
    for (String callback : List.of("beforeStep", "input", "afterStep")) {
      SimulationHost s = start(game);
      s.join("ann"); // has an input
      HostEntity e = glide(s, game.disc, 1, 0);
      run(s, 5);
      assertEquals(List.of("1 enters gate"), game.heard(), callback);
      game.goes = e;
      game.goesIn = callback;
      s.step();
      assertEquals(List.of(s.tick() + " 1 leaves gate"), game.log, callback);
      assertFalse(e.body().isValid());
      run(s, 5);
      assertEquals(1, game.heard().size(), callback);
    }
  }

  @Test
  void whoGoesBetweenTwoTicksLeavesAtOnce() throws Exception {
    SimulationHost s = start(game);
    HostPlayer ann = s.join("ann");
    HostEntity e = glide(s, game.disc, 0.5f, 0);
    ann.entity().teleport(1.5f, 0.5f, 0);
    s.step();
    assertEquals(2, game.heard().size());
    s.despawn(e);
    assertEquals(List.of("1 leaves gate"), game.heard());
    s.leave(ann);
    assertEquals(List.of("0 leaves gate"), game.heard());
    run(s, 5);
    assertEquals(List.of(), game.heard());
  }

  @Test
  void aCoinThatTheFirstTakesIsNotEnteredByTheSecond() throws Exception {
    SimulationHost s = start(game);
    game.takesCoins = true;
    s.spawn(game.coin, -6, 0, 0, null);
    glide(s, game.disc, -6.6f, 0);
    glide(s, game.disc, -5.4f, 0);
    run(s, 5);
    assertEquals(List.of("1 enters coin", "1 leaves coin"), game.heard());
  }

  @Test
  void whatBecomesAnotherKindLeavesAndEntersAgain() throws Exception {
    SimulationHost s = start(game);
    HostEntity e = glide(s, game.disc, 1, 0);
    s.step();
    assertEquals(List.of("0 enters gate"), game.heard());
    e.become(game.square);
    run(s, 3);
    assertEquals(List.of("0 leaves gate", "0 enters gate"), game.heard());
  }

  @Test
  void whatSleepsInASensorStaysInIt() throws Exception {
    SimulationHost s = start(game);
    HostEntity e = glide(s, game.disc, 1, 0);
    run(s, 200);
    assertFalse(e.body().awake());
    e.body().setVelocity(6, 0);
    run(s, 60);
    assertEquals(List.of("0 enters gate", "0 leaves gate"), game.heard());
  }

  /** Discs and dumbbells come and go through the gate and coins, some despawned within. */
  private static void play(SimulationHost s, Gates of, int fromTick, int toTick) {
    for (int tick = fromTick; tick < toTick; tick++) {
      if (tick % 7 == 0) {
        Archetype kind = tick % 2 == 0 ? of.disc : of.dumbbell;
        HostEntity e = s.spawn(kind, -6, tick % 5 - 2, tick, null);
        e.body().setVelocity(5 + tick % 3, 0.3f * (tick % 4 - 1));
        e.body().setAngularVelocity(tick % 9 - 4);
      }
      if (tick % 31 == 0) {
        s.spawn(of.coin, 1 + tick % 3, tick % 3 - 1, 0, null);
      }
      if (tick % 23 == 22) {
        of.goesIn = tick % 2 == 0 ? "beforeStep" : "afterStep";
        of.goes = s.entity(tick % s.entityCapacity());
      }
      s.step();
    }
  }

  @Test
  void aRestoredOrReadStateGoesOnHearingTheSame() throws Exception {
    SimulationHost s = start(game);
    play(s, game, 0, 150);
    int before = game.log.size();
    SimState saved = s.save(null);
    ArchiveWriter bytes = new ArchiveWriter();
    saved.write(bytes);
    play(s, game, 150, 300);
    List<String> expected = List.copyOf(game.log.subList(before, game.log.size()));
    assertTrue(expected.size() > 30, "events=" + expected.size());
    final long hash = s.stateHash();

    game.log.clear();
    s.restore(saved);
    play(s, game, 150, 300);
    assertEquals(expected, game.log);
    assertEquals(hash, s.stateHash());

    Gates second = new Gates();
    SimulationHost other = start(second);
    other.restore(other.read(new ArchiveReader(bytes.toBytes())));
    play(other, second, 150, 300);
    assertEquals(expected, second.log);
    assertEquals(hash, other.stateHash());
  }

  @Test
  void eachVisitBeginsAndEndsInTurn() throws Exception {
    SimulationHost s = start(game);
    play(s, game, 0, 600);
    List<String> inside = new ArrayList<>();
    for (String line : game.log) {
      // Ids are used again, but by then the one before has left.
      String[] words = line.split(" ");
      String visit = words[1] + " " + words[3];
      if (words[3].equals("coin")) {
        continue; // several have that name
      }
      if (words[2].equals("enters")) {
        assertFalse(inside.contains(visit), line);
        inside.add(visit);
      } else {
        assertTrue(inside.remove(visit), line);
      }
    }
  }

  @Test
  void isInsideSaysWhatEnteredTellsInTheSameTick() throws Exception {
    SimulationHost s = start(game);
    HostEntity e = glide(s, game.dumbbell, -3, 4);
    e.body().setAngularVelocity(3);
    for (int i = 0; i < 120; i++) {
      boolean inside = e.isInside("gate");
      s.step();
      boolean enters = game.log.contains(s.tick() + " 0 enters gate");
      boolean leaves = game.log.contains(s.tick() + " 0 leaves gate");
      assertFalse(enters && !inside, "tick " + s.tick());
      assertFalse(leaves && inside, "tick " + s.tick());
    }
    assertEquals(2, game.log.size());
  }

  @Test
  void aNameThatIsNoSensorOfTheLevelIsRefused() throws Exception {
    SimulationHost s = start(game);
    HostEntity e = glide(s, game.disc, 1, 0);
    for (String name : List.of("wall", "coin", "Gate")) {
      String text =
          assertThrows(IllegalArgumentException.class, () -> e.isInside(name)).getMessage();
      assertEquals(
          "sensor=\""
              + name
              + "\" isn't a static of the level with \"sensor\": true, but these are: [gate]; of"
              + " sensors that move or are spawned, Game.entered and left tell",
          text);
    }
  }

  @Test
  void anInputThatReadsOverlapsWhichClientsLackIsFoundOnce() throws Exception {
    SimulationHost s = start(game);
    HostPlayer ann = s.join("ann");
    game.readsOverlaps = true;
    run(s, 5);
    assertEquals(0, s.findings().count());
    s.spawn(game.coin, -4, 3, 0, null);
    run(s, 5);
    assertEquals(1, s.findings().count());
    assertEquals(
        "input reads overlaps with entity 1 (coin) by Body.forEachOverlap, a sensor that clients"
            + " don't simulate, so they can't predict what follows; use Game.entered and left.",
        s.findings().get(0));
    ann.entity().teleport(1, 0, 0);
    run(s, 5);
    assertEquals(2, s.findings().count());
    assertTrue(s.findings().get(1).contains("ask Simulation.isInside"), s.findings().get(1));
  }

  @Test
  void steadyVisitsAllocateNothingAndChangeNoBit() throws Exception {
    SimulationHost s = start(game);
    SimulationHost silent =
        new SimulationHost(
            new PlainGame("gates") {
              @Override
              public void setUp(SetUp of) {
                game.setUp(of);
              }
            },
            level(),
            1,
            60,
            Role.AUTHORITY);
    for (SimulationHost of : List.of(s, silent)) {
      Body<HostEntity> body = of.spawn(of.archetypes().find("disc"), -3, 0, 0, null).body();
      body.setVelocity(6, 0);
      run(of, 90);
    }
    assertEquals(silent.stateHash(), s.stateHash());
  }
}
