package carom.server.session;

import carom.sim.entity.Input;
import java.util.Arrays;
import java.util.Locale;

/**
 * One player's inputs between arrival and use: exactly one is consumed per tick.
 *
 * <p>A client sends each input several times and runs a little ahead of the server, so inputs wait
 * here, at their tick, until the room consumes that tick. Three rules keep hostile clients out. The
 * window, from the next tick to {@code windowTicks} ahead, bounds memory. The first arrival of a
 * tick wins. One tick consumes one input however many arrive, which rules out a speed hack.
 *
 * <p>A client whose input stays the same need not repeat it: it says for how long the newest one
 * holds, see {@link #hold}, and is believed until it says something else.
 *
 * <p>When a tick's input is missing, the newest one is repeated, because a player who held a key
 * probably still holds it; its movement fades, see {@link Input#faded}, and after {@code holdTicks}
 * missing in a row the player counts as neutral.
 *
 * <p>Inputs are packed, see {@link Input#pack}; 0 is neutral. One thread; no allocation.
 */
public final class InputBuffer {
  /** The fate of an offered input. */
  public enum Arrival {
    /** The input is stored and will be consumed at its tick. */
    ACCEPTED,
    /** The input was known already, which is usual for redundant copies. */
    DUPLICATE,
    /**
     * The input's tick was consumed already, with an equal input that the client had {@linkplain
     * #hold held}.
     */
    CONFIRMED,
    /** The input's tick was consumed already. */
    TOO_LATE,
    /** The input's tick lies beyond the window. */
    TOO_EARLY
  }

  private static final int SIZE = 64; // power of two, at least the largest window

  private final int windowTicks;
  private final int holdTicks;
  private final long[] packed = new long[SIZE];
  private final int[] tickOf = new int[SIZE];

  /** True if a slot's input did not arrive but followed from one that was held; by slot. */
  private final boolean[] isHeld = new boolean[SIZE];

  private int lastConsumedTick;
  private int newestTick;
  private boolean anyArrived;
  private long last;
  private int missingInARow;
  private boolean lastMissing;
  private int holdFrom;
  private int holdUntil;
  private long held;
  private int arrivalMargin;
  private long consumed;
  private long missing;
  private long tooLate;
  private long tooEarly;

  /**
   * Creates an empty buffer.
   *
   * @param windowTicks how far ahead of the last consumed tick an input may lie, 1..64
   * @param holdTicks how many missing ticks repeat the last input before it turns neutral
   */
  public InputBuffer(int windowTicks, int holdTicks) {
    if (windowTicks < 1 || windowTicks > SIZE || holdTicks < 0) {
      throw new IllegalArgumentException(
          String.format(
              Locale.ROOT,
              "windowTicks=%d must be 1..%d and holdTicks=%d at least 0",
              windowTicks,
              SIZE,
              holdTicks));
    }
    this.windowTicks = windowTicks;
    this.holdTicks = holdTicks;
    reset(0);
  }

  /**
   * Forgets all inputs and continues after {@code lastConsumedTick}: a fresh or a returning player.
   * The counters stay.
   */
  public void reset(int lastConsumedTick) {
    this.lastConsumedTick = lastConsumedTick;
    newestTick = lastConsumedTick;
    anyArrived = false;
    last = 0;
    missingInARow = holdTicks;
    holdUntil = lastConsumedTick;
    arrivalMargin = 0;
    Arrays.fill(isHeld, false);
    Arrays.fill(tickOf, lastConsumedTick); // consumed, hence never matched again
  }

  /** Offers the input of a tick. Takes any tick and never throws. */
  public Arrival offer(int tick, long input) {
    int ahead = tick - lastConsumedTick; // wraps like the ticks themselves
    if (ahead <= 0) {
      // Redundant copies of what was used are the normal case; late is only what never was here, or
      // is not what the client had said would go on.
      int slot = tick & (SIZE - 1);
      if (tickOf[slot] == tick && !isHeld[slot]) {
        return Arrival.DUPLICATE;
      }
      if (tickOf[slot] == tick) {
        isHeld[slot] = false; // its further copies are duplicates
        if (packed[slot] == input) {
          noteLate(tick, input);
          return Arrival.CONFIRMED;
        }
        missing++;
      } else if (ahead > -SIZE && tickOf[slot] - tick < 0) {
        tickOf[slot] = tick;
        isHeld[slot] = false;
      }
      tooLate++;
      noteLate(tick, input);
      return Arrival.TOO_LATE;
    }
    if (ahead > windowTicks) {
      tooEarly++;
      noteNewest(lastConsumedTick + windowTicks); // the margin must say "too early", not "too late"
      return Arrival.TOO_EARLY;
    }
    int slot = tick & (SIZE - 1);
    if (tickOf[slot] == tick) {
      return Arrival.DUPLICATE;
    }
    tickOf[slot] = tick;
    packed[slot] = input;
    isHeld[slot] = false;
    noteNewest(tick);
    return Arrival.ACCEPTED;
  }

  /**
   * Lets an input count for the ticks after its own, too, until an input for a later tick arrives.
   * It fades from the last of them on. Call after {@link #offer} of that input; ignored when later
   * ones are known.
   *
   * @param tick of the input
   * @param input that goes on
   * @param ticks for how many ticks after it; 0 ends it
   */
  public void hold(int tick, long input, int ticks) {
    if (anyArrived && tick == newestTick) {
      holdFrom = tick;
      holdUntil = tick + Math.min(SIZE, ticks);
      held = input;
      if (tick - lastConsumedTick <= 0) {
        missingInARow = Math.max(0, lastConsumedTick - holdUntil);
      }
    }
  }

  /**
   * Lets a late input be repeated if it is the newest: it says more of the next tick than others.
   */
  private void noteLate(int tick, long input) {
    if (noteNewest(tick)) {
      last = input;
      missingInARow = lastConsumedTick - tick;
    }
  }

  private boolean noteNewest(int tick) {
    boolean isNewest = !anyArrived || tick - newestTick > 0;
    if (isNewest) {
      newestTick = tick;
      anyArrived = true;
      arrivalMargin = tick - lastConsumedTick - 1;
    }
    return isNewest;
  }

  /**
   * Returns the input of the next tick, which must be the one after the last consumed.
   *
   * @param tick {@code lastConsumedTick() + 1}
   * @return the packed input: the player's, the repeated last one, or 0
   */
  public long consume(int tick) {
    if (tick != lastConsumedTick + 1) {
      throw new IllegalStateException(
          String.format(
              Locale.ROOT,
              "tick=%d is not the one after lastConsumedTick=%d",
              tick,
              lastConsumedTick));
    }
    lastConsumedTick = tick;
    consumed++;
    int slot = tick & (SIZE - 1);
    if (tickOf[slot] == tick) {
      last = packed[slot];
      missingInARow = 0;
      lastMissing = false;
      return last;
    }
    if (anyArrived && newestTick == holdFrom && tick - holdFrom > 0 && tick - holdUntil <= 0) {
      tickOf[slot] = tick;
      packed[slot] = held;
      isHeld[slot] = true;
      last = held;
      missingInARow = 0;
      lastMissing = false;
      return last;
    }
    isHeld[slot] = false;
    lastMissing = true;
    if (anyArrived) {
      missing++; // before the first input there is nothing to miss
    }
    missingInARow = Math.min(missingInARow + 1, holdTicks + 1);
    return Input.faded(last, missingInARow, holdTicks);
  }

  /** Returns whether the input of a tick that is still to be consumed is here. */
  public boolean isWaiting(int tick) {
    return tick - lastConsumedTick > 0 && tickOf[tick & (SIZE - 1)] == tick;
  }

  /** Returns the packed input of a tick that {@linkplain #isWaiting waits}. */
  public long waiting(int tick) {
    return packed[tick & (SIZE - 1)];
  }

  /**
   * Returns whether the last consumed input had not arrived but followed from one that was held.
   */
  public boolean lastWasHeld() {
    return isHeld[lastConsumedTick & (SIZE - 1)];
  }

  /** Returns whether the last consumed tick had no input of its own, nor one that was held. */
  public boolean lastWasMissing() {
    return lastMissing;
  }

  /** Returns the tick that was consumed last. */
  public int lastConsumedTick() {
    return lastConsumedTick;
  }

  /**
   * Returns the newest tick an input arrived for, in time or too late; see {@link #marginTicks}.
   */
  public int newestTick() {
    return newestTick;
  }

  /**
   * Returns how many ticks the newest input lay ahead of the first tick that was consumed after it
   * came: the number the client steers its clock by. Negative when it came too late, by that many
   * ticks; 0 when none arrived yet. Other than {@link #marginTicks}, it doesn't fall while nothing
   * comes.
   */
  public int arrivalMarginTicks() {
    return arrivalMargin;
  }

  /**
   * Returns how many ticks the newest input lies ahead of the last consumed tick. Negative when it
   * is past, by that many ticks; 0 when none arrived yet.
   */
  public int marginTicks() {
    return anyArrived ? newestTick - lastConsumedTick : 0;
  }

  /** Returns the number of ticks consumed, those without an input included. */
  public long consumed() {
    return consumed;
  }

  /** Returns the number of ticks without an input of their own, counted from the first input on. */
  public long missing() {
    return missing;
  }

  /** Inputs that came after their tick. */
  public long tooLate() {
    return tooLate;
  }

  /** Inputs refused because they lay beyond the window. */
  public long tooEarly() {
    return tooEarly;
  }
}
