package carom.server.web;

import carom.server.room.Room;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.LongSupplier;

/**
 * Tells whether a server does its work: it has not failed, and each room that has not failed goes
 * on or is paused. Between two questions nothing is done. Any thread.
 */
public final class Health {
  /** A room that has computed no tick for so long is stuck. */
  static final long STUCK_NS = 10_000_000_000L;

  private final List<Room> rooms;
  private final LongSupplier clock;

  /** The age of each room when it was last seen to change, and when that was. */
  private final Map<Room, Seen> seen = new HashMap<>();

  private record Seen(int age, long ns) {}

  /**
   * Creates the health of a server.
   *
   * @param rooms a live list
   * @param clock monotonic nanoseconds
   */
  public Health(List<Room> rooms, LongSupplier clock) {
    this.rooms = rooms;
    this.clock = clock;
  }

  /** Returns what is wrong, or an empty text. */
  public synchronized String problem() {
    List<String> problems = new ArrayList<>();
    boolean allFailed = !rooms.isEmpty(); // a server of a fleet may have none
    seen.keySet().retainAll(rooms);
    for (Room room : rooms) {
      Seen last = seen.get(room);
      allFailed &= room.hasFailed();
      if (room.hasFailed()) {
        continue;
      }
      if (last == null || room.age() != last.age || room.isPaused()) {
        seen.put(room, new Seen(room.age(), clock.getAsLong()));
      } else if (clock.getAsLong() - last.ns >= STUCK_NS) {
        problems.add("room " + room.name() + " is stuck at tick " + room.tick());
      }
    }
    if (allFailed) {
      problems.add("all rooms have failed");
    }
    return String.join("; ", problems);
  }

  /** Returns whether each room that hasn't failed has computed a tick. */
  boolean hasBegun() {
    return rooms.stream().allMatch(room -> room.hasFailed() || room.age() > 0);
  }
}
