package carom.net.protocol;

import carom.net.codec.PlainBits;

/**
 * Codec of a player's id: 1 + 7 bits up to 127, and 1 + 10 bits from 128 on. Only large rooms have
 * ids from 128 on, because a new player gets the lowest free id. Any bits decode to a valid id.
 */
public final class PlayerId {
  private static final int SHORT_BITS = 7;
  private static final int LONG_BITS = 10;

  /** The largest id. */
  public static final int MAX = (1 << LONG_BITS) - 1;

  private PlayerId() {}

  /** Passes an id, 0..{@link #MAX}; a negative one is for readers, who ignore it. */
  public static int code(PlainBits c, int id) {
    boolean wide = c.flag(id >> SHORT_BITS != 0);
    return c.plain(id, wide ? LONG_BITS : SHORT_BITS);
  }
}
