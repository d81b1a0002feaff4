package carom.plain;

/** A convex piece. */
public final class Part {
  /** Radius by which it is rounded, metres. */
  public float radius;

  /** Corners, x and y of each: one of a circle, two of a capsule; metres. */
  public float[] corners;

  /** Creates one to be filled in. */
  public Part() {}
}
