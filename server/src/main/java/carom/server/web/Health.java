package carom.server.web;

import carom.server.room.Room;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.LongSupplier;

/**
 * Tells whether a server does its work: it has not failed, and each room that has not failed goes
 * on or is paused. Between two questions nothing is done. Any thread.
 */
final class Health {
  /** A room that has computed no tick for so long is stuck. */
  static final long STUCK_NS = 10_000_000_000L;

  private final List<Room> rooms;
  private final LongSupplier clock;
  private final int[] ages;
  private final long[] changedNs;

  Health(List<Room> rooms, LongSupplier clock) {
    this.rooms = rooms;
    this.clock = clock;
    ages = new int[rooms.size()];
    changedNs = new long[rooms.size()];
    Arrays.fill(ages, -1);
  }

  /** Returns what is wrong, or an empty text. */
  synchronized String problem() {
    List<String> problems = new ArrayList<>();
    int failed = 0;
    for (int i = 0; i < ages.length; i++) {
      Room room = rooms.get(i);
      if (room.hasFailed()) {
        failed++;
      } else if (room.age() != ages[i] || room.isPaused()) {
        ages[i] = room.age();
        changedNs[i] = clock.getAsLong();
      } else if (clock.getAsLong() - changedNs[i] >= STUCK_NS) {
        problems.add("room " + room.name() + " is stuck at tick " + room.tick());
      }
    }
    if (failed == ages.length) {
      problems.add("all rooms have failed");
    }
    return String.join("; ", problems);
  }

  /** Returns whether each room that hasn't failed has computed a tick. */
  boolean hasBegun() {
    return rooms.stream().allMatch(room -> room.hasFailed() || room.age() > 0);
  }
}
