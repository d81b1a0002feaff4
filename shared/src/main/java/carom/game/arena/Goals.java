package carom.game.arena;

import static carom.game.arena.ArenaFields.GOALS;
import static carom.game.arena.ArenaFields.LAMP;
import static carom.game.arena.ArenaFields.RATING;
import static carom.game.arena.ArenaFields.SCORED;
import static carom.game.arena.ArenaFields.TOUCHED;
import static carom.game.arena.ArenaFields.TOUCHED_BEFORE;
import static carom.game.arena.ArenaFields.WINS;
import static carom.sim.event.Audience.ALL;

import carom.sim.Match;
import carom.sim.MatchClock;
import carom.sim.entity.Entity;
import carom.sim.entity.Player;
import carom.sim.level.Archetype;
import carom.sim.level.Level;

/** Goals: the team that each counts for, the lamps that show them, and the winner. */
final class Goals {
  /** Points that a player gains by a win over players who are as good. */
  private static final int EVEN_POINTS = 16;

  /** Difference of ratings that takes one of these points away. */
  private static final int EDGE_OF_POINT = 25;

  private final Pitch pitch;
  private final Discs discs;

  Goals(Pitch pitch, Discs discs) {
    this.pitch = pitch;
    this.discs = discs;
  }

  /** Counts a goal for a team and for the scorer, and tells all players. */
  void count(Match m, Entity ball, int team) {
    m.add(GOALS, team, 1);
    Player last = ball.get(TOUCHED);
    Player before = ball.get(TOUCHED_BEFORE);
    String by = "";
    Player scorer = last;
    if (last != null && m.team(last) == team) {
      scores(m, last);
      by = ": " + m.name(last);
    } else if (before != null && m.team(before) == team) {
      scores(m, before);
      scorer = before;
      by = ": " + m.name(before);
    } else if (last != null) {
      by = ", own goal by " + m.name(last);
    }
    m.emit(pitch.goal).at(ball.x(), ball.y()).of(ball).by(scorer).data(team).to(ALL);
    String standing = m.get(GOALS, 1) + " : " + m.get(GOALS, 2);
    m.notice("Goal for " + Pitch.TEAM_NAMES[team] + by + " (" + standing + ")");
  }

  private static void scores(Match m, Player p) {
    m.addScore(p, 1);
    p.add(SCORED, MatchClock.isPlaying(m) ? 1 : 0);
  }

  /** Goes on after a goal: lamps, and the end of the match, or teams of equal size. */
  void settle(Match m, int team) {
    setLamps(m);
    if (m.get(GOALS, team) < ArenaGame.GOALS_TO_WIN) {
      discs.balance(m);
    } else if (MatchClock.isPlaying(m)) {
      ArenaGame.CLOCK.finish(m, team);
    } else {
      clear(m);
    }
  }

  /** Sets all scores and goals to 0. */
  void clear(Match m) {
    for (int team = 1; team <= Pitch.TEAMS; team++) {
      m.set(GOALS, team, 0);
    }
    for (Player p : m.players()) {
      m.score(p, 0);
    }
    setLamps(m);
  }

  /** Names the winner of a match that is over. */
  void decide(Match m) {
    int red = m.get(GOALS, 1);
    int blue = m.get(GOALS, 2);
    int winner = red == blue ? 0 : red > blue ? 1 : 2;
    ArenaGame.CLOCK.decide(m, null, winner);
    for (Player p : m.players()) {
      p.add(WINS, winner != 0 && m.team(p) == winner ? 1 : 0);
    }
    rate(m, winner);
    String result = winner == 0 ? "A draw, " : Pitch.TEAM_NAMES[winner] + " wins ";
    m.notice(result + red + " : " + blue + "!");
    m.notice(reason(m, Math.max(red, blue)));
  }

  /**
   * Rates the players of two teams anew, by Elo's formula with a straight line for its curve: the
   * winners get more, the better the others were.
   */
  private static void rate(Match m, int winner) {
    if (winner == 0 || m.teamSize(1) == 0 || m.teamSize(2) == 0) {
      return;
    }
    int edge = rating(m, winner) - rating(m, Pitch.TEAMS + 1 - winner);
    int points = Math.max(1, Math.min(2 * EVEN_POINTS - 1, EVEN_POINTS - edge / EDGE_OF_POINT));
    for (Player p : m.players()) {
      p.add(RATING, m.team(p) == winner ? points : -points);
    }
  }

  private static int rating(Match m, int team) {
    int sum = 0;
    for (Player p : m.players()) {
      sum += m.team(p) == team ? p.get(RATING) : 0;
    }
    return sum / m.teamSize(team);
  }

  /** Returns why the match is over, and who scored most. */
  private static String reason(Match m, int most) {
    Player best = null;
    for (Player p : m.players()) {
      best = best == null || m.score(p) > m.score(best) ? p : best;
    }
    return (most < ArenaGame.GOALS_TO_WIN ? "Time was up" : most + " goals win")
        + (best == null || m.score(best) == 0
            ? ""
            : "; " + m.name(best) + " scored most: " + m.score(best));
  }

  /** Places one lamp for each goal that wins, and lights one for each goal scored. */
  void setLamps(Match m) {
    for (Level.Zone zone : m.level().zones("lamps")) {
      int team = zone.team();
      for (int i = 0; i < ArenaGame.GOALS_TO_WIN && team >= 1 && team <= Pitch.TEAMS; i++) {
        Archetype kind = pitch.lamps[m.get(GOALS, team) > i ? team : 0];
        int slot = (team - 1) * ArenaGame.GOALS_TO_WIN + i;
        Entity lamp = m.get(LAMP, slot);
        if (lamp != null && lamp.archetype() != kind) {
          lamp.despawn();
          lamp = null;
        }
        if (lamp == null) {
          float x = zone.minX() + (zone.maxX() - zone.minX()) * (i + 0.5f) / ArenaGame.GOALS_TO_WIN;
          lamp = m.spawn(kind, x, (zone.minY() + zone.maxY()) / 2, 0, null);
          m.set(LAMP, slot, lamp);
        }
      }
    }
  }
}
