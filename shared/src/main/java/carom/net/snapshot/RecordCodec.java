package carom.net.snapshot;

import carom.net.codec.BitCoder;
import carom.net.codec.BitTable;
import carom.net.codec.Bits;

/**
 * The form of a datagram's records but for what deltas tell, described once: with a {@link
 * carom.net.codec.RangeEncoder} the same lines write that with a {@link
 * carom.net.codec.RangeDecoder} read. {@code docs/PROTOCOL.md} has the same as tables.
 *
 * <p>A record is its kind, its slot, its content. Kind and slot have nodes in a small table of
 * probabilities. As a datagram must be decodable alone, each begins with the same table, and adapts
 * it as it goes on. One object codes one datagram at a time.
 */
final class RecordCodec {

  /** Kinds of records. */
  static final int DELTA = 0;

  static final int ABSOLUTE = 1;
  static final int GONE = 2;
  static final int OUT_OF_SIGHT = 3;

  /** The end of the records, as a kind. */
  static final int END = 4;

  static final int AGE_BITS = 6;

  /** Most records of a datagram. */
  static final int MAX_RECORDS = 4_096;

  private static final int SLOT_BITS = 16;
  private static final int SHORT_ARCHETYPE_BITS = 6;
  private static final int WIDTH_BITS = 5;
  private static final int ANGLE_BITS = 10;
  private static final int MAX_WIDTH = 27;
  private static final int MAX_DIGITS = 17;

  // Nodes.
  private static final int STRAIGHT = 0;
  private static final int AGAIN = STRAIGHT + 2;
  private static final int END_FIRST = AGAIN + 1;
  private static final int END_LATER = END_FIRST + 1;
  private static final int IS_DELTA = END_LATER + 1;
  private static final int IS_ABSOLUTE = IS_DELTA + 1;
  private static final int IS_GONE = IS_ABSOLUTE + 1;
  private static final int SAME_AGE = IS_GONE + 1;
  private static final int SAME_PROFILE = SAME_AGE + 1;
  private static final int NEXT = SAME_PROFILE + 1;
  private static final int BACK = NEXT + 1;
  private static final int GAP = BACK + 1;
  private static final int NODES = GAP + MAX_DIGITS - 1;

  /** Probabilities of a 1 that a datagram begins with, in percent. */
  private static final int[] PRIOR = {
    70, 95, 70, 10, 30, 60, 80, 50, 50, 80, 80, 3, 70, 65, 60, 55, 50, 50, 50, 50, 50, 50, 50, 50,
    50, 50, 50, 50
  };

  private final BitTable table = new BitTable(prior());
  private int slot;
  private int age;
  private int profile;
  private boolean isFirst;
  private boolean isStraight;
  private int markedSlot;
  private int markedAge;
  private int markedProfile;
  private boolean markedFirst;
  private boolean markedStraight;

  private static char[] prior() {
    char[] prior = new char[NODES];
    for (int node = 0; node < NODES; node++) {
      prior[node] = (char) (BitCoder.ONE * PRIOR[node] / 100);
    }
    return prior;
  }

  private boolean flag(BitCoder c, int node, boolean value) {
    return table.code(c, node, value ? 1 : 0) != 0;
  }

  /** Starts a datagram. */
  void begin() {
    table.begin();
    slot = -1;
    age = 0;
    isFirst = true;
    isStraight = false;
  }

  /** Remembers this place, before a record that may not fit. */
  void mark() {
    table.mark();
    markedSlot = slot;
    markedAge = age;
    markedProfile = profile;
    markedFirst = isFirst;
    markedStraight = isStraight;
  }

  /** Goes back to the last {@link #mark}. */
  void rewind() {
    table.rewind();
    slot = markedSlot;
    age = markedAge;
    profile = markedProfile;
    isFirst = markedFirst;
    isStraight = markedStraight;
  }

  /**
   * Codes what a record is, and of which {@link #slot}: mostly a delta of the same age and profile
   * as the one before, of the next slot.
   *
   * @param slot nothing, at the end
   * @param age ticks, of a delta
   * @param profile of a delta
   * @return the kind
   */
  int head(BitCoder c, int kind, int slot, int age, int profile) {
    if (this.age > 0) {
      boolean again = kind == DELTA && age == this.age && profile == this.profile;
      isStraight = flag(c, STRAIGHT + (isStraight ? 1 : 0), again && slot == this.slot + 1);
      if (isStraight) {
        this.slot++;
        return DELTA;
      }
      if (flag(c, AGAIN, again)) {
        otherSlot(c, slot);
        return DELTA;
      }
    }
    if (flag(c, isFirst ? END_FIRST : END_LATER, kind == END)) {
      return END;
    }
    isFirst = false;
    int result = otherKind(c, kind, age, profile);
    if (flag(c, NEXT, slot == this.slot + 1)) {
      this.slot++;
    } else {
      otherSlot(c, slot);
    }
    return result;
  }

  private int otherKind(BitCoder c, int kind, int age, int profile) {
    if (flag(c, IS_DELTA, kind == DELTA)) {
      delta(c, age, profile);
      return DELTA;
    }
    if (flag(c, IS_ABSOLUTE, kind == ABSOLUTE)) {
      return ABSOLUTE;
    }
    return flag(c, IS_GONE, kind == GONE) ? GONE : OUT_OF_SIGHT;
  }

  private void delta(BitCoder c, int newAge, int newProfile) {
    boolean firstDelta = age == 0;
    if (firstDelta || !flag(c, SAME_AGE, newAge == age)) {
      age = c.plain(newAge, AGE_BITS);
      if (!firstDelta && flag(c, SAME_PROFILE, newProfile == profile)) {
        return;
      }
    }
    profile = c.plain(newProfile, Profiles.BITS);
  }

  /** Age of the last delta, ticks; of hostile bytes, 0 too. */
  int age() {
    return age;
  }

  /** Profile of the last delta. */
  int profile() {
    return profile;
  }

  /** Slot of the last record. */
  int slot() {
    return slot;
  }

  /** Codes a slot that isn't the next; mostly they ascend within a datagram. */
  private void otherSlot(BitCoder c, int value) {
    if (flag(c, BACK, value <= slot)) {
      slot = c.plain(value, SLOT_BITS);
    } else {
      slot += 1 + gap(c, value - slot - 1);
    }
  }

  /** A number of at least 1: how many binary digits, then those behind the first. */
  private int gap(BitCoder c, int value) {
    int digits = 1;
    while (digits < MAX_DIGITS && flag(c, GAP + digits - 1, value >>> digits != 0)) {
      digits++;
    }
    return 1 << digits - 1 | c.plain(value, digits - 1);
  }

  int generation(BitCoder c, int value) {
    return c.plain(value, 8);
  }

  int archetype(BitCoder c, int value) {
    int wide = c.plain(value >= 1 << SHORT_ARCHETYPE_BITS ? 1 : 0, 1);
    return c.plain(value, wide != 0 ? 16 : SHORT_ARCHETYPE_BITS);
  }

  int owner(BitCoder c, int value) {
    return c.plain(value >= 0 ? 1 : 0, 1) != 0 ? PlayerId.code(c, value) : -1;
  }

  /**
   * Codes how often the entity was put elsewhere.
   *
   * @param teleports 0..15
   */
  int teleports(BitCoder c, int teleports) {
    boolean any = c.plain(teleports != 0 ? 1 : 0, 1) != 0;
    return any ? c.plain(teleports, FrameState.TELEPORT_BITS) : 0;
  }

  void absolute(BitCoder c, Motion motion) {
    motion.x = sized(c, motion.x);
    motion.y = sized(c, motion.y);
    motion.angle = c.plain(motion.angle, ANGLE_BITS);
    boolean moving = c.plain((motion.vx | motion.vy | motion.omega) != 0 ? 1 : 0, 1) != 0;
    motion.vx = moving ? sized(c, motion.vx) : 0;
    motion.vy = moving ? sized(c, motion.vy) : 0;
    motion.omega = moving ? sized(c, motion.omega) : 0;
  }

  private static int sized(BitCoder c, int value) {
    int z = Bits.zigzag(value);
    int width = Math.min(MAX_WIDTH, c.plain(Bits.width(z), WIDTH_BITS));
    return Bits.unzigzag(c.plain(z, width));
  }
}
