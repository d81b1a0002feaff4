package carom.client.desktop.hud;

import carom.client.desktop.paint.Canvas;
import carom.client.desktop.paint.Fonts;
import carom.client.desktop.paint.Theme;
import carom.client.desktop.paint.ViewCamera;
import carom.client.stats.NetStats;
import carom.client.stats.RecentValues;
import carom.client.view.ClientView;
import carom.client.view.ClientView.Drawn;
import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.math.Vector3;
import java.util.Locale;

/**
 * The connection at a glance, in two sizes: round trip, loss, rates and corrections in a few lines;
 * or all figures, and bars of recent snapshot gaps, sizes, input margins and corrections. It stands
 * in the upper left corner, and goes to the lower right one while the own player is there. Units
 * are points. Texts change four times a second so that they can be read. Render thread only.
 */
public final class NetGraph {
  /** How much is shown. */
  public enum Size {
    /** Nothing. */
    OFF,
    /** A few lines. */
    SMALL,
    /** All figures and bars. */
    FULL
  }

  private static final float SMALL_WIDTH = 226;
  private static final float FULL_WIDTH = 330;
  private static final float PAD = 10;
  private static final float LINE = 17;
  private static final float GRAPH_HEIGHT = 34;
  private static final float GRAPH_STEP = GRAPH_HEIGHT + LINE + 4;
  private static final float REFRESH_SECONDS = 0.25f;

  /** Distance that the own player keeps from the panel, points. */
  private static final float CLEARANCE = 60;

  private static final int SMALL_ROWS = 4;
  private static final int ROWS = 8;
  private static final int GRAPHS = 4;

  private final Canvas canvas;
  private final Hud hud;
  private final Fonts fonts;
  private final String[] rows = new String[ROWS];
  private final String[] captions = new String[GRAPHS];
  private Size size = Size.OFF;
  private boolean atBottomRight;
  private float age = REFRESH_SECONDS;

  /** Creates a net graph that draws into a HUD and shows nothing yet. */
  public NetGraph(Canvas canvas, Hud hud, Fonts fonts) {
    this.canvas = canvas;
    this.hud = hud;
    this.fonts = fonts;
  }

  /** Sets how much is shown. */
  public void size(Size shown) {
    size = shown;
    age = REFRESH_SECONDS;
  }

  /** Shows the next size: a few lines, all, nothing. */
  public void next() {
    size(Size.values()[(size.ordinal() + 1) % Size.values().length]);
  }

  /**
   * Draws it.
   *
   * @param nowNs the present, by the clock of the client's updates
   * @param framesPerSecond of the window
   * @param seconds since the last picture
   * @param below height at the window's lower edge to keep free, points
   */
  public void draw(
      ClientView view,
      ViewCamera camera,
      long nowNs,
      float framesPerSecond,
      float seconds,
      float below) {
    if (size == Size.OFF) {
      return;
    }
    age += seconds;
    if (age >= REFRESH_SECONDS) {
      age = 0;
      write(view.stats(), nowNs, framesPerSecond);
    }
    boolean full = size == Size.FULL;
    float width = full ? FULL_WIDTH : SMALL_WIDTH;
    int lines = full ? ROWS : SMALL_ROWS;
    float height = 2 * PAD + lines * LINE + (full ? GRAPHS * GRAPH_STEP : 0);
    float free = hud.height() - height - 2 * PAD;
    Drawn own = view.own();
    if (own != null) {
      Vector3 at = hud.at(camera, own.x(), own.y());
      atBottomRight =
          isAtBottomRight(
              atBottomRight, at.x, at.y, hud.windowWidth(), hud.height(), width, height);
    }
    float left = atBottomRight ? hud.windowWidth() - width - PAD : PAD;
    float bottom = atBottomRight ? Math.min(PAD + below, PAD + free) : PAD + free;
    hud.panel(left, bottom, width, height);
    float top = bottom + height - PAD;
    float graphsTop = top - lines * LINE;
    if (full) {
      hud.beginFigures();
      float y = graphsTop - LINE - GRAPH_HEIGHT;
      bars(view.stats().gapSeries(), left, y, 100, Theme.INFO);
      bars(view.stats().snapshotBytesSeries(), left, y - GRAPH_STEP, 1_200, Theme.GOOD);
      bars(view.stats().marginSeries(), left, y - 2 * GRAPH_STEP, 10, Theme.ACCENT);
      bars(view.stats().correctionSeries(), left, y - 3 * GRAPH_STEP, 0.5f, Theme.BAD);
      canvas.end();
    }
    hud.begin();
    for (int i = 0; i < lines; i++) {
      hud.left(fonts.small(), rows[i], left + PAD, top - i * LINE, Theme.TEXT);
    }
    for (int i = 0; i < GRAPHS && full; i++) {
      float y = graphsTop - 4 - i * GRAPH_STEP;
      hud.left(fonts.small(), captions[i], left + PAD, y, Theme.MUTED);
    }
    hud.end();
  }

  /**
   * Returns whether a panel stands in the lower right corner and not in the upper left one. It
   * stays where it is until the own player comes near, so that it doesn't jump to and fro.
   *
   * @param was where it is
   * @param x of the own player, points
   * @param y of the own player, points
   */
  static boolean isAtBottomRight(
      boolean was, float x, float y, float windowWidth, float windowHeight, float w, float h) {
    boolean coversTopLeft = x < PAD + w + CLEARANCE && y > windowHeight - PAD - h - CLEARANCE;
    boolean coversBottomRight = x > windowWidth - PAD - w - CLEARANCE && y < PAD + h + CLEARANCE;
    return was ? !coversBottomRight || coversTopLeft : coversTopLeft && !coversBottomRight;
  }

  private void write(NetStats s, long nowNs, float fps) {
    if (size == Size.SMALL) {
      rows[0] = text("RTT %.0f ms    loss %.1f %%", s.rttMs(), s.lossPercent());
      rows[1] = text("%.0f snapshots/s    %.0f fps", s.snapshotsPerSecond(), fps);
      rows[2] =
          text("in %.1f kbit/s    out %.1f kbit/s", s.kbitInPerSecond(), s.kbitOutPerSecond());
      rows[3] =
          text(
              "corrections %.1f/min, mean %.1f cm",
              s.correctionsPerMinute(nowNs), s.correctionMeanMetres() * 100);
      return;
    }
    rows[0] =
        text(
            "RTT %.0f ms   jitter %.0f ms   loss %.1f %%",
            s.rttMs(), s.jitterMs(), s.lossPercent());
    rows[1] =
        text(
            "in %.1f kbit/s   out %.1f kbit/s   %.0f fps",
            s.kbitInPerSecond(), s.kbitOutPerSecond(), fps);
    rows[2] = text("%.0f snapshots/s   mean %.0f bytes", s.snapshotsPerSecond(), s.snapshotBytes());
    rows[3] =
        text(
            "input buffer %.0f of %.1f ticks   clock x%.3f",
            s.inputMargin(), s.targetMargin(), s.clockSpeed());
    rows[4] = text("others drawn %.0f ms ago", s.interpolationDelayMs());
    rows[5] =
        text(
            "corrections %.1f/min, mean %.1f cm   exact %.1f %%",
            s.correctionsPerMinute(nowNs), s.correctionMeanMetres() * 100, s.exactRate() * 100);
    rows[6] =
        text(
            "%d near, exact %.1f %%   mispredictions %d",
            s.nearBodies(), s.perfectRate() * 100, s.disagreements());
    rows[7] =
        text(
            "rollback %.1f ticks, %.1f ms   cut short %d",
            s.rollbackMeanTicks(), s.replayP95Ms(), s.replaysCutShort());
    captions[0] = text("gap between snapshots, ms (p99 %.0f)", s.gapP99Ms());
    captions[1] = "datagram size, bytes (full height 1,200)";
    captions[2] = "input buffer, ticks (red: too late)";
    captions[3] = "corrections, m";
  }

  private void bars(RecentValues series, float left, float bottom, float full, Color color) {
    canvas.rect(left + PAD, bottom, FULL_WIDTH - 2 * PAD, 1, Theme.PANEL_LINE);
    int count = Math.min(series.size(), (int) (FULL_WIDTH - 2 * PAD));
    for (int i = 0; i < count; i++) {
      float value = series.get(i);
      float h = Math.min(1, Math.abs(value) / full) * GRAPH_HEIGHT;
      canvas.rect(left + FULL_WIDTH - PAD - i - 1, bottom, 1, h, value < 0 ? Theme.BAD : color);
    }
  }

  private static String text(String format, Object... values) {
    return String.format(Locale.ROOT, format, values);
  }
}
