package carom.client.desktop.paint;

import carom.client.settings.Palette;
import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.utils.IntIntMap;

/** The colours of everything that is not part of a level. */
public final class UiColours {
  public static final Color BACKDROP = rgb(0x0c1017);
  public static final Color PANEL = new Color(0.03f, 0.05f, 0.08f, 0.78f);
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

  /**
   * Hues below a limit, degrees, and the colour that stands for them. The colours are those by
   * Okabe and Ito, which people with any kind of colour blindness tell apart, and a red that is
   * still called so.
   */
  private static final int[][] HUES = {
    {12, 0xee3333},
    {22, 0xd55e00},
    {45, 0xe69f00},
    {75, 0xf0e442},
    {170, 0x009e73},
    {208, 0x56b4e9},
    {260, 0x0072b2},
    {340, 0xcc79a7},
    {360, 0xee3333}
  };

  /** Saturation below which a colour counts as grey and stays. */
  private static final float GREY = 0.22f;

  private static final IntIntMap MAPPED = new IntIntMap();
  private static boolean colourBlind;

  private UiColours() {}

  /** Sets the colours in which everything is drawn from now on. */
  public static void palette(Palette palette) {
    colourBlind = palette == Palette.COLOUR_BLIND;
    Color.rgb888ToColor(GOOD, colourBlind ? 0x009e73 : 0x5ad18a);
    Color.rgb888ToColor(BAD, colourBlind ? 0xd55e00 : 0xff6b5e);
    Color.rgb888ToColor(INFO, colourBlind ? 0x56b4e9 : 0x5aa9ff);
  }

  /** Returns the colour of the palette for a colour of a game. */
  private static int mapped(int rgb) {
    if (!colourBlind) {
      return rgb;
    }
    int known = MAPPED.get(rgb, -1);
    if (known < 0) {
      known = forAll(rgb);
      MAPPED.put(rgb, known);
    }
    return known;
  }

  /** Returns the colour that all people tell apart for a hue, as bright as the one given. */
  static int forAll(int rgb) {
    int r = rgb >> 16 & 0xff;
    int g = rgb >> 8 & 0xff;
    int b = rgb & 0xff;
    int max = Math.max(r, Math.max(g, b));
    int min = Math.min(r, Math.min(g, b));
    if (max - min <= GREY * max) {
      return rgb;
    }
    float sixths;
    if (max == r) {
      sixths = (g - b) / (float) (max - min);
    } else if (max == g) {
      sixths = 2 + (b - r) / (float) (max - min);
    } else {
      sixths = 4 + (r - g) / (float) (max - min);
    }
    float hue = (60 * sixths + 360) % 360;
    int near = 0;
    for (int i = 0; i < HUES.length && near == 0; i++) {
      near = hue < HUES[i][0] ? HUES[i][1] : 0;
    }
    int brightest = Math.max(near >> 16 & 0xff, Math.max(near >> 8 & 0xff, near & 0xff));
    float scale = max / (float) brightest;
    return Math.round((near >> 16 & 0xff) * scale) << 16
        | Math.round((near >> 8 & 0xff) * scale) << 8
        | Math.round((near & 0xff) * scale);
  }

  /** Returns an opaque colour from 0xRRGGBB. */
  public static Color rgb(int rgb) {
    return new Color((rgb << 8) | 0xff);
  }

  /**
   * Sets {@code out} to 0xRRGGBB, scaled towards black (below 1) or white (above 1), with an
   * opacity.
   */
  public static Color shade(int rgb, float scale, float alpha, Color out) {
    Color.rgb888ToColor(out, mapped(rgb));
    if (scale <= 1) {
      out.mul(scale, scale, scale, 1);
    } else {
      out.lerp(Color.WHITE, Math.min(1, scale - 1));
    }
    out.a = alpha;
    return out;
  }
}
