package carom.net.snapshot.frame;

import carom.net.codec.BitPass;
import carom.net.codec.Bits;
import carom.net.codec.Quantizer;
import carom.net.protocol.PlayerId;

/**
 * The events section, described once for writing and reading: {@link #begin}, then {@link #next}
 * for each event, and once more for the end. Reads any bits without harm. One object codes one
 * section at a time.
 */
final class EventCodec {
  /** Most bits an event takes, with the gap before it. */
  static final int MAX_BITS = 7 + 36 + 8 + 12 + 2 * 26 + 3 * 38 + 17;

  /** Bits of a place in the window. */
  static final int WINDOW_BITS = 6;

  /** Events that may be on their way. */
  static final int WINDOW = 1 << WINDOW_BITS;

  /** Bits of the section's end. */
  static final int END_BITS = 1;

  private static final int SEQUENCE_BITS = 16;
  private static final int COUNT_BITS = 9;
  private static final int WIDTH_BITS = 5;
  private static final int ID_BITS = 16;
  private static final int GENERATION_BITS = 8;
  private static final int NO_TICK = -1;

  private int datagramTick;
  private int sequence;
  private int outstanding;
  private int place;
  private int nextPlace;
  private int tick;

  EventCodec() {}

  /**
   * Codes the head of the section.
   *
   * @param datagramTick the datagram's tick; both sides know it
   * @param sequence number of the oldest event without an ack; 16 bits count
   * @param outstanding events without an ack, 0..512; with 0 the section ends here
   */
  void begin(BitPass c, int datagramTick, int sequence, int outstanding) {
    this.datagramTick = datagramTick;
    nextPlace = 0;
    tick = NO_TICK;
    boolean any = c.flag(outstanding > 0);
    this.sequence = any ? c.plain(sequence, SEQUENCE_BITS) : 0;
    this.outstanding = any ? 1 + c.plain(outstanding - 1, COUNT_BITS) : 0;
  }

  /** Returns the number of the oldest event without an ack, 16 bits. */
  int sequence() {
    return sequence;
  }

  /** Returns how many events have no ack; 0 if the section has nothing else. */
  int outstanding() {
    return outstanding;
  }

  /**
   * Codes the next event, or the end of a section that isn't empty.
   *
   * @param more whether there is another event; if not, the other values mean nothing
   * @param place of the event behind the oldest one, ascending
   * @param e the event; a reader fills it
   * @return whether an event was coded; a reader answers false, too, after bits that make no sense
   */
  boolean next(BitPass c, boolean more, int place, EventRecord e) {
    if (!c.flag(more)) {
      return false;
    }
    int gap = c.flag(place == nextPlace) ? 0 : 1 + c.plain(place - nextPlace - 1, WINDOW_BITS);
    this.place = nextPlace + gap;
    nextPlace = this.place + 1;
    if (!c.require(this.place < Math.min(WINDOW, outstanding))) {
      return false;
    }
    boolean isFirst = tick == NO_TICK;
    int ticks = ticks(c, isFirst ? datagramTick - e.tick : e.tick - tick);
    long when = isFirst ? (long) datagramTick - ticks : (long) tick + ticks;
    content(c, e);
    if (!c.require(when >= 0 && when <= datagramTick && isSane(e))) {
      return false;
    }
    tick = (int) when;
    e.tick = tick;
    return true;
  }

  /** Returns the place of the event coded last. */
  int place() {
    return place;
  }

  /** Codes how far apart two events are, or the first one and the datagram; not negative. */
  private static int ticks(BitPass c, int ticks) {
    int width = c.plain(Bits.width(ticks), WIDTH_BITS);
    return c.plain(ticks, width);
  }

  private static void content(BitPass c, EventRecord e) {
    e.kind = c.plain(e.kind, 8);
    e.player = c.flag(e.player >= 0) ? PlayerId.code(c, e.player) : EventRecord.NONE;
    e.first = entity(c, e.first);
    e.second = entity(c, e.second);
    e.x = c.difference(e.x);
    e.y = c.difference(e.y);
    e.strength = c.flag(e.strength != 0) ? c.plain(e.strength, 16) : 0;
    e.data = c.difference(e.data);
  }

  private static int entity(BitPass c, int key) {
    if (!c.flag(key >= 0)) {
      return EventRecord.NONE;
    }
    int id = c.plain(key, ID_BITS);
    int generation = key >>> ID_BITS;
    return c.flag(generation != 0) ? id | c.plain(generation, GENERATION_BITS) << ID_BITS : id;
  }

  private static boolean isSane(EventRecord e) {
    return Math.abs((long) e.x) <= Quantizer.MAX_POSITION
        && Math.abs((long) e.y) <= Quantizer.MAX_POSITION
        && Float.isFinite(e.strengthOf());
  }
}
