package carom.client.desktop.hud;

import carom.client.desktop.hud.HudLayout.Panel;
import carom.client.desktop.hud.HudLayout.Spot;
import carom.client.desktop.paint.Canvas;
import carom.client.desktop.paint.Fonts;
import carom.client.desktop.paint.UiColours;
import carom.client.desktop.paint.ViewCamera;
import carom.client.link.ConnectionPhase;
import carom.client.view.ClientView;
import carom.client.view.ClientView.Drawn;
import carom.net.protocol.ProtocolLimits;
import carom.net.protocol.ServerMessage.RosterEntry;
import carom.sim.level.Appearance;
import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.graphics.g2d.BitmapFont;
import com.badlogic.gdx.graphics.g2d.GlyphLayout;
import com.badlogic.gdx.graphics.g2d.SpriteBatch;
import com.badlogic.gdx.graphics.g2d.TextureRegion;
import com.badlogic.gdx.math.MathUtils;
import com.badlogic.gdx.math.Matrix4;
import com.badlogic.gdx.math.Vector3;
import com.badlogic.gdx.utils.Align;
import com.badlogic.gdx.utils.Disposable;
import java.util.ArrayList;
import java.util.List;

/**
 * Text and panels over the picture: names, scores, notices, the state of the connection, key hints.
 * Units are points (see {@link Fonts}), origin bottom left. Render thread only.
 */
public final class Hud implements Disposable {
  private static final float PAD = 12;
  private static final float NOTICE_LINE = 32;
  private static final int MOST_NOTICES = 3;
  private static final long NOTICE_NS = 4_000_000_000L;
  private static final float ANSWER_SECONDS = 1.5f;

  /** Hears what is drawn, for tools that look at a picture's layout. Points, origin bottom left. */
  public interface Witness {
    /** Hears of a panel. */
    void panel(float x, float y, float w, float h);

    /** Hears of a text; y is the top of its capitals. */
    void text(BitmapFont font, String text, float x, float y, Color tint);

    /** Hears of a word of the world, which lies below all panels; y is the top of its capitals. */
    void word(BitmapFont font, String text, float x, float y);
  }

  private final Canvas canvas;
  private final SpriteBatch batch = new SpriteBatch();
  private final Matrix4 points = new Matrix4();
  private final Fonts fonts;
  private final GlyphLayout glyphs = new GlyphLayout();
  private final HudLayout layout = new HudLayout();
  private final Panel news = new Panel(Spot.TOP, Spot.BOTTOM);
  private final Panel reply = new Panel(Spot.BOTTOM, Spot.TOP);
  private final Panel role = new Panel(Spot.TOP, Spot.BOTTOM);
  private final Color color = new Color();
  private final Color shadow = new Color();
  private final GlyphLayout wrapped = new GlyphLayout();
  private BitmapFont wrapFont;
  private final FreePlaces places = new FreePlaces();
  private final NameRows names = new NameRows(places, ProtocolLimits.MAX_PLAYERS);
  private final List<String> noticeLines = new ArrayList<>();
  private final List<Float> noticeAges = new ArrayList<>();
  private String answer = "";
  private float answerSeconds;
  private Witness witness;
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
    layout.begin(width, height);
  }

  /** Sets what hears of all that is drawn; null for nothing. */
  public void witness(Witness newWitness) {
    witness = newWitness;
  }

  /** Returns the places of this picture. */
  public HudLayout layout() {
    return layout;
  }

  /** Keeps the HUD off a body, whose radius is given in metres. */
  public void keepFree(ViewCamera camera, float x, float y, float radius, float pixelsPerMetre) {
    Vector3 at = at(camera, x, y);
    layout.keepFree(at.x, at.y, radius * pixelsPerMetre / scale);
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

  /** Ends the batches that a part of the picture has begun before it threw. */
  public void abandon() {
    canvas.abandon();
    if (batch.isDrawing()) {
      batch.end();
    }
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
      color.set(UiColours.TEXT).a = 0.85f * drawn.alpha();
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
    glyphs.setText(fonts.small(), text);
    float top = names.top(player, x, y, glyphs.width);
    if (!Float.isNaN(top)) {
      centred(fonts.small(), text, x, top, color);
    }
  }

  /** Draws a word around a place in the world, but whole, and keeps names off it. */
  public void label(String text, Vector3 at, boolean large, Color textColor) {
    BitmapFont font = large ? fonts.title() : fonts.text();
    glyphs.setText(font, text);
    float w = glyphs.width;
    float x = MathUtils.clamp(at.x, w / 2 + PAD, Math.max(w / 2 + PAD, width - w / 2 - PAD));
    float y = MathUtils.clamp(at.y, glyphs.height + PAD, height - PAD);
    places.take(x - w / 2, y - glyphs.height, w, glyphs.height);
    if (witness != null) {
      witness.word(font, text, x - w / 2, y);
    }
    shadow(font, text, x - w / 2, y, textColor);
    write(font, text, x - w / 2, y, textColor);
  }

  /** Draws a word around a place on the screen. */
  public void floating(String text, Vector3 at, boolean large, Color textColor) {
    centred(large ? fonts.title() : fonts.text(), text, at.x, at.y, textColor);
  }

  /** Draws a word of the world, which lies below all panels; y is the top of its capitals. */
  public void floatingLeft(BitmapFont font, String text, float x, float y, Color tint) {
    if (witness != null) {
      witness.word(font, text, x, y);
    }
    shadow(font, text, x, y, tint);
    write(font, text, x, y, tint);
  }

  /** Draws the notices of the last seconds, newest on top, fading; long ones in several lines. */
  public void notices(ClientView view, long nowNs) {
    noticeLines.clear();
    noticeAges.clear();
    float widest = 0;
    int newest = view.notices().size() - 1;
    for (int i = newest; i >= 0 && i > newest - MOST_NOTICES && age(view, i, nowNs) < 1; i--) {
      for (String line : lines(fonts.large(), view.notices().get(i).text(), width - 4 * PAD)) {
        noticeLines.add(line);
        noticeAges.add(age(view, i, nowNs));
        widest = Math.max(widest, width(fonts.large(), line));
      }
    }
    int shown = noticeLines.size();
    if (shown == 0 || !layout.place(news, widest, shown * NOTICE_LINE)) {
      return;
    }
    batch.begin();
    for (int row = 0; row < shown; row++) {
      color.set(UiColours.TEXT).a = Math.min(1, 3 * (1 - noticeAges.get(row)));
      float y = news.y() + (shown - row) * NOTICE_LINE - 4;
      centred(fonts.large(), noticeLines.get(row), width / 2f, y, color);
    }
    batch.end();
  }

  /** Breaks a text between words into lines that are no wider than a room, points. */
  private List<String> lines(BitmapFont font, String text, float room) {
    if (width(font, text) <= room) {
      return List.of(text);
    }
    List<String> lines = new ArrayList<>();
    String line = "";
    for (String word : text.split(" ")) {
      String longer = line.isEmpty() ? word : line + " " + word;
      if (width(font, longer) > room && !line.isEmpty()) {
        lines.add(line);
        longer = word;
      }
      line = cut(font, longer, room);
    }
    lines.add(line);
    return lines;
  }

  /** Returns the age of a notice in parts of the time for which it shows. */
  private static float age(ClientView view, int notice, long nowNs) {
    return (nowNs - view.notices().get(notice).arrivedNs()) / (float) NOTICE_NS;
  }

  /** Shows a few words for a moment, as the answer to a key. */
  public void showAnswer(String text) {
    answer = text;
    answerSeconds = ANSWER_SECONDS;
  }

  /** Draws the answer to the last key while it shows. */
  public void drawAnswer(float seconds) {
    answerSeconds -= seconds;
    float w = width(fonts.large(), answer);
    if (answerSeconds > 0 && layout.place(reply, w, NOTICE_LINE)) {
      batch.begin();
      color.set(UiColours.TEXT).a = Math.min(1, 3 * answerSeconds);
      centred(fonts.large(), answer, width / 2f, reply.y() + NOTICE_LINE - 4, color);
      batch.end();
    }
  }

  /** Draws that the player has no body, and which player the picture follows meanwhile. */
  public void bodiless(ClientView view) {
    RosterEntry own = view.participant(view.playerId());
    boolean spectator = own != null && own.spectator();
    int watched = view.watchedPlayer();
    String keys = spectator ? "A, D: another     Tab and P: play" : "A, D: another";
    String text =
        watched >= 0
            ? "Watching " + view.playerName(watched)
            : spectator ? "You watch. Nobody plays" : "You are back in a moment";
    float w = Math.max(width(fonts.large(), text), width(fonts.small(), keys));
    if (!layout.place(role, w, 2 * NOTICE_LINE)) {
      return;
    }
    batch.begin();
    float y = role.y() + 2 * NOTICE_LINE - 4;
    centred(fonts.large(), text, width / 2f, y, UiColours.TEXT);
    if (watched >= 0) {
      centred(fonts.small(), keys, width / 2f, y - NOTICE_LINE, UiColours.MUTED);
    }
    batch.end();
  }

  /** Draws what the connection is doing while there is no game to play. */
  public void phase(ClientView view) {
    ConnectionPhase phase = view.phase();
    veil();
    float w = Math.min(width - 2 * PAD, 560);
    wrapped.setText(fonts.text(), view.message(), UiColours.MUTED, w - 4 * PAD, Align.center, true);
    float h = 90 + wrapped.height;
    float x = (width - w) / 2;
    float y = (height - h) / 2;
    panel(x, y, w, h, UiColours.DIALOG);
    if (phase == ConnectionPhase.LOADING) {
      float bar = (w - 2 * PAD) * (float) view.loadingProgress();
      beginFigures();
      canvas.rect(x + PAD, y + PAD, w - 2 * PAD, 4, UiColours.PANEL_LINE);
      canvas.rect(x + PAD, y + PAD, bar, 4, UiColours.ACCENT);
      canvas.end();
    }
    batch.begin();
    fonts.text().draw(batch, wrapped, x + 2 * PAD, y + wrapped.height + 26);
    centred(fonts.large(), title(phase), width / 2f, y + h - 18, UiColours.TEXT);
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
    canvas.rect(0, 0, width, height, UiColours.VEIL);
    canvas.end();
  }

  /** Draws a dark, translucent panel with a thin edge. */
  public void panel(float x, float y, float w, float h) {
    panel(x, y, w, h, UiColours.PANEL);
  }

  /** Draws a panel on a ground of another colour. */
  public void panel(float x, float y, float w, float h, Color ground) {
    places.take(x, y, w, h);
    if (witness != null) {
      witness.panel(x, y, w, h);
    }
    beginFigures();
    canvas.rect(x, y, w, h, ground);
    canvas.frame(x, y, w, h, 1, UiColours.PANEL_LINE);
    canvas.end();
  }

  /** Returns the width of a text, points. */
  public float width(BitmapFont font, String text) {
    glyphs.setText(font, text);
    return glyphs.width;
  }

  /**
   * Draws text that starts at x; y is the top of the capitals. Stands between {@link #begin} and
   * {@link #end}.
   */
  public void left(BitmapFont font, String text, float x, float y, Color tint) {
    if (witness != null && !text.isBlank()) {
      witness.text(font, text, x, y, tint);
    }
    write(font, text, x, y, tint);
  }

  private void write(BitmapFont font, String text, float x, float y, Color tint) {
    font.setColor(tint);
    font.draw(batch, text, snap(x), snap(y));
  }

  /** Draws text as {@link #left} does, with a shadow that keeps it legible on any ground. */
  public void shadowed(BitmapFont font, String text, float x, float y, Color tint) {
    shadow(font, text, x, y, tint);
    left(font, text, x, y, tint);
  }

  private void shadow(BitmapFont font, String text, float x, float y, Color tint) {
    shadow.set(0, 0, 0, 0.6f * tint.a);
    write(font, text, x + 1, y - 1, shadow);
  }

  /** Draws a picture. Stands between {@link #begin} and {@link #end}. */
  void picture(TextureRegion picture, float x, float y, float w, float h) {
    batch.draw(picture, x, y, w, h);
  }

  /** Returns a text that is no wider than a room, points: the beginning and dots, if it is. */
  public String cut(BitmapFont font, String text, float room) {
    if (width(font, text) <= room) {
      return text;
    }
    int end = text.length();
    while (end > 0 && width(font, text.substring(0, end) + "...") > room) {
      end = text.offsetByCodePoints(end, -1);
    }
    return text.substring(0, end) + "...";
  }

  /** Breaks a text into lines of a width, to be drawn by {@link #wrapped}; returns its height. */
  public float wrap(BitmapFont font, String text, float room, Color tint) {
    wrapped.setText(font, text, tint, room, Align.left, true);
    wrapFont = font;
    return wrapped.height;
  }

  /** Draws the text of {@link #wrap}; its upper left corner is given. */
  public void wrapped(float x, float top) {
    wrapFont.draw(batch, wrapped, snap(x), snap(top));
  }

  /** Returns a length in points. */
  public float points(float pixels) {
    return pixels / scale;
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
    glyphs.setText(font, text);
    shadowed(font, text, x - glyphs.width / 2, y, tint);
  }
}
