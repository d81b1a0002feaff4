package carom.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.fixtures.DrawnTriggers;
import carom.fixtures.PlainGame;
import carom.physics.Material;
import carom.physics.archive.ArchiveReader;
import carom.physics.archive.ArchiveWriter;
import carom.physics.geometry.Circle;
import carom.sim.entity.Player;
import carom.sim.field.Count;
import carom.sim.field.Field;
import carom.sim.field.Flag;
import carom.sim.field.Scope;
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import carom.sim.outbox.Event;
import carom.text.Json;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;

/**
 * Goal: a level's triggers do what the file says, in every run alike, also from a saved state on.
 * Method: a level without gravity with a plate, a door and a ball that comes by; then triggers that
 * are drawn at random.
 */
final class LevelTriggerTest {
  private static final Count LAMPS = Field.count("lamps", 0, 9).of(Scope.MATCH);
  private static final Flag OPEN = Field.flag("open").of(Scope.MATCH);
  private static final Count HEALTH = Field.count("health", 0, 100).startsAt(100);

  /** A game that has fields, an event and a disc for each player. */
  private static final class Yard extends PlainGame {
    Archetype disc;

    Yard() {
      super("yard");
    }

    @Override
    public List<Field<?>> fields() {
      return List.of(LAMPS, OPEN, HEALTH);
    }

    @Override
    public void setUp(SetUp s) {
      disc =
          s.archetype(new ArchetypeDef("disc").shape(new Circle(0.5f), new Material(1, 0, 0.5f)));
      s.event("bell", 0xffffff, 1, "");
    }

    @Override
    public void join(Match s, Player p) {
      s.spawn(disc, -4, 3, 0, p);
    }
  }

  private static final String LEVEL =
      """
      {"name": "yard", "game": "yard", "gravity": [0, 0],
       "bounds": {"min": [-20, -12], "max": [20, 12]},
       "statics": [
         {"name": "plate", "sensor": true, "at": [0, 0],
          "shape": {"type": "box", "width": 2, "height": 2}},
         {"name": "wall", "at": [6, 0], "shape": {"type": "box", "width": 1, "height": 20}}],
       "bodies": [
         {"name": "ball", "at": [-4, 0], "shape": {"type": "circle", "radius": 0.5},
          "material": {"restitution": 1}},
         {"name": "door", "type": "kinematic", "at": [9, 0],
          "shape": {"type": "box", "width": 1, "height": 2}},
         {"name": "crate", "at": [12, 5], "shape": {"type": "box", "width": 1, "height": 1}}],
       "triggers": [%s]}
      """;

  private static Level level(String triggers) throws LevelException {
    return Level.parse(
        "t.json", String.format(Locale.ROOT, LEVEL, triggers).getBytes(StandardCharsets.UTF_8));
  }

  private static SimulationHost start(String triggers) throws LevelException {
    return new SimulationHost(new Yard(), level(triggers), 7, 60, Role.AUTHORITY);
  }

  /** Starts a match whose ball flies to the right: in at tick 38 or so, out at 98, back later. */
  private static SimulationHost flying(String triggers) throws LevelException {
    SimulationHost s = start(triggers);
    s.entity(0).setVelocity(4, 0);
    return s;
  }

  private static void run(SimulationHost s, int ticks) {
    for (int i = 0; i < ticks; i++) {
      s.step();
    }
  }

  @Test
  void aDoorOpensWhileThePlateIsPressedAndCloses() throws Exception {
    SimulationHost s =
        flying(
            """
            {"when": {"inside": "plate"}, "do": {"move": "door", "to": [9, 3], "seconds": 0.5},
             "else": {"move": "door", "to": [9, 0], "seconds": 0.5}}
            """);
    run(s, 30);
    assertEquals(0, s.entity(1).y());
    run(s, 25);
    assertTrue(s.entity(1).y() > 0.5f && s.entity(1).y() < 3, "on its way, y=" + s.entity(1).y());
    run(s, 25);
    assertEquals(3, s.entity(1).y(), 1e-5f);
    assertEquals(0, s.entity(1).velocityY());
    run(s, 60);
    assertEquals(0, s.entity(1).y(), 1e-5f);
    assertEquals(9, s.entity(1).x());
  }

  @Test
  void eachConditionHolds() throws Exception {
    assertEquals(1, lampsAfter(60, "{\"when\": {\"enter\": \"plate\"}"));
    assertEquals(0, lampsAfter(60, "{\"when\": {\"enter\": \"plate\", \"who\": \"player\"}"));
    assertEquals(1, lampsAfter(60, "{\"when\": {\"enter\": \"plate\", \"who\": \"body\"}"));
    assertEquals(0, lampsAfter(60, "{\"when\": {\"leave\": \"plate\"}"));
    assertEquals(1, lampsAfter(100, "{\"when\": {\"leave\": \"plate\"}"));
    assertEquals(2, lampsAfter(240, "{\"when\": {\"enter\": \"plate\"}"), "there and back");
    assertEquals(1, lampsAfter(240, "{\"once\": true, \"when\": {\"enter\": \"plate\"}"));
    assertEquals(1, lampsAfter(60, "{\"when\": {\"inside\": \"plate\"}"));
    assertEquals(0, lampsAfter(60, "{\"when\": {\"inside\": \"plate\", \"least\": 2}"));
    assertEquals(1, lampsAfter(160, "{\"when\": {\"hit\": \"wall\", \"impulse\": 1}"));
    assertEquals(0, lampsAfter(160, "{\"when\": {\"hit\": \"wall\", \"impulse\": 100}"));
    assertEquals(1, lampsAfter(160, "{\"when\": {\"hit\": \"ball\"}"));
    assertEquals(0, lampsAfter(29, "{\"when\": {\"timer\": 0.5}"));
    assertEquals(1, lampsAfter(31, "{\"when\": {\"timer\": 0.5}"));
    assertEquals(3, lampsAfter(92, "{\"every\": 0.5, \"when\": {\"timer\": 0.5}"));
    assertEquals(0, lampsAfter(60, "{\"after\": 1, \"when\": {\"enter\": \"plate\"}"));
    assertEquals(1, lampsAfter(120, "{\"after\": 1, \"when\": {\"enter\": \"plate\"}"));
    assertEquals(0, lampsAfter(60, "{\"enabled\": false, \"when\": {\"enter\": \"plate\"}"));
    assertEquals(
        1, lampsAfter(60, "{\"when\": {\"all\": [{\"enter\": \"plate\"}, {\"timer\": 0.1}]}"));
    assertEquals(
        0, lampsAfter(60, "{\"when\": {\"all\": [{\"enter\": \"plate\"}, {\"timer\": 5}]}"));
    assertEquals(
        1, lampsAfter(60, "{\"when\": {\"any\": [{\"inside\": \"plate\"}, {\"timer\": 5}]}"));
    assertEquals(
        2, lampsAfter(9, "{\"when\": {\"field\": \"match.lamps\", \"most\": 1}, \"every\": 0.1"));
    assertEquals(0, lampsAfter(9, "{\"when\": {\"score\": 1}"));
  }

  /** Returns how often a trigger lit a lamp in so many ticks. */
  private static int lampsAfter(int ticks, String trigger) throws LevelException {
    SimulationHost s = flying(trigger + ", \"do\": {\"add\": \"match.lamps\", \"by\": 1}}");
    run(s, ticks);
    return s.get(LAMPS);
  }

  @Test
  void eachActionActs() throws Exception {
    SimulationHost s =
        flying(
            """
            {"when": {"enter": "plate"}, "do": [
              {"set": "match.open", "to": true}, {"set": "match.lamps", "to": 4},
              {"notice": "Somebody is in."}, {"event": "bell"}, {"event": "bell", "at": [1, 2]},
              {"spawn": "crate", "at": [-9, 9]}, {"spawn": "disc", "at": [-9, 5]},
              {"impulse": [0, 5], "on": "crate"}, {"remove": "door"}, {"disable": "late"},
              {"enable": "asleep"}, {"teleport": [-9, -9]}]},
            {"name": "late", "when": {"timer": 1.5}, "do": {"add": "match.lamps", "by": 1}},
            {"name": "asleep", "enabled": false, "when": {"timer": 1.5},
             "do": {"add": "match.lamps", "by": 2}},
            {"when": {"timer": 2}, "do": {"next": "arena"}}
            """);
    int before = s.entityCount();
    run(s, 60);
    assertTrue(s.get(OPEN));
    assertEquals(4, s.get(LAMPS));
    assertNull(s.entity(1));
    assertEquals(before + 1, s.entityCount(), "two came and the door went");
    assertTrue(s.entity(2).velocityY() > 1);
    assertEquals(-9, s.entity(0).y(), 0.01f);
    run(s, 60);
    assertEquals(6, s.get(LAMPS), "one trigger was switched off, the other on");
  }

  @Test
  void triggersThatSpawnForEverFillNoWorld() throws Exception {
    SimulationHost s =
        flying(
            """
            {"when": {"timer": 0.1}, "every": 0.0625, "do": [
              {"spawn": "crate", "at": [-9, 9]}, {"spawn": "crate", "at": [-6, 9]},
              {"spawn": "disc", "at": [-9, 5]}, {"spawn": "disc", "at": [-6, 5]}]}
            """);
    int most = s.level().bodies().size() + LevelRules.MAX_SPAWNED;
    run(s, 640);
    assertEquals(most, s.entityCount());
    s.despawn(s.entity(most - 1));
    run(s, 8);
    assertEquals(most, s.entityCount(), "a place that is free is taken");
  }

  @Test
  void whatIsSaidAndWhatIsPlayedNextLeavesTheMatch() throws Exception {
    SimulationHost s =
        flying(
            """
            {"when": {"enter": "plate"}, "do": [
              {"notice": "Somebody is in."}, {"event": "bell"}, {"event": "bell", "at": [1, 2]}]},
            {"when": {"timer": 2}, "do": {"next": "arena"}}
            """);
    run(s, 60);
    List<String> notices = new ArrayList<>();
    s.outbox().drainNotices(notices::add);
    assertEquals(List.of("Somebody is in."), notices);
    List<String> events = new ArrayList<>();
    s.outbox().drainEvents(e -> events.add(e.kind().name() + " of " + e.first() + " at " + e.x()));
    int ball = Event.key(0, 0);
    assertEquals(2, events.size(), events.toString());
    assertTrue(events.get(0).startsWith("bell of " + ball + " at "), events.get(0));
    assertTrue(events.get(1).endsWith(" at 1.0"), events.get(1));
    assertNull(s.outbox().takeNextMatch());
    run(s, 61);
    assertEquals("arena", s.outbox().takeNextMatch().level());
    s.outbox().drainNotices(notices::add);
    assertEquals(1, notices.size(), "said once");
  }

  @Test
  void theVisitorsPlayerIsScoredAndHurt() throws Exception {
    SimulationHost s =
        start(
            """
            {"when": {"enter": "plate", "who": "player"},
             "do": [{"score": 3}, {"add": "player.health", "by": -30}, {"impulse": [0, 2]}]},
            {"when": {"score": 3}, "once": true, "do": {"set": "player.health", "to": 99}}
            """);
    Player p = s.join("Ann");
    p.entity().setVelocity(4, -3);
    run(s, 200);
    assertEquals(3, s.score(p));
    assertEquals(99, p.get(HEALTH));
    p.entity().despawn();
    run(s, 5);
  }

  @Test
  void aLongWayInAShortTimeTakesLonger() throws Exception {
    SimulationHost s =
        start(
            """
            {"when": {"timer": 0}, "do": {"move": "door", "to": [9000, 0], "seconds": 0.1}}
            """);
    run(s, 60);
    assertTrue(s.entity(1).x() < 600, "x=" + s.entity(1).x());
    run(s, 60 * 20);
    assertEquals(9000, s.entity(1).x(), 0.01f);
    assertEquals(0, s.entity(1).velocityX());
  }

  @Test
  void whatWaitsForAVisitorWhoGoesDoesNothing() throws Exception {
    SimulationHost s =
        flying(
            "{\"when\": {\"enter\": \"plate\"}, \"after\": 1, \"do\": {\"remove\": \"visitor\"}}");
    run(s, 60);
    s.despawn(s.entity(0));
    s.spawn(s.archetype("ball"), -9, 0);
    run(s, 120);
    assertNotNull(s.entity(0), "the one that took the slot isn't it");
  }

  @Test
  void aTriggerThatRemovesItsVisitorIsToldOnce() throws Exception {
    SimulationHost s =
        flying(
            """
            {"when": {"enter": "plate"}, "do": [{"remove": "visitor"}, {"teleport": [0, 0]},
             {"add": "match.lamps", "by": 1}]},
            {"when": {"leave": "plate"}, "do": {"add": "match.lamps", "by": 4}}
            """);
    run(s, 60);
    assertNull(s.entity(0));
    assertEquals(5, s.get(LAMPS));
  }

  @Test
  void mistakesAreNamedWithPlaceAndRemedy() throws Exception {
    refused("{\"do\": {\"notice\": \"a\"}}", "triggers[0].when is missing");
    refused(
        "{\"when\": {\"enter\": \"plat\"}, \"do\": {\"notice\": \"a\"}}", "did you mean \"plate\"");
    refused("{\"when\": {\"enter\": \"wall\"}, \"do\": {\"notice\": \"a\"}}", "\"sensor\": true");
    refused(
        "{\"when\": {\"entr\": \"plate\"}, \"do\": {\"notice\": \"a\"}}", "did you mean \"enter\"");
    refused("{\"when\": {}, \"do\": {\"notice\": \"a\"}}", "triggers[0].when is empty");
    refused(
        "{\"when\": {\"timer\": 1, \"score\": 2}, \"do\": {\"notice\": \"a\"}}",
        "has both \"timer\" and \"score\"");
    refused("{\"when\": {\"timer\": 1}, \"do\": []}", "triggers[0].do has 0 actions");
    refused("{\"when\": {\"timer\": 1}, \"do\": {\"score\": 1}}", "the condition has nothing");
    refused(
        "{\"when\": {\"inside\": \"plate\"}, \"do\": {\"score\": 1}, \"else\": {\"score\": 1}}",
        "triggers[0].else acts on what sets the trigger off");
    refused(
        "{\"when\": {\"enter\": \"plate\"}, \"do\": {\"score\": 1}, \"else\": {\"notice\": \"a\"}}",
        "needs a condition that lasts");
    refused(
        "{\"when\": {\"timer\": 1}, \"once\": true, \"every\": 1, \"do\": {\"notice\": \"a\"}}",
        "contradicts \"once\"");
    refused(
        "{\"when\": {\"timer\": 1}, \"do\": {\"move\": \"crate\", \"to\": [0, 0]}}",
        "triggers[0].do.move=\"crate\" must be one of \"bodies\" with \"type\": \"kinematic\"");
    refused("{\"when\": {\"timer\": 1}, \"do\": {\"enable\": \"x\"}}", "one of \"triggers\"");
    refused("{\"when\": {\"timer\": 1}, \"do\": {\"remove\": \"wall\"}}", "never moves");
    unmatched("{\"spawn\": \"cratte\", \"at\": [0, 0]}", "do.spawn=\"cratte\"", "\"crate\"");
    unmatched("{\"event\": \"bel\", \"at\": [0, 0]}", "do.event=\"bel\"", "\"bell\"");
    unmatched("{\"add\": \"match.lamp\", \"by\": 1}", "do.add=\"match.lamp\"", "match.lamps");
    unmatched("{\"add\": \"match.triggerDue\", \"by\": 1}", "must be a field of the game", "");
    unmatched("{\"add\": \"match.open\", \"by\": 1}", "add to numbers", "");
    unmatched("{\"add\": \"match.lamps\", \"by\": 0.5}", "whole number", "");
    unmatched("{\"set\": \"match.lamps\", \"to\": 10}", "do.set", "");
    unmatched("{\"set\": \"match.open\", \"to\": 10}", "do.set", "");
  }

  private static void refused(String trigger, String words) {
    LevelException e = assertThrows(LevelException.class, () -> level(trigger));
    assertTrue(e.getMessage().contains(words), e.getMessage());
    assertTrue(e.getMessage().startsWith("t.json:"), e.getMessage());
  }

  private static void unmatched(String action, String words, String hint) throws Exception {
    String trigger = "{\"when\": {\"timer\": 1}, \"do\": " + action + "}";
    IllegalArgumentException e = assertThrows(IllegalArgumentException.class, () -> start(trigger));
    assertTrue(e.getMessage().contains(words) && e.getMessage().contains(hint), e.getMessage());
    assertTrue(e.getMessage().startsWith("t.json:"), e.getMessage());
  }

  @Test
  void aSavedMatchGoesOnAlike() throws Exception {
    int fired = 0;
    for (int seed = 0; seed < 120; seed++) {
      DrawnTriggers draw = new DrawnTriggers(seed);
      String triggers = draw.triggers();
      SimulationHost s = flying(triggers);
      s.join("Ann").entity().setVelocity(3, -3);
      run(s, draw.below(200));
      SimState state = s.save(null);
      ArchiveWriter out = new ArchiveWriter();
      state.write(out);
      run(s, 150);
      long hash = s.stateHash();
      fired += s.get(OPEN) || s.get(LAMPS) > 0 ? 1 : 0;
      s.restore(state);
      run(s, 150);
      assertEquals(hash, s.stateHash(), () -> "restored: " + triggers);
      SimulationHost other = start(triggers);
      other.restore(other.read(new ArchiveReader(out.toBytes())));
      run(other, 150);
      assertEquals(hash, other.stateHash(), () -> "read: " + triggers);
    }
    assertTrue(fired > 30, "fired=" + fired);
  }

  @Test
  void theSchemaTakesWhatTheReaderTakes() throws Exception {
    SchemaChecker schema = SchemaChecker.levels();
    for (int seed = 0; seed < 200; seed++) {
      String json = String.format(Locale.ROOT, LEVEL, new DrawnTriggers(seed).triggers());
      assertEquals("", schema.check(Json.parse(json.getBytes(StandardCharsets.UTF_8))), json);
    }
  }

  @Test
  void aDamagedFileIsRefusedWithItsPlace() {
    int refused = 0;
    for (int seed = 0; seed < 3000; seed++) {
      DrawnTriggers draw = new DrawnTriggers(seed);
      StringBuilder json = new StringBuilder(draw.triggers());
      for (int i = 0; i <= draw.below(3); i++) {
        int at = draw.below(json.length());
        switch (draw.below(3)) {
          case 0 -> json.deleteCharAt(at);
          case 1 -> json.setCharAt(at, "{}[]\",:0a-".charAt(draw.below(10)));
          default -> json.insert(at, draw.of("9e9", "null", "[]", "{}", "\"x\"", "-1", ","));
        }
      }
      try {
        start(json.toString());
      } catch (LevelException | IllegalArgumentException e) {
        assertTrue(e.getMessage().startsWith("t.json:"), () -> e.getMessage() + " of " + json);
        refused++;
      }
    }
    assertTrue(refused > 1000, "refused=" + refused);
    assertFalse(refused == 3000);
  }
}
