package carom.client.desktop;

import carom.client.ClientView;
import carom.client.ClientView.Drawn;
import carom.client.ConnectionPhase;
import carom.net.protocol.ServerMessage.RosterEntry;
import carom.sim.Appearance;
import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.graphics.g2d.BitmapFont;
import com.badlogic.gdx.graphics.g2d.GlyphLayout;
import com.badlogic.gdx.graphics.g2d.SpriteBatch;
import com.badlogic.gdx.math.MathUtils;
import com.badlogic.gdx.math.Vector3;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * Text and panels over the picture: names, scores, what the server said, what the connection is up
 * to, key hints. In pixels, origin bottom left. Render thread only.
 */
final class Hud {
  private static final int SHORT_LIST = 5;
  private static final int LONG_LIST = 24;
  private static final float PAD = 12;
  private static final float LINE = 22;
  private static final long NOTICE_NS = 4_000_000_000L;
  private static final float HINT_SECONDS = 12;

  private final Canvas canvas;
  private final SpriteBatch batch;
  private final Fonts fonts;
  private final GlyphLayout layout = new GlyphLayout();
  private final Color color = new Color();
  private final Color shadow = new Color();
  private final List<RosterEntry> ranking = new ArrayList<>();

  Hud(Canvas canvas, SpriteBatch batch, Fonts fonts) {
    this.canvas = canvas;
    this.batch = batch;
    this.fonts = fonts;
  }

  /** Names above the players' bodies. */
  void names(ClientView view, ViewCamera camera, float pixelsPerMetre) {
    batch.begin();
    for (int i = 0; i < view.entityCount(); i++) {
      Drawn drawn = view.entity(i);
      if (drawn.archetype().appearance().look() != Appearance.Look.PLAYER || drawn == view.own()) {
        continue;
      }
      String name = view.playerName(drawn.ownerId());
      Vector3 at = camera.toScreen(drawn.x(), drawn.y());
      color.set(Theme.TEXT).a = 0.85f * drawn.alpha();
      centred(fonts.small, name, at.x, at.y + pixelsPerMetre * 0.75f + 16, color);
    }
    batch.end();
  }

  /** The players by score: a few of them, or on demand many. */
  void scores(ClientView view, int width, int height, boolean all) {
    ranking.clear();
    ranking.addAll(view.players());
    ranking.sort(
        Comparator.comparingInt(RosterEntry::score)
            .reversed()
            .thenComparing(RosterEntry::playerId));
    int shown = Math.min(ranking.size(), all ? LONG_LIST : SHORT_LIST);
    if (shown == 0) {
      return;
    }
    float w = 220;
    float h = shown * LINE + 2 * PAD + LINE;
    float x = width - w - PAD;
    float top = height - PAD;
    panel(x, top - h, w, h);
    batch.begin();
    left(
        fonts.small,
        view.players().size() + (all ? " players" : " players   Tab: all"),
        x + PAD,
        top - PAD,
        Theme.MUTED);
    for (int i = 0; i < shown; i++) {
      RosterEntry entry = ranking.get(i);
      boolean own = entry.playerId() == view.playerId();
      float y = top - PAD - (i + 1) * LINE;
      left(fonts.text, (i + 1) + "  " + entry.name(), x + PAD, y, own ? Theme.ACCENT : Theme.TEXT);
      String score = Integer.toString(entry.score());
      layout.setText(fonts.text, score);
      left(fonts.text, score, x + w - PAD - layout.width, y, own ? Theme.ACCENT : Theme.TEXT);
    }
    batch.end();
  }

  /** What the server announced in the last seconds, newest on top, fading. */
  void notices(ClientView view, long nowNs, int width, int height) {
    batch.begin();
    float y = height - 70;
    for (int i = view.notices().size() - 1; i >= 0; i--) {
      ClientView.Notice notice = view.notices().get(i);
      float left = 1 - (nowNs - notice.arrivedNs()) / (float) NOTICE_NS;
      if (left <= 0) {
        break;
      }
      color.set(Theme.TEXT).a = Math.min(1, left * 3);
      centred(fonts.large, notice.text(), width / 2f, y, color);
      y -= 32;
    }
    batch.end();
  }

  /** The keys, for the first seconds. */
  void hints(float secondsPlayed, int width) {
    if (secondsPlayed > HINT_SECONDS) {
      return;
    }
    batch.begin();
    color.set(Theme.TEXT).a = Math.min(1, HINT_SECONDS - secondsPlayed) * 0.85f;
    centred(
        fonts.text,
        "WASD or arrows: move     mouse: aim     Space: act     F3: net graph     F4: debug    "
            + " Esc: leave",
        width / 2f,
        PAD + 18,
        color);
    batch.end();
  }

  /** What the connection is doing while there is no game to play. */
  void phase(ClientView view, int width, int height) {
    ConnectionPhase phase = view.phase();
    if (phase == ConnectionPhase.PLAYING) {
      return;
    }
    layout.setText(fonts.text, view.message());
    float w = Math.max(360, layout.width + 4 * PAD);
    float h = 110;
    float x = (width - w) / 2;
    float y = (height - h) / 2;
    panel(x, y, w, h);
    if (phase == ConnectionPhase.LOADING) {
      canvas.begin(batch.getProjectionMatrix(), 1);
      canvas.rect(x + PAD, y + PAD, w - 2 * PAD, 4, Theme.PANEL_LINE);
      canvas.rect(
          x + PAD, y + PAD, (w - 2 * PAD) * (float) view.loadingProgress(), 4, Theme.ACCENT);
      canvas.end();
    }
    batch.begin();
    centred(fonts.large, title(phase), width / 2f, y + h - 22, Theme.TEXT);
    centred(fonts.text, view.message(), width / 2f, y + 46, Theme.MUTED);
    batch.end();
  }

  private static String title(ConnectionPhase phase) {
    return switch (phase) {
      case IDLE, CONNECTING -> "Connecting";
      case JOINING -> "Joining";
      case LOADING -> "Loading the level";
      case RECONNECTING -> "Reconnecting";
      case ENDED -> "Disconnected";
      case PLAYING -> "";
    };
  }

  /** A dark panel with a thin edge. */
  void panel(float x, float y, float w, float h) {
    canvas.begin(batch.getProjectionMatrix(), 1);
    canvas.rect(x, y, w, h, Theme.PANEL);
    canvas.line(x, y, x + w, y, 1, Theme.PANEL_LINE);
    canvas.line(x, y + h, x + w, y + h, 1, Theme.PANEL_LINE);
    canvas.line(x, y, x, y + h, 1, Theme.PANEL_LINE);
    canvas.line(x + w, y, x + w, y + h, 1, Theme.PANEL_LINE);
    canvas.end();
  }

  /**
   * Text that starts at x; y is the top of the capitals. Between {@code batch.begin} and {@code
   * end}.
   */
  void left(BitmapFont font, String text, float x, float y, Color tint) {
    font.setColor(tint);
    font.draw(batch, text, MathUtils.round(x), MathUtils.round(y));
  }

  /** Text around x, with a shadow that keeps it legible on any ground. */
  private void centred(BitmapFont font, String text, float x, float y, Color tint) {
    layout.setText(font, text);
    shadow.set(0, 0, 0, 0.6f * tint.a);
    left(font, text, x - layout.width / 2 + 1, y - 1, shadow);
    left(font, text, x - layout.width / 2, y, tint);
  }
}
