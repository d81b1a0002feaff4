package carom.net.snapshot;

import java.util.Arrays;

/**
 * What the server told of other players' inputs, by player and tick: the last {@value #TICKS} ticks
 * of each player ever relayed, some of them ahead of the newest snapshot. Filled by the decoder, in
 * any order of ticks. One thread; allocates when a player is relayed for the first time, 768 bytes.
 */
public final class RelayedInputs {
  /** Ticks kept. */
  public static final int TICKS = FrameRing.SIZE;

  private static final int MASK = TICKS - 1;

  private final long[][] inputs = new long[256][];
  private final int[][] ticks = new int[256][];
  private final int[] newest = new int[256];

  RelayedInputs() {
    Arrays.fill(newest, -1);
  }

  void put(int player, int tick, long input) {
    if (inputs[player] == null) {
      inputs[player] = new long[TICKS];
      ticks[player] = new int[TICKS];
      Arrays.fill(ticks[player], -1);
    }
    int at = tick & MASK;
    if (tick < ticks[player][at]) {
      return; // an old datagram that came late
    }
    inputs[player][at] = input;
    ticks[player][at] = tick;
    newest[player] = Math.max(newest[player], tick);
  }

  /** Whether the input of that very tick is known. */
  public boolean knows(int player, int tick) {
    return inputs[player] != null && tick >= 0 && ticks[player][tick & MASK] == tick;
  }

  /** The packed input of a tick, or 0 when it isn't known. */
  public long at(int player, int tick) {
    return knows(player, tick) ? inputs[player][tick & MASK] : 0;
  }

  /** The newest tick up to a tick that the player's input is known of, or -1. */
  public int newestBefore(int player, int tick) {
    if (newest[player] <= tick) {
      return newest[player];
    }
    for (int t = tick; t > tick - TICKS && t >= 0; t--) {
      if (knows(player, t)) {
        return t;
      }
    }
    return -1;
  }

  /** The newest tick that the player's input is known of, or -1. */
  public int newestTick(int player) {
    return newest[player];
  }
}
