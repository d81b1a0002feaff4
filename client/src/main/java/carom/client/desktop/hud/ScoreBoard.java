package carom.client.desktop.hud;

import carom.client.desktop.paint.Canvas;
import carom.client.desktop.paint.Fonts;
import carom.client.desktop.paint.UiColours;
import carom.client.view.ClientView;
import carom.net.protocol.ServerMessage.RosterEntry;
import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.graphics.g2d.BitmapFont;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * The table of all who are here, while Tab is held and when a match is over. It has each team in
 * its colour with its score, its players with score, standing and ping, then spectators. Render
 * thread only.
 */
public final class ScoreBoard {
  private static final float PAD = 14;
  private static final float LINE = 22;
  private static final float WIDTH = 560;
  private static final float SWATCH = 12;

  private static final Comparator<RosterEntry> ORDER =
      Comparator.comparing(RosterEntry::spectator)
          .thenComparing(RosterEntry::team)
          .thenComparing(RosterEntry::score, Comparator.reverseOrder())
          .thenComparing(RosterEntry::playerId);

  private final Hud hud;
  private final Canvas canvas;
  private final Fonts fonts;
  private final ShownGame game;
  private final List<RosterEntry> rows = new ArrayList<>();

  /** Lines of the table: rows by their number, or -1 - team for the heading of a team. */
  private final List<Integer> lines = new ArrayList<>();

  /** Creates a table. The arguments stay the property of the caller. */
  public ScoreBoard(Hud hud, Canvas canvas, Fonts fonts, ShownGame game) {
    this.hud = hud;
    this.canvas = canvas;
    this.fonts = fonts;
    this.game = game;
  }

  /**
   * Draws the table in the middle of the window, or lower; nothing without players.
   *
   * @param above height at the window's top that stays free, points
   */
  public void draw(ClientView view, float above) {
    rows.clear();
    rows.addAll(view.players());
    rows.sort(ORDER);
    if (rows.isEmpty()) {
      return;
    }
    String keys = keys(view);
    float room = hud.height() - above - 2 * PAD;
    int most = Math.max(1, (int) ((room - 3 * PAD) / LINE) - 2);
    int shown = arrange(view, most);
    float w = Math.min(WIDTH, hud.windowWidth() - 2 * PAD);
    float h = (lines.size() + (keys.isEmpty() ? 1 : 2)) * LINE + 2 * PAD;
    float x = (hud.windowWidth() - w) / 2;
    float top = Math.min((hud.height() + h) / 2, hud.height() - above - PAD);
    hud.panel(x, top - h, w, h, UiColours.DIALOG);
    hud.layout().take(x, top - h, w, h);
    swatches(x, top - PAD - LINE);
    hud.begin();
    float y = top - PAD;
    row(x, w, y, fonts.small(), UiColours.MUTED, title(rows.size(), shown), "Score", "", "Ping");
    for (int line : lines) {
      y -= LINE;
      if (line < 0) {
        heading(view, x, w, y, -1 - line);
      } else {
        player(view, x, w, y, rows.get(line));
      }
    }
    hud.left(fonts.small(), keys, x + PAD, y - LINE - 4, UiColours.MUTED);
    hud.end();
  }

  /** Chooses the lines that fit, the own player among them. Returns how many players they show. */
  private int arrange(ClientView view, int most) {
    lines.clear();
    int team = 0;
    int shown = 0;
    int ownLine = -1;
    for (int i = 0; i < rows.size(); i++) {
      RosterEntry entry = rows.get(i);
      boolean heads = game.teamCount() > 0 && !entry.spectator() && entry.team() != team;
      if (heads) {
        team = entry.team();
        lines.add(-1 - team);
      }
      ownLine = entry.playerId() == view.playerId() ? lines.size() : ownLine;
      lines.add(i);
    }
    if (lines.size() > most) {
      int last = ownLine >= most ? lines.get(ownLine) : lines.get(most - 1);
      lines.subList(most - 1, lines.size()).clear();
      lines.add(last);
    }
    for (int line : lines) {
      shown += line >= 0 ? 1 : 0;
    }
    return shown;
  }

  private void swatches(float x, float top) {
    hud.beginFigures();
    for (int i = 0; i < lines.size(); i++) {
      if (lines.get(i) < 0) {
        Color color = game.teamColor(-1 - lines.get(i));
        canvas.rect(x + PAD, top - i * LINE - SWATCH, SWATCH, SWATCH, color);
      }
    }
    canvas.end();
  }

  private void heading(ClientView view, float x, float w, float y, int team) {
    String score = game.hasTeamScore() ? Integer.toString(game.teamScore(view, team)) : "";
    row(x, w, y, fonts.text(), game.teamColor(team), "     " + game.team(team), score);
  }

  private void player(ClientView view, float x, float w, float y, RosterEntry entry) {
    boolean own = entry.playerId() == view.playerId();
    Color tint = own ? UiColours.ACCENT : entry.alive() ? UiColours.TEXT : UiColours.MUTED;
    String ping = entry.pingMs() == 0 ? "-" : entry.pingMs() + " ms";
    String score = entry.spectator() ? "" : Integer.toString(entry.score());
    row(x, w, y, fonts.text(), tint, "     " + entry.name(), score, standing(entry), ping);
  }

  private static String title(int all, int shown) {
    String count = all == 1 ? "1 is here" : all + " are here";
    return shown < all ? count + ", " + shown + " of them below" : count;
  }

  private void row(float x, float w, float y, BitmapFont font, Color tint, String... cells) {
    float scale = w / WIDTH;
    float[] columns = {PAD, 330 * scale, 400 * scale, 485 * scale};
    for (int i = 0; i < cells.length; i++) {
      float room = (i + 1 < columns.length ? columns[i + 1] : w) - columns[i] - PAD / 2;
      hud.left(font, hud.cut(font, cells[i], room), x + columns[i], y, tint);
    }
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
    for (int team = 1; team <= Math.min(9, game.teamCount()) && !watches; team++) {
      keys.append("     ").append(team).append(": ").append(game.team(team));
    }
    return keys.toString();
  }
}
