package carom.net.snapshot.frame;

import java.util.Arrays;

/**
 * Tells which slots of a ring's newest frame have changed since each of the older ones, 64 slots at
 * a time. Worked out once for all sessions that ask. One thread; allocates only while the frames
 * grow.
 */
public final class ChangedSlots {

  private final FrameRing ring;

  /** By frames back and word: the slots that changed since. */
  private final long[][] changed = new long[FrameRing.SIZE][];

  /** By frames back and word: the slots that hold another entity, owner or archetype since. */
  private final long[][] renamed = new long[FrameRing.SIZE][];

  /** Number of frames back that are worked out. */
  private int reach;

  private int tick = -1;

  ChangedSlots(FrameRing ring) {
    this.ring = ring;
    Arrays.fill(changed, new long[0]);
    Arrays.fill(renamed, new long[0]);
  }

  /**
   * Returns which slots of a word changed since an older frame.
   *
   * @param back how many frames before the newest that is, as {@link FrameRing#backTo} says
   */
  public long since(int back, int word) {
    long[] row = row(changed, back);
    return word < row.length ? row[word] : 0;
  }

  /** Returns which slots of a word hold another entity, owner or archetype since. */
  public long renamedSince(int back, int word) {
    long[] row = row(renamed, back);
    return word < row.length ? row[word] : 0;
  }

  private long[] row(long[][] rows, int back) {
    if (ring.newest().tick() != tick) {
      tick = ring.newest().tick();
      reach = 0;
    }
    while (reach < back) {
      extend();
    }
    return rows[back];
  }

  private void extend() {
    FrameState frame = ring.back(reach);
    int words = (ring.newest().slotLimit() + 63) >> 6;
    int next = reach + 1;
    if (changed[next].length < words) {
      changed[next] = new long[2 * words];
      renamed[next] = new long[2 * words];
    }
    for (int word = 0; word < words; word++) {
      long before = reach == 0 ? 0 : changed[reach][word];
      changed[next][word] = before | frame.changed().word(word);
      before = reach == 0 ? 0 : renamed[reach][word];
      renamed[next][word] = before | frame.renamed().word(word);
    }
    reach = next;
  }
}
