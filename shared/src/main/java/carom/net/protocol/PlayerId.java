package carom.net.protocol;

import carom.net.codec.BitCoder;
import carom.net.codec.BitReader;
import carom.net.codec.BitWriter;

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

  /** Writes an id. */
  public static void write(BitWriter w, int id) {
    boolean wide = id >> SHORT_BITS != 0;
    w.write(wide);
    w.write(id, wide ? LONG_BITS : SHORT_BITS);
  }

  /** Reads an id. */
  public static int read(BitReader r) {
    return r.read(r.readBit() ? LONG_BITS : SHORT_BITS);
  }

  /** Codes an id. Returns the id written, or the id read. */
  public static int code(BitCoder c, int id) {
    int wide = c.plain(id >> SHORT_BITS != 0 ? 1 : 0, 1);
    return c.plain(id, wide != 0 ? LONG_BITS : SHORT_BITS);
  }
}
