package carom.client.look;

import carom.physics.math.Limits;
import carom.sim.field.Count;
import carom.sim.field.Field;
import carom.sim.field.Ratio;

/**
 * A picture that is drawn for each entity of an archetype, or for each piece of a level of that
 * name, in place of its shapes. Several sprites of an archetype lie on each other in the order in
 * which they were declared. Each method changes it and returns it, and throws {@link
 * IllegalArgumentException} for a value outside its range.
 *
 * <pre>{@code
 * v.sprite("car", "car.png").size(2.8f, 1.2f).tint();
 * v.sprite("runner", "runner.png").size(1, 2).frames(6).perMetre(2).upright().flips();
 * v.sprite("door", "door.png").frames(2).by(OPEN);
 * v.sprite("wall", "bricks.png").size(2, 2).tiled();
 * }</pre>
 */
public final class Sprite {
  /** The direction in which a sprite points. */
  public enum Turn {
    /** The direction of the body's angle. */
    BODY,
    /** The direction of the level's x axis, however the body is turned. */
    UPRIGHT,
    /** The direction in which the body moves; the last one while it stands. */
    MOVE,
    /** The direction of the own player's aim; that of others' movement. */
    AIM
  }

  private final String archetype;
  private final String file;
  private float width;
  private float height;
  private float offsetX;
  private float offsetY;
  private int frames = 1;
  private float framesPerSecond;
  private float framesPerMetre;
  private ShownValue frame;
  private Turn turn = Turn.BODY;
  private boolean flips;
  private boolean tiled;
  private boolean ofPlayer;
  private int rgb = 0xffffff;

  Sprite(String archetype, String file) {
    this.archetype = Limits.notNull("archetype", archetype);
    this.file = Limits.notNull("file", file);
  }

  /**
   * Sets its size, 0.01..2,000 metres each. Without it, the picture is as wide as the archetype's
   * shapes.
   */
  public Sprite size(float newWidth, float newHeight) {
    Range.check("a sprite's width", newWidth, 0.01f, 2_000);
    height = Range.check("a sprite's height", newHeight, 0.01f, 2_000);
    width = newWidth;
    return this;
  }

  /** Moves it, ±2,000 metres in its own frame: x is where it points. */
  public Sprite at(float x, float y) {
    Range.check("a sprite's place", x, -2_000, 2_000);
    offsetY = Range.check("a sprite's place", y, -2_000, 2_000);
    offsetX = x;
    return this;
  }

  /** Divides the picture into 1..256 frames of equal width, side by side; the first one shows. */
  public Sprite frames(int count) {
    frames = Range.check("a sprite's frames", count, 1, 256);
    return this;
  }

  /** Shows the frames one after the other, ±1,000 a second; below 0 from the last to the first. */
  public Sprite perSecond(float count) {
    framesPerSecond = Range.check("frames per second", count, -1_000, 1_000);
    return this;
  }

  /** Shows the frames one after the other as the body moves, ±1,000 for each metre. */
  public Sprite perMetre(float count) {
    framesPerMetre = Range.check("frames per metre", count, -1_000, 1_000);
    return this;
  }

  /**
   * Shows the frame of a value: a {@link Count} from its least value on, the constant of a choice,
   * the second frame of a flag that is set, that share of the frames for a {@link Ratio}. A value
   * beyond shows the last frame.
   */
  public Sprite by(Field<?> field) {
    frame = ShownValue.of(field);
    return this;
  }

  /** Sets the direction in which it points; without it, that of the body. */
  public Sprite turn(Turn direction) {
    turn = Limits.notNull("direction", direction);
    return this;
  }

  /** Keeps it upright, however the body is turned. */
  public Sprite upright() {
    return turn(Turn.UPRIGHT);
  }

  /** Mirrors it while the body moves to the left, or while it points there. */
  public Sprite flips() {
    flips = true;
    return this;
  }

  /** Repeats the picture, at its size, over each box of the archetype's shapes. */
  public Sprite tiled() {
    tiled = true;
    return this;
  }

  /** Multiplies its colours by that of the player, or else by the archetype's. */
  public Sprite tint() {
    ofPlayer = true;
    return this;
  }

  /** Multiplies its colours by a colour, 0xRRGGBB. */
  public Sprite tint(int newRgb) {
    rgb = newRgb & 0xffffff;
    return this;
  }

  /** Returns the name of the archetype. */
  public String archetype() {
    return archetype;
  }

  /** Returns the name of the picture's file. */
  public String file() {
    return file;
  }

  /** Returns its width, metres; 0 for that of the archetype. */
  public float width() {
    return width;
  }

  /** Returns its height, metres; 0 for that of its picture at the archetype's width. */
  public float height() {
    return height;
  }

  /** Returns where its middle is, metres along the direction in which it points. */
  public float offsetX() {
    return offsetX;
  }

  /** Returns where its middle is, metres to the left of the direction in which it points. */
  public float offsetY() {
    return offsetY;
  }

  /** Returns the number of its frames. */
  public int frames() {
    return frames;
  }

  /** Returns how many frames show in a second. */
  float framesPerSecond() {
    return framesPerSecond;
  }

  /** Returns how many frames show for each metre. */
  float framesPerMetre() {
    return framesPerMetre;
  }

  /** Returns the direction in which it points. */
  public Turn turn() {
    return turn;
  }

  /** Returns whether it is mirrored when it goes to the left. */
  public boolean isFlipping() {
    return flips;
  }

  /** Returns whether it is repeated over boxes. */
  public boolean isTiled() {
    return tiled;
  }

  /** Returns whether it has the colour of its player. */
  public boolean isTinted() {
    return ofPlayer;
  }

  /** Returns the colour by which its own are multiplied, 0xRRGGBB. */
  public int rgb() {
    return rgb;
  }

  /** Returns what chooses the frame, or null. */
  public ShownValue frameBy() {
    return frame;
  }

  /**
   * Returns the frame to show, 0..{@link #frames} - 1.
   *
   * @param value of {@link #frameBy}, 0 without it
   * @param seconds since some moment
   * @param metres that the body has moved
   */
  public int frame(float value, double seconds, double metres) {
    if (frame == null) {
      long shown = (long) Math.floor(framesPerSecond * seconds + framesPerMetre * metres);
      return Math.floorMod(shown, frames);
    }
    float chosen = value;
    if (frame.field() instanceof Count count) {
      chosen -= count.min();
    } else if (frame.field() instanceof Ratio) {
      chosen *= frames;
    }
    return Math.max(0, Math.min(frames - 1, (int) chosen));
  }
}
