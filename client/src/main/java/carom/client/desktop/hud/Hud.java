package carom.client.desktop.hud;

import carom.client.desktop.paint.Canvas;
import carom.client.desktop.paint.Fonts;
import carom.client.desktop.paint.Theme;
import carom.client.desktop.paint.ViewCamera;
import carom.client.link.ConnectionPhase;
import carom.client.view.ClientView;
import carom.client.view.ClientView.Drawn;
import carom.net.protocol.Limits;
import carom.net.protocol.ServerMessage.RosterEntry;
import carom.sim.level.Appearance;
import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.graphics.g2d.BitmapFont;
import com.badlogic.gdx.graphics.g2d.GlyphLayout;
import com.badlogic.gdx.graphics.g2d.SpriteBatch;
import com.badlogic.gdx.math.MathUtils;
import com.badlogic.gdx.math.Matrix4;
import com.badlogic.gdx.math.Vector3;
import com.badlogic.gdx.utils.Align;
import com.badlogic.gdx.utils.Disposable;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * Text and panels over the picture: names, scores, notices, the state of the connection, key hints.
 * Units are points (see {@link Fonts}), origin bottom left. Render thread only.
 */
public final class Hud implements Disposable {
  private static final int SHORT_LIST = 5;
  private static final float PAD = 12;
  private static final float LINE = 22;
  private static final long NOTICE_NS = 4_000_000_000L;
  private static final float ANSWER_SECONDS = 1.5f;

  private final Canvas canvas;
  private final SpriteBatch batch = new SpriteBatch();
  private final Matrix4 points = new Matrix4();
  private final Fonts fonts;
  private final GlyphLayout layout = new GlyphLayout();
  private final Color color = new Color();
  private final Color shadow = new Color();
  private final List<RosterEntry> ranking = new ArrayList<>();
  private final GlyphLayout wrapped = new GlyphLayout();
  private final FreePlaces places = new FreePlaces();
  private final NameRows names = new NameRows(places, Limits.MAX_PLAYERS);
  private String answer = "";
  private float answerSeconds;
  private float scale = 1;
  private float width;
  private float height;

  /** Creates a HUD. The canvas and the fonts stay the property of the caller. */
  public Hud(Canvas canvas, Fonts fonts) {
    this.canvas = canvas;
    this.fonts = fonts;
  }

  /** Sets the window's size, px; call it once per frame, before anything else. */
  public void size(int newWidth, int newHeight) {
    scale = fonts.scale();
    width = newWidth / scale;
    height = newHeight / scale;
    points.setToOrtho2D(0, 0, width, height);
    batch.setProjectionMatrix(points);
  }

  /** Returns the window's height, points. */
  public float height() {
    return height;
  }

  /** Returns the window's width, points. */
  public float windowWidth() {
    return width;
  }

  /** Returns the pixels of a point. */
  float pixelsPerPoint() {
    return scale;
  }

  /** Begins figures in points, origin bottom left; end them by the canvas. */
  public void beginFigures() {
    canvas.begin(points, scale);
  }

  /** Returns the place of a position in the world, points. The result is reused. */
  public Vector3 at(ViewCamera camera, float x, float y) {
    return camera.toScreen(x, y).scl(1 / scale);
  }

  /** Returns the nearest place at which a glyph's edge meets a pixel's. */
  private float snap(float at) {
    return MathUtils.round(at * scale) / scale;
  }

  /**
   * Starts a batch of text; {@link #left} and {@link #floating} stand between this and {@link
   * #end}.
   */
  public void begin() {
    batch.begin();
  }

  /** Ends the batch of text. */
  public void end() {
    batch.end();
  }

  /**
   * Draws names above the players' bodies, in rows where bodies are close together. A name without
   * room, or where the last frame had a panel, isn't drawn.
   */
  public void names(ClientView view, ViewCamera camera, float pixelsPerMetre) {
    batch.begin();
    for (int i = 0; i < view.entityCount(); i++) {
      Drawn drawn = view.entity(i);
      if (drawn.archetype().appearance().look() != Appearance.Look.PLAYER || drawn == view.own()) {
        continue;
      }
      Vector3 at = at(camera, drawn.x(), drawn.y());
      color.set(Theme.TEXT).a = 0.85f * drawn.alpha();
      name(
          drawn.ownerId(),
          view.playerName(drawn.ownerId()),
          at.x,
          at.y + pixelsPerMetre / scale * 0.75f + 16);
    }
    batch.end();
    places.clear();
  }

  /** Draws a name around x with its upper edge at y, or higher if that place is taken. */
  private void name(int player, String text, float x, float y) {
    layout.setText(fonts.small(), text);
    float top = names.top(player, x, y, layout.width);
    if (!Float.isNaN(top)) {
      centred(fonts.small(), text, x, top, color);
    }
  }

  /** Draws a word around a place on the screen. */
  public void floating(String text, Vector3 at, boolean large, Color textColor) {
    centred(large ? fonts.title() : fonts.text(), text, at.x, at.y, textColor);
  }

  /** Draws the few best players by score, always including the own one. */
  public void scores(ClientView view) {
    ranking.clear();
    for (RosterEntry entry : view.players()) {
      if (!entry.spectator()) {
        ranking.add(entry);
      }
    }
    ranking.sort(
        Comparator.comparingInt(RosterEntry::score)
            .reversed()
            .thenComparing(RosterEntry::playerId));
    int shown = Math.min(ranking.size(), SHORT_LIST);
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
        fonts.small(),
        ranking.size() == 1
            ? "1 player"
            : ranking.size() + (ranking.size() == shown ? " players" : " players   Tab: all"),
        x + PAD,
        top - PAD,
        Theme.MUTED);
    for (int i = 0; i < shown; i++) {
      int rank = i == shown - 1 ? Math.max(i, rank(view.playerId())) : i;
      RosterEntry entry = ranking.get(rank);
      boolean own = entry.playerId() == view.playerId();
      float y = top - PAD - (i + 1) * LINE;
      Color tint = own ? Theme.ACCENT : Theme.TEXT;
      String score = Integer.toString(entry.score());
      layout.setText(fonts.text(), score);
      float room = w - 3 * PAD - layout.width;
      left(fonts.text(), score, x + w - PAD - layout.width, y, tint);
      String name = (rank + 1) + "  " + entry.name();
      layout.setText(fonts.text(), name, 0, name.length(), tint, room, Align.left, false, "...");
      fonts.text().draw(batch, layout, snap(x + PAD), snap(y));
    }
    batch.end();
  }

  /** Returns the rank of a player, or -1. */
  private int rank(int playerId) {
    for (int i = 0; i < ranking.size(); i++) {
      if (ranking.get(i).playerId() == playerId) {
        return i;
      }
    }
    return -1;
  }

  /**
   * Draws the notices of the last seconds, newest on top, fading.
   *
   * @param below distance from the window's upper edge that others need, points
   */
  public void notices(ClientView view, long nowNs, float below) {
    batch.begin();
    float y = height - Math.max(70, below);
    for (int i = view.notices().size() - 1; i >= 0; i--) {
      ClientView.Notice notice = view.notices().get(i);
      float left = 1 - (nowNs - notice.arrivedNs()) / (float) NOTICE_NS;
      if (left <= 0) {
        break;
      }
      color.set(Theme.TEXT).a = Math.min(1, left * 3);
      centred(fonts.large(), notice.text(), width / 2f, y, color);
      y -= 32;
    }
    batch.end();
  }

  /** Shows a few words for a moment, as the answer to a key. */
  public void showAnswer(String text) {
    answer = text;
    answerSeconds = ANSWER_SECONDS;
  }

  /** Draws the answer to the last key while it shows. */
  public void drawAnswer(float seconds) {
    if (answerSeconds > 0) {
      batch.begin();
      color.set(Theme.TEXT).a = Math.min(1, 3 * answerSeconds);
      centred(fonts.large(), answer, width / 2f, height / 3f, color);
      batch.end();
      answerSeconds -= seconds;
    }
  }

  /**
   * Draws lines in the middle that are broken where the window ends, from a height upwards. Stands
   * between {@link #begin} and {@link #end}.
   *
   * @return the upper edge of the first line
   */
  float paragraph(BitmapFont font, String text, float bottom, Color tint) {
    float room = width - 4 * PAD;
    shadow.set(0, 0, 0, 0.6f * tint.a);
    wrapped.setText(font, text, shadow, room, Align.center, true);
    float top = snap(bottom + wrapped.height);
    font.draw(batch, wrapped, 2 * PAD + 1, top - 1);
    wrapped.setText(font, text, tint, room, Align.center, true);
    font.draw(batch, wrapped, 2 * PAD, top);
    return top;
  }

  /** Draws that the player has no body, and which player the picture follows meanwhile. */
  public void bodiless(ClientView view) {
    RosterEntry own = view.participant(view.playerId());
    boolean spectator = own != null && own.spectator();
    int watched = view.watchedPlayer();
    batch.begin();
    if (watched >= 0) {
      String keys = spectator ? "A, D: another     Tab and P: play" : "A, D: another";
      float y = height - 120;
      centred(fonts.large(), "Watching " + view.playerName(watched), width / 2f, y, Theme.TEXT);
      centred(fonts.small(), keys, width / 2f, y - 30, Theme.MUTED);
    } else {
      String text = spectator ? "You watch. Nobody plays" : "You are back in a moment";
      centred(fonts.large(), text, width / 2f, height / 2f, Theme.TEXT);
    }
    batch.end();
  }

  /** Draws what the connection is doing while there is no game to play. */
  public void phase(ClientView view) {
    ConnectionPhase phase = view.phase();
    veil();
    float w = Math.min(width - 2 * PAD, 560);
    wrapped.setText(fonts.text(), view.message(), Theme.MUTED, w - 4 * PAD, Align.center, true);
    float h = 90 + wrapped.height;
    float x = (width - w) / 2;
    float y = (height - h) / 2;
    panel(x, y, w, h, Theme.DIALOG);
    if (phase == ConnectionPhase.LOADING) {
      float bar = (w - 2 * PAD) * (float) view.loadingProgress();
      beginFigures();
      canvas.rect(x + PAD, y + PAD, w - 2 * PAD, 4, Theme.PANEL_LINE);
      canvas.rect(x + PAD, y + PAD, bar, 4, Theme.ACCENT);
      canvas.end();
    }
    batch.begin();
    fonts.text().draw(batch, wrapped, x + 2 * PAD, y + wrapped.height + 26);
    centred(fonts.large(), title(phase), width / 2f, y + h - 18, Theme.TEXT);
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

  /** Darkens everything, because the picture isn't the present. */
  public void veil() {
    beginFigures();
    canvas.rect(0, 0, width, height, Theme.VEIL);
    canvas.end();
  }

  /** Draws a dark, translucent panel with a thin edge. */
  public void panel(float x, float y, float w, float h) {
    panel(x, y, w, h, Theme.PANEL);
  }

  /** Draws a panel on a ground of another colour. */
  public void panel(float x, float y, float w, float h, Color ground) {
    places.take(x, y, w, h);
    beginFigures();
    canvas.rect(x, y, w, h, ground);
    canvas.frame(x, y, w, h, 1, Theme.PANEL_LINE);
    canvas.end();
  }

  /** Returns the width of a text, points. */
  public float width(BitmapFont font, String text) {
    layout.setText(font, text);
    return layout.width;
  }

  /**
   * Draws text that starts at x; y is the top of the capitals. Stands between {@link #begin} and
   * {@link #end}.
   */
  public void left(BitmapFont font, String text, float x, float y, Color tint) {
    font.setColor(tint);
    font.draw(batch, text, snap(x), snap(y));
  }

  /** Draws text as {@link #left} does, with a shadow that keeps it legible on any ground. */
  public void shadowed(BitmapFont font, String text, float x, float y, Color tint) {
    shadow.set(0, 0, 0, 0.6f * tint.a);
    left(font, text, x + 1, y - 1, shadow);
    left(font, text, x, y, tint);
  }

  /** Returns the beginning of a text that is no wider than a room, points. */
  String startOf(BitmapFont font, String text, float room) {
    int end = text.length();
    while (end > 0 && width(font, text.substring(0, end)) > room) {
      end = text.offsetByCodePoints(end, -1);
    }
    return text.substring(0, end);
  }

  /** Returns the end of a text that is no wider than a room, points. */
  public String endOf(BitmapFont font, String text, float room) {
    int start = 0;
    while (start < text.length() && width(font, text.substring(start)) > room) {
      start = text.offsetByCodePoints(start, 1);
    }
    return text.substring(start);
  }

  @Override
  public void dispose() {
    batch.dispose();
  }

  /** Draws text around x, with a shadow that keeps it legible on any ground. */
  void centred(BitmapFont font, String text, float x, float y, Color tint) {
    layout.setText(font, text);
    shadow.set(0, 0, 0, 0.6f * tint.a);
    left(font, text, x - layout.width / 2 + 1, y - 1, shadow);
    left(font, text, x - layout.width / 2, y, tint);
  }
}
