package carom.client.look;

import carom.physics.math.Limits;
import carom.sim.field.Countdown;
import carom.sim.field.EntityRef;
import carom.sim.field.Field;
import carom.sim.field.PlayerRef;
import java.util.Locale;

/**
 * A line of the own player's panel, from a field of the game: a bar, a number, a time, a word, or
 * icons. Lines of a view take the place of the game's own bars and numbers. Each method changes it
 * and returns it.
 *
 * <pre>{@code
 * v.hud(
 *     HudItem.bar("shield", SHIELD).colour(0x4cc9f0),
 *     HudItem.icons("heart.png", LIVES),
 *     HudItem.time("back in", OUT).whileSet(OUT).at(HudItem.Place.TOP));
 * }</pre>
 */
public final class HudItem {
  /** The ways to show a value. */
  public enum Kind {
    /** A bar that is full at the field's greatest value. */
    BAR,
    /** The field's value. */
    NUMBER,
    /** The seconds of a countdown, or of a number of seconds. */
    TIME,
    /** A picture for each unit of the value. */
    ICONS,
    /** A choice's constant, or the name of a player. */
    WORD
  }

  /** A place at the edge, which has one panel for its lines. It gives way to the own body. */
  public enum Place {
    /** The lower edge, in the middle. */
    BOTTOM,
    /** The lower left corner. */
    BOTTOM_LEFT,
    /** The lower right corner. */
    BOTTOM_RIGHT,
    /** The upper edge, in the middle. */
    TOP,
    /** The upper left corner. */
    TOP_LEFT
  }

  /** Largest factor of a line. */
  public static final float MAX_SCALE = 1e6f;

  /** Most decimals of a line. */
  public static final int MAX_DECIMALS = 6;

  /** Most icons of a line. */
  public static final int MAX_ICONS = 12;

  private final Kind kind;
  private final String label;
  private final ShownValue value;
  private ShownValue condition;
  private Place place = Place.BOTTOM;
  private int rgb = -1;
  private float scale = 1;
  private int decimals;

  private HudItem(Kind kind, String label, Field<?> field) {
    this.kind = kind;
    this.label = Limits.notNull("label", label);
    value = ShownValue.of(field);
    boolean isReference = field instanceof PlayerRef || field instanceof EntityRef;
    if (kind == Kind.WORD ? !value.isWord() : isReference) {
      throw new IllegalArgumentException(
          (kind == Kind.WORD ? "a word" : "a number")
              + " can't show "
              + field.path()
              + "; word shows choices and players, the others show what counts");
    }
  }

  /** Returns a bar: of a share as it is, of a count from its least to its greatest value. */
  public static HudItem bar(String label, Field<?> field) {
    if (field instanceof Countdown) {
      throw new IllegalArgumentException(
          "a bar can't show " + field.path() + ", which has no greatest value; use time or number");
    }
    return new HudItem(Kind.BAR, label, field);
  }

  /** Returns a number. */
  public static HudItem number(String label, Field<?> field) {
    return new HudItem(Kind.NUMBER, label, field);
  }

  /** Returns the seconds that a countdown has left; other fields are taken as seconds. */
  public static HudItem time(String label, Field<?> field) {
    return new HudItem(Kind.TIME, label, field);
  }

  /** Returns a choice's constant in lower case, or the name of the player that a field means. */
  public static HudItem word(String label, Field<?> field) {
    return new HudItem(Kind.WORD, label, field);
  }

  /** Returns as many pictures as the value says, up to {@link #MAX_ICONS}. */
  public static HudItem icons(String file, Field<?> field) {
    return new HudItem(Kind.ICONS, file, field);
  }

  /** Shows it only while a field is other than 0, or means a player or an entity. */
  public HudItem whileSet(Field<?> field) {
    condition = ShownValue.of(field);
    return this;
  }

  /** Sets where it stands; at the lower edge without it. */
  public HudItem at(Place where) {
    place = Limits.notNull("place", where);
    return this;
  }

  /** Sets the colour of a bar, 0xRRGGBB; without it, green and red below 30 %. */
  public HudItem colour(int newRgb) {
    rgb = newRgb & 0xffffff;
    return this;
  }

  /**
   * Multiplies what a number or a time shows, such as by 3.6 to show m/s as km/h, or by 0.001 to
   * show milliseconds as seconds.
   *
   * @param factor within {@link #MAX_SCALE} on both sides of 0; 1 without it
   */
  public HudItem scale(float factor) {
    requireFigures("scale");
    scale = Range.check("factor", factor, -MAX_SCALE, MAX_SCALE);
    return this;
  }

  /**
   * Sets how many digits stand behind the point of a number or a time. Without it a number is
   * rounded to a whole one, and a time is rounded up.
   *
   * @param digits 0 to {@link #MAX_DECIMALS}
   */
  public HudItem decimals(int digits) {
    requireFigures("decimals");
    decimals = Range.check("digits", digits, 0, MAX_DECIMALS);
    return this;
  }

  private void requireFigures(String word) {
    if (kind != Kind.NUMBER && kind != Kind.TIME) {
      throw new IllegalArgumentException(
          "a "
              + kind.name().toLowerCase(Locale.ROOT)
              + " has no "
              + word
              + "; a number or time has");
    }
  }

  /** Returns what it shows. */
  public Kind kind() {
    return kind;
  }

  /** Returns the word before it; for icons, the picture's file. */
  public String label() {
    return label;
  }

  /** Returns the value that it shows. */
  public ShownValue value() {
    return value;
  }

  /** Returns the value without which it doesn't show; null if it always does. */
  public ShownValue condition() {
    return condition;
  }

  /** Returns where it stands. */
  public Place place() {
    return place;
  }

  /** Returns by what a number or a time is multiplied. */
  public float scale() {
    return scale;
  }

  /** Returns how many digits stand behind the point. */
  public int decimals() {
    return decimals;
  }

  /** Returns the colour of a bar, 0xRRGGBB; -1 for the usual ones. */
  public int rgb() {
    return rgb;
  }
}
