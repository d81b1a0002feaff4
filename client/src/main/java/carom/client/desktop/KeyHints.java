package carom.client.desktop;

import carom.client.desktop.hud.Hud;
import carom.client.desktop.hud.HudLayout.Panel;
import carom.client.desktop.hud.HudLayout.Spot;
import carom.client.desktop.hud.ShownGame;
import carom.client.desktop.paint.Fonts;
import carom.client.desktop.paint.UiColours;
import com.badlogic.gdx.graphics.Color;
import java.util.List;

/**
 * The keys of a game and what it is about, in a corner. They show for the first seconds of a visit
 * and fade; a key brings them back. Render thread only.
 */
final class KeyHints {
  /**
   * A key and what it does.
   *
   * @param key its name
   * @param does what it does, in a word or two
   */
  public record Hint(String key, String does) {}

  private static final float SHOWN_SECONDS = 12;
  private static final float PAD = 10;
  private static final float LINE = 15;
  private static final float KEY_WIDTH = 128;
  private static final float WIDTH = 250;

  private final Hud hud;
  private final Fonts fonts;
  private final ShownGame game;
  private final Panel panel = new Panel(Spot.BOTTOM_RIGHT, Spot.BOTTOM_LEFT, Spot.TOP_LEFT);
  private final Color color = new Color();
  private List<Hint> hints = List.of();
  private float left = SHOWN_SECONDS;

  /** Creates hints that show. The arguments stay the property of the caller. */
  public KeyHints(Hud hud, Fonts fonts, ShownGame game) {
    this.hud = hud;
    this.fonts = fonts;
    this.game = game;
  }

  /** Sets the keys, in the order in which they stand. */
  public void keys(List<Hint> keys) {
    hints = keys;
  }

  /** Shows the hints again, or hides them if they show. */
  public void toggle() {
    left = left > 0 ? 0 : SHOWN_SECONDS;
  }

  /**
   * Draws the hints while they show.
   *
   * @param seconds since the last picture
   */
  public void draw(float seconds) {
    if (left <= 0) {
      return;
    }
    left -= seconds;
    float alpha = Math.max(0, Math.min(1, left));
    float aboutHeight = hud.wrap(fonts.small(), game.about(), WIDTH - 2 * PAD, UiColours.ACCENT);
    float h = aboutHeight + 8 + hints.size() * LINE + 2 * PAD;
    if (!hud.layout().place(panel, WIDTH, h)) {
      return;
    }
    color.set(UiColours.PANEL).a *= alpha;
    hud.panel(panel.x(), panel.y(), WIDTH, h, color);
    hud.begin();
    float x = panel.x() + PAD;
    float y = panel.y() + h - PAD;
    color.set(UiColours.ACCENT).a = alpha;
    hud.wrap(fonts.small(), game.about(), WIDTH - 2 * PAD, color);
    hud.wrapped(x, y);
    y -= aboutHeight + 8;
    for (Hint hint : hints) {
      color.set(UiColours.TEXT).a = alpha;
      hud.left(fonts.small(), hud.cut(fonts.small(), hint.key(), KEY_WIDTH - 6), x, y, color);
      color.set(UiColours.MUTED).a = alpha;
      String does = hud.cut(fonts.small(), hint.does(), WIDTH - 2 * PAD - KEY_WIDTH);
      hud.left(fonts.small(), does, x + KEY_WIDTH, y, color);
      y -= LINE;
    }
    hud.end();
  }
}
