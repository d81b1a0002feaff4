package carom.net.snapshot.frame;

import java.util.Arrays;

/**
 * Keeps the poses that a client received in the last {@link FrameRing#SIZE} ticks. Those of 64
 * neighbouring slots and one tick, a <em>word</em>, lie side by side: a run is read against a few
 * ticks, so that its baselines come in a row out of memory, where a history per entity would miss
 * the processor's caches for each.
 *
 * <p>All poses of a slot are of one entity, with one kind and one owner. When another one comes,
 * the slot's poses are forgotten. A word takes 34 KiB from its first pose on. One thread; allocates
 * only for words that are new.
 */
public final class ReceivedPoses {
  private static final int MASK = FrameRing.SIZE - 1;

  private static final class Word {
    /** By tick modulo the size, then by slot. */
    final long[] poses = new long[FrameRing.SIZE * Long.SIZE];

    /** By tick modulo the size: the slots whose poses are there. */
    final long[] held = new long[FrameRing.SIZE];

    /** By slot: what the entity is, and whose. */
    final int[] kinds = new int[Long.SIZE];

    final int[] owners = new int[Long.SIZE];

    int newest;

    boolean keeps(int tick) {
      return tick <= newest && tick > newest - FrameRing.SIZE;
    }

    void reach(int tick) {
      for (int t = Math.max(newest, tick - FrameRing.SIZE) + 1; t <= tick; t++) {
        held[t & MASK] = 0;
      }
      newest = Math.max(newest, tick);
    }
  }

  private Word[] words = {};

  /** Creates a memory without poses. */
  public ReceivedPoses() {}

  /**
   * Adds the pose of an entity after a tick, unless the slot has one of that tick or the tick is
   * too old.
   *
   * @param slot 0..65,535
   * @param kind archetype, generation and teleports, in any form
   * @param owner see {@link Ownership}
   * @param pose in range
   */
  public void add(int slot, int tick, int kind, int owner, QuantizedPose pose) {
    Word word = wordOf(slot, tick);
    word.reach(tick);
    if (!word.keeps(tick)) {
      return;
    }
    int at = slot & Long.SIZE - 1;
    long bit = 1L << slot;
    if (word.kinds[at] != kind || word.owners[at] != owner) {
      for (int i = 0; i < FrameRing.SIZE; i++) {
        word.held[i] &= ~bit;
      }
      word.kinds[at] = kind;
      word.owners[at] = owner;
    }
    if ((word.held[tick & MASK] & bit) == 0) {
      word.held[tick & MASK] |= bit;
      word.poses[place(slot, tick)] =
          PoseTable.packed(pose.x, pose.y, pose.angle, pose.still ? 1 : 0);
    }
  }

  private Word wordOf(int slot, int tick) {
    int index = slot >> 6;
    if (index >= words.length) {
      words = Arrays.copyOf(words, Math.max(index + 1, 2 * words.length));
    }
    if (words[index] == null) {
      words[index] = new Word();
      words[index].newest = tick;
    }
    return words[index];
  }

  private static int place(int slot, int tick) {
    return (tick & MASK) << 6 | slot & Long.SIZE - 1;
  }

  /**
   * Returns those of 64 slots, from 64 {@code word} on, whose poses after a tick are there. Any
   * numbers may be asked for.
   */
  public long held(int word, int tick) {
    Word there = word >= 0 && word < words.length ? words[word] : null;
    return there != null && there.keeps(tick) ? there.held[tick & MASK] : 0;
  }

  /** Copies a pose that is there. */
  public void read(int slot, int tick, QuantizedPose out) {
    PoseTable.unpack(words[slot >> 6].poses[place(slot, tick)], out);
  }

  /** Returns the kind of the entity whose poses are there. */
  public int kind(int slot) {
    return words[slot >> 6].kinds[slot & Long.SIZE - 1];
  }

  /** Returns whose the entity is whose poses are there. */
  public int owner(int slot) {
    return words[slot >> 6].owners[slot & Long.SIZE - 1];
  }
}
