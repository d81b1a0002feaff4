package carom.net.snapshot.frame;

import java.util.Arrays;

/**
 * Holds the identities of a frame's entities. Frames in a row in which no entity comes, goes or
 * changes its owner share one object, which is then neither written nor compared again. One thread.
 */
final class Identities {
  static final int FREE = -1;

  /**
   * By slot: archetype, generation, and how often the entity was put elsewhere; or {@link #FREE}.
   */
  int[] kind = {};

  int[] owner = {};
  final SlotSet living = new SlotSet();
  int count;

  /** Limit of the slots in use: one more than the highest. */
  int limit;

  /** Number of frames that hold this object. */
  int holders;

  /** Makes room for slots below a limit; those that are new are free. */
  void ensure(int length) {
    int old = kind.length;
    if (length > old) {
      kind = Arrays.copyOf(kind, length);
      Arrays.fill(kind, old, length, FREE);
      owner = Arrays.copyOf(owner, length);
      living.ensure(length);
    }
  }

  void add(int slot, int kind, int owner) {
    this.kind[slot] = kind;
    this.owner[slot] = owner;
    living.add(slot);
    count++;
    limit = Math.max(limit, slot + 1);
  }

  /** Forgets everybody. */
  Identities clear() {
    Arrays.fill(kind, 0, limit, FREE);
    living.clear();
    count = 0;
    limit = 0;
    return this;
  }

  /**
   * Returns those of 64 neighbouring slots below a limit whose entity isn't the same as in another.
   */
  long differing(Identities other, int word, int limit) {
    long result = 0;
    for (int slot = word << 6, end = Math.min(limit, slot + 64); slot < end; slot++) {
      // a free slot's owner means nothing
      int difference =
          kind[slot] ^ other.kind[slot] | (owner[slot] ^ other.owner[slot]) & ~(kind[slot] >> 31);
      result |= (difference != 0 ? 1L : 0) << slot;
    }
    return result;
  }

  /** The identities that the frames of a ring take turns with. */
  static final class Recycler {
    private Identities[] all = {};

    /** Returns identities without entities that no frame holds. */
    Identities take() {
      for (Identities each : all) {
        if (each.holders == 0) {
          return each.clear();
        }
      }
      all = Arrays.copyOf(all, all.length + 1);
      all[all.length - 1] = new Identities();
      return all[all.length - 1];
    }
  }
}
