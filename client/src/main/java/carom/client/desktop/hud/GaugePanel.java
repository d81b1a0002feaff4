package carom.client.desktop.hud;

import carom.client.desktop.hud.HudLayout.Panel;
import carom.client.desktop.hud.HudLayout.Spot;
import carom.client.desktop.paint.Canvas;
import carom.client.desktop.paint.Fonts;
import carom.client.desktop.paint.UiColours;
import carom.client.desktop.paint.ViewCamera;
import carom.client.field.FieldView;
import carom.client.view.ClientView;
import carom.client.view.ClientView.Drawn;
import carom.sim.field.Countdown;
import carom.sim.field.Gauge;
import carom.sim.level.Appearance;
import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.math.MathUtils;
import com.badlogic.gdx.math.Vector3;

/**
 * The {@link Gauge}s of a game: bars and numbers of the own player at the lower edge, small bars
 * over heads. Render thread only.
 */
public final class GaugePanel {
  private static final float PAD = 10;
  private static final float LINE = 20;
  private static final float LABEL_WIDTH = 80;
  private static final float BAR_WIDTH = 150;
  private static final float BAR_HEIGHT = 10;
  private static final float HEAD_WIDTH = 34;
  private static final float HEAD_HEIGHT = 4;

  /** Share of a bar below which it is drawn in the colour of danger. */
  private static final float LOW = 0.3f;

  private final Hud hud;
  private final Canvas canvas;
  private final Fonts fonts;
  private final ShownGame game;
  private final Panel panel = new Panel(Spot.BOTTOM, Spot.BOTTOM_LEFT, Spot.TOP_LEFT);

  /** Creates a panel. The arguments stay the property of the caller. */
  public GaugePanel(Hud hud, Canvas canvas, Fonts fonts, ShownGame game) {
    this.hud = hud;
    this.canvas = canvas;
    this.fonts = fonts;
    this.game = game;
  }

  /** Draws bars over the bodies of players; before panels, as a part of the world. */
  public void heads(ClientView view, ViewCamera camera, float pixelsPerMetre) {
    if (!view.knowsFields()) {
      return;
    }
    hud.beginFigures();
    for (int i = 0; i < view.entityCount(); i++) {
      Drawn body = view.entity(i);
      if (body.archetype().appearance().look() == Appearance.Look.PLAYER && body.ownerId() >= 0) {
        Vector3 at = hud.at(camera, body.x(), body.y());
        head(view.player(body.ownerId()), at.x, at.y + hud.points(0.75f * pixelsPerMetre));
      }
    }
    canvas.end();
  }

  private void head(FieldView player, float x, float bottom) {
    float y = bottom;
    for (Gauge gauge : game.gauges()) {
      if (gauge.kind() == Gauge.Kind.OVER_HEADS) {
        bar(gauge.share(player), x - HEAD_WIDTH / 2, y, HEAD_WIDTH, HEAD_HEIGHT);
        y += HEAD_HEIGHT + 2;
      }
    }
  }

  /** Draws the bars and numbers of the own player, or of the one that is watched. */
  public void draw(ClientView view) {
    Drawn body = view.own() == null ? view.watched() : view.own();
    int lines = 0;
    for (Gauge gauge : game.gauges()) {
      lines += isOwn(gauge) ? 1 : 0;
    }
    float w = LABEL_WIDTH + BAR_WIDTH + 2 * PAD;
    float h = lines * LINE + PAD;
    boolean shows = body != null && lines > 0 && view.knowsFields();
    if (!shows || !hud.layout().placeAnyhow(panel, w, h)) {
      return;
    }
    hud.panel(panel.x(), panel.y(), w, h);
    float x = panel.x() + PAD;
    float y = panel.y() + h - PAD / 2;
    for (Gauge gauge : game.gauges()) {
      if (isOwn(gauge)) {
        line(gauge, view, body.ownerId(), x, y);
        y -= LINE;
      }
    }
  }

  private static boolean isOwn(Gauge gauge) {
    return gauge.kind() == Gauge.Kind.BAR || gauge.kind() == Gauge.Kind.NUMBER;
  }

  private void line(Gauge gauge, ClientView view, int player, float x, float top) {
    boolean isBar = gauge.kind() == Gauge.Kind.BAR;
    if (isBar) {
      hud.beginFigures();
      float share = gauge.share(view.player(player));
      bar(share, x + LABEL_WIDTH, top - (LINE + BAR_HEIGHT) / 2, BAR_WIDTH, BAR_HEIGHT);
      canvas.end();
    }
    hud.begin();
    String label = hud.cut(fonts.small(), gauge.label(), LABEL_WIDTH - 6);
    hud.left(fonts.small(), label, x, top - 5, UiColours.TEXT);
    if (!isBar) {
      int value = ShownGame.value(gauge, view, player);
      boolean seconds = gauge.field() instanceof Countdown;
      int shown = seconds ? (value + view.tickRate() - 1) / view.tickRate() : value;
      String text = seconds ? shown + " s" : Integer.toString(shown);
      hud.left(fonts.text(), text, x + LABEL_WIDTH, top - 4, UiColours.TEXT);
    }
    hud.end();
  }

  private void bar(float share, float x, float y, float w, float h) {
    float full = MathUtils.clamp(share, 0, 1);
    Color color = full < LOW ? UiColours.BAD : UiColours.GOOD;
    canvas.rect(x - 1, y - 1, w + 2, h + 2, UiColours.BACKDROP);
    canvas.rect(x, y, w, h, UiColours.PANEL_LINE);
    canvas.rect(x, y, w * full, h, color);
  }
}
