package carom.physics.dynamics.store;

import carom.physics.archive.Archive;
import carom.physics.math.StateHash;
import java.util.Arrays;

/**
 * Allocates the slots of a table. Free slots are reused last in, first out, each time with another
 * generation, so that a handle of something destroyed can be told. The list of free slots is part
 * of a world's state, so that a restored world gives out the same slots again.
 */
public final class Slots {
  private static final int FIRST_CAPACITY = 64;

  private int[] generation = new int[FIRST_CAPACITY];
  private int[] free = new int[FIRST_CAPACITY];
  private int freeCount;
  private int bound;

  /** Returns one more than the largest slot ever used. */
  public int bound() {
    return bound;
  }

  /** Returns the number of slots in use. */
  public int count() {
    return bound - freeCount;
  }

  /** Returns how often a slot was given back. */
  public int generation(int slot) {
    return generation[slot];
  }

  /** Gives a slot out: a free one, else that at {@link #bound}. */
  public int take() {
    if (freeCount > 0) {
      return free[--freeCount];
    }
    reserve(bound + 1);
    return bound++;
  }

  /** Takes a slot in use back. */
  public void release(int slot) {
    generation[slot]++;
    free[freeCount++] = slot;
  }

  /** Gives free slots out in ascending order from now on, until others are released. */
  public void sortFree() {
    Arrays.sort(free, 0, freeCount);
    for (int i = 0, j = freeCount - 1; i < j; i++, j--) {
      int low = free[i];
      free[i] = free[j];
      free[j] = low;
    }
  }

  /** Makes room for slots below a number. */
  private void reserve(int slots) {
    if (generation.length < slots) {
      int capacity = Math.max(slots, 2 * generation.length);
      generation = Arrays.copyOf(generation, capacity);
      free = Arrays.copyOf(free, capacity);
    }
  }

  /** Returns a hash of the free slots and their order. */
  public long hash() {
    long h = StateHash.mix(StateHash.SEED, (long) bound << 32 | freeCount);
    for (int i = 0; i < freeCount; i++) {
      h = StateHash.mix(h, free[i]);
    }
    return h;
  }

  /**
   * Copies everything into another object, which grows as needed; allocates only then.
   *
   * @return the bytes that were copied
   */
  public long copyTo(Slots to) {
    to.reserve(bound);
    System.arraycopy(generation, 0, to.generation, 0, bound);
    Arrays.fill(to.generation, bound, Math.max(bound, to.bound), 0);
    System.arraycopy(free, 0, to.free, 0, freeCount);
    to.bound = bound;
    to.freeCount = freeCount;
    return (long) (bound + freeCount) * Integer.BYTES;
  }

  /** Passes the generations of n slots through an archive; {@link #passFree} must follow. */
  public void passGenerations(Archive a, String of, int n) {
    reserve(n);
    a.integers("generation of " + of, generation, n, Integer.MIN_VALUE, Integer.MAX_VALUE);
  }

  /**
   * Passes the list of free ones of n slots through an archive.
   *
   * @param type what is in each slot, {@code none} in free ones, which is checked
   */
  public void passFree(Archive a, String of, int n, byte[] type, byte none) {
    freeCount = a.count("free " + of + " slots", freeCount, n, Integer.BYTES);
    a.integers("free " + of + " slot", free, freeCount, 0, n - 1);
    if (!a.reads()) {
      return;
    }
    bound = n;
    boolean[] isFree = new boolean[n];
    for (int i = 0; i < freeCount; i++) {
      a.require(!isFree[free[i]], of + " slot=" + free[i] + " is free twice");
      isFree[free[i]] = true;
    }
    for (int slot = 0; slot < n; slot++) {
      a.require(isFree[slot] == (type[slot] == none), of + " slot=" + slot + " is lost");
    }
  }
}
