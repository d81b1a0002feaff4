package carom.client.look;

/**
 * Shows an event again in slow motion: the picture's last moments, while the game goes on behind
 * them. It disturbs nobody who plays: those see it who watch or are out, and all once the match is
 * over. Any key ends it. Each method changes it and returns it.
 *
 * <pre>{@code
 * v.event("goal", SlowMotion.last(1).speed(0.4f));
 * }</pre>
 */
public final class SlowMotion implements Effect {
  /** Longest time that is shown again, seconds. */
  public static final float MAX_SECONDS = 3;

  private final float seconds;
  private float speed = 0.4f;

  private SlowMotion(float seconds) {
    this.seconds = Range.check("a slow motion's seconds", seconds, 0.2f, MAX_SECONDS);
  }

  /** Returns one that begins 0.2..{@value #MAX_SECONDS} seconds before the event. */
  public static SlowMotion last(float seconds) {
    return new SlowMotion(seconds);
  }

  /** Sets its speed, 0.1..1 of the game's; 0.4 without it. */
  public SlowMotion speed(float share) {
    speed = Range.check("a slow motion's speed", share, 0.1f, 1);
    return this;
  }

  /** Returns how long before the event it begins, seconds. */
  public float seconds() {
    return seconds;
  }

  /** Returns its speed, a share of the game's. */
  public float speed() {
    return speed;
  }
}
