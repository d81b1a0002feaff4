package carom.game.rockets;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.game.GamesTest;
import carom.sim.MatchClock;
import carom.sim.MatchPhase;
import carom.sim.Role;
import carom.sim.SimulationHost;
import carom.sim.entity.Entity;
import carom.sim.entity.HostPlayer;
import carom.sim.entity.Input;
import org.junit.jupiter.api.Test;

/** Goal: the rules of a match. Method: the shipped level; two players; one shoots. */
final class RocketGameTest {
  private static final int HEALTH = RocketFields.HEALTH.max();

  private final SimulationHost s = GamesTest.start("rockets", 1, Role.AUTHORITY);
  private final HostPlayer ann = s.join("ann");
  private final HostPlayer ben = s.join("ben");

  private void run(int ticks) {
    for (int i = 0; i < ticks; i++) {
      s.step();
    }
  }

  private static void put(HostPlayer p, float x, float y) {
    p.entity().body().setPose(x, y, 0);
    p.entity().body().setVelocity(0, 0);
  }

  private int count(String archetype) {
    int count = 0;
    for (Entity e : s.entities()) {
      count += e.archetype().name().startsWith(archetype) ? 1 : 0;
    }
    return count;
  }

  private Entity first(String archetype) {
    for (Entity e : s.entities()) {
      if (e.archetype().name().startsWith(archetype)) {
        return e;
      }
    }
    throw new AssertionError("there is no " + archetype);
  }

  /** Lets Ann shoot at Ben, four metres away, until he is out; returns the ticks. */
  private int hitBen() {
    int ticks = 0;
    for (; ben.isAlive(); ticks++) {
      put(ann, -16, 0);
      put(ben, -12, 0);
      ann.input().aim(0).hold(Input.ACTION, true);
      run(1);
      assertTrue(ticks < 600, "ben is still there");
    }
    ann.input().hold(Input.ACTION, false);
    return ticks;
  }

  private void awaitBen() {
    for (int i = 0; !ben.isAlive(); i++) {
      run(1);
      assertTrue(i < 600, "ben is still out");
    }
  }

  @Test
  void aPlayerWhoIsHitIsOutForLongEnoughToLookOn() {
    hitBen();
    assertNull(ben.entity());
    run(s.ticks(RocketGame.RESPAWN_SECONDS) - 1);
    assertNull(ben.entity());
    run(3);
    assertNotNull(ben.entity());
  }

  @Test
  void theMatchBeginsWhenAllAreReadyAndPracticeIsForgotten() {
    hitBen();
    assertEquals(1, ann.score());
    assertEquals(MatchPhase.WARM_UP, MatchClock.phase(s));
    ann.ready(true);
    run(2);
    assertEquals(MatchPhase.WARM_UP, MatchClock.phase(s));
    ben.ready(true);
    run(2);
    assertEquals(MatchPhase.COUNTDOWN, MatchClock.phase(s));
    run(180);
    assertEquals(MatchPhase.PLAYING, MatchClock.phase(s));
    assertEquals(0, ann.score());
  }

  @Test
  void tenHitsWinAndNoneCountsAfterwards() {
    ann.ready(true);
    ben.ready(true);
    run(182);
    for (int hit = 1; hit <= RocketGame.HITS_TO_WIN; hit++) {
      assertEquals(MatchPhase.PLAYING, MatchClock.phase(s));
      hitBen();
      assertEquals(hit, ann.score());
      if (hit < RocketGame.HITS_TO_WIN) {
        awaitBen();
      }
    }
    assertEquals(MatchPhase.OVER, MatchClock.phase(s));
    run(1);
    assertEquals(ann.id(), MatchClock.winner(s));
    awaitBen();
    hitBen();
    assertEquals(RocketGame.HITS_TO_WIN, ann.score());
  }

  @Test
  void whoLeadsWhenTheTimeIsOverWinsAndADrawHasNoWinner() {
    ann.ready(true);
    ben.ready(true);
    run(182 + s.ticks(RocketGame.MATCH_SECONDS));
    assertEquals(MatchPhase.OVER, MatchClock.phase(s));
    assertEquals(-1, MatchClock.winner(s));
  }

  @Test
  void aShieldHoldsHarmOffEmptiesAndFillsAgain() {
    int bare = HEALTH - shootOnce();
    ben.input().hold(RocketGame.SHIELD, true);
    run(2);
    assertTrue(ben.get(RocketFields.SHIELDED));
    int before = ben.get(RocketFields.HEALTH);
    int shielded = before - shootOnce();
    assertTrue(bare > 20 && shielded > 0 && shielded < bare / 3, bare + " " + shielded);
    run(s.ticks(RocketGame.SHIELD_SECONDS));
    assertFalse(ben.get(RocketFields.SHIELDED), "it is empty");
    run(s.ticks(RocketGame.SHIELD_FILL_SECONDS / 2) + 2);
    assertTrue(ben.get(RocketFields.SHIELDED), "it is half full again");
  }

  /** Lets Ann shoot a rocket at Ben; returns the health that he has afterwards. */
  private int shootOnce() {
    int before = ben.get(RocketFields.HEALTH);
    for (int i = 0; ben.get(RocketFields.HEALTH) == before; i++) {
      put(ann, -16, 0);
      put(ben, -12, 0);
      ann.input().aim(0).hold(Input.ACTION, i == 0);
      run(1);
      assertTrue(i < 60, "ben isn't hit");
    }
    run(40);
    return ben.get(RocketFields.HEALTH);
  }

  @Test
  void aRockBreaksIntoPiecesThatBreakAndLeavesSomethingToTake() {
    Entity rock = first("rock.large");
    for (int i = 0; count("rock.medium") == 0; i++) {
      put(ann, rock.x() - 4, rock.y());
      ann.input().aim(0).hold(Input.ACTION, true);
      run(1);
      assertTrue(i < 600, "the rock is whole");
    }
    ann.input().hold(Input.ACTION, false);
    assertEquals(3, count("rock.large"));
    assertEquals(2, count("rock.medium"));
    String kinds = count("repair") + " " + count("scatter") + " " + count("torpedoes");
    assertEquals(
        1, count("repair") + count("scatter") + count("torpedoes") + count("mines"), kinds);
    rock = first("rock.medium");
    for (int i = 0; count("rock.small") == 0; i++) {
      put(ann, rock.x() - 4, rock.y());
      ann.input().aim(0).hold(Input.ACTION, true);
      run(1);
      assertTrue(i < 600, "the rock is whole");
    }
    assertEquals(0, count("rock.small") % 3, "small=" + count("rock.small"));
  }

  @Test
  void thereAreNeverMoreRocksThanTheLimit() {
    long seed = 7;
    int most = 0;
    for (int i = 0; i < 90 * 60; i++) {
      for (HostPlayer p : new HostPlayer[] {ann, ben}) {
        if (p.isAlive() && i % 20 == 0) {
          seed = seed * 6364136223846793005L + 1442695040888963407L;
          p.input().aim((seed >>> 40) / 1_000f).hold(Input.ACTION, true);
        }
      }
      run(1);
      most = Math.max(most, count("rock."));
    }
    assertTrue(most > 8 && most <= Rocks.MOST, "rocks=" + most);
  }

  @Test
  void aWeaponIsTakenOnceAndRunsEmpty() {
    put(ann, -16, 0);
    ann.set(RocketFields.WEAPON, Weapon.SCATTER);
    ann.set(RocketFields.AMMO, 1);
    ann.input().aim(0).hold(Input.ACTION, true);
    run(1);
    assertEquals(5, count("bolt"));
    assertTrue(ann.entity().velocityX() < -3, "vx=" + ann.entity().velocityX());
    assertEquals(Weapon.ROCKET, ann.get(RocketFields.WEAPON));
  }

  @Test
  void aMineWaitsForAShipAndIsPutDownToItsPlayer() {
    put(ben, 16, 0);
    put(ann, -16, 0);
    ann.set(RocketFields.WEAPON, Weapon.MINES);
    ann.set(RocketFields.AMMO, 1);
    ann.input().aim(0).hold(Input.ACTION, true);
    run(1);
    ann.input().hold(Input.ACTION, false);
    run(90);
    Entity mine = first("mine");
    assertTrue(mine.x() < -17.5f, "x=" + mine.x());
    put(ben, mine.x() + 0.8f, mine.y());
    run(3);
    assertEquals(0, count("mine"));
    assertTrue(ben.get(RocketFields.HEALTH) < 50, "health=" + ben.get(RocketFields.HEALTH));
  }
}
