package carom.net.snapshot.event;

import carom.net.codec.BitReader;
import carom.net.codec.BitWriter;
import carom.net.codec.Bits;
import carom.net.codec.Quantizer;
import carom.net.protocol.PlayerId;

/** One event on the wire: a pair of write and read that mirror each other. */
final class EventCodec {
  /** Most bits an event takes, with the gap before it. */
  static final int MAX_BITS = 7 + 36 + 8 + 12 + 2 * 26 + 3 * 38 + 17;

  /** Bits of a place in the window. */
  static final int WINDOW_BITS = 6;

  private static final int WIDTH_BITS = 5;
  private static final int ID_BITS = 16;
  private static final int GENERATION_BITS = 8;

  private EventCodec() {}

  /**
   * Writes an event.
   *
   * @param ticks from the event before it in the datagram, or to the datagram's; not negative
   */
  static void write(BitWriter w, EventRecord e, int ticks) {
    int width = Integer.SIZE - Integer.numberOfLeadingZeros(ticks);
    w.write(width, WIDTH_BITS);
    w.write(ticks, width);
    w.write(e.kind, 8);
    w.write(e.player >= 0);
    if (e.player >= 0) {
      PlayerId.write(w, e.player);
    }
    writeEntity(w, e.first);
    writeEntity(w, e.second);
    Bits.writeDifference(w, e.x);
    Bits.writeDifference(w, e.y);
    w.write(e.strength != 0);
    if (e.strength != 0) {
      w.write(e.strength, 16);
    }
    Bits.writeDifference(w, e.data);
  }

  /** Reads an event; answers the ticks, not negative. The caller checks {@link #isSane}. */
  static int read(BitReader r, EventRecord e) {
    int ticks = r.read(r.read(WIDTH_BITS));
    e.kind = r.read(8);
    e.player = r.readBit() ? PlayerId.read(r) : EventRecord.NONE;
    e.first = readEntity(r);
    e.second = readEntity(r);
    e.x = Bits.readDifference(r);
    e.y = Bits.readDifference(r);
    e.strength = r.readBit() ? r.read(16) : 0;
    e.data = Bits.readDifference(r);
    return ticks;
  }

  private static void writeEntity(BitWriter w, int key) {
    w.write(key >= 0);
    if (key >= 0) {
      int generation = key >>> ID_BITS;
      w.write(key, ID_BITS);
      w.write(generation != 0);
      if (generation != 0) {
        w.write(generation, GENERATION_BITS);
      }
    }
  }

  private static int readEntity(BitReader r) {
    if (!r.readBit()) {
      return EventRecord.NONE;
    }
    int id = r.read(ID_BITS);
    return r.readBit() ? id | r.read(GENERATION_BITS) << ID_BITS : id;
  }

  /** Whether what was read can have been written. */
  static boolean isSane(EventRecord e) {
    return Math.abs((long) e.x) <= Quantizer.MAX_POSITION
        && Math.abs((long) e.y) <= Quantizer.MAX_POSITION
        && Float.isFinite(e.strengthOf());
  }
}
