package carom.net.snapshot;

import carom.net.snapshot.frame.FrameRing;
import carom.net.snapshot.frame.FrameState;
import carom.net.snapshot.frame.SlotSet;
import carom.net.snapshot.frame.SlotTicks;
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
 * <p>Most slots have many alike among their neighbours: acked at the same tick, changed since, in
 * sight. Such are looked at 64 at a time.
 *
 * <p>One thread, no allocation in the steady state. Memory: 21 bytes per slot of the room.
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

  /** The slots that have collected any weight. */
  private final SlotSet weighty = new SlotSet();

  private final SlotTicks acked = new SlotTicks();
  private final SlotTicks lastSent = new SlotTicks();

  /** Tick at which the slot came into sight or left it: acks of older records mean nothing. */
  private int[] sightTick = {};

  /** The newest of those by word. */
  private int[] sightTicks = {};

  private float[] weight = {};
  private int[] order = {};
  private final int[] classCount = new int[CLASSES];
  private int seenTick = -1;
  private int weighedTick = -1;

  // The answer of update(), and whether it is out of date though the tick is the same.
  private int count;
  private double wanted;
  private boolean touched;

  // Of the last tick that backTo() was asked for, and its answer.
  private int askedTick = UNKNOWN;
  private int askedNow = UNKNOWN;
  private int askedBack;
  private boolean sawEverything;
  private int waiting;
  private float leastChosen;
  private int cursor;
  private boolean onSpare;
  private float deltaBits = FIRST_DELTA_BITS;
  private float absoluteBits = FIRST_ABSOLUTE_BITS;

  // Of the word at the cursor: those of its slots that are chosen and not given yet, by the frame
  // they are coded against.
  private final FrameState[] groupHeld = new FrameState[FrameRing.SIZE];
  private final long[] groupSlots = new long[FrameRing.SIZE];
  private int groups;
  private long runSlots;

  // The answer of baseline(), besides its reason.
  private FrameState held;

  Selection(FrameRing ring, Interest interest) {
    this.ring = ring;
    this.interest = interest;
    learnLevel();
  }

  /** The client knows nothing but the level. */
  void reset() {
    acked.clear();
    lastSent.clear();
    Arrays.fill(sightTick, 0);
    Arrays.fill(sightTicks, 0);
    Arrays.fill(weight, 0);
    weighty.clear();
    inSight.clear();
    told.clear();
    candidates.clear();
    forced.clear();
    chosen.clear();
    spare.clear();
    waiting = 0;
    seenTick = -1;
    askedNow = UNKNOWN;
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
      }
    }
    SlotSet same = ring.asLevel();
    for (int word = same.nextWord(0); word >= 0; word = same.nextWord(word + 1)) {
      acked.raise(word, same.word(word), tick);
    }
  }

  private void ensure(int length) {
    if (length <= weight.length) {
      return;
    }
    int grown = Math.max(MIN_LENGTH, Math.max(length, 2 * weight.length)) + 63 & -64;
    acked.ensure(grown);
    lastSent.ensure(grown);
    sightTick = Arrays.copyOf(sightTick, grown);
    sightTicks = Arrays.copyOf(sightTicks, grown >> 6);
    weight = Arrays.copyOf(weight, grown);
    order = new int[grown];
    inSight.ensure(grown);
    told.ensure(grown);
    candidates.ensure(grown);
    forced.ensure(grown);
    chosen.ensure(grown);
    spare.ensure(grown);
    weighty.ensure(grown);
  }

  // ---- what the client knows

  /** The client has received what was written of some of 64 slots at a tick. */
  void ack(int word, long slots, int tick) {
    long meant = slots;
    if (tick < sightTicks[word]) {
      for (long rest = slots; rest != 0; rest &= rest - 1) {
        int slot = (word << 6) + Long.numberOfTrailingZeros(rest);
        meant ^= tick < sightTick[slot] ? Long.lowestOneBit(rest) : 0;
      }
    }
    long shown = meant & inSight.word(word);
    told.removeWord(word, meant ^ shown);
    if (shown != 0) {
      acked.raise(word, shown | steady(word, acked.layer(word) & ~shown, tick), tick);
    }
    touched = true;
  }

  /**
   * Those of a layer that were not told, as they had not changed up to a tick: what the client
   * holds of them is true of that tick, too, and they stay with the others.
   */
  private long steady(int word, long slots, int tick) {
    if (slots == 0 || acked.layerTick(word) >= tick) {
      return 0;
    }
    int to = ring.backTo(tick);
    int from = to < 0 ? -1 : ring.backTo(acked.layerTick(word));
    long rest = from < 0 ? 0 : slots & inSight.word(word);
    for (int back = to; back < from; back++) {
      rest &= ~ring.back(back).changed().word(word);
    }
    return rest;
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

  /** A record of the slot was written that isn't part of a run. */
  void wrote(int slot, int tick, int bits) {
    if (isShown(slot)) {
      absoluteBits += (bits - absoluteBits) * SIZE_SHARE;
    }
    wrote(slot >> 6, 1L << slot, tick);
  }

  /** Some of 64 slots were written as a run. */
  void wroteRun(int word, long slots, int tick, int bits) {
    int deltas = Long.bitCount(slots);
    deltaBits += ((float) bits / deltas - deltaBits) * Math.min(1, deltas * SIZE_SHARE);
    wrote(word, slots, tick);
  }

  private void wrote(int word, long slots, int tick) {
    told.addWord(word, slots);
    lastSent.raise(word, slots, tick);
    for (long rest = slots & weighty.word(word); rest != 0; rest &= rest - 1) {
      weight[(word << 6) + Long.numberOfTrailingZeros(rest)] = 0;
    }
    weighty.removeWord(word, slots);
    forced.removeWord(word, slots);
    (onSpare ? spare : chosen).removeWord(word, slots);
    waiting -= Long.bitCount(slots);
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
    for (int word = candidates.nextWord(0); word >= 0; word = candidates.nextWord(word + 1)) {
      for (long rest = update(now, word); rest != 0; rest &= rest - 1) {
        int slot = (word << 6) + Long.numberOfTrailingZeros(rest);
        if (isNews(now, slot)) {
          count++;
          wanted += expectedBits(now, slot);
        }
      }
    }
    return count;
  }

  /** Looks at what is as most in a word; answers those that are to be looked at one by one. */
  private long update(FrameState now, int word) {
    long all = candidates.word(word);
    long known = all & known(now, word);
    if (known == 0) {
      return all;
    }
    long changed = known & ring.changes().since(backTo(acked.layerTick(word)), word);
    candidates.removeWord(word, known ^ changed);
    long seen = interest.stay(now, word, changed);
    int news = Long.bitCount(seen);
    count += news;
    wanted += news * deltaBits;
    return all & ~known | changed & ~seen;
  }

  /**
   * Those of a word that are alive and in sight, and that the client holds as of the tick of its
   * layer, of which the ring has the frame.
   */
  private long known(FrameState now, int word) {
    long layer = acked.layer(word);
    if (layer == 0 || backTo(acked.layerTick(word)) < 0) {
      return 0;
    }
    return layer & inSight.word(word) & now.living().word(word) & ~forced.word(word);
  }

  /** As {@link FrameRing#backTo}; mostly for the tick that was asked for before. */
  private int backTo(int tick) {
    int now = ring.newest().tick();
    if (tick != askedTick || now != askedNow) {
      askedTick = tick;
      askedNow = now;
      askedBack = ring.backTo(tick);
    }
    return askedBack;
  }

  /** As {@link #update}, whose last answer is good as long as nothing has happened since. */
  int updated(FrameState now) {
    return touched || seenTick != now.tick() ? update(now) : count;
  }

  /** Whether there is something to say about a candidate; if not, it is none any more. */
  private boolean isNews(FrameState now, int slot) {
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
      sightTicks[slot >> 6] = now.tick();
      acked.set(slot, UNKNOWN);
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
    return acked.get(slot) >= ring.changedTick(slot) && !force;
  }

  /**
   * The one place that decides what a slot's record is coded against. For {@link Baseline#ACKED}
   * the frame is left in {@link #held}: the newest one in which the slot still is as it was in the
   * acked tick. So a body that begins to move after a long rest is coded against the end of its
   * rest, and the client learns when it began.
   */
  Baseline baseline(FrameState now, int slot) {
    held = null;
    if (slot >= weight.length || isSettled(now, slot)) {
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
    int ackedTick = acked.get(slot);
    return ackedTick < 0 ? Baseline.NEW : against(now, slot, ackedTick);
  }

  private Baseline against(FrameState now, int slot, int ackedTick) {
    FrameState newestHolding = ring.lastLike(slot, ackedTick);
    if (newestHolding == null) {
      return now.tick() - ackedTick < FrameRing.SIZE ? Baseline.ROLLED_OUT : Baseline.TOO_OLD;
    }
    if (now.tick() - newestHolding.tick() >= FrameRing.SIZE) {
      return Baseline.TOO_OLD;
    }
    if (!now.sameIdentity(newestHolding, slot)) {
      return Baseline.IDENTITY;
    }
    held = newestHolding;
    return Baseline.ACKED;
  }

  /** The frame of the last {@link Baseline#ACKED}, else null. */
  FrameState held() {
    return held;
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
      weighty.add(slot);
    }
  }

  /** What a slot collects per tick. */
  float priority(FrameState now, int slot) {
    if (!isShown(slot)) {
      return 1;
    }
    float priority = interest.priority(now, slot);
    if (acked.get(slot) < 0 || forced.has(slot)) {
      return priority * NEWS;
    }
    return (now.vx(slot) | now.vy(slot) | now.omega(slot)) == 0 ? priority * REST : priority;
  }

  private float expectedBits(FrameState now, int slot) {
    if (!inSight.has(slot) || !now.alive(slot)) {
      return FAREWELL_BITS;
    }
    return acked.get(slot) < 0 ? absoluteBits : deltaBits;
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

  /** Begins a datagram: all that isn't written yet is given again, those that must go first. */
  void rewind() {
    onSpare = false;
    cursor = 0;
  }

  /** Goes on to what is given if room is left. */
  void toSpare() {
    onSpare = true;
    cursor = 0;
  }

  /** Goes on to runs, of those that must go first or of the spare ones. */
  void toRuns() {
    cursor = 0;
    groups = 0;
  }

  /**
   * The next slot, ascending, that is to be written alone, as it has no {@link #held} frame; {@link
   * SlotSet#NONE} at the end.
   */
  int nextSingle(FrameState now) {
    SlotSet from = onSpare ? spare : chosen;
    for (int slot = from.next(cursor); slot >= 0; slot = from.next(slot + 1)) {
      int word = slot >> 6;
      long alone = from.word(word) & ~plain(now, word) & -1L << slot;
      for (; alone != 0; alone &= alone - 1) {
        slot = (word << 6) + Long.numberOfTrailingZeros(alone);
        if (baseline(now, slot) != Baseline.ACKED) {
          cursor = slot + 1;
          return slot;
        }
      }
      slot = word << 6 | 63;
    }
    return SlotSet.NONE;
  }

  /** Those of a word that are coded against a frame, as is seen at once. */
  private long plain(FrameState now, int word) {
    long known = known(now, word);
    if (known == 0 || now.tick() - acked.layerTick(word) >= FrameRing.SIZE) {
      return 0;
    }
    return known & ~ring.changes().renamedSince(backTo(acked.layerTick(word)), word);
  }

  /**
   * Goes to the next run: some of 64 slots that are all coded against the frame {@link #held}.
   *
   * @return whether there is one
   */
  boolean nextRun(FrameState now) {
    SlotSet from = onSpare ? spare : chosen;
    while (groups == 0) {
      int word = from.nextWord(cursor);
      if (word < 0) {
        return false;
      }
      cursor = word + 1;
      group(now, word, from.word(word));
    }
    groups--;
    held = groupHeld[groups];
    runSlots = groupSlots[groups];
    return true;
  }

  /** The run's slots are some from 64 times that on. */
  int runWord() {
    return cursor - 1;
  }

  /** Which of those: the lowest bit is the first. */
  long runSlots() {
    return runSlots;
  }

  /** Sorts slots by the newest frame in which they are as acked. */
  private void group(FrameState now, int word, long slots) {
    long rest = slots & plain(now, word);
    for (long alone = slots ^ rest; alone != 0; alone &= alone - 1) {
      int slot = (word << 6) + Long.numberOfTrailingZeros(alone);
      if (baseline(now, slot) == Baseline.ACKED) {
        addToGroup(held, 1L << slot);
      }
    }
    for (int back = rest == 0 ? 0 : backTo(acked.layerTick(word)); back > 0 && rest != 0; back--) {
      long changed = rest & ring.back(back - 1).changed().word(word);
      if (changed != 0) {
        addToGroup(ring.back(back), changed);
        rest ^= changed;
      }
    }
  }

  private void addToGroup(FrameState frame, long slots) {
    for (int i = 0; i < groups; i++) {
      if (groupHeld[i] == frame) {
        groupSlots[i] |= slots;
        return;
      }
    }
    groupHeld[groups] = frame;
    groupSlots[groups++] = slots;
  }

  // ---- to look into

  /** Entities there is something to say about and that weren't written since. */
  int waiting() {
    return waiting;
  }

  int ackedTick(int slot) {
    return acked.get(slot);
  }

  int sentTick(int slot) {
    return lastSent.get(slot);
  }

  float weight(int slot) {
    return slot < weight.length ? weight[slot] : 0;
  }

  /** Least priority collected by anything chosen when not everything fitted; 0 when it did. */
  float leastChosen() {
    return leastChosen;
  }
}
