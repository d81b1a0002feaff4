package carom.client.look;

/**
 * Draws figures, texts and pictures over the picture, for a {@link HudPainter}. Lengths are points,
 * from the lower left corner of the window; a point is a pixel unless the screen is dense. Colours
 * are 0xRRGGBB, alpha goes from 0 to 1. Later figures cover earlier ones. Only for the call that
 * got it.
 */
public interface HudCanvas {
  /** Returns the width of the window. */
  float width();

  /** Returns the height of the window. */
  float height();

  /** Returns how far from the left a place of the level is, whose coordinates are metres. */
  float screenX(float x, float y);

  /** Returns how far from below a place of the level is, whose coordinates are metres. */
  float screenY(float x, float y);

  /** Fills a rectangle, of which the lower left corner is given. */
  void rect(float x, float y, float w, float h, int rgb, float alpha);

  /** Fills a disc. */
  void disc(float x, float y, float radius, int rgb, float alpha);

  /** Draws a line. */
  void line(float x1, float y1, float x2, float y2, float width, int rgb, float alpha);

  /** Writes a text that begins at x; y is the upper edge of its capitals. */
  void text(String text, float x, float y, int rgb);

  /** Writes a large text that begins at x; y is the upper edge of its capitals. */
  void title(String text, float x, float y, int rgb);

  /** Returns the width of a text as {@link #text} writes it. */
  float textWidth(String text);

  /** Returns the width of a text as {@link #title} writes it. */
  float titleWidth(String text);

  /**
   * Draws a picture, of which the lower left corner is given. One that isn't there is left out.
   *
   * @param file as {@link ViewSetup#sprite} has it
   */
  void picture(String file, float x, float y, float w, float h);
}
