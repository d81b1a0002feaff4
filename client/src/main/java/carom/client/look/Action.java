package carom.client.look;

import carom.physics.math.Limits;
import carom.sim.entity.Input;
import carom.text.Suggestion;
import java.util.ArrayList;
import java.util.List;

/**
 * Something that a player does in a game, with a name for people and the keys that do it unless the
 * player chooses others. It sets a part of {@link Input}: a button, the movement along an axis,
 * both by a place that is pointed at, or the aim. So nothing else is sent for it, and the game
 * reads it as {@code in.pressed(JUMP)} or {@code in.moveX()}.
 *
 * <pre>{@code
 * Action.button("jump", Input.JUMP).key("W", "Space").pad("A")
 * Action.moveX("left", "right").keys("A", "D").keys("Left", "Right").stick("left")
 * Action.aim("aim").mouse("pointer").stick("right")
 * }</pre>
 *
 * <p>Immutable: each method returns a changed copy, and throws {@link IllegalArgumentException} for
 * a name that there isn't.
 */
public final class Action {
  /** Longest name, characters. */
  public static final int MAX_NAME = 24;

  private static final List<String> MOUSE = List.of("left", "right", "middle");
  private static final List<String> PAD =
      List.of("A", "B", "X", "Y", "L1", "R1", "L3", "R3", "Back", "Start");
  private static final List<String> STICKS = List.of("left", "right", "d-pad");
  private static final String POINTER = "pointer";

  /** Keys that the window needs in every game. */
  private static final List<String> RESERVED =
      List.of("Escape", "F1", "F2", "F3", "F4", "F12", "Unknown");

  /** The part of the input that an action sets. */
  public enum Kind {
    /** A bit of {@link Input#buttons()}. */
    BUTTON,
    /** The movement to the right, {@link Input#moveX()}. */
    MOVE_X,
    /** The movement upwards, {@link Input#moveY()}. */
    MOVE_Y,
    /** A place, by both movements: the way from the body to where the player points. */
    POINT,
    /** The direction of {@link Input#aim()}. */
    AIM
  }

  /**
   * The keys that do one thing; a movement has one for each way. What the player chooses takes the
   * place of these keys.
   *
   * @param name what they do, for people and for the player's settings
   * @param keys their names, such as {@code Space}, {@code L-Shift} or {@code Left}
   */
  public record Binding(String name, List<String> keys) {
    private Binding with(List<String> more) {
      List<String> all = new ArrayList<>(keys);
      all.addAll(more);
      return new Binding(name, List.copyOf(all));
    }
  }

  private final Kind kind;
  private final int button;
  private final float range;
  private final List<Binding> bindings;
  private final List<String> mouse;
  private final List<String> pad;
  private final List<String> sticks;

  private Action(
      Kind kind,
      int button,
      float range,
      List<Binding> bindings,
      List<String> mouse,
      List<String> pad,
      List<String> sticks) {
    this.kind = kind;
    this.button = button;
    this.range = range;
    this.bindings = bindings;
    this.mouse = mouse;
    this.pad = pad;
    this.sticks = sticks;
  }

  private static Action of(Kind kind, int button, float range, String... names) {
    List<Binding> bindings = new ArrayList<>();
    for (String name : names) {
      bindings.add(new Binding(checked(name), List.of()));
    }
    return new Action(kind, button, range, List.copyOf(bindings), List.of(), List.of(), List.of());
  }

  private static String checked(String name) {
    if (Limits.notNull("action", name).isBlank()
        || name.length() > MAX_NAME
        || !name.matches("[\\p{L}\\p{N}' -]+")) {
      throw new IllegalArgumentException(
          "action=\"" + name + "\" is no name: 1 to " + MAX_NAME + " letters, digits and spaces");
    }
    return name;
  }

  /**
   * Returns an action that holds a button while a key of it is down.
   *
   * @param name what it does, in a word or two
   * @param button a bit of {@link Input#buttons()}, such as {@link Input#JUMP}; bits from {@code 1
   *     << 5} to {@code 1 << 15} have no other meaning
   */
  public static Action button(String name, int button) {
    if (Integer.bitCount(button) != 1 || button > 0xffff || button < 0) {
      throw new IllegalArgumentException(
          "action=\"" + name + "\": button=" + button + " is not one of the bits 1 << 0..15");
    }
    return of(Kind.BUTTON, button, 0, name);
  }

  /** Returns the movement to the left and to the right. */
  public static Action moveX(String left, String right) {
    return of(Kind.MOVE_X, 0, 0, left, right);
  }

  /** Returns the movement down and up. */
  public static Action moveY(String down, String up) {
    return of(Kind.MOVE_Y, 0, 0, down, up);
  }

  /**
   * Returns a place that the player points at, as the movement: {@link Input#moveX()} and {@link
   * Input#moveY()} are the way from the body to it, as shares of the range. What is further away
   * lies at the range. A stick gives the way as a movement does.
   *
   * @param name what it does, in a word or two
   * @param range metres that are 1, from 0.5 to 1,000; a step of the movement is a 127th of it
   */
  public static Action point(String name, float range) {
    return of(Kind.POINT, 0, Range.check("range", range, 0.5f, 1_000), name);
  }

  /** Returns the aim. It follows the movement as long as neither mouse nor stick aims. */
  public static Action aim(String name) {
    return of(Kind.AIM, 0, 0, name);
  }

  /** Adds keys to a button, by their names in the player's settings. */
  public Action key(String... names) {
    require(kind == Kind.BUTTON, "key() is for buttons; a movement has keys(less, more)");
    List<String> all = Range.all("key", names);
    for (String name : all) {
      require(!RESERVED.contains(name), "key \"" + name + "\" is the window's in every game");
    }
    return with(List.of(bindings.get(0).with(all)));
  }

  /** Adds a pair of keys to a movement: to the left or down, and to the right or up. */
  public Action keys(String less, String more) {
    require(kind == Kind.MOVE_X || kind == Kind.MOVE_Y, "keys() is for movements");
    Limits.notNull("less", less);
    Limits.notNull("more", more);
    require(!RESERVED.contains(less) && !RESERVED.contains(more), "a key is the window's");
    return with(List.of(bindings.get(0).with(List.of(less)), bindings.get(1).with(List.of(more))));
  }

  /**
   * Adds a button of the mouse, {@code left}, {@code right} or {@code middle}; for the aim and for
   * a place {@code pointer}.
   */
  public Action mouse(String name) {
    require(
        kind != Kind.MOVE_X && kind != Kind.MOVE_Y,
        "the mouse doesn't move along an axis; point() takes its place as the movement");
    known(name, kind == Kind.BUTTON ? MOUSE : List.of(POINTER));
    return new Action(kind, button, range, bindings, and(mouse, name), pad, sticks);
  }

  /**
   * Adds a button of the gamepad: {@code A}, {@code B}, {@code X}, {@code Y}, {@code L1}, {@code
   * R1}, {@code L3}, {@code R3}, {@code Back} or {@code Start}.
   */
  public Action pad(String name) {
    require(kind == Kind.BUTTON, "pad() is for buttons; others have stick()");
    known(name, PAD);
    return new Action(kind, button, range, bindings, mouse, and(pad, name), sticks);
  }

  /**
   * Adds a stick of the gamepad to a movement or the aim: {@code left}, {@code right}, {@code
   * d-pad}.
   */
  public Action stick(String name) {
    require(kind != Kind.BUTTON, "stick() is for movements and the aim");
    known(name, STICKS);
    return new Action(kind, button, range, bindings, mouse, pad, and(sticks, name));
  }

  private void require(boolean so, String problem) {
    if (!so) {
      throw new IllegalArgumentException("action=\"" + name() + "\": " + problem);
    }
  }

  private void known(String name, List<String> names) {
    require(
        names.contains(Limits.notNull("name", name)),
        "\"" + name + "\" is unknown, known are " + names + Suggestion.didYouMean(name, names));
  }

  private static List<String> and(List<String> names, String name) {
    List<String> all = new ArrayList<>(names);
    all.add(name);
    return List.copyOf(all);
  }

  private Action with(List<Binding> changed) {
    return new Action(kind, button, range, changed, mouse, pad, sticks);
  }

  /** Returns the part of the input that it sets. */
  public Kind kind() {
    return kind;
  }

  /** Returns its bit of {@link Input#buttons()}; 0 for what is no button. */
  public int button() {
    return button;
  }

  /** Returns the metres that are a whole movement, of a place; 0 for what is none. */
  public float range() {
    return range;
  }

  /** Returns whether keys do it: a button or a movement, which players may give other keys. */
  public boolean hasKeys() {
    return kind != Kind.POINT && kind != Kind.AIM;
  }

  /** Returns what it does, for people: the first name of a movement. */
  public String name() {
    return bindings.get(0).name();
  }

  /**
   * Returns its keys: one binding of a button, two of a movement; that of aim or place has no keys.
   */
  public List<Binding> bindings() {
    return bindings;
  }

  /** Returns the buttons of the mouse that do it; {@code pointer} if it follows that. */
  public List<String> mouse() {
    return mouse;
  }

  /** Returns the buttons of the gamepad that do it. */
  public List<String> pad() {
    return pad;
  }

  /** Returns the sticks of the gamepad that do it. */
  public List<String> sticks() {
    return sticks;
  }

  @Override
  public String toString() {
    return kind + " " + bindings;
  }
}
