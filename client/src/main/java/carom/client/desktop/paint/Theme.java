package carom.client.desktop.paint;

import com.badlogic.gdx.graphics.Color;

/** The colours of everything that is not part of a level. */
public final class Theme {
  public static final Color BACKDROP = rgb(0x0c1017);
  public static final Color PANEL = new Color(0.03f, 0.05f, 0.08f, 0.62f);
  public static final Color DIALOG = new Color(0.05f, 0.07f, 0.11f, 0.94f);
  public static final Color VEIL = new Color(0.03f, 0.05f, 0.08f, 0.55f);
  public static final Color PANEL_LINE = rgb(0x2c3a4f);
  public static final Color TEXT = rgb(0xe8eef6);
  public static final Color MUTED = rgb(0x8fa0b5);
  public static final Color ACCENT = rgb(0xffb340);
  public static final Color GOOD = rgb(0x5ad18a);
  public static final Color BAD = rgb(0xff6b5e);
  public static final Color INFO = rgb(0x5aa9ff);
  public static final Color SHADOW = new Color(0, 0, 0, 0.28f);

  private Theme() {}

  /** Returns an opaque colour from 0xRRGGBB. */
  public static Color rgb(int rgb) {
    return new Color((rgb << 8) | 0xff);
  }

  /**
   * Sets {@code out} to 0xRRGGBB, scaled towards black (below 1) or white (above 1), with an
   * opacity.
   */
  public static Color shade(int rgb, float scale, float alpha, Color out) {
    Color.rgb888ToColor(out, rgb);
    if (scale <= 1) {
      out.mul(scale, scale, scale, 1);
    } else {
      out.lerp(Color.WHITE, Math.min(1, scale - 1));
    }
    out.a = alpha;
    return out;
  }
}
