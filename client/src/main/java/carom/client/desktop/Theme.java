package carom.client.desktop;

import com.badlogic.gdx.graphics.Color;

/** The colours of everything that is not part of a level. */
final class Theme {
  static final Color BACKDROP = rgb(0x0c1017);
  static final Color PANEL = new Color(0.03f, 0.05f, 0.08f, 0.62f);
  static final Color DIALOG = new Color(0.05f, 0.07f, 0.11f, 0.94f);
  static final Color VEIL = new Color(0.03f, 0.05f, 0.08f, 0.55f);
  static final Color PANEL_LINE = rgb(0x2c3a4f);
  static final Color TEXT = rgb(0xe8eef6);
  static final Color MUTED = rgb(0x8fa0b5);
  static final Color ACCENT = rgb(0xffb340);
  static final Color GOOD = rgb(0x5ad18a);
  static final Color BAD = rgb(0xff6b5e);
  static final Color INFO = rgb(0x5aa9ff);
  static final Color SHADOW = new Color(0, 0, 0, 0.28f);

  private Theme() {}

  /** An opaque colour from 0xRRGGBB. */
  static Color rgb(int rgb) {
    return new Color((rgb << 8) | 0xff);
  }

  /**
   * Sets {@code out} to 0xRRGGBB, scaled towards black (below 1) or white (above 1), with an
   * opacity.
   */
  static Color shade(int rgb, float scale, float alpha, Color out) {
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
