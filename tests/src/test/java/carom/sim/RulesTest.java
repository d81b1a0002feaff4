package carom.sim;

import static carom.sim.field.Scope.MATCH;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.fixtures.PlainGame;
import carom.game.GuardedGame;
import carom.physics.Material;
import carom.physics.geometry.Circle;
import carom.sim.entity.Entity;
import carom.sim.entity.Player;
import carom.sim.event.Audience;
import carom.sim.field.Count;
import carom.sim.field.Field;
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Level;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;

/**
 * Goal: {@link Game#rules} does what {@link Rules} says, alike after a restore, and what a client
 * couldn't do is refused by name or found. Method: rules as lambdas on a level with two plates and
 * two doors.
 */
final class RulesTest {
  private static final Count KNOWN = Field.count("known", 0, 99).of(MATCH).to(Audience.ALL);
  private static final Count SECRET = Field.count("secret", 0, 99).of(MATCH).to(Audience.NOBODY);
  private static final Count AMMO = Field.count("ammo", 0, 99).to(Audience.OWNER);
  private static final Count HEALTH = Field.count("health", 0, 99).startsAt(50);

  private static final String LEVEL =
      """
      {"name": "rules", "game": "rules", "gravity": [0, 0],
       "bounds": {"min": [-20, -12], "max": [20, 12]},
       "statics": [
         {"name": "plate", "sensor": true, "at": [0, 0],
          "shape": {"type": "box", "width": 4, "height": 4}},
         {"name": "wall", "at": [9, 0], "shape": {"type": "box", "width": 1, "height": 9}}],
       "bodies": [
         {"name": "door", "type": "kinematic", "at": [0, 8],
          "shape": {"type": "box", "width": 1, "height": 1}},
         {"name": "ball", "at": [1, 0], "shape": {"type": "circle", "radius": 0.5}},
         {"name": "twin", "type": "kinematic", "at": [9, 9],
          "shape": {"type": "box", "width": 1, "height": 1},
          "repeat": {"columns": 2, "step": [2, 0]}}]}
      """;

  /** A game whose rules are given. */
  private static final class Given extends PlainGame {
    private final Consumer<Rules> rules;
    private Consumer<Match> afterStep = m -> {};
    private Archetype disc;

    Given(Consumer<Rules> rules) {
      super("rules");
      this.rules = rules;
    }

    @Override
    public List<Field<?>> fields() {
      return List.of(KNOWN, SECRET, AMMO, HEALTH);
    }

    @Override
    public void setUp(SetUp s) {
      disc =
          s.archetype(new ArchetypeDef("disc").shape(new Circle(0.5f), new Material(1, 0, 0.5f)));
    }

    @Override
    public void join(Match m, Player p) {
      m.spawn(disc, -1, 0, 0, p);
    }

    @Override
    public Consumer<Rules> rules(Level level) {
      return r -> rules.accept(r);
    }

    @Override
    public void afterStep(Match m) {
      afterStep.accept(m);
    }
  }

  private static SimulationHost start(Game game) throws Exception {
    Level level = Level.parse("t.json", LEVEL.getBytes(StandardCharsets.UTF_8));
    SimulationHost s = new SimulationHost(game, level, 7, 60, Role.AUTHORITY);
    s.join("Ann");
    return s;
  }

  private static SimulationHost start(Consumer<Rules> rules) throws Exception {
    return start(new Given(rules));
  }

  private static void run(SimulationHost s, int ticks) {
    for (int i = 0; i < ticks; i++) {
      s.step();
    }
  }

  @Test
  void whatIsInASensorIsCounted() throws Exception {
    List<String> seen = new ArrayList<>();
    SimulationHost s =
        start(
            r -> {
              seen.add(r.countInside("plate") + " " + r.playersInside("plate"));
              r.forEachInside("plate", e -> r.add(KNOWN, e.isOwned() ? 1 : 10));
            });
    run(s, 3);
    assertEquals(List.of("0 0", "2 1", "2 1"), seen, "of the step before");
    assertEquals(22, s.get(KNOWN));
    s.entity(1).teleport(6, 0, 0);
    run(s, 2);
    assertEquals("1 1", seen.get(4));
  }

  @Test
  void aBodyIsMovedFromTheNextTickOn() throws Exception {
    SimulationHost s =
        start(
            r -> {
              if (r.tick() == 10) {
                r.move("door", 3, 8, 0.5f);
              }
            });
    run(s, 10);
    assertEquals(0, s.entity(0).x());
    run(s, 1);
    assertEquals(0.1f, s.entity(0).x(), 1e-6f);
    run(s, 29);
    assertEquals(3, s.entity(0).x(), 1e-6f);
    run(s, 5);
    assertEquals(3, s.entity(0).x(), 1e-6f);
    assertEquals(0, s.entity(0).velocityX());
  }

  @Test
  void whatBelongsToNobodyIsTakenAway() throws Exception {
    SimulationHost s =
        start(
            r -> {
              for (var e : r.entities()) {
                if (e.archetype().name().equals("ball") && r.tick() == 2) {
                  e.despawn();
                }
              }
            });
    run(s, 2);
    assertNull(s.entity(1));
  }

  @Test
  void aRestoredMatchGoesOnAlike() throws Exception {
    SimulationHost s =
        start(
            r -> {
              if (r.tick() % 40 == 7) {
                r.move("door", r.tick() % 9, 8, 0.3f);
              }
              r.add(KNOWN, r.countInside("plate") > 1 ? 1 : -1);
            });
    run(s, 50);
    SimState state = s.save(null);
    run(s, 60);
    long hash = s.stateHash();
    s.restore(state);
    run(s, 60);
    assertEquals(hash, s.stateHash());
  }

  private static String refused(Consumer<Rules> rules) throws Exception {
    SimulationHost s = start(rules);
    return assertThrows(RuntimeException.class, s::step).getMessage();
  }

  private static String refusedLater(Consumer<Rules> rules) throws Exception {
    SimulationHost s = start(rules);
    s.step(); // what is in a sensor shows in the step after
    return assertThrows(RuntimeException.class, s::step).getMessage();
  }

  private static void ammo(Player p) {
    if (p != null) {
      p.set(AMMO, 1);
    }
  }

  private static void each(Rules r, Consumer<Entity> call) {
    r.entities().forEach(call);
  }

  @Test
  void whatAClientCannotDoIsRefusedByName() throws Exception {
    String field = refused(r -> r.set(SECRET, 3));
    assertTrue(field.startsWith("match.secret can't be written in Game.rules"), field);
    String ammo = refusedLater(r -> r.forEachInside("plate", e -> ammo(e.owner())));
    assertTrue(ammo.startsWith("player.ammo can't be written in Game.rules"), ammo);
    String push = refused(r -> each(r, e -> e.applyImpulse(1, 0)));
    assertTrue(push.contains("Game.rules, which clients run, too"), push);
    String place = refused(r -> each(r, e -> e.teleport(1, 0, 0)));
    assertTrue(place.startsWith("a change of door"), place);
    String mine =
        refused(
            r ->
                each(
                    r,
                    e -> {
                      if (e.isOwned()) {
                        e.despawn();
                      }
                    }));
    assertTrue(mine.startsWith("despawn of disc"), mine);
    assertTrue(refused(r -> r.move("gate", 0, 0, 1)).startsWith("body=\"gate\" isn't one"));
    assertTrue(refused(r -> r.move("ball", 0, 0, 1)).startsWith("body=\"ball\" isn't one"));
    assertTrue(refused(r -> r.move("twin", 0, 0, 1)).startsWith("body=\"twin\" is the name of"));
    assertTrue(refused(r -> r.countInside("wall")).startsWith("sensor=\"wall\" isn't a static"));
    String spawn = refused(r -> ((Match) r).spawn(r.archetype("ball"), 0, 0));
    assertTrue(spawn.startsWith("spawn can't be called in Game.rules"), spawn);
  }

  @Test
  void whatTheRulesReadButClientsDoNotKnowIsFound() throws Exception {
    SimulationHost s = start(r -> r.add(KNOWN, r.get(SECRET)));
    run(s, 20);
    String found = s.findings().toString();
    assertTrue(found.contains("rules reads match.secret"), found);
  }

  @Test
  void aFieldThatRulesReadAndOtherRulesWriteIsFound() throws Exception {
    Given game = new Given(r -> r.add(KNOWN, 0));
    game.afterStep = m -> m.set(KNOWN, m.tick() % 9);
    SimulationHost s = start(game);
    run(s, 300);
    String found = s.findings().toString();
    assertTrue(found.contains("afterStep writes match.known, which rules reads"), found);
  }

  @Test
  void aGuardedGameHasTheRulesOfItsGame() {
    assertNotNull(new GuardedGame(new Given(r -> {}), (callback, s, e) -> {}).rules(null));
    assertNull(new GuardedGame(new PlainGame("plain"), (callback, s, e) -> {}).rules(null));
  }
}
