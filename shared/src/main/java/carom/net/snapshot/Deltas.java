package carom.net.snapshot;

import carom.net.codec.RangeEncoder;
import carom.net.codec.SliceList;
import carom.net.codec.Surprise;
import java.util.Arrays;

/**
 * The deltas of a room's newest frame, each worked out once for all sessions: how a body differs
 * from what is predicted out of an older frame, as slices for {@link RangeEncoder#slices}. Most
 * sessions have acked one of a few ticks, so what one of them needs is mostly there already. Where
 * room for all of them ends, the rest is worked out each time.
 *
 * <p>One thread, no allocation in the steady state. Memory: 256 bytes per slot and up to 4 MiB.
 */
final class Deltas {

  private static final int MIN_SLOTS = 64;

  /** Slices kept. */
  private static final int MAX_SLICES = 1 << 17;

  /** So many neighbouring slots have one profile: what is alike was mostly made together. */
  private static final int BLOCK_BITS = 5;

  /** On every so many-th slot that changed each profile is tried, to find the one that fits. */
  private static final int SAMPLED = 8;

  /** Share of what was before in what is known of a block's profiles: 1 - 2^-{@value}. */
  private static final int FORGET_SHIFT = 3;

  // A delta as a number: one more than its first slice, and how many there are.
  private static final int COUNT_BITS = 8;
  private static final int COUNT = (1 << COUNT_BITS) - 1;

  private final int tickRate;
  private final Predictor predictor;
  private final DeltaCodec codec;
  private final SliceList slices = new SliceList();
  private final Surprise surprise = new Surprise();
  private final Motion old = new Motion();
  private final Motion actual = new Motion();
  private final Motion residual = new Motion();

  /** By age and slot: the delta as a number, 0 when it isn't there. */
  private int[] known = {};

  private int slots;
  private long agesKnown;
  private int kept;
  private int tick = -1;

  /** By block and profile: what the bits of its deltas would lately have cost. */
  private long[] costs = {};

  /** By block: the cheapest. */
  private byte[] profiles = {};

  Deltas(int tickRate, float gravityX, float gravityY) {
    this.tickRate = tickRate;
    predictor = new Predictor(tickRate);
    predictor.gravity(gravityX, gravityY);
    codec = new DeltaCodec(tickRate);
  }

  int tickRate() {
    return tickRate;
  }

  /** The profile that the slot's deltas of the newest frame are coded with. */
  int profile(int slot) {
    return profiles[slot >> BLOCK_BITS];
  }

  /**
   * The delta of a slot between two frames.
   *
   * @param now the ring's newest frame
   * @param held an older one that holds the slot
   * @return for {@link #write}, until the next call
   */
  int of(FrameState now, FrameState held, int slot) {
    if (now.tick() != tick) {
      begin(now, held);
    }
    int age = now.tick() - held.tick();
    int at = age * slots + slot;
    int delta = known[at];
    return delta != 0 ? delta : add(at, age, now, held, slot);
  }

  private void begin(FrameState now, FrameState held) {
    tick = now.tick();
    slices.clear();
    kept = 0;
    if (now.slotLimit() > slots) {
      slots = Math.max(MIN_SLOTS, Math.max(now.slotLimit(), 2 * slots));
      known = new int[FrameRing.SIZE * slots];
      int blocks = (slots >> BLOCK_BITS) + 1;
      profiles = Arrays.copyOf(profiles, blocks);
      costs = Arrays.copyOf(costs, blocks * Profiles.COUNT);
    } else {
      for (long ages = agesKnown; ages != 0; ages &= ages - 1) {
        int from = Long.numberOfTrailingZeros(ages) * slots;
        Arrays.fill(known, from, from + slots, 0);
      }
    }
    agesKnown = 0;
    tryProfiles(now, held);
  }

  private void tryProfiles(FrameState now, FrameState held) {
    SlotSet changed = now.changed();
    int last = -1;
    for (int slot = changed.next(tick % SAMPLED); slot >= 0; slot = changed.next(slot + SAMPLED)) {
      if (!now.sameIdentity(held, slot)) {
        continue;
      }
      int block = slot >> BLOCK_BITS;
      int age = now.tick() - held.tick();
      int way = work(age, now, held, slot);
      int best = 0;
      for (int i = 0; i < Profiles.COUNT; i++) {
        int at = block * Profiles.COUNT + i;
        if (block != last) {
          costs[at] -= costs[at] >> FORGET_SHIFT;
        }
        surprise.reset();
        codec.profile(Profiles.table(i));
        codec.code(surprise, age, old, way, residual);
        costs[at] += surprise.sum();
        best = costs[at] < costs[block * Profiles.COUNT + best] ? i : best;
      }
      profiles[block] = (byte) best;
      last = block;
    }
  }

  private int work(int age, FrameState now, FrameState held, int slot) {
    held.motion(slot, old);
    now.motion(slot, actual);
    int way = predictor.way(old, actual, age);
    residual.setResidual(predictor, old, actual, way, age);
    return way;
  }

  private int add(int at, int age, FrameState now, FrameState held, int slot) {
    slices.shorten(kept);
    codec.profile(Profiles.table(profile(slot)));
    int way = work(age, now, held, slot);
    codec.code(slices, age, old, way, residual);
    slices.cut();
    int delta = kept + 1 << COUNT_BITS | slices.size() - kept;
    if (slices.size() <= MAX_SLICES) {
      kept = slices.size();
      known[at] = delta;
      agesKnown |= 1L << age;
    }
    return delta;
  }

  /** Writes a delta's content. */
  void write(RangeEncoder range, int delta) {
    int from = (delta >>> COUNT_BITS) - 1;
    range.cut();
    range.slices(slices, from, from + (delta & COUNT));
  }
}
