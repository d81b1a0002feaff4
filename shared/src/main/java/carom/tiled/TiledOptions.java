package carom.tiled;

/**
 * Options of a conversion, which go before what the map says.
 *
 * @param game for which the level is; empty for the map's property {@code game}, or else {@code
 *     platformer}
 * @param name of the level; empty for the map's property {@code name}, or else that of the file
 * @param pixelsPerMetre 0 for the map's property {@code pixelsPerMetre}, or else the width of a
 *     tile
 */
public record TiledOptions(String game, String name, double pixelsPerMetre) {
  /** All as the map says. */
  public static final TiledOptions NONE = new TiledOptions("", "", 0);
}
