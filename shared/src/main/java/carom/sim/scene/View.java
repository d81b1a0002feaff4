package carom.sim.scene;

/**
 * The part of the world that a scene shows.
 *
 * @param x its centre, m
 * @param y its centre, m
 * @param width least width to show, m
 * @param height least height to show, m
 */
public record View(float x, float y, float width, float height) {
  /**
   * Checks the size.
   *
   * @throws IllegalArgumentException if it is not positive
   */
  public View {
    if (!(width > 0 && height > 0)) {
      throw new IllegalArgumentException(
          "width=" + width + " height=" + height + " must be more than 0 m");
    }
  }
}
