package carom.game.platformer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.game.Games;
import carom.game.GamesTest;
import carom.physics.Body;
import carom.sim.MatchClock;
import carom.sim.MatchPhase;
import carom.sim.Role;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.entity.Input;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import carom.sim.outbox.NextMatch;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;

/** Goal: movement follows its design. Method: one player, scripted input, a small level. */
class PlatformerGameTest {
  private static final float FEET = PlatformerGame.PLAYER_HEIGHT / 2;

  /** Ground from -20 to 20 at height 0, and whatever else. */
  private static SimulationHost level(float spawnX, float spawnY, String statics, String bodies) {
    String json =
        "{\"name\":\"t\",\"game\":\"platformer\",\"gravity\":[0,-26],"
            + "\"bounds\":{\"min\":[-30,-6],\"max\":[30,30]},"
            + "\"spawns\":[{\"at\":["
            + spawnX
            + ","
            + spawnY
            + "]},{\"name\":\"flag\",\"at\":[18,29]},{\"name\":\"coin\",\"at\":[15,1]}],"
            + "\"statics\":[{\"at\":[0,-1],\"material\":{\"friction\":0.7},"
            + "\"shape\":{\"type\":\"box\",\"width\":40,\"height\":2}}"
            + statics
            + "],\"bodies\":["
            + bodies
            + "]}";
    try {
      Level level = Level.parse("t.json", json.getBytes(StandardCharsets.UTF_8));
      return new SimulationHost(Games.create("platformer"), level, 1, 60, Role.AUTHORITY);
    } catch (LevelException e) {
      throw new AssertionError(e);
    }
  }

  private static String plank(float x, float top, float width) {
    return ",{\"at\":["
        + x
        + ","
        + (top - 0.15f)
        + "],\"oneWay\":true,\"material\":{\"friction\":0.6},"
        + "\"shape\":{\"type\":\"box\",\"width\":"
        + width
        + ",\"height\":0.3}}";
  }

  private static void run(SimulationHost s, int ticks) {
    for (int i = 0; i < ticks; i++) {
      s.step();
    }
  }

  private static Body<HostEntity> body(SimulationHost s) {
    return s.player(0).entity().body();
  }

  /** Lowest point above the ground's height. */
  private static float feet(SimulationHost s) {
    return body(s).y() - FEET;
  }

  private static float highest(SimulationHost s, int ticks) {
    float top = -100;
    for (int i = 0; i < ticks; i++) {
      s.step();
      top = Math.max(top, feet(s));
    }
    return top;
  }

  private static SimulationHost standing(String statics, String bodies) {
    SimulationHost s = level(0, 0.75f, statics, bodies);
    s.join("ann");
    run(s, 30);
    assertEquals(0, feet(s), 0.03f);
    return s;
  }

  @Test
  void aHeldJumpReachesThreeMetresAndATapHalfOfIt() {
    SimulationHost s = standing("", "");
    s.player(0).input().hold(Input.JUMP, true);
    float full = highest(s, 60);
    assertEquals(3.2f, full, 0.25f);
    assertEquals(0, feet(s), 0.03f, "holding the button doesn't jump again");

    s.player(0).input().hold(Input.JUMP, false);
    run(s, 5);
    s.player(0).input().hold(Input.JUMP, true);
    run(s, 3);
    s.player(0).input().hold(Input.JUMP, false);
    float tap = highest(s, 60);
    assertTrue(tap > 0.8f && tap < 0.65f * full, "tap=" + tap);
  }

  @Test
  void whoFallsComesBackAtTheLastCheckpointOfTheLevel() {
    String pole =
        ",{\"name\":\"pole\",\"sensor\":true,\"at\":[6,1],"
            + "\"shape\":{\"type\":\"box\",\"width\":0.4,\"height\":2}}";
    String trigger =
        "],\"triggers\":[{\"when\":{\"enter\":\"pole\",\"who\":\"player\"},"
            + "\"do\":{\"checkpoint\":[6.5,0.75]}}";
    SimulationHost s = standing(pole, trigger);
    assertEquals(0, afterAFall(s), 0.1f, "no checkpoint yet");
    s.player(0).input().move(1, 0);
    while (body(s).x() < 9) {
      s.step();
    }
    s.player(0).input().move(0, 0);
    assertEquals(6.5f, afterAFall(s), 0.1f);
    assertEquals(6.5f, afterAFall(s), 0.1f, "once more with another body");
  }

  /** Lets the player fall out of the level. Returns where it is when it has come back. */
  private static float afterAFall(SimulationHost s) {
    s.player(0).entity().teleport(-12, -9, 0);
    run(s, 2);
    assertFalse(s.player(0).isAlive());
    run(s, 70);
    return body(s).x();
  }

  @Test
  void aJumpPressedJustBeforeLandingCounts() {
    SimulationHost s = level(0, 3, "", "");
    s.join("ann");
    while (feet(s) > 0.6f) {
      s.step();
    }
    s.player(0).input().hold(Input.JUMP, true);
    assertTrue(highest(s, 40) > 2.5f);
  }

  @Test
  void aJumpPressedJustAfterTheEdgeCounts() {
    SimulationHost s = level(18, 0.75f, "", "");
    s.join("ann");
    run(s, 20);
    s.player(0).input().move(1, 0);
    while (body(s).x() < 20.45f) {
      s.step();
    }
    run(s, 3);
    float edge = feet(s);
    assertTrue(edge < 0);
    s.player(0).input().hold(Input.JUMP, true);
    assertTrue(highest(s, 30) > 2);
  }

  @Test
  void noSecondJumpInTheAir() {
    SimulationHost s = standing("", "");
    s.player(0).input().hold(Input.JUMP, true);
    run(s, 20);
    s.player(0).input().hold(Input.JUMP, false);
    run(s, 2);
    float before = body(s).velocityY();
    s.player(0).input().hold(Input.JUMP, true);
    s.step();
    assertTrue(body(s).velocityY() <= before);
  }

  @Test
  void runsAtFullSpeedInAThirdOfASecondAndStopsFaster() {
    SimulationHost s = standing("", "");
    s.player(0).input().move(1, 0);
    run(s, 20);
    assertEquals(PlatformerGame.SPEED, body(s).velocityX(), 0.4f);
    s.player(0).input().move(0, 0);
    run(s, 15);
    assertEquals(0, body(s).velocityX(), 0.3f);
  }

  @Test
  void wallsDontHoldAJumper() {
    SimulationHost s =
        standing(",{\"at\":[1,5],\"shape\":{\"type\":\"box\",\"width\":1,\"height\":10}}", "");
    s.player(0).input().move(1, 0);
    s.player(0).input().hold(Input.JUMP, true);
    float top = highest(s, 60);
    assertEquals(3.2f, top, 0.3f);
    assertEquals(0, feet(s), 0.05f);
  }

  @Test
  void aOneWayPlatformPassesFromBelowAndHoldsFromAbove() {
    SimulationHost s = standing(plank(0, 2.5f, 6), "");
    s.player(0).input().hold(Input.JUMP, true);
    float top = highest(s, 120);
    assertEquals(3.2f, top, 0.25f, "the platform didn't slow the jump");
    assertEquals(2.5f, feet(s), 0.03f);
    run(s, 300);
    assertEquals(2.5f, feet(s), 0.03f);
  }

  @Test
  void tooLowAJumpFallsBackThroughTheOneWayPlatform() {
    for (float height = 2.7f; height < 4.6f; height += 0.1f) {
      SimulationHost s = standing(plank(0, height, 6), "");
      s.player(0).input().hold(Input.JUMP, true);
      float top = highest(s, 120);
      assertEquals(3.2f, top, 0.25f, "height=" + height);
      float expected = top > height ? height : 0;
      assertEquals(expected, feet(s), 0.05f, "height=" + height);
    }
  }

  @Test
  void aFallFromHighAboveIsCaughtByTheOneWayPlatform() {
    for (float drop = 3; drop < 20; drop += 1.37f) {
      SimulationHost s = level(0, 4 + drop, plank(0, 3, 6), "");
      s.join("ann");
      run(s, 150);
      assertEquals(3, feet(s), 0.05f, "drop=" + drop);
    }
  }

  @Test
  void downDropsThrough() {
    SimulationHost s = level(0, 4, plank(0, 3, 6), "");
    s.join("ann");
    run(s, 60);
    assertEquals(3, feet(s), 0.03f);
    s.player(0).input().move(0, -1);
    run(s, 3);
    s.player(0).input().move(0, 0);
    run(s, 60);
    assertEquals(0, feet(s), 0.03f);
  }

  @Test
  void downOnSolidGroundDoesNothing() {
    SimulationHost s = standing("", "");
    s.player(0).input().move(0, -1).hold(Input.DOWN, true);
    run(s, 60);
    assertEquals(0, feet(s), 0.03f);
  }

  @Test
  void cratesRestOnOneWayPlatforms() {
    SimulationHost s =
        level(
            10,
            1,
            plank(0, 3, 14),
            "{\"at\":[0,4],\"angle\":20,\"shape\":{\"type\":\"box\",\"width\":0.9,\"height\":0.9},"
                + "\"repeat\":{\"rows\":4,\"step\":[0,1.2]}}");
    run(s, 300);
    for (int id = 0; id < 4; id++) {
      assertTrue(
          Math.abs(s.entity(id).body().x()) > 3 || s.entity(id).body().y() > 3.3f,
          "y=" + s.entity(id).body().y());
    }
  }

  @Test
  void aMovingPlatformCarriesItsRider() {
    String ferry =
        "{\"type\":\"kinematic\",\"at\":[0,2.85],\"oneWay\":true,"
            + "\"shape\":{\"type\":\"box\",\"width\":3,\"height\":0.3},"
            + "\"motion\":{\"to\":[8,5.85],\"period\":6}}";
    SimulationHost s = level(0, 4, "", ferry);
    s.join("ann");
    run(s, 45);
    for (int i = 0; i < 720; i++) {
      s.step();
      Body<HostEntity> platform = s.entity(0).body();
      assertEquals(platform.x(), body(s).x(), 0.9f, "tick " + s.tick());
      assertEquals(platform.y() + 0.15f, feet(s), 0.08f, "tick " + s.tick());
    }
  }

  @Test
  void aPlayerTopplesAStack() {
    SimulationHost s =
        standing(
            "",
            "{\"at\":[4,0.45],\"material\":{\"density\":0.4,\"friction\":0.6},"
                + "\"shape\":{\"type\":\"box\",\"width\":0.9,\"height\":0.9},"
                + "\"repeat\":{\"rows\":5,\"step\":[0,0.9]}}");
    run(s, 120);
    assertTrue(s.entity(4).body().y() > 4, "the stack stands by itself");
    s.player(0).input().move(1, 0);
    run(s, 120);
    assertTrue(s.entity(4).body().y() < 3, "y=" + s.entity(4).body().y());
  }

  @Test
  void coinsCountAndComeBack() {
    SimulationHost s = standing("", "");
    int before = s.entityCount();
    s.player(0).input().move(1, 0);
    while (s.player(0).score() == 0 && s.tick() < 400) {
      s.step();
    }
    assertEquals(1, s.player(0).score());
    assertEquals(before - 1, s.entityCount());
    s.player(0).input().move(-1, 0);
    run(s, 30);
    s.player(0).input().move(0, 0);
    run(s, 660);
    assertEquals(before, s.entityCount());
    assertEquals(1, s.player(0).score());
  }

  @Test
  void whoFallsOutIsBackASecondLater() {
    SimulationHost s = standing("", "");
    HostPlayer p = s.player(0);
    p.input().move(1, 0);
    while (p.entity() != null) {
      s.step();
      assertTrue(s.tick() < 600);
    }
    p.input().move(0, 0);
    run(s, 55);
    assertNull(p.entity());
    run(s, 10);
    assertNotNull(p.entity());
    assertFalse(body(s).x() > 1);
  }

  @Test
  void theFlagIsWorthTenAndMovesOn() throws Exception {
    SimulationHost s = GamesTest.start("platformer", 1, Role.AUTHORITY);
    HostPlayer p = s.join("ann");
    for (int round = 0; round < 3; round++) {
      HostEntity flag = flag(s);
      p.entity().body().setPose(flag.body().x(), flag.body().y(), 0);
      p.entity().body().setVelocity(0, 0);
      int before = p.score();
      s.step();
      assertTrue(p.score() >= before + PlatformerGame.FLAG_POINTS);
      assertNull(flag(s));
      float x = flag.body().isValid() ? 0 : p.entity().body().x();
      run(s, 300);
      assertTrue(Math.abs(flag(s).body().x() - x) > 3);
    }
  }

  /** A player who keeps running right and jumping crosses the shipped level and finds coins. */
  @Test
  void aSimpleRunnerCrossesTheLevel() {
    SimulationHost s = GamesTest.start("platformer", 1, Role.AUTHORITY);
    HostPlayer p = s.join("ann");
    float farthest = -40;
    while (s.tick() < 60 * 60 && farthest < 36) {
      p.input().move(1, 0).hold(Input.JUMP, s.tick() % 40 < 25);
      s.step();
      if (p.entity() != null) {
        farthest = Math.max(farthest, body(s).x());
      }
    }
    assertTrue(farthest >= 36, "farthest=" + farthest);
    assertTrue(p.score() >= 5, "score=" + p.score());
  }

  private static HostEntity flag(SimulationHost s) {
    for (int id = 0; id < s.entityCapacity(); id++) {
      if (s.entity(id) != null && s.entity(id).archetype().name().equals("flag")) {
        return s.entity(id);
      }
    }
    return null;
  }

  @Test
  void sixtyPointsWinTheMatchAndTheNextBegins() {
    SimulationHost s = level(15, 1, "", "");
    HostPlayer ann = s.join("ann");
    ann.score(PlatformerGame.POINTS_TO_WIN - 1);
    run(s, 2); // the spawn is at the coin
    assertEquals(PlatformerGame.POINTS_TO_WIN, ann.score());
    assertEquals(MatchPhase.OVER, MatchClock.phase(s));
    assertEquals(ann.id(), MatchClock.winner(s));
    run(s, 8 * 60 + 2);
    assertEquals(NextMatch.OF_ROTATION, s.outbox().takeNextMatch());
    assertEquals(PlatformerGame.POINTS_TO_WIN, ann.score(), "nothing counts any more");
  }

  @Test
  void whoLeadsWhenTheTimeIsOverWins() {
    SimulationHost s = level(0, 1, "", "");
    HostPlayer ann = s.join("ann");
    final HostPlayer ben = s.join("ben");
    ann.score(1);
    ben.score(2);
    run(s, (int) (PlatformerGame.MATCH_SECONDS * 60) + 1);
    assertEquals(MatchPhase.OVER, MatchClock.phase(s));
    assertEquals(ben.id(), MatchClock.winner(s));
  }
}
