package carom.net.snapshot.frame;

import java.util.Arrays;

/**
 * A tick for each slot. Of 64 neighbouring slots most have the same one mostly: that is kept once
 * for the word, with those that have it, their <em>layer</em>; only the others have ticks of their
 * own. So what happens to many slots at once costs as little as what happens to one. One thread;
 * allocates only in {@link #ensure}.
 */
public final class SlotTicks {

  static final int UNKNOWN = -1;

  private int[] ticks = {};
  private int[] layerTicks = {};
  private long[] layers = {};

  /** Makes room for slots below a limit. */
  public void ensure(int limit) {
    int old = ticks.length;
    if (limit > old) {
      ticks = Arrays.copyOf(ticks, limit);
      Arrays.fill(ticks, old, limit, UNKNOWN);
      int words = (limit + 63) >> 6;
      layerTicks = Arrays.copyOf(layerTicks, words);
      layers = Arrays.copyOf(layers, words);
    }
  }

  /** No slot has a tick. */
  public void clear() {
    Arrays.fill(ticks, UNKNOWN);
    Arrays.fill(layers, 0);
  }

  /** The slot's tick, or {@link #UNKNOWN}. */
  public int get(int slot) {
    if (slot >= ticks.length) {
      return UNKNOWN;
    }
    int word = slot >> 6;
    return (layers[word] >>> slot & 1) != 0 ? layerTicks[word] : ticks[slot];
  }

  /** Gives a slot a tick, or {@link #UNKNOWN}. */
  public void set(int slot, int tick) {
    layers[slot >> 6] &= ~(1L << slot);
    ticks[slot] = tick;
  }

  /** Those of a word that have {@link #layerTick}. */
  public long layer(int word) {
    return layers[word];
  }

  /** The tick of a word's layer; means nothing while that is empty. */
  public int layerTick(int word) {
    return layerTicks[word];
  }

  /** Gives those of some slots of a word a tick that had an earlier one, or none. */
  public void raise(int word, long slots, int tick) {
    long layer = layers[word];
    if (layer != 0 && tick < layerTicks[word]) {
      for (long rest = slots & ~layer; rest != 0; rest &= rest - 1) {
        int slot = (word << 6) + Long.numberOfTrailingZeros(rest);
        ticks[slot] = Math.max(ticks[slot], tick);
      }
      return;
    }
    long later = 0;
    long kept = layer != 0 && tick == layerTicks[word] ? layer : 0;
    for (long rest = layer & ~slots & ~kept; rest != 0; rest &= rest - 1) {
      ticks[(word << 6) + Long.numberOfTrailingZeros(rest)] = layerTicks[word];
    }
    for (long rest = slots & ~layer; rest != 0; rest &= rest - 1) {
      long slot = Long.lowestOneBit(rest);
      later |= ticks[(word << 6) + Long.numberOfTrailingZeros(rest)] > tick ? slot : 0;
    }
    layers[word] = kept | slots & ~later;
    layerTicks[word] = tick;
  }
}
