package carom.plain;

/** Colours behind the bodies. */
public final class Theme {
  /** Colour at the bottom, 0xRRGGBB. */
  public int background;

  /** Colour at the top, 0xRRGGBB. */
  public int sky;

  /** Colour of the grid, 0xRRGGBB. */
  public int grid;

  /** Creates one to be filled in. */
  public Theme() {}
}
