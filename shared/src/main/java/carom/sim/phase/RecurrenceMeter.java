package carom.sim.phase;

/**
 * Tells what recurs from what happens now and then: a level that rises with each time and sinks
 * with each tick. One thread; no allocation.
 */
public final class RecurrenceMeter {
  /** Rise of the level with each time, usually. It sinks by 1 with each tick. */
  private static final int RISE = 4;

  /**
   * The level that counts as recurrent: 20 times in as many ticks, or 60 times in every third tick.
   */
  private static final int LEVEL = 60;

  private int level;
  private int lastTick;
  private int firstTick;
  private boolean told;

  /** Creates a meter of something that never happened yet. */
  public RecurrenceMeter() {}

  /** Forgets all. */
  public void clear() {
    level = 0;
    told = false;
  }

  /**
   * Notes that it happened.
   *
   * @param tick not before the last one
   * @return whether it has just become recurrent; true once
   */
  public boolean note(int tick) {
    return note(tick, RISE);
  }

  /**
   * Notes that it happened.
   *
   * @param tick not before the last one
   * @param rise how much the level rises, which is the number of ticks after which it has sunk
   *     again
   * @return whether it has just become recurrent; true once
   */
  public boolean note(int tick, int rise) {
    int sunk = Math.max(0, level - (tick - lastTick));
    firstTick = sunk == 0 ? tick : firstTick;
    boolean again = level > 0 && tick == lastTick;
    level = again ? level : sunk + rise;
    lastTick = tick;
    boolean isRecurrent = level >= LEVEL;
    boolean tells = isRecurrent && !told;
    told |= isRecurrent;
    return tells;
  }

  /** Returns the tick at which it began. */
  public int firstTick() {
    return firstTick;
  }
}
