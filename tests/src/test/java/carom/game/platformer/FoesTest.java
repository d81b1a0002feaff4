package carom.game.platformer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.game.Games;
import carom.sim.Role;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;

/**
 * Goal: foes patrol, chase, hurt and are beaten, and runs are timed, as the page of the game says.
 * Method: a floor from -20 to 20 at height 0, with zones.
 */
final class FoesTest {
  private static SimulationHost level(float spawnX, String zones) {
    String json =
        """
        {"name": "t", "game": "platformer", "gravity": [0, -26],
         "bounds": {"min": [-30, -6], "max": [30, 30]},
         "spawns": [{"at": [%s, 0.8]}, {"name": "flag", "at": [18, 29]}],
         "zones": [%s],
         "statics": [{"at": [0, -1], "shape": {"type": "box", "width": 40, "height": 2}}]}
        """
            .formatted(spawnX, zones);
    try {
      Level level = Level.parse("t.json", json.getBytes(StandardCharsets.UTF_8));
      return new SimulationHost(Games.create("platformer"), level, 1, 60, Role.AUTHORITY);
    } catch (LevelException e) {
      throw new AssertionError(e);
    }
  }

  private static String zone(String name, float min, float max) {
    return "{\"name\": \"%s\", \"min\": [%s, 0], \"max\": [%s, 4]}".formatted(name, min, max);
  }

  private static void run(SimulationHost s, int ticks) {
    for (int i = 0; i < ticks; i++) {
      s.step();
    }
  }

  private static HostEntity find(SimulationHost s, String archetype) {
    for (int id = 0; id < s.entityCapacity(); id++) {
      if (s.entity(id) != null && s.entity(id).archetype().name().equals(archetype)) {
        return s.entity(id);
      }
    }
    return null;
  }

  private static void put(HostPlayer p, float x, float y) {
    p.entity().body().setPose(x, y, 0);
    p.entity().body().setVelocity(0, 0);
  }

  @Test
  void aWalkerGoesFromEdgeToEdge() {
    SimulationHost s = level(-15, zone("walker", 0, 6));
    run(s, 6);
    HostEntity walker = find(s, "walker");
    float left = 9;
    float right = -9;
    for (int tick = 0; tick < 600; tick++) {
      s.step();
      left = Math.min(left, walker.x());
      right = Math.max(right, walker.x());
    }
    assertEquals(0, left, 0.3f);
    assertEquals(6, right, 0.3f);
  }

  @Test
  void aHunterComesAfterTheOneItSeesAndGivesUpOutsideOfItsZone() {
    SimulationHost s = level(-15, zone("hunter", 0, 10));
    HostPlayer ann = s.join("Ann");
    run(s, 100); // nobody is chased at once
    put(ann, 9, 0.8f);
    HostEntity hunter = find(s, "hunter");
    hunter.body().setPose(2, 0.5f, 0);
    run(s, 60);
    assertTrue(hunter.velocityX() > 4, "vx=" + hunter.velocityX());
    put(ann, -15, 0.8f);
    run(s, 40);
    assertTrue(Math.abs(hunter.velocityX()) < 2.2f, "vx=" + hunter.velocityX());
    run(s, 600);
    assertTrue(hunter.x() > -0.5f && hunter.x() < 10.5f, "x=" + hunter.x());
  }

  @Test
  void aFoeThatFallsIsTakenAway() {
    SimulationHost s = level(-15, zone("hunter", 16, 26)); // the floor ends at 20
    run(s, 6);
    assertNotNull(find(s, "hunter"));
    run(s, 200);
    assertNull(find(s, "hunter"));
  }

  @Test
  void landingOnAFoeBeatsItAndItComesBack() {
    SimulationHost s = level(-15, zone("walker", 0, 6));
    HostPlayer ann = s.join("Ann");
    run(s, 120);
    HostEntity walker = find(s, "walker");
    put(ann, walker.x(), walker.y() + 2);
    int ticks = 0;
    while (find(s, "walker") != null && ticks++ < 60) {
      s.step();
    }
    assertNotNull(find(s, "flat"));
    assertTrue(ann.entity().velocityY() > 5, "vy=" + ann.entity().velocityY());
    assertEquals(PlatformerGame.FOE_POINTS, ann.score());
    run(s, 60);
    assertNull(find(s, "flat"));
    put(ann, -15, 0.8f);
    run(s, 600);
    assertNotNull(find(s, "walker"));
  }

  @Test
  void runningIntoAFoeThrowsBackAndCostsPointsOnce() {
    SimulationHost s = level(-15, zone("walker", 0, 6));
    HostPlayer ann = s.join("Ann");
    ann.score(10);
    run(s, 120);
    HostEntity walker = find(s, "walker");
    put(ann, walker.x() - 1.5f, 0.7f);
    ann.input().move(1, 0);
    int ticks = 0;
    while (ann.get(PlatformerFields.HURT) == 0 && ticks++ < 120) {
      s.step();
    }
    assertTrue(ann.entity().velocityX() < -5, "vx=" + ann.entity().velocityX());
    run(s, 60); // back in the midst of it, and spared
    assertEquals(10 - PlatformerGame.HURT_POINTS, ann.score());
    assertNotNull(find(s, "walker"));
  }

  @Test
  void aRunIsTimedAndTakesBackToTheStart() {
    SimulationHost s = level(-18, zone("start", -20, -16) + ", " + zone("goal", 16, 20));
    HostPlayer ann = s.join("Ann");
    run(s, 30);
    ann.input().move(1, 0);
    int begin = 0;
    while (s.get(PlatformerFields.BEST_RUN) == 0 && s.tick() < 900) {
      s.step();
      begin = begin == 0 && ann.get(PlatformerFields.RUN) > 0 ? s.tick() : begin;
    }
    int ms = (s.tick() - begin) * 1_000 / 60;
    assertEquals(ms, s.get(PlatformerFields.BEST_RUN), 40);
    assertEquals(s.get(PlatformerFields.BEST_RUN), ann.get(PlatformerFields.OWN_BEST));
    assertEquals(PlatformerGame.RUN_POINTS, ann.score());
    assertTrue(ann.entity().x() < -16, "x=" + ann.entity().x());
    int length = s.get(PlatformerFields.BEST_LENGTH);
    assertTrue(length >= 3 * ms / 1_000, "length=" + length);
    for (int i = 1; i < length; i++) {
      float x = Runs.x(s.get(PlatformerFields.BEST_PATH, i), s.level().bounds());
      float before = Runs.x(s.get(PlatformerFields.BEST_PATH, i - 1), s.level().bounds());
      assertTrue(x > before, "sample=" + i + " x=" + x);
    }
    int record = s.get(PlatformerFields.BEST_RUN);
    ann.input().move(0.5f, 0);
    run(s, 900); // slower
    assertEquals(record, s.get(PlatformerFields.BEST_RUN));
    assertFalse(ann.score() == PlatformerGame.RUN_POINTS, "the second run counts, too");
  }

  @Test
  void aLevelWithoutFoesHasNoRules() {
    assertFalse(level(-15, "").hasRules());
    assertTrue(level(-15, zone("walker", 0, 6)).hasRules());
  }

  @Test
  void aGoalWithoutAStartIsRefused() {
    String error =
        assertThrows(IllegalArgumentException.class, () -> level(-15, zone("goal", 0, 6)))
            .getMessage();
    assertTrue(error.contains("a run needs one \"start\" and one \"goal\""), error);
  }
}
