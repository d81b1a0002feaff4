package carom.net.snapshot.record;

import carom.net.codec.RangeEncoder;
import carom.net.codec.SliceList;
import carom.net.codec.Surprise;
import carom.net.snapshot.frame.FrameRing;
import carom.net.snapshot.frame.FrameState;
import carom.net.snapshot.frame.Motion;
import carom.net.snapshot.frame.Predictor;
import carom.net.snapshot.frame.SlotSet;
import java.util.Arrays;

/**
 * Keeps the deltas of a room's newest frame, each worked out once for all sessions: how a body
 * differs from what is predicted out of an older frame, as slices for {@link RangeEncoder#slices}.
 * Most sessions have acked one of a few ticks, and what changed since then is the same for all that
 * see it: so whole runs of deltas are there already, too. Where room for all of them ends, the rest
 * is worked out each time.
 *
 * <p>One thread, no allocation in the steady state. Memory: 280 bytes per slot and up to 8 MiB.
 */
public final class Deltas {

  private static final int MIN_SLOTS = 64;

  /** Binary logarithm of the neighbouring slots that share a profile: mostly made together. */
  private static final int BLOCK_BITS = 5;

  /** Number of slices kept, about. */
  private static final int MAX_SLICES = 1 << 17;

  /** Distance of the changed slots on which all profiles are tried, to find the best. */
  private static final int SAMPLED = 8;

  /** Share of what was before in what is known of a block's profiles: 1 - 2^-{@value}. */
  private static final int FORGET_SHIFT = 3;

  /** Number of words that are looked at to see how dense changes are. */
  private static final int WORDS_SEEN = 32;

  /** Number of parts of runs kept for each age. */
  private static final int PARTS = 8;

  private static final int UNKNOWN = -1;

  // A delta as a number: one more than its first slice, and how many there are.
  private static final int COUNT_BITS = 8;
  private static final int COUNT = (1 << COUNT_BITS) - 1;

  private final FrameRing ring;
  private final Predictor predictor;
  private final DeltaCodec codec;
  private final SliceList slices = new SliceList();
  private final SliceList runs = new SliceList();
  private final Surprise surprise = new Surprise();
  private final Motion old = new Motion();
  private final Motion actual = new Motion();
  private final Motion residual = new Motion();

  /** By age and slot: the delta as a number, 0 when it isn't there. */
  private int[] known = {};

  // The runs that are there, by age and place: which slots, its first slice, the one behind its
  // last, its density. The first place of a word is its own; the others are for parts of runs, as
  // where a datagram ends, and are shared.
  private long[] runSlots = {};
  private char[] runWord = {};
  private int[] runFrom = {};
  private int[] runTo = {};
  private byte[] runDensity = {};

  /** By age: where the next part goes. */
  private final int[] nextPart = new int[FrameRing.SIZE];

  /** By age: the density that most runs have. */
  private final int[] usual = new int[FrameRing.SIZE];

  private int slots;
  private int places;
  private long agesKnown;
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
    codec = new DeltaCodec(tickRate);
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
   * Returns the delta of a slot between two frames.
   *
   * @param now the ring's newest frame
   * @param held an older one that holds the slot
   * @return until the next call
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
    runs.clear();
    kept = 0;
    if (now.slotLimit() > slots) {
      slots = Math.max(MIN_SLOTS, Math.max(now.slotLimit(), 2 * slots) + 63 & -64);
      int words = slots >> 6;
      known = new int[FrameRing.SIZE * slots];
      places = words + PARTS;
      runSlots = new long[FrameRing.SIZE * places];
      runWord = new char[FrameRing.SIZE * places];
      runFrom = new int[FrameRing.SIZE * places];
      runTo = new int[FrameRing.SIZE * places];
      runDensity = new byte[FrameRing.SIZE * places];
      profiles = Arrays.copyOf(profiles, slots >> BLOCK_BITS);
      costs = Arrays.copyOf(costs, (slots >> BLOCK_BITS) * Profiles.COUNT);
    } else {
      for (long ages = agesKnown; ages != 0; ages &= ages - 1) {
        int age = Long.numberOfTrailingZeros(ages);
        Arrays.fill(known, age * slots, (age + 1) * slots, 0);
        Arrays.fill(runSlots, age * places, (age + 1) * places, 0);
      }
    }
    agesKnown = 0;
    Arrays.fill(usual, UNKNOWN);
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
        codec.profile(i);
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
    codec.profile(profile(slot));
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

  // ---- runs

  /** Writes some of 64 neighbouring slots as one run: what it is, which slots, their deltas. */
  public void writeRun(
      RangeEncoder range,
      RecordCodec records,
      FrameState now,
      FrameState held,
      int word,
      long which) {
    if (now.tick() != tick) {
      begin(now, held);
    }
    int age = now.tick() - held.tick();
    int at = placeOf(age, word, which);
    if (at < 0) {
      at = addRun(age, now, held, word, which);
    }
    int low = profile(word << 6);
    int high = profile((word << 6) + 32);
    records.kind(range, RecordCodec.RUN);
    if (at >= 0) {
      records.run(range, word, age, low, high, runDensity[at]);
      range.cut();
      range.slices(runs, runFrom[at], runTo[at]);
      return;
    }
    int density = SlotCodec.density(which, usual(now, age));
    records.run(range, word, age, low, high, density);
    range.cut();
    SlotCodec.code(range, density, which);
    for (long rest = which; rest != 0; rest &= rest - 1) {
      write(range, of(now, held, (word << 6) + Long.numberOfTrailingZeros(rest)));
    }
  }

  /** Returns where a run is, or a negative number. */
  private int placeOf(int age, int word, long which) {
    int first = age * places;
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
  private int addRun(int age, FrameState now, FrameState held, int word, long which) {
    if (runs.size() > MAX_SLICES) {
      return UNKNOWN;
    }
    int at = age * places + word;
    if (runSlots[at] != 0) {
      at = (age + 1) * places - 1 - nextPart[age];
      nextPart[age] = (nextPart[age] + 1) % PARTS;
    }
    int density = SlotCodec.density(which, usual(now, age));
    runFrom[at] = runs.size();
    SlotCodec.code(runs, density, which);
    runs.cut();
    for (long rest = which; rest != 0; rest &= rest - 1) {
      int delta = of(now, held, (word << 6) + Long.numberOfTrailingZeros(rest));
      int from = (delta >>> COUNT_BITS) - 1;
      runs.addAll(slices, from, from + (delta & COUNT));
    }
    runTo[at] = runs.size();
    runSlots[at] = which;
    runWord[at] = (char) word;
    runDensity[at] = (byte) density;
    agesKnown |= 1L << age;
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
  public long fitting(FrameState now, FrameState held, int word, long which, int bits) {
    double left = bits;
    long result = 0;
    for (long rest = which; rest != 0; rest &= rest - 1) {
      int delta = of(now, held, (word << 6) + Long.numberOfTrailingZeros(rest));
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
