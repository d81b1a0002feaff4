package carom.client.look;

import carom.physics.math.Limits;

/**
 * Small things that fly for a moment and fade: sparks, smoke, splinters, confetti. They are part of
 * the picture only, hit nothing, and cost no traffic. Each method changes it and returns it, and
 * throws {@link IllegalArgumentException} for a value outside its range.
 *
 * <pre>{@code
 * v.event("boom", Particles.burst(60).speed(2, 9).seconds(0.3f, 0.9f).colour(0xffe08a, 0xc0392b).glow());
 * v.trail("rocket", Particles.stream(80).speed(0, 1).size(0.3f, 0.05f).colour(0x888888, 0x222222));
 * }</pre>
 */
public final class Particles implements Effect {
  /** Most particles of a burst, and of a stream in a second. */
  public static final int MAX = 500;

  private final int count;
  private float leastSpeed = 1;
  private float mostSpeed = 4;
  private float leastSeconds = 0.3f;
  private float mostSeconds = 0.7f;
  private float sizeAtFirst = 0.15f;
  private float sizeAtLast = 0.02f;
  private int rgbAtFirst = -1;
  private int rgbAtLast = -1;
  private float alpha = 1;
  private float gravity;
  private float drag;
  private float spread = (float) Math.PI;
  private boolean glows;
  private String picture = "";

  private Particles(int count) {
    this.count = Range.check("particles", count, 1, MAX);
  }

  /**
   * Returns 1..{@value #MAX} that fly apart at once. The harder the event or blow, the more there
   * are.
   */
  public static Particles burst(int count) {
    return new Particles(count);
  }

  /** Returns 1..{@value #MAX} in each second, for a trail. */
  public static Particles stream(int perSecond) {
    return new Particles(perSecond);
  }

  /** Sets how fast they begin to fly, 0..1,000 m/s. */
  public Particles speed(float least, float most) {
    Range.checkPair("speed", least, most, 0, 1_000);
    leastSpeed = least;
    mostSpeed = most;
    return this;
  }

  /** Sets for how long they fly, 0.02..10 seconds. */
  public Particles seconds(float least, float most) {
    Range.checkPair("seconds", least, most, 0.02f, 10);
    leastSeconds = least;
    mostSeconds = most;
    return this;
  }

  /** Sets their half size at first and at last, 0..100 metres. */
  public Particles size(float atFirst, float atLast) {
    Range.check("size at first", atFirst, 0, 100);
    sizeAtLast = Range.check("size at last", atLast, 0, 100);
    sizeAtFirst = atFirst;
    return this;
  }

  /** Sets their colour at first and at last, 0xRRGGBB; without it, that of the event or body. */
  public Particles colour(int atFirst, int atLast) {
    rgbAtFirst = atFirst & 0xffffff;
    rgbAtLast = atLast & 0xffffff;
    return this;
  }

  /** Sets how opaque they begin, 0..1. */
  public Particles alpha(float share) {
    alpha = Range.check("particles' alpha", share, 0, 1);
    return this;
  }

  /** Sets how they fall, -100..100: 1 as bodies of the level do, below 0 they rise. */
  public Particles gravity(float share) {
    gravity = Range.check("particles' gravity", share, -100, 100);
    return this;
  }

  /** Sets how soon they slow down, 0..1,000 1/s. */
  public Particles drag(float perSecond) {
    drag = Range.check("particles' drag", perSecond, 0, 1_000);
    return this;
  }

  /**
   * Sets the half angle of the cone in which they fly, 0..π radians. Its middle is where a blow
   * pushes the body, and for a trail where the body comes from. Without it, they fly in all
   * directions.
   */
  public Particles spread(float radians) {
    spread = Range.check("particles' spread", radians, 0, (float) Math.PI);
    return this;
  }

  /** Adds their light to what is behind them, as fire does. */
  public Particles glow() {
    glows = true;
    return this;
  }

  /** Sets a picture to draw instead of a soft dot. */
  public Particles picture(String file) {
    picture = Limits.notNull("picture", file);
    return this;
  }

  /** Returns how many there are in a burst, or in a second of a stream. */
  public int count() {
    return count;
  }

  /** Returns a value between two, such as the speed of the next one. */
  private static float between(float least, float most, float random) {
    return least + (most - least) * random;
  }

  /** Returns the speed for a random number of 0..1, m/s. */
  public float speed(float random) {
    return between(leastSpeed, mostSpeed, random);
  }

  /** Returns the time to live for a random number of 0..1, seconds. */
  public float seconds(float random) {
    return between(leastSeconds, mostSeconds, random);
  }

  /** Returns the half size when a share of the life is over, metres. */
  public float size(float over) {
    return between(sizeAtFirst, sizeAtLast, over);
  }

  /** Returns the colour at first, 0xRRGGBB; -1 for that of the event or body. */
  public int rgbAtFirst() {
    return rgbAtFirst;
  }

  /** Returns the colour at last, 0xRRGGBB; -1 for that of the event or body. */
  public int rgbAtLast() {
    return rgbAtLast;
  }

  /** Returns how opaque they begin, 0..1. */
  public float alpha() {
    return alpha;
  }

  /** Returns how they fall, in shares of the level's gravity. */
  public float gravity() {
    return gravity;
  }

  /** Returns how soon they slow down, 1/s. */
  public float drag() {
    return drag;
  }

  /** Returns the half angle of the cone in which they fly, radians. */
  public float spread() {
    return spread;
  }

  /** Returns whether they add their light to what is behind them. */
  public boolean isGlowing() {
    return glows;
  }

  /** Returns the name of the picture's file; empty for a soft dot. */
  public String picture() {
    return picture;
  }
}
