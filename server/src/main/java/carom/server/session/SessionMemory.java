package carom.server.session;

import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;

/**
 * Touches the memory that sessions will take, before players come. The system provides a page of
 * memory when it is touched first. When a crowd joins, that was four fifths of the time of each
 * collection ({@code docs/lab/crowd.md}).
 */
public final class SessionMemory {
  /** Bytes that a session keeps, with what it allocates while it joins. */
  private static final int BYTES_PER_PLACE = 166_000;

  /** The most places that count, those of the largest room: no larger crowd comes at once. */
  private static final int MOST_PLACES = 1_024;

  /** Number of players that may come at once without a noticeable pause. */
  private static final int FEW_PLACES = 64;

  /** Arrays of this size go to the old generation, where sessions live, because no other fits. */
  private static final int BLOCK_BYTES = 8 << 20;

  private SessionMemory() {}

  /**
   * Touches the memory of sessions, but no more than the JVM has taken for its heap, and frees it
   * again. Takes some 50 ms for 500 places, and none for up to {@value #FEW_PLACES}.
   *
   * @param places number of seats in all rooms
   * @return how many bytes were touched
   */
  public static long touch(int places) {
    if (places <= FEW_PLACES) {
      return 0;
    }
    var heap = ManagementFactory.getMemoryMXBean().getHeapMemoryUsage();
    long free = heap.getCommitted() - heap.getUsed() - 2L * BLOCK_BYTES;
    long wanted = Math.min((long) Math.min(places, MOST_PLACES) * BYTES_PER_PLACE, free);
    List<byte[]> blocks = new ArrayList<>();
    for (long touched = 0; touched + BLOCK_BYTES <= wanted; touched += BLOCK_BYTES) {
      blocks.add(new byte[BLOCK_BYTES]); // the JVM writes the zeros
    }
    long touched = (long) blocks.size() * BLOCK_BYTES;
    blocks.clear();
    System.gc(); // else the next collection of the old generation would come early
    return touched;
  }
}
