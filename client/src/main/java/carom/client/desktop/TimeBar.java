package carom.client.desktop;

import carom.client.desktop.hud.Hud;
import carom.client.desktop.paint.Canvas;
import carom.client.desktop.paint.UiColours;
import com.badlogic.gdx.math.MathUtils;

/**
 * The time of a recording as a bar at the bottom, in which the mouse chooses. Render thread only.
 */
final class TimeBar {
  private static final float PAD = 12;
  private static final float BOTTOM = 52;
  private static final float HEIGHT = 6;

  /** Height at the window's lower edge that the bar and what stands below it need, points. */
  public static final float ROOM = 70;

  /** Distance from the bar within which a click means it, points. */
  private static final float REACH = 10;

  private static final float KNOB = 7;

  private final Hud hud;
  private final Canvas canvas;

  /** Creates a bar. The arguments stay the property of the caller. */
  public TimeBar(Hud hud, Canvas canvas) {
    this.hud = hud;
    this.canvas = canvas;
  }

  /** Draws the bar. */
  public void draw(int tick, int lastTick) {
    float width = hud.windowWidth() - 2 * PAD;
    float share = MathUtils.clamp(tick / (float) Math.max(1, lastTick), 0, 1);
    hud.beginFigures();
    canvas.rect(PAD, BOTTOM, width, HEIGHT, UiColours.PANEL_LINE);
    canvas.rect(PAD, BOTTOM, width * share, HEIGHT, UiColours.ACCENT);
    canvas.disc(PAD + width * share, BOTTOM + HEIGHT / 2, KNOB, UiColours.TEXT);
    canvas.end();
  }

  /** Returns whether a pixel (origin top left) is on the bar. */
  public boolean isAt(int x, int y) {
    float up = hud.height() - y / hud.pixelsPerPoint();
    return Math.abs(up - BOTTOM - HEIGHT / 2) <= HEIGHT / 2 + REACH && x >= 0;
  }

  /** Returns the tick at the column of a pixel. */
  public int tick(int x, int lastTick) {
    float share = (x / hud.pixelsPerPoint() - PAD) / (hud.windowWidth() - 2 * PAD);
    return Math.round(MathUtils.clamp(share, 0, 1) * lastTick);
  }
}
