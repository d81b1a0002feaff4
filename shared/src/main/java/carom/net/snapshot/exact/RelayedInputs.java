package carom.net.snapshot.exact;

import carom.net.snapshot.frame.FrameRing;
import java.util.Arrays;

/**
 * Holds other players' inputs as received, by player and tick: the last {@value #TICKS} ticks of
 * each player ever relayed, some of them ahead of the newest snapshot. The decoder adds inputs in
 * any order of ticks. One thread; allocates when a player is relayed for the first time, 768 bytes.
 */
public final class RelayedInputs {
  /** Number of ticks kept. */
  public static final int TICKS = FrameRing.SIZE;

  private static final int MASK = TICKS - 1;

  private long[][] inputs = {};
  private int[][] ticks = {};
  private int[] newest = {};

  /** Creates an object without inputs. */
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

  /** Puts the packed input of a player at a tick, unless a newer tick has its place. */
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

  /** Returns whether the player's input of exactly that tick is known. */
  public boolean knows(int player, int tick) {
    return player < newest.length
        && inputs[player] != null
        && tick >= 0
        && ticks[player][tick & MASK] == tick;
  }

  /** Returns the packed input of a tick, or 0 when it isn't known. */
  public long at(int player, int tick) {
    return knows(player, tick) ? inputs[player][tick & MASK] : 0;
  }

  /** Returns the newest tick, up to a tick, whose input of the player is known, or -1. */
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

  /** Returns the newest tick whose input of the player is known, or -1. */
  public int newestTick(int player) {
    return player < newest.length ? newest[player] : -1;
  }
}
