package carom.sim.entity;

import carom.physics.math.Limits;

/**
 * The commands of one player for one tick: an input frame.
 *
 * <p>Every value is quantised when it is set, so that the client that predicts and the server that
 * decides read the same numbers. {@link #pack} makes six bytes of it. Mutable; one thread.
 */
public final class Input {
  /** Jump, or the first face button of a controller. */
  public static final int JUMP = 1;

  /** The game's main action: dash, kick, use. */
  public static final int ACTION = 1 << 1;

  /** A second action. */
  public static final int SECOND = 1 << 2;

  /** Down as a button of its own, such as to drop through a one-way platform. */
  public static final int DOWN = 1 << 3;

  /** Up as a button of its own. */
  public static final int UP = 1 << 4;

  /** Number of bits of a packed input. */
  public static final int PACKED_BITS = 48;

  private static final int MOVE_STEPS = 127;
  private static final float TURN_TO_RAD = (float) (2 * Math.PI / 65536);
  private static final float RAD_TO_TURN = (float) (65536 / (2 * Math.PI));

  private int buttons;
  private int before;
  private int moveX;
  private int moveY;
  private int aim;

  /** Creates an input with no button held, no movement, and an aim along +x. */
  public Input() {}

  /** Returns all buttons that are held during the tick, 16 bits. */
  public int buttons() {
    return buttons;
  }

  /** Sets all 16 buttons at once; higher bits are dropped. */
  public Input buttons(int bits) {
    buttons = bits & 0xffff;
    return this;
  }

  /** Returns whether any button of the mask is held. */
  public boolean held(int mask) {
    return (buttons & mask) != 0;
  }

  /**
   * Returns whether any button of the mask went down: it is held in this tick and wasn't in the
   * tick before, in which the player may have been without a body.
   */
  public boolean pressed(int mask) {
    return (buttons & ~before & mask) != 0;
  }

  /** Returns whether any button of the mask went up: it was held in the tick before, and isn't. */
  public boolean released(int mask) {
    return (before & ~buttons & mask) != 0;
  }

  /** Returns the buttons of the tick before, 16 bits; no part of {@link #pack}. */
  int before() {
    return before;
  }

  /**
   * Sets the buttons of the tick before, from which {@link #pressed} and {@link #released} follow.
   * What runs a simulation calls it: a step does for the next one, and a client that learns what
   * was held.
   *
   * @param bits 16 buttons; higher bits are dropped
   */
  public void before(int bits) {
    before = bits & 0xffff;
  }

  /** Holds or releases the buttons of the mask. */
  public Input hold(int mask, boolean down) {
    return buttons(down ? buttons | mask : buttons & ~mask);
  }

  /** Returns the movement to the right, -1..1 in steps of 1/127. */
  public float moveX() {
    return moveX / (float) MOVE_STEPS;
  }

  /** Returns the movement upwards, -1..1 in steps of 1/127. */
  public float moveY() {
    return moveY / (float) MOVE_STEPS;
  }

  /**
   * Sets the movement, quantised to steps of 1/127.
   *
   * @param x to the right, clamped to -1..1; NaN counts as 0
   * @param y upwards, clamped to -1..1; NaN counts as 0
   */
  public Input move(float x, float y) {
    moveX = steps(x);
    moveY = steps(y);
    return this;
  }

  /**
   * Returns the aim direction in radians, counterclockwise from +x, in [0, 2 pi) in steps of
   * 1/65536 turn.
   */
  public float aim() {
    return aim * TURN_TO_RAD;
  }

  /**
   * Sets the aim direction, quantised to 1/65536 turn.
   *
   * @param rad radians counterclockwise from +x, any finite number; others count as 0
   */
  public Input aim(float rad) {
    float turns = rad * RAD_TO_TURN;
    aim = Math.abs(turns) < 1e9f ? Math.round(turns) & 0xffff : 0;
    return this;
  }

  /** Releases all buttons, and sets movement and aim to 0. */
  public void clear() {
    unpack(0);
  }

  /** Copies all values of another input. */
  public void set(Input other) {
    unpack(Limits.notNull("other", other).pack());
  }

  /**
   * Returns the input as {@value #PACKED_BITS} bits: buttons, moveX, moveY, aim from the lowest bit
   * up.
   */
  public long pack() {
    return buttons | (moveX & 0xffL) << 16 | (moveY & 0xffL) << 24 | (long) aim << 32;
  }

  /**
   * Takes all values from bits that {@link #pack} made. Any 64 bits give a legal input: a movement
   * of -128 steps becomes -127, and bits above {@value #PACKED_BITS} are ignored.
   */
  public void unpack(long packed) {
    buttons = (int) packed & 0xffff;
    moveX = Math.max(-MOVE_STEPS, (byte) (packed >>> 16));
    moveY = Math.max(-MOVE_STEPS, (byte) (packed >>> 24));
    aim = (int) (packed >>> 32) & 0xffff;
  }

  /**
   * Returns a guess at an unknown input from the last known one. A player who held a button
   * probably still holds it, and a player who steered probably steers a little less each tick. The
   * guess repeats the whole input for the first third of the time. Then the movement shrinks
   * linearly, while buttons and aim stay. After the hold time it is 0.
   *
   * @param last the last known input, packed
   * @param ticks how long ago that was, at least 0
   * @param holdTicks how long an input is repeated, at least 0
   * @return a packed input; 0 when {@code ticks} is more than {@code holdTicks}
   */
  public static long faded(long last, int ticks, int holdTicks) {
    if (ticks > holdTicks) {
      return 0;
    }
    int full = holdTicks / 3;
    if (ticks <= full) {
      return last;
    }
    int left = holdTicks - ticks + 1;
    int whole = holdTicks - full + 1;
    long x = shrunk((byte) (last >>> 16), left, whole);
    long y = shrunk((byte) (last >>> 24), left, whole);
    return last & ~0xffff0000L | (x & 0xff) << 16 | (y & 0xff) << 24;
  }

  private static int shrunk(int steps, int left, int whole) {
    return steps * left / whole;
  }

  /**
   * Returns for how many ticks the last known input of a player is repeated, half a second.
   *
   * @param tickRate ticks a second
   */
  public static int holdTicks(int tickRate) {
    return tickRate / 2;
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof Input in && in.pack() == pack();
  }

  @Override
  public int hashCode() {
    return Long.hashCode(pack());
  }

  @Override
  public String toString() {
    return "buttons=" + buttons + " move=" + moveX() + "," + moveY() + " aim=" + aim();
  }

  private static int steps(float value) {
    return Math.round(Math.max(-1, Math.min(1, value)) * MOVE_STEPS); // Math.round(NaN) is 0
  }
}
