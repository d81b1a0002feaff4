package carom.net.snapshot;

import carom.net.snapshot.frame.FrameState;

/**
 * Decides which entities one client sees, and which of them matter most. A {@code SnapshotEncoder}
 * asks about each entity that changed and that the client knows, or that was offered by {@code
 * SnapshotEncoder.notice}. Called on the room's thread; must not allocate.
 */
public interface Interest {

  /** An interest in everything: all entities are in sight and matter the same. */
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
   * Returns whether {@link #sees} should be asked about every entity that changes. If not, the
   * encoder asks about unknown entities only after {@code SnapshotEncoder.notice}, so that the cost
   * of a client grows with what it sees.
   */
  boolean everything();

  /**
   * Returns whether the client sees an entity.
   *
   * @param frame the newest frame; the slot is alive in it
   * @param slot the entity
   * @param known whether it is in sight already: staying should take less than entering, so that
   *     nothing flickers at the border
   */
  boolean sees(FrameState frame, int slot, boolean known);

  /**
   * Returns which of 64 neighbouring entities stay in sight: {@link #sees} for many at once.
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
   * Returns how much an entity matters, in any unit that is the same for all entities. An entity
   * that doesn't fit the budget collects its priority tick by tick; the highest sum goes first.
   *
   * @param frame the newest frame; the slot is alive in it
   * @param slot the entity
   * @return greater than 0
   */
  float priority(FrameState frame, int slot);
}
