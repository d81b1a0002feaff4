package carom.net.snapshot;

import carom.net.snapshot.frame.FrameRing;
import carom.net.snapshot.frame.FrameState;
import carom.net.snapshot.frame.SlotSet;
import java.util.Arrays;

/**
 * Selects the entities that one client is told about in a tick, and their order. It chooses among
 * the candidates of {@link ClientKnowledge} by priority; the encoder writes what it gives, run by
 * run and single by single, and reports what was written.
 *
 * <p>One thread, no allocation in the steady state.
 */
final class Selection {
  /** Classes of weight for sorting: eight to an octave, from 2^-8 to 2^24. */
  private static final int CLASSES = 256;

  private static final int CLASS_SHIFT = 20;
  private static final int LOWEST_CLASS = (127 - 8) << 3;

  /** Share of the budget that is promised to the heaviest entities. */
  private static final double SAFE_SHARE = 0.8;

  /** Share of the budget, at most, that is tried. */
  private static final double SPARE_SHARE = 1.4;

  /** Factor for an entity that the client can't predict from what it knows. */
  private static final float NEWS = 2;

  /**
   * Priority of an entity that is gone, more than most have: until that arrives, the client shows
   * what isn't there, and its record takes a few bits.
   */
  private static final float GONE = 8;

  /** Factor for an entity at rest: until that arrives, the client shows it moving on. */
  private static final float REST = 1.5f;

  private final FrameRing ring;
  private final Interest interest;
  private final RecordSizes sizes;
  private final ClientKnowledge client;

  /** The slots that go first. */
  private final SlotSet chosen = new SlotSet();

  /** The slots that go where room is left: sizes are known only when written. */
  private final SlotSet spare = new SlotSet();

  /** Priority that each slot has collected since it was sent. */
  private float[] weight = {};

  /** The slots that have collected any weight. */
  private final SlotSet weighty = new SlotSet();

  private int weighedTick = -1;
  private int[] order = {};
  private final int[] classCount = new int[CLASSES];
  private int waiting;
  private float leastChosen;

  private int cursor;
  private boolean onSpare;

  // The word at the cursor: its slots that are chosen and not given yet, by the frame that they are
  // coded against. Of the last such group, those that have as many poses make a run.
  private final FrameState[] groupHeld = new FrameState[FrameRing.SIZE];
  private final long[] groupSlots = new long[FrameRing.SIZE];
  private int groups;
  private int poses;
  private int stride;
  private long runSlots;
  private int baseline;

  /**
   * Creates the choice of a session's entities.
   *
   * @param ring the room's frames
   * @param interest what the client looks at
   * @param sizes estimates of records' sizes
   * @param client what the client knows
   */
  public Selection(FrameRing ring, Interest interest, RecordSizes sizes, ClientKnowledge client) {
    this.ring = ring;
    this.interest = interest;
    this.sizes = sizes;
    this.client = client;
  }

  private void ensure(int limit) {
    if (limit > weight.length) {
      weight = Arrays.copyOf(weight, limit);
      order = new int[limit];
      chosen.ensure(limit);
      spare.ensure(limit);
      weighty.ensure(limit);
    }
  }

  // ---- choosing

  /**
   * Chooses what goes into this tick's datagrams, after {@link ClientKnowledge#update}: everything,
   * or when that is more than fits, the entities that have collected most priority. What doesn't
   * fit goes on collecting.
   *
   * @param count how many candidates there are
   */
  public void choose(FrameState now, int count, int budgetBytes) {
    ensure(client.slotLimit());
    waiting = count;
    boolean waited = chosen.next(0) >= 0 || leastChosen > 0;
    chosen.set(client.candidates());
    spare.clear();
    leastChosen = 0;
    boolean fits = client.wantedBits() <= 8.0 * budgetBytes;
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
    SlotSet candidates = client.candidates();
    for (int slot = candidates.next(0); slot >= 0; slot = candidates.next(slot + 1)) {
      weight[slot] += ticks * priority(now, slot);
      weighty.add(slot);
    }
  }

  /** Returns what a slot collects per tick. */
  public float priority(FrameState now, int slot) {
    if (!now.alive(slot)) {
      return GONE;
    }
    if (!client.seesAlive(slot)) {
      return 1;
    }
    float priority = interest.priority(now, slot);
    if (client.isNew(now, slot)) {
      return priority * NEWS;
    }
    return now.still(slot) ? priority * REST : priority;
  }

  /** Chooses by a counting sort over classes of weight: linear. */
  private void chooseHeaviest(FrameState now, double bits) {
    SlotSet candidates = client.candidates();
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
      sum += client.expectedBits(now, order[i]);
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

  // ---- giving

  /** Returns whether anything chosen isn't written yet. */
  public boolean hasChosen() {
    return chosen.next(0) >= 0 || spare.next(0) >= 0;
  }

  /** Begins a datagram: gives all that isn't written yet again, the chosen slots first. */
  public void rewind() {
    onSpare = false;
    cursor = 0;
  }

  /** Goes on to the slots that are given if room is left. */
  public void toSpare() {
    onSpare = true;
    cursor = 0;
  }

  /** Goes on to runs, of the chosen slots or of the spare ones. */
  public void toRuns() {
    cursor = 0;
    groups = 0;
  }

  /**
   * Returns the next slot, ascending, that goes alone, as it has no frame to be coded against;
   * {@link SlotSet#NONE} at the end.
   */
  public int nextSingle(FrameState now) {
    SlotSet from = onSpare ? spare : chosen;
    for (int slot = from.next(cursor); slot >= 0; slot = from.next(slot + 1)) {
      int word = slot >> 6;
      long alone = from.word(word) & ~client.deltas(now, word) & -1L << slot;
      for (; alone != 0; alone &= alone - 1) {
        slot = (word << 6) + Long.numberOfTrailingZeros(alone);
        if (client.baseline(now, slot) != BaselineReason.ACKED) {
          cursor = slot + 1;
          return slot;
        }
      }
      slot = word << 6 | 63;
    }
    return SlotSet.NONE;
  }

  /**
   * Goes to the next run: some slots of a word that all have the {@link #baseline}.
   *
   * @return whether there is one
   */
  public boolean nextRun(FrameState now) {
    SlotSet from = onSpare ? spare : chosen;
    while (groups == 0) {
      int word = from.nextWord(cursor);
      if (word < 0) {
        return false;
      }
      cursor = word + 1;
      group(now, word, from.word(word));
      poses = 0;
    }
    int word = runWord();
    FrameState held = groupHeld[groups - 1];
    long slots = groupSlots[groups - 1];
    if (poses == 0) {
      poses = Baseline.MOST_POSES;
      stride = client.heldTicks().stride(now, held, word, slots);
    }
    do {
      runSlots =
          poses == 1 ? slots : client.heldTicks().sharing(now, held, word, slots, poses, stride);
      baseline = Baseline.of(now.tick() - held.tick(), poses, stride);
      poses--;
    } while (runSlots == 0);
    groupSlots[groups - 1] = slots ^ runSlots;
    if (slots == runSlots) {
      groups--;
      poses = 0;
    }
    return true;
  }

  /** Returns the run's word: its slots are some from 64 times that on. */
  public int runWord() {
    return cursor - 1;
  }

  /** Returns the run's slots: the lowest bit is the first of the word. */
  public long runSlots() {
    return runSlots;
  }

  /** Returns what the run is coded against. */
  public int baseline() {
    return baseline;
  }

  /** Sorts slots by the frame that they are coded against. */
  private void group(FrameState now, int word, long slots) {
    long rest = slots & client.deltas(now, word);
    for (long alone = slots ^ rest; alone != 0; alone &= alone - 1) {
      int slot = (word << 6) + Long.numberOfTrailingZeros(alone);
      if (client.baseline(now, slot) == BaselineReason.ACKED) {
        addToGroup(client.held(), 1L << slot);
      }
    }
    if (rest != 0) {
      int back = client.deltasBack(word);
      while ((ring.back(back - 1).changed().word(word) & rest) == 0) {
        back--; // they all rested
      }
      addToGroup(ring.back(back), rest);
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

  // ---- what was written

  /** Notes that a record of the slot was written that isn't part of a run. */
  public void wroteSingle(int slot, int tick, int bits) {
    if (client.seesAlive(slot)) {
      sizes.wroteAbsolute(bits);
    }
    wrote(slot >> 6, 1L << slot, tick);
  }

  /** Notes that some slots of a word were written as a run. */
  public void wroteRun(int word, long slots, int tick, int bits) {
    sizes.wroteRun(Long.bitCount(slots), bits);
    wrote(word, slots, tick);
  }

  private void wrote(int word, long slots, int tick) {
    client.wrote(word, slots, tick);
    for (long rest = slots & weighty.word(word); rest != 0; rest &= rest - 1) {
      weight[(word << 6) + Long.numberOfTrailingZeros(rest)] = 0;
    }
    weighty.removeWord(word, slots);
    (onSpare ? spare : chosen).removeWord(word, slots);
    waiting -= Long.bitCount(slots);
  }

  /** Returns how many entities there is something to say about that weren't written since. */
  public int waiting() {
    return waiting;
  }

  /** Returns the priority that a slot has collected since it was sent. */
  public float weight(int slot) {
    return slot < weight.length ? weight[slot] : 0;
  }

  /** Returns the least priority that anything chosen had collected; 0 when everything fitted. */
  public float leastChosen() {
    return leastChosen;
  }
}
