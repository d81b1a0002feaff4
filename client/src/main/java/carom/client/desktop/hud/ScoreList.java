package carom.client.desktop.hud;

import carom.client.desktop.hud.HudLayout.Panel;
import carom.client.desktop.hud.HudLayout.Spot;
import carom.client.desktop.paint.Canvas;
import carom.client.desktop.paint.Fonts;
import carom.client.desktop.paint.UiColours;
import carom.client.view.ClientView;
import carom.net.protocol.ServerMessage.RosterEntry;
import com.badlogic.gdx.graphics.Color;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * The few best players by score, always with the own one, in a corner. Render thread only. Ranks
 * are those of a game without teams: players of equal score share one.
 */
public final class ScoreList {
  private static final int MOST = 5;
  private static final float WIDTH = 190;
  private static final float PAD = 10;
  private static final float LINE = 21;
  private static final float SWATCH = 10;

  private static final Comparator<RosterEntry> BEST_FIRST =
      Comparator.comparingInt(RosterEntry::score).reversed().thenComparing(RosterEntry::playerId);

  private final Hud hud;
  private final Canvas canvas;
  private final Fonts fonts;
  private final ShownGame game;
  private final PlayerColours colours;
  private final Color own = new Color();
  private final Panel panel = new Panel(Spot.TOP_RIGHT, Spot.TOP_LEFT, Spot.BOTTOM_RIGHT);
  private final List<RosterEntry> ranking = new ArrayList<>();

  /** Creates a list. The arguments stay the property of the caller. */
  public ScoreList(Hud hud, Canvas canvas, Fonts fonts, ShownGame game, PlayerColours colours) {
    this.colours = colours;
    this.hud = hud;
    this.canvas = canvas;
    this.fonts = fonts;
    this.game = game;
  }

  /** Draws the list, if there are players and a corner is free. */
  public void draw(ClientView view) {
    rank(view);
    int shown = Math.min(ranking.size(), MOST);
    float h = (shown + 1) * LINE + 2 * PAD - 4;
    if (shown == 0 || !hud.layout().place(panel, WIDTH, h)) {
      return;
    }
    float x = panel.x();
    float top = panel.y() + h;
    hud.panel(x, panel.y(), WIDTH, h);
    hud.beginFigures();
    for (int i = 0; i < shown; i++) {
      Color color = color(entry(view, i, shown));
      canvas.rect(x + PAD, top - PAD - (i + 1) * LINE - SWATCH - 1, SWATCH, SWATCH, color);
    }
    canvas.end();
    hud.begin();
    String count = ranking.size() == 1 ? "1 player" : ranking.size() + " players";
    String more = ranking.size() > shown ? "    Tab: all" : "";
    hud.left(fonts.small(), count + more, x + PAD, top - PAD, UiColours.MUTED);
    for (int i = 0; i < shown; i++) {
      line(view, entry(view, i, shown), x, top - PAD - (i + 1) * LINE);
    }
    hud.end();
  }

  /** Returns the colour of a player's team or, without teams, of its body. */
  private Color color(RosterEntry entry) {
    if (game.teamCount() > 0) {
      return game.teamColor(entry.team());
    }
    int rgb = colours.rgb(entry.playerId());
    return rgb < 0 ? own.set(Color.CLEAR) : UiColours.shade(rgb, 1, 1, own);
  }

  private void rank(ClientView view) {
    ranking.clear();
    for (RosterEntry entry : view.players()) {
      if (!entry.spectator()) {
        ranking.add(entry);
      }
    }
    ranking.sort(BEST_FIRST);
  }

  /** Returns the player of a line; the own one has the last if it isn't among the best. */
  private RosterEntry entry(ClientView view, int line, int shown) {
    RosterEntry own = view.participant(view.playerId());
    boolean hidden = line == shown - 1 && own != null && ranking.indexOf(own) >= shown;
    return hidden ? own : ranking.get(line);
  }

  private void line(ClientView view, RosterEntry entry, float x, float y) {
    Color tint = entry.playerId() == view.playerId() ? UiColours.ACCENT : UiColours.TEXT;
    String score = Integer.toString(entry.score());
    float scoreX = x + WIDTH - PAD - hud.width(fonts.text(), score);
    hud.left(fonts.text(), score, scoreX, y, tint);
    float nameX = x + PAD + SWATCH + 8;
    if (game.teamCount() == 0) {
      String rank = entry.score() > 0 ? Integer.toString(rankOf(ranking, entry)) : "";
      hud.left(fonts.text(), rank, nameX, y, UiColours.MUTED);
      nameX += 24;
    }
    hud.left(fonts.text(), hud.cut(fonts.text(), entry.name(), scoreX - 8 - nameX), nameX, y, tint);
  }

  /** Returns a player's rank: one more than there are players with a higher score. */
  static int rankOf(List<RosterEntry> players, RosterEntry entry) {
    int rank = 1;
    for (RosterEntry other : players) {
      rank += !other.spectator() && other.score() > entry.score() ? 1 : 0;
    }
    return rank;
  }
}
