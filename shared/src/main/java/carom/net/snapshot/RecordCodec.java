package carom.net.snapshot;

import carom.net.codec.BitCoder;
import carom.net.codec.Bits;
import carom.net.snapshot.frame.FrameRing;
import carom.net.snapshot.frame.FrameState;
import carom.net.snapshot.frame.Ownership;
import carom.net.snapshot.frame.QuantizedPose;

/**
 * The form of a datagram's records but for what deltas tell, described once: with a {@link
 * carom.net.codec.RangeEncoder} the same lines write that with a {@link
 * carom.net.codec.RangeDecoder} read. {@code docs/protocol/CODING.md} has the same as tables.
 *
 * <p>Deltas come in <em>runs</em>: some of 64 neighbouring slots, all against the same tick. What a
 * run is has nodes in a small table of probabilities. As a datagram must be decodable alone, each
 * begins with the same table, and adapts it as it goes on. What is behind that doesn't depend on
 * the datagram: which slots, and their deltas. All other records stand alone: kind, slot, content.
 * One object codes one datagram at a time.
 */
final class RecordCodec {

  /** Kind of record that holds the deltas of some neighbouring slots. */
  public static final int RUN = 0;

  /** Kind of record that holds all of an entity. */
  public static final int ABSOLUTE = 1;

  /** Kind of record that says that a slot is free. */
  public static final int GONE = 2;

  /** Kind of record that says that an entity left the sight of the client. */
  public static final int OUT_OF_SIGHT = 3;

  /** Kind that stands for the end of the records. */
  public static final int END = 4;

  /** Number of records of a datagram, at most; each slot of a run counts. */
  public static final int MAX_RECORDS = 4_096;

  private static final int SLOT_BITS = 16;
  private static final int WORD_BITS = 10;
  private static final int SHORT_ARCHETYPE_BITS = 6;
  private static final int WIDTH_BITS = 5;
  private static final int ANGLE_BITS = 10;
  private static final int MAX_WIDTH = 27;
  private static final int MAX_DIGITS = 17;

  // Nodes.
  private static final int IS_RUN = 0;
  private static final int END_FIRST = IS_RUN + 2;
  private static final int END_LATER = END_FIRST + 1;
  private static final int IS_ABSOLUTE = END_LATER + 1;
  private static final int IS_GONE = IS_ABSOLUTE + 1;
  private static final int SAME_BASELINE = IS_GONE + 1;
  private static final int BASELINE_BEFORE = SAME_BASELINE + 1;
  private static final int SAME_PROFILE = BASELINE_BEFORE + 1;
  private static final int SAME_DENSITY = SAME_PROFILE + 2;
  private static final int NEXT_WORD = SAME_DENSITY + 1;
  private static final int NEXT_SLOT = NEXT_WORD + 1;
  private static final int BACK = NEXT_SLOT + 1;
  private static final int GAP = BACK + 1;
  private static final int NODES = GAP + MAX_DIGITS - 1;

  /** Probabilities of a 1 at the begin of a datagram, percent. */
  private static final int[] PRIOR = {
    60, 90, 10, 90, 80, 50, 85, 40, 75, 75, 90, 85, 80, 3, 70, 65, 60, 55, 50, 50, 50, 50, 50, 50,
    50, 50, 50, 50, 50, 50
  };

  private final BitTable table = new BitTable(prior());
  private int slot;
  private int word;
  private int baseline;
  private int baselineBefore;
  private int lowProfile;
  private int highProfile;
  private int density;
  private boolean isFirst;
  private boolean isRun;
  private int markedSlot;
  private int markedWord;
  private int markedBaseline;
  private int markedBaselineBefore;
  private int markedLowProfile;
  private int markedHighProfile;
  private int markedDensity;
  private boolean markedFirst;
  private boolean markedRun;

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
  public void begin() {
    table.begin();
    slot = -1;
    word = -1;
    baseline = 0;
    baselineBefore = 0;
    isFirst = true;
    isRun = false;
  }

  /** Remembers this place, before a record that may not fit. */
  public void mark() {
    table.mark();
    markedSlot = slot;
    markedWord = word;
    markedBaseline = baseline;
    markedBaselineBefore = baselineBefore;
    markedLowProfile = lowProfile;
    markedHighProfile = highProfile;
    markedDensity = density;
    markedFirst = isFirst;
    markedRun = isRun;
  }

  /** Goes back to the last {@link #mark}. */
  public void rewind() {
    table.rewind();
    slot = markedSlot;
    word = markedWord;
    baseline = markedBaseline;
    baselineBefore = markedBaselineBefore;
    lowProfile = markedLowProfile;
    highProfile = markedHighProfile;
    density = markedDensity;
    isFirst = markedFirst;
    isRun = markedRun;
  }

  /** Codes what comes next: of a run its {@link #run} follows, of most others their slot. */
  public int kind(BitCoder c, int kind) {
    boolean first = isFirst;
    isFirst = false;
    // Asked before all else, as an arithmetic code of nothing but yes takes no bytes.
    if (first && flag(c, END_FIRST, kind == END)) {
      return END;
    }
    isRun = flag(c, IS_RUN + (isRun ? 1 : 0), kind == RUN);
    if (isRun) {
      return RUN;
    }
    if (!first && flag(c, END_LATER, kind == END)) {
      return END;
    }
    if (flag(c, IS_ABSOLUTE, kind == ABSOLUTE)) {
      return ABSOLUTE;
    }
    return flag(c, IS_GONE, kind == GONE) ? GONE : OUT_OF_SIGHT;
  }

  /**
   * Codes what all of a run have in common, mostly the same as of the run before, but the next 64
   * slots.
   *
   * @param word the 64 slots from 64 {@code word} on
   * @param baseline see {@link Baseline}
   * @param low profile of the lower 32 slots, see {@link Profiles}
   * @param high profile of the others
   * @param density of {@link SlotCodec}
   */
  public void run(BitCoder c, int word, int baseline, int low, int high, int density) {
    boolean firstRun = this.baseline == 0;
    if (firstRun || !flag(c, SAME_BASELINE, baseline == this.baseline)) {
      int other = baselineBefore;
      baselineBefore = this.baseline;
      boolean before = other > 0 && flag(c, BASELINE_BEFORE, baseline == other);
      this.baseline = before ? other : baseline(c, baseline);
    }
    boolean same = !firstRun && flag(c, SAME_PROFILE, low == highProfile);
    lowProfile = same ? highProfile : c.plain(low, Profiles.BITS);
    same = flag(c, SAME_PROFILE + 1, high == lowProfile);
    highProfile = same ? lowProfile : c.plain(high, Profiles.BITS);
    if (firstRun || !flag(c, SAME_DENSITY, density == this.density)) {
      this.density = c.plain(density, SlotCodec.DENSITY_BITS);
    }
    if (flag(c, NEXT_WORD, word == this.word + 1)) {
      this.word++;
    } else if (flag(c, BACK, word < this.word)) {
      this.word = c.plain(word, WORD_BITS);
    } else {
      this.word += gap(c, word - this.word + 1) - 1;
    }
  }

  private static int baseline(BitCoder c, int baseline) {
    int age = c.plain(Baseline.age(baseline), FrameRing.AGE_BITS);
    int poses = c.plain(Baseline.poses(baseline), Baseline.POSES_BITS);
    int stride = poses > 1 ? c.plain(Baseline.stride(baseline), Baseline.STRIDE_BITS) : 0;
    return Baseline.of(age, poses, stride);
  }

  /** Returns the baseline of the last run; after hostile bytes it may not be valid. */
  public int baseline() {
    return baseline;
  }

  /** Returns the profile of the last run's lower 32 slots. */
  public int lowProfile() {
    return lowProfile;
  }

  /** Returns the profile of the last run's upper 32 slots. */
  public int highProfile() {
    return highProfile;
  }

  /** Returns the density of the last run. */
  public int density() {
    return density;
  }

  /** Returns the word of the last run: its slots begin at 64 times that. */
  public int word() {
    return word;
  }

  /** Codes the slot of a record that is no run; mostly they ascend within a datagram. */
  public int slot(BitCoder c, int value) {
    if (flag(c, NEXT_SLOT, value == slot + 1)) {
      slot++;
    } else if (flag(c, BACK, value <= slot)) {
      slot = c.plain(value, SLOT_BITS);
    } else {
      slot += 1 + gap(c, value - slot - 1);
    }
    return slot;
  }

  /** Codes a number of at least 1: how many binary digits, then those behind the first. */
  private int gap(BitCoder c, int value) {
    int digits = 1;
    while (digits < MAX_DIGITS && flag(c, GAP + digits - 1, value >>> digits != 0)) {
      digits++;
    }
    return 1 << digits - 1 | c.plain(value, digits - 1);
  }

  /** Codes a generation, 0..255. */
  public int generation(BitCoder c, int value) {
    return c.plain(value, 8);
  }

  /** Codes an archetype, 0..65,535. */
  public int archetype(BitCoder c, int value) {
    boolean wide = c.flag(value >= 1 << SHORT_ARCHETYPE_BITS);
    return c.plain(value, wide ? 16 : SHORT_ARCHETYPE_BITS);
  }

  /** Codes whose the entity is. */
  public int owner(BitCoder c, int value) {
    return Ownership.code(c, value);
  }

  /**
   * Codes how often the entity was teleported, modulo 16.
   *
   * @param teleports 0..15
   */
  public int teleports(BitCoder c, int teleports) {
    return c.flag(teleports != 0) ? c.plain(teleports, FrameState.TELEPORT_BITS) : 0;
  }

  /** Codes a pose by itself; what is read may be out of range. */
  public void absolute(BitCoder c, QuantizedPose pose) {
    pose.x = sized(c, pose.x);
    pose.y = sized(c, pose.y);
    pose.angle = c.plain(pose.angle, ANGLE_BITS);
    pose.still = c.flag(pose.still);
  }

  private static int sized(BitCoder c, int value) {
    int z = Bits.zigzag(value);
    int width = Math.min(MAX_WIDTH, c.plain(Bits.width(z), WIDTH_BITS));
    return Bits.unzigzag(c.plain(z, width));
  }
}
