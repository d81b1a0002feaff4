package carom.client;

/** The packed inputs of the last ticks of one stay in a game. One thread; allocates nothing. */
final class InputHistory {
  private static final int RING = 256;
  private static final int MASK = RING - 1;

  private final long[] inputs = new long[RING];
  private int firstTick = -1;
  private int steadyTick;

  /**
   * Adds the input of a tick. Ticks that the clock jumped over get the same input.
   *
   * @param lastTick the tick before the jump
   */
  void add(int tick, long packed, int lastTick) {
    boolean first = firstTick < 0;
    if (first || packed != inputs[(tick - 1) & MASK]) {
      steadyTick = tick;
    }
    if (first) {
      firstTick = tick;
    }
    inputs[tick & MASK] = packed;
    for (int missed = Math.max(lastTick + 1, tick - RING + 1); missed < tick; missed++) {
      inputs[missed & MASK] = packed;
      firstTick = Math.min(firstTick, missed);
    }
  }

  /** Returns the input of one of the last 256 ticks. */
  long at(int tick) {
    return inputs[tick & MASK];
  }

  /** Returns the first tick with an input, or -1. */
  int firstTick() {
    return firstTick;
  }

  /** Returns the tick since which the input has been the same. */
  int steadyTick() {
    return steadyTick;
  }
}
