package carom.net.snapshot;

import java.util.Arrays;

/**
 * What one client knows of each entity, and which entities it is told about next: sight, baselines,
 * priorities. The encoder writes what this chooses and reports what it has written.
 *
 * <p>Work per tick is for entities that changed and are in sight, and for those that wait; entities
 * that rest cost nothing, and neither do entities out of sight. An entity that leaves the client's
 * view leaves its sight with the first change after that: as long as nothing changes, what the
 * client shows is the truth, and telling it to forget would cost more than letting it remember.
 *
 * <p>One thread, no allocation in the steady state. Memory: 20 bytes per slot of the room.
 */
final class Selection {

  private static final int MIN_LENGTH = 64;
  private static final int UNKNOWN = -1;

  /** Classes of weight for sorting: eight to an octave, from 2^-8 to 2^24. */
  private static final int CLASSES = 256;

  private static final int CLASS_SHIFT = 20;
  private static final int LOWEST_CLASS = (127 - 8) << 3;

  /** Sizes assumed before any record was written, bits. */
  private static final float FIRST_DELTA_BITS = 44;

  private static final float FIRST_ABSOLUTE_BITS = 96;
  private static final float FAREWELL_BITS = 12;

  /** Of the budget, so much is promised to the heaviest, and so much may be tried. */
  private static final double SAFE_SHARE = 0.8;

  private static final double SPARE_SHARE = 1.4;

  /** Share of a new size in the running mean. */
  private static final float SIZE_SHARE = 1f / 32;

  /** What can't be foreseen from what the client knows counts more. */
  private static final float NEWS = 2;

  /** So does coming to rest: until it arrives, the client shows it moving on. */
  private static final float REST = 1.5f;

  private final FrameRing ring;
  private final Interest interest;
  private final SlotSet inSight = new SlotSet();

  /** The slots of which the client may show something. */
  private final SlotSet told = new SlotSet();

  private final SlotSet candidates = new SlotSet();
  private final SlotSet forced = new SlotSet();
  private final SlotSet chosen = new SlotSet();

  /** Goes where room is left: sizes are known only when written. */
  private final SlotSet spare = new SlotSet();

  private int[] acked = {};
  private int[] lastSent = {};

  /** Tick at which the slot came into sight or left it: acks of older records mean nothing. */
  private int[] sightTick = {};

  private float[] weight = {};
  private int[] order = {};
  private final int[] classCount = new int[CLASSES];
  private int seenTick = -1;
  private int weighedTick = -1;

  // The answer of update(), and whether it is out of date though the tick is the same.
  private int count;
  private double wanted;
  private boolean touched;

  // Of the last tick that lastHolding() was asked for: its frame and the one that follows it.
  private int borderTick = UNKNOWN;
  private int borderNow = UNKNOWN;
  private FrameState border;
  private FrameState behindBorder;
  private boolean sawEverything;
  private int waiting;
  private float leastChosen;
  private int cursor;
  private boolean onSpare;
  private float deltaBits = FIRST_DELTA_BITS;
  private float absoluteBits = FIRST_ABSOLUTE_BITS;

  // The answer of baseline(), besides its reason.
  private FrameState held;

  Selection(FrameRing ring, Interest interest) {
    this.ring = ring;
    this.interest = interest;
    learnLevel();
  }

  /** The client knows nothing but the level. */
  void reset() {
    Arrays.fill(acked, UNKNOWN);
    Arrays.fill(lastSent, UNKNOWN);
    Arrays.fill(sightTick, 0);
    Arrays.fill(weight, 0);
    inSight.clear();
    told.clear();
    candidates.clear();
    forced.clear();
    chosen.clear();
    spare.clear();
    waiting = 0;
    seenTick = -1;
    borderNow = UNKNOWN;
    learnLevel();
  }

  /**
   * The client shows the level's entities where the level places them, and we know that it does.
   */
  private void learnLevel() {
    FrameState level = ring.level();
    if (level == null || ring.newest() == null) {
      return;
    }
    int tick = ring.firstTick();
    ensure(level.slotLimit());
    for (int slot = 0; slot < level.slotLimit(); slot++) {
      if (level.alive(slot)) {
        inSight.add(slot);
        told.add(slot);
        acked[slot] = ring.asLevel().has(slot) ? tick : UNKNOWN;
      }
    }
  }

  private void ensure(int length) {
    if (length <= acked.length) {
      return;
    }
    int old = acked.length;
    int grown = Math.max(MIN_LENGTH, Math.max(length, 2 * old));
    acked = Arrays.copyOf(acked, grown);
    Arrays.fill(acked, old, grown, UNKNOWN);
    lastSent = Arrays.copyOf(lastSent, grown);
    Arrays.fill(lastSent, old, grown, UNKNOWN);
    sightTick = Arrays.copyOf(sightTick, grown);
    weight = Arrays.copyOf(weight, grown);
    order = new int[grown];
    inSight.ensure(grown);
    told.ensure(grown);
    candidates.ensure(grown);
    forced.ensure(grown);
    chosen.ensure(grown);
    spare.ensure(grown);
  }

  // ---- what the client knows

  /** The client has received what was written of the slot at a tick. */
  void ack(int slot, int tick) {
    if (tick < sightTick[slot]) {
      return;
    }
    touched = true;
    if (inSight.has(slot)) {
      acked[slot] = Math.max(acked[slot], tick);
    } else {
      told.remove(slot);
    }
  }

  /** The slot's next record is absolute, whatever was acked. */
  void force(int slot) {
    ensure(slot + 1);
    forced.add(slot);
    candidates.add(slot);
    touched = true;
  }

  /** Considers a slot that may have come into view. */
  void notice(int slot) {
    ensure(slot + 1);
    if (!inSight.has(slot)) {
      candidates.add(slot);
      touched = true;
    }
  }

  boolean isInSight(int slot) {
    return inSight.has(slot);
  }

  /** A record of the slot was written. */
  void wrote(int slot, int tick, int bits) {
    if (held != null) {
      deltaBits += (bits - deltaBits) * SIZE_SHARE;
    } else if (isShown(slot)) {
      absoluteBits += (bits - absoluteBits) * SIZE_SHARE;
    }
    told.add(slot);
    lastSent[slot] = tick;
    weight[slot] = 0;
    forced.remove(slot);
    (onSpare ? spare : chosen).remove(slot);
    waiting--;
    touched = true;
  }

  private boolean isShown(int slot) {
    return inSight.has(slot) && ring.newest().alive(slot);
  }

  // ---- what it is told

  /**
   * Looks at everything that changed since the last call.
   *
   * @return how many entities there is something to say about
   */
  int update(FrameState now) {
    see(now);
    touched = false;
    count = 0;
    wanted = 0;
    for (int slot = candidates.next(0); slot >= 0; slot = candidates.next(slot + 1)) {
      if (isNews(now, slot)) {
        count++;
        wanted += expectedBits(now, slot);
      }
    }
    return count;
  }

  /** As {@link #update}, whose last answer is good as long as nothing has happened since. */
  int updated(FrameState now) {
    return touched || seenTick != now.tick() ? update(now) : count;
  }

  /** Whether there is something to say about a candidate; if not, it is none any more. */
  private boolean isNews(FrameState now, int slot) {
    // Most are like this: known, alive, changed, and staying in sight.
    if (acked[slot] >= 0
        && acked[slot] < now.changedTick(slot)
        && inSight.has(slot)
        && now.alive(slot)
        && interest.sees(now, slot, true)) {
      return true;
    }
    look(now, slot);
    if (!isSettled(now, slot)) {
      return true;
    }
    candidates.remove(slot);
    if (!now.alive(slot)) {
      inSight.remove(slot);
      told.remove(slot);
    }
    return false;
  }

  private void see(FrameState now) {
    ensure(now.slotLimit());
    boolean everything = interest.everything();
    if (everything && !sawEverything) {
      seenTick = -1;
    }
    sawEverything = everything;
    if (seenTick == now.tick()) {
      return;
    }
    int back = 0;
    FrameState frame = now;
    while (frame != null && frame.tick() > seenTick) {
      if (everything) {
        candidates.addAll(frame.changed());
      } else {
        candidates.addCommon(frame.changed(), inSight);
      }
      frame = ring.back(++back);
    }
    if (frame == null) {
      // The last frame seen has left the ring, or there was none: anything may have changed.
      if (everything) {
        candidates.addBelow(now.slotLimit());
      } else {
        candidates.addAll(inSight);
      }
    }
    seenTick = now.tick();
  }

  /** Lets an entity into sight, or out of it. The dead stay as they are until it was told. */
  private void look(FrameState now, int slot) {
    if (!now.alive(slot)) {
      return;
    }
    boolean known = inSight.has(slot);
    if (known && isSettled(now, slot)) {
      return; // what the client shows is true, wherever it looks
    }
    if (interest.sees(now, slot, known) != known) {
      sightTick[slot] = now.tick();
      acked[slot] = UNKNOWN;
      if (known) {
        inSight.remove(slot);
      } else {
        inSight.add(slot);
      }
    }
  }

  /** Whether there is nothing to say about a slot. */
  private boolean isSettled(FrameState now, int slot) {
    if (!inSight.has(slot)) {
      return !told.has(slot);
    }
    if (!now.alive(slot) && !told.has(slot)) {
      return true;
    }
    boolean force = forced.has(slot) && now.alive(slot);
    return acked[slot] >= now.changedTick(slot) && !force;
  }

  /**
   * The one place that decides what a slot's record is coded against. For {@link Baseline#ACKED}
   * the frame is left in {@link #held}: the newest one in which the slot still is as it was in the
   * acked tick. So a body that begins to move after a long rest is coded against the end of its
   * rest, and the client learns when it began.
   */
  Baseline baseline(FrameState now, int slot) {
    held = null;
    if (slot >= acked.length) {
      return Baseline.QUIESCENT;
    }
    int ackedTick = acked[slot];
    if (ackedTick >= 0
        && ackedTick < now.changedTick(slot)
        && inSight.has(slot)
        && now.alive(slot)
        && !forced.has(slot)) {
      return against(now, slot, ackedTick); // as most are
    }
    if (isSettled(now, slot)) {
      return Baseline.QUIESCENT;
    }
    if (!inSight.has(slot)) {
      return Baseline.OUT_OF_SIGHT;
    }
    if (!now.alive(slot)) {
      return Baseline.GONE;
    }
    if (forced.has(slot)) {
      return Baseline.FORCED;
    }
    return ackedTick < 0 ? Baseline.NEW : against(now, slot, ackedTick);
  }

  private Baseline against(FrameState now, int slot, int ackedTick) {
    FrameState newestHolding = lastHolding(slot, ackedTick);
    if (newestHolding == null) {
      return now.tick() - ackedTick < FrameRing.SIZE ? Baseline.ROLLED_OUT : Baseline.TOO_OLD;
    }
    if (now.tick() - newestHolding.tick() >= FrameRing.SIZE) {
      return Baseline.TOO_OLD;
    }
    if (!now.sameIdentitySince(newestHolding, slot)) {
      return Baseline.IDENTITY;
    }
    held = newestHolding;
    return Baseline.ACKED;
  }

  /** The frame of the last {@link Baseline#ACKED}, else null. */
  FrameState held() {
    return held;
  }

  /** The newest frame in which the slot is as in the acked tick, or null when the ring has none. */
  private FrameState lastHolding(int slot, int ackedTick) {
    int now = ring.newest().tick();
    if (ackedTick != borderTick || now != borderNow) {
      borderTick = ackedTick;
      borderNow = now;
      border = ring.at(ackedTick);
      behindBorder = ring.at(ackedTick + 1);
    }
    if (behindBorder != null && behindBorder.changedTick(slot) > ackedTick) {
      return border;
    }
    // changedTick only grows from frame to frame: search the border between "still as acked" and
    // "changed".
    int holds = ring.count();
    int differs = 0;
    while (holds - differs > 1) {
      int middle = (holds + differs) >>> 1;
      FrameState candidate = ring.back(middle);
      if (candidate.tick() >= ackedTick && candidate.changedTick(slot) > ackedTick) {
        differs = middle;
      } else {
        holds = middle;
      }
    }
    FrameState newest = ring.back(holds);
    return newest != null && newest.tick() >= ackedTick ? newest : null;
  }

  // ---- what it is told first

  /**
   * Chooses what goes into this tick's datagrams, after {@link #update}: everything, or when that
   * is more than fits, who has collected most priority. What doesn't fit goes on collecting.
   *
   * @param count what {@link #update} answered
   */
  void choose(FrameState now, int count, int budgetBytes) {
    waiting = count;
    boolean waited = chosen.next(0) >= 0 || leastChosen > 0;
    chosen.set(candidates);
    spare.clear();
    leastChosen = 0;
    boolean fits = wanted <= 8.0 * budgetBytes;
    if (!fits || waited) {
      weigh(now);
    }
    if (!fits) {
      chooseHeaviest(now, 8.0 * budgetBytes);
    }
  }

  private void weigh(FrameState now) {
    int ticks = weighedTick < 0 ? 1 : Math.max(1, Math.min(255, now.tick() - weighedTick));
    weighedTick = now.tick();
    for (int slot = candidates.next(0); slot >= 0; slot = candidates.next(slot + 1)) {
      weight[slot] += ticks * priority(now, slot);
    }
  }

  /** What a slot collects per tick. */
  float priority(FrameState now, int slot) {
    if (!isShown(slot)) {
      return 1;
    }
    float priority = interest.priority(now, slot);
    if (acked[slot] < 0 || forced.has(slot)) {
      return priority * NEWS;
    }
    return (now.vx(slot) | now.vy(slot) | now.omega(slot)) == 0 ? priority * REST : priority;
  }

  private float expectedBits(FrameState now, int slot) {
    if (!inSight.has(slot) || !now.alive(slot)) {
      return FAREWELL_BITS;
    }
    return acked[slot] < 0 ? absoluteBits : deltaBits;
  }

  /** A counting sort by classes of weight: linear. */
  private void chooseHeaviest(FrameState now, double bits) {
    chosen.clear();
    Arrays.fill(classCount, 0);
    for (int slot = candidates.next(0); slot >= 0; slot = candidates.next(slot + 1)) {
      classCount[lightness(slot)]++;
    }
    int at = 0;
    for (int i = 0; i < CLASSES; i++) {
      int count = classCount[i];
      classCount[i] = at;
      at += count;
    }
    for (int slot = candidates.next(0); slot >= 0; slot = candidates.next(slot + 1)) {
      order[classCount[lightness(slot)]++] = slot;
    }
    double sum = 0;
    for (int i = 0; i < at && sum < bits * SPARE_SHARE; i++) {
      sum += expectedBits(now, order[i]);
      if (sum < bits * SAFE_SHARE) {
        chosen.add(order[i]);
        leastChosen = weight[order[i]];
      } else {
        spare.add(order[i]);
      }
    }
  }

  private int lightness(int slot) {
    int heaviness = (Float.floatToIntBits(weight[slot]) >>> CLASS_SHIFT) - LOWEST_CLASS;
    return CLASSES - 1 - Math.max(0, Math.min(CLASSES - 1, heaviness));
  }

  /** Whether anything chosen isn't written yet. */
  boolean hasChosen() {
    return chosen.next(0) >= 0 || spare.next(0) >= 0;
  }

  /** Begins a datagram: {@link #next} starts again with what isn't written yet. */
  void rewind() {
    cursor = 0;
    onSpare = false;
  }

  /**
   * The next slot to be written, ascending, then the spare ones; {@link SlotSet#NONE} at the end.
   */
  int next() {
    int slot = onSpare ? SlotSet.NONE : chosen.next(cursor);
    if (slot < 0) {
      slot = spare.next(onSpare ? cursor : 0);
      onSpare = true;
    }
    cursor = slot + 1;
    return slot;
  }

  // ---- to look into

  /** Entities there is something to say about and that weren't written since. */
  int waiting() {
    return waiting;
  }

  int ackedTick(int slot) {
    return slot < acked.length ? acked[slot] : UNKNOWN;
  }

  int sentTick(int slot) {
    return slot < lastSent.length ? lastSent[slot] : UNKNOWN;
  }

  float weight(int slot) {
    return slot < weight.length ? weight[slot] : 0;
  }

  /** Least priority collected by anything chosen when not everything fitted; 0 when it did. */
  float leastChosen() {
    return leastChosen;
  }
}
