package carom.net.snapshot;

import carom.net.snapshot.frame.FrameRing;
import carom.net.snapshot.frame.FrameState;
import carom.net.snapshot.frame.SlotSet;
import carom.net.snapshot.frame.SlotTicks;
import carom.net.snapshot.ledger.DatagramLedger;
import java.util.Arrays;

/**
 * The server's knowledge of what one client knows. It tells which entities are in the client's
 * sight, which tick of each it has acked, and so which entities there is something to say about,
 * the candidates.
 *
 * <p>Work per tick is for entities that changed and are in sight, and for those that wait; entities
 * at rest cost nothing, and neither do entities out of sight. An entity that leaves the client's
 * view leaves its sight with the first change after that: as long as nothing changes, what the
 * client shows is the truth, and telling it to forget would cost more than letting it remember.
 *
 * <p>Most slots have many alike among their neighbours: acked at the same tick, changed since, in
 * sight. Such slots are looked at 64 at a time, a <em>word</em>: word w holds the slots from 64 w
 * on, the lowest bit first.
 *
 * <p>One thread, no allocation in the steady state.
 */
final class ClientKnowledge implements DatagramLedger.Section {
  private static final int MIN_LENGTH = 64;
  private static final int UNKNOWN = -1;

  private final FrameRing ring;
  private final DatagramLedger ledger;
  private final Interest interest;
  private final RecordSizes sizes;
  private final SlotSet inSight = new SlotSet();

  /** The slots of which the client may show something. */
  private final SlotSet mayShow = new SlotSet();

  private final SlotSet candidates = new SlotSet();
  private final SlotSet forced = new SlotSet();
  private final SlotTicks acked = new SlotTicks();
  private final SlotTicks lastSent = new SlotTicks();

  /** Ticks before those in {@link #acked} that the client holds, too. */
  private final HeldTicks heldTicks;

  /** Tick at which the slot came into sight or left it: acks of older records mean nothing. */
  private int[] sightTick = {};

  /** The newest of {@link #sightTick}, by word. */
  private int[] newestSightTick = {};

  private int seenTick = -1;
  private boolean sawEverything;

  // The answer of update(), and whether it is out of date though the tick is the same.
  private int count;
  private double wantedBits;
  private boolean touched;

  // The last tick that backTo() was asked for, and its answer.
  private int askedTick = UNKNOWN;
  private int askedNow = UNKNOWN;
  private int askedBack;

  /** The frame of the last {@link #baseline} that was {@link BaselineReason#ACKED}, else null. */
  private FrameState held;

  /**
   * Creates the knowledge of a client that knows nothing yet.
   *
   * @param ring the room's frames
   * @param ledger of the datagrams that records are written into
   * @param interest what the client looks at
   * @param sizes estimates of records' sizes
   * @param bestStride stride of baselines to try first, ticks
   */
  public ClientKnowledge(
      FrameRing ring, DatagramLedger ledger, Interest interest, RecordSizes sizes, int bestStride) {
    this.ring = ring;
    this.ledger = ledger;
    this.interest = interest;
    this.sizes = sizes;
    heldTicks = new HeldTicks(ring, acked, bestStride);
    learnLevel();
  }

  /** Takes the level as acked: the client shows its entities where the level places them. */
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
        mayShow.add(slot);
      }
    }
    SlotSet same = ring.asLevel();
    for (int word = same.nextWord(0); word >= 0; word = same.nextWord(word + 1)) {
      acked.raise(word, same.word(word), tick);
      heldTicks.add(word, same.word(word), tick);
    }
  }

  private void ensure(int limit) {
    if (limit <= sightTick.length) {
      return;
    }
    int grown = Math.max(MIN_LENGTH, Math.max(limit, 2 * sightTick.length)) + 63 & -64;
    acked.ensure(grown);
    lastSent.ensure(grown);
    heldTicks.ensure(grown);
    sightTick = Arrays.copyOf(sightTick, grown);
    newestSightTick = Arrays.copyOf(newestSightTick, grown >> 6);
    inSight.ensure(grown);
    mayShow.ensure(grown);
    candidates.ensure(grown);
    forced.ensure(grown);
  }

  /** Returns the limit of the slots that there is room for; a multiple of 64. */
  int slotLimit() {
    return sightTick.length;
  }

  // ---- what was sent, and what has arrived

  @Override
  public void acknowledged(int tick, int word, long slots) {
    long meant = slots;
    if (tick < newestSightTick[word]) {
      for (long rest = slots; rest != 0; rest &= rest - 1) {
        int slot = (word << 6) + Long.numberOfTrailingZeros(rest);
        meant ^= tick < sightTick[slot] ? Long.lowestOneBit(rest) : 0;
      }
    }
    long seen = meant & inSight.word(word);
    mayShow.removeWord(word, meant ^ seen);
    if (seen != 0) {
      long held = seen | steady(word, acked.layer(word), tick);
      acked.raise(word, held, tick);
      heldTicks.add(word, held, tick);
    }
    touched = true;
  }

  /**
   * Returns those slots of a layer that have not changed up to a tick, so that they need not have
   * been sent. What the client holds of them is true of that tick and those before, too, and they
   * stay with the others.
   */
  private long steady(int word, long slots, int tick) {
    if (slots == 0 || acked.layerTick(word) >= tick) {
      return 0;
    }
    int to = ring.backTo(tick);
    int from = to < 0 ? -1 : ring.backTo(acked.layerTick(word));
    long rest = from < 0 ? 0 : slots & inSight.word(word);
    for (int back = from - 1; back >= to && rest != 0; back--) {
      FrameState frame = ring.back(back);
      rest &= ~frame.changed().word(word);
      heldTicks.add(word, rest, frame.tick());
    }
    return rest;
  }

  /** Notes that the datagram begun last holds records of some slots of a word at a tick. */
  void wrote(int word, long slots, int tick) {
    ledger.append(this, word, slots);
    mayShow.addWord(word, slots);
    lastSent.raise(word, slots, tick);
    forced.removeWord(word, slots);
    touched = true;
  }

  /** Makes the slot's next record absolute, even if the client acknowledged an earlier one. */
  public void force(int slot) {
    ensure(slot + 1);
    forced.add(slot);
    candidates.add(slot);
    touched = true;
  }

  /** Considers a slot that may have come into view. */
  public void notice(int slot) {
    ensure(slot + 1);
    if (!inSight.has(slot)) {
      candidates.add(slot);
      touched = true;
    }
  }

  /** Returns whether a slot is in the client's sight. */
  public boolean isInSight(int slot) {
    return inSight.has(slot);
  }

  /** Returns those of 64 neighbouring slots, from 64 {@code word} on, that are in sight. */
  public long inSight(int word) {
    return inSight.word(word);
  }

  /** Returns whether the client sees a living entity in the slot. */
  boolean seesAlive(int slot) {
    return inSight.has(slot) && ring.newest().alive(slot);
  }

  /** Returns whether the slot's next record can't build on what the client knows. */
  boolean isNew(FrameState now, int slot) {
    return acked.get(slot) < 0 || baseline(now, slot) != BaselineReason.ACKED;
  }

  /** Returns the newest tick of the slot that the client has acked, or -1. */
  public int ackedTick(int slot) {
    return acked.get(slot);
  }

  /** Returns the last tick at which a record of the slot was sent, or -1. */
  public int sentTick(int slot) {
    return lastSent.get(slot);
  }

  // ---- what there is to say

  /**
   * Looks at everything that changed since the last call.
   *
   * @return how many entities there is something to say about
   */
  public int update(FrameState now) {
    collect(now);
    touched = false;
    count = 0;
    wantedBits = 0;
    for (int word = candidates.nextWord(0); word >= 0; word = candidates.nextWord(word + 1)) {
      for (long rest = update(now, word); rest != 0; rest &= rest - 1) {
        int slot = (word << 6) + Long.numberOfTrailingZeros(rest);
        if (isNews(now, slot)) {
          count++;
          wantedBits += expectedBits(now, slot);
        }
      }
    }
    return count;
  }

  /** Updates as {@link #update}, unless its last answer still holds. */
  public int updated(FrameState now) {
    return touched || seenTick != now.tick() ? update(now) : count;
  }

  /** Returns the slots there is something to say about, after {@link #update}. */
  SlotSet candidates() {
    return candidates;
  }

  /** Returns the bits that records of all candidates would take, after {@link #update}. */
  double wantedBits() {
    return wantedBits;
  }

  /** Returns the bits that the slot's next record will take, about. */
  float expectedBits(FrameState now, int slot) {
    if (!inSight.has(slot) || !now.alive(slot)) {
      return sizes.farewellBits();
    }
    return acked.get(slot) < 0 ? sizes.absoluteBits() : sizes.deltaBits();
  }

  /** Updates the common slots of a word; returns those that must be looked at one by one. */
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
    wantedBits += news * sizes.deltaBits();
    return all & ~known | changed & ~seen;
  }

  /**
   * Returns the common slots of a word: alive, in sight, and acked at the tick of the word's layer,
   * of which the ring has the frame.
   */
  private long known(FrameState now, int word) {
    long layer = acked.layer(word);
    if (layer == 0 || backTo(acked.layerTick(word)) < 0) {
      return 0;
    }
    return layer & inSight.word(word) & now.living().word(word) & ~forced.word(word);
  }

  /** Asks {@link FrameRing#backTo}; mostly for the tick that was asked for before. */
  private int backTo(int tick) {
    int now = ring.newest().tick();
    if (tick != askedTick || now != askedNow) {
      askedTick = tick;
      askedNow = now;
      askedBack = ring.backTo(tick);
    }
    return askedBack;
  }

  /** Drops a candidate there is nothing to say about; returns whether there is something. */
  private boolean isNews(FrameState now, int slot) {
    updateSight(now, slot);
    if (!isSettled(now, slot)) {
      return true;
    }
    candidates.remove(slot);
    if (!now.alive(slot)) {
      inSight.remove(slot);
      mayShow.remove(slot);
    }
    return false;
  }

  /** Adds what changed since the last frame seen to the candidates. */
  private void collect(FrameState now) {
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

  /** Lets an entity into sight, or out of it. A dead one stays until the client was told. */
  private void updateSight(FrameState now, int slot) {
    if (!now.alive(slot)) {
      return;
    }
    boolean known = inSight.has(slot);
    if (known && isSettled(now, slot)) {
      return; // what the client shows is true, wherever it looks
    }
    if (interest.sees(now, slot, known) != known) {
      sightTick[slot] = now.tick();
      newestSightTick[slot >> 6] = now.tick();
      acked.set(slot, UNKNOWN);
      heldTicks.forget(slot);
      if (known) {
        inSight.remove(slot);
      } else {
        inSight.add(slot);
      }
    }
  }

  /** Returns whether there is nothing to say about a slot. */
  private boolean isSettled(FrameState now, int slot) {
    if (!inSight.has(slot)) {
      return !mayShow.has(slot);
    }
    if (!now.alive(slot) && !mayShow.has(slot)) {
      return true;
    }
    boolean force = forced.has(slot) && now.alive(slot);
    return acked.get(slot) >= ring.changedTick(slot) && !force;
  }

  // ---- what it is coded against

  /**
   * Decides what a slot's record is coded against: the one place that does. For {@link
   * BaselineReason#ACKED} the frame is left in {@link #held}: that of the acked tick, or if it has
   * left the ring, the newest one in which the slot still is as it was then.
   */
  public BaselineReason baseline(FrameState now, int slot) {
    held = null;
    if (slot >= sightTick.length || isSettled(now, slot)) {
      return BaselineReason.QUIESCENT;
    }
    if (!inSight.has(slot)) {
      return BaselineReason.OUT_OF_SIGHT;
    }
    if (!now.alive(slot)) {
      return BaselineReason.GONE;
    }
    if (forced.has(slot)) {
      return BaselineReason.FORCED;
    }
    int ackedTick = acked.get(slot);
    return ackedTick < 0 ? BaselineReason.NEW : against(now, slot, ackedTick);
  }

  private BaselineReason against(FrameState now, int slot, int ackedTick) {
    FrameState holding = ring.at(ackedTick);
    holding = holding == null ? ring.lastLike(slot, ackedTick) : holding;
    if (holding == null) {
      return now.tick() - ackedTick < FrameRing.SIZE
          ? BaselineReason.ROLLED_OUT
          : BaselineReason.TOO_OLD;
    }
    if (now.tick() - holding.tick() >= FrameRing.SIZE) {
      return BaselineReason.TOO_OLD;
    }
    if (!now.sameIdentity(holding, slot)) {
      return BaselineReason.IDENTITY;
    }
    held = holding;
    return BaselineReason.ACKED;
  }

  /** Returns the frame of the last {@link BaselineReason#ACKED}, else null. */
  FrameState held() {
    return held;
  }

  /**
   * Returns slots of a word that are certainly coded against a frame, found 64 at a time; {@link
   * #baseline} decides about the others.
   */
  long deltas(FrameState now, int word) {
    long known = known(now, word);
    if (known == 0 || now.tick() - acked.layerTick(word) >= FrameRing.SIZE) {
      return 0;
    }
    return known & ~ring.changes().renamedSince(backTo(acked.layerTick(word)), word);
  }

  /** Returns what the client holds of earlier ticks. */
  HeldTicks heldTicks() {
    return heldTicks;
  }

  /** Returns how many frames ago the {@link #deltas} of a word were acked. */
  int deltasBack(int word) {
    return backTo(acked.layerTick(word));
  }
}
