package carom.client.desktop.hud;

import carom.client.desktop.paint.Fonts;
import carom.client.desktop.paint.Theme;
import carom.client.view.ClientView;
import carom.game.Games;
import carom.net.protocol.ServerMessage.RosterEntry;
import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.graphics.g2d.BitmapFont;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * The table of all who are here, while Tab is held: team, name, score, how they stand, ping.
 * Players come first, by team and score, then spectators. Render thread only.
 */
public final class ScoreBoard {
  private static final float PAD = 14;
  private static final float LINE = 22;
  private static final float WIDTH = 620;

  private static final Comparator<RosterEntry> ORDER =
      Comparator.comparing(RosterEntry::spectator)
          .thenComparing(RosterEntry::team)
          .thenComparing(RosterEntry::score, Comparator.reverseOrder())
          .thenComparing(RosterEntry::playerId);

  private final Hud hud;
  private final Fonts fonts;
  private final List<RosterEntry> rows = new ArrayList<>();
  private String teamsOf = "";
  private List<String> teams = List.of();

  /** Creates a table. The arguments stay the property of the caller. */
  public ScoreBoard(Hud hud, Fonts fonts) {
    this.hud = hud;
    this.fonts = fonts;
  }

  /** Returns the names of the teams of the game that is shown; the first is team 1. */
  public List<String> teams(ClientView view) {
    if (!view.game().equals(teamsOf)) {
      teamsOf = view.game();
      teams = Games.create(teamsOf).teams();
    }
    return teams;
  }

  /**
   * Draws the table in the middle of the window.
   *
   * @param above height at the window's top that stays free, points
   */
  public void draw(ClientView view, float above) {
    rows.clear();
    rows.addAll(view.players());
    rows.sort(ORDER);
    int most = Math.max(1, (int) ((hud.height() - above - 6 * PAD) / LINE) - 3);
    int shown = Math.min(rows.size(), most);
    float w = Math.min(WIDTH, hud.windowWidth() - 2 * PAD);
    float h = (shown + 2) * LINE + 3 * PAD;
    float x = (hud.windowWidth() - w) / 2;
    float top = (hud.height() - above + h) / 2;
    hud.panel(x, top - h, w, h, Theme.DIALOG);
    hud.begin();
    float y = top - PAD;
    row(
        x,
        w,
        y,
        fonts.small(),
        Theme.MUTED,
        "Team",
        title(rows.size(), shown),
        "Score",
        "",
        "Ping");
    for (int i = 0; i < shown; i++) {
      RosterEntry entry = rows.get(i);
      y -= LINE;
      boolean own = entry.playerId() == view.playerId();
      Color tint = own ? Theme.ACCENT : entry.alive() ? Theme.TEXT : Theme.MUTED;
      String ping = entry.pingMs() == 0 ? "-" : entry.pingMs() + " ms";
      String score = entry.spectator() ? "" : Integer.toString(entry.score());
      row(
          x,
          w,
          y,
          fonts.text(),
          tint,
          team(view, entry),
          entry.name(),
          score,
          standing(entry),
          ping);
    }
    hud.left(fonts.small(), keys(view), x + PAD, y - LINE - PAD, Theme.MUTED);
    hud.end();
  }

  private static String title(int all, int shown) {
    String count = all == 1 ? "1 is here" : all + " are here";
    return shown < all ? count + ", the first " + shown : count;
  }

  private void row(float x, float w, float y, BitmapFont font, Color tint, String... cells) {
    float scale = w / WIDTH;
    float[] columns = {PAD, 90 * scale, 400 * scale, 460 * scale, 545 * scale};
    for (int i = 0; i < cells.length; i++) {
      float room = (i + 1 < columns.length ? columns[i + 1] : w) - columns[i] - PAD / 2;
      hud.left(font, hud.startOf(font, cells[i], room), x + columns[i], y, tint);
    }
  }

  private String team(ClientView view, RosterEntry entry) {
    int team = entry.team();
    List<String> names = teams(view);
    if (entry.spectator() || (names.isEmpty() && team == 0)) {
      return "";
    }
    return team >= 1 && team <= names.size() ? names.get(team - 1) : Integer.toString(team);
  }

  private static String standing(RosterEntry entry) {
    if (entry.spectator()) {
      return "watches";
    }
    return !entry.alive() ? "out" : entry.ready() ? "ready" : "";
  }

  private String keys(ClientView view) {
    RosterEntry own = view.participant(view.playerId());
    if (own == null) {
      return ""; // who looks at a replay presses other keys
    }
    boolean watches = own.spectator();
    StringBuilder keys = new StringBuilder(watches ? "P: play" : "P: watch     R: ready");
    for (int i = 0; i < Math.min(9, teams(view).size()) && !watches; i++) {
      keys.append("     ").append(i + 1).append(": ").append(teams(view).get(i));
    }
    return keys.toString();
  }
}
