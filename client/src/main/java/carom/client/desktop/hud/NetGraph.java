package carom.client.desktop.hud;

import carom.client.desktop.paint.Canvas;
import carom.client.desktop.paint.Fonts;
import carom.client.desktop.paint.Theme;
import carom.client.stats.NetStats;
import carom.client.stats.RecentValues;
import com.badlogic.gdx.graphics.Color;
import java.util.Locale;

/**
 * The connection at a glance: figures, and bars of recent snapshot gaps, sizes, input margins and
 * corrections. Units are pixels. Texts change four times a second so that they can be read. Render
 * thread only.
 */
public final class NetGraph {
  private static final float WIDTH = 330;
  private static final float PAD = 10;
  private static final float LINE = 17;
  private static final float GRAPH_HEIGHT = 34;
  private static final float REFRESH_SECONDS = 0.25f;

  /** Where it ends, px from the window's left edge. */
  public static final float RIGHT = PAD + WIDTH;

  private static final int ROWS = 8;
  private static final int GRAPHS = 4;

  private final Canvas canvas;
  private final Hud hud;
  private final Fonts fonts;
  private final String[] rows = new String[ROWS];
  private final String[] captions = new String[GRAPHS];
  private float age = REFRESH_SECONDS;

  /** Creates a net graph that draws into a HUD. */
  public NetGraph(Canvas canvas, Hud hud, Fonts fonts) {
    this.canvas = canvas;
    this.hud = hud;
    this.fonts = fonts;
  }

  /**
   * Draws the figures and the bars.
   *
   * @param stats the connection
   * @param nowNs the present, by the clock of the client's updates
   * @param framesPerSecond of the window
   * @param seconds since the last picture
   */
  public void draw(NetStats stats, long nowNs, float framesPerSecond, float seconds) {
    age += seconds;
    if (age >= REFRESH_SECONDS) {
      age = 0;
      write(stats, nowNs, framesPerSecond);
    }
    float height = 2 * PAD + ROWS * LINE + GRAPHS * (GRAPH_HEIGHT + LINE + 4);
    hud.panel(PAD, PAD, WIDTH, height);
    float graphsTop = PAD + height - PAD - ROWS * LINE;
    canvas.begin(hud.pixels(), 1);
    float y = graphsTop - LINE - GRAPH_HEIGHT;
    float step = GRAPH_HEIGHT + LINE + 4;
    bars(stats.gapSeries(), y, 100, Theme.INFO);
    bars(stats.snapshotBytesSeries(), y - step, 1_200, Theme.GOOD);
    bars(stats.marginSeries(), y - 2 * step, 10, Theme.ACCENT);
    bars(stats.correctionSeries(), y - 3 * step, 0.5f, Theme.BAD);
    canvas.end();

    hud.begin();
    float top = PAD + height - PAD;
    for (int i = 0; i < ROWS; i++) {
      hud.left(fonts.small, rows[i], 2 * PAD, top - i * LINE, Theme.TEXT);
    }
    for (int i = 0; i < GRAPHS; i++) {
      hud.left(fonts.small, captions[i], 2 * PAD, graphsTop - 4 - i * step, Theme.MUTED);
    }
    hud.end();
  }

  private void write(NetStats s, long nowNs, float fps) {
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

  private void bars(RecentValues series, float bottom, float full, Color color) {
    canvas.rect(2 * PAD, bottom, WIDTH - 2 * PAD, 1, Theme.PANEL_LINE);
    int count = Math.min(series.size(), (int) (WIDTH - 2 * PAD));
    for (int i = 0; i < count; i++) {
      float value = series.get(i);
      float h = Math.min(1, Math.abs(value) / full) * GRAPH_HEIGHT;
      canvas.rect(PAD + WIDTH - PAD - i - 1, bottom, 1, h, value < 0 ? Theme.BAD : color);
    }
  }

  private static String text(String format, Object... values) {
    return String.format(Locale.ROOT, format, values);
  }
}
