package carom.client.desktop;

import carom.client.desktop.hud.Hud;
import carom.client.desktop.hud.HudLayout.Panel;
import carom.client.desktop.hud.HudLayout.Spot;
import carom.client.desktop.paint.Canvas;
import carom.client.desktop.paint.Fonts;
import carom.client.desktop.paint.UiColours;
import carom.client.stats.NetStats;
import carom.client.stats.RecentValues;
import carom.client.view.ClientView;
import com.badlogic.gdx.graphics.Color;
import java.util.Locale;

/**
 * The connection at a glance, in two sizes: round trip, loss, rates and corrections in a few lines;
 * or all figures, and bars of recent snapshot gaps, sizes, input margins and corrections. It stands
 * in a corner where neither the own player nor another panel is, with fewer bars where a window is
 * small. Units are points. Texts change four times a second so that they can be read. It widens for
 * large figures, and doesn't narrow again, so that it stands still. Render thread only.
 */
final class NetGraph {
  /** The amount of detail. */
  public enum Size {
    /** The net graph is hidden. */
    OFF,
    /** The net graph shows a few lines. */
    SMALL,
    /** The net graph shows all figures and bars. */
    FULL
  }

  private static final float SMALL_WIDTH = 226;
  private static final float FULL_WIDTH = 330;
  private static final float PAD = 10;
  private static final float LINE = 17;
  private static final float GRAPH_HEIGHT = 34;
  private static final float GRAPH_STEP = GRAPH_HEIGHT + LINE + 4;
  private static final float REFRESH_SECONDS = 0.25f;

  private static final int SMALL_ROWS = 4;
  private static final int ROWS = 8;
  private static final int GRAPHS = 4;

  private final Canvas canvas;
  private final Hud hud;
  private final Fonts fonts;
  private final String[] rows = new String[ROWS];
  private final String[] captions = new String[GRAPHS];
  private Size size = Size.OFF;
  private final Panel panel =
      new Panel(Spot.TOP_LEFT, Spot.BOTTOM_RIGHT, Spot.BOTTOM_LEFT, Spot.TOP_RIGHT);
  private float age = REFRESH_SECONDS;
  private float width;

  /** Creates a net graph that draws into a HUD and shows nothing yet. */
  public NetGraph(Canvas canvas, Hud hud, Fonts fonts) {
    this.canvas = canvas;
    this.hud = hud;
    this.fonts = fonts;
  }

  /** Sets how much is shown. */
  public void size(Size shown) {
    size = shown;
    width = shown == Size.FULL ? FULL_WIDTH : SMALL_WIDTH;
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
   */
  public void draw(ClientView view, long nowNs, float framesPerSecond, float seconds) {
    if (size == Size.OFF) {
      return;
    }
    boolean full = size == Size.FULL;
    int lines = full ? ROWS : SMALL_ROWS;
    age += seconds;
    if (age >= REFRESH_SECONDS) {
      age = 0;
      write(view.stats(), nowNs, framesPerSecond);
      for (int i = 0; i < lines; i++) {
        width = Math.max(width, hud.width(fonts.small(), rows[i]) + 2 * PAD);
      }
    }
    int graphs = full ? GRAPHS : 0;
    while (!hud.layout().place(panel, width, height(lines, graphs))) {
      if (--graphs < 0) {
        return; // no corner has room for a line of it
      }
    }
    float left = panel.x();
    float bottom = panel.y();
    float height = height(lines, graphs);
    hud.panel(left, bottom, width, height);
    float top = bottom + height - PAD;
    float graphsTop = top - lines * LINE;
    hud.beginFigures();
    for (int i = 0; i < graphs; i++) {
      bars(view.stats(), i, left, graphsTop - LINE - GRAPH_HEIGHT - i * GRAPH_STEP);
    }
    canvas.end();
    hud.begin();
    for (int i = 0; i < lines; i++) {
      hud.left(fonts.small(), rows[i], left + PAD, top - i * LINE, UiColours.TEXT);
    }
    for (int i = 0; i < graphs; i++) {
      float y = graphsTop - 4 - i * GRAPH_STEP;
      hud.left(fonts.small(), captions[i], left + PAD, y, UiColours.MUTED);
    }
    hud.end();
  }

  private static float height(int lines, int graphs) {
    return 2 * PAD + lines * LINE + graphs * GRAPH_STEP;
  }

  private void write(NetStats s, long nowNs, float fps) {
    if (size == Size.SMALL) {
      rows[0] = text("RTT %.0f ms    loss %.1f %%%s", s.rttMs(), s.lossPercent(), way(s));
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
            "RTT %.0f ms   jitter %.0f ms   loss %.1f %%%s",
            s.rttMs(), s.jitterMs(), s.lossPercent(), way(s));
    rows[1] =
        text(
            "in %.1f kbit/s   out %.1f kbit/s   %.0f fps",
            s.kbitInPerSecond(), s.kbitOutPerSecond(), fps);
    rows[2] = text("%.0f snapshots/s   mean %.0f bytes", s.snapshotsPerSecond(), s.snapshotBytes());
    rows[3] =
        text(
            "input buffer %.0f of %.1f ticks   clock x%.3f",
            s.inputMargin(), s.targetMargin(), s.clockSpeed());
    rows[4] =
        text(
            "others drawn %.0f ms ago%s",
            s.interpolationDelayMs(), s.viewsNarrow() ? "   busy: narrow view" : "");
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

  private static String way(NetStats s) {
    return s.isOverTcp() ? "   TCP: UDP is blocked" : "";
  }

  private void bars(NetStats stats, int graph, float left, float y) {
    switch (graph) {
      case 0 -> bars(stats.gapSeries(), left, y, 100, UiColours.INFO);
      case 1 -> bars(stats.snapshotBytesSeries(), left, y, 1_200, UiColours.GOOD);
      case 2 -> bars(stats.marginSeries(), left, y, 10, UiColours.ACCENT);
      default -> bars(stats.correctionSeries(), left, y, 0.5f, UiColours.BAD);
    }
  }

  private void bars(RecentValues series, float left, float bottom, float full, Color color) {
    canvas.rect(left + PAD, bottom, FULL_WIDTH - 2 * PAD, 1, UiColours.PANEL_LINE);
    int count = Math.min(series.size(), (int) (FULL_WIDTH - 2 * PAD));
    for (int i = 0; i < count; i++) {
      float value = series.get(i);
      float h = Math.min(1, Math.abs(value) / full) * GRAPH_HEIGHT;
      canvas.rect(left + FULL_WIDTH - PAD - i - 1, bottom, 1, h, value < 0 ? UiColours.BAD : color);
    }
  }

  private static String text(String format, Object... values) {
    return String.format(Locale.ROOT, format, values);
  }
}
