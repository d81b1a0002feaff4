package carom.net.snapshot;

import java.util.Arrays;

/** A set of player ids, 0..255. Mutable, reused. */
public final class PlayerSet {
  private static final int SIZE = 256;

  private final long[] bits = new long[SIZE >> 6];

  /** Creates an empty set. */
  public PlayerSet() {}

  /**
   * Adds a player.
   *
   * @param player 0..255
   * @throws IndexOutOfBoundsException when the id is out of range
   */
  public void add(int player) {
    if (player < 0 || player >= SIZE) {
      throw new IndexOutOfBoundsException("player=" + player + " is outside 0.." + (SIZE - 1));
    }
    bits[player >> 6] |= 1L << player;
  }

  /** Whether a player is in the set; false for ids out of range. */
  public boolean has(int player) {
    return player >= 0 && player < SIZE && (bits[player >> 6] & 1L << player) != 0;
  }

  /** The smallest id in the set that is at least {@code from}, or -1. */
  public int next(int from) {
    for (int player = from; player < SIZE; ) {
      long rest = bits[player >> 6] & -1L << player;
      if (rest != 0) {
        return (player & ~63) + Long.numberOfTrailingZeros(rest);
      }
      player = (player & ~63) + 64;
    }
    return -1;
  }

  /** How many there are. */
  public int size() {
    int size = 0;
    for (long word : bits) {
      size += Long.bitCount(word);
    }
    return size;
  }

  /** Removes everybody. */
  public void clear() {
    Arrays.fill(bits, 0);
  }

  /** Becomes equal to another set. */
  public void set(PlayerSet other) {
    System.arraycopy(other.bits, 0, bits, 0, bits.length);
  }

  /** Whether both hold the same players. */
  public boolean sameAs(PlayerSet other) {
    return Arrays.equals(bits, other.bits);
  }
}
