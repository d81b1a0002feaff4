package carom.plain;

/** Says what the client shows; in large levels the server tells what is in it. */
public final class View {
  /** Centre while the player has no body, metres. */
  public float x;

  /** Centre while the player has no body, metres. */
  public float y;

  /** Half the width of the picture, metres. */
  public float halfWidth;

  /** Half the height of the picture, metres. */
  public float halfHeight;

  /** Creates one to be filled in. */
  public View() {}

  /** Creates one around the player's body. */
  public View(float halfWidth, float halfHeight) {
    this.halfWidth = halfWidth;
    this.halfHeight = halfHeight;
  }
}
