package carom.net.protocol;

import carom.net.codec.PlainBits;

/**
 * A player's id on the wire: 1 + 7 bits, or 1 + 10 from 128 on, which only large rooms have, since
 * the lowest free id goes to who comes. Whatever is read is an id.
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
