package carom.net.snapshot.relay;

import carom.net.snapshot.frame.FrameRing;
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

  private long[][] inputs = {};
  private int[][] ticks = {};
  private int[] newest = {};

  public RelayedInputs() {}

  private void ensure(int players) {
    int known = newest.length;
    if (players <= known) {
      return;
    }
    int grown = Math.max(players, 2 * known);
    inputs = Arrays.copyOf(inputs, grown);
    ticks = Arrays.copyOf(ticks, grown);
    newest = Arrays.copyOf(newest, grown);
    Arrays.fill(newest, known, grown, -1);
  }

  public void put(int player, int tick, long input) {
    ensure(player + 1);
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
    return player < newest.length
        && inputs[player] != null
        && tick >= 0
        && ticks[player][tick & MASK] == tick;
  }

  /** The packed input of a tick, or 0 when it isn't known. */
  public long at(int player, int tick) {
    return knows(player, tick) ? inputs[player][tick & MASK] : 0;
  }

  /** The newest tick up to a tick that the player's input is known of, or -1. */
  public int newestBefore(int player, int tick) {
    int last = newestTick(player);
    if (last <= tick) {
      return last;
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
    return player < newest.length ? newest[player] : -1;
  }
}
