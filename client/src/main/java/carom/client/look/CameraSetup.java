package carom.client.look;

/**
 * The part of the level that the window shows. Without a view's word it is the whole level if that
 * fits at a readable size, or else 16 m of it around the player. Each method changes it and returns
 * it.
 *
 * <pre>{@code
 * v.camera().height(18).lead(0.35f);        // a chase
 * v.camera().height(14).framesAll();        // a duel
 * }</pre>
 */
public final class CameraSetup {
  private float height;
  private float leadSeconds;
  private boolean framesAll;

  CameraSetup() {}

  /** Sets the height that it shows while it follows a player, 4..200 metres. */
  public CameraSetup height(float metres) {
    height = Range.check("a camera's height", metres, 4, 200);
    return this;
  }

  /** Looks ahead to where the player will be in 0..2 seconds at the present velocity. */
  public CameraSetup lead(float seconds) {
    leadSeconds = Range.check("a camera's lead", seconds, 0, 2);
    return this;
  }

  /** Keeps the bodies of all players in the picture; {@link #height} is then the least. */
  public CameraSetup framesAll() {
    framesAll = true;
    return this;
  }

  /** Returns the height that it shows, metres; 0 for the usual. */
  public float height() {
    return height;
  }

  /** Returns how far ahead it looks, seconds of the player's way. */
  public float leadSeconds() {
    return leadSeconds;
  }

  /** Returns whether it keeps all players in the picture. */
  public boolean isFramingAll() {
    return framesAll;
  }
}
