package carom.client.prediction;

import carom.client.interpolation.Pose;

/**
 * What a correction moved a body by, still shown and fading: the state jumps at once, the picture
 * glides after it. The offset shrinks by a factor of e each {@value #FADE_MS} ms; half a metre is
 * below a centimetre after 200 ms. What is too far to glide is shown at once.
 */
final class VisualError {
  static final int FADE_MS = 50;

  /** Farther than this a glide would look like flying. */
  private static final float SNAP_METRES = 3;

  private float x;
  private float y;
  private float angle;

  void clear() {
    x = 0;
    y = 0;
    angle = 0;
  }

  /** The body jumped by the negative of this. */
  void add(float dx, float dy, float dAngle) {
    x += dx;
    y += dy;
    angle += dAngle;
    if (metres() > SNAP_METRES) {
      clear();
    }
  }

  /** Lets time pass. */
  void fade(float seconds) {
    float keep = (float) Math.exp(-seconds * 1_000 / FADE_MS);
    x *= keep;
    y *= keep;
    angle *= keep;
  }

  void addTo(Pose pose) {
    pose.x += x;
    pose.y += y;
    pose.angle += angle;
  }

  float metres() {
    return (float) Math.sqrt(x * x + y * y);
  }
}
