package carom.server.session;

import carom.sim.Input;
import java.util.Arrays;

/**
 * One player's inputs between arrival and use: exactly one is consumed per tick.
 *
 * <p>A client sends each input several times and runs a little ahead of the server, so inputs wait
 * here, at their tick, until the room consumes that tick. Three rules keep hostile clients out: the
 * window (nothing further ahead than {@code windowTicks}, nothing in the past) bounds memory, the
 * first arrival of a tick wins, and one tick consumes one input however many arrive (no speed
 * hack).
 *
 * <p>When a tick's input is missing, the last one is repeated, because a player who held a key
 * probably still holds it; its movement fades, see {@link Input#faded}, and after {@code holdTicks}
 * missing in a row the player counts as neutral.
 *
 * <p>Inputs are packed, see {@link Input#pack}; 0 is neutral. One thread; no allocation.
 */
public final class InputBuffer {
  /** What became of an offered input. */
  public enum Verdict {
    /** Stored, will be consumed at its tick. */
    ACCEPTED,
    /** Already known; the usual fate of redundant copies. */
    DUPLICATE,
    /** Its tick was consumed already. */
    TOO_LATE,
    /** Its tick lies beyond the window. */
    TOO_EARLY
  }

  private static final int SIZE = 64; // power of two, at least the largest window

  private final int windowTicks;
  private final int holdTicks;
  private final long[] packed = new long[SIZE];
  private final int[] tickOf = new int[SIZE];
  private int lastConsumedTick;
  private int newestTick;
  private boolean anyArrived;
  private long last;
  private int missingInARow;
  private boolean lastMissing;
  private long consumed;
  private long missing;
  private long tooLate;
  private long tooEarly;

  /**
   * @param windowTicks how far ahead of the last consumed tick an input may lie, 1..64
   * @param holdTicks how many missing ticks repeat the last input before it turns neutral
   */
  public InputBuffer(int windowTicks, int holdTicks) {
    if (windowTicks < 1 || windowTicks > SIZE || holdTicks < 0) {
      throw new IllegalArgumentException(
          "windowTicks=%d must be 1..%d and holdTicks=%d at least 0"
              .formatted(windowTicks, SIZE, holdTicks));
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
    Arrays.fill(tickOf, lastConsumedTick); // consumed, hence never matched again
  }

  /** Offers the input of a tick. Never throws, whatever the tick. */
  public Verdict offer(int tick, long input) {
    int ahead = tick - lastConsumedTick; // wraps like the ticks themselves
    if (ahead <= 0) {
      // Redundant copies of what was used are the normal case; late is only what never was here.
      if (tickOf[tick & (SIZE - 1)] == tick) {
        return Verdict.DUPLICATE;
      }
      if (ahead > -SIZE && tickOf[tick & (SIZE - 1)] - tick < 0) {
        tickOf[tick & (SIZE - 1)] = tick; // its further copies are duplicates
      }
      tooLate++;
      noteNewest(tick);
      return Verdict.TOO_LATE;
    }
    if (ahead > windowTicks) {
      tooEarly++;
      noteNewest(lastConsumedTick + windowTicks); // the margin must say "too early", not "too late"
      return Verdict.TOO_EARLY;
    }
    int slot = tick & (SIZE - 1);
    if (tickOf[slot] == tick) {
      return Verdict.DUPLICATE;
    }
    tickOf[slot] = tick;
    packed[slot] = input;
    noteNewest(tick);
    return Verdict.ACCEPTED;
  }

  private void noteNewest(int tick) {
    if (!anyArrived || tick - newestTick > 0) {
      newestTick = tick;
      anyArrived = true;
    }
  }

  /**
   * The input of the next tick, which must be the one after the last consumed.
   *
   * @param tick {@code lastConsumedTick() + 1}
   * @return the packed input: the player's, the repeated last one, or 0
   */
  public long consume(int tick) {
    if (tick != lastConsumedTick + 1) {
      throw new IllegalStateException(
          "tick=%d is not the one after lastConsumedTick=%d".formatted(tick, lastConsumedTick));
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
    lastMissing = true;
    if (anyArrived) {
      missing++; // before the first input there is nothing to miss
    }
    missingInARow = Math.min(missingInARow + 1, holdTicks + 1);
    return Input.faded(last, missingInARow, holdTicks);
  }

  /** Whether the last consumed tick had no input of its own. */
  public boolean lastWasMissing() {
    return lastMissing;
  }

  /** The tick that was consumed last. */
  public int lastConsumedTick() {
    return lastConsumedTick;
  }

  /** The newest tick an input arrived for, in time or too late; see {@link #marginTicks}. */
  public int newestTick() {
    return newestTick;
  }

  /**
   * How many ticks the newest input lies ahead of the last consumed tick: the number the client
   * steers its clock by. Negative when its inputs come too late, by that many ticks; 0 when none
   * arrived yet.
   */
  public int marginTicks() {
    return anyArrived ? newestTick - lastConsumedTick : 0;
  }

  /** Whether an input arrived since the last {@link #reset}. */
  public boolean anyArrived() {
    return anyArrived;
  }

  /** Ticks consumed, missing ones included. */
  public long consumed() {
    return consumed;
  }

  /** Ticks without an input of their own, counted from the first input on. */
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
