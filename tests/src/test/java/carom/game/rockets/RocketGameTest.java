package carom.game.rockets;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.game.GamesTest;
import carom.sim.MatchClock;
import carom.sim.MatchPhase;
import carom.sim.Role;
import carom.sim.SimulationHost;
import carom.sim.entity.HostPlayer;
import carom.sim.entity.Input;
import org.junit.jupiter.api.Test;

/** Goal: the rules of a match. Method: the shipped level; two players; one shoots. */
final class RocketGameTest {
  private final SimulationHost s = GamesTest.start("rockets", 1, Role.AUTHORITY);
  private final HostPlayer ann = s.join("ann");
  private final HostPlayer ben = s.join("ben");

  private void run(int ticks) {
    for (int i = 0; i < ticks; i++) {
      s.step();
    }
  }

  /** Lets Ann shoot at Ben, four metres away, until he is out; returns the ticks. */
  private int hitBen() {
    ann.entity().body().setPose(-16, 0, 0);
    ben.entity().body().setPose(-12, 0, 0);
    int ticks = 0;
    for (; ben.isAlive(); ticks++) {
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
}
