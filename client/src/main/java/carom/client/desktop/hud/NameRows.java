package carom.client.desktop.hud;

/**
 * Chooses the row above a body in which its player's name is written: the lowest that is free. A
 * name comes down again only where there is room to spare, so that it doesn't jump while two bodies
 * move side by side. Points, origin bottom left. Render thread only; no allocation.
 */
final class NameRows {
  /** Height of a row. */
  static final float LINE = 17;

  /** Rows above a body. */
  static final int ROWS = 3;

  private static final float GAP = 6;

  /** Additional room on each side that a name needs to come down. */
  private static final float TO_SPARE = 10;

  private final FreePlaces places;
  private final byte[] rows;

  /**
   * Creates the rows of a frame.
   *
   * @param places what is taken already in this frame
   * @param players names are those of players below this number
   */
  NameRows(FreePlaces places, int players) {
    this.places = places;
    rows = new byte[players];
  }

  /**
   * Takes the place for a player's name.
   *
   * @param x the name's middle
   * @param y the lowest row's upper edge
   * @param width the name's
   * @return the row's upper edge, or NaN when no row has room
   */
  float top(int player, float x, float y, float width) {
    float wide = width + GAP;
    for (int row = 0; row < ROWS; row++) {
      float top = y + row * LINE;
      float more = row < rows[player] ? TO_SPARE : 0;
      if (places.isFree(x - wide / 2 - more, top - LINE - more, wide + 2 * more, LINE + 2 * more)) {
        places.take(x - wide / 2, top - LINE, wide, LINE);
        rows[player] = (byte) row;
        return top;
      }
    }
    return Float.NaN;
  }
}
