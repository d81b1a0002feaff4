package carom.tiled;

/**
 * The scale of a map, by which its places become places of a level: pixels become metres, and y
 * points up.
 *
 * @param pixelsPerMetre above 0
 * @param bottom y of the level's y = 0 in the map, pixels
 */
record MapScale(double pixelsPerMetre, double bottom) {
  /** Returns a length in metres. */
  double length(double pixels) {
    return pixels / pixelsPerMetre;
  }

  /** Returns an x in metres. */
  double x(double pixels) {
    return pixels / pixelsPerMetre;
  }

  /** Returns a y in metres. */
  double y(double pixels) {
    return (bottom - pixels) / pixelsPerMetre;
  }
}
