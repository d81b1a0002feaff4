package carom.net.snapshot;

import carom.net.snapshot.frame.FrameRing;
import carom.net.snapshot.frame.FrameState;
import carom.net.snapshot.frame.SlotTicks;
import java.util.Arrays;

/**
 * Remembers for each of the last {@link FrameRing#SIZE} ticks of which slots a client certainly
 * holds the state after that tick: so the server knows which earlier poses a {@link Baseline} may
 * have. A word of 64 neighbouring slots takes 64 longs from the first time that any of them is
 * held. One thread; allocates only for words that are new.
 */
final class HeldTicks {
  private static final int MASK = FrameRing.SIZE - 1;

  private final FrameRing ring;

  /** The newest tick of each slot that the client acked. */
  private final SlotTicks acked;

  /** Strides that are tried for baselines, the best first. */
  private final int[] strides;

  /** By word: the slots held, by tick modulo the size; null before the first. */
  private long[][] held = {};

  /** By word: the newest tick that was added. */
  private int[] newest = {};

  /**
   * Creates an empty memory.
   *
   * @param acked the newest tick of each slot that the client acked
   * @param bestStride stride to try first, ticks
   */
  public HeldTicks(FrameRing ring, SlotTicks acked, int bestStride) {
    this.ring = ring;
    this.acked = acked;
    strides =
        bestStride == 1
            ? new int[] {1, 2, 3}
            : new int[] {
              bestStride, bestStride + 1, bestStride - 1, bestStride + 2, 2 * bestStride
            };
  }

  /** Makes room for slots below a limit. */
  public void ensure(int limit) {
    int words = limit + 63 >> 6;
    if (words > held.length) {
      held = Arrays.copyOf(held, words);
      newest = Arrays.copyOf(newest, words);
    }
  }

  /** Adds slots of a word that are held after a tick. */
  public void add(int word, long slots, int tick) {
    if (slots == 0 || held[word] != null && tick <= newest[word] - FrameRing.SIZE) {
      return;
    }
    long[] ticks = held[word];
    if (ticks == null) {
      ticks = new long[FrameRing.SIZE];
      held[word] = ticks;
      newest[word] = tick;
    }
    for (int t = Math.max(newest[word], tick - FrameRing.SIZE) + 1; t <= tick; t++) {
      ticks[t & MASK] = 0;
    }
    newest[word] = Math.max(newest[word], tick);
    ticks[tick & MASK] |= slots;
  }

  private long at(int word, int tick) {
    boolean kept =
        held[word] != null && tick <= newest[word] && tick > newest[word] - FrameRing.SIZE;
    return kept ? held[word][tick & MASK] : 0;
  }

  /** Forgets a slot in all ticks. */
  public void forget(int slot) {
    long[] ticks = held[slot >> 6];
    for (int i = 0; ticks != null && i < FrameRing.SIZE; i++) {
      ticks[i] &= ~(1L << slot);
    }
  }

  /**
   * Returns the stride with which slots have most earlier poses that the client holds.
   *
   * @param baseline the frame of the baseline: in it, all the slots are as acked
   */
  public int stride(FrameState now, FrameState baseline, int word, long slots) {
    int best = strides[0];
    int most = -1;
    int all = (Baseline.MOST_POSES - 1) * Long.bitCount(slots);
    for (int i = 0; i < strides.length && most < all; i++) {
      int count = 0;
      for (int poses = 2; poses <= Baseline.MOST_POSES; poses++) {
        count += Long.bitCount(sharing(now, baseline, word, slots, poses, strides[i]));
      }
      if (count > most) {
        most = count;
        best = strides[i];
      }
    }
    return best;
  }

  /** Returns those slots of which the client holds some earlier poses, too, a stride apart. */
  public long sharing(
      FrameState now, FrameState baseline, int word, long slots, int poses, int stride) {
    int oldest = baseline.tick() - (poses - 1) * stride;
    int back = ring.backTo(oldest);
    if (back < 0 || now.tick() - oldest >= FrameRing.SIZE) {
      return 0;
    }
    long rest = slots & ~ring.changes().renamedSince(back, word);
    for (int i = 1; i < poses && rest != 0; i++) {
      int tick = baseline.tick() - i * stride;
      rest = ring.backTo(tick) < 0 ? 0 : held(word, rest, tick);
    }
    return rest;
  }

  /** Returns those slots whose state after a tick, not younger than their baseline, is held. */
  private long held(int word, long slots, int tick) {
    long layer = acked.layer(word);
    long result = slots & at(word, tick);
    result |= tick >= acked.layerTick(word) ? slots & layer : 0;
    for (long rest = slots & ~layer & ~result; rest != 0; rest &= rest - 1) {
      int ackedTick = acked.get((word << 6) + Long.numberOfTrailingZeros(rest));
      result |= ackedTick >= 0 && ackedTick <= tick ? Long.lowestOneBit(rest) : 0;
    }
    return result;
  }
}
