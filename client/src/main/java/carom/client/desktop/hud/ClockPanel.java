package carom.client.desktop.hud;

import carom.client.desktop.paint.Fonts;
import carom.client.desktop.paint.Theme;
import carom.client.field.FieldView;
import carom.client.view.ClientView;
import carom.game.Games;
import carom.net.protocol.ServerMessage.RosterEntry;
import carom.sim.Game;
import carom.sim.MatchClock;
import carom.sim.MatchPhase;
import com.badlogic.gdx.math.Vector3;
import java.util.List;

/**
 * Shows what a match is at, at the top of the picture: players it waits for, countdown, time left,
 * result. Nothing for a game without a {@link MatchClock}. Render thread only.
 */
public final class ClockPanel {
  private static final float TOP = 30;

  private final Hud hud;
  private final Fonts fonts;
  private final Vector3 at = new Vector3();
  private String clockOf = "";
  private MatchClock clock;
  private List<String> teams = List.of();

  /** Creates a panel. The arguments stay the property of the caller. */
  public ClockPanel(Hud hud, Fonts fonts) {
    this.hud = hud;
    this.fonts = fonts;
  }

  /** Draws the phase of the match that a client plays or a replay shows. */
  public void draw(ClientView view) {
    if (!view.game().equals(clockOf)) {
      clockOf = view.game();
      Game game = Games.create(clockOf);
      clock = game.clock();
      teams = game.teams();
    }
    if (clock == null || !view.knowsFields()) {
      return;
    }
    FieldView match = view.match();
    MatchPhase phase = MatchClock.phase(match);
    int ticks = MatchClock.ticksLeft(match);
    int seconds = ticks < 0 ? -1 : (ticks + view.tickRate() - 1) / view.tickRate();
    switch (phase) {
      case WARM_UP -> line(warmUp(clock, view.players()), false);
      case COUNTDOWN -> line(Integer.toString(seconds), true);
      case PLAYING -> line(seconds < 0 ? "" : time(seconds), false);
      case OVER -> {
        String result = result(match, view);
        line(result + "     next match in " + seconds, false);
      }
    }
  }

  /** Draws a line at the top, or a large word in the middle. */
  private void line(String text, boolean large) {
    if (text.isEmpty()) {
      return;
    }
    if (!large) {
      float half = hud.width(fonts.text, text) / 2 + 14;
      hud.panel(hud.windowWidth() / 2f - half, hud.height() - TOP - 8, 2 * half, TOP);
    }
    hud.begin();
    at.set(hud.windowWidth() / 2f, large ? hud.height() * 0.6f : hud.height() - 15, 0);
    hud.floating(text, at, large, large ? Theme.ACCENT : Theme.TEXT);
    hud.end();
  }

  /** Returns what a warm-up waits for. */
  static String warmUp(MatchClock clock, List<RosterEntry> roster) {
    int players = 0;
    int ready = 0;
    for (RosterEntry entry : roster) {
      players += entry.spectator() ? 0 : 1;
      ready += !entry.spectator() && entry.ready() ? 1 : 0;
    }
    int wanted = clock.playersToBegin();
    return players < wanted
        ? "Warm-up: " + players + " of " + wanted + " players"
        : "Warm-up: " + ready + " of " + players + " are ready (Tab and R)";
  }

  /** Returns minutes and seconds, such as 4:05. */
  static String time(int seconds) {
    return seconds / 60 + (seconds % 60 < 10 ? ":0" : ":") + seconds % 60;
  }

  private String result(FieldView match, ClientView view) {
    int team = MatchClock.winningTeam(match);
    if (team > 0) {
      return (team <= teams.size() ? teams.get(team - 1) : "Team " + team) + " wins!";
    }
    String player = view.playerName(MatchClock.winner(match));
    return player.isEmpty() ? "Nobody wins" : player + " wins!";
  }
}
