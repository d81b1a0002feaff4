package carom.client.desktop.game;

import carom.client.desktop.hud.Hud;
import carom.client.desktop.hud.HudLayout.Panel;
import carom.client.desktop.hud.HudLayout.Spot;
import carom.client.desktop.paint.Canvas;
import carom.client.desktop.paint.Fonts;
import carom.client.desktop.paint.UiColours;
import carom.client.look.HudItem;
import carom.client.look.HudItem.Place;
import carom.client.view.ClientView;
import carom.client.view.ClientView.Drawn;
import carom.sim.field.Countdown;
import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.graphics.Texture;
import com.badlogic.gdx.graphics.g2d.TextureRegion;
import com.badlogic.gdx.math.MathUtils;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * Draws the lines of a game's look about the own player, or the one watched. Render thread only.
 */
final class LookHud {
  private static final float PAD = 10;
  private static final float LINE = 22;
  private static final float LABEL_WIDTH = 80;
  private static final float VALUE_WIDTH = 150;
  private static final float BAR_HEIGHT = 10;
  private static final float ICON = 18;
  private static final float ICON_STEP = 22;

  /** Share of a bar below which it is drawn in the colour of danger. */
  private static final float LOW = 0.3f;

  private final ShownLook look;
  private final LookPictures pictures;
  private final Hud hud;
  private final Canvas canvas;
  private final Fonts fonts;
  private final Panel[] panels = new Panel[Place.values().length];
  private final List<HudItem> shown = new ArrayList<>();
  private final TextureRegion region = new TextureRegion();
  private final Color color = new Color();

  LookHud(ShownLook look, LookPictures pictures, Hud hud, Canvas canvas, Fonts fonts) {
    this.look = look;
    this.pictures = pictures;
    this.hud = hud;
    this.canvas = canvas;
    this.fonts = fonts;
    for (Place place : Place.values()) {
      panels[place.ordinal()] = new Panel(spots(place));
    }
  }

  static Spot[] spots(Place place) {
    return switch (place) {
      case BOTTOM -> new Spot[] {Spot.BOTTOM, Spot.BOTTOM_LEFT, Spot.TOP_LEFT};
      case BOTTOM_LEFT -> new Spot[] {Spot.BOTTOM_LEFT, Spot.BOTTOM, Spot.TOP_LEFT};
      case BOTTOM_RIGHT -> new Spot[] {Spot.BOTTOM_RIGHT, Spot.BOTTOM, Spot.BOTTOM_LEFT};
      case TOP -> new Spot[] {Spot.TOP, Spot.TOP_LEFT, Spot.BOTTOM};
      case TOP_LEFT -> new Spot[] {Spot.TOP_LEFT, Spot.BOTTOM_LEFT, Spot.BOTTOM};
    };
  }

  /** Returns whether the look has lines, which take the place of the game's own. */
  public boolean hasLines() {
    return !look.setup().hud().isEmpty();
  }

  /** Draws the lines that show now. */
  public void draw(ClientView view) {
    Drawn body = view.own() == null ? view.watched() : view.own();
    if (body == null || !view.knowsFields()) {
      return;
    }
    for (Place place : Place.values()) {
      gather(place, view, body);
      float width = LABEL_WIDTH + VALUE_WIDTH + 2 * PAD;
      float height = shown.size() * LINE + PAD;
      Panel panel = panels[place.ordinal()];
      if (!shown.isEmpty() && hud.layout().placeAnyhow(panel, width, height)) {
        hud.panel(panel.x(), panel.y(), width, height);
        for (int i = 0; i < shown.size(); i++) {
          float y = panel.y() + PAD / 2 + (shown.size() - 1 - i) * LINE;
          line(shown.get(i), view, body, panel.x() + PAD, y);
        }
      }
    }
  }

  private void gather(Place place, ClientView view, Drawn body) {
    shown.clear();
    List<HudItem> all = look.setup().hud();
    for (int i = 0; i < all.size(); i++) {
      HudItem item = all.get(i);
      boolean shows =
          item.condition() == null || item.condition().number(view, body.ownerId(), body) != 0;
      if (item.place() == place && shows) {
        shown.add(item);
      }
    }
  }

  private void line(HudItem item, ClientView view, Drawn body, float x, float y) {
    if (item.kind() == HudItem.Kind.BAR) {
      bar(item, item.value().share(view, body.ownerId(), body), x + LABEL_WIDTH, y);
    }
    hud.begin();
    Texture icon = item.kind() == HudItem.Kind.ICONS ? pictures.of(item.label()) : null;
    if (icon != null) {
      region.setRegion(icon);
      float value = item.value().number(view, body.ownerId(), body);
      int count = MathUtils.clamp(Math.round(value), 0, HudItem.MAX_ICONS);
      float step = Math.min(ICON_STEP, (LABEL_WIDTH + VALUE_WIDTH - ICON) / HudItem.MAX_ICONS);
      for (int i = 0; i < count; i++) {
        hud.picture(region, x + i * step, y + (LINE - ICON) / 2, ICON, ICON);
      }
    } else {
      String label = item.kind() == HudItem.Kind.ICONS ? "" : item.label();
      String cut = hud.cut(fonts.small(), label, LABEL_WIDTH - 6);
      hud.left(fonts.small(), cut, x, y + LINE - 5, UiColours.TEXT);
      if (item.kind() != HudItem.Kind.BAR) {
        hud.left(
            fonts.text(), text(item, view, body), x + LABEL_WIDTH, y + LINE - 4, UiColours.TEXT);
      }
    }
    hud.end();
  }

  private String text(HudItem item, ClientView view, Drawn body) {
    if (item.kind() == HudItem.Kind.WORD) {
      return hud.cut(fonts.text(), item.value().word(view, body.ownerId(), body), VALUE_WIDTH);
    }
    float value = item.value().number(view, body.ownerId(), body);
    if (item.kind() == HudItem.Kind.TIME) {
      boolean ticks = item.value().field() instanceof Countdown;
      return figure(item, ticks ? value / view.tickRate() : value) + " s";
    }
    return figure(item, value);
  }

  private static String figure(HudItem item, float value) {
    float shown = item.scale() * value;
    if (item.decimals() > 0) {
      return String.format(Locale.ROOT, "%." + item.decimals() + "f", shown);
    }
    boolean roundsUp = item.kind() == HudItem.Kind.TIME;
    return Integer.toString(roundsUp ? MathUtils.ceil(shown) : Math.round(shown));
  }

  private void bar(HudItem item, float share, float x, float y) {
    float bottom = y + (LINE - BAR_HEIGHT) / 2;
    Color full = share < LOW ? UiColours.BAD : UiColours.GOOD;
    hud.beginFigures();
    canvas.rect(x - 1, bottom - 1, VALUE_WIDTH + 2, BAR_HEIGHT + 2, UiColours.BACKDROP);
    canvas.rect(x, bottom, VALUE_WIDTH, BAR_HEIGHT, UiColours.PANEL_LINE);
    Color tint = item.rgb() < 0 ? full : UiColours.shade(item.rgb(), 1, 1, color);
    canvas.rect(x, bottom, VALUE_WIDTH * share, BAR_HEIGHT, tint);
    canvas.end();
  }
}
