package carom.net.snapshot;

import carom.net.codec.BitCoder;
import carom.net.codec.BitCost;
import carom.net.codec.RangeEncoder;
import carom.net.codec.SliceList;
import carom.net.snapshot.frame.FrameRing;
import carom.net.snapshot.frame.FrameState;
import carom.net.snapshot.frame.QuantizedPose;
import carom.net.snapshot.frame.SlotSet;
import java.util.Arrays;

/**
 * Keeps the deltas of a room's newest frame, each worked out once for all sessions: how a body
 * differs from what is predicted out of older frames, as slices for {@link RangeEncoder#slices}.
 * Most sessions have acked one of a few ticks, and what changed since then is the same for all that
 * see it and know the same poses before: so whole runs of deltas are there already, too. Where room
 * for all of them ends, the rest is worked out each time.
 *
 * <p>One thread, no allocation in the steady state. Memory: 160 bytes per slot and up to 8 MiB.
 */
public final class Deltas {

  private static final int MIN_SLOTS = 64;

  /** Binary logarithm of the neighbouring slots that share a profile: mostly made together. */
  private static final int BLOCK_BITS = 5;

  /** Number of slices kept, about. */
  private static final int MAX_SLICES = 1 << 17;

  /** Distance of the changed slots on which all profiles are tried, to find the best. */
  private static final int SAMPLED = 8;

  /** Least saving for which a block takes another profile than the one before, 1/256 bit. */
  private static final int OTHER_PROFILE = 6 * 256;

  /** Share of what was before in what is known of a block's profiles: 1 - 2^-{@value}. */
  private static final int FORGET_SHIFT = 3;

  /** Number of words that are looked at to see how dense changes are. */
  private static final int WORDS_SEEN = 32;

  /** Number of baselines whose deltas are kept; those of further ones are worked out each time. */
  private static final int BASELINES = 32;

  /** Number of parts of runs kept for each baseline. */
  private static final int PARTS = 8;

  private static final int UNKNOWN = -1;

  // A delta as a number: one more than its first slice, and how many there are.
  private static final int COUNT_BITS = 8;
  private static final int COUNT = (1 << COUNT_BITS) - 1;

  private final FrameRing ring;
  private final Predictor predictor;
  private final int bestStride;
  private final DeltaCodec codec;
  private final SliceList slices = new SliceList();
  private final SliceList runs = new SliceList();
  private final BitCost surprise = new BitCost();
  private final Track track = new Track();
  private final QuantizedPose predicted = new QuantizedPose();
  private final QuantizedPose actual = new QuantizedPose();
  private final QuantizedPose residual = new QuantizedPose();

  /** Number of ticks for which the body of the {@link #track} went on resting. */
  private int rested;

  /** The baselines that were asked for in this tick: each has a row. */
  private final int[] baselines = new int[BASELINES];

  private int rows;

  /** By row and slot: the delta as a number, 0 when it isn't there. */
  private int[] known = {};

  // The runs that are there, by row and place: which slots, its first slice, the one behind its
  // last, its density. The first place of a word is its own; the others are for parts of runs, as
  // where a datagram ends, and are shared.
  private long[] runSlots = {};
  private char[] runWord = {};
  private int[] runFrom = {};
  private int[] runTo = {};
  private byte[] runDensity = {};

  /** By row: where the next part goes. */
  private final int[] nextPart = new int[BASELINES];

  /** By age: the density that most runs have. */
  private final int[] usual = new int[FrameRing.SIZE];

  private int slots;
  private int places;
  private int kept;
  private int tick = -1;

  /** By block and profile: what the bits of its deltas would lately have cost. */
  private long[] costs = {};

  /** By block: the cheapest. */
  private byte[] profiles = {};

  /**
   * Creates the deltas of a room.
   *
   * @param ring the room's frames; its gravity must be set before
   * @param tickRate ticks per second, for prediction; the clients' decoders must be given the same
   */
  public Deltas(FrameRing ring, int tickRate) {
    this.ring = ring;
    predictor = new Predictor(tickRate);
    predictor.gravity(ring.gravityX(), ring.gravityY());
    codec = new DeltaCodec();
    bestStride = Baseline.bestStride(tickRate);
  }

  /** Returns the stride to try first for baselines of several poses, ticks. */
  public int bestStride() {
    return bestStride;
  }

  /** Returns the frames that the deltas are of. */
  public FrameRing ring() {
    return ring;
  }

  /** Returns the profile that the slot's deltas of the newest frame are coded with. */
  int profile(int slot) {
    return profiles[slot >> BLOCK_BITS];
  }

  /**
   * Returns the delta of a slot.
   *
   * @param now the ring's newest frame
   * @param baseline a {@link Baseline} whose frames the ring has, and which hold the slot
   * @return until the next call
   */
  int of(FrameState now, int baseline, int slot) {
    int row = row(now, baseline);
    if (row < 0) {
      return add(-1, now, baseline, slot);
    }
    int at = row * slots + slot;
    int delta = known[at];
    return delta != 0 ? delta : add(at, now, baseline, slot);
  }

  /** Returns the row of a baseline, or a negative number when there is none left. */
  private int row(FrameState now, int baseline) {
    if (now.tick() != tick) {
      begin(now, baseline);
    }
    for (int row = 0; row < rows; row++) {
      if (baselines[row] == baseline) {
        return row;
      }
    }
    if (rows == BASELINES) {
      return UNKNOWN;
    }
    Arrays.fill(known, rows * slots, (rows + 1) * slots, 0);
    Arrays.fill(runSlots, rows * places, (rows + 1) * places, 0);
    baselines[rows] = baseline;
    return rows++;
  }

  private void begin(FrameState now, int baseline) {
    tick = now.tick();
    slices.clear();
    runs.clear();
    kept = 0;
    rows = 0;
    if (now.slotLimit() > slots) {
      slots = Math.max(MIN_SLOTS, Math.max(now.slotLimit(), 2 * slots) + 63 & -64);
      int words = slots >> 6;
      known = new int[BASELINES * slots];
      places = words + PARTS;
      runSlots = new long[BASELINES * places];
      runWord = new char[BASELINES * places];
      runFrom = new int[BASELINES * places];
      runTo = new int[BASELINES * places];
      runDensity = new byte[BASELINES * places];
      profiles = Arrays.copyOf(profiles, slots >> BLOCK_BITS);
      costs = Arrays.copyOf(costs, (slots >> BLOCK_BITS) * Profiles.COUNT);
    }
    Arrays.fill(usual, UNKNOWN);
    int stride = Baseline.poses(baseline) > 1 ? Baseline.stride(baseline) : bestStride;
    int three = Baseline.of(Baseline.age(baseline), Baseline.MOST_POSES, stride);
    tryProfiles(now, frame(now, three, Baseline.MOST_POSES - 1) == null ? baseline : three);
  }

  private void tryProfiles(FrameState now, int baseline) {
    SlotSet changed = now.changed();
    int last = -1;
    int usualProfile = 0;
    for (int slot = changed.next(tick % SAMPLED); slot >= 0; slot = changed.next(slot + SAMPLED)) {
      if (!isSame(now, baseline, slot)) {
        continue;
      }
      int block = slot >> BLOCK_BITS;
      int best = 0;
      study(now, baseline, slot);
      for (int i = 0; i < Profiles.COUNT; i++) {
        int at = block * Profiles.COUNT + i;
        if (block != last) {
          costs[at] -= costs[at] >> FORGET_SHIFT;
        }
        surprise.reset();
        code(surprise, i);
        costs[at] += surprise.sum();
        best = costs[at] < costs[block * Profiles.COUNT + best] ? i : best;
      }
      boolean worth =
          costs[block * Profiles.COUNT + usualProfile] - costs[block * Profiles.COUNT + best]
              > OTHER_PROFILE;
      usualProfile = worth ? best : usualProfile;
      profiles[block] = (byte) usualProfile;
      last = block;
    }
  }

  /** Returns whether all frames of a baseline hold the same entity in a slot as the newest one. */
  private boolean isSame(FrameState now, int baseline, int slot) {
    for (int i = 0; i < Baseline.poses(baseline); i++) {
      FrameState held = frame(now, baseline, i);
      if (held == null || !now.sameIdentity(held, slot)) {
        return false;
      }
    }
    return true;
  }

  private FrameState frame(FrameState now, int baseline, int pose) {
    return ring.at(now.tick() - Baseline.age(baseline) - pose * Baseline.stride(baseline));
  }

  private void study(FrameState now, int baseline, int slot) {
    for (int i = 0; i < Baseline.poses(baseline); i++) {
      frame(now, baseline, i).pose(slot, track.pose(i));
    }
    rested = track.newest.still ? rested(now, Baseline.age(baseline), slot) : 0;
    predictor.study(track, baseline);
    now.pose(slot, actual);
  }

  /** Returns for how many ticks a slot stayed as it was in the frame of a baseline. */
  private int rested(FrameState now, int age, int slot) {
    int back = ring.backTo(now.tick() - age) - 1;
    while (back > 0 && !ring.back(back).changed().has(slot)) {
      back--;
    }
    return ring.back(back + 1).tick() - now.tick() + age;
  }

  private void code(BitCoder c, int profile) {
    predictor.predict(track, profile, predicted);
    residual.setResidual(predicted, actual);
    codec.profile(profile);
    codec.code(c, track, residual, rested);
  }

  /**
   * Works a delta out.
   *
   * @param at where to keep it, or a negative number for nowhere
   */
  private int add(int at, FrameState now, int baseline, int slot) {
    slices.shorten(kept);
    study(now, baseline, slot);
    code(slices, profile(slot));
    slices.cut();
    int delta = kept + 1 << COUNT_BITS | slices.size() - kept;
    if (at >= 0 && slices.size() <= MAX_SLICES) {
      kept = slices.size();
      known[at] = delta;
    }
    return delta;
  }

  /** Writes a delta's content. */
  void write(RangeEncoder range, int delta) {
    int from = (delta >>> COUNT_BITS) - 1;
    range.cut();
    range.slices(slices, from, from + (delta & COUNT));
  }

  // ---- runs

  /** Writes some of 64 neighbouring slots as one run: what it is, which slots, their deltas. */
  public void writeRun(
      RangeEncoder range, RecordCodec records, FrameState now, int baseline, int word, long which) {
    int row = row(now, baseline);
    int at = row < 0 ? UNKNOWN : placeOf(row, word, which);
    if (at < 0 && row >= 0) {
      at = addRun(row, now, word, which);
    }
    int low = profile(word << 6);
    int high = profile((word << 6) + 32);
    records.kind(range, RecordCodec.RUN);
    if (at >= 0) {
      records.run(range, word, baseline, low, high, runDensity[at]);
      range.cut();
      range.slices(runs, runFrom[at], runTo[at]);
      return;
    }
    int density = SlotCodec.density(which, usual(now, Baseline.age(baseline)));
    records.run(range, word, baseline, low, high, density);
    range.cut();
    SlotCodec.code(range, density, which);
    for (long rest = which; rest != 0; rest &= rest - 1) {
      write(range, of(now, baseline, (word << 6) + Long.numberOfTrailingZeros(rest)));
    }
  }

  /** Returns where a run is, or a negative number. */
  private int placeOf(int row, int word, long which) {
    int first = row * places;
    if (runSlots[first + word] == which) {
      return first + word;
    }
    int end = first + places;
    for (int at = end - PARTS; at < end; at++) {
      if (runSlots[at] == which && runWord[at] == word) {
        return at;
      }
    }
    return UNKNOWN;
  }

  /** Works a run out and returns where it is; negative when there is no room for it. */
  private int addRun(int row, FrameState now, int word, long which) {
    int baseline = baselines[row];
    if (runs.size() > MAX_SLICES) {
      return UNKNOWN;
    }
    int at = row * places + word;
    if (runSlots[at] != 0) {
      at = (row + 1) * places - 1 - nextPart[row];
      nextPart[row] = (nextPart[row] + 1) % PARTS;
    }
    int density = SlotCodec.density(which, usual(now, Baseline.age(baseline)));
    runFrom[at] = runs.size();
    SlotCodec.code(runs, density, which);
    runs.cut();
    for (long rest = which; rest != 0; rest &= rest - 1) {
      int delta = of(now, baseline, (word << 6) + Long.numberOfTrailingZeros(rest));
      int from = (delta >>> COUNT_BITS) - 1;
      runs.addAll(slices, from, from + (delta & COUNT));
    }
    runTo[at] = runs.size();
    runSlots[at] = which;
    runWord[at] = (char) word;
    runDensity[at] = (byte) density;
    return at;
  }

  /** Returns the density that fits most runs of an age. */
  private int usual(FrameState now, int age) {
    if (usual[age] == UNKNOWN) {
      int back = ring.backTo(now.tick() - age);
      int limit = now.slotLimit() + 63 >> 6;
      int best = 0;
      long least = Long.MAX_VALUE;
      for (int density = 0; density < SlotCodec.DENSITIES; density++) {
        long cost = 0;
        for (int word = 0; word < limit; word += 1 + limit / WORDS_SEEN) {
          long changed = ring.changes().since(back, word);
          cost += changed == 0 ? 0 : SlotCodec.cost(density, changed);
        }
        if (cost < least) {
          least = cost;
          best = density;
        }
      }
      usual[age] = best;
    }
    return usual[age];
  }

  /**
   * Returns those of a run's slots, in their order, whose deltas together fit into a number of
   * bits. Long deltas are passed over for shorter ones.
   */
  public long fitting(FrameState now, int baseline, int word, long which, int bits) {
    double left = bits;
    long result = 0;
    for (long rest = which; rest != 0; rest &= rest - 1) {
      int delta = of(now, baseline, (word << 6) + Long.numberOfTrailingZeros(rest));
      int from = (delta >>> COUNT_BITS) - 1;
      double cost = slices.bits(from, from + (delta & COUNT));
      if (cost <= left) {
        left -= cost;
        result |= Long.lowestOneBit(rest);
      }
    }
    return result;
  }
}
