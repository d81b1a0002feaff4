package carom.client.desktop.hud;

import carom.client.desktop.paint.Fonts;
import carom.client.desktop.paint.Theme;
import carom.client.view.ClientView;
import carom.game.Games;
import com.badlogic.gdx.graphics.Color;

/**
 * What a game is about and its keys, at the bottom of the picture. They show for the first seconds
 * of a visit and fade; a key brings them back. Render thread only.
 */
public final class KeyHints {
  private static final float SHOWN_SECONDS = 12;
  private static final float BOTTOM = 14;
  private static final float EDGE = 4;

  private final Hud hud;
  private final Fonts fonts;
  private final Color color = new Color();
  private String keys = "";
  private String hintsOf = "";
  private String about = "";
  private float left = SHOWN_SECONDS;
  private float height; // as they were drawn last

  /** Creates hints that show. The arguments stay the property of the caller. */
  public KeyHints(Hud hud, Fonts fonts) {
    this.hud = hud;
    this.fonts = fonts;
  }

  /** Sets the keys, as one text. */
  public void keys(String text) {
    keys = text;
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
  public void draw(ClientView view, float seconds) {
    if (left <= 0) {
      return;
    }
    left -= seconds;
    if (!view.game().equals(hintsOf)) {
      hintsOf = view.game();
      about = Games.create(hintsOf).description();
    }
    float alpha = Math.max(0, Math.min(1, left));
    if (height > 0) {
      color.set(Theme.PANEL).a *= alpha;
      hud.panel(EDGE, EDGE, hud.windowWidth() - 2 * EDGE, height - EDGE, color);
    }
    hud.begin();
    color.set(Theme.TEXT).a = alpha * 0.95f;
    float top = hud.paragraph(fonts.text(), keys, BOTTOM, color);
    color.set(Theme.ACCENT).a = alpha * 0.95f;
    height = hud.paragraph(fonts.text(), about, top + 8, color) + BOTTOM - EDGE;
    hud.end();
  }

  /** Returns how much of the window's lower edge the hints take, points; 0 when they are gone. */
  public float height() {
    return left > 0 ? height : 0;
  }
}
