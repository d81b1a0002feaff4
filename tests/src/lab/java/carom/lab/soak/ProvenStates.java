package carom.lab.soak;

import carom.server.room.Room;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Remembers the hashes of the last ticks of each room, and compares them with the state in which
 * the next server's rooms begin.
 */
final class ProvenStates {
  /** Ticks of play that a crash may cost: one second. */
  private static final int MOST_LOST = 60;

  private static final int HALF_SECOND = 30;
  private static final int KEPT = 4 * MOST_LOST;

  /** The last ticks of a room. */
  private static final class Past {
    final int[] matches = new int[KEPT];
    final int[] ticks = new int[KEPT];
    final long[] hashes = new long[KEPT];
    final int[] players = new int[KEPT];
    int count;
  }

  private final Map<String, Past> rooms = new HashMap<>();
  private int worstLost;
  private int compared;
  private int fewer;

  /** Takes note of a tick. */
  void tick(Room room) {
    Past past = rooms.computeIfAbsent(room.name(), name -> new Past());
    int at = past.count++ % KEPT;
    past.matches[at] = room.match().number();
    past.ticks[at] = room.tick();
    past.hashes[at] = room.simulation().stateHash();
    past.players[at] = room.simulation().playerCount();
  }

  /**
   * Requires that each room of a new server, before its first tick, is in a state that it was in
   * before: the last one, or after a crash one of the last second.
   */
  void requireResumed(List<Room> resumed, boolean crashed) {
    for (Room room : resumed) {
      Past past = rooms.get(room.name());
      if (past != null) {
        requireResumed(room, past, crashed ? MOST_LOST : 0);
      }
    }
  }

  private void requireResumed(Room room, Past past, int mostLost) {
    int match = room.match().number();
    int tick = room.simulation().tick();
    for (int lost = 0; lost <= mostLost && lost < Math.min(past.count, KEPT); lost++) {
      int at = (past.count - 1 - lost) % KEPT;
      if (past.matches[at] == match && past.ticks[at] == tick) {
        worstLost = Math.max(worstLost, lost);
        if (room.simulation().playerCount() < past.players[at]) {
          requireSeated(room, past, lost);
          return;
        }
        compared++;
        long hash = room.simulation().stateHash();
        if (hash != past.hashes[at]) {
          throw new AssertionError(
              "room=%s goes on at match=%d tick=%d with hash=%016x, it was %016x"
                  .formatted(room.name(), match, tick, hash, past.hashes[at]));
        }
        return;
      }
    }
    int last = (past.count - 1) % KEPT;
    throw new AssertionError(
        "room=%s goes on at match=%d tick=%d, it was at match=%d tick=%d; at most %d are lost"
            .formatted(room.name(), match, tick, past.matches[last], past.ticks[last], mostLost));
  }

  /**
   * Requires that players who are in the log but have no seat on the disk, and so leave at once,
   * came or went within the half second in which seats are written.
   */
  private void requireSeated(Room room, Past past, int lost) {
    fewer++;
    int players = room.simulation().playerCount();
    int fewest = Integer.MAX_VALUE;
    for (int back = 0; back <= lost + HALF_SECOND && back < Math.min(past.count, KEPT); back++) {
      fewest = Math.min(fewest, past.players[(past.count - 1 - back) % KEPT]);
    }
    if (players < fewest) {
      throw new AssertionError(
          "room=%s has players=%d, and had never less than %d within half a second"
              .formatted(room.name(), players, fewest));
    }
  }

  /** Forgets all, because the next rooms begin anew. */
  void forget() {
    rooms.clear();
  }

  /** Returns what was seen, for people. */
  String summary() {
    return "rooms resumed with equal hash=%d, without those who came or went=%d, most ticks lost=%d"
        .formatted(compared, fewer, worstLost);
  }
}
