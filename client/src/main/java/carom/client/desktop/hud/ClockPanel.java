package carom.client.desktop.hud;

import carom.client.desktop.paint.Fonts;
import carom.client.desktop.paint.Theme;
import carom.client.field.FieldView;
import carom.client.view.ClientView;
import carom.game.Games;
import carom.net.protocol.ServerMessage.RosterEntry;
import carom.sim.Game;
import carom.sim.MatchClock;
import carom.sim.match.MatchPhase;
import com.badlogic.gdx.math.Vector3;
import java.util.List;

/**
 * Shows what a match is at, at the top of the picture: players it waits for, countdown, time left,
 * result. Nothing for a game without a {@link MatchClock}. Render thread only.
 */
public final class ClockPanel {
  private static final float TOP = 30;

  /** Height of the result with its distance from the window's upper edge, points. */
  public static final float RESULT = 140;

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
      case OVER -> result(result(match, view), seconds);
    }
  }

  /** Returns whether the result of a match shows, so that the table of players belongs below it. */
  public boolean isOver(ClientView view) {
    return clock != null && view.knowsFields() && MatchClock.phase(view.match()) == MatchPhase.OVER;
  }

  /** Draws the result across the window. */
  private void result(String text, int seconds) {
    float height = hud.height();
    boolean fits = hud.width(fonts.title(), text) < hud.windowWidth() - 40;
    hud.panel(-2, height - RESULT, hud.windowWidth() + 4, RESULT - 16, Theme.DIALOG);
    hud.begin();
    at.set(hud.windowWidth() / 2f, height - (fits ? 30 : 48), 0);
    hud.centred(fits ? fonts.title() : fonts.large(), text, at.x, at.y, Theme.ACCENT);
    String next = seconds < 0 ? "" : "next match in " + seconds + " s";
    hud.centred(fonts.text(), next, at.x, height - RESULT + 30, Theme.TEXT);
    hud.end();
  }

  /** Draws a line at the top, or a large word in the middle. */
  private void line(String text, boolean large) {
    if (text.isEmpty()) {
      return;
    }
    if (!large) {
      float half = hud.width(fonts.text(), text) / 2 + 14;
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
    int winner = MatchClock.winner(match);
    if (winner >= 0 && winner == view.playerId()) {
      return "You win!";
    }
    String player = view.playerName(winner);
    return player.isEmpty() ? "Nobody wins" : player + " wins!";
  }
}
