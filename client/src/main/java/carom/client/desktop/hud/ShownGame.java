package carom.client.desktop.hud;

import carom.client.desktop.paint.UiColours;
import carom.client.view.ClientView;
import carom.game.Games;
import carom.sim.Game;
import carom.sim.MatchClock;
import carom.sim.field.Gauge;
import carom.sim.field.Scope;
import com.badlogic.gdx.graphics.Color;
import java.util.List;

/**
 * The picture's game as it describes itself: its teams, their colours, its clock and gauges. Asks
 * the game once, not in each picture. Render thread only.
 */
public final class ShownGame {
  private String name = "";
  private String about = "";
  private List<String> teams = List.of();
  private int[] teamRgb = {};
  private List<Gauge> gauges = List.of();
  private MatchClock clock;
  private boolean playersColours;
  private Gauge teamScore;
  private Gauge gameClock;
  private final Color color = new Color();

  /** Creates one that knows no game. */
  public ShownGame() {}

  /** Looks at the game that a view shows. */
  public void look(ClientView view) {
    if (view.game().equals(name)) {
      return;
    }
    name = view.game();
    Game game = Games.create(name);
    about = game.description();
    teams = game.teams();
    teamRgb = new int[teams.size() + 1];
    for (int team = 1; team <= teams.size(); team++) {
      teamRgb[team] = game.teamRgb(team);
    }
    playersColours = game.ownColours();
    clock = game.clock();
    gauges = game.gauges();
    teamScore = first(Gauge.Kind.TEAM_SCORE);
    gameClock = first(Gauge.Kind.CLOCK);
  }

  private Gauge first(Gauge.Kind kind) {
    return gauges.stream().filter(gauge -> gauge.kind() == kind).findFirst().orElse(null);
  }

  /** Returns what it is about, in a line. */
  public String about() {
    return about;
  }

  /** Returns the number of teams. */
  public int teamCount() {
    return teams.size();
  }

  /** Returns the name of a team; its number where it has none. */
  public String team(int team) {
    return team >= 1 && team <= teams.size() ? teams.get(team - 1) : "Team " + team;
  }

  /** Returns the colour of a team, that of its bodies. The result is reused. */
  Color teamColor(int team) {
    boolean known = team >= 1 && team < teamRgb.length;
    return known ? UiColours.shade(teamRgb[team], 1, 1, color) : color.set(UiColours.MUTED);
  }

  /** Returns whether bodies may have the colours of their players. */
  boolean hasPlayersColours() {
    return playersColours;
  }

  /** Returns the phases of its matches, or null. */
  public MatchClock clock() {
    return clock;
  }

  /** Returns the fields that it shows. */
  public List<Gauge> gauges() {
    return gauges;
  }

  /** Returns whether it tells the scores of its teams. */
  boolean hasTeamScore() {
    return teamScore != null;
  }

  /** Returns the score of a team, as {@link #hasTeamScore} says. */
  int teamScore(ClientView view, int team) {
    return teamScore.value(view.match(), team);
  }

  /** Returns the ticks left by a clock of the game's own, or -1. */
  int ownClockTicks(ClientView view) {
    return gameClock == null ? -1 : gameClock.value(view.match());
  }

  /** Returns the value that a gauge shows for a player. */
  static int value(Gauge gauge, ClientView view, int player) {
    boolean ofMatch = gauge.field().scope() == Scope.MATCH;
    return gauge.value(ofMatch ? view.match() : view.player(player));
  }
}
