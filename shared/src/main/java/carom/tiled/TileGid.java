package carom.tiled;

/**
 * A tile as it lies in a cell: which one, and how it is flipped. Tiled swaps x and y first, then
 * mirrors horizontally, then vertically.
 *
 * @param gid global id, 0 for no tile
 */
record TileGid(int gid, boolean swapped, boolean mirroredX, boolean mirroredY) {
  private static final int MIRRORED_X = 1 << 31;
  private static final int MIRRORED_Y = 1 << 30;
  private static final int SWAPPED = 1 << 29;
  private static final int ID = 0x0fffffff; // a fourth flag is for hexagonal maps

  static TileGid of(int raw) {
    return new TileGid(
        raw & ID, (raw & SWAPPED) != 0, (raw & MIRRORED_X) != 0, (raw & MIRRORED_Y) != 0);
  }

  /** Returns where a point of the tile comes to lie; width and height are the tile's own. */
  double[] place(double x, double y, double width, double height) {
    double px = swapped ? y : x;
    double py = swapped ? x : y;
    double w = swapped ? height : width;
    double h = swapped ? width : height;
    return new double[] {mirroredX ? w - px : px, mirroredY ? h - py : py};
  }
}
