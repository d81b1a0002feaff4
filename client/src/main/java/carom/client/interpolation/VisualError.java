package carom.client.interpolation;

/**
 * What a correction moved a body by, still shown and fading: the state jumps at once, the picture
 * glides after it. The offset shrinks by a factor of e each {@value #FADE_MS} ms; three metres, the
 * farthest that glides, are below a centimetre after 250 ms; what is farther is shown at once.
 * Mutable; one body's.
 */
public final class VisualError {
  /** Time in which an offset shrinks by a factor of e, milliseconds. */
  public static final int FADE_MS = 42;

  /** Farther than this a glide would look like flying. */
  private static final float SNAP_METRES = 3;

  /** Less than that nobody sees. */
  private static final float LEAST_METRES = 1e-4f;

  private static final float LEAST_RADIANS = 1e-4f;

  private float x;
  private float y;
  private float angle;

  /** Creates none. */
  public VisualError() {}

  /** Nothing is left of it: what follows is shown where it is. */
  public void clear() {
    x = 0;
    y = 0;
    angle = 0;
  }

  /** The body jumped by the negative of this. */
  public void add(float dx, float dy, float dAngle) {
    x += dx;
    y += dy;
    angle += dAngle;
    if (metres() > SNAP_METRES) {
      clear();
    }
  }

  /** Lets time pass. */
  public void fade(float seconds) {
    if (x == 0 && y == 0 && angle == 0) {
      return;
    }
    float keep = (float) Math.exp(-seconds * 1_000 / FADE_MS);
    x *= keep;
    y *= keep;
    angle *= keep;
    if (metres() < LEAST_METRES && Math.abs(angle) < LEAST_RADIANS) {
      clear();
    }
  }

  /** Moves a pose by what is left. */
  public void addTo(Pose pose) {
    pose.x += x;
    pose.y += y;
    pose.angle += angle;
  }

  /** How far it is, metres. */
  public float metres() {
    return (float) Math.sqrt(x * x + y * y);
  }
}
