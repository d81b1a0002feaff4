package carom.net.snapshot.frame;

import java.util.Arrays;

/**
 * Holds a room's inputs that have arrived at the server and wait for the ticks after the newest
 * frame. A client that gets them predicts other players without guessing. Each player has those of
 * the next ticks without a gap, at most {@value #MOST}. One thread; allocates only to grow.
 */
public final class WaitingInputs {
  /** Number of inputs of a player, at most: a cheat that reads them looks no more ticks ahead. */
  public static final int MOST = 7;

  private byte[] count = new byte[16];
  private long[] inputs = new long[count.length * MOST];

  WaitingInputs() {}

  /** Removes all inputs. */
  void clear() {
    Arrays.fill(count, (byte) 0);
  }

  /**
   * Adds the input of the tick behind the last one that was added for a player, or behind the
   * frame's.
   *
   * @param player id, 0..1,023
   * @param packed 48 bits, higher ones are dropped
   * @return false when there is no room for more
   */
  public boolean add(int player, long packed) {
    if (count(player) == MOST) {
      return false;
    }
    if (player >= count.length) {
      count = Arrays.copyOf(count, Math.max(2 * count.length, player + 1));
      inputs = Arrays.copyOf(inputs, count.length * MOST);
    }
    inputs[player * MOST + count[player]++] = packed & FrameState.INPUT_MASK;
    return true;
  }

  /** Returns how many inputs of a player wait. */
  public int count(int player) {
    return player < count.length ? count[player] : 0;
  }

  /** Returns the input of a player {@code ahead} ticks after the frame's, from 1 on. */
  public long at(int player, int ahead) {
    return inputs[player * MOST + ahead - 1];
  }
}
