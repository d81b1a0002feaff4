package carom.net.snapshot.frame;

import java.util.Arrays;

/**
 * Holds a tick for each slot. Most of 64 neighbouring slots, a word, share one tick. It is kept
 * once for the word, with the slots that have it, the word's <em>layer</em>; only the others have
 * ticks of their own. So a change of many slots at once costs as little as a change of one. One
 * thread; allocates only in {@link #ensure}.
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

  /** Returns the slot's tick, or {@link #UNKNOWN}. */
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

  /** Returns the slots of a word that have {@link #layerTick}. */
  public long layer(int word) {
    return layers[word];
  }

  /** Returns the tick of a word's layer; it means nothing while the layer is empty. */
  public int layerTick(int word) {
    return layerTicks[word];
  }

  /** Gives a tick to those of some slots of a word that had an earlier one, or none. */
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
