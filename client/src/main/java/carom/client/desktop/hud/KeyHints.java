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
  private static final float BOTTOM = 12;

  private final Hud hud;
  private final Fonts fonts;
  private final Color color = new Color();
  private String keys = "";
  private String hintsOf = "";
  private String about = "";
  private float left = SHOWN_SECONDS;

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
    hud.begin();
    color.set(Theme.TEXT).a = Math.max(0, Math.min(1, left)) * 0.95f;
    float top = hud.paragraph(fonts.text(), keys, BOTTOM, color);
    color.set(Theme.ACCENT).a = Math.max(0, Math.min(1, left)) * 0.95f;
    hud.paragraph(fonts.text(), about, top + 8, color);
    hud.end();
  }
}
