package carom.client.look;

/**
 * A shake of the picture, weaker the farther away its cause is. Each method changes it and returns
 * it.
 *
 * <pre>{@code
 * v.event("boom", Shake.by(0.35f), Particles.burst(60));
 * }</pre>
 */
public final class Shake implements Effect {
  /** Largest way, metres. */
  public static final float MAX_METRES = 2;

  private final float metres;
  private float seconds = 0.4f;

  private Shake(float metres) {
    this.metres = Range.check("a shake's metres", metres, 0, MAX_METRES);
  }

  /** Returns a shake that moves the picture 0..2 metres if its cause is hard and near. */
  public static Shake by(float metres) {
    return new Shake(metres);
  }

  /** Sets for how long it shakes, 0.05..3 seconds; 0.4 without it. */
  public Shake seconds(float length) {
    seconds = Range.check("a shake's seconds", length, 0.05f, 3);
    return this;
  }

  /** Returns how far it moves the picture, metres. */
  public float metres() {
    return metres;
  }

  /** Returns for how long it shakes, seconds. */
  public float seconds() {
    return seconds;
  }
}
