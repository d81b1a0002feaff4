package carom.sim.ruling;

import java.util.Arrays;

/**
 * The latest rulings of a simulation, numbered from 0 in the order they were made. One thread;
 * allocates only to grow.
 */
public final class RulingLog {
  /** Most rulings that are kept; older ones are forgotten. A power of two. */
  public static final int MOST = 1_024;

  private Ruling[] rulings = {};
  private long next;

  /** Creates an empty log. */
  public RulingLog() {}

  /** Returns the number that the next ruling will have. */
  public long next() {
    return next;
  }

  /** Returns the number of the oldest ruling that is kept. */
  public long oldest() {
    return Math.max(0, next - MOST);
  }

  /** Returns a ruling by its number, {@link #oldest} to {@link #next} less 1; it is live. */
  public Ruling get(long number) {
    return rulings[(int) number & (MOST - 1)];
  }

  /** Adds a ruling for the caller to fill in. */
  public Ruling add() {
    int slot = (int) next++ & (MOST - 1);
    if (slot >= rulings.length) {
      rulings = Arrays.copyOf(rulings, Math.min(MOST, Math.max(16, 2 * rulings.length)));
    }
    if (rulings[slot] == null) {
      rulings[slot] = new Ruling();
    }
    return rulings[slot];
  }
}
