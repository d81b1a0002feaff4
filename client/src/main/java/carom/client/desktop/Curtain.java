package carom.client.desktop;

import carom.client.desktop.hud.Hud;
import carom.client.desktop.paint.Canvas;
import carom.client.desktop.paint.UiColours;
import carom.client.link.ConnectionPhase;
import carom.client.view.ClientView;
import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.math.Vector3;

/**
 * The transition between matches and rooms: a curtain that closes from above and below over the
 * last picture while the next level loads, shows its name, and opens on the new match. Render
 * thread only.
 */
final class Curtain {
  private static final float CLOSE_SECONDS = 0.35f;
  private static final float OPEN_SECONDS = 0.6f;

  /** Time for which the name shows on the closed curtain, however quick the level is there. */
  private static final float HOLD_SECONDS = 0.9f;

  private static final Color CLOTH = UiColours.rgb(0x0a0e15);

  private final Hud hud;
  private final Canvas canvas;
  private final Vector3 at = new Vector3();
  private final Color color = new Color();
  private final Color edge = new Color();
  private String room = "";
  private int match;
  private boolean loads;
  private float closed;
  private float holdSeconds;

  /** Creates a curtain that is open. The arguments stay the property of the caller. */
  public Curtain(Hud hud, Canvas canvas) {
    this.hud = hud;
    this.canvas = canvas;
  }

  /**
   * Moves the curtain and draws it.
   *
   * @param seconds since the last picture
   */
  public void draw(ClientView view, float seconds) {
    boolean hasPicture = match > 0;
    loads = hasPicture && view.phase() == ConnectionPhase.LOADING;
    if (view.matchNumber() != match || !view.room().equals(room)) {
      match = view.matchNumber();
      room = view.room();
      closed = 1; // the picture has changed already
      holdSeconds = HOLD_SECONDS;
    }
    if (loads) {
      closed = Math.min(1, closed + seconds / CLOSE_SECONDS);
    } else if (holdSeconds > 0) {
      holdSeconds -= seconds;
    } else {
      closed = Math.max(0, closed - seconds / OPEN_SECONDS);
    }
    if (closed > 0) {
      paint(view);
    }
  }

  /** Returns whether nothing of it shows. */
  public boolean isOpen() {
    return closed == 0;
  }

  /** Returns whether it shows the level that loads, so that nothing else needs to. */
  public boolean showsLoading() {
    return loads;
  }

  private void paint(ClientView view) {
    float share = closed * closed * (3 - 2 * closed);
    float width = hud.windowWidth();
    float height = hud.height();
    float half = height / 2 * share;
    edge.set(UiColours.ACCENT).a = share;
    hud.beginFigures();
    canvas.rect(0, 0, width, half, CLOTH);
    canvas.rect(0, height - half, width, half, CLOTH);
    canvas.rect(0, half - 2, width, 2, edge);
    canvas.rect(0, height - half, width, 2, edge);
    if (loads) {
      float bar = Math.min(360, width - 40);
      float x = (width - bar) / 2;
      canvas.rect(x, height / 2 - 62, bar, 4, UiColours.PANEL_LINE);
      canvas.rect(x, height / 2 - 62, bar * (float) view.loadingProgress(), 4, UiColours.ACCENT);
    }
    canvas.end();
    hud.begin();
    boolean named = view.level() != null && !loads;
    text(
        named ? view.level().name() : view.message(), height / 2 + (named ? 52 : 26), named, share);
    if (named) {
      text(view.game() + "     room " + view.room(), height / 2 - 34, false, 0.7f * share);
    }
    hud.end();
  }

  private void text(String text, float y, boolean large, float alpha) {
    at.set(hud.windowWidth() / 2f, y, 0);
    color.set(UiColours.TEXT).a = alpha;
    hud.floating(text, at, large, color);
  }
}
