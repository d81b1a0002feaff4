package carom.game.arena;

import static carom.game.arena.ArenaFields.GOALS;
import static carom.game.arena.ArenaFields.LAMP;
import static carom.game.arena.ArenaFields.TOUCHED;
import static carom.game.arena.ArenaFields.TOUCHED_BEFORE;
import static carom.sim.event.Audience.ALL;

import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.level.Archetype;
import carom.sim.level.Level;
import carom.sim.match.MatchClock;

/** Goals: the team that each counts for, the lamps that show them, and the winner. */
final class Goals {
  private final Pitch pitch;
  private final Discs discs;

  Goals(Pitch pitch, Discs discs) {
    this.pitch = pitch;
    this.discs = discs;
  }

  /** Counts a goal for a team and for the scorer, and tells all players. */
  void count(SimulationHost s, HostEntity ball, int team) {
    s.add(GOALS, team, 1);
    HostPlayer last = ball.get(TOUCHED);
    HostPlayer before = ball.get(TOUCHED_BEFORE);
    String by = "";
    HostPlayer scorer = last;
    if (last != null && last.team() == team) {
      last.score(last.score() + 1);
      by = ": " + last.name();
    } else if (before != null && before.team() == team) {
      before.score(before.score() + 1);
      scorer = before;
      by = ": " + before.name();
    } else if (last != null) {
      by = ", own goal by " + last.name();
    }
    s.emit(pitch.goal).at(ball.body().x(), ball.body().y()).of(ball).by(scorer).data(team).to(ALL);
    String standing = s.get(GOALS, 1) + " : " + s.get(GOALS, 2);
    s.notice("Goal for " + Pitch.TEAM_NAMES[team] + by + " (" + standing + ")");
  }

  /** Goes on after a goal: lamps, and the end of the match, or teams of equal size. */
  void settle(SimulationHost s, int team) {
    setLamps(s);
    if (s.get(GOALS, team) < ArenaGame.GOALS_TO_WIN) {
      discs.balance(s);
    } else if (MatchClock.isPlaying(s)) {
      ArenaGame.CLOCK.finish(s, team);
    } else {
      clear(s);
    }
  }

  /** Sets all scores and goals to 0. */
  void clear(SimulationHost s) {
    for (int team = 1; team <= Pitch.TEAMS; team++) {
      s.set(GOALS, team, 0);
    }
    for (int id = 0; id < s.playerCapacity(); id++) {
      if (s.player(id) != null) {
        s.player(id).score(0);
      }
    }
    setLamps(s);
  }

  /** Names the winner of a match that is over. */
  void decide(SimulationHost s) {
    int red = s.get(GOALS, 1);
    int blue = s.get(GOALS, 2);
    int winner = red == blue ? 0 : red > blue ? 1 : 2;
    ArenaGame.CLOCK.decide(s, null, winner);
    String result = winner == 0 ? "A draw, " : Pitch.TEAM_NAMES[winner] + " wins ";
    s.notice(result + red + " : " + blue + "!");
  }

  /** Places one lamp for each goal that wins, and lights one for each goal scored. */
  void setLamps(SimulationHost s) {
    for (Level.Zone zone : s.level().zones("lamps")) {
      int team = zone.team();
      for (int i = 0; i < ArenaGame.GOALS_TO_WIN && team >= 1 && team <= Pitch.TEAMS; i++) {
        Archetype kind = pitch.lamps[s.get(GOALS, team) > i ? team : 0];
        int slot = (team - 1) * ArenaGame.GOALS_TO_WIN + i;
        HostEntity lamp = s.get(LAMP, slot);
        if (lamp != null && lamp.archetype() != kind) {
          s.despawn(lamp);
          lamp = null;
        }
        if (lamp == null) {
          float x = zone.minX() + (zone.maxX() - zone.minX()) * (i + 0.5f) / ArenaGame.GOALS_TO_WIN;
          lamp = s.spawn(kind, x, (zone.minY() + zone.maxY()) / 2, 0, null);
          s.set(LAMP, slot, lamp);
        }
      }
    }
  }
}
