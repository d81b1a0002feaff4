package carom.client.interpolation;

/**
 * The offset between the drawn pose and the corrected state of a body. A correction changes the
 * state at once; the picture follows smoothly while this offset fades.
 *
 * <p>The offset shrinks by a factor of e every {@value #FADE_MS} ms: three metres are below a
 * centimetre after 250 ms. A larger offset is dropped, so that the picture jumps. Mutable; one
 * body's.
 */
public final class VisualError {
  /** Time in which an offset shrinks by a factor of e, milliseconds. */
  public static final int FADE_MS = 42;

  /** Largest offset, metres. A longer glide would look like flying. */
  private static final float SNAP_METRES = 3;

  /** Smallest offset, metres; a player wouldn't see less. */
  private static final float LEAST_METRES = 1e-4f;

  private static final float LEAST_RADIANS = 1e-4f;

  private float x;
  private float y;
  private float angle;

  /** Creates an offset of 0. */
  public VisualError() {}

  /** Sets the offset to 0. */
  public void clear() {
    x = 0;
    y = 0;
    angle = 0;
  }

  /** Adds to the offset: the body jumped by the negative of this. */
  public void add(float dx, float dy, float dAngle) {
    x += dx;
    y += dy;
    angle += dAngle;
    if (metres() > SNAP_METRES) {
      clear();
    }
  }

  /** Lets the offset fade. */
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

  /** Adds the offset to a pose. */
  public void addTo(Pose pose) {
    pose.x += x;
    pose.y += y;
    pose.angle += angle;
  }

  /** Returns the length of the offset, metres. */
  public float metres() {
    return (float) Math.sqrt(x * x + y * y);
  }
}
