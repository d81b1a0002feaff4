package carom.net.snapshot;

import carom.net.snapshot.frame.FrameState;

/**
 * What one client is told about, and what it is told first: the question a {@link SnapshotEncoder}
 * asks about each entity that it might send. Called on the room's thread, for entities that changed
 * and are known to the client or were offered by {@link SnapshotEncoder#notice}; must not allocate.
 */
public interface Interest {

  /** Everything is in sight and everything matters the same. */
  Interest EVERYTHING =
      new Interest() {
        @Override
        public boolean everything() {
          return true;
        }

        @Override
        public boolean sees(FrameState frame, int slot, boolean known) {
          return true;
        }

        @Override
        public long stay(FrameState frame, int word, long slots) {
          return slots;
        }

        @Override
        public float priority(FrameState frame, int slot) {
          return 1;
        }
      };

  /**
   * Whether {@link #sees} should be asked about every entity that changes. If not, entities that
   * the client doesn't know are asked about only after {@link SnapshotEncoder#notice}, so that the
   * cost of a client grows with what it sees.
   */
  boolean everything();

  /**
   * Whether the client is told about an entity.
   *
   * @param frame the newest frame; the slot is alive in it
   * @param slot the entity
   * @param known whether it is in sight already: staying should take less than entering, so that
   *     nothing flickers at the border
   */
  boolean sees(FrameState frame, int slot, boolean known);

  /**
   * Which of 64 neighbouring entities stay in sight: {@link #sees} for many at once.
   *
   * @param frame the newest frame; the slots are alive in it
   * @param word the slots from 64 {@code word} on
   * @param slots those that are asked about, all in sight already; the lowest bit is the first
   */
  default long stay(FrameState frame, int word, long slots) {
    long result = 0;
    for (long rest = slots; rest != 0; rest &= rest - 1) {
      boolean stays = sees(frame, (word << 6) + Long.numberOfTrailingZeros(rest), true);
      result |= stays ? Long.lowestOneBit(rest) : 0;
    }
    return result;
  }

  /**
   * How much an entity matters, in any unit that is the same for all entities: what doesn't fit the
   * budget collects its priority tick by tick, and who has most goes first.
   *
   * @param frame the newest frame; the slot is alive in it
   * @param slot the entity
   * @return greater than 0
   */
  float priority(FrameState frame, int slot);
}
