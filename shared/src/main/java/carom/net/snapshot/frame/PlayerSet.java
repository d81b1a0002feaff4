package carom.net.snapshot.frame;

import carom.net.protocol.PlayerId;
import java.util.Arrays;

/** A set of player ids, 0..1,023. Mutable, reused; allocates only to grow. */
public final class PlayerSet {
  private static final long[] NONE = {};

  private long[] bits = NONE;

  /** Creates an empty set. */
  public PlayerSet() {}

  /**
   * Adds a player.
   *
   * @param player 0..1,023
   * @throws IndexOutOfBoundsException when the id is out of range
   */
  public void add(int player) {
    if (player < 0 || player > PlayerId.MAX) {
      throw new IndexOutOfBoundsException("player=" + player + " is outside 0.." + PlayerId.MAX);
    }
    ensure((player >> 6) + 1);
    bits[player >> 6] |= 1L << player;
  }

  private void ensure(int words) {
    if (words > bits.length) {
      bits = Arrays.copyOf(bits, words);
    }
  }

  /** Returns whether a player is in the set; false for ids out of range. */
  public boolean has(int player) {
    return player >= 0 && player >> 6 < bits.length && (bits[player >> 6] & 1L << player) != 0;
  }

  /** Returns the smallest id in the set that is at least {@code from}, or -1. */
  public int next(int from) {
    for (int word = from >> 6, player = from; word < bits.length; player = ++word << 6) {
      long rest = bits[word] & -1L << player;
      if (rest != 0) {
        return (word << 6) + Long.numberOfTrailingZeros(rest);
      }
    }
    return -1;
  }

  /** Returns the number of players. */
  public int size() {
    int size = 0;
    for (long word : bits) {
      size += Long.bitCount(word);
    }
    return size;
  }

  /** Removes all players. */
  public void clear() {
    Arrays.fill(bits, 0);
  }

  /** Copies another set into this one. */
  public void set(PlayerSet other) {
    ensure(other.bits.length);
    System.arraycopy(other.bits, 0, bits, 0, other.bits.length);
    Arrays.fill(bits, other.bits.length, bits.length, 0);
  }

  /** Returns whether both hold the same players. */
  public boolean sameAs(PlayerSet other) {
    int common = Math.min(bits.length, other.bits.length);
    return Arrays.equals(bits, 0, common, other.bits, 0, common)
        && isEmptyFrom(common)
        && other.isEmptyFrom(common);
  }

  private boolean isEmptyFrom(int word) {
    for (int i = word; i < bits.length; i++) {
      if (bits[i] != 0) {
        return false;
      }
    }
    return true;
  }
}
