package carom.client.desktop.hud;

import carom.client.desktop.hud.HudLayout.Panel;
import carom.client.desktop.hud.HudLayout.Spot;
import carom.client.desktop.paint.Canvas;
import carom.client.desktop.paint.Fonts;
import carom.client.desktop.paint.UiColours;
import carom.client.field.FieldView;
import carom.client.view.ClientView;
import carom.net.protocol.ServerMessage.RosterEntry;
import carom.sim.MatchClock;
import carom.sim.MatchPhase;
import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.graphics.g2d.BitmapFont;
import com.badlogic.gdx.math.Vector3;
import java.util.List;
import java.util.function.UnaryOperator;

/**
 * Shows what a match is at, at the top of the picture: players it waits for, countdown, time left
 * and the teams' scores, result. Nothing for a game without {@link MatchClock}, clock and scores.
 * Render thread only.
 */
public final class ClockPanel {
  private static final float LINE = 30;
  private static final float PAD = 14;
  private static final float SWATCH = 12;

  /** Height of the result with its distance from the window's upper edge, points. */
  private static final float RESULT = 150;

  private final Hud hud;
  private final Canvas canvas;
  private final Fonts fonts;
  private final ShownGame game;
  private final Panel panel = new Panel(Spot.TOP);
  private final Vector3 at = new Vector3();
  private UnaryOperator<String> adviceAlone = room -> "";
  private float depth;

  /** Creates a panel. The arguments stay the property of the caller. */
  public ClockPanel(Hud hud, Canvas canvas, Fonts fonts, ShownGame game) {
    this.hud = hud;
    this.canvas = canvas;
    this.fonts = fonts;
    this.game = game;
  }

  /** Sets what a player is told who waits alone in a room, by its name; empty for nothing. */
  public void adviceAlone(UnaryOperator<String> ofRoom) {
    adviceAlone = ofRoom;
  }

  /** Returns the height at the window's upper edge that was drawn on last, points. */
  public float depth() {
    return depth;
  }

  /** Draws the phase of the match that a client plays or a replay shows. */
  public void draw(ClientView view) {
    depth = 0;
    if (!view.knowsFields()) {
      return;
    }
    MatchClock clock = game.clock();
    int ticks = clock == null ? game.ownClockTicks(view) : MatchClock.ticksLeft(view.match());
    int seconds = ticks < 0 ? -1 : (ticks + view.tickRate() - 1) / view.tickRate();
    MatchPhase phase = clock == null ? MatchPhase.PLAYING : MatchClock.phase(view.match());
    switch (phase) {
      case WARM_UP -> {
        boolean alone = view.players().size() == 1 && clock.playersToBegin() > 1;
        String text =
            Readiness.waits(view, clock)
                ? "Warm-up: move, or Tab and R, to begin"
                : warmUp(clock, view.players());
        line(view, text, alone ? adviceAlone.apply(view.room()) : "");
      }
      case COUNTDOWN -> {
        at.set(hud.windowWidth() / 2f, hud.height() * 0.6f, 0);
        hud.begin();
        hud.floating(Integer.toString(seconds), at, true, UiColours.ACCENT);
        hud.end();
      }
      case PLAYING -> line(view, seconds < 0 ? "" : time(seconds), "");
      case OVER -> result(view, seconds);
    }
  }

  /** Returns whether the result of a match shows, so that the table of players belongs below it. */
  public boolean isOver(ClientView view) {
    return game.clock() != null
        && view.knowsFields()
        && MatchClock.phase(view.match()) == MatchPhase.OVER;
  }

  /** Draws the time, with the teams' scores around it, and a line of advice below. */
  private void line(ClientView view, String text, String below) {
    int teams = game.hasTeamScore() ? game.teamCount() : 0;
    float w = 2 * PAD + (text.isEmpty() ? 0 : hud.width(fonts.text(), text));
    for (int team = 1; team <= teams; team++) {
      w += score(view, team) + PAD;
    }
    float wide = below.isEmpty() ? w : Math.max(w, hud.width(fonts.small(), below) + 2 * PAD);
    float h = below.isEmpty() ? LINE : LINE + 20;
    if ((text.isEmpty() && teams == 0) || !hud.layout().placeAnyhow(panel, wide, h)) {
      return;
    }
    hud.panel(panel.x(), panel.y(), wide, h);
    depth = hud.height() - panel.y();
    float x = panel.x() + (wide - w) / 2 + PAD;
    float top = panel.y() + h - 9;
    for (int team = 1; team <= (teams + 1) / 2; team++) {
      x = drawScore(view, team, x, top);
    }
    hud.begin();
    hud.left(fonts.text(), text, x, top, UiColours.TEXT);
    hud.left(
        fonts.small(),
        below,
        panel.x() + (wide - hud.width(fonts.small(), below)) / 2,
        top - 21,
        UiColours.ACCENT);
    hud.end();
    x += text.isEmpty() ? 0 : hud.width(fonts.text(), text) + PAD;
    for (int team = (teams + 1) / 2 + 1; team <= teams; team++) {
      x = drawScore(view, team, x, top);
    }
  }

  private String scoreText(ClientView view, int team) {
    return game.team(team) + "  " + game.teamScore(view, team);
  }

  /** Returns the width of a team's score, points. */
  private float score(ClientView view, int team) {
    return SWATCH + 6 + hud.width(fonts.text(), scoreText(view, team));
  }

  /** Draws a team's score; returns where the next begins. */
  private float drawScore(ClientView view, int team, float x, float top) {
    hud.beginFigures();
    canvas.rect(x, top - SWATCH, SWATCH, SWATCH, game.teamColor(team));
    canvas.end();
    hud.begin();
    hud.left(fonts.text(), scoreText(view, team), x + SWATCH + 6, top, UiColours.TEXT);
    hud.end();
    return x + score(view, team) + PAD;
  }

  /** Draws the result across the window: who won, how, and what comes next. */
  private void result(ClientView view, int seconds) {
    float height = hud.height();
    String text = winner(view);
    String how = how(view);
    boolean fits = hud.width(fonts.title(), text) < hud.windowWidth() - 40;
    BitmapFont font = fits ? fonts.title() : fonts.large();
    int team = MatchClock.winningTeam(view.match());
    hud.panel(-2, height - RESULT, hud.windowWidth() + 4, RESULT - 8, UiColours.DIALOG);
    hud.layout().take(0, height - RESULT, hud.windowWidth(), RESULT);
    depth = RESULT;
    hud.begin();
    float x = hud.windowWidth() / 2f;
    Color tint = team > 0 ? game.teamColor(team) : UiColours.ACCENT;
    hud.centred(font, text, x, height - (fits ? 26 : 44), tint);
    hud.centred(fonts.large(), how, x, height - RESULT + 60, UiColours.TEXT);
    String next = seconds < 0 ? "" : "The next match begins in " + seconds + " s";
    hud.centred(fonts.text(), next, x, height - RESULT + 28, UiColours.MUTED);
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

  private String winner(ClientView view) {
    FieldView match = view.match();
    int team = MatchClock.winningTeam(match);
    if (team > 0) {
      return game.team(team) + " wins!";
    }
    int winner = MatchClock.winner(match);
    if (winner >= 0 && winner == view.playerId()) {
      return "You win!";
    }
    String player = view.playerName(winner);
    return player.isEmpty() ? "A draw" : player + " wins!";
  }

  /** Returns the teams' scores, or how the own player did. */
  private String how(ClientView view) {
    RosterEntry own = view.participant(view.playerId());
    boolean played = own != null && !own.spectator();
    if (!game.hasTeamScore()) {
      int rank = played ? ScoreList.rankOf(view.players(), own) : 0;
      return played ? "You are number " + rank + " with a score of " + own.score() : "";
    }
    StringBuilder text = new StringBuilder();
    for (int team = 1; team <= game.teamCount(); team++) {
      text.append(team == 1 ? "" : " : ").append(game.teamScore(view, team));
    }
    int winner = MatchClock.winningTeam(view.match());
    if (played && winner > 0) {
      text.append(own.team() == winner ? "    Your team wins" : "    Your team loses");
    }
    return text.toString();
  }
}
