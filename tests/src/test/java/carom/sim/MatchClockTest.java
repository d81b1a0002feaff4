package carom.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;

import carom.fixtures.PlainGame;
import carom.sim.entity.HostPlayer;
import carom.sim.level.Level;
import carom.sim.outbox.NextMatch;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Goal: a match goes through its phases at the right ticks, and tells its game. */
class MatchClockTest {
  private final List<String> told = new ArrayList<>();
  private MatchClock clock;
  private NextMatch chosen;

  private final class ClockGame extends PlainGame {
    ClockGame() {
      super("clock", "none");
    }

    @Override
    public MatchClock clock() {
      return clock;
    }

    @Override
    public NextMatch next(Match m) {
      return chosen == null ? super.next(m) : chosen;
    }

    @Override
    public void phase(Match s, MatchPhase now) {
      told.add(now.text() + "@" + s.tick());
    }
  }

  private SimulationHost start(MatchClock withClock, Role role) throws Exception {
    clock = withClock;
    String json =
        """
        {"name": "Empty", "game": "clock", "gravity": [0, 0],
         "bounds": {"min": [-9, -9], "max": [9, 9]}, "spawns": [{"at": [0, 0]}],
         "statics": [{"at": [0, -2], "shape": {"type": "box", "width": 9, "height": 1}}]}
        """;
    Level level = Level.parse("clock.json", json.getBytes(StandardCharsets.UTF_8));
    return new SimulationHost(new ClockGame(), level, 1, 60, role);
  }

  private static void run(SimulationHost s, int ticks) {
    for (int i = 0; i < ticks; i++) {
      s.step();
    }
  }

  @Test
  void warmUpWaitsForEnoughPlayersWhoAreReady() throws Exception {
    SimulationHost s =
        start(MatchClock.playing(10).warmUp(2).whenReady().countdown(3).over(5), Role.AUTHORITY);
    HostPlayer ann = s.join("Ann");
    ann.ready(true);
    run(s, 100);
    assertEquals(MatchPhase.WARM_UP, MatchClock.phase(s), "one player is too few");
    assertEquals(-1, MatchClock.ticksLeft(s));
    HostPlayer bob = s.join("Bob");
    run(s, 100);
    assertEquals(MatchPhase.WARM_UP, MatchClock.phase(s), "Bob isn't ready");
    bob.ready(true);
    run(s, 1);
    assertEquals(MatchPhase.COUNTDOWN, MatchClock.phase(s));
    run(s, 3 * 60 + 10 * 60 + 5 * 60 + 5);
    assertEquals(3, told.size(), told.toString());
    assertEquals("countdown@" + told(0), told.get(0));
    assertEquals("playing@" + (told(0) + 3 * 60), told.get(1));
    assertEquals("over@" + (told(0) + 13 * 60), told.get(2));
    assertEquals(NextMatch.OF_ROTATION, s.outbox().takeNextMatch());
  }

  private int told(int index) {
    return Integer.parseInt(told.get(index).substring(told.get(index).indexOf('@') + 1));
  }

  @Test
  void aClientKnowsThePhaseOfEveryTickWithoutAMessage() throws Exception {
    MatchClock timed = MatchClock.playing(2).countdown(1).over(1);
    SimulationHost server = start(timed, Role.AUTHORITY);
    SimulationHost client = start(timed, Role.PREDICTION);
    for (int tick = 0; tick < 5 * 60; tick++) {
      assertEquals(MatchClock.phase(server), MatchClock.phase(client), "tick=" + tick);
      assertEquals(MatchClock.ticksLeft(server), MatchClock.ticksLeft(client), "tick=" + tick);
      server.step();
      client.step();
    }
    assertEquals(MatchPhase.OVER, MatchClock.phase(client));
  }

  @Test
  void aGameEndsItsMatchEarlyAndSaysWhoHasWon() throws Exception {
    NextMatch next = NextMatch.level("other").keepingTeams();
    SimulationHost s = start(MatchClock.playing(0).over(2).next(next), Role.AUTHORITY);
    HostPlayer ann = s.join("Ann");
    run(s, 100_000 / 60);
    assertEquals(MatchPhase.PLAYING, MatchClock.phase(s));
    assertEquals(-1, MatchClock.ticksLeft(s), "nothing but the game ends it");
    clock.finish(s, ann);
    assertEquals(MatchPhase.OVER, MatchClock.phase(s));
    assertEquals(ann.id(), MatchClock.winner(s));
    clock.finish(s, 2);
    assertEquals(0, MatchClock.winningTeam(s), "it is over already");
    run(s, 2 * 60 - 1);
    assertNull(s.outbox().takeNextMatch());
    run(s, 2);
    assertEquals(next, s.outbox().takeNextMatch());
  }

  @Test
  void aGameChoosesWhatFollowsOnceTheResultWasShown() throws Exception {
    SimulationHost s = start(MatchClock.playing(1).over(2), Role.AUTHORITY);
    s.join("Ann");
    run(s, 90);
    chosen = NextMatch.level("hole2").keepingScores();
    run(s, 90 - 1);
    assertNull(s.outbox().takeNextMatch(), "the result is shown for 2 s");
    run(s, 2);
    assertEquals(chosen, s.outbox().takeNextMatch());
  }

  @Test
  void anEarlyEndShowsTheResultForItsFullTime() throws Exception {
    SimulationHost s = start(MatchClock.playing(10).countdown(1).over(3), Role.AUTHORITY);
    s.join("Ann");
    run(s, 1 * 60 + 4 * 60);
    clock.finish(s);
    assertEquals(MatchPhase.OVER, MatchClock.phase(s));
    assertEquals(3 * 60, MatchClock.ticksLeft(s));
  }

  @Test
  void timesOutsideTheirRangesAreRefusedByName() {
    refused("seconds=-1.0 is outside 0..86400.0", () -> MatchClock.playing(-1));
    refused("seconds=61.0 is outside 0..60.0", () -> MatchClock.playing(1).countdown(61));
    refused("seconds=601.0 is outside 0..600.0", () -> MatchClock.playing(1).over(601));
    refused("enough=1025.0 is outside 0..1024.0", () -> MatchClock.playing(1).warmUp(1_025));
  }

  private static void refused(String message, Runnable call) {
    assertEquals(message, assertThrows(IllegalArgumentException.class, call::run).getMessage());
  }
}
