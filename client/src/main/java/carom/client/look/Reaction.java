package carom.client.look;

/**
 * A reaction of a body's picture to a blow: it is squeezed along the blow and springs back, lights
 * up, or sticks for a moment before it catches up. It is part of the picture only. With {@link
 * ViewSetup#event} it happens to the event's first entity. Each method changes it and returns it,
 * and throws {@link IllegalArgumentException} for a value outside its range.
 *
 * <pre>{@code
 * v.blow("player", new Reaction().squash(0.35f).flash(0xffffff));
 * v.event("hit", new Reaction().hold(0.06f).flash(0xff4d6d), SoundFile.of("hit.wav"));
 * }</pre>
 */
public final class Reaction implements Effect {
  private float squash;
  private float hold;
  private int flashRgb = -1;
  private float seconds = 0.3f;

  /** Creates a reaction that shows nothing yet. */
  public Reaction() {}

  /** Squeezes it along the blow by a share of its size, 0..0.9, for a hard blow. */
  public Reaction squash(float share) {
    squash = Range.check("a reaction's squash", share, 0, 0.9f);
    return this;
  }

  /** Lights it up in a colour, 0xRRGGBB. */
  public Reaction flash(int rgb) {
    flashRgb = rgb & 0xffffff;
    return this;
  }

  /** Holds it where it was struck for 0..0.3 seconds; then it catches up. */
  public Reaction hold(float length) {
    hold = Range.check("a reaction's hold", length, 0, 0.3f);
    return this;
  }

  /** Sets how long it springs and glows, 0.05..3 seconds; 0.3 without it. */
  public Reaction seconds(float length) {
    seconds = Range.check("a reaction's seconds", length, 0.05f, 3);
    return this;
  }

  /** Returns the share by which a hard blow squeezes it, 0..0.9. */
  public float squash() {
    return squash;
  }

  /** Returns for how long it stays where it was struck, seconds. */
  public float hold() {
    return hold;
  }

  /** Returns the colour in which it lights up, 0xRRGGBB; -1 for none. */
  public int flashRgb() {
    return flashRgb;
  }

  /** Returns how long it springs and glows. */
  public float seconds() {
    return seconds;
  }
}
